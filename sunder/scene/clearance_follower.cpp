#include <sunder/base/contract.h>
#include <sunder/near/box_sweep.h>
#include <sunder/scene/clearance_follower.h>
#include <sunder/scene/part_questions.h>
#include <sunder/solid/round/world_box.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

namespace sunder::scene {

namespace {

constexpr double unbounded = std::numeric_limits<double>::infinity();

// Not less than the sum.
double sum_above(double x, double y) { return x == 0 ? y : y == 0 ? x : std::nextafter(x + y, unbounded); }

// At least so far, along an axis? A difference that is less than `least` is not rounded to more than that.
bool are_apart(const Box3& a, const Box3& b, double least) {
  const auto along = [&](std::size_t k) { return b.low[k] - a.high[k] > least || a.low[k] - b.high[k] > least; };
  return along(0) || along(1) || along(2);
}

}  // namespace

ClearanceFollower::ClearanceFollower(std::span<const Body> bodies, const ClearanceQuestion& question)
    : members_(bodies, question.allowed), margins_(question), boxes_(members_.size()) {
  rigid_.reserve(members_.size());
  radii_.reserve(members_.size());
  for (std::uint32_t i = 0; i < members_.size(); ++i) {
    const solid::RoundBody& shape = members_.part(bodies, i).shape;
    rigid_.emplace_back(shape.core());
    radii_.push_back(reach_beyond_core(shape));
  }
  list_few();
}

ClearanceFollower::Near ClearanceFollower::near(std::uint32_t i, std::uint32_t j) const {
  const double least = margins_.of(members_.body(i), members_.body(j));
  return {i, j, least, sum_above(least, sum_above(radii_[i], radii_[j]))};
}

void ClearanceFollower::list_few() {
  Counts counts;
  members_.complete(counts);
  // Of more parts than that, to look through their pairs for those few would cost more.
  is_few_ = counts.pairs - counts.allowed <= few && members_.size() <= 2 * few;
  if (!is_few_) return;
  for (std::uint32_t i = 0; i < members_.size(); ++i) {
    for (std::uint32_t j = i + 1; j < members_.size(); ++j) {
      if (members_.are_asked_about(i, j)) near_.push_back(near(i, j));
    }
  }
}

// What rests has its box: a part that throws has none for this pose, so it is placed last.
void ClearanceFollower::place(std::span<const Body> bodies) {
  for (std::uint32_t i = 0; i < members_.size(); ++i) {
    const Part& part = members_.part(bodies, i);
    if (is_placed_ && part.pose.affine() == rigid_[i].pose) continue;
    require_rigid(part.shape, part.pose);
    boxes_[i] = rough_box_of(part);
    rigid_[i].place(part.pose);
  }
  is_placed_ = true;
}

void ClearanceFollower::look_at(Near& pair, std::span<const Body> bodies, ClearanceAnswer& answer) {
  const std::uint32_t i = pair.i, j = pair.j;
  const double least = pair.least, needed = pair.needed;
  if (least == 0 || are_apart(boxes_[i], boxes_[j], least)) return;
  ++answer.by_method;
  if (part_again(rigid_[i], rigid_[j], pair.kept, needed)) return;
  ++looks_;
  std::optional<Point3> way;
  look_whether_closer(members_, bodies, i, j, least, answer, &way);
  if (way && std::isfinite(needed)) keep_parting_of_world(rigid_[i], *way, pair.kept);
}

ClearanceAnswer ClearanceFollower::ask(std::span<const Body> bodies) {
  place(bodies);
  ClearanceAnswer answer;
  if (is_few_) {
    for (Near& pair : near_) look_at(pair, bodies, answer);
  } else {
    std::vector<Box3> wide;
    for (const Box3& box : boxes_) wide.push_back(widened(box, margins_.greatest()));
    for (const auto& [i, j] : meeting_boxes(std::span<const Box3>(wide))) {
      if (!members_.are_asked_about(i, j)) continue;
      const auto [at, is_new] =
          places_.try_emplace(std::uint64_t{i} << 32 | j, static_cast<std::uint32_t>(near_.size()));
      if (is_new) near_.push_back(near(i, j));
      look_at(near_[at->second], bodies, answer);
    }
  }
  complete(members_, answer);
  return answer;
}

}  // namespace sunder::scene
