#include <sunder/base/contract.h>
#include <sunder/scene/part_clearance.h>
#include <sunder/scene/part_questions.h>
#include <sunder/solid/mesh/mesh_distance.h>
#include <sunder/solid/round/round_closer.h>
#include <sunder/solid/round/round_distance.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>
#include <variant>
#include <vector>

namespace sunder::scene {

namespace {

constexpr double outermost = std::numeric_limits<double>::infinity();

// The distance of two meshes as they are. of_hulls: the same of their hulls, which is kept where the meshes meet.
solid::RoundDistanceEvidence evidence_of(const MeshesOfPair& meshes, const Part& a, const Part& b,
                                         solid::RoundDistanceEvidence of_hulls) {
  const solid::MeshDistance found = mesh_distance(meshes.a, a.pose, meshes.b, b.pose);
  const solid::NearTriangles* const nearest = nearest_of(found);
  if (nearest != nullptr) return nearest->closest;
  return of_hulls;
}

[[maybe_unused]] bool is_margin(double x) { return x >= 0 && x <= std::numeric_limits<double>::max(); }

}  // namespace

Margins::Margins(const ClearanceQuestion& question) : least_(question.least), greatest_(question.least) {
  SUNDER_REQUIRE(is_margin(question.least));
  for (const auto& [a, b, least] : question.margins) {
    SUNDER_REQUIRE(is_margin(least));
    own_[std::minmax(a, b)] = least;
    greatest_ = std::max(greatest_, least);
  }
}

double Margins::of(std::uint32_t body_a, std::uint32_t body_b) const {
  const auto own = own_.find(std::minmax(body_a, body_b));
  return own == own_.end() ? least_ : own->second;
}

bool is_of_meshes(const PartDistance& pair, std::span<const Body> bodies) {
  return meshes_of(bodies[pair.body_a].parts[pair.part_a], bodies[pair.body_b].parts[pair.part_b]).has_value();
}

Box3 widened(const Box3& box, double least) {
  Box3 wide = box;
  for (std::size_t k = 0; k < 3; ++k) {
    wide.low[k] = std::nextafter(box.low[k] - least / 2, -outermost);
    wide.high[k] = std::nextafter(box.high[k] + least / 2, outermost);
  }
  return wide;
}

void look_whether_closer(const Members& members, std::span<const Body> bodies, std::uint32_t i, std::uint32_t j,
                         double least, ClearanceAnswer& answer, std::optional<Point3>* apart_along) {
  SUNDER_REQUIRE(least > 0);
  const Part &a = members.part(bodies, i), &b = members.part(bodies, j);
  const PartPair of = members.pair(i, j);
  solid::RoundCloser found = round_closer(a.shape, a.pose, b.shape, b.pose, least);
  const auto listed_in = [&](std::vector<CloserParts>& list, solid::RoundDistanceEvidence& evidence) {
    const Interval distance = solid::distance_of(evidence);
    list.push_back({{of.body_a, of.body_b, of.part_a, of.part_b, distance, std::move(evidence)}, least});
  };
  if (auto* nearer = std::get_if<solid::Nearer>(&found.evidence)) {
    const auto meshes = meshes_of(a, b);
    if (meshes && !are_meshes_closer(meshes->a, a.pose, meshes->b, b.pose, least)) {
      const bool do_hulls_meet = solid::distance_of(nearer->distance).high == 0;
      answer.surfaces_alone += do_hulls_meet && !(meshes->a.is_closed() && meshes->b.is_closed());
      return;
    }
    if (meshes) nearer->distance = evidence_of(*meshes, a, b, std::move(nearer->distance));
    listed_in(answer.closer, nearer->distance);
  } else if (auto* perhaps = std::get_if<solid::PerhapsNearer>(&found.evidence)) {
    listed_in(answer.undecided, perhaps->distance);
  } else if (apart_along != nullptr) {
    *apart_along = rounded_way(found);
  }
}

PartDistance part_distance(const Members& members, std::span<const Body> bodies, std::uint32_t i, std::uint32_t j,
                           double most) {
  const Part &a = members.part(bodies, i), &b = members.part(bodies, j);
  const PartPair of = members.pair(i, j);
  solid::RoundDistanceEvidence evidence = round_distance(a.shape, a.pose, b.shape, b.pose).evidence;
  Interval distance = solid::distance_of(evidence);
  const auto meshes = distance.low <= most ? meshes_of(a, b) : std::nullopt;
  if (meshes) {
    evidence = evidence_of(*meshes, a, b, std::move(evidence));
    distance = solid::distance_of(evidence);
  }
  return {of.body_a, of.body_b, of.part_a, of.part_b, distance, std::move(evidence)};
}

void complete(const Members& members, ClearanceAnswer& answer) {
  Counts counts;
  counts.by_method = answer.by_method;
  members.complete(counts);
  answer.pairs = counts.pairs;
  answer.allowed = counts.allowed;
  answer.by_boxes = counts.by_boxes;
  for (auto* list : {&answer.closer, &answer.undecided}) std::sort(list->begin(), list->end(), comes_first);
}

}  // namespace sunder::scene
