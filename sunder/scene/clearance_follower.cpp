#include <sunder/base/contract.h>
#include <sunder/near/box_sweep.h>
#include <sunder/scene/clearance_follower.h>
#include <sunder/scene/part_questions.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

namespace sunder::scene {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

// Cylinders and cones are within their radius of their axis.
double radius_about_core(const solid::RoundBody& shape) {
  return shape.kind() == RoundKind::ellipsoid ? infinity : shape.radius();
}

// Not less than the sum.
double sum_above(double x, double y) { return x == 0 ? y : y == 0 ? x : std::nextafter(x + y, infinity); }

}  // namespace

ClearanceFollower::ClearanceFollower(std::span<const Body> bodies, const ClearanceQuestion& question)
    : members_(bodies, question.allowed), margins_(question), boxes_(members_.size()), wide_(members_.size()) {
  for (std::uint32_t i = 0; i < members_.size(); ++i) {
    const solid::RoundBody& shape = members_.part(bodies, i).shape;
    rigid_.emplace_back(shape.core());
    radii_.push_back(radius_about_core(shape));
  }
}

// What rests has its box.
void ClearanceFollower::place(std::span<const Body> bodies) {
  for (std::uint32_t i = 0; i < members_.size(); ++i) {
    const Part& part = members_.part(bodies, i);
    if (is_placed_ && part.pose.affine() == rigid_[i].pose) continue;
    require_rigid(part.shape, part.pose);
    rigid_[i].place(part.pose);
    boxes_[i] = rough_box_of(part);
    wide_[i] = widened(boxes_[i], margins_.greatest());
  }
  is_placed_ = true;
}

ClearanceFollower::Near& ClearanceFollower::near(std::uint32_t i, std::uint32_t j) {
  const auto [at, is_new] = near_.try_emplace(std::uint64_t{i} << 32 | j);
  Near& near = at->second;
  if (is_new) {
    near.least = margins_.of(members_.body(i), members_.body(j));
    near.needed = sum_above(near.least, sum_above(radii_[i], radii_[j]));
  }
  return near;
}

ClearanceAnswer ClearanceFollower::ask(std::span<const Body> bodies) {
  place(bodies);
  ClearanceAnswer answer;
  for (const auto& [i, j] : meeting_boxes(std::span<const Box3>(wide_))) {
    if (!members_.are_asked_about(i, j)) continue;
    Near& known = near(i, j);
    if (known.least == 0 || apart_by_boxes(boxes_[i], boxes_[j], known.least)) continue;
    ++answer.by_method;
    if (part_again(rigid_[i], rigid_[j], known.kept, known.needed)) continue;
    ++looks_;
    std::optional<Point3> way;
    look_whether_closer(members_, bodies, i, j, known.least, answer, &way);
    if (way && std::isfinite(known.needed)) keep_parting_of_world(rigid_[i], *way, known.kept);
  }
  complete(members_, answer);
  return answer;
}

}  // namespace sunder::scene
