// Any bytes, read as URDF and as SRDF. Seeds: cases/mesh, cases/broken, cases/panda, cases/scene.
#include <fuzz/mesh_fuzz.h>
#include <sunder/io/robot/robot_motion.h>
#include <sunder/io/robot/srdf.h>
#include <sunder/io/robot/urdf.h>

#include <cmath>
#include <set>

namespace {

using sunder::fuzz::require;

// The properties U1 to U4 of urdf.h.
void check(const sunder::io::Robot& robot) {
  std::set<std::string> names;
  for (const auto& link : robot.links) require(!link.name.empty() && names.insert(link.name).second, "names of links");
  require(robot.joints.size() + 1 == robot.links.size(), "the number of joints");
  std::vector<bool> placed(robot.links.size());
  placed.at(robot.root) = true;
  for (const auto& joint : robot.joints) {
    require(placed.at(joint.parent) && !placed.at(joint.child), "the order of joints");
    placed[joint.child] = true;
    require(joint.lower <= joint.upper, "the limits");
    const double length = std::hypot(joint.axis[0], joint.axis[1], joint.axis[2]);
    require(std::abs(length - 1) < 1e-9, "the length of the axis");
    if (joint.mimic) require(joint.mimic->joint < robot.joints.size(), "the mimic");
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  constexpr std::string_view file = "fuzz";
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  try {
    for (const auto& pair : sunder::io::parse_srdf(bytes, file).disabled) require(pair.links[0] != pair.links[1], "S2");
  } catch (const sunder::Error& error) {
    sunder::fuzz::check_message(error, file);
  }
  sunder::io::Robot robot;
  try {
    robot = sunder::io::parse_urdf(bytes, file);
  } catch (const sunder::Error& error) {
    sunder::fuzz::check_message(error, file);
    return 0;
  }
  check(robot);
  try {
    require(sunder::io::link_poses(robot, {}).size() == robot.links.size(), "the number of poses");
    for (const auto& link : robot.links) {
      for (const auto& shape : link.shapes) sunder::io::shape_pose(shape);
    }
  } catch (const sunder::Error&) {  // an overflow
  }
  return 0;
}
