// Where a robot's links and shapes are.
// Also called: forward kinematics.
#pragma once

#include <sunder/base/error.h>
#include <sunder/io/urdf.h>
#include <sunder/solid/object/pose.h>

#include <map>
#include <string>
#include <vector>

namespace sunder::io {

// The value of each joint, in the order of robot.joints:
// - given in `values` by the joint's name: that value, also beyond the joint's limits (see beyond_limits);
// - not given: 0 if the joint's limits allow it, else the limit nearest to 0;
// - a mimic: multiplier * the followed joint's value + offset, in doubles; its own limits are not looked at, since its
//   file's author chose them together with the multiplier;
// - fixed: 0.
// Throws Error bad_call that names the joint: there is none of this name, it is fixed or follows another one, the value
// is not finite. And when a mimic's value overflows.
std::vector<double> joint_values(const Robot& robot, const std::map<std::string, double>& values);

// That the robot has no joint of this name, and what to do: which joints can be given a value; and where the name is
// that of a time, or of a joint with a unit that is not read (degrees), that.
std::string no_such_joint(const Robot& robot, const std::string& name);

// Which of these values are beyond the limits of their joints, for people: "joint 'elbow' is at 3, beyond its limits
// from -2 to 2". The limits are included. Names that are no joints are left to joint_values.
std::vector<std::string> beyond_limits(const Robot& robot, const std::map<std::string, double>& values);

// The pose of each link in the frame of the root link, in the order of robot.links; the root's is the identity.
// Turns are computed in doubles with the C library's sine and cosine, whose last bit differs between machines. The
// poses returned are what later answers are exact for. Requires a robot with the properties U1 to U4 of urdf.h. Throws
// Error bad_call as joint_values does, bad_pose naming the joint when a pose overflows. Cost: linear in links and
// joints.
std::vector<solid::Pose> link_poses(const Robot& robot, const std::map<std::string, double>& values);

// The pose of a frame within its parent.
solid::Pose origin_pose(const UrdfOrigin& origin);

// The pose of a shape within its link: from the coordinates of the mesh file or of box_corners, scale and origin in
// one.
solid::Pose shape_pose(const CollisionShape& shape);

// Where a joint of this value has its child, within its frame at value 0.
solid::Pose joint_motion(const Joint& joint, double value);

}  // namespace sunder::io
