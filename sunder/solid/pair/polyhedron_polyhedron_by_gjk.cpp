// The search that proposes. See docs/design/solid-pair.md.
#include <sunder/solid/pair/gjk_search.h>
#include <sunder/solid/pair/polyhedron_polyhedron.h>
#include <sunder/solid/pair/polyhedron_polyhedron_answer.h>
#include <sunder/solid/pair/simplex_proposals.h>

#include <cmath>

namespace sunder::solid {

namespace {

// Scales the direction so that its largest component has size about 1, and drops components that are negligible then;
// so it is tame (predicate/along.h). Returns false for zero and for what is not finite.
bool normalize(Point3& d) {
  const double largest = std::max(std::fabs(d.x), std::max(std::fabs(d.y), std::fabs(d.z)));
  if (!(largest > 0) || !std::isfinite(d.x) || !std::isfinite(d.y) || !std::isfinite(d.z)) return false;
  const auto component = [&](double x) {
    const double part = x / largest;
    return std::fabs(part) < 0x1p-60 ? 0.0 : part;
  };
  d = {component(d.x), component(d.y), component(d.z)};
  return true;
}

// The direction as a certificate can hold it: tame, and with one vertex of the difference clearly furthest.
//
// Near contact the direction is perpendicular to a face of the difference, whose vertices then tie. So it is turned a
// little towards one of them, at the cost of at most a quarter of the gap, and floating point can tell the extreme
// vertices. `w` is what the direction found; it becomes the vertex that is now furthest. Returns false for a direction
// that is zero or not finite.
bool settle(const DifferenceSimplex& simplex, Point3& d, DifferenceVertex& w) {
  if (!normalize(d)) return false;
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
  return normalize(d);
}

// In doubles, with directions in doubles for bodies that are apart.
template <class Holds>
bool propose_in_doubles(const Placed& a, const Placed& b, GjkSearch<double>& search, const Holds& holds, Cost& cost) {
  search.direction = search.first_direction();
  for (int i = 0; i < search.most_iterations; ++i) {
    ++cost.iterations;
    const DifferenceVertex w = search.probe(cost);
    if (dot(search.direction, w.at) < 0) {
      DifferenceVertex furthest = w;
      Point3 direction = search.direction;
      if (settle(search.simplex, direction, furthest) && holds(apart_along(direction, furthest.a, furthest.b))) {
        return true;
      }
    }
    if (!search.gains_by(w) || !search.step_to(w)) break;
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

}  // namespace

PairAnswer polyhedron_polyhedron_by_gjk(const ConvexPolyhedron& body_a, const Pose& pose_a,  //
                                        const ConvexPolyhedron& body_b, const Pose& pose_b) {
  const Placed a(body_a, pose_a), b(body_b, pose_b);
  return answer_by(a, b, [&](const auto& holds, Cost& cost) {
    GjkSearch<double> search(a, b);
    return propose_in_doubles(a, b, search, holds, cost) ||
           propose_in_double_doubles(a, b, search.direction, holds, cost);
  });
}

}  // namespace sunder::solid
