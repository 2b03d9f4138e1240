#include <sunder/base/contract.h>
#include <sunder/predicate/coordinates.h>
#include <sunder/solid/exact/spanning_vertices.h>
#include <sunder/solid/section/polyhedron_plane_claims.h>

#include <algorithm>
#include <array>
#include <utility>
#include <variant>

namespace sunder::solid {

namespace {

// A body and a plane, in exact numbers.
struct Exactly {
  const ConvexPolyhedron& body;
  const Pose& pose;
  const Plane& plane;

  Exact3 image(std::uint32_t v) const { return coordinates<Dyadic>(Posed3{body.vertices()[v], &pose.affine(), false}); }
  Dyadic height(std::uint32_t v) const { return solid::height(plane, exact_point(image(v))); }

  std::array<Dyadic, 3> normal(bool reversed) const {
    const Exact3 n = coordinates<Dyadic>(plane.normal);
    if (reversed) return {-n.x, -n.y, -n.z};
    return {n.x, n.y, n.z};
  }

  // Vertices with weights: the point that they make, and the combination.
  PointOf made(const std::vector<std::pair<std::uint32_t, Dyadic>>& weighted) const {
    PointOf point;
    Combination& made = point.of_body;
    made.denominator = Dyadic();
    for (const auto& [v, weight] : weighted) {
      if (weight.sign() == Sign::zero) continue;
      made.add(v, weight);
      made.denominator = made.denominator + weight;
    }
    point.at = exact_point(numerators_of(made, [&](std::uint32_t v) { return image(v); }), made.denominator);
    return point;
  }

  // On the way from a vertex that is not above the plane to one that is not below it.
  PointOf between(std::uint32_t below, std::uint32_t above) const {
    const Dyadic low = height(below), high = height(above);
    if (low.sign() == Sign::zero) return made({{below, 1.0}});
    if (high.sign() == Sign::zero) return made({{above, 1.0}});
    return made({{below, high}, {above, -low}});
  }

  // A vertex on that side. Requires that there is one.
  std::uint32_t beyond(Sign side, std::uint32_t first) const {
    if (height(first).sign() == side) return first;
    std::uint32_t v = 0;
    while (height(v).sign() != side) ++v;
    return v;
  }

  // In the relative interior of the body, which overlaps the plane: the mean of a few vertices, or between that and a
  // vertex on the other side.
  PointOf inside(const AcrossPlane& across) const {
    const std::vector<std::uint32_t> spanning = spanning_vertices(body);
    Dyadic sum;
    std::vector<std::pair<std::uint32_t, Dyadic>> weighted;
    for (const std::uint32_t v : spanning) {
      sum = sum + height(v);
      weighted.emplace_back(v, 1.0);
    }
    if (sum.sign() == Sign::zero) return made(weighted);
    const bool is_above = sum.sign() == Sign::positive;
    const std::uint32_t other =
        beyond(is_above ? Sign::negative : Sign::positive, is_above ? across.below : across.above);
    // sum > 0 > h, or the other way round: sum h + (-h) sum = 0.
    const Dyadic h = height(other);
    for (auto& [v, weight] : weighted) weight = is_above ? -h : h;
    weighted.emplace_back(other, is_above ? sum : -sum);
    return made(weighted);
  }

  // Is the body, which touches the plane, below it? Where the vertices named are on the plane, their
  // neighbours are not all.
  bool is_below(const AcrossPlane& across) const {
    if (height(across.below).sign() == Sign::negative) return true;
    if (height(across.above).sign() == Sign::positive) return false;
    for (const std::uint32_t v : body.neighbours(across.below)) {
      const Sign side = height(v).sign();
      if (side != Sign::zero) return side == Sign::negative;
    }
    SUNDER_REQUIRE(false);  // it is in the plane, and does not only touch it
    return true;
  }
};

CommonPoint common(const Plane& plane, const FlatBody& in_file, PointOf point, bool is_inside) {
  Combination of_plane = combination_of(plane, in_file, point.at, is_inside);
  return {std::move(point.at), std::move(point.of_body), std::move(of_plane)};
}

}  // namespace

ExactPoint3 common_point(const ConvexPolyhedron& body, const Pose& pose, const Plane& plane,
                         const PolyhedronPlane& answer) {
  const auto& [below, above] = std::get<AcrossPlane>(answer.evidence);
  return Exactly{body, pose, plane}.between(below, above).at;
}

void add_claims(PairClaims& pairs, std::uint32_t a, std::uint32_t b, const ConvexPolyhedron& body, const Pose& pose,
                const Plane& plane, const FlatBody& in_file, const PolyhedronPlane& answer, Relation contact) {
  const Exactly exact{body, pose, plane};
  if (const auto* beside = std::get_if<BesidePlane>(&answer.evidence)) {
    const bool is_above = beside->side == Sign::positive;
    pairs.add_apart(a, b, exact.normal(is_above));
    return pairs.add_nearest(a, b, beside->nearest, exact.normal(!is_above));
  }
  const AcrossPlane& across = std::get<AcrossPlane>(answer.evidence);
  if (contact == Relation::overlapping) {
    return pairs.add_overlapping(a, b, common(plane, in_file, exact.inside(across), true));
  }
  CommonPoint point = common(plane, in_file, exact.between(across.below, across.above), false);
  if (contact == Relation::none) return pairs.add_meet(a, b, point);
  pairs.add_touching(a, b, point, exact.normal(!exact.is_below(across)));
}

}  // namespace sunder::solid
