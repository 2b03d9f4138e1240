// The bodies that the links of a robot stand for: their shapes read, each with its place in the link.
#pragma once

#include <sunder/base/error.h>
#include <sunder/io/mesh/mesh_body.h>
#include <sunder/io/robot/packages.h>
#include <sunder/io/robot/urdf.h>
#include <sunder/scene/scene.h>
#include <sunder/solid/object/pose.h>
#include <sunder/solid/round/round_body.h>

#include <array>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace sunder::io {

struct BodyPart {
  std::string name;
  MeshBody body;
  solid::Pose pose;  // within the link

  // A sphere, a cylinder, a capsule, which is what is meant; `body` then has its file, its name, and its core.
  std::optional<solid::RoundBody> round{};
  std::string unit{};  // of the numbers of the shape, as they are before the pose, where that is known; else empty
  std::shared_ptr<const solid::Mesh> mesh{};  // as it is, where it is not convex and is asked about so

  // What is placed, and asked about.
  solid::RoundBody shape() const { return round ? *round : solid::RoundBody(body.hull); }
};

struct LinkBody {
  std::uint32_t link = 0;  // of the robot
  std::vector<BodyPart> parts;
};

struct RobotBodies {
  std::vector<LinkBody> bodies;               // links without shapes are none
  std::vector<std::filesystem::path> meshes;  // the files that were read, each once
  std::vector<LeftOut> told;  // visuals of links without a collision shape, where other links have some: no part of the
                              // question by URDF, and no error, but to be told with the answer
};

// Reads the meshes of all links; a file may serve several. A part has the name of its shape, or its number in the link;
// of a mesh with several objects, with the object's name: "2.finger". What is not read goes into `left_out`, with its
// consent also a mesh that cannot be read at all; what is read into `inputs`, where given. file: the robot's, for
// messages. Throws Error as read_bodies (mesh_body.h) and resolve_mesh (packages.h) do.
RobotBodies read_robot_bodies(const Robot& robot, const std::filesystem::path& file, bool require_convex,
                              LeftOutList& left_out, InputFiles* inputs = nullptr, const Packages& packages = {});

// Has a link a collision shape, read or not? Visuals are none.
bool has_collision_shapes(const Robot& robot);

// Parts at their place in the world, where the link is at `link` (robot_motion.h). Throws Error bad_pose
// where a pose overflows.
scene::Body placed_body(const std::string& name, const std::vector<BodyPart>& parts, const solid::Pose& link);

// The pairs of bodies, as positions, whose links are joined by a joint, or by joints through links without shapes; the
// lower first, sorted. Cost: at worst bodies times joints.
std::vector<std::array<std::uint32_t, 2>> adjacent_bodies(const Robot& robot, const RobotBodies& bodies);

}  // namespace sunder::io
