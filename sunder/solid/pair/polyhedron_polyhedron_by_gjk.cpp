// The search that proposes. See docs/design/solid-pair.md.
#include <sunder/solid/pair/gjk_search.h>
#include <sunder/solid/pair/polyhedron_polyhedron.h>
#include <sunder/solid/pair/polyhedron_polyhedron_answer.h>
#include <sunder/solid/pair/simplex_proposals.h>
#include <sunder/solid/pair/support.h>

#include <type_traits>
#include <utility>

namespace sunder::solid {

namespace {

// The vertices are those of walks over the vertex graphs.
template <class Real>
class Search : public GjkSearch<Real> {
 public:
  using Vector = VectorOf<Real>;
  using Vertex = DifferenceVertexOf<Real>;

  Search(const Placed& a, const Placed& b)
      : GjkSearch<Real>(a, b), ranks_(a.graph.is_slow || b.graph.is_slow ? top_ranks : Hierarchy::none) {}

  // The two vertices furthest towards each other along `direction`, and their difference.
  Vertex probe(Cost& cost) const {
    const Placed &a = this->a_, &b = this->b_;
    const Vector e = a.pulled(this->direction), f = negated(b.pulled(this->direction));
    const Point3 g = rounded(e), h = rounded(f);
    const std::uint32_t start_a = search_start(a.graph, g), start_b = search_start(b.graph, h);
    std::uint32_t in_a = support(a.body, g, start_a, cost), in_b = support(b.body, h, start_b, cost);
    if constexpr (!std::is_same_v<Real, double>) {
      in_a = support_in_double_doubles(a.body, e, in_a, cost.probes);
      in_b = support_in_double_doubles(b.body, f, in_b, cost.probes);
    }
    return this->difference_of(in_a, in_b);
  }

  // Where walks go down hierarchies, the search begins with the vertices at their top, which stay in the memory caches.
  // True where that goes on: from now on it is about the whole bodies.
  bool refine() { return std::exchange(ranks_, Hierarchy::none) != Hierarchy::none; }

 private:
  std::uint32_t support(const ConvexPolyhedron& body, const Point3& along, std::uint32_t start, Cost& cost) const {
    return body.search_graph().is_slow ? support_by_hierarchy<double>(body, along, cost.probes, ranks_)
                                       : support_from(body, along, start, cost.probes);
  }

  static constexpr std::uint32_t top_ranks = 1024;

  std::uint32_t ranks_;
};

// In doubles, with directions in doubles for bodies that are apart.
template <class Holds>
bool propose_in_doubles(const Placed& a, const Placed& b, Search<double>& search, const Holds& holds, Cost& cost) {
  search.direction = search.first_direction();
  for (int i = 0; i < most_iterations; ++i) {
    ++cost.iterations;
    const DifferenceVertex w = search.probe(cost);
    if (dot(search.direction, w.at) < 0) {
      if (search.refine()) continue;
      DifferenceVertex furthest = w;
      Point3 direction = search.direction;
      if (settle(search.simplex, direction, furthest) && holds(apart_along(direction, furthest.a, furthest.b))) {
        return true;
      }
    }
    if (!search.gains_by(w)) {
      if (search.refine()) continue;
      break;
    }
    if (!search.step_to(w)) break;
  }
  return propose_meet(a, b, search.simplex, holds) ||
         propose_apart_along_features(search.simplex, search.direction, holds);
}

// The same search in twice the precision, for gaps and depths in the last bits; with directions perpendicular to the
// simplex for bodies that are apart.
template <class Holds>
bool propose_in_double_doubles(const Placed& a, const Placed& b, const Point3& direction, const Holds& holds,
                               Cost& cost) {
  Search<DoubleDouble> search(a, b);
  search.refine();
  search.direction = {direction.x, direction.y, direction.z};
  for (int i = 0; i < most_iterations; ++i) {
    ++cost.iterations;
    const DifferenceVertexOf<DoubleDouble> w = search.probe(cost);
    if (dot(search.direction, w.at) < 0 && propose_apart_along_perpendicular(search.simplex, w.a, w.b, holds)) {
      return true;
    }
    if (!search.gains_by(w) || !search.step_to(w)) break;
  }
  return propose_meet(a, b, search.simplex, holds);
}

template <class Holds>
bool propose(const Placed& a, const Placed& b, const Holds& holds, Cost& cost) {
  Search<double> search(a, b);
  return propose_in_doubles(a, b, search, holds, cost) ||
         propose_in_double_doubles(a, b, search.direction, holds, cost);
}

}  // namespace

PairAnswer polyhedron_polyhedron_by_gjk(const ConvexPolyhedron& body_a, const Pose& pose_a,  //
                                        const ConvexPolyhedron& body_b, const Pose& pose_b) {
  const Placed a(body_a, pose_a), b(body_b, pose_b);
  return answer_by(a, b, [&](const auto& holds, Cost& cost) {
    const auto propose_of = [&](const Placed& p, const Placed& q, const auto& of) { return propose(p, q, of, cost); };
    const Stretched stretched(a, b);
    return stretched.is_wanted() ? stretched.propose(a, b, holds, propose_of) : propose(a, b, holds, cost);
  });
}

}  // namespace sunder::solid
