// How much random tests do, and from which seed: for people who want more, or the same again.
#pragma once

#include <algorithm>
#include <cstdint>
#include <cstdlib>

namespace sunder::tests {

// How many cases a test should run: `count` times the environment variable SUNDER_TEST_SCALE (default 1).
inline int scaled_count(int count) {
  const char* scale = std::getenv("SUNDER_TEST_SCALE");
  return std::max(1, static_cast<int>(count * (scale ? std::atof(scale) : 1.0)));
}

// The seed of a test: SUNDER_TEST_SEED, or `seed`.
inline std::uint64_t chosen_seed(std::uint64_t seed) {
  const char* given = std::getenv("SUNDER_TEST_SEED");
  return given ? std::strtoull(given, nullptr, 10) : seed;
}

}  // namespace sunder::tests
