// The support of two placed polyhedra for the search of Gilbert, Johnson and Keerthi (gjk.h), by walks on their search
// graphs.
#pragma once

#include <sunder/solid/search/gjk.h>
#include <sunder/solid/search/placed.h>
#include <sunder/solid/search/support.h>

#include <algorithm>
#include <cstdint>
#include <type_traits>

namespace sunder::solid {

// Its vertices are images of vertices of A less images of vertices of B.
template <class Real>
class GraphSupport {
 public:
  using Vector = VectorOf<Real>;
  using Vertex = DifferenceVertexOf<Real>;

  GraphSupport(const Placed& a, const Placed& b) : scale(scale_to_one(std::max(a.size, b.size))), a_(a), b_(b) {
    const auto& s = a.pose.translation;
    const auto& t = b.pose.translation;
    const auto shift = [&](std::size_t i) -> Real { return difference<Real>(t[i], s[i]) * Real(scale); };
    shift_ = {shift(0), shift(1), shift(2)};
  }

  double scale;

  // Between the middles of the bodies.
  Vector first_direction() const {
    const Vector p = a_.turned<Real>(a_.graph.middle, scale), q = b_.turned<Real>(b_.graph.middle, scale);
    const Vector d{(q.x - p.x) + shift_.x, (q.y - p.y) + shift_.y, (q.z - p.z) + shift_.z};
    return dot(d, d) > Real(0) ? d : Vector{1, 0, 0};
  }

  // The two vertices furthest towards each other, and their difference.
  Vertex furthest(const Vector& direction, const DifferenceSimplexOf<Real>&, Cost& cost) const {
    const Vector e = a_.pulled(direction), f = negated(b_.pulled(direction));
    const Point3 g = rounded(e), h = rounded(f);
    const std::uint32_t start_a = search_start(a_.graph, g), start_b = search_start(b_.graph, h);
    std::uint32_t a = support(a_, g, start_a, cost), b = support(b_, h, start_b, cost);
    if constexpr (!std::is_same_v<Real, double>) {
      a = support_in_double_doubles(a_.body, e, a, cost.probes);
      b = support_in_double_doubles(b_.body, f, b, cost.probes);
    }
    return of_vertices(a, b);
  }

  // The difference of vertex a of A and vertex b of B.
  Vertex of_vertices(std::uint32_t a, std::uint32_t b) const {
    const Vector p = a_.turned<Real>(a, scale), q = b_.turned<Real>(b, scale);
    return {{(p.x - q.x) - shift_.x, (p.y - q.y) - shift_.y, (p.z - q.z) - shift_.z}, a, b};
  }

  // The images of a vertex of A, and of one of B, from which differences are made.
  Vector3<Real> image_of_a(std::uint32_t v) const {
    const Vector p = a_.turned<Real>(v, scale);
    return {p.x, p.y, p.z};
  }
  Vector3<Real> image_of_b(std::uint32_t v) const {
    const Vector q = b_.turned<Real>(v, scale);
    return {q.x + shift_.x, q.y + shift_.y, q.z + shift_.z};
  }

  static bool are_same(const Vertex& v, const Vertex& w) { return (v.a == w.a) & (v.b == w.b); }
  static Real noise(const Vector& d, const Vertex& w) {
    return 4 * relative_noise * (magnitude(d.x * w.at.x) + magnitude(d.y * w.at.y) + magnitude(d.z * w.at.z));
  }
  Real noise2(const Vertex& v) const {
    const Vector p = a_.turned<Real>(v.a, scale), q = b_.turned<Real>(v.b, scale);
    return relative_noise * relative_noise * (dot(p, p) + dot(q, q));
  }

  // Where walks go down hierarchies, vertices are looked for at their top only, which stays in the memory caches, until
  // refine().
  void begin_at_the_top() {
    if (a_.graph.is_slow || b_.graph.is_slow) ranks_ = top_ranks;
  }
  bool is_coarse() const { return ranks_ != Hierarchy::none; }
  void refine() { ranks_ = Hierarchy::none; }

 private:
  // What rounding leaves of a difference of two images, as part of their size: some roundings.
  static constexpr double relative_noise = std::is_same_v<Real, double> ? 0x1p-46 : 0x1p-98;
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

template <class Real>
using GjkSearch = Gjk<Real, GraphSupport<Real>>;

}  // namespace sunder::solid
