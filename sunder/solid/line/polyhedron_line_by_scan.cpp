// The body as the common part of closed half-spaces, each of which cuts off a part of the line: slow and obvious.
#include <sunder/number/exact_vector.h>
#include <sunder/predicate/coordinates.h>
#include <sunder/solid/line/polyhedron_line.h>
#include <sunder/solid/line/polyhedron_ray.h>
#include <sunder/solid/line/polyhedron_segment.h>

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

namespace sunder::solid {

namespace {

using Exact = Vector3<Dyadic>;

// normal.(x - on) <= 0
struct HalfSpace {
  Exact normal, on;
};

class Scan {
 public:
  Scan(const ConvexPolyhedron& body, const Pose& pose, const Point3& a, const Point3& b)
      : body_(body),
        is_point_(a == b),
        a_(coordinates<Dyadic>(a)),
        way_(is_point_ ? Exact{1.0, 0.0, 0.0} : coordinates<Dyadic>(b) - a_) {
    for (const Point3& p : body.vertices()) {
      vertices_.push_back(coordinates<Dyadic>(Posed3{p, &pose.affine(), false}));
      sum_ = vertices_.size() == 1 ? vertices_[0] : sum(sum_, vertices_.back());
    }
    add_half_spaces();
  }

  PolyhedronCut cut(OwnEnds ends) const {
    PolyhedronCut answer{evidence(ends), DecidedBy::scan, {}};
    answer.cost.probes = vertices_.size();
    return answer;
  }

 private:
  PolyhedronCut::Evidence evidence(OwnEnds ends) const {
    std::optional<ExactFraction> low, high;
    LineFacets of_line;
    for (std::uint32_t k = 0; k < half_spaces_.size(); ++k) {
      const HalfSpace& half = half_spaces_[k];
      Dyadic along = dot(half.normal, way_), reach = dot(half.normal, half.on - a_);
      switch (along.sign()) {
        case Sign::zero:
          if (reach.sign() == Sign::negative) return CutParting{};
          break;
        case Sign::positive: {
          ExactFraction t{std::move(reach), std::move(along)};
          if (high && t >= *high) break;
          high = std::move(t);
          of_line.leaves = k;
          break;
        }
        case Sign::negative: {
          ExactFraction t{-reach, -along};
          if (low && t <= *low) break;
          low = std::move(t);
          of_line.enters = k;
          break;
        }
      }
    }
    const ExactFraction at_a, at_b{Dyadic(1.0)}, end = is_point_ ? at_a : at_b;
    if (ends.a && *low < at_a) low = at_a;
    if (ends.b && *high > end) high = end;
    if (*high < *low) return CutParting{};
    const auto end_at = [&](const ExactFraction& t) {
      const OwnEnd own = ends.a && t == at_a ? OwnEnd::a : ends.b && t == at_b ? OwnEnd::b : OwnEnd::none;
      return CutEnd{feature_at(t), own};
    };
    // Of a body with an inside, each half-space is a facet's.
    const std::optional<LineFacets> facets = body_.dimension() == 3 ? std::optional(of_line) : std::nullopt;
    if (*low == *high) return CutPoint{end_at(*low), facets};
    const CutFeature between = feature_at(middle(*low, *high));
    if (between.place == CutPlace::inside) return CutAcross{end_at(*low), end_at(*high), of_line};
    return CutAlong{end_at(*low), end_at(*high), between, facets};
  }

  // With the body on the side where its middle is, or on both sides.
  void add(Exact normal, const Exact& on) {
    const Sign side = dot(normal, sum_ - times(static_cast<double>(vertices_.size()), on)).sign();
    if (side != Sign::positive) half_spaces_.push_back({normal, on});
    if (side != Sign::negative) half_spaces_.push_back({{-normal.x, -normal.y, -normal.z}, on});
  }

  void add_half_spaces() {
    const Exact& v = vertices_[0];
    const Exact axes[3] = {{1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, 1.0}};
    switch (body_.dimension()) {
      case 0:
        for (const Exact& axis : axes) add(axis, v);
        break;
      case 1: {
        const Exact edge = vertices_[1] - v;
        add(edge, v);
        add(edge, vertices_[1]);
        for (const Exact& axis : axes) add(cross(edge, axis), v);  // two of them span all that is perpendicular
        break;
      }
      case 2: add_edges(); [[fallthrough]];
      default:
        for (std::uint32_t f = 0; f < body_.facet_count(); ++f) add(normal(f), vertices_[body_.facet(f)[0]]);
    }
  }

  void add_edges() {
    const std::span<const std::uint32_t> cycle = body_.facet(0);
    for (std::size_t k = 0; k < cycle.size(); ++k) {
      const Exact& from = vertices_[cycle[k]];
      add(cross(vertices_[cycle[k + 1 < cycle.size() ? k + 1 : 0]] - from, normal(0)), from);
    }
  }

  Exact normal(std::uint32_t f) const {
    const std::span<const std::uint32_t> cycle = body_.facet(f);
    const Exact& v = vertices_[cycle[0]];
    return cross(vertices_[cycle[1]] - v, vertices_[cycle[2]] - v);
  }

  // Of a point of the body.
  CutFeature feature_at(const ExactFraction& t) const {
    const Exact point = sum(times(t.denominator, a_), times(t.numerator, way_));  // times the denominator
    const auto from = [&](std::uint32_t v) { return point - times(t.denominator, vertices_[v]); };
    for (std::uint32_t v = 0; v < vertices_.size(); ++v) {
      if (is_zero(from(v))) return {CutPlace::vertex, v, 0};
    }
    std::optional<std::uint32_t> facet;
    int count = 0;
    for (std::uint32_t f = 0; f < body_.facet_count(); ++f) {
      if (dot(normal(f), from(body_.facet(f)[0])).sign() != Sign::zero) continue;
      if (!facet) facet = f;
      ++count;
    }
    if (body_.dimension() == 3 && count == 0) return {CutPlace::inside, 0, 0};
    if (body_.dimension() == 3 && count == 1) return {CutPlace::facet, *facet, 0};
    for (std::uint32_t v = 0; v < vertices_.size(); ++v) {
      for (const std::uint32_t w : body_.neighbours(v)) {
        if (w < v) continue;
        const Exact edge = vertices_[w] - vertices_[v];
        if (!is_zero(cross(edge, from(v)))) continue;
        if (dot(edge, from(v)).sign() == Sign::positive && dot(edge, from(w)).sign() == Sign::negative) {
          return {CutPlace::edge, v, w};
        }
      }
    }
    return {CutPlace::facet, 0, 0};
  }

  const ConvexPolyhedron& body_;
  bool is_point_;  // then the way is any
  Exact a_, way_, sum_;
  std::vector<Exact> vertices_;
  std::vector<HalfSpace> half_spaces_;
};

}  // namespace

PolyhedronCut polyhedron_line_by_scan(const ConvexPolyhedron& body, const Pose& pose, const Line& line) {
  return Scan(body, pose, line.a, line.b).cut({});
}

PolyhedronCut polyhedron_ray_by_scan(const ConvexPolyhedron& body, const Pose& pose, const Ray& ray) {
  return Scan(body, pose, ray.a, ray.b).cut({.a = true, .b = false});
}

PolyhedronCut polyhedron_segment_by_scan(const ConvexPolyhedron& body, const Pose& pose, const Segment& segment) {
  return Scan(body, pose, segment.a, segment.b).cut({.a = true, .b = true});
}

}  // namespace sunder::solid
