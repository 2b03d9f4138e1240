// How a proof is made: the call, as the file says it (docs/claims.md, `call`), and the same call once more.
//
// The words are the verb, the options with their values, and the files, as somebody would write them on a command line:
// those that change what is read or asked, and the option that names the proof, with "-" in the place of its name. What
// is printed, drawn or listed besides, and threads, are left out.
#pragma once

#include <sunder/ask/talk.h>
#include <sunder/ask/verb.h>
#include <sunder/certificate/origin.h>
#include <sunder/io/text/file.h>

#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <vector>

namespace sunder::ask {

// Answers the call that stands in the verb's values, whose words the talk has then.
Report run_call(const Verb& verb, Talk& talk);

// The origin of a proof that this call makes.
Origin origin_of(const Talk& talk, InputFiles inputs, std::vector<std::string> left_out);

// The same of an origin that lacks the call.
Origin by_this_call(const Talk& talk, Origin origin);

// The words of the call in the verb's values.
std::vector<std::string> words_of(const Verb& verb);

// Answers the call of these words, reading these files alone (io::GivenFiles), writing none, and telling nobody.
// write takes the text of its proofs, by their names. Throws Error, also where the words are no call that makes a proof.
using ProofSink = std::function<void(const std::filesystem::path& name, std::string_view text)>;
void run_again(std::span<const std::string> words, std::vector<io::GivenFiles::File> files, const ProofSink& write);

// "sunder pair a.obj b.obj --pose-b '1, 0, 0'", for people.
std::string call_text(std::span<const std::string> words);

}  // namespace sunder::ask
