#include <sunder/base/interruption.h>
#include <sunder/solid/hull/quickhull.h>

#include <sunder/predicate/point/scaled_orient.h>

#include <algorithm>
#include <queue>
#include <random>
#include <utility>

// Quickhull keeps the boundary of the hull C of the points inserted so far, and for every other point that lies
// strictly outside of C a triangle that the point is strictly above; the points of one triangle are its conflict list.
// To insert a point p, the triangles that p is strictly above are removed and p is joined to the rim of the hole.
//
// Q1. No triangle is degenerate. Of the two triangles at an edge ab of the rim, p is strictly above one and not above
//     the other. Were p on the line ab, it would be in both planes.
// Q2. The hole is a disk. Let c be inside C. From p' = p - e (p - c), for a small e > 0, exactly the triangles of the
//     hole are strictly visible and no plane of a triangle contains p'. What is visible from a point in general
//     position is a disk.
// Q3. The new triangles and the kept ones cover the boundary of C' = hull(C, p) once: the kept ones are the part of the
//     boundary of C that p is not strictly above, which stays boundary; the rest is the cone from p over the rim.
// Q4. A point q of the list of a removed triangle R is inside C' or on its boundary, or strictly above a new triangle.
//     Suppose it is not strictly above any. The new triangles are all those at p, so q lies in the cone from p over C:
//     q = p + t (x - p) for an x in C. If t <= 1, q is in C'. Otherwise x is strictly between p and q, which are both
//     strictly above R, so x in C is strictly above R too, which contradicts that R bounds C.
//     So points strictly above no new triangle can be dropped: they repeat a corner or are not extreme in the whole
//     set.
// Q5. The lists are empty in the end, so all points are in the hull, and each extreme point is inserted. Each insertion
//     takes a point from the lists for good, and so the end comes.
// Q6. Equal points are always in the same list, because where a point goes depends on its coordinates only. Of equal
//     points the one with the lowest index is inserted, so a corner has the lowest index among the points equal to it.
//     Mostly that is the first of a list, which is the farthest, at equal heights the one with the lowest index.
// Q7. Which of many new triangles is q strictly above? They are the sides of a convex cone with apex p, so this is
//     whether a point lies in a convex polygon, by halving. Let r(0), r(1), ... be the rim; the axis is the line from p
//     to r(0), and h(k) the half-plane from the axis through r(k). These turn about the axis by less than half a turn,
//     from the first triangle to the last. If q is above neither of these two, it lies in a half-plane h from the axis
//     between them. If h lies from h(k) to h(k + 1), not on the axis only, its part in the cone is an angle of less
//     than half a turn between the axis and triangle k; so q is in the cone or above triangle k. The first and the last
//     triangle, and those coplanar with them, are no such side: where h is in their plane, the side is the one after
//     or before them. A point of the axis is in every half-plane, and any such side tells.
// Q8. Where points crowd together at ever smaller sizes, as (t, t^2, 0) for t = 1, 1/2, 1/4, ... do, the farthest one
//     leaves all but a few on one list, again and again. So after some such insertions one is taken at random.
// All this needs the exact sign for "strictly above". "Farthest" may be as wrong as floating point makes it, as long as
// it orders the points and equal points have equal heights.
//
// Triangles coplanar with p stay, although then some corner may no longer be extreme and has to be sorted out later
// (merge_coplanar). Removing them would keep every corner extreme, but would replace all triangles of a flat facet
// with each new corner of it: quadratic for a prism.

namespace sunder::solid {

namespace {

constexpr std::uint32_t no_point = Triangle::none;

// The size of the box around the points, as rounded.
Point3 extent_of(std::span<const Point3> points) {
  Point3 low = points[0], high = points[0];
  for (const Point3& p : points) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
  }
  return {high.x - low.x, high.y - low.y, high.z - low.z};
}

class Quickhull {
 public:
  explicit Quickhull(std::span<const Point3> points)
      : points_(points), extent_(extent_of(points)), next_outside_(points.size()) {}

  Triangulation run(std::array<std::uint32_t, 4> simplex) {
    start(simplex);
    while (!urgent_.empty() || !waiting_.empty()) {
      may_be_interrupted(20);
      const std::uint32_t t = take_next();
      if (triangles_[t].removed || triangles_[t].outside == no_point) continue;
      insert(triangles_[t].lopsided < most_lopsided ? triangles_[t].outside : random_outside(t), t);
    }
    return {std::move(triangles_), side_tests_};
  }

 private:
  // An edge, as the triangle on its left and the place of its first corner there.
  struct Edge {
    std::uint32_t triangle;
    std::uint32_t place;
    friend bool operator==(const Edge&, const Edge&) = default;
  };

  // A triangle that the latest insertion made.
  struct Fresh {
    std::uint32_t triangle;
    std::uint32_t outside_count = 0;  // the length of its conflict list
  };

  // The index of a new triangle a, b, c. `adjacent` is left open.
  std::uint32_t make_triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    std::uint32_t t;
    if (free_.empty()) {
      t = static_cast<std::uint32_t>(triangles_.size());
      triangles_.emplace_back();
    } else {
      t = free_.back();
      free_.pop_back();
    }
    triangles_[t] = {.corner = {a, b, c}, .plane = FacetPlane(points_[a], points_[b], points_[c], extent_)};
    return t;
  }

  void start(std::array<std::uint32_t, 4> simplex) {
    auto [a, b, c, d] = simplex;
    if (orient_3d(points_[a], points_[b], points_[c], points_[d]) == Sign::positive) std::swap(b, c);
    for (const auto& [i, j, k] : {std::array{a, b, c}, {a, d, b}, {b, d, c}, {c, d, a}}) {
      fresh_.push_back({make_triangle(i, j, k)});
    }
    triangles_[0].adjacent = {1, 2, 3};
    triangles_[1].adjacent = {3, 2, 0};
    triangles_[2].adjacent = {1, 3, 0};
    triangles_[3].adjacent = {2, 1, 0};
    for (std::uint32_t q = 0; q < points_.size(); ++q) place(q);
    queue_fresh();
  }

  // Inserts point p, which is strictly above triangle t.
  void insert(std::uint32_t p, std::uint32_t t) {
    const Edge rim = remove_visible(points_[p], t);
    fill_hole(p, rim);
    std::uint32_t placed = 0;
    for (const std::uint32_t v : visible_) {
      for (std::uint32_t q = std::exchange(triangles_[v].outside, no_point); q != no_point; ++placed) {
        const std::uint32_t following = next_outside_[q];
        if (points_[q] != points_[p]) place(q);
        q = following;
      }
    }
    note_lopsided(triangles_[t].lopsided, placed);
    free_.insert(free_.end(), visible_.begin(), visible_.end());
    queue_fresh();
  }

  // Q8. Does one of the fresh triangles have nearly all of the points that were placed? `before`: of the triangle that
  // the insertion began with.
  void note_lopsided(std::uint8_t before, std::uint32_t placed) {
    for (const Fresh& fresh : fresh_) {
      const bool is_lopsided = fresh.outside_count >= short_list && fresh.outside_count > placed - placed / 4;
      const int now = is_lopsided ? std::min(before + 1, most_lopsided) : std::max(before - 1, 0);
      triangles_[fresh.triangle].lopsided = static_cast<std::uint8_t>(now);
    }
  }

  // Q8. A point of the list of triangle t at random; of equal points the one with the lowest index.
  std::uint32_t random_outside(std::uint32_t t) {
    const std::uint32_t first = triangles_[t].outside;
    std::uint32_t chosen = first, count = 0;
    for (std::uint32_t q = first; q != no_point; q = next_outside_[q]) ++count;
    for (auto skipped = random_() % count; skipped > 0; --skipped) chosen = next_outside_[chosen];
    for (std::uint32_t q = first; q != no_point; q = next_outside_[q]) {
      if (q < chosen && points_[q] == points_[chosen]) chosen = q;
    }
    return chosen;
  }

  static constexpr int most_lopsided = 2;
  static constexpr std::uint32_t short_list = 16;  // of such lists the order does not matter

  // Marks the triangles that p is strictly above as removed and lists them in visible_, starting from triangle t,
  // which is one of them. Returns an edge of the rim, as seen from the hole.
  Edge remove_visible(const Point3& p, std::uint32_t t) {
    Edge rim{t, 0};
    std::uint64_t tests = 0;
    visible_.assign(1, t);
    triangles_[t].removed = true;
    for (std::size_t i = 0; i < visible_.size(); ++i) {
      const std::uint32_t v = visible_[i];
      for (const std::uint32_t e : {0u, 1u, 2u}) {
        const std::uint32_t beyond = triangles_[v].adjacent[e];
        if (triangles_[beyond].removed) continue;
        if (triangles_[beyond].side(points_, p) == Sign::positive) {
          triangles_[beyond].removed = true;
          visible_.push_back(beyond);
        } else {
          rim = {v, e};
        }
        ++tests;
      }
    }
    side_tests_ += tests;
    return rim;
  }

  // Joins p to all edges of the rim, counter-clockwise from one of them. The new triangles are listed in fresh_.
  void fill_hole(std::uint32_t p, const Edge& first) {
    fresh_.clear();
    Edge rim = first;
    do {
      const std::uint32_t a = triangles_[rim.triangle].corner[rim.place];
      const std::uint32_t b = triangles_[rim.triangle].corner[next(rim.place)];
      const std::uint32_t kept = triangles_[rim.triangle].adjacent[rim.place];
      const std::uint32_t t = make_triangle(p, a, b);
      triangles_[t].adjacent[1] = kept;
      triangles_[kept].adjacent[triangles_[kept].place_of(b)] = t;
      if (!fresh_.empty()) link(fresh_.back().triangle, t);
      fresh_.push_back({t});
      rim = next_on_rim(rim);
    } while (rim != first);
    link(fresh_.back().triangle, fresh_.front().triangle);
  }

  // New triangles p, a, b and p, b, c share the edge bp.
  void link(std::uint32_t pab, std::uint32_t pbc) {
    triangles_[pab].adjacent[2] = pbc;
    triangles_[pbc].adjacent[0] = pab;
  }

  // The edge of the rim that begins where the given one ends: turns about that corner through the hole.
  Edge next_on_rim(const Edge& rim) const {
    const std::uint32_t pivot = triangles_[rim.triangle].corner[next(rim.place)];
    Edge edge{rim.triangle, next(rim.place)};
    for (;;) {
      const std::uint32_t beyond = triangles_[edge.triangle].adjacent[edge.place];
      if (!triangles_[beyond].removed) return edge;
      edge = {beyond, triangles_[beyond].place_of(pivot)};
    }
  }

  // Puts point q on the conflict list of a fresh triangle that it is strictly above, if any.
  void place(std::uint32_t q) {
    const bool wide = fresh_.size() > wide_fan;
    const std::size_t first = wide ? fan_place(points_[q]) : 0, end = wide ? first + 1 : fresh_.size();
    for (std::size_t k = first; k < end; ++k) {
      Fresh& fresh = fresh_[k];
      Triangle& triangle = triangles_[fresh.triangle];
      if (triangle.side(points_, points_[q]) != Sign::positive) continue;
      const std::uint32_t farthest = triangle.outside;
      if (farthest == no_point || is_farther(triangle, q, farthest)) {
        next_outside_[q] = farthest;
        triangle.outside = q;
      } else {
        next_outside_[q] = next_outside_[farthest];
        next_outside_[farthest] = q;
      }
      ++fresh.outside_count;
      side_tests_ += k + 1 - first;
      return;
    }
    side_tests_ += end - first;
  }

  // Fans of more triangles are searched by halving. The limit is uncritical.
  static constexpr std::uint32_t wide_fan = 64;

  // The number of the fresh triangle that q is strictly above if it is strictly above any; see Q7.
  [[gnu::noinline]] std::uint32_t fan_place(const Point3& q) {
    const auto last = static_cast<std::uint32_t>(fresh_.size()) - 1;
    const Sign to_first = fan_side(1, q), to_last = fan_side(last, q);
    if (to_first == Sign::positive) return 0;    // the plane of the first triangle
    if (to_last == Sign::negative) return last;  // that of the last one, seen from its other side
    if (to_last == Sign::zero && to_first != Sign::zero) {
      return halved(0, last, [&](std::uint32_t k) { return fan_side(k, q) == Sign::negative; });
    }
    const Point3& witness = to_last == Sign::zero ? points_[rim_corner(1)] : q;  // zero twice: q is on the axis
    return halved(1, last, [&](std::uint32_t k) { return fan_side(k, witness) != Sign::positive; });
  }

  // The greatest k in [low, high) with a property that holds at low, and from there on up to some k.
  template <class Holds>
  static std::uint32_t halved(std::uint32_t low, std::uint32_t high, const Holds& holds) {
    while (high - low > 1) {
      const std::uint32_t middle = low + (high - low) / 2;
      (holds(middle) ? low : high) = middle;
    }
    return low;
  }

  // The corner of the rim at which fresh triangle k begins.
  std::uint32_t rim_corner(std::uint32_t k) const { return triangles_[fresh_[k].triangle].corner[1]; }

  // On which side of the plane through the axis and corner k of the rim q is: negative towards higher numbers.
  Sign fan_side(std::uint32_t k, const Point3& q) {
    ++side_tests_;
    return orient_3d_of_any_size(points_[triangles_[fresh_[0].triangle].corner[0]], points_[rim_corner(0)],
                                 points_[rim_corner(k)], q);
  }

  bool is_farther(const Triangle& triangle, std::uint32_t q, std::uint32_t r) const {
    const auto height = [&](std::uint32_t i) {
      const double h = triangle.plane.height(points_[triangle.corner[0]], points_[i]);
      return h > 0 ? h : 0;  // both are above, whatever rounding says; NaN after an overflow
    };
    const double q_height = height(q), r_height = height(r);
    return q_height > r_height || (q_height == r_height && q < r);
  }

  // Long lists are worked off in the order in which they came up, so that the hull grows evenly all round: else a
  // region can fill up with needles that end at a corner far away, which are replaced again and again. Short lists are
  // worked off at once, while what they need is in the memory caches. The limit is uncritical.
  static constexpr std::uint32_t long_list = 64;

  void queue_fresh() {
    for (const Fresh& fresh : fresh_) {
      if (fresh.outside_count >= long_list) {
        waiting_.push(fresh.triangle);
      } else if (fresh.outside_count > 0) {
        urgent_.push_back(fresh.triangle);
      }
    }
  }

  std::uint32_t take_next() {
    std::uint32_t t;
    if (urgent_.empty()) {
      t = waiting_.front();
      waiting_.pop();
    } else {
      t = urgent_.back();
      urgent_.pop_back();
    }
    return t;
  }

  std::span<const Point3> points_;
  Point3 extent_;
  std::vector<std::uint32_t> next_outside_;  // the conflict lists: what follows a point in its list
  std::vector<Triangle> triangles_;
  std::vector<std::uint32_t> free_;    // removed triangles, whose places can be used again
  std::vector<std::uint32_t> urgent_;  // every triangle with a list is in one of these; others may be
  std::queue<std::uint32_t> waiting_;
  std::vector<std::uint32_t> visible_;  // of the latest insertion: the triangles removed,
  std::vector<Fresh> fresh_;            // and the triangles made
  std::minstd_rand random_;
  std::uint64_t side_tests_ = 0;
};

}  // namespace

Triangulation quickhull(std::span<const Point3> points, std::array<std::uint32_t, 4> simplex) {
  return Quickhull(points).run(simplex);
}

}  // namespace sunder::solid
