// The search that proposes. See docs/design/solid-pair.md.
#include <sunder/predicate/along.h>
#include <sunder/solid/pair/gjk_search.h>
#include <sunder/solid/pair/polyhedron_polyhedron.h>
#include <sunder/solid/pair/polyhedron_polyhedron_answer.h>
#include <sunder/solid/pair/simplex_proposals.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace sunder::solid {

namespace {

// The direction as a certificate can hold it: tame, and with one vertex of the difference clearly furthest.
//
// Near contact the direction is perpendicular to a face of the difference, whose vertices then tie. So it is turned a
// little towards one of them, at the cost of at most a quarter of the gap, and floating point can tell the extreme
// vertices. `w` is what the direction found; it becomes the vertex that is now furthest. Returns false for a direction
// that is zero or not finite.
bool settle(const DifferenceSimplex& simplex, Point3& d, DifferenceVertex& w) {
  if (!make_tame(d)) return false;
  const std::size_t n = static_cast<std::size_t>(simplex.count);
  if (n < 2) return true;
  Point3 centroid;
  for (std::size_t i = 0; i < n; ++i) {
    const Point3& p = simplex.vertex[i].at;
    centroid = {centroid.x + p.x, centroid.y + p.y, centroid.z + p.z};
  }
  const double part = 1.0 / simplex.count;
  centroid = {centroid.x * part, centroid.y * part, centroid.z * part};
  const auto from_centroid = [&](const Point3& p) {
    return Point3{p.x - centroid.x, p.y - centroid.y, p.z - centroid.z};
  };
  // A vertex clearly beyond the face is furthest anyway.
  const double gap = -dot(d, w.at);
  const Point3 beyond = from_centroid(w.at);
  const double height = dot(d, beyond);
  if (height * height > 0x1p-40 * dot(beyond, beyond)) return true;
  // Else the vertex of the face that is furthest from the centroid.
  Point3 e;
  double length2 = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const Point3 f = from_centroid(simplex.vertex[i].at);
    if (dot(f, f) <= length2) continue;
    length2 = dot(f, f);
    e = f;
    w = simplex.vertex[i];
  }
  const double amount = std::min(0x1p-7 / std::sqrt(length2), 0.25 * gap / std::fabs(dot(e, w.at)));
  d = {d.x + amount * e.x, d.y + amount * e.y, d.z + amount * e.z};
  return make_tame(d);
}

// In doubles, with directions in doubles for bodies that are apart.
template <class Holds>
bool propose_in_doubles(const Placed& a, const Placed& b, GjkSearch<double>& search, const Holds& holds, Cost& cost) {
  search.direction = search.first_direction();
  for (int i = 0; i < search.most_iterations; ++i) {
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
  GjkSearch<DoubleDouble> search(a, b);
  search.direction = {direction.x, direction.y, direction.z};
  for (int i = 0; i < search.most_iterations; ++i) {
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
  GjkSearch<double> search(a, b);
  search.begin_at_the_top();
  return propose_in_doubles(a, b, search, holds, cost) ||
         propose_in_double_doubles(a, b, search.direction, holds, cost);
}

// The axes of the world stretched, each by a power of two, so that two bodies have about the same size along all.
// Needles are searched so; whatever is lost, the exact checks are about the bodies as they are.
class Stretched {
 public:
  Stretched(const Placed& a, const Placed& b) {
    for (std::size_t i = 0; i < 3; ++i) {
      const double size = std::max(size_along(a, i), size_along(b, i));
      if (!(size > 0 && size <= std::numeric_limits<double>::max())) continue;
      size_[i] = size;
      least_ = std::min(least_, size);
      greatest_ = std::max(greatest_, size);
    }
  }

  // Would floating point not see along one axis what there is, for what there is along another?
  bool is_wanted() const { return greatest_ > least_ * 0x1p40; }

  template <class Holds>
  bool propose(const Placed& a, const Placed& b, const Holds& holds, Cost& cost) const {
    std::array<double, 3> by;
    for (std::size_t i = 0; i < 3; ++i) by[i] = std::ldexp(1.0, std::clamp(-std::ilogb(size_[i]), -1020, 1020));
    const auto stretched = [&](Affine3 pose) {
      for (std::size_t i = 0; i < 9; ++i) pose.linear[i] *= by[i / 3];
      for (std::size_t i = 0; i < 3; ++i) pose.translation[i] *= by[i];
      return pose;
    };
    const Affine3 pose_a = stretched(a.pose), pose_b = stretched(b.pose);
    // A direction is a linear form: d . (S x) is (S d) . x. Beside a form n of the world it only tells a sense.
    const auto of_world = [&](Proposal p) {
      Point3& d = p.direction;
      if (p.claim == Proposal::Claim::apart_along) {
        d = {d.x * by[0], d.y * by[1], d.z * by[2]};
      } else {
        d = {d.x / by[0], d.y / by[1], d.z / by[2]};
      }
      return holds(p);
    };
    return solid::propose(Placed(a, pose_a), Placed(b, pose_b), of_world, cost);
  }

 private:
  static double size_along(const Placed& body, std::size_t axis) {
    const Point3 &low = body.graph.low, &high = body.graph.high;
    const auto part = [&](std::size_t j, double from, double to) {
      return std::fabs(body.pose.linear[3 * axis + j]) * std::max(std::fabs(from), std::fabs(to));
    };
    return part(0, low.x, high.x) + part(1, low.y, high.y) + part(2, low.z, high.z);
  }

  std::array<double, 3> size_{1, 1, 1};
  double least_ = std::numeric_limits<double>::infinity(), greatest_ = 0;
};

}  // namespace

PairAnswer polyhedron_polyhedron_by_gjk(const ConvexPolyhedron& body_a, const Pose& pose_a,  //
                                        const ConvexPolyhedron& body_b, const Pose& pose_b) {
  const Placed a(body_a, pose_a), b(body_b, pose_b);
  return answer_by(a, b, [&](const auto& holds, Cost& cost) {
    const Stretched stretched(a, b);
    return stretched.is_wanted() ? stretched.propose(a, b, holds, cost) : propose(a, b, holds, cost);
  });
}

}  // namespace sunder::solid
