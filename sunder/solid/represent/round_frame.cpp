#include <sunder/number/double_double.h>
#include <sunder/number/estimate.h>
#include <sunder/solid/represent/round_frame.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace sunder::solid {

namespace {

constexpr double round_enough = 0x1p-8;

// A vertex a, from it to b, c and d, and the axes of the frame, of any length.
template <class Real>
struct Corners {
  using Vector = Vector3<Real>;
  Vector b, c, d, across, normal;

  explicit Corners(std::span<const Point3> points) {
    const Point3 a =
        *std::min_element(points.begin(), points.end(), [](const Point3& p, const Point3& q) { return p.x < q.x; });
    const auto furthest = [&](const auto& distance) {
      Vector best{0, 0, 0};
      Real greatest = 0;
      for (const Point3& p : points) {
        const Vector x{Real(p.x) - Real(a.x), Real(p.y) - Real(a.y), Real(p.z) - Real(a.z)};
        const Real at = distance(x);
        if (at > greatest) greatest = at, best = x;
      }
      return best;
    };
    b = furthest([](const Vector& x) { return dot(x, x); });
    c = furthest([&](const Vector& x) {
      const Vector n = cross(b, x);
      return dot(n, n);
    });
    normal = cross(b, c);
    across = cross(normal, b);
    d = furthest([&](const Vector& x) { return magnitude(dot(normal, x)); });
  }

  bool is_round() const {
    const Real height = dot(normal, d);
    return height * height > Real(round_enough * round_enough) * dot(normal, normal) * dot(b, b);
  }
};

// Surely? Rounding each row by itself may turn the frame of a needle over.
bool has_positive_determinant(const std::array<Point3, 3>& row) {
  const auto lift = [](const Point3& r) { return Vector3<Estimate>{r.x, r.y, r.z}; };
  return sign(dot(cross(lift(row[0]), lift(row[1])), lift(row[2]))) == Guess::positive;
}

// axis.x = 1 for this x, as far as the sense of the axis allows.
Point3 row(const Vector3<DoubleDouble>& axis, const Vector3<DoubleDouble>& x) {
  const DoubleDouble length = magnitude(dot(axis, x));
  return {nearest(axis.x / length), nearest(axis.y / length), nearest(axis.z / length)};
}

}  // namespace

RoundFrame make_round_frame(std::span<const Point3> vertices) {
  if (Corners<double>(vertices).is_round()) return {};
  const Corners<DoubleDouble> corners(vertices);
  if (corners.is_round()) return {};
  const RoundFrame frame{{row(corners.b, corners.b), row(corners.across, corners.c), row(corners.normal, corners.d)},
                         false};
  for (const Point3& r : frame.row) {
    const double greatest = std::max({std::fabs(r.x), std::fabs(r.y), std::fabs(r.z)});
    if (!(greatest > 0x1p-200 && greatest < 0x1p200)) return {};
  }
  return has_positive_determinant(frame.row) ? frame : RoundFrame{};
}

}  // namespace sunder::solid
