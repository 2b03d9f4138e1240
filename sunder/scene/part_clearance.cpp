#include <sunder/base/contract.h>
#include <sunder/scene/part_clearance.h>
#include <sunder/scene/part_questions.h>
#include <sunder/scene/parts_as_meshes.h>
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
  return PartsAsMeshes::of(bodies[pair.body_a].parts[pair.part_a], bodies[pair.body_b].parts[pair.part_b]).has_value();
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
  auto* const nearer = std::get_if<solid::Nearer>(&found.evidence);
  auto* const perhaps = std::get_if<solid::PerhapsNearer>(&found.evidence);
  if (nearer != nullptr || perhaps != nullptr) {
    solid::RoundDistanceEvidence& evidence = nearer != nullptr ? nearer->distance : perhaps->distance;
    Verdict verdict = nearer != nullptr ? Verdict::meet : Verdict::undecided;
    if (const auto parts = PartsAsMeshes::of(a, b)) {
      verdict = parts->clearance(least);
      if (verdict == Verdict::apart) {
        answer.surfaces_alone += solid::distance_of(evidence).low == 0 && !parts->are_closed();
        return;
      }
      if (auto as_they_are = parts->distance()) evidence = *std::move(as_they_are);
    }
    listed_in(verdict == Verdict::meet ? answer.closer : answer.undecided, evidence);
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
  const auto parts = distance.low <= most ? PartsAsMeshes::of(a, b) : std::nullopt;
  if (parts) {
    if (auto as_they_are = parts->distance()) evidence = *std::move(as_they_are);
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
