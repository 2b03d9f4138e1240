// For tests: the hull by trying all planes through three points, in integer arithmetic. Shares with convex_hull the
// form of the answer, and no code.
#pragma once

#include <sunder/solid/hull/convex_hull.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <map>
#include <set>
#include <utility>
#include <vector>

namespace sunder::solid {

// T: an integer type that holds the determinants without overflow.
template <class T>
class BruteForceHull {
 public:
  using Vector = std::array<T, 3>;
  using Set = std::set<std::uint32_t>;

  explicit BruteForceHull(std::vector<Vector> points) : points_(std::move(points)) {
    std::map<Vector, std::uint32_t> first_of;
    for (std::uint32_t i = 0; i < points_.size(); ++i) first_of.insert({points_[i], i});
    for (const auto& [point, i] : first_of) distinct_.insert(i);
  }

  ConvexHull hull() {
    find_facets();
    ConvexHull result;
    result.dimension = dimension_;
    for (const std::uint32_t p : distinct_) {
      if (is_extreme(p)) result.vertices.push_back(p);
    }
    const auto number = [&](std::uint32_t p) {
      return static_cast<std::uint32_t>(std::find(result.vertices.begin(), result.vertices.end(), p) -
                                        result.vertices.begin());
    };

    std::set<std::vector<std::uint32_t>> cycles;
    for (const auto& [on_plane, normal] : facets_) {
      Set corners;
      for (const std::uint32_t p : on_plane) {
        if (is_extreme(p)) corners.insert(number(p));
      }
      cycles.insert(cycle_of(result.vertices, corners, normal));
      if (dimension_ == 2) cycles.insert(cycle_of(result.vertices, corners, minus({}, normal)));
    }
    for (const std::vector<std::uint32_t>& cycle : cycles) append(cycle, result.facet_begin, result.facet_vertices);

    // At vertex v, counter-clockwise: after the vertex that follows v on a facet comes the one before v.
    for (std::uint32_t v = 0; v < result.vertices.size(); ++v) {
      std::map<std::uint32_t, std::uint32_t> after;
      for (const std::vector<std::uint32_t>& cycle : cycles) {
        const std::size_t size = cycle.size();
        for (std::size_t i = 0; i < size; ++i) {
          if (cycle[i] == v) after[cycle[(i + 1) % size]] = cycle[(i + size - 1) % size];
        }
      }
      if (dimension_ == 1) after[1 - v] = 1 - v;
      std::vector<std::uint32_t> around;
      if (!after.empty()) {
        std::uint32_t w = after.begin()->first;
        do {
          around.push_back(w);
          w = after.at(w);
        } while (w != around.front());
      }
      append(around, result.neighbour_begin, result.neighbours);
    }
    return result;
  }

 private:
  static Vector minus(const Vector& a, const Vector& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
  static T dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
  static Vector cross(const Vector& a, const Vector& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
  }
  static bool is_zero(const Vector& a) { return a[0] == 0 && a[1] == 0 && a[2] == 0; }

  static void append(const std::vector<std::uint32_t>& cycle, std::vector<std::uint32_t>& begin,
                     std::vector<std::uint32_t>& all) {
    all.insert(all.end(), cycle.begin(), cycle.end());
    begin.push_back(static_cast<std::uint32_t>(all.size()));
  }

  // All planes through three points that have all others on one side, with an outward normal; and the dimension.
  void find_facets() {
    dimension_ = distinct_.size() > 1 ? 1 : 0;
    for (const std::uint32_t a : distinct_) {
      for (const std::uint32_t b : distinct_) {
        for (const std::uint32_t c : distinct_) {
          if (a < b && b < c) try_plane(a, b, c);
        }
      }
    }
  }

  void try_plane(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    Vector normal = cross(minus(points_[b], points_[a]), minus(points_[c], points_[a]));
    if (is_zero(normal)) return;
    dimension_ = std::max(dimension_, 2);
    bool any_above = false, any_below = false;
    Set on_plane;
    for (const std::uint32_t p : distinct_) {
      const T height = dot(normal, minus(points_[p], points_[a]));
      any_above |= height > 0;
      any_below |= height < 0;
      if (height == 0) on_plane.insert(p);
    }
    if (any_above || any_below) dimension_ = 3;
    if (any_above && any_below) return;
    if (any_above) normal = minus({}, normal);
    facets_.insert({on_plane, normal});
  }

  // Of the facets' planes through an extreme point of a body, three meet in that point alone. Of a flat set a point is
  // extreme when it is neither between two others nor inside a triangle of three.
  bool is_extreme(std::uint32_t p) const {
    if (dimension_ == 3) {
      std::vector<Vector> normals;
      for (const auto& [on_plane, normal] : facets_) {
        if (on_plane.count(p)) normals.push_back(normal);
      }
      for (const Vector& l : normals) {
        for (const Vector& m : normals) {
          for (const Vector& n : normals) {
            if (dot(cross(l, m), n) != 0) return true;
          }
        }
      }
      return false;
    }
    for (const std::uint32_t a : distinct_) {
      for (const std::uint32_t b : distinct_) {
        if (a == p || b == p) continue;
        const Vector pa = minus(points_[a], points_[p]), pb = minus(points_[b], points_[p]);
        if (is_zero(cross(pa, pb)) && dot(pa, pb) < 0) return false;
        for (const std::uint32_t c : distinct_) {
          if (c == p) continue;
          const Vector pc = minus(points_[c], points_[p]);
          if (dot(cross(pa, pb), cross(pb, pc)) > 0 && dot(cross(pb, pc), cross(pc, pa)) > 0) return false;
        }
      }
    }
    return true;
  }

  // The corners of a convex polygon counter-clockwise around a normal: all others are on the left of an edge.
  std::vector<std::uint32_t> cycle_of(const std::vector<std::uint32_t>& vertices, const Set& corners,
                                      const Vector& normal) const {
    std::vector<std::uint32_t> cycle{*corners.begin()};
    for (std::size_t i = 1; i < corners.size(); ++i) {
      const Vector& a = points_[vertices[cycle.back()]];
      for (const std::uint32_t next : corners) {
        if (next == cycle.back()) continue;
        const Vector edge = minus(points_[vertices[next]], a);
        if (std::all_of(corners.begin(), corners.end(), [&](std::uint32_t c) {
              return c == cycle.back() || c == next || dot(cross(edge, minus(points_[vertices[c]], a)), normal) > 0;
            })) {
          cycle.push_back(next);
          break;
        }
      }
    }
    return cycle;
  }

  std::vector<Vector> points_;
  Set distinct_;  // of equal points the one with the lowest index
  int dimension_ = 0;
  std::map<Set, Vector> facets_;  // the points on the plane of a facet, and the outward normal
};

}  // namespace sunder::solid
