// A set of numbers 0 .. N - 1 with its neighbours: which member is the next below or above a number?
// Also called: predecessor and successor search; bit trie.
//
// A tree of words of 64 bits, level by level in arrays: a bit of a word says whether the word below holds anything.
// Cost: at most six levels up and six down, for N < 2^31; one or two where members are dense. 1.02 N bits.
#pragma once

#include <sunder/base/contract.h>

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace sunder::planar {

class RankSet {
 public:
  static constexpr std::uint32_t none = 0xffffffffu;

  // Empty. Requires count < 2^31; members are below it.
  explicit RankSet(std::uint32_t count) {
    SUNDER_REQUIRE(count < 1u << 31);
    std::size_t size = count;
    for (std::vector<std::uint64_t>& words : levels_) words.assign(size = size / 64 + 1, 0);
  }

  void insert(std::uint32_t k) {
    for (std::vector<std::uint64_t>& words : levels_) {
      std::uint64_t& word = words[k / 64];
      const bool was_empty = word == 0;
      word |= bit(k);
      if (!was_empty) return;
      k /= 64;
    }
  }

  void erase(std::uint32_t k) {
    for (std::vector<std::uint64_t>& words : levels_) {
      if ((words[k / 64] &= ~bit(k)) != 0) return;
      k /= 64;
    }
  }

  // The greatest member below k, or none.
  std::uint32_t before(std::uint32_t k) const {
    for (std::size_t level = 0; level < levels_.size(); ++level) {
      const std::uint64_t word = levels_[level][k / 64] & (bit(k) - 1);
      k /= 64;
      if (word != 0) return greatest_under(level, 64 * k + highest(word));
    }
    return none;
  }

  // The least member above k, or none.
  std::uint32_t after(std::uint32_t k) const {
    for (std::size_t level = 0; level < levels_.size(); ++level) {
      const std::uint64_t word = levels_[level][k / 64] & ((~bit(k) + 1) << 1);
      k /= 64;
      if (word != 0) return least_under(level, 64 * k + lowest(word));
    }
    return none;
  }

 private:
  static std::uint64_t bit(std::uint32_t k) { return std::uint64_t{1} << (k % 64); }
  static std::uint32_t highest(std::uint64_t word) { return static_cast<std::uint32_t>(std::bit_width(word) - 1); }
  static std::uint32_t lowest(std::uint64_t word) { return static_cast<std::uint32_t>(std::countr_zero(word)); }

  std::uint32_t greatest_under(std::size_t level, std::uint32_t k) const {
    while (level-- > 0) k = 64 * k + highest(levels_[level][k]);
    return k;
  }
  std::uint32_t least_under(std::size_t level, std::uint32_t k) const {
    while (level-- > 0) k = 64 * k + lowest(levels_[level][k]);
    return k;
  }

  std::array<std::vector<std::uint64_t>, 6> levels_;  // 64^6 > 2^31
};

}  // namespace sunder::planar
