#include <sunder/base/contract.h>
#include <sunder/predicate/filter/stages.h>
#include <sunder/predicate/point/common_point.h>
#include <sunder/predicate/point/orient.h>

#include <algorithm>
#include <cmath>

namespace sunder {

namespace {

// The points other than number `left_out`, in order.
template <std::size_t N, class T>
std::array<T, N - 1> others(const std::array<T, N>& points, std::size_t left_out) {
  std::array<T, N - 1> rest{};
  for (std::size_t i = 0, j = 0; i < N; ++i) {
    if (i != left_out) rest[j++] = points[i];
  }
  return rest;
}

template <std::size_t N>
std::array<Posed3, N> joined(std::span<const Posed3> a, std::span<const Posed3> b) {
  std::array<Posed3, N> points{};
  for (std::size_t i = 0; i < N; ++i) points[i] = i < a.size() ? a[i] : b[i - a.size()];
  return points;
}

// The orientation of N points in the space of N - 1 dimensions that is left when the projection drops axes, in any
// stage's numbers or as an exact sign.
template <class P>
auto minor_of(int, const std::array<P, 4>& p) {
  return orient_3d_formula(p[0], p[1], p[2], p[3]);
}
template <class P>
auto minor_of(int axis, const std::array<P, 3>& p) {
  return axis == 0   ? orient_2d_formula<0>(p[0], p[1], p[2])
         : axis == 1 ? orient_2d_formula<1>(p[0], p[1], p[2])
                     : orient_2d_formula<2>(p[0], p[1], p[2]);
}
template <class P>
auto minor_of(int axis, const std::array<P, 2>& p) {
  return axis == 0 ? p[1].x - p[0].x : axis == 1 ? p[1].y - p[0].y : p[1].z - p[0].z;
}

Sign minor_sign(int axis, const std::array<Posed3, 3>& p, StageTally* tally) {
  return orient_2d_along(axis, p[0], p[1], p[2], tally);
}
Sign minor_sign(int axis, const std::array<Posed3, 2>& p, StageTally* tally) {
  return compare_coordinate(axis, p[0], p[1], tally);
}

// Do the N points lie in a common space of dimension N - 2?
bool is_flat(const std::array<Posed3, 4>& p, StageTally* tally) {
  return orient_3d(p[0], p[1], p[2], p[3], tally) == Sign::zero;
}
bool is_flat(const std::array<Posed3, 3>& p, StageTally* tally) {
  for (int axis = 0; axis < 3; ++axis) {
    if (orient_2d_along(axis, p[0], p[1], p[2], tally) != Sign::zero) return false;
  }
  return true;
}

// The minors c_i of five points in any stage's numbers. The last is minus the sum of the others, so four triple
// products of differences do, and these share two vector products.
template <class P>
auto five_minors(const std::array<P, 5>& p) {
  const auto y0 = p[0] - p[4], y1 = p[1] - p[4], y2 = p[2] - p[4], y3 = p[3] - p[4];
  const auto u = cross(y0, y1), v = cross(y2, y3);
  const std::array first{dot(y1, v), dot(y0, v), dot(y3, u), dot(y2, u)};
  // c_0 = first[0], c_1 = -first[1], c_2 = first[2], c_3 = -first[3]
  return std::pair{first, (first[1] - first[0]) + (first[3] - first[2])};
}

// Of five points: does the dependency part A from B, as far as one stage can tell?
template <class Stage>
Guess five_are_separated(const std::array<Posed3, 5>& points, std::size_t count_a) {
  using Image = decltype(lift<Stage>(points[0]));
  const std::array<Image, 5> images{lift<Stage>(points[0]), lift<Stage>(points[1]), lift<Stage>(points[2]),
                                    lift<Stage>(points[3]), lift<Stage>(points[4])};
  const auto [first, last] = five_minors(images);
  const std::array guesses{sign(first[0]), sign(first[1]), sign(first[2]), sign(first[3]), sign(last)};
  // The sign of c_i, turned over for B: one value for all. first[1] and first[3] are -c_1 and -c_3.
  int common = 0;
  bool unsure = false;
  for (std::size_t i = 0; i < 5; ++i) {
    if (!is_sure(guesses[i])) {
      unsure = true;
      continue;
    }
    const int side = static_cast<int>(guesses[i]) * ((i == 1 || i == 3) == (i < count_a) ? -1 : 1);
    if (side == 0 || side == -common) return Guess::negative;
    common = side;
  }
  return unsure ? Guess::unsure : Guess::positive;
}

// The same in floating point with one error bound for all: cheaper than Rounded, and enough where the five points are
// not nearly in a plane. Requires tame points.
//
// Let u = 2^-53. An image's coordinate is a Rounded<3> with a magnitude of at most 4 reach, but for roundings; so its
// error is at most e = bound<4> 4 reach. A difference y of two has an error of at most d = 2 e + u Y, where Y is the
// greatest computed |y|. A triple product is a sum of six products of three differences, computed with bound<5>:
//   |error| <= 6 ((Y + d)^3 - Y^3) + bound<5> 6 Y^3 <= 18 d (Y + d)^2 + 36 u Y^3
// and the last minor, a sum of four of these in two steps, has four times that error and 2.1 u times 4 * 6.1 Y^3. The
// factors below are larger by more than what the rounding of the bound itself takes away.
Guess five_are_separated_with_one_bound(std::span<const Posed3> a, std::span<const Posed3> b) {
  std::array<Vector3<double>, 5> images;
  double reach = 0;
  std::size_t n = 0;
  for (const std::span<const Posed3>& part : {a, b}) {
    for (const Posed3& p : part) {
      images[n++] = rounded_image(p);
      reach = std::max(reach, p.reach);
    }
  }
  double size = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    const Vector3<double> y = images[i] - images[4];
    size = std::max(size, std::max(std::fabs(y.x), std::max(std::fabs(y.y), std::fabs(y.z))));
  }
  const double off = 2 * (Rounded<4>::bound * 4 * reach) + 0x1p-53 * size;
  const double error = 20 * off * ((size + off) * (size + off)) + 40 * 0x1p-53 * (size * size * size);
  const auto [first, last] = five_minors(images);
  // c_i with its sign turned over for B: all five beyond the error on one side, or one of them on either.
  const std::size_t count_a = a.size();
  const auto side = [&](std::size_t i, double c) { return (i == 1 || i == 3) == (i < count_a) ? -c : c; };
  const double s0 = side(0, first[0]), s1 = side(1, first[1]), s2 = side(2, first[2]), s3 = side(3, first[3]),
               s4 = side(4, last) / 6;
  const double least = std::min(std::min(s0, s1), std::min(std::min(s2, s3), s4));
  const double greatest = std::max(std::max(s0, s1), std::max(std::max(s2, s3), s4));
  if (least > error || greatest < -error) return Guess::positive;
  return least < -error && greatest > error ? Guess::negative : Guess::unsure;
}

bool five_have_common_point(std::span<const Posed3> a, std::span<const Posed3> b, StageTally* tally) {
  bool all_tame = true;
  for (const Posed3& p : a) all_tame = all_tame && p.tame;
  for (const Posed3& p : b) all_tame = all_tame && p.tame;
  if (all_tame) {
    const Guess guess = five_are_separated_with_one_bound(a, b);
    if (is_sure(guess)) {
      if (tally) ++tally->rounded;
      return guess == Guess::positive;
    }
  }
  const std::array<Posed3, 5> points = joined<5>(a, b);
  const std::size_t count_a = a.size();
  if (all_tame) {
    const Guess guess = five_are_separated<RoundedStage>(points, count_a);
    if (is_sure(guess)) {
      if (tally) ++tally->rounded;
      return guess == Guess::positive;
    }
  }
  const Guess guess = five_are_separated<IntervalStage>(points, count_a);
  if (is_sure(guess)) {
    if (tally) ++tally->interval;
    return guess == Guess::positive;
  }
  if (tally) ++tally->exact;
  return five_are_separated<ExactStage>(points, count_a) == Guess::positive;
}

// Along one choice of axis: -1 a sign is wrong, 0 all minors vanish (another axis is needed), 1 they separate A from B.
template <std::size_t N>
int separated_along(int axis, const std::array<Posed3, N>& points, std::size_t count_a, StageTally* tally) {
  int first = 0;
  bool vanishes = false;
  for (std::size_t i = 0; i < N; ++i) {
    const Sign c = minor_sign(axis, others(points, i), tally);
    const int side = static_cast<int>(c) * ((i % 2 == 0) == (i < count_a) ? 1 : -1);
    if (side == 0) {
      vanishes = true;
      if (first != 0) return -1;
    } else {
      if (vanishes || side == -first) return -1;
      first = side;
    }
  }
  return vanishes ? 0 : 1;
}

template <std::size_t N>
bool have_common_point_of(std::span<const Posed3> a, std::span<const Posed3> b, StageTally* tally) {
  const std::array<Posed3, N> points = joined<N>(a, b);
  if (!is_flat(points, tally)) return false;
  for (int axis = 0; axis < 3; ++axis) {
    const int separated = separated_along(axis, points, a.size(), tally);
    if (separated != 0) return separated > 0;
  }
  return false;
}

template <std::size_t N>
std::array<Dyadic, 5> weights_of(std::span<const Posed3> a, std::span<const Posed3> b) {
  const std::array<Posed3, N> points = joined<N>(a, b);
  std::array<Vector3<Dyadic>, N> images;
  for (std::size_t i = 0; i < N; ++i) images[i] = lift<ExactStage>(points[i]);
  std::array<Dyadic, 5> weights;
  if constexpr (N == 2) {
    weights[0] = weights[1] = Dyadic(1.0);
  } else {
    int axis = 0;
    while (axis < 2 && minor_of(axis, others(images, 0)).sign() == Sign::zero) ++axis;
    for (std::size_t i = 0; i < N; ++i) {
      const Dyadic c = minor_of(axis, others(images, i));
      weights[i] = c.sign() == Sign::negative ? -c : c;
    }
  }
  return weights;
}

}  // namespace

bool have_common_point(std::span<const Posed3> a, std::span<const Posed3> b, StageTally* tally) {
  SUNDER_REQUIRE(!a.empty() && !b.empty() && a.size() + b.size() <= 5);
  switch (a.size() + b.size()) {
    case 2:
      for (int axis = 0; axis < 3; ++axis) {
        if (compare_coordinate(axis, a[0], b[0], tally) != Sign::zero) return false;
      }
      return true;
    case 3: return have_common_point_of<3>(a, b, tally);
    case 4: return have_common_point_of<4>(a, b, tally);
    case 5: return five_have_common_point(a, b, tally);
    default: return false;
  }
}

std::array<Dyadic, 5> common_point_weights(std::span<const Posed3> a, std::span<const Posed3> b) {
  SUNDER_REQUIRE(have_common_point(a, b));
  switch (a.size() + b.size()) {
    case 2: return weights_of<2>(a, b);
    case 3: return weights_of<3>(a, b);
    case 4: return weights_of<4>(a, b);
    default: return weights_of<5>(a, b);
  }
}

}  // namespace sunder
