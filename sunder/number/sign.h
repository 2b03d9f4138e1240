// The sign of a number, as a type of its own: it does not turn into a bool or a number by itself.
#pragma once

#include <cstdint>

namespace sunder {

enum class Sign : std::int8_t { negative = -1, zero = 0, positive = 1 };

// What a stage of a predicate answers: a sign, or "unsure", which is no sign at all.
enum class Guess : std::int8_t { negative = -1, zero = 0, positive = 1, unsure = 2 };

constexpr bool is_sure(Guess g) { return g != Guess::unsure; }

// Precondition: is_sure(g).
constexpr Sign to_sign(Guess g) { return static_cast<Sign>(static_cast<std::int8_t>(g)); }

constexpr Sign operator-(Sign s) { return static_cast<Sign>(-static_cast<std::int8_t>(s)); }

constexpr Sign operator*(Sign a, Sign b) {
  return static_cast<Sign>(static_cast<std::int8_t>(a) * static_cast<std::int8_t>(b));
}

// The sign of a double as it stands (no rounding is involved in looking at it). Not for NaN.
constexpr Sign sign_of(double x) { return x > 0 ? Sign::positive : x < 0 ? Sign::negative : Sign::zero; }

}  // namespace sunder
