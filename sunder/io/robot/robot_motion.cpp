#include <sunder/base/contract.h>
#include <sunder/io/robot/joint_values.h>
#include <sunder/io/robot/robot_motion.h>
#include <sunder/io/text/text.h>
#include <sunder/solid/object/affine_product.h>

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

// Maps the child's frame at this value of the joint into its frame at value 0. A rotation is computed in doubles; about
// a coordinate axis its entries are exactly 0, 1, +-sine and cosine.
Affine3 joint_map(const Joint& joint, double value) {
  const auto [x, y, z] = joint.axis;
  switch (joint.type) {
    case JointType::fixed: break;
    case JointType::prismatic: return {Affine3{}.linear, {x * value, y * value, z * value}};
    case JointType::revolute:
    case JointType::continuous: {
      const double c = std::cos(value), s = std::sin(value), d = 1 - c;
      return {{x * x + c * (1 - x * x), x * y * d - z * s, x * z * d + y * s,  //
               x * y * d + z * s, y * y + c * (1 - y * y), y * z * d - x * s,  //
               x * z * d - y * s, y * z * d + x * s, z * z + c * (1 - z * z)},
              {}};
    }
  }
  return {};
}

bool is_finite(const Affine3& map) {
  Lanes zeros{0, 0};  // no zero iff some number is not finite
  const auto& m = map.linear;
  const auto& t = map.translation;
  for (const Lanes lanes : {Lanes{m[0], m[1]}, Lanes{m[2], m[3]}, Lanes{m[4], m[5]}, Lanes{m[6], m[7]},
                            Lanes{m[8], t[0]}, Lanes{t[1], t[2]}}) {
    zeros += 0 * lanes;
  }
  return bits_of(zeros == 0) == 3;
}

// That the robot has no joint of this name, and what to do: which joints can be given a value; and where the name is
// that of a time, or of a joint with a unit that is not read (degrees), that.
std::string no_such_joint(const Robot& robot, const std::string& name) {
  constexpr std::size_t most = 40;
  const std::string word = in_small_letters(name);
  for (const std::string_view time : {"t", "time", "timestamp", "stamp", "sec", "secs", "seconds"}) {
    if (word != time && !(time.size() > 2 && (word.starts_with(time) || word.ends_with(time)))) continue;
    return "the robot has no joint of this name, and times are not read; leave it out";
  }
  const std::vector<std::string> known = movable_joints(robot);
  for (const std::string& joint : known) {
    if (!name.starts_with(joint) || word.find("deg", joint.size()) == std::string::npos) continue;
    return fmt::format(
        "the robot has no joint of this name, and degrees are read in tables only; give radians (degrees times "
        "pi / 180) for {}",
        quote(joint));
  }
  const std::string longer = longer_names(name, known);
  if (!longer.empty()) return fmt::format("the robots have no joint of this name, but {}; give one of these", longer);
  std::string names;
  for (std::size_t k = 0; k < std::min(most, known.size()); ++k) names += (k == 0 ? "" : ", ") + known[k];
  if (known.size() > most) names += fmt::format(" and {} more (see sunder info)", known.size() - most);
  return "the robot has no joint of this name; " +
         (known.empty() ? "none of its joints can be given a value" : "those that can be given a value are " + names);
}

}  // namespace

RobotMotion::RobotMotion(const Robot& robot, std::span<const std::string> joints) : joints_(robot.joints) {
  std::vector<bool> is_child(robot.links.size());
  for (const Joint& joint : joints_) is_child[joint.child] = true;
  for (std::uint32_t link = 0; link < is_child.size(); ++link) {
    if (!is_child[link]) roots_.push_back(link);
  }
  for (const Joint& joint : joints_) {
    origins_.push_back(solid::affine_product(origin_pose(joint.origin).affine(), {}));
    rest_.push_back(joint.type == JointType::fixed ? 0 : std::clamp(0.0, joint.lower, joint.upper));
  }
  for (const std::string& name : joints) {
    const auto found =
        std::find_if(joints_.begin(), joints_.end(), [&](const Joint& joint) { return joint.name == name; });
    if (found == joints_.end()) fail_joint(name, no_such_joint(robot, name));
    if (found->type == JointType::fixed) fail_joint(name, "is fixed; give it no value");
    if (found->mimic) {
      fail_joint(name,
                 fmt::format("follows joint {}; give that one a value", quote(joints_[found->mimic->joint].name)));
    }
    given_.push_back(static_cast<std::uint32_t>(found - joints_.begin()));
  }
  std::vector<bool> is_known(joints_.size());
  std::vector<std::uint32_t> chain;
  for (std::uint32_t joint = 0; joint < joints_.size(); ++joint) {
    for (std::uint32_t i = joint; !is_known[i]; i = joints_[i].mimic->joint) {
      is_known[i] = true;
      if (!joints_[i].mimic) break;
      chain.push_back(i);
    }
    mimics_.insert(mimics_.end(), chain.rbegin(), chain.rend());
    chain.clear();
  }
}

void RobotMotion::fill(std::span<const double> values, std::span<double> all) const {
  SUNDER_REQUIRE(values.size() == given_.size());
  std::copy(rest_.begin(), rest_.end(), all.begin());
  for (std::size_t k = 0; k < values.size(); ++k) {
    if (!std::isfinite(values[k])) fail_joint(joint_of(k).name, "the value is not finite; give a finite number");
    all[given_[k]] = values[k];
  }
  for (const std::uint32_t i : mimics_) {
    const Mimic& mimic = *joints_[i].mimic;
    all[i] = mimic.multiplier * all[mimic.joint] + mimic.offset;
    if (!std::isfinite(all[i])) {
      fail_joint(joints_[i].name, "its value overflows; look at its mimic's multiplier and offset");
    }
  }
}

std::vector<double> RobotMotion::joint_values(std::span<const double> values) const {
  std::vector<double> all(joints_.size());
  fill(values, all);
  return all;
}

void RobotMotion::place(std::span<const double> values, std::span<Affine3> links) const {
  // Few robots have more joints: their values need no memory of the heap.
  constexpr std::size_t usual = 64;
  std::array<double, usual> of_few;
  std::vector<double> of_many(joints_.size() > usual ? joints_.size() : 0);
  const std::span<double> all = of_many.empty() ? std::span<double>(of_few).first(joints_.size()) : std::span(of_many);
  fill(values, all);
  for (const std::uint32_t root : roots_) links[root] = {};
  for (std::size_t i = 0; i < joints_.size(); ++i) {
    const Joint& joint = joints_[i];
    const Affine3 motion =
        joint.type == JointType::fixed ? origins_[i] : solid::affine_product(origins_[i], joint_map(joint, all[i]));
    Affine3& link = links[joint.child];
    link = solid::affine_product(links[joint.parent], motion);
    if (!is_finite(link)) {
      throw Error(ErrorCode::bad_pose, "its pose overflows; give smaller numbers", "joint " + quote(joint.name));
    }
  }
}

std::vector<Pose> link_poses(const Robot& robot, const std::map<std::string, double>& values) {
  std::vector<std::string> joints;
  std::vector<double> numbers;
  for (const auto& [name, value] : values) {
    joints.push_back(name);
    numbers.push_back(value);
  }
  std::vector<Affine3> links(robot.links.size());
  RobotMotion(robot, joints).place(numbers, links);
  std::vector<Pose> poses;
  for (const Affine3& link : links) poses.push_back(Pose::from_matrix(link.linear, link.translation));
  return poses;
}

std::vector<std::string> movable_joints(const Robot& robot) {
  std::vector<std::string> names;
  for (const Joint& joint : robot.joints) {
    if (joint.type != JointType::fixed && !joint.mimic) names.push_back(joint.name);
  }
  return names;
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
