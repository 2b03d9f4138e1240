// Robots out of URDF files: links, the shapes to test for collisions, and joints. Where the links are for given joint
// values: robot_motion.h.
#pragma once

#include <sunder/base/error.h>
#include <sunder/certificate/origin.h>
#include <sunder/io/text/left_out.h>
#include <sunder/predicate/point.h>

#include <array>
#include <cstdint>
#include <filesystem>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace sunder::io {

// A frame within a parent's frame: turned by roll, pitch and yaw (radians, about the fixed axes x, y, z in this order),
// then moved by xyz (metres).
struct UrdfOrigin {
  std::array<double, 3> xyz{0, 0, 0};
  std::array<double, 3> rpy{0, 0, 0};
};

// One shape of a link: a mesh file, or one of these, centred at the origin.
enum class ShapeKind : std::uint8_t {
  mesh,
  box,
  sphere,
  cylinder,  // its axis along z
  capsule,   // its axis along z: the points within the radius of a segment
};
std::string_view name_of(ShapeKind kind);  // "cylinder", the name of its element

struct CollisionShape {
  std::string name;  // the name of <collision>; often empty
  ShapeKind kind = ShapeKind::box;
  std::string mesh;                      // as written, see resolve_mesh (packages.h); empty: no mesh
  std::array<double, 3> scale{1, 1, 1};  // of a mesh: no entry is 0, negative entries reflect
  std::array<double, 3> size{0, 0, 0};   // of a box: its edges, centred at the origin; no entry is negative
  double radius = 0;                     // of a sphere, a cylinder, a capsule; not negative
  double length = 0;                     // of a cylinder, above 0; of a capsule that of the segment, not negative
  UrdfOrigin origin;                     // within the link
};

struct Link {
  std::string name;
  std::vector<CollisionShape> shapes;  // in the order of the file
};

// A planar joint NAME is three joints here, one after the other, with links without shapes between them: shifts NAME/x
// and NAME/y, then a turn NAME/yaw about z. A floating one is six: NAME/x, /y, /z, then turns NAME/yaw, /pitch, /roll
// about z, y, x, which is the rpy of an <origin>. They have no limits. A link between has the
// name of the joint that it hangs on.
enum class JointType { fixed, revolute, continuous, prismatic };

struct Mimic {
  std::uint32_t joint = 0;  // number of the joint that is followed: value = multiplier * its value + offset
  double multiplier = 1, offset = 0;
};

struct Joint {
  std::string name;
  JointType type = JointType::fixed;
  std::uint32_t parent = 0, child = 0;  // numbers of links
  UrdfOrigin origin;                    // of the child's frame within the parent's, at value 0
  std::array<double, 3> axis{1, 0, 0};  // in the child's frame, of length 1 up to rounding; meaningless when fixed
  // Radians or metres. Finite for revolute and prismatic, but for those of planar and floating joints.
  double lower = -std::numeric_limits<double>::infinity();
  double upper = std::numeric_limits<double>::infinity();
  std::optional<Mimic> mimic;
};

// A tree of links. What read_urdf returns has these properties:
// U1. Names of links are unique, names of joints are unique, none is empty, and every one is one line of UTF-8.
// U2. Every link but `root` is the child of exactly one joint, and hangs on the root. A joint's parent is the root or
//     the child of an earlier joint (so joints are not in the order of the file).
// U3. Every number is finite, but for the limits of joints that have none. lower <= upper.
// U4. No chain of mimics runs in a circle.
struct Robot {
  std::string name;  // may be empty
  std::vector<Link> links;
  std::vector<Joint> joints;
  std::uint32_t root = 0;         // a number of a link
  std::vector<LeftOut> left_out;  // the shapes that are not read, each of a link, in the order of the file
  std::filesystem::path folder;   // of the file; names of meshes are relative to it
};

// The kind of what a <visual> leaves out.
inline constexpr std::string_view visual_shape = "visual shape";

// Reads <robot>, <link>, <collision> (mesh, box, sphere, cylinder, capsule) and <joint>. No part of the question, and
// so not told: <inertial>, <transmission>, <gazebo>, dynamics and the like, and the <visual> of a link that has a
// <collision>. Told in `left_out`: shapes that are none of these, by the name of their element; and as "visual shape"
// each <visual> of a link without a <collision>.
// Throws Error bad_file, "FILE:LINE: what is wrong; remedy", in one line: XML that is not well-formed, xacro that was
// not expanded (anywhere in the file), two shapes in one <collision>, a missing or repeated name, a number that is
// none, a link that does not exist, links that are no tree, missing limits. Meshes are not
// opened. inputs: as of read_file (file.h).
Robot read_urdf(const std::filesystem::path& path, InputFiles* inputs = nullptr);

// As read_urdf, from memory. place: the file's name for messages. `folder` stays empty.
Robot parse_urdf(std::string_view bytes, std::string_view place);

}  // namespace sunder::io
