// What clearances ask of two parts: how far apart they have to be, and whether they are.
#pragma once

#include <sunder/base/error.h>
#include <sunder/predicate/point.h>
#include <sunder/scene/clearance.h>
#include <sunder/scene/members.h>
#include <sunder/scene/scene.h>

#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <tuple>
#include <utility>

namespace sunder::scene {

// By pairs of bodies, in any order.
class Margins {
 public:
  // Requires distances that are finite, and not negative.
  explicit Margins(const ClearanceQuestion& question);

  double of(std::uint32_t body_a, std::uint32_t body_b) const;
  double greatest() const { return greatest_; }

 private:
  double least_, greatest_;
  std::map<std::pair<std::uint32_t, std::uint32_t>, double> own_;
};

// The box, wider by half of that distance on each side, rounded outwards: boxes of parts that are closer than that have
// a common point.
Box3 widened(const Box3& box, double least);

// Are the parts i and j closer than `least`? Where they are, or that is undecided, they are listed, with their
// distance. Where they are not, `apart_along`, unless nullptr, becomes a direction from the first to the second along
// which they are that far apart, rounded. Requires i < j, least > 0. Throws Error: bad_pose (round_body.h). Cost: that
// of their distance, and half of that for the direction.
void look_whether_closer(const Members& members, std::span<const Body> bodies, std::uint32_t i, std::uint32_t j,
                         double least, ClearanceAnswer& answer, std::optional<Point3>* apart_along = nullptr);

// How far apart the parts i < j are. Their meshes are only looked at where the hulls are no further apart than `most`.
PartDistance part_distance(const Members& members, std::span<const Body> bodies, std::uint32_t i, std::uint32_t j,
                           double most);

// The order of pairs (clearance.h, C3).
inline bool comes_first(const PartDistance& p, const PartDistance& q) {
  return std::tie(p.body_a, p.body_b, p.part_a, p.part_b) < std::tie(q.body_a, q.body_b, q.part_a, q.part_b);
}

// Brings the lists into order (clearance.h, C3), and says how many pairs there are; what is counted as by_method stands
// there, the rest is by boxes.
void complete(const Members& members, ClearanceAnswer& answer);

}  // namespace sunder::scene
