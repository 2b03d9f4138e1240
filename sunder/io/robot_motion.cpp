#include <sunder/base/contract.h>
#include <sunder/io/joint_map.h>
#include <sunder/io/robot_motion.h>
#include <sunder/io/text.h>
#include <sunder/io/urdf_kinematics.h>
#include <sunder/solid/object/affine_product.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace sunder::io {

namespace {

[[noreturn]] void fail_joint(const std::string& name, const std::string& text) {
  throw Error(ErrorCode::bad_call, text, "joint " + quote(name));
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

}  // namespace

RobotMotion::RobotMotion(const Robot& robot, std::span<const std::string> joints)
    : joints_(robot.joints), root_(robot.root) {
  for (const Joint& joint : joints_) {
    origins_.push_back(origin_pose(joint.origin).affine());
    rest_.push_back(joint.type == JointType::fixed ? 0 : std::clamp(0.0, joint.lower, joint.upper));
  }
  for (const std::string& name : joints) {
    const auto found =
        std::find_if(joints_.begin(), joints_.end(), [&](const Joint& joint) { return joint.name == name; });
    if (found == joints_.end()) {
      fail_joint(name, no_such_joint(robot, name));
    }
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

void RobotMotion::place(std::span<const double> values, std::span<Affine3> links) const {
  SUNDER_REQUIRE(values.size() == given_.size());
  // Few robots have more joints: their values need no memory of the heap.
  constexpr std::size_t usual = 64;
  std::array<double, usual> of_few;
  std::vector<double> of_many(joints_.size() > usual ? joints_.size() : 0);
  const std::span<double> all = of_many.empty() ? std::span<double>(of_few).first(joints_.size()) : std::span(of_many);
  std::copy(rest_.begin(), rest_.end(), all.begin());
  for (std::size_t k = 0; k < values.size(); ++k) all[given_[k]] = values[k];
  for (const std::uint32_t i : mimics_) {
    const Mimic& mimic = *joints_[i].mimic;
    all[i] = mimic.multiplier * all[mimic.joint] + mimic.offset;
    if (!std::isfinite(all[i])) {
      fail_joint(joints_[i].name, "its value overflows; look at its mimic's multiplier and offset");
    }
  }
  links[root_] = {};
  for (std::size_t i = 0; i < joints_.size(); ++i) {
    const Joint& joint = joints_[i];
    const Affine3 motion =
        joint.type == JointType::fixed ? origins_[i] : solid::affine_product(origins_[i], joint_map(joint, all[i]));
    Affine3& link = links[joint.child];
    link = joint.parent == root_ ? motion : solid::affine_product(links[joint.parent], motion);
    if (!is_finite(link)) {
      throw Error(ErrorCode::bad_pose, "its pose overflows; give smaller numbers", "joint " + quote(joint.name));
    }
  }
}

std::vector<std::string> movable_joints(const Robot& robot) {
  std::vector<std::string> names;
  for (const Joint& joint : robot.joints) {
    if (joint.type != JointType::fixed && !joint.mimic) names.push_back(joint.name);
  }
  return names;
}

}  // namespace sunder::io
