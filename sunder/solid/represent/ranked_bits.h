// Bit vectors with ranks: how many of the first i bits are set, in constant time.
// Also called: succinct rank structure; bitmap with popcount index.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace sunder::solid {

// Several vectors of one length, in 1.5 bits a bit. Set bits, then count(), then ask for ranks.
class RankedBits {
 public:
  RankedBits() = default;
  RankedBits(std::uint32_t vectors, std::uint32_t length)
      : words_per_vector_(length / 64 + 1),
        words_(std::size_t{vectors} * words_per_vector_),
        before_(std::size_t{vectors} * words_per_vector_) {}

  // Requires a position below the length; so of rank(), or the length.
  void set(std::uint32_t vector, std::uint32_t i) { words_[place(vector, i)] |= std::uint64_t{1} << (i % 64); }

  void count() {
    for (std::size_t w = 0; w < words_.size(); ++w) {
      const bool is_first = w % words_per_vector_ == 0;
      before_[w] = is_first ? 0 : before_[w - 1] + static_cast<std::uint32_t>(std::popcount(words_[w - 1]));
    }
  }

  // How many of the bits 0 .. i - 1 are set.
  std::uint32_t rank(std::uint32_t vector, std::uint32_t i) const {
    const std::size_t w = place(vector, i);
    const std::uint64_t below = (std::uint64_t{1} << (i % 64)) - 1;
    return before_[w] + static_cast<std::uint32_t>(std::popcount(words_[w] & below));
  }

  std::size_t memory() const {  // bytes
    return words_.capacity() * sizeof(words_[0]) + before_.capacity() * sizeof(before_[0]);
  }

 private:
  std::size_t place(std::uint32_t vector, std::uint32_t i) const { return vector * words_per_vector_ + i / 64; }

  std::size_t words_per_vector_ = 0;
  std::vector<std::uint64_t> words_;
  std::vector<std::uint32_t> before_;
};

}  // namespace sunder::solid
