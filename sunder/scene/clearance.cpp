#include <sunder/base/contract.h>
#include <sunder/near/box_sweep.h>
#include <sunder/near/box_tree.h>
#include <sunder/number/interval.h>
#include <sunder/scene/clearance.h>
#include <sunder/scene/members.h>
#include <sunder/scene/part_clearance.h>
#include <sunder/scene/part_questions.h>
#include <sunder/solid/round/round_distance.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>
#include <utility>
#include <variant>

namespace sunder::scene {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

// The same for every rounding: a double below, or above.
double below(double x) { return std::nextafter(x, -infinity); }
double above(double x) { return std::nextafter(x, infinity); }

// No points of the boxes are closer than this along axis k; not positive where they overlap there.
double gap_along(const Box3& a, const Box3& b, std::size_t k) {
  const double gap = std::max(a.low[k] - b.high[k], b.low[k] - a.high[k]);
  return std::isnan(gap) ? -infinity : below(gap);
}

// The square of what no points of the boxes are closer than, rounded down.
double squared_gap(const Box3& a, const Box3& b) {
  double sum = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const double gap = std::max(0.0, gap_along(a, b, k));
    sum = std::max(0.0, below(sum + std::max(0.0, below(gap * gap))));
  }
  return sum;
}

// The square of what no points of the boxes are further apart than, rounded up.
double squared_reach(const Box3& a, const Box3& b) {
  double sum = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const double reach = above(std::max(a.high[k] - b.low[k], b.high[k] - a.low[k]));
    sum = above(sum + above(reach * reach));
  }
  return std::isnan(sum) ? infinity : sum;
}

// Is `one` nearer? Exactly; where one is curved, and the bounds do not tell, is its upper bound less?
bool is_nearer(const PartDistance& one, const PartDistance& other) {
  if (one.meet() || other.meet()) return one.meet() && !other.meet();
  const Interval &p = one.distance, &q = other.distance;
  if (p.high < q.low || q.high < p.low) return p.high < q.low;
  return solid::is_nearer(one.evidence, other.evidence).value_or(p.high < q.high);
}

}  // namespace

ClearanceAnswer closer_pairs(std::span<const Body> bodies, const ClearanceQuestion& question) {
  const Members members(bodies, question.allowed);
  const Margins margins(question);
  std::vector<solid::WorldBox> boxes;
  std::vector<Box3> wide;
  for (std::uint32_t i = 0; i < members.size(); ++i) {
    wide.push_back(widened(boxes.emplace_back(box_of(members.part(bodies, i))), margins.greatest()));
  }
  ClearanceAnswer answer;
  for (const auto& [i, j] : meeting_boxes(std::span<const Box3>(wide))) {
    if (!members.are_asked_about(i, j)) continue;
    const double least = margins.of(members.body(i), members.body(j));
    if (least == 0 || apart_by_boxes(boxes[i], boxes[j], least)) continue;
    ++answer.by_method;
    look_whether_closer(members, bodies, i, j, least, answer);
  }
  complete(members, answer);
  return answer;
}

std::optional<PartDistance> nearest_parts(std::span<const Body> bodies,
                                          std::vector<std::array<std::uint32_t, 2>> allowed, std::uint64_t* looks) {
  const Members members(bodies, std::move(allowed));
  const std::vector<std::uint32_t> groups = members.bodies();
  std::vector<Box3> boxes;
  for (std::uint32_t i = 0; i < members.size(); ++i) boxes.push_back(box_of(members.part(bodies, i)));
  const BoxTree tree(boxes, groups);
  struct Candidate {
    double squared = infinity;
    std::uint32_t i = 0, j = 0;  // i < j
  };
  const auto comes_before = [&](const Candidate& p, const Candidate& q) {  // of equal ones, as the pairs of bodies do
    const auto key = [&](const Candidate& c) {
      return std::tuple(c.squared, members.body(c.i), members.body(c.j), c.i, c.j);
    };
    return key(p) < key(q);
  };
  // Of the pairs that are asked about, twice each: those whose boxes are, squared, no further apart than `most`, which
  // may become less meanwhile.
  const auto for_each_pair = [&](const double& most, const auto& of_pair) {
    for (const std::uint32_t i : tree.order()) {
      const auto gap = [&](const Box3& box) { return squared_gap(boxes[i], box); };
      const std::uint64_t seen = tree.for_each_near(groups[i], gap, most, [&](std::uint32_t j, double squared) {
        const Candidate here{squared, std::min(i, j), std::max(i, j)};
        if (members.are_asked_about(here.i, here.j)) of_pair(here, i < j);
      });
      if (looks != nullptr) *looks += seen;
    }
  };
  std::optional<Candidate> first;  // whose boxes are nearest
  double least = infinity;
  for_each_pair(least, [&](const Candidate& here, bool) {
    if (!first || comes_before(here, *first)) first = here;
    least = first->squared;
  });
  if (!first) return std::nullopt;
  PartDistance nearest = part_distance(members, bodies, first->i, first->j, infinity);
  if (nearest.meet()) return nearest;  // of all whose boxes meet, the first one
  const auto bound = [&] { return above(nearest.distance.high * nearest.distance.high); };  // of the square, rounded up
  // The boxes of the first may have much more room than others (one around all bodies, say).
  double most = bound();
  for_each_pair(
      most, [&](const Candidate& here, bool) { most = std::min(most, squared_reach(boxes[here.i], boxes[here.j])); });
  std::vector<Candidate> candidates;
  for_each_pair(most, [&](const Candidate& here, bool is_new) {
    if (is_new && (here.i != first->i || here.j != first->j)) candidates.push_back(here);
  });
  std::sort(candidates.begin(), candidates.end(), comes_before);
  double low = nearest.distance.low;  // of all that were looked at
  for (const Candidate& here : candidates) {
    if (here.squared > bound()) break;
    PartDistance found = part_distance(members, bodies, here.i, here.j, nearest.distance.high);
    low = std::min(low, found.distance.low);
    const bool is_first = comes_first(found, nearest);
    if (is_nearer(found, nearest) || (is_first && !is_nearer(nearest, found))) {
      nearest = std::move(found);
    }
    if (nearest.meet()) break;  // those that meet come in their order
  }
  nearest.distance.low = low;
  return nearest;
}

std::optional<AxisApart> apart_by_boxes(const Box3& a, const Box3& b, double least) {
  SUNDER_REQUIRE(least > 0);
  for (std::size_t k = 0; k < 3; ++k) {
    if (gap_along(a, b, k) >= least) return AxisApart{k, a.high[k] < b.low[k]};
  }
  return std::nullopt;
}

}  // namespace sunder::scene
