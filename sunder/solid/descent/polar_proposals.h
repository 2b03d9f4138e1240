// What the walk between two spaces (polar_walk.h) ends with, as proposals.
#pragma once

#include <sunder/predicate/point/along.h>
#include <sunder/solid/descent/polar_walk.h>
#include <sunder/solid/pair/polyhedron_polyhedron_answer.h>
#include <sunder/solid/search/axis_scaled.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <type_traits>

namespace sunder::solid {

// Whose polar is used: that of the larger body, which sees the other, if it is tiny, as a point; the other way round
// nothing would be left of the origin's surroundings. Of a flat body there is none.
enum class PolarOf : std::uint8_t { a, b };

inline double length_of(const Placed& body) {
  const Point3 &low = body.graph.low, &high = body.graph.high;
  const double half = std::max({high.x / 2 - low.x / 2, high.y / 2 - low.y / 2, high.z / 2 - low.z / 2});
  double greatest = 0;
  for (const double m : body.pose.linear) greatest = std::max(greatest, std::fabs(m));
  return greatest * half;
}
inline PolarOf polar_of(const Placed& a, const Placed& b) {
  if (a.body.dimension() != b.body.dimension()) return a.body.dimension() == 3 ? PolarOf::a : PolarOf::b;
  return length_of(a) > length_of(b) ? PolarOf::a : PolarOf::b;
}

template <class Real, class Trees>
bool propose_in(const Placed& a, const Placed& b, const Holds& holds, Cost& cost) {
  using End = typename PolarWalk<Real, Trees>::End;
  const bool of_b = polar_of(a, b) == PolarOf::b;
  const Placed &p = of_b ? a : b, &r = of_b ? b : a;
  PolarWalk<Real, Trees> walk(p, r, cost, nullptr);
  switch (walk.run()) {
    case End::apart: {
      const VectorOf<Real> towards_r = walk.direction();
      const std::uint32_t of_p = walk.vertex_of_p(),
                          of_r = support(r.body, rounded(r.pulled(negated(towards_r))), cost.probes);
      const VectorOf<Real> direction = of_b ? towards_r : negated(towards_r);
      Proposal proposal = apart_along(rounded(direction), of_b ? of_p : of_r, of_b ? of_r : of_p);
      if constexpr (std::is_same_v<Real, double>) {
        return make_tame(proposal.direction) && holds(proposal);
      } else {
        proposal.claim = Proposal::Claim::apart_along_sum;
        proposal.rest = {direction.x.low, direction.y.low, direction.z.low};
        return holds(proposal);
      }
    }
    case End::meet: {
      const Mixture<Real> of_p = walk.of_p(), of_r = walk.of_r();
      for (const bool drop_negligible : {!walk.is_clear(), walk.is_clear()}) {
        Proposal proposal;
        proposal.near_a = (of_b ? of_p : of_r).vertex[0];
        proposal.near_b = (of_b ? of_r : of_p).vertex[0];
        if (name_at_most_five(a, b, of_b ? of_p : of_r, of_b ? of_r : of_p, drop_negligible, proposal) &&
            holds(proposal)) {
          return true;
        }
      }
      return false;
    }
    case End::none: break;
  }
  return false;
}

// In doubles, then in twice the precision. Requires that one of the bodies is not flat.
template <class Trees>
PairAnswer polyhedron_polyhedron_by_trees(const Placed& a, const Placed& b) {
  return answer_by(a, b, [&](const Holds& holds, Cost& cost) {
    const auto propose_of = [&](const Placed& p, const Placed& q, const Holds& of) {
      return propose_in<double, Trees>(p, q, of, cost) || propose_in<DoubleDouble, Trees>(p, q, of, cost);
    };
    return propose_axis_scaled_where_wanted(a, b, holds, propose_of);
  });
}

}  // namespace sunder::solid
