// Two doubles, or four floats, in one vector register, by the vector extension of GCC and Clang: the same instructions
// that single doubles use, on two at once, so the same results everywhere. Loops written in lanes have no branches that
// depend on data, which in searches nobody can predict.
#pragma once

#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>

namespace sunder {

using Lanes = double __attribute__((vector_size(16)));
using LanesMask = std::int64_t __attribute__((vector_size(16)));  // of comparisons: -1 where true, else 0

using FloatLanes = float __attribute__((vector_size(16)));
using FloatLanesMask = std::int32_t __attribute__((vector_size(16)));

inline Lanes lanes_at(const double* p) {
  Lanes lanes;
  std::memcpy(&lanes, p, sizeof lanes);
  return lanes;
}

inline Lanes swapped(Lanes a) { return Lanes{a[1], a[0]}; }

// Lane by lane; a where they are equal, or one is no number.
#ifdef __SSE2__
inline Lanes greater_of(Lanes a, Lanes b) { return __builtin_ia32_maxpd(b, a); }
inline Lanes smaller_of(Lanes a, Lanes b) { return __builtin_ia32_minpd(b, a); }
#else
inline Lanes greater_of(Lanes a, Lanes b) { return b > a ? b : a; }
inline Lanes smaller_of(Lanes a, Lanes b) { return b < a ? b : a; }
#endif
inline Lanes absolute(Lanes a) {
  constexpr std::int64_t all_but_sign = 0x7fffffffffffffff;
  return reinterpret_cast<Lanes>(reinterpret_cast<LanesMask>(a) & all_but_sign);
}
inline Lanes root_of(Lanes a) {
#ifdef __SSE2__
  return __builtin_ia32_sqrtpd(a);
#else
  return Lanes{std::sqrt(a[0]), std::sqrt(a[1])};
#endif
}

// As bits, the first lane's the lowest.
inline std::uint32_t bits_of(LanesMask mask) {
#ifdef __SSE2__
  return static_cast<std::uint32_t>(__builtin_ia32_movmskpd(reinterpret_cast<Lanes>(mask)));
#else
  return static_cast<std::uint32_t>((mask[0] & 1) | (mask[1] & 2));
#endif
}

inline std::uint32_t bits_of_four(FloatLanesMask mask) {
#ifdef __SSE__
  return static_cast<std::uint32_t>(__builtin_ia32_movmskps(reinterpret_cast<FloatLanes>(mask)));
#else
  return static_cast<std::uint32_t>((mask[0] & 1) | (mask[1] & 2) | (mask[2] & 4) | (mask[3] & 8));
#endif
}

// a <= b, for masks that are combined: GCC 12 takes `&` of plain comparisons of doubles apart into single lanes.
inline LanesMask is_at_most(Lanes a, Lanes b) {
#ifdef __SSE2__
  return reinterpret_cast<LanesMask>(__builtin_ia32_cmplepd(a, b));
#else
  return a <= b;
#endif
}

inline FloatLanes absolute(FloatLanes a) {
  constexpr std::int32_t all_but_sign = 0x7fffffff;
  return reinterpret_cast<FloatLanes>(reinterpret_cast<FloatLanesMask>(a) & all_but_sign);
}

inline double greater_lane(Lanes a) { return a[1] > a[0] ? a[1] : a[0]; }

// Which of the numbers values[0][0], values[0][1], values[1][0], ... is the greatest: of equals the first. Where some
// are not numbers, any. Requires count, the number of Lanes, to be even, at least 2 and at most 16.
inline std::uint32_t first_of_greatest(const Lanes* values, std::uint32_t count) {
  Lanes left = values[0], right = values[1];
  for (std::uint32_t i = 2; i < count; i += 2) {
    left = greater_of(left, values[i]);
    right = greater_of(right, values[i + 1]);
  }
  const double greatest = greater_lane(greater_of(left, right));
  LanesMask found{0, 0}, bit{1, 2}, next_bit{4, 8};
  for (std::uint32_t i = 0; i < count; i += 2) {
    found |= ((values[i] == greatest) & bit) | ((values[i + 1] == greatest) & next_bit);
    bit <<= 4;
    next_bit <<= 4;
  }
  const std::uint64_t last = std::uint64_t{1} << ((2 * count - 1) % 64);
  return static_cast<std::uint32_t>(std::countr_zero(static_cast<std::uint64_t>(found[0] | found[1]) | last));
}

}  // namespace sunder
