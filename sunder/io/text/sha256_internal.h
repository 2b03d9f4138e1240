// The plain way of SHA-256, which every processor has: for tests of the other one. Not installed.
#pragma once

#include <string>
#include <string_view>

namespace sunder::io {

std::string sha256_plainly(std::string_view bytes);

}  // namespace sunder::io
