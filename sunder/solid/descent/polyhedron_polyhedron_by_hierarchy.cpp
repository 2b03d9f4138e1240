// The closest points of two polyhedra, kept while going down their hierarchies.
//
// The direction between the closest points of two levels supports both there. Below, at most one vertex of each level
// lies beyond either plane (BL15 Lemma 4.2), a new one, which the walks down both hierarchies find where they stand. It
// joins the simplex of the closest points by a step of Gilbert, Johnson and Keerthi's method, which turns the
// direction, and the walks begin anew. Where the simplex holds the origin, levels meet, and so do the polyhedra.
//
// Departures: DK90 looks at all neighbours of the extreme vertex, whose degree nothing bounds; the walks here are by
// sectors of its normal cone (hierarchy_walk.h). Above the bottom the points are nearly the closest: one step a level.
#include <sunder/solid/pair/polyhedron_polyhedron.h>
#include <sunder/solid/pair/polyhedron_polyhedron_answer.h>
#include <sunder/solid/search/axis_scaled.h>
#include <sunder/solid/search/gjk_proposals.h>
#include <sunder/solid/search/support.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>

namespace sunder::solid {

namespace {

// On a level but the last; the next goes on from there. Closest points on each level, by as many steps as it takes, are
// twice the probes in all: what is far from the closest points at the bottom is soon undone.
constexpr int most_steps_on_a_level = 1;

// The furthest vertices of the levels of one body. A point and a segment have one level.
template <class Real>
class LevelWalk {
 public:
  using Vector = VectorOf<Real>;

  LevelWalk(const ConvexPolyhedron& body, std::uint64_t& probes) : vertices_(body.vertices()), probes_(probes) {
    if (vertices_.size() < 3) return;
    compare_.emplace(body);
    turn_.emplace(*compare_);
    walk_.emplace(hierarchy(), *compare_, *turn_, probes);
  }
  LevelWalk(const LevelWalk&) = delete;
  LevelWalk& operator=(const LevelWalk&) = delete;

  std::size_t level_count() const { return walk_ ? hierarchy().level_end.size() : 1; }

  void turn_to(const Vector& direction) {
    if (walk_) {
      compare_->turn_to(direction);
      walk_->start();
    } else {
      direction_ = direction;
    }
  }

  // Requires a level not above that of the last call since the direction turned.
  std::uint32_t furthest(std::size_t level) {
    if (walk_) {
      const std::uint32_t end = hierarchy().level_end[std::min(level, level_count() - 1)];
      return hierarchy().nodes[walk_->go_on(end)].vertex;
    }
    probes_ += vertices_.size();
    const Point3 &p = vertices_.front(), &q = vertices_.back();
    const Vector edge{difference<Real>(q.x, p.x), difference<Real>(q.y, p.y), difference<Real>(q.z, p.z)};
    return dot(direction_, edge) > Real(0) ? 1 : 0;
  }

 private:
  using Compare = CompareAlong<Real>;
  using Turn = TurnBy<CompareAlong<Real>>;

  const Hierarchy& hierarchy() const { return compare_->hierarchy(); }

  std::span<const Point3> vertices_;
  std::uint64_t& probes_;
  Vector direction_{};  // of a body without a hierarchy
  std::optional<Compare> compare_;
  std::optional<Turn> turn_;
  std::optional<HierarchyWalk<Compare, Turn>> walk_;
};

// The difference of levels.
template <class Real>
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
  LevelWalk<Real> of_a_, of_b_;
};

template <class Real>
using Descent = Gjk<Real, LevelSupport<Real>>;

template <class Real>
bool propose_by_descent(const Placed& a, const Placed& b, Descent<Real>& search, const Holds& holds, Cost& cost) {
  LevelSupport<Real>& support = search.support;
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

// In doubles, then in twice the precision.
bool propose(const Placed& a, const Placed& b, const Holds& holds, Cost& cost) {
  Descent<double> search(a, b, cost);
  search.begin({});
  if (propose_by_descent(a, b, search, holds, cost) ||
      propose_apart_along_features(search.simplex, search.direction, holds)) {
    return true;
  }
  Descent<DoubleDouble> finer(a, b, cost);
  const Point3& d = search.direction;
  finer.direction = {d.x, d.y, d.z};
  return propose_by_descent(a, b, finer, holds, cost);
}

}  // namespace

PairAnswer polyhedron_polyhedron_by_hierarchy(const ConvexPolyhedron& body_a, const Pose& pose_a,  //
                                              const ConvexPolyhedron& body_b, const Pose& pose_b) {
  const Placed a(body_a, pose_a), b(body_b, pose_b);
  return answer_by(a, b, [&](const Holds& holds, Cost& cost) {
    const auto propose_of = [&](const Placed& p, const Placed& q, const Holds& of) { return propose(p, q, of, cost); };
    return propose_axis_scaled_where_wanted(a, b, holds, propose_of);
  });
}

}  // namespace sunder::solid
