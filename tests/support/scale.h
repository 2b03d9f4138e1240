// How much random tests do, and from which seed: for people who want more, or the same again. The only readers of
// SUNDER_TEST_SCALE and SUNDER_TEST_SEED; a value that is not one throws, so that the test fails.
#pragma once

#include <cstdint>

namespace sunder::tests {

// How many cases a test should run: `count` times SUNDER_TEST_SCALE (a number above 0; default 1), rounded down, but
// at least the lesser of `count` and `at_least`.
int scaled_count(int count, int at_least = 1);

// Does SUNDER_TEST_SCALE ask for less than a tenth, as ./do check and ./do test --quick do? Then tests leave their
// largest instances out.
bool is_scaled_down();

// The seed of a test: its own, moved by SUNDER_TEST_SEED (a whole number; default 0).
std::uint64_t chosen_seed(std::uint64_t own);

// What the two do with the variable's text; nullptr: it is not set. Throw std::invalid_argument.
double scale_of(const char* text);
std::uint64_t seed_moved_by(const char* text, std::uint64_t own);

}  // namespace sunder::tests
