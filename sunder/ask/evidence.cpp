#include <sunder/ask/evidence.h>

#include <sunder/scene/rounded_evidence.h>
#include <sunder/solid/pair/contact_evidence.h>

#include <fmt/format.h>

namespace sunder::ask {

PlacedVertices placed_vertices(const solid::ConvexPolyhedron& shape, const solid::Pose& pose) {
  return {shape.vertices(), pose.affine(), false};
}

std::string decided_text(DecidedBy decided_by) {
  switch (decided_by) {
    case DecidedBy::filter: return "the search's evidence, checked by floating-point filters alone";
    case DecidedBy::evidence: return "the search's evidence, checked with the help of exact arithmetic";
    case DecidedBy::finishing: return "exact finishing, because the search's evidence did not hold";
    case DecidedBy::scan: return "exact arithmetic, by looking at everything";
  }
  return "";
}

std::string evidence_text(const PairCertificate& c, const PlacedVertices& a, const PlacedVertices& b,
                          const std::string& name_a, const std::string& name_b) {
  if (c.verdict == Verdict::meet) {
    return fmt::format("a common point at about {}, made of {} of {} and {} of {}",
                       about(scene::rounded_common_point(c, a, b)),
                       c.count_a == 1 ? "1 vertex" : fmt::format("{} vertices", c.count_a), name_a, c.count_b, name_b);
  }
  const scene::RoundedGap gap = scene::rounded_gap(c, a, b);
  return fmt::format(
      "an empty slab about {} wide across the direction of about {},\nfrom vertex {} of {} to vertex {} of {}",
      about(gap.width), about(gap.direction), c.extreme_a, name_a, c.extreme_b, name_b);
}

Json evidence_json(const PairCertificate& c, const PlacedVertices& a, const PlacedVertices& b) {
  if (c.verdict == Verdict::meet) {
    const auto begin = c.vertices.begin(), middle = begin + c.count_a;
    return {{"point", to_json(scene::rounded_common_point(c, a, b))},
            {"vertices_a", std::vector<std::uint32_t>(begin, middle)},
            {"vertices_b", std::vector<std::uint32_t>(middle, middle + c.count_b)}};
  }
  const scene::RoundedGap gap = scene::rounded_gap(c, a, b);
  return {{"direction_about", to_json(gap.direction)},
          {"gap_about", gap.width},
          {"extreme_a", c.extreme_a},
          {"extreme_b", c.extreme_b}};
}

void add_solid_pair(PairClaims& pairs, const SolidPair& pair, const PairCertificate& certificate, Contact contact) {
  if (contact == Contact::none) return pairs.add_pair(pair.index_a, pair.index_b, certificate);
  const solid::Interiors interiors = solid::interiors(pair.a, pair.pose_a, pair.b, pair.pose_b);
  if (interiors.meet) return pairs.add_overlapping(pair.index_a, pair.index_b, interiors.point);
  pairs.add_touching(pair.index_a, pair.index_b, pairs.common_point(pair.index_a, pair.index_b, certificate),
                     interiors.direction);
}

}  // namespace sunder::ask
