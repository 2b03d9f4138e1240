// What a call writes is none of what it reads, and is written once.
#pragma once

#include <sunder/ask/talk.h>

#include <filesystem>
#include <string>
#include <vector>

namespace sunder::ask {

// A file as the call names it: the option and the path. "-" is standard input, or standard output.
struct NamedFile {
  std::string option;
  std::filesystem::path path;
};

// Throws Error bad_call where an output has no name, or is the same file as an input or an output before it: by another
// spelling, a symbolic or a hard link, the name of an open stream. Standard output is an output too, unless the call is
// quiet. Pipes and devices are files here, but for /dev/null, and a terminal that is read and written. Nothing is read
// or written; where standard output is an input, nothing is printed there any more.
void require_apart(Talk& talk, const std::vector<NamedFile>& inputs, std::vector<NamedFile> outputs);

// Is what is written to `output` written over what is read from `input`? "-" is the stream of each. That a terminal is
// written and read is nothing.
bool overwrites(const std::filesystem::path& output, const std::filesystem::path& input);

}  // namespace sunder::ask
