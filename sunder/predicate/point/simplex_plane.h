// On which side of the hyperplane through d points of R^d is another one, 2 <= d <= 6? In floating point with a bound
// of the error, and exactly. Planes are made once and asked about many points.
// Also called: orientation test (sign of a determinant) in d dimensions.
//
// The plane through the corners p0, .., p(d-1), in their order, has the normal n whose product with any v is
// det(v, p1 - p0, .., p(d-1) - p0). The side of q is the sign of n (q - p0): exchange two corners, and it changes.
#pragma once

#include <sunder/number/dyadic.h>
#include <sunder/number/sign.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace sunder {

inline constexpr std::size_t most_of_simplex = 6;

// Indices of points, of which the first d count.
using SimplexCorners = std::array<std::uint32_t, most_of_simplex>;

struct RoundedPlane {
  std::array<double, most_of_simplex> normal{};
  double offset = 0, error = 0;  // of n q - offset, for any of the points
};

// Points that planes are laid through and asked about. Immutable.
class PlanePoints {
 public:
  // rows: d finite doubles each.
  PlanePoints(std::size_t d, std::vector<double> rows);
  // rows: d + 1 numbers each, of which the last, w, is positive: the points x / w.
  PlanePoints(std::size_t d, std::vector<Dyadic> rows);

  std::size_t dimension() const { return d_; }
  std::uint32_t size() const { return count_; }

  // The coordinates, rounded, each column times a power of two so that all are at most 1 in size.
  const double* rounded(std::uint32_t k) const { return rounded_.data() + k * d_; }

  // The point, exactly: d + 1 numbers as above.
  std::vector<Dyadic> row(std::uint32_t k) const;

  // In scaled columns. Where products of so many bits as the points have are exact, so is it, and the error is zero.
  RoundedPlane rounded_plane(const SimplexCorners& corners) const;

  // Of that plane.
  Guess rounded_side(const RoundedPlane& plane, std::uint32_t k) const {
    const double* const p = rounded(k);
    double sum = 0;
    for (std::size_t c = 0; c < d_; ++c) sum += plane.normal[c] * p[c];
    const double value = sum - plane.offset;
    if (value > plane.error) return Guess::positive;
    if (value < -plane.error) return Guess::negative;
    return plane.error == 0 ? Guess::zero : Guess::unsure;
  }

  // With a bound of its own for the point. Cost: that of making the plane.
  Guess closer_side(const SimplexCorners& corners, std::uint32_t k) const;

  // The plane exactly, without any scale: (n, -n p0), times a positive number. Exact arithmetic, some d 2^d products.
  std::vector<Dyadic> exact_plane(const SimplexCorners& corners) const;
  Sign exact_side(std::span<const Dyadic> plane, std::uint32_t k) const;

  // Is point k in the cone of the corners, seen from m / n? center: the d numbers m, and n, which is positive. Requires
  // that the corners' ways from there are independent, and points of doubles. In intervals, then exactly.
  bool in_cone(std::span<const Dyadic> center, const SimplexCorners& corners, std::uint32_t k) const;

 private:
  std::size_t d_;
  std::uint32_t count_ = 0;
  std::vector<double> rows_;    // or
  std::vector<Dyadic> ratios_;  // as they were given
  std::vector<double> rounded_;
  bool is_exact_ = false;   // is floating point?
  double uncertainty_ = 0;  // of differences of rounded coordinates, in units of 2^-53
};

}  // namespace sunder
