// How far apart are two triangles of leaves of two placed meshes? In double precision, with bounds of all errors.
// Also called: triangle-triangle distance. Source: Ericson 2005, "Real-Time Collision Detection", section 5.1.
#pragma once

#include <sunder/number/interval.h>
#include <sunder/solid/mesh/placed_triangles.h>
#include <sunder/solid/search/closest_features.h>
#include <sunder/solid/search/search_vector.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

namespace sunder::solid {

// Encloses the distance of two triangles; and corners (0, 1, 2) that seem to hold the nearest points.
struct TriangleGap {
  Interval distance{0, std::numeric_limits<double>::infinity()};
  FeatureVertices features{1, 1, {0, 0}};
  Point3 way;  // between these points, from A to B
};

class TriangleGaps {
 public:
  // Errors of images: as of TrianglesApart.
  TriangleGaps(const PlacedMesh& a, const PlacedMesh& b)
      : is_known_(a.at(0u).tame && b.at(0u).tame), error_(0x1p-44 * (a.at(0u).reach + b.at(0u).reach)) {}

  // If the distance is more than `limit`, the answer may tell no more than that.
  TriangleGap operator()(const RoundedTriangle& t, const RoundedTriangle& u, double limit) const {
    TriangleGap gap;
    if (!is_known_) return gap;
    double square = 0;
    for (std::size_t c = 0; c < 3; ++c) {
      const double apart = std::max({t.box.low[c] - u.box.high[c], u.box.low[c] - t.box.high[c], 0.0});
      square += apart * apart;
    }
    gap.distance.low = std::max(0.0, std::sqrt(square) * (1 - 0x1p-48) - error_);
    if (gap.distance.low > limit) return gap;
    Nearest nearest;
    for (std::uint32_t i = 0; i < 3; ++i) {
      for (std::uint32_t j = 0; j < 3; ++j) nearest.of_edges(t, i, u, j);
    }
    for (std::uint32_t k = 0; k < 3; ++k) {
      nearest.of_face(t, u, k, true);
      nearest.of_face(u, t, k, false);
    }
    const double length = std::sqrt(nearest.square);
    gap.features = nearest.features;
    gap.way = nearest.way;
    gap.distance.high = length * (1 + 0x1p-48) + error_;
    if (length > 0) gap.distance.low = std::max(gap.distance.low, rounded_along(nearest.way, t, u) / length - error_);
    return gap;
  }

  // How far apart they are at least, as a direction from A to B of length 1 tells, or of length 0; it may be below 0.
  double along(const Point3& d, const RoundedTriangle& t, const RoundedTriangle& u) const {
    return is_known_ ? rounded_along(d, t, u) - error_ : 0;
  }

 private:
  static Point3 minus(const Point3& p, const Point3& q) { return {p.x - q.x, p.y - q.y, p.z - q.z}; }

  static double rounded_along(const Point3& d, const RoundedTriangle& t, const RoundedTriangle& u) {
    return std::min({dot(d, u.corners[0]), dot(d, u.corners[1]), dot(d, u.corners[2])}) -
           std::max({dot(d, t.corners[0]), dot(d, t.corners[1]), dot(d, t.corners[2])});
  }

  // Two points, in the triangles but for rounding.
  struct Nearest {
    double square = std::numeric_limits<double>::infinity();
    Point3 way;  // from A to B
    FeatureVertices features{1, 1, {0, 0}};

    void of_edges(const RoundedTriangle& t, std::uint32_t i, const RoundedTriangle& u, std::uint32_t j) {
      const std::uint32_t i2 = (i + 1) % 3, j2 = (j + 1) % 3;
      const Point3 e = minus(t.corners[i2], t.corners[i]), f = minus(u.corners[j2], u.corners[j]),
                   r = minus(u.corners[j], t.corners[i]);
      const double ee = dot(e, e), ff = dot(f, f), ef = dot(e, f), er = dot(e, r), fr = dot(f, r);
      const double spanned = ee * ff - ef * ef;
      double s = spanned > 0 ? std::clamp((er * ff - fr * ef) / spanned, 0.0, 1.0) : 0;
      const double wanted = ff > 0 ? (ef * s - fr) / ff : 0, v = std::clamp(wanted, 0.0, 1.0);
      if (v != wanted) s = ee > 0 ? std::clamp((ef * v + er) / ee, 0.0, 1.0) : 0;
      const Point3 d{r.x + f.x * v - e.x * s, r.y + f.y * v - e.y * s, r.z + f.z * v - e.z * s};
      if (!take(d)) return;
      features = {};
      add_ends(s, i, i2, features.count_a);
      add_ends(v, j, j2, features.count_b);
    }

    // Corner k of u above the inside of t.
    void of_face(const RoundedTriangle& t, const RoundedTriangle& u, std::uint32_t k, bool is_t_of_a) {
      const double area = dot(t.normal, t.normal);
      std::array<double, 3> weights{};
      double sum = 0;
      for (std::size_t c = 0; c < 3; ++c) {
        const Point3 &p = t.corners[(c + 1) % 3], &q = t.corners[(c + 2) % 3];
        weights[c] = dot(cross(minus(q, p), minus(u.corners[k], p)), t.normal);
        if (!(weights[c] > 0)) return;
        sum += weights[c];
      }
      if (!(area > 0)) return;
      Point3 d = u.corners[k];
      for (std::size_t c = 0; c < 3; ++c) {
        const double weight = weights[c] / sum;
        const Point3& p = t.corners[c];
        d = {d.x - p.x * weight, d.y - p.y * weight, d.z - p.z * weight};
      }
      if (!is_t_of_a) d = {-d.x, -d.y, -d.z};
      if (!take(d)) return;
      features = is_t_of_a ? FeatureVertices{3, 1, {0, 1, 2, k}} : FeatureVertices{1, 3, {k, 0, 1, 2}};
    }

   private:
    bool take(const Point3& d) {
      const double length = dot(d, d);
      if (!(length < square)) return false;
      square = length;
      way = d;
      return true;
    }
    void add_ends(double at, std::uint32_t first, std::uint32_t second, std::uint8_t& count) {
      std::size_t n = std::size_t{features.count_a} + features.count_b;
      if (at < 1) features.vertices[n++] = first, ++count;
      if (at > 0) features.vertices[n] = second, ++count;
    }
  };

  bool is_known_;
  double error_;
};

}  // namespace sunder::solid
