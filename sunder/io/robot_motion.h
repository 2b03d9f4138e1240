// Where a robot's links are, for one placement after another: urdf_kinematics.h made ready for thousands of them.
// Also called: forward kinematics.
#pragma once

#include <sunder/base/error.h>
#include <sunder/io/urdf.h>
#include <sunder/solid/object/pose.h>

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace sunder::io {

class RobotMotion {
 public:
  // joints: those that values are given for, in the order of the values; each once. Keeps what it needs of the robot.
  // Requires a robot with the properties U1 to U4 of urdf.h. Throws Error bad_call that names the joint: there is none
  // of this name, it is fixed, or it follows another one.
  RobotMotion(const Robot& robot, std::span<const std::string> joints);

  // The poses of all links, as link_poses of urdf_kinematics.h has them for the same values, bit by bit but for the
  // signs of zeros; limits are not looked at. Requires as many values as joints, each finite, and as many poses as
  // links. Allocates nothing for robots of up to 64 joints. Throws Error bad_call where a mimic's value overflows,
  // bad_pose where a pose does, naming the joint.
  void place(std::span<const double> values, std::span<solid::Pose> links) const;

  // The joint of a value, with its limits.
  const Joint& joint_of(std::size_t value) const { return joints_[given_[value]]; }

 private:
  std::vector<Joint> joints_;
  std::vector<Affine3> origins_;       // of each joint
  std::vector<double> rest_;           // values of joints that none is given for
  std::vector<std::uint32_t> given_;   // of each value its joint
  std::vector<std::uint32_t> mimics_;  // joints that follow others, after those that they follow
  std::uint32_t root_ = 0;             // the link that hangs on none
};

// As compose, without the work where one of them is the identity. (The sign of a zero may be another one.)
inline solid::Pose composed(const solid::Pose& outer, const solid::Pose& inner) {
  if (outer.affine() == Affine3{}) return inner;
  return inner.affine() == Affine3{} ? outer : compose(outer, inner);
}

// The joints that values can be given for: all but the fixed ones and those that follow others; in the order of
// robot.joints.
std::vector<std::string> movable_joints(const Robot& robot);

}  // namespace sunder::io
