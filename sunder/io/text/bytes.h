// Numbers out of raw bytes, in either byte order, on any machine.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <type_traits>

namespace sunder::io {

enum class ByteOrder { little_endian, big_endian };

// The number whose sizeof(Number) bytes stand at `from`: any integer or IEEE type of 1, 2, 4 or 8 bytes.
template <class Number>
Number load(const char* from, ByteOrder order) {
  static_assert(std::is_arithmetic_v<Number> && sizeof(Number) <= 8);
  std::uint64_t bits = 0;
  for (std::size_t i = 0; i < sizeof(Number); ++i) {
    const std::size_t at = order == ByteOrder::big_endian ? i : sizeof(Number) - 1 - i;
    bits = bits << 8 | static_cast<unsigned char>(from[at]);
  }
  if constexpr (std::is_same_v<Number, double>) {
    return std::bit_cast<double>(bits);
  } else if constexpr (std::is_same_v<Number, float>) {
    return std::bit_cast<float>(static_cast<std::uint32_t>(bits));
  } else {
    return static_cast<Number>(bits);
  }
}

}  // namespace sunder::io
