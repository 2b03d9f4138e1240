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

Sign order(const ExactFraction& s, const ExactFraction& t) {
  return (s.numerator * t.denominator - t.numerator * s.denominator).sign();
}
bool equals(const ExactFraction& t, double x) { return order(t, {Dyadic(x)}) == Sign::zero; }

class Scan {
 public:
  Scan(const ConvexPolyhedron& body, const Pose& pose, const Point3& a, const Point3& b)
      : body_(body), a_(coordinates<Dyadic>(a)), way_(coordinates<Dyadic>(b) - a_) {
    for (const Point3& p : body.vertices()) {
      vertices_.push_back(coordinates<Dyadic>(Posed3{p, &pose.affine(), false}));
      sum_ = vertices_.size() == 1 ? vertices_[0] : sum(sum_, vertices_.back());
    }
    add_half_spaces();
  }

  PolyhedronCut cut(bool ends_a, bool ends_b) {
    PolyhedronCut cut;
    cut.decided_by = DecidedBy::scan;
    cut.cost.probes = vertices_.size();
    std::optional<ExactFraction> low, high;
    if (ends_a) low = ExactFraction{};
    if (ends_b) high = ExactFraction{Dyadic(1.0)};
    if (is_zero(way_)) high = ExactFraction{};
    for (const HalfSpace& half : half_spaces_) {
      Dyadic along = dot(half.normal, way_), reach = dot(half.normal, half.on - a_);
      switch (along.sign()) {
        case Sign::zero:
          if (reach.sign() == Sign::negative) return cut;
          break;
        case Sign::positive: {
          ExactFraction t{std::move(reach), std::move(along)};
          if (!high || order(t, *high) == Sign::negative) high = std::move(t);
          break;
        }
        case Sign::negative: {
          ExactFraction t{-reach, -along};
          if (!low || order(t, *low) == Sign::positive) low = std::move(t);
          break;
        }
      }
    }
    const Sign length = order(*high, *low);
    if (length == Sign::negative) return cut;
    const auto own = [&](const ExactFraction& t) {
      return ends_a && equals(t, 0) ? OwnEnd::a : ends_b && equals(t, 1) ? OwnEnd::b : OwnEnd::none;
    };
    cut.first = {feature_at(*low), own(*low)};
    cut.last = {feature_at(*high), own(*high)};
    if (length == Sign::zero) {
      cut.kind = CutKind::point;
      return cut;
    }
    const ExactFraction middle{low->numerator * high->denominator + high->numerator * low->denominator,
                               (low->denominator * high->denominator).scaled(1)};
    cut.surface = feature_at(middle);
    cut.kind = cut.surface.place == CutPlace::inside ? CutKind::across : CutKind::along;
    if (cut.kind == CutKind::across) cut.surface = {};
    return cut;
  }

 private:
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
  Exact a_, way_, sum_;
  std::vector<Exact> vertices_;
  std::vector<HalfSpace> half_spaces_;
};

}  // namespace

PolyhedronCut polyhedron_line_by_scan(const ConvexPolyhedron& body, const Pose& pose, const Line& line) {
  return Scan(body, pose, line.a, line.b).cut(false, false);
}

PolyhedronCut polyhedron_ray_by_scan(const ConvexPolyhedron& body, const Pose& pose, const Ray& ray) {
  return Scan(body, pose, ray.a, ray.b).cut(true, false);
}

PolyhedronCut polyhedron_segment_by_scan(const ConvexPolyhedron& body, const Pose& pose, const Segment& segment) {
  return Scan(body, pose, segment.a, segment.b).cut(true, true);
}

}  // namespace sunder::solid
