// The closest points of two polyhedra, kept while going down their hierarchies.
//
// The direction between the closest points of two levels supports both there. Below, at most one vertex of each level
// lies beyond either plane (BL15 Lemma 4.2), a new one, which the walks down both hierarchies find where they stand; it
// joins the simplex that holds the closest points. So the simplex is the same on most levels, and where it is not, some
// steps of Gilbert, Johnson and Keerthi's method find the next: each turns the direction, and begins the walks anew.
// Where the origin is in the simplex, levels meet, and so do the polyhedra.
//
// Departure: DK90 looks at all neighbours of the extreme vertex, whose degree nothing bounds; the walks here are by
// sectors of its normal cone (hierarchy_walk.h).
#include <sunder/solid/pair/gjk_search.h>
#include <sunder/solid/pair/polyhedron_polyhedron.h>
#include <sunder/solid/pair/polyhedron_polyhedron_answer.h>
#include <sunder/solid/pair/simplex_proposals.h>
#include <sunder/solid/pair/support.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

namespace sunder::solid {

namespace {

// On a level but the last. What it leaves undone is done on the next.
constexpr int most_steps_on_a_level = 8;

// The furthest vertices of the levels of one body. A point and a segment have one level.
template <class Real>
class LevelWalk {
 public:
  using Vector = VectorOf<Real>;

  LevelWalk(const ConvexPolyhedron& body, std::uint64_t& probes) : vertices_(body.vertices()), probes_(probes) {
    if (vertices_.size() < 3) return;
    hierarchy_ = &body.hierarchy();
    compare_.emplace(*hierarchy_, direction_);
    turn_.emplace(*compare_);
    walk_.emplace(*hierarchy_, *compare_, *turn_, probes);
  }
  LevelWalk(const LevelWalk&) = delete;
  LevelWalk& operator=(const LevelWalk&) = delete;

  std::size_t level_count() const { return walk_ ? hierarchy_->level_end.size() : 1; }

  void turn_to(const Vector& direction) {
    direction_ = direction;
    if (walk_) walk_->start();
  }

  // Requires a level not above that of the last call since the direction turned.
  std::uint32_t furthest(std::size_t level) {
    if (walk_) {
      const std::uint32_t end = hierarchy_->level_end[std::min(level, level_count() - 1)];
      return hierarchy_->nodes[walk_->go_on(end)].vertex;
    }
    probes_ += vertices_.size();
    const Point3 &p = vertices_.front(), &q = vertices_.back();
    const Vector edge{difference<Real>(q.x, p.x), difference<Real>(q.y, p.y), difference<Real>(q.z, p.z)};
    return dot(direction_, edge) > Real(0) ? 1 : 0;
  }

 private:
  using Compare = CompareAlong<Real>;
  using Turn = TurnAlong<Real>;

  std::span<const Point3> vertices_;
  std::uint64_t& probes_;
  const Hierarchy* hierarchy_ = nullptr;
  Vector direction_{};
  std::optional<Compare> compare_;
  std::optional<Turn> turn_;
  std::optional<HierarchyWalk<Compare, Turn>> walk_;
};

template <class Real>
class Descent : public GjkSearch<Real> {
 public:
  using Vector = VectorOf<Real>;
  using Vertex = DifferenceVertexOf<Real>;

  Descent(const Placed& a, const Placed& b, Cost& cost)
      : GjkSearch<Real>(a, b), of_a_(a.body, cost.probes), of_b_(b.body, cost.probes), cost_(cost) {}

  void turn_to(const Vector& towards) {
    this->direction = towards;
    of_a_.turn_to(this->a_.pulled(towards));
    of_b_.turn_to(negated(this->b_.pulled(towards)));
  }

  // True where a proposal held. propose_apart(w): at the bottom, where the direction seems to part the bodies.
  template <class Holds, class ProposeApart>
  bool run(const Holds& holds, const ProposeApart& propose_apart) {
    const std::size_t levels = std::max(of_a_.level_count(), of_b_.level_count());
    bool goes_on = true;
    for (std::size_t level = 0; level < levels && goes_on; ++level) {
      const bool is_last = level + 1 == levels;
      for (int i = is_last ? most_iterations : most_steps_on_a_level; i > 0 && goes_on; --i) {
        ++cost_.iterations;
        const Vertex w = this->difference_of(of_a_.furthest(level), of_b_.furthest(level));
        if (is_last && dot(this->direction, w.at) < Real(0) && propose_apart(w)) return true;
        if (!this->gains_by(w)) break;
        goes_on = this->step_to(w);
        if (goes_on) turn_to(this->direction);
      }
    }
    return propose_meet(this->a_, this->b_, this->simplex, holds);
  }

 private:
  LevelWalk<Real> of_a_, of_b_;
  Cost& cost_;
};

// In doubles, with directions in doubles or the features of the simplex for bodies that are apart; then in twice the
// precision, with directions perpendicular to the simplex.
template <class Holds>
bool propose(const Placed& a, const Placed& b, const Holds& holds, Cost& cost) {
  Descent<double> search(a, b, cost);
  search.turn_to(search.first_direction());
  const auto along_direction = [&](DifferenceVertex w) {
    Point3 direction = search.direction;
    return settle(search.simplex, direction, w) && holds(apart_along(direction, w.a, w.b));
  };
  if (search.run(holds, along_direction) || propose_apart_along_features(search.simplex, search.direction, holds)) {
    return true;
  }
  Descent<DoubleDouble> finer(a, b, cost);
  finer.turn_to({search.direction.x, search.direction.y, search.direction.z});
  return finer.run(holds, [&](const DifferenceVertexOf<DoubleDouble>& w) {
    return propose_apart_along_perpendicular(finer.simplex, w.a, w.b, holds);
  });
}

}  // namespace

PairAnswer polyhedron_polyhedron_by_hierarchy(const ConvexPolyhedron& body_a, const Pose& pose_a,  //
                                              const ConvexPolyhedron& body_b, const Pose& pose_b) {
  const Placed a(body_a, pose_a), b(body_b, pose_b);
  return answer_by(a, b, [&](const auto& holds, Cost& cost) {
    const auto propose_of = [&](const Placed& p, const Placed& q, const auto& of) { return propose(p, q, of, cost); };
    const Stretched stretched(a, b);
    return stretched.is_wanted() ? stretched.propose(a, b, holds, propose_of) : propose(a, b, holds, cost);
  });
}

}  // namespace sunder::solid
