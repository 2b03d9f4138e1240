// Triangles of leaves of two placed meshes: are two surely apart? In double precision.
// Also called: separating axis test; triangle-triangle rejection tests.
#pragma once

#include <sunder/predicate/coordinates.h>
#include <sunder/solid/mesh/placed_mesh.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace sunder::solid {

// A triangle as floating point sees it in the world.
struct RoundedTriangle {
  std::array<Point3, 3> corners;
  Point3 normal;
  Box3 box;
};

// The triangles of one leaf, which are made when another leaf is asked for.
class LeafTriangles {
 public:
  explicit LeafTriangles(const PlacedMesh& of) : of_(of) {}

  const RoundedTriangle& operator[](std::uint32_t triangle) const { return triangles_[triangle - range_.first]; }

  TriangleRange take(std::size_t leaf) {
    if (leaf == leaf_) return range_;
    leaf_ = leaf;
    range_ = of_.mesh().tree().triangles(leaf);
    for (std::uint32_t t = range_.first; t < range_.end; ++t) make(of_.triangle(t), triangles_[t - range_.first]);
    return range_;
  }

 private:
  static void make(const PosedTriangle& of, RoundedTriangle& made) {
    for (std::size_t k = 0; k < 3; ++k) {
      const Vector3<double> at = rounded_image(of[k]);
      made.corners[k] = {at.x, at.y, at.z};
    }
    const auto& [p, q, r] = made.corners;
    const Point3 u{q.x - p.x, q.y - p.y, q.z - p.z}, v{r.x - p.x, r.y - p.y, r.z - p.z};
    made.normal = {u.y * v.z - u.z * v.y, u.z * v.x - u.x * v.z, u.x * v.y - u.y * v.x};
    made.box = hull(hull(Box3{p, p}, Box3{q, q}), Box3{r, r});
  }

  const PlacedMesh& of_;
  std::size_t leaf_ = 0;  // the one that is there; none is 0
  TriangleRange range_;
  std::array<RoundedTriangle, MeshTree::leaf_size> triangles_;
};

// Triangles of a placed mesh and a segment: does it surely go past one? Along the ways across it and an edge of the triangle,
// which part it from most triangles that it does not cross.
class SegmentPast {
 public:
  // The error is that of TrianglesApart, below.
  SegmentPast(const PlacedMesh& of, const Posed3& p, const Posed3& q)
      : of_(of),
        is_known_(of.at(0u).tame && p.tame && q.tame),
        error_(0x1p-45 * (of.at(0u).reach + std::max(p.reach, q.reach))),
        from_(image(p)),
        to_(image(q)),
        way_{to_.x - from_.x, to_.y - from_.y, to_.z - from_.z} {}

  bool operator()(std::uint32_t triangle) const {
    if (!is_known_) return false;
    const PosedTriangle posed = of_.triangle(triangle);
    const std::array<Point3, 3> corners{image(posed[0]), image(posed[1]), image(posed[2])};
    for (std::size_t k = 0; k < 3; ++k) {
      const Point3 &p = corners[k], &q = corners[(k + 1) % 3];
      const Point3 e{q.x - p.x, q.y - p.y, q.z - p.z};
      const Point3 d{way_.y * e.z - way_.z * e.y, way_.z * e.x - way_.x * e.z, way_.x * e.y - way_.y * e.x};
      const auto at = [&d](const Point3& x) { return d.x * x.x + d.y * x.y + d.z * x.z; };
      const double s0 = at(from_), s1 = at(to_), t0 = at(corners[0]), t1 = at(corners[1]), t2 = at(corners[2]);
      const double gap = std::max(std::min(s0, s1) - std::max({t0, t1, t2}), std::min({t0, t1, t2}) - std::max(s0, s1));
      if (gap > error_ * (std::fabs(d.x) + std::fabs(d.y) + std::fabs(d.z))) return true;
    }
    return false;
  }

 private:
  static Point3 image(const Posed3& p) {
    const Vector3<double> at = rounded_image(p);
    return {at.x, at.y, at.z};
  }

  const PlacedMesh& of_;
  bool is_known_;
  double error_;
  Point3 from_, to_, way_;
};

class TrianglesApart {
 public:
  // A coordinate of an image is a sum of four numbers of at most `reach` in size, rounded six times: it is off by less
  // than 2^-48 reach; and so is, times the sizes of a direction's components, each product with it.
  TrianglesApart(const PlacedMesh& a, const PlacedMesh& b)
      : is_known_(a.at(0u).tame && b.at(0u).tame), error_(0x1p-45 * (a.at(0u).reach + b.at(0u).reach)) {}

  // Surely apart: no point of one is one of the other. False also means: not sure.
  bool operator()(const RoundedTriangle& t, const RoundedTriangle& u) const {
    if (!is_known_) return false;
    for (std::size_t c = 0; c < 3; ++c) {
      if (t.box.low[c] - u.box.high[c] > error_ || u.box.low[c] - t.box.high[c] > error_) return true;
    }
    if (are_apart_along(t.normal, t, u) || are_apart_along(u.normal, t, u)) return true;
    for (std::size_t i = 0; i < 3; ++i) {
      const Point3 e = way(t.corners[i], t.corners[(i + 1) % 3]);
      for (std::size_t j = 0; j < 3; ++j) {
        const Point3 f = way(u.corners[j], u.corners[(j + 1) % 3]);
        if (are_apart_along({e.y * f.z - e.z * f.y, e.z * f.x - e.x * f.z, e.x * f.y - e.y * f.x}, t, u)) return true;
      }
    }
    return false;
  }

 private:
  static Point3 way(const Point3& p, const Point3& q) { return {q.x - p.x, q.y - p.y, q.z - p.z}; }

  // Any direction will do, as it is rounded; it is finite, for the images are tame.
  bool are_apart_along(const Point3& d, const RoundedTriangle& t, const RoundedTriangle& u) const {
    const auto at = [&](const Point3& p) { return d.x * p.x + d.y * p.y + d.z * p.z; };
    const double t0 = at(t.corners[0]), t1 = at(t.corners[1]), t2 = at(t.corners[2]);
    const double u0 = at(u.corners[0]), u1 = at(u.corners[1]), u2 = at(u.corners[2]);
    const double gap =
        std::max(std::min({t0, t1, t2}) - std::max({u0, u1, u2}), std::min({u0, u1, u2}) - std::max({t0, t1, t2}));
    return gap > error_ * (std::fabs(d.x) + std::fabs(d.y) + std::fabs(d.z));
  }

  bool is_known_;
  double error_;
};

}  // namespace sunder::solid
