// Sets of small numbers: of half-spaces that hold a point, of vertices of a face.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace sunder::polytope {

// Of numbers below 64 times its size. Those that are compared have one size.
using Bits = std::vector<std::uint64_t>;

inline Bits no_bits(std::size_t numbers) { return Bits((numbers + 63) / 64); }

inline bool has(const Bits& bits, std::size_t k) { return (bits[k / 64] >> (k % 64) & 1) != 0; }

inline void add(Bits& bits, std::size_t k) { bits[k / 64] |= std::uint64_t{1} << (k % 64); }

inline void keep_common(Bits& bits, const Bits& others) {
  for (std::size_t w = 0; w < bits.size(); ++w) bits[w] &= others[w];
}

inline bool is_within(const Bits& some, const Bits& all) {
  for (std::size_t w = 0; w < some.size(); ++w) {
    if ((some[w] & ~all[w]) != 0) return false;
  }
  return true;
}

inline std::size_t size_of(const Bits& bits) {
  std::size_t count = 0;
  for (const std::uint64_t word : bits) count += static_cast<std::size_t>(std::popcount(word));
  return count;
}

// Calls with each, ascending.
template <class Call>
void for_each(const Bits& bits, const Call& call) {
  for (std::size_t w = 0; w < bits.size(); ++w) {
    for (std::uint64_t word = bits[w]; word != 0; word &= word - 1) {
      call(static_cast<std::uint32_t>(64 * w) + static_cast<std::uint32_t>(std::countr_zero(word)));
    }
  }
}

inline std::vector<std::uint32_t> members_of(const Bits& bits) {
  std::vector<std::uint32_t> result;
  for_each(bits, [&](std::uint32_t k) { result.push_back(k); });
  return result;
}

// Requires that there is one.
inline std::uint32_t least_of(const Bits& bits) {
  std::size_t w = 0;
  while (bits[w] == 0) ++w;
  return static_cast<std::uint32_t>(64 * w) + static_cast<std::uint32_t>(std::countr_zero(bits[w]));
}

}  // namespace sunder::polytope
