// The note of certificate files of version 1.
#pragma once

#include <string>

namespace sunder {

// The text of a certificate file of version 1, with a note: what of its input the file does not speak of, because it
// was left out, skipped or simplified ("The note" of docs/certificates.md). An empty note is none. A longer one than
// 4,000 characters is cut, and then ends in "...". Requires a text as the writers make it, without a note. Cost:
// linear.
std::string with_note(std::string certificate, const std::string& note);

}  // namespace sunder
