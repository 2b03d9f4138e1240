// SHA-256 of a file's bytes, by which certificates name what they were made of.
#pragma once

#include <string>
#include <string_view>

namespace sunder::io {

// 64 hexadecimal digits. Source: FIPS 180-4. Cost: linear. Throws nothing but for want of memory.
std::string sha256(std::string_view bytes);

}  // namespace sunder::io
