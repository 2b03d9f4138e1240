// Oriented boxes and triangles of two placed meshes, of which one goes straight past the other: when may two meet? In
// floating point, with bounds of all errors.
// Also called: swept bounding boxes; moving separating axis test, time of impact of oriented boxes.
// Source: Eberly 2001, "Dynamic Collision Detection using Oriented Bounding Boxes": at each time two boxes are apart iff
// one of fifteen directions parts them, and these stay the same; so along each of them there is one interval of time in
// which they overlap, and the boxes meet in what all these intervals have in common.
#pragma once

#include <sunder/base/lanes.h>
#include <sunder/solid/mesh/placed_boxes.h>
#include <sunder/solid/mesh/placed_mesh.h>
#include <sunder/solid/mesh/placed_triangles.h>
#include <sunder/solid/object/translation.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

namespace sunder::solid {

constexpr double never = std::numeric_limits<double>::infinity();

// How the second one moves from time 0 to 1, as seen from the first, in the world: rounded.
struct RelativePath {
  Point3 way;
  double sum = 0;  // of the sizes of all it is made of: it is off by some parts in 2^52 of that

  RelativePath(const Translation& of_a, const Translation& of_b) {
    for (std::size_t c = 0; c < 3; ++c) {
      const auto at = [c](const Pose& pose) { return pose.affine().translation[c]; };
      way[c] = (at(of_b.end()) - at(of_b.begin())) - (at(of_a.end()) - at(of_a.begin()));
      for (const Translation* of : {&of_a, &of_b}) sum += std::fabs(at(of->begin())) + std::fabs(at(of->end()));
    }
  }
};

// As PlacedBoxes, of boxes that are placed so at time 0. At time s the second frame has come s times the path, which is
// one more way in the first frame: all errors of a way are those of the path, too, times s, and so at most that.
class SweptBoxes : public PlacedBoxes {
 public:
  SweptBoxes(const BoxFrame& a, const BoxFrame& b, const RelativePath& path) : PlacedBoxes(a, b) {
    const std::array<Point3, 3> inverse = inverse_of(a.edges);
    double far = 0, rows = 0;
    for (std::size_t r = 0; r < 3; ++r) {
      const double along = dot(inverse[r], path.way);
      path_[r] = static_cast<float>(along);
      far += std::fabs(along);
      rows = std::max(rows, std::fabs(inverse[r].x) + std::fabs(inverse[r].y) + std::fabs(inverse[r].z));
    }
    const double off = (residue_of(inverse, a.edges) + 0x1p-46) * 2 * far + rows * path.sum * 0x1p-46;
    if (!(off < 0x1p20) || !(far < 0x1p40)) {
      is_known_ = false;
      return;
    }
    error_ += static_cast<float>(off);
    size_of_path_ = static_cast<float>(far);
  }

  // Before that time of 0 to 1 they surely do not meet; `never`: at no time. 0 where nothing is known.
  //
  // Along a direction they overlap at time s iff |way + s path| <= reach. Besides the errors that are_apart() counts,
  // reach and way are added, in single precision: so the error of single precision is counted twice.
  double first_time(const OrientedBox& a, const OrientedBox& b) const {
    if (!is_known_) return 0;
    const auto& [ax, ay, az, half_a, half_b, x, y, z, to_x, to_y, to_z, sizes] = seen_by_first(a, b);
    float error = error_ + (sizes + size_of_path_) * 0x1p-18F;
    Times times;
    const auto along_path = [&](FloatLanes dx, FloatLanes dy, FloatLanes dz) {
      return dx * path_[0] + dy * path_[1] + dz * path_[2];
    };
    const FloatLanes way = ax * to_x + ay * to_y + az * to_z, path = along_path(ax, ay, az);
    std::array<FloatLanes, 3> seen;  // each axis of the second along those of the first
    FloatLanes reach = half_a + error;
    for (int k = 0; k < 3; ++k) {
      seen[static_cast<std::size_t>(k)] = ax * x[k] + ay * y[k] + az * z[k];
      reach += absolute(seen[static_cast<std::size_t>(k)]) * half_b[k];
    }
    times.overlap(way, path, reach);
    if (!turns_ || times.is_empty()) return times.first();
    error *= 2 * (1 + times_);
    reach = half_b * (times_ * times_) + error;
    for (int k = 0; k < 3; ++k) reach += absolute(x * ax[k] + y * ay[k] + z * az[k]) * half_a[k];
    times.overlap(x * to_x + y * to_y + z * to_z, along_path(x, y, z), reach);
    if (times.is_empty()) return never;
    const FloatLanes way_1 = turned(way), way_2 = turned(way_1), half_1 = turned(half_a), half_2 = turned(half_1);
    const FloatLanes path_1 = turned(path), path_2 = turned(path_1);
    for (std::size_t j = 0; j < 3; ++j) {
      const std::size_t k = (j + 1) % 3, l = (j + 2) % 3;
      const FloatLanes seen_1 = turned(seen[j]), seen_2 = turned(seen_1);
      const FloatLanes of_b = (absolute(seen[l]) * b.half[k] + absolute(seen[k]) * b.half[l]) * times_;
      const FloatLanes of_a = half_1 * absolute(seen_2) + half_2 * absolute(seen_1);
      times.overlap(way_2 * seen_1 - way_1 * seen_2, path_2 * seen_1 - path_1 * seen_2, of_a + of_b + error);
    }
    return times.first();
  }

 private:
  // The first three lanes count; the last one of each box is beyond all there is.
  class Times {
   public:
    // A quotient that is no number tells nothing.
    void overlap(FloatLanes way, FloatLanes path, FloatLanes reach) {
      const FloatLanes p = (-reach - way) / path, q = (reach - way) / path;
      for (int k = 0; k < 3; ++k) {
        const float low = std::min(p[k], q[k]), high = std::max(p[k], q[k]);
        if (p[k] != p[k] || q[k] != q[k]) continue;
        first_ = std::max(first_, low);
        last_ = std::min(last_, high);
      }
    }
    bool is_empty() const { return first_ * (1 - 0x1p-20F) - 0x1p-100F > last_ * (1 + 0x1p-20F); }
    double first() const {
      return is_empty() ? never : std::max(0.0, static_cast<double>(first_ * (1 - 0x1p-20F) - 0x1p-100F));
    }

   private:
    float first_ = 0, last_ = 1;
  };

  std::array<float, 3> path_{};  // in the first frame
  float size_of_path_ = 0;
};

// The same of triangles of leaves, which are where they are at time 0 (placed_triangles.h); in double precision.
class SweptTriangles {
 public:
  // `reach` of all four poses together is R: images are off by less than 2^-48 R, as of TrianglesApart; the path, of
  // three sums of numbers of at most R, by less than 2^-50 R, and so at any time. Each product with a direction, and
  // the sums of two of them, are rounded by less than 2^-48 R times the sizes of its components.
  SweptTriangles(const PlacedMesh& a, const PlacedMesh& a_end, const PlacedMesh& b, const PlacedMesh& b_end,
                 const RelativePath& path)
      : path_(path.way), is_known_(true) {
    double reach = 0;
    for (const PlacedMesh* of : {&a, &a_end, &b, &b_end}) {
      is_known_ = is_known_ && of->at(0u).tame;
      reach += of->at(0u).reach;
    }
    error_ = 0x1p-45 * reach;
  }

  double first_time(const RoundedTriangle& t, const RoundedTriangle& u) const {
    if (!is_known_) return 0;
    Times times;
    for (std::size_t c = 0; c < 3; ++c) {
      times.overlap(t.box.low[c], t.box.high[c], u.box.low[c], u.box.high[c], path_[c], error_);
    }
    if (times.is_empty()) return never;
    look_along(t.normal, t, u, times);
    look_along(u.normal, t, u, times);
    if (times.is_empty()) return never;
    const std::array<Point3, 3> e = edges_of(t), f = edges_of(u);
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t j = 0; j < 3; ++j) look_along(cross(e[i], f[j]), t, u, times);
      if (times.is_empty()) return never;
    }
    for (std::size_t i = 0; i < 3; ++i) {  // of triangles that move in one plane
      look_along(cross(t.normal, e[i]), t, u, times);
      look_along(cross(u.normal, f[i]), t, u, times);
    }
    return times.is_empty() ? never : times.first();
  }

 private:
  static std::array<Point3, 3> edges_of(const RoundedTriangle& of) {
    const auto way = [&](std::size_t i, std::size_t j) {
      const Point3 &p = of.corners[i], &q = of.corners[j];
      return Point3{q.x - p.x, q.y - p.y, q.z - p.z};
    };
    return {way(0, 1), way(1, 2), way(2, 0)};
  }

  class Times {
   public:
    // The first one is from a to a_end, and stays; the second one from b to b_end, and comes `path` in the time.
    void overlap(double a, double a_end, double b, double b_end, double path, double error) {
      const double p = (a - b_end - error) / path, q = (a_end - b + error) / path;
      if (p != p || q != q) return;
      first_ = std::max(first_, std::min(p, q));
      last_ = std::min(last_, std::max(p, q));
    }
    bool is_empty() const { return first() > last_ * (1 + 0x1p-50); }
    double first() const { return std::max(0.0, first_ * (1 - 0x1p-50) - 0x1p-1000); }

   private:
    double first_ = 0, last_ = 1;
  };

  // Any direction will do, as it is rounded. In one plane it is a product of three ways: where that is beyond the
  // doubles, or below them, quotients are no numbers, or the error is counted as nothing: so it is left out.
  void look_along(const Point3& d, const RoundedTriangle& t, const RoundedTriangle& u, Times& times) const {
    const double size = std::fabs(d.x) + std::fabs(d.y) + std::fabs(d.z);
    if (!(size > 0x1p-500 && size < 0x1p500)) return;
    const auto at = [&](const Point3& p) { return d.x * p.x + d.y * p.y + d.z * p.z; };
    const double t0 = at(t.corners[0]), t1 = at(t.corners[1]), t2 = at(t.corners[2]);
    const double u0 = at(u.corners[0]), u1 = at(u.corners[1]), u2 = at(u.corners[2]);
    times.overlap(std::min({t0, t1, t2}), std::max({t0, t1, t2}), std::min({u0, u1, u2}), std::max({u0, u1, u2}),
                  at(path_), error_ * size);
  }

  Point3 path_;
  bool is_known_;
  double error_ = 0;
};

}  // namespace sunder::solid
