#include <sunder/number/exact_vector.h>
#include <sunder/solid/pair/contact_evidence.h>
#include <sunder/solid/pair/polyhedron_polyhedron.h>

namespace sunder::solid {

ClosestPoints closest_points(const ClosestFeatures& closest) {
  const FeatureVertices& f = closest.features();
  const auto [way, weights] = closest.way();
  const std::array<Posed3, 4> images = closest.images();
  const auto point = [&](std::size_t begin, std::size_t end) {
    PointOf made;
    Vector3<Dyadic> numerators{};
    for (std::size_t k = begin; k < end; ++k) {
      numerators = sum(numerators, times(weights[k], coordinates<Dyadic>(images[k])));
      made.of_body.parts.push_back({f.vertices[k], weights[k]});
    }
    made.of_body.denominator = way.denominator;
    made.at = exact_point(numerators, way.denominator);
    return made;
  };
  return {point(0, f.count_a), point(f.count_a, std::size_t{f.count_a} + f.count_b)};
}

void add_claims(PairClaims& pairs, const ClaimedPair& pair, const PairCertificate& certificate, Relation contact) {
  if (contact == Relation::none) return pairs.add_pair(pair.index_a, pair.index_b, certificate);
  const Interiors found = interiors(pair.a, pair.pose_a, pair.b, pair.pose_b);
  if (found.meet) return pairs.add_overlapping(pair.index_a, pair.index_b, found.point);
  pairs.add_touching(pair.index_a, pair.index_b,
                     pairs.common_point(pair.index_a, pair.index_b, std::get<CommonVertices>(certificate)),
                     found.direction);
}

void add_distance(PairClaims& pairs, const ClaimedPair& pair, const PolyhedronDistance& distance) {
  const ClosestFeatures* closest = closest_of(distance);
  if (closest == nullptr) return;
  const auto [of_a, of_b] = closest_points(*closest);
  pairs.add_distance(pair.index_a, pair.index_b, of_a, of_b);
}

void add_clearance(PairClaims& pairs, const ClaimedPair& pair, const PolyhedronDistance& distance, double least) {
  const std::uint32_t a = pair.index_a, b = pair.index_b;
  if (const auto* vertices = std::get_if<CommonVertices>(&distance.evidence)) {
    const CommonPoint common = pairs.common_point(a, b, *vertices);
    return pairs.add_clearance_broken(a, b, least, {common.at, common.of_a}, {common.at, common.of_b});
  }
  const auto [of_a, of_b] = closest_points(*closest_of(distance));
  if (compare_distance(distance, least) == Sign::negative) {
    return pairs.add_clearance_broken(a, b, least, of_a, of_b);
  }
  pairs.add_clearance(a, b, least, way_between(of_a, of_b));
}

}  // namespace sunder::solid

namespace sunder {

void prove(const TextSink& sink, const AskedPair<solid::ConvexPolyhedron, solid::Pose>& asked,
           const PairAnswer& answer) {
  prove_pair(sink, asked, PairClaims::Space::solid, asked.a.vertices(), asked.at_a.affine(), asked.b.vertices(),
             asked.at_b.affine(), [&](PairClaims& pairs, std::uint32_t index_a, std::uint32_t index_b) {
               const Relation relation = asked.tells_relation
                                             ? polyhedron_polyhedron_contact(asked.a, asked.at_a, asked.b, asked.at_b)
                                             : Relation::none;
               solid::add_claims(pairs, {index_a, index_b, asked.a, asked.at_a, asked.b, asked.at_b}, answer.evidence,
                                 relation);
             });
}

}  // namespace sunder
