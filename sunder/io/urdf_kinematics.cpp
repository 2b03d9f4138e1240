#include <sunder/base/error.h>
#include <sunder/io/joint_map.h>
#include <sunder/io/robot_motion.h>
#include <sunder/io/text.h>
#include <sunder/io/urdf_kinematics.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string_view>

namespace sunder::io {
namespace {

using solid::Pose;

[[noreturn]] void fail_joint(const std::string& name, const std::string& text) {
  throw Error(ErrorCode::bad_call, text, "joint " + quote(name));
}

void check_given(const Robot& robot, const std::string& name, double value) {
  const auto found =
      std::find_if(robot.joints.begin(), robot.joints.end(), [&](const Joint& joint) { return joint.name == name; });
  if (found == robot.joints.end()) fail_joint(name, no_such_joint(robot, name));
  if (found->type == JointType::fixed) fail_joint(name, "is fixed; give it no value");
  if (found->mimic) {
    fail_joint(name,
               fmt::format("follows joint {}; give that one a value", quote(robot.joints[found->mimic->joint].name)));
  }
  if (!std::isfinite(value)) fail_joint(name, "the value is not finite; give a finite number");
}

double own_value(const Joint& joint, const std::map<std::string, double>& values) {
  if (joint.type == JointType::fixed) return 0;
  const auto given = values.find(joint.name);
  return given != values.end() ? given->second : std::clamp(0.0, joint.lower, joint.upper);
}

}  // namespace

solid::Pose joint_motion(const Joint& joint, double value) {
  const Affine3 map = joint_map(joint, value);
  return Pose::from_matrix(map.linear, map.translation);
}

std::vector<double> joint_values(const Robot& robot, const std::map<std::string, double>& values) {
  for (const auto& [name, value] : values) check_given(robot, name, value);
  std::vector<double> all(robot.joints.size());
  std::vector<bool> known(robot.joints.size());
  std::vector<std::uint32_t> followers;  // a chain of mimics, whose values are known from its end
  for (std::uint32_t joint = 0; joint < robot.joints.size(); ++joint) {
    std::uint32_t i = joint;
    for (; !known[i] && robot.joints[i].mimic; i = robot.joints[i].mimic->joint) followers.push_back(i);
    if (!known[i]) all[i] = own_value(robot.joints[i], values);
    known[i] = true;
    for (; !followers.empty(); followers.pop_back()) {
      const std::uint32_t follower = followers.back();
      const Joint& follows = robot.joints[follower];
      all[follower] = follows.mimic->multiplier * all[follows.mimic->joint] + follows.mimic->offset;
      known[follower] = true;
      if (!std::isfinite(all[follower])) {
        fail_joint(follows.name, "its value overflows; look at its mimic's multiplier and offset");
      }
    }
  }
  return all;
}

std::string no_such_joint(const Robot& robot, const std::string& name) {
  constexpr std::size_t most = 40;
  const std::string word = in_small_letters(name);
  for (const std::string_view time : {"t", "time", "timestamp", "stamp", "sec", "secs", "seconds"}) {
    if (word != time && !(time.size() > 2 && (word.starts_with(time) || word.ends_with(time)))) continue;
    return "the robot has no joint of this name, and times are not read; leave out this column";
  }
  const std::vector<std::string> known = movable_joints(robot);
  for (const std::string& joint : known) {
    if (!name.starts_with(joint) || word.find("deg", joint.size()) == std::string::npos) continue;
    return fmt::format(
        "the robot has no joint of this name, and degrees are not read; give radians (degrees times pi / 180), and "
        "name the column {}",
        quote(joint));
  }
  std::string names;
  for (std::size_t k = 0; k < std::min(most, known.size()); ++k) names += (k == 0 ? "" : ", ") + known[k];
  if (known.size() > most) names += fmt::format(" and {} more (see sunder info)", known.size() - most);
  return "the robot has no joint of this name; " +
         (known.empty() ? "none of its joints can be given a value" : "those that can be given a value are " + names);
}

std::vector<std::string> beyond_limits(const Robot& robot, const std::map<std::string, double>& values) {
  std::vector<std::string> texts;
  for (const Joint& joint : robot.joints) {
    const auto given = values.find(joint.name);
    if (given == values.end() || (joint.lower <= given->second && given->second <= joint.upper)) continue;
    texts.push_back(fmt::format("joint {} is at {}, beyond its limits from {} to {}", quote(joint.name), given->second,
                                joint.lower, joint.upper));
  }
  return texts;
}

std::vector<Pose> link_poses(const Robot& robot, const std::map<std::string, double>& values) {
  const std::vector<double> all = joint_values(robot, values);
  std::vector<Pose> poses(robot.links.size());
  for (std::size_t i = 0; i < robot.joints.size(); ++i) {
    const Joint& joint = robot.joints[i];
    try {
      poses[joint.child] =
          compose(poses[joint.parent], compose(origin_pose(joint.origin), joint_motion(joint, all[i])));
    } catch (const Error& error) {
      throw Error(error.code(), error.what(), "joint " + quote(joint.name));
    }
  }
  return poses;
}

Pose origin_pose(const UrdfOrigin& origin) {
  const double cr = std::cos(origin.rpy[0]), sr = std::sin(origin.rpy[0]);
  const double cp = std::cos(origin.rpy[1]), sp = std::sin(origin.rpy[1]);
  const double cy = std::cos(origin.rpy[2]), sy = std::sin(origin.rpy[2]);
  return Pose::from_matrix({cy * cp, cy * sp * sr - sy * cr, cy * sp * cr + sy * sr,  //
                            sy * cp, sy * sp * sr + cy * cr, sy * sp * cr - cy * sr,  //
                            -sp, cp * sr, cp * cr},
                           origin.xyz);
}

Pose shape_pose(const CollisionShape& shape) {
  const Pose scale = Pose::from_matrix({shape.scale[0], 0, 0, 0, shape.scale[1], 0, 0, 0, shape.scale[2]}, {0, 0, 0});
  return compose(origin_pose(shape.origin), scale);
}

}  // namespace sunder::io
