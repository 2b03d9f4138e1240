// Seeded random streams for tests, benchmarks and examples: the same numbers with every compiler.
//
// SplitMix64 (Steele, Lea, Flood 2014): one 64-bit state, every seed is good. Not for cryptography.
#pragma once

#include <cmath>
#include <cstdint>

namespace sunder {

class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(seed) {}

  std::uint64_t next() {
    std::uint64_t z = (state_ += 0x9e3779b97f4a7c15u);
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
  }

  // An integer in [0, n), n > 0. The bias is below n / 2^64.
  std::uint64_t below(std::uint64_t n) { return next() % n; }

  // An integer in [low, high], low <= high. high - low < 2^63.
  std::int64_t between(std::int64_t low, std::int64_t high) {
    return low + static_cast<std::int64_t>(below(static_cast<std::uint64_t>(high - low) + 1));
  }

  // A double in [0, 1), a multiple of 2^-53.
  double unit() { return static_cast<double>(next() >> 11) * 0x1p-53; }

  // A double in [low, high]; high itself only by rounding. Requires a finite high - low.
  double uniform(double low, double high) { return low + (high - low) * unit(); }

  // A double whose logarithm is uniform in [log(low), log(high)], both positive; a little outside by rounding. Its last
  // bits are those of the C library's exp and log.
  double log_uniform(double low, double high) {
    const double from = std::log(low);
    return std::exp(from + unit() * (std::log(high) - from));
  }

 private:
  std::uint64_t state_;
};

}  // namespace sunder
