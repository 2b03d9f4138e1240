#include <sunder/solid/mesh/face_triangles.h>

#include <sunder/base/contract.h>
#include <sunder/base/interruption.h>
#include <sunder/predicate/point/orient.h>
#include <sunder/predicate/point/ring_area.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace sunder::solid {

namespace {

// The axis on which the normal is greatest, as floating point has it.
int widest_axis(std::span<const Point3> points, std::span<const std::uint32_t> corners) {
  Point3 normal;
  const Point3& first = points[corners[0]];
  for (std::size_t k = 1; k + 1 < corners.size(); ++k) {
    const Point3 &p = points[corners[k]], &q = points[corners[k + 1]];
    const Point3 u{p.x - first.x, p.y - first.y, p.z - first.z}, v{q.x - first.x, q.y - first.y, q.z - first.z};
    normal = {normal.x + u.y * v.z - u.z * v.y, normal.y + u.z * v.x - u.x * v.z, normal.z + u.x * v.y - u.y * v.x};
  }
  const double x = std::fabs(normal.x), y = std::fabs(normal.y), z = std::fabs(normal.z);
  if (x + y + z > 0) return z >= x && z >= y ? 2 : y >= x ? 1 : 0;
  // Its parts cancel, or floating point has no number: an axis along which some corners are not on one line.
  for (const int axis : {2, 1, 0}) {
    for (std::size_t k = 2; k < corners.size(); ++k) {
      const Point3 &a = points[corners[k - 2]], &b = points[corners[k - 1]], &c = points[corners[k]];
      if (orient_2d_along(axis, a, b, c) != Sign::zero) return axis;
    }
  }
  return 2;
}

class EarClipping {
 public:
  EarClipping(std::span<const Point3> points, std::span<const std::uint32_t> corners)
      : points_(points), ring_(corners.begin(), corners.end()), axis_(widest_axis(points, corners)) {}

  FaceTriangles run() {
    FaceTriangles result;
    is_left_ = ring_area_along(axis_, points_, ring_) != Sign::negative;
    if (ring_.size() > 3) {
      const bool is_convex = is_star_of_first();
      result.crosses_itself = !is_convex && crosses_itself();
      if (!is_convex) cut_ears(result.triangles);
    }
    for (std::size_t k = 1; k + 1 < ring_.size(); ++k) result.triangles.push_back({ring_[0], ring_[k], ring_[k + 1]});
    for (const auto& [a, b, c] : result.triangles) {
      if (turn(points_[a], points_[b], points_[c]) == Sign::negative) result.crosses_itself = true;
    }
    return result;
  }

 private:
  const Point3& at(std::size_t k) const { return points_[ring_[k]]; }
  std::size_t after(std::size_t k) const { return k + 1 < ring_.size() ? k + 1 : 0; }
  std::size_t before(std::size_t k) const { return k > 0 ? k - 1 : ring_.size() - 1; }
  // As turned as the face is: positive.
  Sign turn(const Point3& a, const Point3& b, const Point3& c) const {
    const Sign sign = orient_2d_along(axis_, a, b, c);
    return is_left_ ? sign : -sign;
  }

  // Do the triangles from the first corner turn as the face, all of them, and does no edge turn away? Then it is
  // convex, and goes around once.
  bool is_star_of_first() const {
    for (std::size_t k = 0; k < ring_.size(); ++k) {
      if (turn(at(before(k)), at(k), at(after(k))) == Sign::negative) return false;
      if (k > 0 && after(k) > 0 && turn(at(0), at(k), at(k + 1)) != Sign::positive) return false;
    }
    return true;
  }

  bool crosses_itself() const {
    for (std::size_t i = 0; i < ring_.size(); ++i) {
      may_be_interrupted(static_cast<std::uint32_t>(ring_.size()));
      for (std::size_t j = i + 2; j < ring_.size(); ++j) {
        if (after(j) == i) continue;
        const Point3 &a = at(i), &b = at(after(i)), &c = at(j), &d = at(after(j));
        const Sign of_c = turn(a, b, c), of_d = turn(a, b, d);
        if (of_c == Sign::zero || of_d == Sign::zero || of_c == of_d) continue;
        const Sign of_a = turn(c, d, a), of_b = turn(c, d, b);
        if (of_a != Sign::zero && of_b != Sign::zero && of_a != of_b) return true;
      }
    }
    return false;
  }

  // Until three corners are left.
  void cut_ears(std::vector<std::array<std::uint32_t, 3>>& triangles) {
    std::size_t k = 0;
    for (std::size_t refused = 0; ring_.size() > 3;) {
      may_be_interrupted(static_cast<std::uint32_t>(ring_.size()));
      if (k >= ring_.size()) k = 0;
      // There and back at once: nothing is between. Once around without an ear: then any.
      if (at(before(k)) == at(after(k)) || is_ear(k) || refused > ring_.size()) {
        triangles.push_back({ring_[before(k)], ring_[k], ring_[after(k)]});
        ring_.erase(ring_.begin() + static_cast<std::ptrdiff_t>(k));
        k = k > 0 ? k - 1 : ring_.size() - 1;
        refused = 0;
      } else {
        ++k;
        ++refused;
      }
    }
  }

  bool is_ear(std::size_t k) const {
    const Point3 &a = at(before(k)), &b = at(k), &c = at(after(k));
    if (turn(a, b, c) != Sign::positive) return false;
    for (std::size_t j = 0; j < ring_.size(); ++j) {
      const Point3& p = at(j);
      if (p == a || p == b || p == c) {
        if (j != before(k) && j != k && j != after(k) && enters(j, a, b, c)) return false;
        continue;
      }
      if (turn(a, b, p) != Sign::negative && turn(b, c, p) != Sign::negative && turn(c, a, p) != Sign::negative) {
        return false;
      }
    }
    return true;
  }

  // Corner j lies at a, b or c. Does one of its two edges lead into the triangle?
  bool enters(std::size_t j, const Point3& a, const Point3& b, const Point3& c) const {
    return leads_into(at(j), at(before(j)), a, b, c) || leads_into(at(j), at(after(j)), a, b, c);
  }

  bool leads_into(const Point3& p, const Point3& to, const Point3& a, const Point3& b, const Point3& c) const {
    const Point3 &next = p == a ? b : p == b ? c : a, &last = p == a ? c : p == b ? a : b;
    return turn(p, next, to) == Sign::positive && turn(last, p, to) == Sign::positive;
  }

  std::span<const Point3> points_;
  std::vector<std::uint32_t> ring_;
  int axis_;
  bool is_left_ = true;
};

}  // namespace

FaceTriangles face_triangles(std::span<const Point3> points, std::span<const std::uint32_t> corners) {
  SUNDER_REQUIRE(corners.size() >= 3);
  return EarClipping(points, corners).run();
}

}  // namespace sunder::solid
