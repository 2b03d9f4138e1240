// Search, propose, check; finish exactly where the check fails. See docs/design/solid-pair.md.
#include <sunder/predicate/common_point.h>
#include <sunder/solid/object/search_graph_walk.h>
#include <sunder/solid/pair/closest_simplex.h>
#include <sunder/solid/pair/evidence.h>
#include <sunder/solid/pair/exact_simplex.h>
#include <sunder/solid/pair/extreme_vertex.h>
#include <sunder/solid/pair/polyhedron_polyhedron.h>

#include <cmath>

namespace sunder::solid {

namespace {

double dot(const Point3& a, const Point3& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }

// The transposed linear part times d: the direction as the body's own frame sees it.
Point3 pulled(const Affine3& pose, const Point3& d) {
  const auto& m = pose.linear;
  return {m[0] * d.x + m[3] * d.y + m[6] * d.z, m[1] * d.x + m[4] * d.y + m[7] * d.z,
          m[2] * d.x + m[5] * d.y + m[8] * d.z};
}

// Scales the direction so that its largest component has size about 1, and drops components that are negligible then;
// so it is tame (predicate/along.h). Returns false for zero and for what is not finite.
bool normalize(Point3& d) {
  const double largest = std::max(std::fabs(d.x), std::max(std::fabs(d.y), std::fabs(d.z)));
  if (!(largest > 0 && largest <= std::numeric_limits<double>::max())) return false;
  const auto component = [&](double x) {
    const double part = x / largest;
    return std::fabs(part) < 0x1p-60 ? 0.0 : part;
  };
  d = {component(d.x), component(d.y), component(d.z)};
  return true;
}

// The search: the state of Gilbert, Johnson and Keerthi's method on two placed bodies.
class Search {
 public:
  Search(const Placed& a, const Placed& b) : a_(a), b_(b) {
    const auto& s = a.pose.translation;
    const auto& t = b.pose.translation;
    const double scale = simplex.scale = scale_of(std::max(a.size, b.size));
    shift_ = {(t[0] - s[0]) * scale, (t[1] - s[1]) * scale, (t[2] - s[2]) * scale};
    const Point3 p = a.turned(a.graph.middle, scale), q = b.turned(b.graph.middle, scale);
    direction = {(q.x - p.x) + shift_.x, (q.y - p.y) + shift_.y, (q.z - p.z) + shift_.z};
    if (!(dot(direction, direction) > 0)) direction = {1, 0, 0};
  }

  // The two vertices furthest towards each other along `direction`, and their difference.
  DifferenceVertex probe(Cost& cost) const {
    DifferenceVertex w;
    const Point3 e = pulled(a_.pose, direction), f = pulled(b_.pose, direction);
    const Point3 g{-f.x, -f.y, -f.z};
    const std::uint32_t start_a = search_start(a_.graph, e), start_b = search_start(b_.graph, g);
    w.a = furthest_from(a_.graph, e, start_a, cost.probes);
    w.b = furthest_from(b_.graph, g, start_b, cost.probes);
    const Point3 p = a_.turned(w.a, simplex.scale), q = b_.turned(w.b, simplex.scale);
    w.at = {(p.x - q.x) - shift_.x, (p.y - q.y) - shift_.y, (p.z - q.z) - shift_.z};
    return w;
  }

  // Is w further along the direction than the face, by more than the noise of floating point?
  bool gains_by(const DifferenceVertex& w) const {
    if (simplex.count == 0) return true;
    bool is_there = false;  // without branches: how many vertices there are is hard to predict
    for (int i = 0; i < 4; ++i) {
      const DifferenceVertex& v = simplex.vertex[static_cast<std::size_t>(i)];
      is_there |= (i < simplex.count) & (v.a == w.a) & (v.b == w.b);
    }
    if (is_there) return false;
    const Point3& v = simplex.vertex[0].at;
    const Point3& d = direction;
    const double gain = dot(d, {w.at.x - v.x, w.at.y - v.y, w.at.z - v.z});
    return gain > 0x1p-44 * (std::fabs(d.x * w.at.x) + std::fabs(d.y * w.at.y) + std::fabs(d.z * w.at.z));
  }

  // The square of the distance from which on no direction is worth going: for a vertex, the noise of floating point.
  double noise2() const {
    if (simplex.count != 1) return 0;
    const Point3 p = a_.turned(simplex.vertex[0].a, simplex.scale), q = b_.turned(simplex.vertex[0].b, simplex.scale);
    return 0x1p-92 * (dot(p, p) + dot(q, q));
  }

  // The direction as a certificate can hold it: tame, and with one vertex of the difference clearly furthest.
  //
  // Near contact the direction is perpendicular to a face of the difference, whose vertices then tie. So it is turned a
  // little towards one of them, at the cost of at most a quarter of the gap, and floating point can tell the extreme
  // vertices. `w` is what the direction found; it becomes the vertex that is now furthest. Returns false for a
  // direction that is zero or not finite.
  bool settle(Point3& d, DifferenceVertex& w) const {
    d = direction;
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

  Point3 direction;           // of the world, from A towards B
  DifferenceSimplex simplex;  // the face nearest to the origin, or the tetrahedron around it

 private:
  // A power of two that brings differences of images near 1 where sixth powers of them could overflow or vanish, as
  // they occur in closest_simplex.cpp; else 1.
  static double scale_of(double size) {
    if (size >= 0x1p-100 && size <= 0x1p100) return 1;
    if (!(size > 0 && size <= std::numeric_limits<double>::max())) return 1;
    return std::ldexp(1.0, std::clamp(-std::ilogb(size), -1022, 1022));
  }

  const Placed& a_;
  const Placed& b_;
  Point3 shift_;
};

constexpr int most_iterations = 100;

}  // namespace

PairAnswer polyhedron_polyhedron_by_gjk(const ConvexPolyhedron& body_a, const Pose& pose_a,  //
                                        const ConvexPolyhedron& body_b, const Pose& pose_b) {
  const Placed a(body_a, pose_a), b(body_b, pose_b);
  PairAnswer answer;
  StageTally tally;
  Search search(a, b);

  bool decided = false;
  bool enclosed = false;
  for (int i = 0; i < most_iterations && !decided && !enclosed; ++i) {
    ++answer.cost.iterations;
    const DifferenceVertex w = search.probe(answer.cost);
    if (dot(search.direction, w.at) < 0) {
      DifferenceVertex furthest = w;
      Point3 direction;
      decided = search.settle(direction, furthest) &&
                check_apart(a, b, direction, furthest.a, furthest.b, answer.evidence, tally);
      if (decided) break;
    }
    if (!search.gains_by(w)) break;
    search.simplex.vertex[static_cast<std::size_t>(search.simplex.count++)] = w;
    double distance2 = 0;
    enclosed = !reduce_to_closest_face(search.simplex, search.direction, distance2);
    if (!enclosed && !(distance2 > search.noise2())) break;
  }

  if (!decided) decided = check_meet(a, b, search.simplex, answer.evidence, tally);
  if (!decided) decided = check_apart_by_features(a, b, search.simplex, search.direction, answer.evidence, tally);
  answer.decided_by = tally.exact == 0 ? DecidedBy::filter : DecidedBy::evidence;
  if (!decided) {
    answer.evidence = decide_by_exact_simplex(a, b, search.simplex, tally);
    answer.decided_by = DecidedBy::finishing;
  }
  answer.cost.exact = tally.exact;
  return answer;
}

}  // namespace sunder::solid
