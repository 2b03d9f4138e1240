#include <sunder/number/exact_vector.h>
#include <sunder/predicate/coordinates.h>
#include <sunder/solid/exact/exact_gjk.h>
#include <sunder/solid/round/round_finish.h>
#include <sunder/solid/round/round_placed.h>
#include <sunder/solid/search/extreme_vertex.h>

#include <algorithm>
#include <utility>
#include <vector>

namespace sunder::solid {

namespace {

using Exact = Vector3<Dyadic>;

Exact operator+(const Exact& p, const Exact& q) { return {p.x + q.x, p.y + q.y, p.z + q.z}; }
Exact negated_exact(const Exact& v) { return {-v.x, -v.y, -v.z}; }

CommonPoint common(const PlacedRound& curved, const Exact& at, const Dyadic& weight, Combination of_polyhedron) {
  const ExactPoint3 point = exact_point(at, weight);
  return {point, made_by(curved, point), std::move(of_polyhedron)};
}

// ---- Ellipsoids: L^-1 times the determinant makes balls of them.

class BallAndImages {
 public:
  BallAndImages(const PlacedRound& ball, const PlacedRound& polyhedron, Cost& cost, StageTally& tally)
      : ball_(ball), polyhedron_(polyhedron), adjoint_(adjoint(ball.core.pose)), cost_(cost), tally_(tally) {
    const auto& m = ball.core.pose.linear;
    determinant_ = adjoint_[0] * Dyadic(m[0]) + adjoint_[1] * Dyadic(m[3]) + adjoint_[2] * Dyadic(m[6]);
    centre_ = times(determinant_, coordinates<Dyadic>(ball.shape.points[0]));
  }

  CurvedVerdict decide(std::uint32_t near) {
    ExactNearest nearest = ExactNearest::to_origin();
    join(nearest, {0, near});
    exact_gjk(*this, nearest, tally_.exact);
    const auto& [features, way, weights] = nearest.closest;
    const Dyadic radius = Dyadic(ball_.radius()) * determinant_;
    CurvedVerdict verdict;
    verdict.sign = (radius * radius * way.denominator - way.squared()).sign();
    if (verdict.sign != Sign::positive) verdict.direction = pulled(way.way);
    if (verdict.sign == Sign::negative) return verdict;
    Combination of_polyhedron{{}, way.denominator};
    for (std::size_t k = 0; k < features.count_b; ++k)
      of_polyhedron.parts.push_back({features.of_b(k), weights[k + 1]});
    const Exact sum =
        numerators_of(of_polyhedron, [&](std::uint32_t v) { return coordinates<Dyadic>(polyhedron_.core[v]); });
    verdict.point = common(ball_, sum, way.denominator, std::move(of_polyhedron));
    return verdict;
  }

  // As the support of the search for the nearest image to the origin, which is the centre.
  std::array<std::uint32_t, 2> extreme(const ExactNearest& nearest) {
    ++cost_.iterations;
    ++tally_.exact;
    const WorldDirection world(pulled(nearest.closest.way.way));
    const Placed& core = polyhedron_.core;
    Along along(world, core.pose, core.tame);
    return {0, extreme_vertex_from(core, along, End::least, nearest.of_b(), cost_, tally_)};
  }
  void join(ExactNearest& nearest, const std::array<std::uint32_t, 2>& next) const {
    nearest.b.add(next[1], at(next[1]));
  }

 private:
  Exact at(std::uint32_t v) const {
    const auto& t = ball_.core.pose.translation;
    const Exact p = coordinates<Dyadic>(polyhedron_.core[v]) - coordinates<Dyadic>(Point3{t[0], t[1], t[2]});
    const auto row = [&](std::size_t i) { return adjoint_[i] * p.x + adjoint_[i + 1] * p.y + adjoint_[i + 2] * p.z; };
    return Exact{row(0), row(3), row(6)} - centre_;
  }
  Exact pulled(const Exact& n) const {
    const auto column = [&](std::size_t j) {
      return adjoint_[j] * n.x + adjoint_[3 + j] * n.y + adjoint_[6 + j] * n.z;
    };
    return {column(0), column(1), column(2)};
  }

  const PlacedRound& ball_;
  const PlacedRound& polyhedron_;
  std::array<Dyadic, 9> adjoint_;
  Dyadic determinant_;
  Exact centre_;
  Cost& cost_;
  StageTally& tally_;
};

// ---- Cylinders and discs: what of the polyhedron lies between two planes across an axis.

// The points p of the polyhedron with 0 <= (p - base) axis <= height.
class Slab {
 public:
  // A corner of it: weights of one or two vertices, over their sum.
  struct Corner {
    std::array<std::uint32_t, 2> vertex{};
    std::array<Dyadic, 2> weight;
    std::size_t count = 0;
    Exact across;    // (p - base) x axis, times the sum
    Dyadic divisor;  // the sum
  };

  Slab(const PlacedRound& polyhedron, const Exact& base, const Exact& axis, const Dyadic& height, StageTally& tally)
      : core_(polyhedron.core), axis_(axis), tally_(tally) {
    const std::size_t n = core_.graph.vertices.size();
    for (std::uint32_t v = 0; v < n; ++v) {
      from_base.push_back(coordinates<Dyadic>(core_[v]) - base);
      along.push_back(dot(from_base[v], axis));
      over.push_back(along[v] - height);
    }
    for (std::uint32_t v = 0; v < n; ++v) {
      if (along[v].sign() != Sign::negative && over[v].sign() != Sign::positive) add_vertex(v);
      for (const std::uint32_t u : core_.body.neighbours(v)) {
        if (u > v) continue;
        add_crossing(u, v, along);
        if (height.sign() != Sign::zero) add_crossing(u, v, over);
      }
    }
    tally.exact += static_cast<std::uint32_t>(n);
  }

  std::vector<Corner> corners;
  std::vector<Exact> from_base;
  std::vector<Dyadic> along, over;

  // The point of it that is nearest to the axis. Requires a corner, and that the axis does not meet it.
  struct Nearest {
    Exact towards;         // along `across`
    ExactFraction square;  // of the distance times |axis|
    Combination of_polyhedron;
    Exact point;             // over the combination's denominator
    std::size_t corner = 0;  // one that it is made of
  };
  Nearest nearest_to_axis() {
    ExactNearest nearest = ExactNearest::to_origin();
    join(nearest, {0, 0});
    exact_gjk(*this, nearest, tally_.exact);
    return made(nearest.closest);
  }

  // As the support of the search for the nearest point to the axis among the corners, seen along it.
  std::array<std::uint32_t, 2> extreme(const ExactNearest& nearest) {
    const Exact& n = nearest.closest.way.way;
    std::uint32_t least = nearest.of_b();
    Dyadic value = dot(n, corners[least].across);
    for (std::uint32_t i = 0; i < corners.size(); ++i) {
      const Dyadic here = dot(n, corners[i].across);
      if ((here * corners[least].divisor - value * corners[i].divisor).sign() != Sign::negative) continue;
      least = i;
      value = here;
    }
    tally_.exact += static_cast<std::uint32_t>(corners.size());
    return {0, least};
  }
  // All of them times the divisors of all, `scale_`: then they are no fractions.
  void join(ExactNearest& nearest, const std::array<std::uint32_t, 2>& next) {
    VertexSet<Dyadic>& set = nearest.b;
    set.add(next[1], {});
    scale_ = Dyadic(1.0);
    for (std::size_t k = 0; k < set.count; ++k) {
      set.at[k] = corners[set.vertex[k]].across;
      scale_ = scale_ * corners[set.vertex[k]].divisor;
      for (std::size_t j = 0; j < set.count; ++j) {
        if (j != k) set.at[k] = times(corners[set.vertex[j]].divisor, set.at[k]);
      }
    }
  }

  // A direction along which no vertex is less far than the point nearest to the axis: perpendicular to the axis where
  // that will do, else turned so far towards it as a vertex beyond the slab demands.
  Exact direction_to(const Nearest& nearest) const {
    Exact m = cross(axis_, nearest.towards);  // m p = towards (p x axis)
    const Corner& corner = corners[nearest.corner];
    const Dyadic value = dot(nearest.towards, corner.across);
    ExactFraction most;
    Sign side = Sign::zero;
    for (std::size_t v = 0; v < along.size(); ++v) {
      Dyadic lacks = value - dot(m, from_base[v]) * corner.divisor;  // times the divisor
      if (lacks.sign() != Sign::positive) continue;
      const bool above = over[v].sign() == Sign::positive;
      Dyadic beyond = above ? over[v] : -along[v];
      if (beyond.sign() != Sign::positive) continue;  // within the slab none lacks
      ExactFraction turn{std::move(lacks), std::move(beyond)};
      if (turn <= most) continue;
      most = std::move(turn);
      side = above ? Sign::positive : Sign::negative;
    }
    if (side == Sign::zero) return m;
    const Dyadic turn = side == Sign::positive ? most.numerator : -most.numerator;
    return times(corner.divisor * most.denominator, m) + times(turn, axis_);
  }

 private:
  void add_vertex(std::uint32_t v) {
    Corner c;
    c.vertex[0] = v;
    c.weight[0] = c.divisor = Dyadic(1.0);
    c.count = 1;
    c.across = cross(from_base[v], axis_);
    corners.push_back(std::move(c));
  }
  void add_crossing(std::uint32_t u, std::uint32_t v, const std::vector<Dyadic>& height) {
    if (height[u].sign() * height[v].sign() != Sign::negative) return;
    const bool up = height[v].sign() == Sign::positive;
    Corner c;
    c.vertex = {u, v};
    c.weight = {up ? height[v] : -height[v], up ? -height[u] : height[u]};
    c.count = 2;
    c.divisor = c.weight[0] + c.weight[1];
    c.across = cross(times(c.weight[0], from_base[u]) + times(c.weight[1], from_base[v]), axis_);
    corners.push_back(std::move(c));
  }
  Nearest made(const ClosestWay<Dyadic>& closest) const {
    const auto& [features, way, weights] = closest;
    Nearest nearest{way.way, {way.squared(), way.denominator * scale_ * scale_}, {}, {}, features.of_b(0)};
    // The scaled points are all `scale_` times the corners: the weights are those of the corners.
    Combination& sum = nearest.of_polyhedron;
    sum.denominator = way.denominator;
    for (std::size_t k = 0; k < features.count_b; ++k) {
      sum.denominator = sum.denominator * corners[features.of_b(k)].divisor;
    }
    for (std::size_t k = 0; k < features.count_b; ++k) {
      const Corner& c = corners[features.of_b(k)];
      Dyadic others = weights[k + 1];
      for (std::size_t j = 0; j < features.count_b; ++j) {
        if (j != k) others = others * corners[features.of_b(j)].divisor;
      }
      for (std::size_t i = 0; i < c.count; ++i) sum.add(c.vertex[i], others * c.weight[i]);
    }
    nearest.point = numerators_of(sum, [&](std::uint32_t v) { return coordinates<Dyadic>(core_[v]); });
    return nearest;
  }

  const Placed& core_;
  Exact axis_;
  Dyadic scale_;
  StageTally& tally_;
};

// Within the radius of the axis, between base and base + height?
CurvedVerdict within_radius(const PlacedRound& curved, Slab& slab, const Exact& axis) {
  CurvedVerdict verdict;
  if (slab.corners.empty()) {
    verdict.sign = Sign::negative;
    verdict.direction = slab.over[0].sign() == Sign::positive ? axis : negated_exact(axis);
    return verdict;
  }
  const Slab::Nearest nearest = slab.nearest_to_axis();
  const Dyadic r(curved.radius());
  verdict.sign = compare(ExactFraction{r * r * dot(axis, axis)}, nearest.square);
  if (verdict.sign != Sign::positive) verdict.direction = slab.direction_to(nearest);
  if (verdict.sign != Sign::negative) {
    verdict.point = common(curved, nearest.point, nearest.of_polyhedron.denominator, nearest.of_polyhedron);
  }
  return verdict;
}

// ---- Cones: edges.

// The points of an edge, from + t (to - from).
class EdgeAndCone {
 public:
  EdgeAndCone(const PlacedRound& cone, const PlacedRound& polyhedron, const Exact& base, const Exact& axis)
      : cone_(cone), core_(polyhedron.core), base_(base), axis_(axis), length2_(dot(axis, axis)) {}

  // A point of the edge that the cone holds. Along the edge q(t) = A t^2 + B t + C is not positive where the double
  // cone holds it; of the half between base plane and apex only some t from t0 to t1 are.
  std::optional<CommonPoint> common_point(std::uint32_t u, std::uint32_t v) const {
    const Exact from = coordinates<Dyadic>(core_[u]) - base_, way = coordinates<Dyadic>(core_[v]) - base_ - from;
    const Dyadic r(cone_.radius()), r2 = r * r;
    const Exact c = cross(from, axis_), e = cross(way, axis_);
    const Dyadic s = dot(from, axis_), s_way = dot(way, axis_), rest = length2_ - s;
    const Dyadic a = length2_ * dot(e, e) - r2 * s_way * s_way;
    const Dyadic b = length2_ * dot(c, e) + r2 * rest * s_way;  // half of B
    const Dyadic d = length2_ * dot(c, c) - r2 * rest * rest;
    ExactFraction low, high{Dyadic(1.0)};
    // 0 <= s + t s_way <= length2
    switch (s_way.sign()) {
      case Sign::zero:
        if (s.sign() == Sign::negative || rest.sign() == Sign::negative) return std::nullopt;
        break;
      case Sign::positive:
        low = std::max(low, {-s, s_way});
        high = std::min(high, {rest, s_way});
        break;
      case Sign::negative:
        low = std::max(low, {-rest, -s_way});
        high = std::min(high, {s, -s_way});
        break;
    }
    if (high < low) return std::nullopt;
    const auto holds = [&](const ExactFraction& t) {
      const auto& [n, m] = t;
      return (a * n * n + Dyadic(2.0) * b * n * m + d * m * m).sign() != Sign::positive;
    };
    if (holds(low)) return made(u, v, low);
    if (holds(high)) return made(u, v, high);
    if (a.sign() != Sign::positive) return std::nullopt;
    const ExactFraction least{-b, a};
    if (low >= least || least >= high || !holds(least)) return std::nullopt;
    return made(u, v, least);
  }

 private:
  CommonPoint made(std::uint32_t u, std::uint32_t v, const ExactFraction& t) const {
    const auto& [n, whole] = t;
    const Dyadic rest = whole - n;
    Combination of_edge{{}, whole};
    if (rest.sign() == Sign::positive) of_edge.parts.push_back({u, rest});
    if (n.sign() == Sign::positive) of_edge.parts.push_back({v, n});
    const Exact at = times(rest, coordinates<Dyadic>(core_[u])) + times(n, coordinates<Dyadic>(core_[v]));
    return common(cone_, at, whole, std::move(of_edge));
  }

  const PlacedRound& cone_;
  const Placed& core_;
  const Exact &base_, &axis_;
  Dyadic length2_;
};

}  // namespace

CurvedVerdict ellipsoid_polyhedron(const PlacedRound& ellipsoid, const PlacedRound& polyhedron, std::uint32_t near,
                                   Cost& cost, StageTally& tally) {
  return BallAndImages(ellipsoid, polyhedron, cost, tally).decide(near);
}

CurvedVerdict cylinder_polyhedron(const PlacedRound& cylinder, const PlacedRound& polyhedron, StageTally& tally) {
  const auto [base, axis] = *axis_of(cylinder);
  Slab slab(polyhedron, base, axis, dot(axis, axis), tally);
  return within_radius(cylinder, slab, axis);
}

CurvedVerdict cone_polyhedron(const PlacedRound& cone, const PlacedRound& polyhedron, StageTally& tally) {
  const auto [base, axis] = *axis_of(cone);
  CurvedVerdict verdict;
  Slab disc(polyhedron, base, axis, Dyadic(0.0), tally);
  if (!disc.corners.empty()) {
    CurvedVerdict of_disc = within_radius(cone, disc, axis);
    if (of_disc.point) {
      verdict.point = std::move(of_disc.point);
      return verdict;
    }
  }
  const EdgeAndCone edges(cone, polyhedron, base, axis);
  const ConvexPolyhedron& body = polyhedron.core.body;
  const std::uint32_t n = static_cast<std::uint32_t>(body.vertices().size());
  for (std::uint32_t v = 0; v < n; ++v) {
    if (n == 1) verdict.point = edges.common_point(0, 0);
    for (const std::uint32_t u : body.neighbours(v)) {
      if (u > v || verdict.point) continue;
      ++tally.exact;
      verdict.point = edges.common_point(u, v);
    }
    if (verdict.point) return verdict;
  }
  verdict.sign = Sign::negative;
  return verdict;
}

}  // namespace sunder::solid
