#include <sunder/solid/round/round_placed.h>

#include <sunder/number/exact_vector.h>
#include <sunder/number/interval.h>
#include <sunder/predicate/coordinates.h>
#include <sunder/solid/exact/spanning_vertices.h>
#include <sunder/solid/round/round_finish.h>
#include <sunder/solid/round/world_box.h>

#include <algorithm>
#include <utility>

namespace sunder::solid {

namespace {

using Exact = Vector3<Dyadic>;
using round_detail::exact_image;

}  // namespace

Combination round_detail::exact(const RoundCombination& c) {
  Combination made;
  made.denominator = Dyadic(0.0);
  for (std::size_t k = 0; k < c.count(); ++k) {
    made.parts.push_back({c.vertices[k], Dyadic(c.weights[k])});
    made.denominator = made.denominator + Dyadic(c.weights[k]);
  }
  return made;
}

Exact round_detail::exact_image(const PlacedRound& body, const Point3& p) {
  return coordinates<Dyadic>(Posed3{p, &body.core.pose, false});
}

namespace {

// A point of the body that is well inside, where it has an inside.
Exact middle_of(const PlacedRound& curved) {
  const auto axis = axis_of(curved);
  if (!axis) return exact_image(curved, curved.shape.points[0]);
  return sum(axis->base, times(Dyadic(curved.kind() == RoundKind::cone ? 0.25 : 0.5), axis->way));
}

// Of a cylinder's or a cone's axis, or of an ellipsoid the centre: that is nearest to the point.
ExactPoint3 on_core(const PlacedRound& curved, const Exact& near) {
  const auto axis = axis_of(curved);
  if (!axis) return exact_point(exact_image(curved, curved.shape.points[0]));
  const auto& [base, way] = *axis;
  const Dyadic along = dot(near - base, way), all = dot(way, way);
  if (along.sign() != Sign::positive) return exact_point(base);
  if ((all - along).sign() != Sign::positive) return exact_point(sum(base, way));
  return exact_point(sum(times(all, base), times(along, way)), all);
}

// Encloses coordinate k of an end of a cylinder's or a cone's axis.
Interval end_of(const PlacedRound& body, std::size_t end, std::size_t k) {
  return coordinate(k, {body.shape.points[end], &body.core.pose, body.core.tame});
}

// At least how far the body reaches along axis k beyond its core, of a cone beyond its base's middle.
double reach(const PlacedRound& body, std::size_t k) {
  const auto square = [](const Interval& x) { return x * x; };
  switch (body.kind()) {
    case RoundKind::hull: break;
    case RoundKind::ellipsoid: {
      const double* const row = &body.pose.affine().linear[3 * k];
      const Interval sum = square(row[0]) + square(row[1]) + square(row[2]);
      return (square_root(sum) * body.radius()).high;
    }
    case RoundKind::cylinder:
    case RoundKind::cone: {
      // r sqrt(1 - a_k^2 / a a), a the axis; never more than r.
      std::array<Interval, 3> squares;
      for (std::size_t j = 0; j < 3; ++j) squares[j] = square(end_of(body, 1, j) - end_of(body, 0, j));
      const Interval across = squares[(k + 1) % 3] + squares[(k + 2) % 3];
      const double part = std::min(square_root(across / (across + squares[k])).high, 1.0);
      return (Interval(part) * body.radius()).high;
    }
  }
  return body.radius();
}

// From the core's box to the body's.
void widen(const PlacedRound& body, Box3& box) {
  for (std::size_t k = 0; k < 3; ++k) {
    const Interval beyond = reach(body, k);
    if (body.kind() != RoundKind::cone) {
      box.low[k] = (Interval(box.low[k]) - beyond).low;
      box.high[k] = (Interval(box.high[k]) + beyond).high;
      continue;
    }
    const Interval base = end_of(body, 0, k), apex = end_of(body, 1, k);
    box.low[k] = std::min((Interval(base.low) - beyond).low, apex.low);
    box.high[k] = std::max((Interval(base.high) + beyond).high, apex.high);
  }
}

}  // namespace

double size_of(const PlacedRound& body) {
  const bool is_mapped = body.kind() == RoundKind::ellipsoid;
  return std::max(body.core.size, body.radius() * (is_mapped ? body.pose.linear_range().greatest : 1));
}

RoundShape shape_along(const PlacedRound& body, const WorldDirection& direction, End end, std::uint32_t near,
                       Cost& cost, StageTally& tally) {
  RoundShape shape = body.shape;
  if (body.body.is_curved()) return shape;
  std::uint32_t v = 0;
  if (body.core.graph.vertices.size() > 1) {
    Along along(direction, body.core.pose, body.core.tame);
    v = extreme_vertex_from(body.core, along, end, near, cost, tally);
  }
  shape.points[0] = body.core.graph.vertices[v];
  return shape;
}

Sign side_of(const PlacedRound& body, const WeightedPoint& x, const RoundCombination& made, StageTally* tally) {
  if (body.body.is_curved()) return side_of(body.shape, x, tally);
  if (made.count() == 0) return Sign::negative;
  return nearness(round_detail::weighted(body, made), body.radius(), x, 0, tally);
}

Sign side_of(const PlacedRound& body, const ExactPoint3& x, const Combination& made) {
  if (body.body.is_curved()) return side_of(body.shape, x);
  if (made.parts.empty()) return Sign::negative;
  return nearness(core_point(body, made.parts)->at, body.radius(), x, 0);
}

bool is_inside(const PlacedRound& body, const ExactPoint3& x, const Combination& made) {
  return body.body.is_polyhedron() || side_of(body, x, made) == Sign::positive;
}

std::optional<ExactPoint3> moved_in(const PlacedRound& body, const ExactPoint3& x, int bits, Combination& made) {
  if (!body.body.is_polyhedron()) return std::nullopt;
  const std::vector<std::uint32_t> spanning = spanning_vertices(body.body.core());
  const Dyadic n(static_cast<double>(spanning.size())), part = Dyadic::power_of_two(-bits), rest = Dyadic(1.0) - part;
  // Over n times the old denominator.
  Combination moved{{}, made.denominator * n};
  for (const auto& [index, numerator] : made.parts) moved.parts.push_back({index, numerator * n * rest});
  Exact middle{Dyadic(0.0), Dyadic(0.0), Dyadic(0.0)};
  for (const std::uint32_t v : spanning) {
    middle = sum(middle, coordinates<Dyadic>(body.core[v]));
    moved.add(v, made.denominator * part);
  }
  made = std::move(moved);
  return exact_point(sum(times(n * rest, x.numerators()), times(x.denominator * part, middle)), x.denominator * n);
}

Combination made_by(const PlacedRound& body, const ExactPoint3& x, const Combination& made) {
  return body.body.is_curved() ? made_by(body, x) : made;
}

Combination made_by(const PlacedRound& curved, const ExactPoint3& x) {
  const Exact at = x.numerators();
  const Dyadic& weight = x.denominator;
  const auto axis = axis_of(curved);
  if (!axis) {
    const Affine3& pose = curved.core.pose;
    const std::array<Dyadic, 9> m = adjoint(pose);
    const auto& l = pose.linear;
    const Dyadic determinant = m[0] * Dyadic(l[0]) + m[1] * Dyadic(l[3]) + m[2] * Dyadic(l[6]);
    const auto& t = pose.translation;
    const Exact p = at - times(weight, coordinates<Dyadic>(Point3{t[0], t[1], t[2]}));
    const auto row = [&](std::size_t i) { return m[i] * p.x + m[i + 1] * p.y + m[i + 2] * p.z; };
    return {{{0, Dyadic(1.0)}}, 1.0, ExactPoint3{row(0), row(3), row(6), determinant * weight}};
  }
  const Dyadic along = dot(at - times(weight, axis->base), axis->way), all = weight * dot(axis->way, axis->way);
  Combination made{{}, all};
  const Dyadic rest = all - along;
  if (rest.sign() != Sign::zero) made.parts.push_back({0, rest});
  if (along.sign() != Sign::zero) made.parts.push_back({1, along});
  return made;
}

Combination in_points(const PlacedRound& body, Combination of_core) {
  if (body.kind() == RoundKind::ellipsoid) {
    of_core.from = ExactPoint3{};
  } else if (body.body.is_curved()) {
    for (auto& part : of_core.parts) part.index = body.body.core().source()[part.index];
  }
  return of_core;
}

std::optional<PointOf> core_point(const PlacedRound& body, const std::vector<Weights::Part>& weights) {
  if (body.body.is_curved()) return std::nullopt;
  Combination made;
  made.denominator = Dyadic(0.0);
  for (const auto& [index, weight] : weights) {
    made.add(index, weight);
    made.denominator = made.denominator + weight;
  }
  const Exact sum = numerators_of(made, [&](std::uint32_t v) { return coordinates<Dyadic>(body.core[v]); });
  return PointOf{exact_point(sum, made.denominator), std::move(made)};
}

PointOf held_by(const PlacedRound& curved, const Exact& near, int bits) {
  const Exact inwards = middle_of(curved) - near;
  ExactPoint3 x = exact_point(near);
  for (int k = bits; k >= 8 && side_of(curved.shape, x) == Sign::negative; k -= k > 24 ? 6 : 4) {
    x = exact_point(sum(near, times(Dyadic::power_of_two(-k), inwards)));
  }
  if (side_of(curved.shape, x) == Sign::negative) x = on_core(curved, near);
  return {x, made_by(curved, x)};
}

std::optional<PolyhedronDistance> distance_of_cores(const PlacedRound& a, const PlacedRound& b) {
  if (a.body.is_curved() || b.body.is_curved()) return std::nullopt;
  return polyhedron_polyhedron_distance(a.body.core(), a.pose, b.body.core(), b.pose);
}

std::optional<ExactAxis> axis_of(const PlacedRound& body) {
  if (body.shape.ends() == 1) return std::nullopt;
  const Exact base = exact_image(body, body.shape.points[0]);
  return ExactAxis{base, exact_image(body, body.shape.points[1]) - base};
}

std::vector<std::array<Dyadic, 3>> outward_directions(const PlacedRound& body, const ExactPoint3& x) {
  std::vector<std::array<Dyadic, 3>> found;
  if (!body.body.is_curved()) return found;
  const auto add = [&](const Exact& n) {
    if (!is_zero(n)) found.push_back({n.x, n.y, n.z});
  };
  const auto axis = axis_of(body);
  const Exact first = axis ? axis->base : exact_image(body, body.shape.points[0]);
  const Exact from = x.numerators() - times(x.denominator, first);
  if (!axis) {
    // L^-T L^-1 (x - t - L c), up to a positive factor.
    const std::array<Dyadic, 9> m = adjoint(body.core.pose);
    const auto row = [&](std::size_t i) { return m[i] * from.x + m[i + 1] * from.y + m[i + 2] * from.z; };
    const Exact v{row(0), row(3), row(6)};
    const auto column = [&](std::size_t j) { return m[j] * v.x + m[3 + j] * v.y + m[6 + j] * v.z; };
    add({column(0), column(1), column(2)});
    return found;
  }
  const Exact& way = axis->way;
  const Dyadic length2 = dot(way, way), along = dot(from, way);
  const Exact across = times(length2, from) - times(along, way);
  if (body.kind() == RoundKind::cylinder) {
    add(across);
  } else {
    const Dyadic r(body.radius());
    add(sum(times(length2, across), times(r * r * (x.denominator * length2 - along), way)));
  }
  add(way);
  add({-way.x, -way.y, -way.z});
  return found;
}

std::optional<CurvedVerdict> curved_polyhedron(const PlacedRound& curved, const PlacedRound& polyhedron,
                                               std::uint32_t near, Cost& cost, StageTally& tally) {
  if (!polyhedron.body.is_polyhedron()) return std::nullopt;
  switch (curved.kind()) {
    case RoundKind::hull: break;
    case RoundKind::ellipsoid: return ellipsoid_polyhedron(curved, polyhedron, near, cost, tally);
    case RoundKind::cylinder: return cylinder_polyhedron(curved, polyhedron, tally);
    case RoundKind::cone: return cone_polyhedron(curved, polyhedron, tally);
  }
  return std::nullopt;
}

WorldBox world_box(const PlacedRound& body) {
  WorldBox box = world_box(body.core);
  widen(body, box);
  return box;
}

Box3 rough_world_box(const PlacedRound& body) {
  Box3 box = rough_world_box(body.core);
  widen(body, box);
  return box;
}

WorldBox world_box(const RoundBody& body, const Pose& pose) {
  return body.is_polyhedron() ? world_box(Placed(body.core(), pose)) : world_box(PlacedRound(body, pose));
}

Box3 rough_world_box(const RoundBody& body, const Pose& pose) {
  return body.is_polyhedron() ? rough_world_box(Placed(body.core(), pose)) : rough_world_box(PlacedRound(body, pose));
}

}  // namespace sunder::solid
