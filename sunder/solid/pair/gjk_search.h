// The search of Gilbert, Johnson and Keerthi on two placed bodies, in double or in double-double precision: one vertex
// of their difference after another, each further towards the origin. What it leaves is for proposals; nothing here
// decides anything.
// Source: Gilbert, Johnson, Keerthi 1988.
#pragma once

#include <sunder/base/cost.h>
#include <sunder/solid/pair/closest_features.h>
#include <sunder/solid/pair/closest_simplex.h>
#include <sunder/solid/pair/placed.h>
#include <sunder/solid/pair/support.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <type_traits>
#include <utility>

namespace sunder::solid {

// The state of Gilbert, Johnson and Keerthi's method on two placed bodies.
template <class Real>
class GjkSearch {
 public:
  using Vector = VectorOf<Real>;
  using Vertex = DifferenceVertexOf<Real>;

  GjkSearch(const Placed& a, const Placed& b) : a_(a), b_(b) {
    const auto& s = a.pose.translation;
    const auto& t = b.pose.translation;
    const double scale = simplex.scale = scale_to_one(std::max(a.size, b.size));
    const auto shift = [&](std::size_t i) -> Real { return difference<Real>(t[i], s[i]) * Real(scale); };
    shift_ = {shift(0), shift(1), shift(2)};
  }

  // Between the middles of the bodies.
  Vector first_direction() const {
    const Vector p = a_.turned<Real>(a_.graph.middle, simplex.scale),
                 q = b_.turned<Real>(b_.graph.middle, simplex.scale);
    const Vector d{(q.x - p.x) + shift_.x, (q.y - p.y) + shift_.y, (q.z - p.z) + shift_.z};
    return dot(d, d) > 0 ? d : Vector{1, 0, 0};
  }

  // The two vertices furthest towards each other along `direction`, and their difference.
  Vertex probe(Cost& cost) const {
    Vertex w;
    const Vector e = a_.pulled(direction), f = negated(b_.pulled(direction));
    const Point3 g = rounded(e), h = rounded(f);
    const std::uint32_t start_a = search_start(a_.graph, g), start_b = search_start(b_.graph, h);
    w.a = support(a_, g, start_a, cost);
    w.b = support(b_, h, start_b, cost);
    if constexpr (!std::is_same_v<Real, double>) {
      w.a = support_in_double_doubles(a_.body, e, w.a, cost.probes);
      w.b = support_in_double_doubles(b_.body, f, w.b, cost.probes);
    }
    return of_vertices(w.a, w.b);
  }

  // The difference of vertex a of A and vertex b of B.
  Vertex of_vertices(std::uint32_t a, std::uint32_t b) const {
    const Vector p = a_.turned<Real>(a, simplex.scale), q = b_.turned<Real>(b, simplex.scale);
    return {{(p.x - q.x) - shift_.x, (p.y - q.y) - shift_.y, (p.z - q.z) - shift_.z}, a, b};
  }

  // The vertices of A in the simplex, and those of B, each once, with images from which differences are made. Requires
  // a vertex.
  VertexSet<Real> vertices_of_a() const {
    VertexSet<Real> set;
    for (std::size_t i = 0; i < static_cast<std::size_t>(simplex.count); ++i) {
      const std::uint32_t v = simplex.vertex[i].a;
      if (set.has(v)) continue;
      const Vector p = a_.turned<Real>(v, simplex.scale);
      set.add(v, {p.x, p.y, p.z});
    }
    return set;
  }
  VertexSet<Real> vertices_of_b() const {
    VertexSet<Real> set;
    for (std::size_t i = 0; i < static_cast<std::size_t>(simplex.count); ++i) {
      const std::uint32_t v = simplex.vertex[i].b;
      if (set.has(v)) continue;
      const Vector q = b_.turned<Real>(v, simplex.scale);
      set.add(v, {q.x + shift_.x, q.y + shift_.y, q.z + shift_.z});
    }
    return set;
  }

  // Where walks go down hierarchies, vertices are looked for at their top only, which stays in the memory caches, until
  // refine(). True where that changes anything: from then on the search is about the whole bodies.
  void begin_at_the_top() {
    if (a_.graph.is_slow || b_.graph.is_slow) ranks_ = top_ranks;
  }
  bool refine() { return std::exchange(ranks_, Hierarchy::none) != Hierarchy::none; }

  // Is w further along the direction than the face, by more than the noise of floating point?
  bool gains_by(const Vertex& w) const {
    if (simplex.count == 0) return true;
    bool is_there = false;  // without branches: how many vertices there are is hard to predict
    for (int i = 0; i < 4; ++i) {
      const Vertex& v = simplex.vertex[static_cast<std::size_t>(i)];
      is_there |= (i < simplex.count) & (v.a == w.a) & (v.b == w.b);
    }
    if (is_there) return false;
    const Vector& d = direction;
    const Real gain = dot(d, minus(w.at, simplex.vertex[0].at));
    return gain > 4 * noise * (magnitude(d.x * w.at.x) + magnitude(d.y * w.at.y) + magnitude(d.z * w.at.z));
  }

  // One step: w joins the simplex, which becomes its face nearest to the origin. False where that is no use: the origin
  // is inside, or as near as floating point can tell.
  bool step_to(const Vertex& w) {
    simplex.vertex[static_cast<std::size_t>(simplex.count++)] = w;
    if (!reduce_to_closest_face(simplex, direction, distance2)) return false;
    if (simplex.count != 1) return distance2 > 0;
    const Vector p = a_.turned<Real>(simplex.vertex[0].a, simplex.scale),
                 q = b_.turned<Real>(simplex.vertex[0].b, simplex.scale);
    return distance2 > noise * noise * (dot(p, p) + dot(q, q));
  }

  // What rounding leaves of a difference of two images, as part of their size: some roundings.
  static constexpr double noise = std::is_same_v<Real, double> ? 0x1p-46 : 0x1p-98;
  static constexpr int most_iterations = 100;

  Vector direction;                   // of the world, from A towards B
  DifferenceSimplexOf<Real> simplex;  // the face nearest to the origin, or the tetrahedron around it
  Real distance2 = 0;                 // of that face, squared, after a step

 private:
  static constexpr std::uint32_t top_ranks = 1024;

  std::uint32_t support(const Placed& of, const Point3& along, std::uint32_t start, Cost& cost) const {
    return of.graph.is_slow ? support_by_hierarchy<double>(of.body, along, cost.probes, ranks_)
                            : support_from(of.body, of.graph, along, start, cost.probes);
  }

  const Placed& a_;
  const Placed& b_;
  Vector shift_;
  std::uint32_t ranks_ = Hierarchy::none;
};

// Each step should come nearer; where several in a row do not, floating point goes in circles.
template <class Real>
class Nearing {
 public:
  bool goes_on(const Real& distance2) {
    if (distance2 < nearest_) {
      nearest_ = distance2;
      in_vain_ = 0;
      return true;
    }
    return ++in_vain_ < most_in_vain;
  }

 private:
  static constexpr int most_in_vain = 4;
  Real nearest_ = std::numeric_limits<double>::infinity();
  int in_vain_ = 0;
};

}  // namespace sunder::solid
