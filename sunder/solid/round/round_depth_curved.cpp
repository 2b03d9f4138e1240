// A polytope of differences of points that the bodies hold, exactly, grows where it is nearest to the origin, until
// hardly anything of the difference is beyond it there; of hulls with a radius these are points of the cores, and D is
// the difference of cores. Where the origin is not in D, or hardly, one point of D is as near to it as the radii tell.
#include <sunder/number/root.h>
#include <sunder/predicate/coordinates.h>
#include <sunder/solid/round/round_distance.h>
#include <sunder/solid/round/round_methods.h>
#include <sunder/solid/round/round_nearest.h>
#include <sunder/solid/round/round_placed.h>
#include <sunder/solid/search/expanding_polytope.h>
#include <sunder/solid/search/extreme_vertex.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

namespace sunder::solid {

namespace {

using Exact = Vector3<Dyadic>;
constexpr double unlimited = std::numeric_limits<double>::infinity();

// Of a hull its core.
std::vector<ReachAlong> reaches(const PlacedRound& body, const WorldDirection& direction, End end, Cost& cost) {
  StageTally tally;
  RoundShape shape = shape_along(body, direction, end, 0, cost, tally);
  shape.radius -= body.body.rounding();
  cost.exact += tally.exact;
  const Exact d = direction.exact();
  return reaches_along(end == End::least ? Exact{-d.x, -d.y, -d.z} : d, shape);
}

// How far A reaches along the direction beyond where B begins, over the length of the direction: no further than that.
double reach_at_most(const PlacedRound& a, const PlacedRound& b, const WorldDirection& direction, Cost& cost) {
  const Exact d = direction.exact();
  const Interval length = root({dot(d, d)});
  double most = -unlimited;
  for (const ReachAlong& last : reaches(a, direction, End::greatest, cost)) {
    for (const ReachAlong& first : reaches(b, direction, End::least, cost)) {
      const Interval roots = root(last.square) + root(first.square);
      most = std::max(most, (((last.q + first.q).enclosure() + roots) / length).high);
    }
  }
  return most;
}

class CurvedDepth {
 public:
  CurvedDepth(const PlacedRound& a, const PlacedRound& b, Cost& cost)
      : a_(a),
        b_(b),
        cost_(cost),
        search_(a, b),
        scale_(search_.simplex.scale),
        radii_(Dyadic(a.body.rounding()) + Dyadic(b.body.rounding())),
        polytope_([this](std::uint32_t k) { return exact_[k]; }) {
    std::frexp(scale_, &shift_);
    --shift_;
    size_ = std::max(size_of(a), size_of(b)) * scale_;
  }

  EnclosedDepth run() {
    if (begin()) {
      grow();
      take_surface();
    }
    take_directions();
    if (!(depth_.low > 0) && radii_.sign() == Sign::positive) take_points();
    return {depth_, *std::move(direction_), std::move(proof_)};
  }

 private:
  // The point that a body has at one end of a difference; of a hull a vertex. Nothing where it is not of dyadic
  // numbers.
  struct EndOf {
    std::uint32_t number;
    Exact at;
  };
  std::optional<EndOf> end_of(const PlacedRound& body, const Point3& seen, std::uint32_t vertex,
                              std::vector<PointOf>& points) {
    if (vertex != no_vertex) return EndOf{vertex, coordinates<Dyadic>(body.core[vertex])};
    const auto& origin = a_.core.pose.translation;
    const auto part = [&](double x, std::size_t k) { return Dyadic(origin[k]) + Dyadic(x).scaled(-shift_); };
    if (!std::isfinite(seen.x + seen.y + seen.z)) return std::nullopt;
    PointOf held = held_by(body, {part(seen.x, 0), part(seen.y, 1), part(seen.z, 2)}, 48);
    if (!(held.at.denominator == Dyadic(1.0))) return std::nullopt;
    const Exact at = held.at.numerators();
    points.push_back(std::move(held));
    return EndOf{static_cast<std::uint32_t>(points.size() - 1), at};
  }

  // A corner of the difference, the furthest along the direction, about; which is remembered if D ends there soon.
  std::optional<std::uint32_t> furthest(const Point3& direction) {
    search_.simplex.count = 0;
    search_.direction = direction;
    const DifferenceVertexOf<double> w = search_.probe(cost_);
    const double beyond = dot(direction, w.at) / std::sqrt(dot(direction, direction));
    if (beyond < least_reach_) {
      least_reach_ = beyond;
      best_ = direction;
    }
    const auto& slot = search_.support.slots[w.a];
    const auto of_a = end_of(a_, slot.of_a, slot.vertex_a, surface_.of_a);
    const auto of_b = end_of(b_, slot.of_b, slot.vertex_b, surface_.of_b);
    if (!of_a || !of_b) return std::nullopt;
    const Exact way = of_a->at - of_b->at;
    exact_.push_back({way.x.scaled(shift_), way.y.scaled(shift_), way.z.scaled(shift_)});
    surface_.corners.push_back({of_a->number, of_b->number});
    const auto estimate = [](const Dyadic& x) -> Estimate {
      const double high = x.nearest();
      if (!std::isfinite(high)) return {high, unlimited};
      const double low = (x - Dyadic(high)).nearest();
      return {DoubleDouble(high, low), std::fabs(low) * 0x1p-50 + 0x1p-1070};
    };
    const Exact& at = exact_.back();
    return polytope_.add_corner({estimate(at.x), estimate(at.y), estimate(at.z)});
  }

  Point3 about(std::uint32_t corner) const {
    const Exact& at = exact_[corner];
    return {at.x.nearest(), at.y.nearest(), at.z.nearest()};
  }

  // Four corners that are far from being of one plane. False: there are none.
  bool begin() {
    std::vector<std::uint32_t> all;
    const auto look = [&](const Point3& d) {
      for (const Point3& way : {d, negated(d)}) {
        if (const auto corner = furthest(way)) all.push_back(*corner);
      }
    };
    for (const Point3& axis : {Point3{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}) look(axis);
    if (all.empty()) return false;
    const std::uint32_t p = all[0];
    const auto furthest_by = [&](const auto& measure) {
      return *std::max_element(all.begin(), all.end(),
                               [&](std::uint32_t x, std::uint32_t y) { return measure(x) < measure(y); });
    };
    const auto from_p = [&](std::uint32_t k) { return minus(about(k), about(p)); };
    const std::uint32_t q = furthest_by([&](std::uint32_t k) { return dot(from_p(k), from_p(k)); });
    const Point3 line = from_p(q);
    for (const Point3& axis : {Point3{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}) {
      const Point3 across = cross(line, axis);
      if (dot(across, across) > 0) look(across);
    }
    const std::uint32_t r = furthest_by([&](std::uint32_t k) {
      const Point3 n = cross(line, from_p(k));
      return dot(n, n);
    });
    const Point3 normal = cross(line, from_p(r));
    if (!(dot(normal, normal) > 0)) return false;
    look(normal);
    const std::uint32_t s = furthest_by([&](std::uint32_t k) { return std::fabs(dot(normal, from_p(k))); });
    const double height = std::fabs(dot(normal, from_p(s))) / std::sqrt(dot(normal, normal));
    if (!(height > 0x1p-40 * size_)) return false;
    polytope_.begin({p, q, r, s});
    return true;
  }

  void grow() {
    while (const std::optional<std::uint32_t> facet = polytope_.nearest()) {
      const double low = polytope_.facets()[*facet].height.low;
      const double all = least_reach_ + (radii_.nearest() * scale_);
      if (least_reach_ - low <= std::max(round_depth_width * all, 0x1p-42 * size_)) return;
      if (polytope_.corner_count() >= round_depth_most_corners) return;
      ++cost_.iterations;
      const Vector3<Estimate>& n = polytope_.facets()[*facet].normal;
      Point3 direction{n.x.value.high, n.y.value.high, n.z.value.high};
      if (!make_tame(direction)) return;
      const std::optional<std::uint32_t> corner = furthest(direction);
      if (!corner || polytope_.side(*facet, *corner) != Sign::positive) {
        // Nothing is beyond it, as far as the search sees: so it is as near as any.
        return;
      }
      polytope_.expand(*facet, *corner);
    }
  }

  void take_surface() {
    double least = unlimited;
    std::vector<std::uint32_t> number(exact_.size(), no_entry), number_a(surface_.of_a.size(), no_entry),
        number_b(surface_.of_b.size(), no_entry);
    DepthSurface kept;
    const auto keep = [](std::vector<std::uint32_t>& numbers, std::uint32_t k, const std::vector<PointOf>& from,
                         std::vector<PointOf>& to) {
      if (from.empty()) return k;  // a vertex
      if (numbers[k] == no_entry) {
        numbers[k] = static_cast<std::uint32_t>(to.size());
        to.push_back(from[k]);
      }
      return numbers[k];
    };
    for (const ExpandingPolytope::Facet& facet : polytope_.facets()) {
      if (!facet.is_alive) continue;
      least = std::min(least, facet.height.low);
      std::array<std::uint32_t, 3>& triangle = kept.triangles.emplace_back();
      for (std::size_t k = 0; k < 3; ++k) {
        std::uint32_t& n = number[facet.corner[k]];
        if (n == no_entry) {
          n = static_cast<std::uint32_t>(kept.corners.size());
          const auto& [of_a, of_b] = surface_.corners[facet.corner[k]];
          kept.corners.push_back(
              {keep(number_a, of_a, surface_.of_a, kept.of_a), keep(number_b, of_b, surface_.of_b, kept.of_b)});
        }
        triangle[k] = n;
      }
    }
    if (!(least > 0)) return;
    const Dyadic low = Dyadic(least).scaled(-shift_) + radii_;
    depth_.low = std::min(low.enclosure().low, std::numeric_limits<double>::max());
    if (depth_.low > 0) proof_ = std::move(kept);
  }

  void take(const WorldDirection& direction) {
    const double reach = reach_at_most(a_, b_, direction, cost_);
    const double high = std::max((Interval(reach) + radii_.enclosure()).high, 0.0);
    if (direction_ && high >= depth_.high) return;
    depth_.high = high;
    direction_ = direction;
  }
  void take_directions() {
    take(WorldDirection(make_tame(best_) ? best_ : Point3{1, 0, 0}));
    for (const PlacedRound* body : {&a_, &b_}) {
      const auto axis = axis_of(*body);
      if (!axis) continue;
      const Exact& way = axis->way;
      take(WorldDirection(way));
      take(WorldDirection(Exact{-way.x, -way.y, -way.z}));
    }
  }

  // The cores, and what is curved, have a point of the difference that is near enough: where they meet, the origin.
  void take_points() {
    const bool is_a = a_.body.rounding() > 0;  // the other one is curved
    const PlacedRound& hull = is_a ? a_ : b_;
    const RoundBody bare = RoundBody::rounded(hull.body.core(), 0);
    const PlacedRound core(bare, hull.pose);
    const RoundDistance between = is_a ? round_distance(core, b_) : round_distance(a_, core);
    if (const auto* apart = std::get_if<CurvedApart>(&between.evidence)) take(apart->nearest->direction);
    const auto [of_a, of_b] = is_a ? nearest_of(core, b_, between.evidence) : nearest_of(a_, core, between.evidence);
    const NearPoints points(of_a, of_b);
    // The radii exceed `low` by what the points are apart, at least.
    const auto is_near = [&](double low) {
      const Dyadic rest = radii_ - Dyadic(low);
      return rest.sign() != Sign::negative && compare_root(points.square, rest) != Sign::positive;
    };
    const double low = (radii_ - Dyadic(root(points.square).high)).enclosure().low;
    if (!(low > 0) || !is_near(low)) return;
    depth_.low = low;
    proof_ = DepthPoints{points.of_a, points.of_b, !is_a, is_a};
  }

  const PlacedRound& a_;
  const PlacedRound& b_;
  Cost& cost_;
  Interval depth_{0, unlimited};
  std::optional<WorldDirection> direction_;
  DepthProof proof_;
  RoundSearch<double> search_;
  double scale_, size_ = 0;  // lengths of the search and of the polytope are times the scale, a power of two
  int shift_ = 0;
  Dyadic radii_;  // of hulls
  ExpandingPolytope polytope_;
  std::vector<Exact> exact_;
  DepthSurface surface_;  // of all corners, without triangles
  Point3 best_{1, 0, 0};  // along which D ends soonest, of those seen
  double least_reach_ = unlimited;
};

}  // namespace

EnclosedDepth depth_of_curved(const PlacedRound& a, const PlacedRound& b, Cost& cost) {
  return CurvedDepth(a, b, cost).run();
}

}  // namespace sunder::solid
