// Computes where a robot's links and shapes are, for one placement or for many in turn.
// Also called: forward kinematics.
#pragma once

#include <sunder/base/error.h>
#include <sunder/base/lanes.h>
#include <sunder/io/robot/urdf.h>
#include <sunder/solid/object/pose.h>

#include <array>
#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <vector>

namespace sunder::io {

// The value of each joint:
// - given: that value, also beyond the joint's limits (see beyond_limits);
// - not given: 0 if the joint's limits allow it, else the limit nearest to 0;
// - a mimic: multiplier * the followed joint's value + offset, in doubles; its own limits are not looked at, since its
//   file's author chose them together with the multiplier;
// - fixed: 0.
// Turns are computed in doubles with the C library's sine and cosine, whose last bit differs between machines. The
// maps returned are what later answers are exact for.
class RobotMotion {
 public:
  // joints: those that values are given for, in the order of the values; each once. Keeps what it needs of the robot.
  // Requires a robot with the properties U1 to U4 of urdf.h, or several of them one after the other, each a tree. Throws Error bad_call that names the joint: there is none
  // of this name, it is fixed, or it follows another one.
  RobotMotion(const Robot& robot, std::span<const std::string> joints);

  // The maps of all links, each in the frame of its root link, in the order of robot.links; limits are not looked at.
  // Requires as many values as joints, and as many maps as links. Allocates nothing for robots of up to 64 joints.
  // Throws Error bad_call where a value is not finite, or a mimic's value overflows, bad_pose where a map does, naming
  // the joint. All numbers of the maps are finite. A map is a product of rotations up to rounding; the constructor of a
  // pose refuses one that is singular. Cost: linear in links and joints.
  void place(std::span<const double> values, std::span<Affine3> links) const;

  // The values of all joints, in the order of robot.joints. Throws Error bad_call as place does.
  std::vector<double> joint_values(std::span<const double> values) const;

  // The joint of a value, with its limits.
  const Joint& joint_of(std::size_t value) const { return joints_[given_[value]]; }

 private:
  void fill(std::span<const double> values, std::span<double> all) const;

  std::vector<Joint> joints_;
  std::vector<Affine3> origins_;       // of each joint
  std::vector<double> rest_;           // values of joints that none is given for
  std::vector<std::uint32_t> given_;   // of each value its joint
  std::vector<std::uint32_t> mimics_;  // joints that follow others, after those that they follow
  std::vector<std::uint32_t> roots_;   // the links that hang on none
};

// The poses of all links for these values by name, as RobotMotion has them. Throws Error as it does.
std::vector<solid::Pose> link_poses(const Robot& robot, const std::map<std::string, double>& values);

// The joints that values can be given for: all but the fixed ones and those that follow others; in the order of
// robot.joints.
std::vector<std::string> movable_joints(const Robot& robot);

// Which of these values are beyond the limits of their joints, for people: "joint 'elbow' is at 3, beyond its limits
// from -2 to 2". The limits are included. Names that are no joints are left to RobotMotion.
std::vector<std::string> beyond_limits(const Robot& robot, const std::map<std::string, double>& values);

// The pose of a frame within its parent.
solid::Pose origin_pose(const UrdfOrigin& origin);

// The pose of a shape within its link: from the coordinates of the mesh file or of box_corners, scale and origin in
// one.
solid::Pose shape_pose(const CollisionShape& shape);

inline bool is_identity(const Affine3& map) {
  const auto& [m, t] = map;
  const auto at = [&](std::size_t k, double x, double y) { return lanes_at(&m[k]) == Lanes{x, y}; };
  const auto is_left = at(0, 1, 0) & at(2, 0, 0) & at(4, 1, 0) & at(6, 0, 0) & (lanes_at(&t[0]) == Lanes{0, 0}) &
                       (Lanes{m[8], t[2]} == Lanes{1, 0});
  return bits_of(is_left) == 3;
}

// As compose, without the work where one of them is the identity. (The sign of a zero may be another one.)
inline solid::Pose composed(const solid::Pose& outer, const solid::Pose& inner) {
  if (is_identity(outer.affine())) return inner;
  return is_identity(inner.affine()) ? outer : compose(outer, inner);
}

}  // namespace sunder::io
