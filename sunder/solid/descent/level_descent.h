// The closest points of two polyhedra, kept while going down their hierarchies.
//
// The direction between the closest points of two levels supports both there. Below, at most one vertex of each level
// lies beyond either plane (BL15 Lemma 4.2), a new one, which the walks down both hierarchies find where they stand. It
// joins the simplex of the closest points by a step of Gilbert, Johnson and Keerthi's method, which turns the
// direction, and the walks begin anew. Where the simplex holds the origin, levels meet, and so do the polyhedra.
//
// Departures: DK90 looks at all neighbours of the extreme vertex, whose degree nothing bounds. Here the walks are by
// sectors of its normal cone (hierarchy_walk.h), or down bounded hierarchies, by all neighbours that come, as BL15 has
// it (bounded_walk.h). Above the bottom the points are nearly the closest: one step a level.
#pragma once

#include <sunder/solid/pair/polyhedron_polyhedron_answer.h>
#include <sunder/solid/represent/bounded_walk.h>
#include <sunder/solid/search/axis_scaled.h>
#include <sunder/solid/search/bounded_support.h>
#include <sunder/solid/search/gjk_proposals.h>
#include <sunder/solid/search/support.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>

namespace sunder::solid {

// On a level but the last; the next goes on from there. Closest points on each level, by as many steps as it takes, are
// twice the probes in all: what is far from the closest points at the bottom is soon undone.
inline constexpr int most_steps_on_a_level = 1;

// The walks down both kinds of hierarchies, as LevelWalk takes them: from level to level along one direction.
template <class Real>
class PlainLevels {
 public:
  static constexpr bool are_bounded = false;

  PlainLevels(const ConvexPolyhedron& body, std::uint64_t& probes)
      : compare_(body), turn_{compare_}, walk_(compare_.hierarchy(), compare_, turn_, probes) {}

  std::size_t level_count() const { return compare_.hierarchy().level_end.size(); }
  void turn_to(const VectorOf<Real>& direction) {
    compare_.turn_to(direction);
    walk_.start();
  }
  std::uint32_t furthest(std::size_t level) {
    const Hierarchy& hierarchy = compare_.hierarchy();
    return hierarchy.nodes[walk_.go_on(hierarchy.level_end[level])].vertex;
  }

 private:
  using Compare = CompareAlong<Real>;
  using Turn = TurnBy<Compare>;

  Compare compare_;
  Turn turn_;
  HierarchyWalk<Compare, Turn> walk_;
};

// A cut point stands for the vertex that it was cut from: a vertex of the polyhedron, and near.
template <class Real>
class BoundedLevels {
 public:
  static constexpr bool are_bounded = true;

  BoundedLevels(const ConvexPolyhedron& body, std::uint64_t& probes)
      : compare_(body), walk_(compare_.hierarchy(), compare_, probes) {}

  std::size_t level_count() const { return compare_.hierarchy().levels.size(); }
  void turn_to(const VectorOf<Real>& direction) {
    compare_.turn_to(direction);
    walk_.start();
  }
  std::uint32_t furthest(std::size_t level) {
    const BoundedHierarchy& hierarchy = compare_.hierarchy();
    return hierarchy.nodes[walk_.go_on(hierarchy.levels[level].end)].vertex;
  }

 private:
  using Compare = CompareBounded<Real>;

  Compare compare_;
  BoundedWalk<Compare> walk_;
};

// The furthest vertices of the levels of one body. A point and a segment have one level.
template <class Real, class Levels>
class LevelWalk {
 public:
  using Vector = VectorOf<Real>;

  LevelWalk(const ConvexPolyhedron& body, std::uint64_t& probes) : vertices_(body.vertices()), probes_(probes) {
    if (vertices_.size() >= 3) levels_.emplace(body, probes);
  }
  LevelWalk(const LevelWalk&) = delete;
  LevelWalk& operator=(const LevelWalk&) = delete;

  std::size_t level_count() const { return levels_ ? levels_->level_count() : 1; }

  void turn_to(const Vector& direction) {
    if (levels_) {
      levels_->turn_to(direction);
    } else {
      direction_ = direction;
    }
  }

  // Requires a level not above that of the last call since the direction turned.
  std::uint32_t furthest(std::size_t level) {
    if (levels_) return levels_->furthest(std::min(level, level_count() - 1));
    probes_ += vertices_.size();
    const Point3 &p = vertices_.front(), &q = vertices_.back();
    const Vector edge{difference<Real>(q.x, p.x), difference<Real>(q.y, p.y), difference<Real>(q.z, p.z)};
    return dot(direction_, edge) > Real(0) ? 1 : 0;
  }

 private:
  std::span<const Point3> vertices_;
  std::uint64_t& probes_;
  Vector direction_{};  // of a body without a hierarchy
  std::optional<Levels> levels_;
};

// The difference of levels.
template <class Real, class Levels>
class LevelSupport : public GraphSupport<Real> {
 public:
  using Vector = VectorOf<Real>;

  LevelSupport(const Placed& a, const Placed& b, Cost& cost)
      : GraphSupport<Real>(a, b), a_(a), b_(b), of_a_(a.body, cost.probes), of_b_(b.body, cost.probes) {}

  std::size_t level = 0;

  std::size_t level_count() const { return std::max(of_a_.level_count(), of_b_.level_count()); }

  void turn_to(const Vector& direction) {
    of_a_.turn_to(a_.pulled(direction));
    of_b_.turn_to(negated(b_.pulled(direction)));
  }

  // Along the direction that it was turned to.
  DifferenceVertexOf<Real> furthest(const Vector&, const DifferenceSimplexOf<Real>&, Cost&) {
    return this->of_vertices(of_a_.furthest(level), of_b_.furthest(level));
  }

 private:
  const Placed& a_;
  const Placed& b_;
  LevelWalk<Real, Levels> of_a_, of_b_;
};

template <class Real, class Levels>
using Descent = Gjk<Real, LevelSupport<Real, Levels>>;

template <class Real, class Levels>
bool propose_by_descent(const Placed& a, const Placed& b, Descent<Real, Levels>& search, const Holds& holds,
                        Cost& cost) {
  LevelSupport<Real, Levels>& support = search.support;
  support.turn_to(search.direction);
  const std::size_t levels = support.level_count();
  for (support.level = 0; support.level < levels; ++support.level) {
    const bool is_last = support.level + 1 == levels;
    GjkLimits limits{.in_vain = 1};
    if (!is_last) limits.steps = most_steps_on_a_level;
    const auto parts = [&](const auto& w) { return is_last && propose_apart(search, w, holds); };
    const auto turns = [&](bool) {
      support.turn_to(search.direction);
      return false;
    };
    const GjkEnd end = search.run(limits, cost, parts, turns);
    if (end == GjkEnd::stopped) return true;
    if (end != GjkEnd::inside) continue;
    if (propose_meet(a, b, search.simplex, holds)) return true;
    if (is_last) return false;
    search.simplex.count = 0;  // the polyhedra may meet in another way, more clearly
    support.turn_to(search.direction);
  }
  return propose_meet(a, b, search.simplex, holds);
}

// In doubles, then in twice the precision. Levels: PlainLevels or BoundedLevels.
template <template <class> class Levels>
bool propose_by_levels(const Placed& a, const Placed& b, const Holds& holds, Cost& cost) {
  Descent<double, Levels<double>> search(a, b, cost);
  search.begin({});
  if (propose_by_descent<double, Levels<double>>(a, b, search, holds, cost) ||
      propose_apart_along_features(search.simplex, search.direction, holds)) {
    return true;
  }
  Descent<DoubleDouble, Levels<DoubleDouble>> finer(a, b, cost);
  const Point3& d = search.direction;
  finer.direction = {d.x, d.y, d.z};
  return propose_by_descent<DoubleDouble, Levels<DoubleDouble>>(a, b, finer, holds, cost);
}

template <template <class> class Levels>
PairAnswer polyhedron_polyhedron_by_levels(const ConvexPolyhedron& body_a, const Pose& pose_a,  //
                                           const ConvexPolyhedron& body_b, const Pose& pose_b) {
  Placed a(body_a, pose_a), b(body_b, pose_b);
  a.by_bounded = b.by_bounded = Levels<double>::are_bounded;
  return answer_by(a, b, [&](const Holds& holds, Cost& cost) {
    const auto propose = [&](const Placed& p, const Placed& q, const Holds& of) {
      return propose_by_levels<Levels>(p, q, of, cost);
    };
    return propose_axis_scaled_where_wanted(a, b, holds, propose);
  });
}

}  // namespace sunder::solid
