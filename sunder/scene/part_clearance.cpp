#include <sunder/base/contract.h>
#include <sunder/predicate/point/along.h>
#include <sunder/predicate/point/shortest_way.h>
#include <sunder/scene/part_clearance.h>
#include <sunder/scene/part_questions.h>
#include <sunder/solid/pair/polyhedron_polyhedron_distance.h>
#include <sunder/solid/round/round_clearance.h>
#include <sunder/solid/round/round_distance.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <tuple>
#include <utility>

namespace sunder::scene {

namespace {

constexpr double outermost = std::numeric_limits<double>::infinity();

[[maybe_unused]] bool is_margin(double x) { return x >= 0 && x <= std::numeric_limits<double>::max(); }

enum class Nearer : std::uint8_t { no, yes, undecided };

Point3 rounded(const WorldDirection& direction) {
  const Vector3<Interval> enclosed = direction.enclosure();
  return {enclosed.x.low, enclosed.y.low, enclosed.z.low};
}

// From A to B. Mostly intervals tell it; else it costs exact numbers.
Point3 rounded_way(const solid::ClosestFeatures& closest) {
  const solid::FeatureVertices& of = closest.features();
  const std::array<Posed3, 4> images = closest.images();
  const std::span<const Posed3> all(images);
  const EnclosedWay enclosed = enclosed_way(all.first(of.count_a), all.subspan(of.count_a, of.count_b));
  if (enclosed.weights == Guess::positive) return {enclosed.way.x.low, enclosed.way.y.low, enclosed.way.z.low};
  return rounded(WorldDirection(closest.way().way.way));
}

// Of two polyhedra: their distance tells.
Nearer look_at_polyhedra(PartDistance& pair, const Part& a, const Part& b, std::optional<Point3>* apart_along) {
  const solid::PolyhedronDistance found =
      polyhedron_polyhedron_distance(a.shape.core(), a.pose, b.shape.core(), b.pose);
  if (compare_distance(found, pair.least) == Sign::negative) {
    pair.distance = found.distance();
    pair.closest = found.closest;
    return Nearer::yes;
  }
  if (apart_along != nullptr) *apart_along = rounded_way(*found.closest);
  return Nearer::no;
}

// Of others.
Nearer look_at_round(PartDistance& pair, const Part& a, const Part& b, std::optional<Point3>* apart_along) {
  const solid::PlacedRound in_a(a.shape, a.pose), in_b(b.shape, b.pose);
  const solid::RoundClearance found = round_clearance(in_a, in_b, pair.least);
  if (found.kept()) {
    if (apart_along != nullptr) *apart_along = rounded(*found.direction);
    return Nearer::no;
  }
  const solid::RoundDistance distance = round_distance(in_a, in_b);
  if (found.undecided() && distance.distance.low >= pair.least) return Nearer::no;
  pair.distance = distance.distance;
  if (!distance.meet()) pair.points = distance.points;
  return found.broken() || distance.distance.high < pair.least ? Nearer::yes : Nearer::undecided;
}

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
  PartDistance pair{of.body_a, of.body_b, of.part_a, of.part_b, least};
  const Nearer nearer = are_polyhedra(a, b) ? look_at_polyhedra(pair, a, b, apart_along)  //
                                            : look_at_round(pair, a, b, apart_along);
  if (nearer == Nearer::no) return;
  (nearer == Nearer::yes ? answer.closer : answer.undecided).push_back(std::move(pair));
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
