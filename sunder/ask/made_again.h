// Was a certificate file made from these files? The program reads them again, by the call that it names, and compares.
#pragma once

#include <sunder/certificate/origin.h>

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace sunder::ask {

// A file that is held against a certificate.
struct GivenInput {
  std::string name, bytes, sha256;
};

// Throws Error bad_file where it cannot be read.
GivenInput read_given(const std::string& name);

// What shows that the file is not made of these, in words; empty where it is: they are its inputs, each by its SHA-256,
// in their order, and its call makes a file of them that is the same byte for byte, up to its statements, and has each
// note of a statement, as of joint values, on a statement of the same. So is all that it says of itself, but for the
// statements, which the checker checks.
// text: a certificate file that is right in form; inputs and call: what it says of itself. The call reads nothing but
// these files, and writes none.
// Cost: that of the call.
std::string difference_made_again(std::string_view text, const InputFiles& inputs, std::span<const std::string> call,
                                  std::span<const GivenInput> given);

}  // namespace sunder::ask
