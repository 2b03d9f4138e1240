// Scenes as files: named bodies made of parts, where they are, and which pairs may meet.
//
//   {"unit": "m",                                        optional: m, cm, mm, in or ft
//    "bodies": [{"name": "table",
//                "pose": POSE,                           optional: of the body in the world
//                "parts": [{"name": "top",               optional: a name of its own within the body
//                           "pose": POSE,                optional: of the part in the body
//                           SHAPE}]}],
//    "allowed": [["table", "hand"]]}                     optional: pairs of bodies that are not asked about
//
// POSE is one of
//   {"matrix": [[a, b, c, x], [d, e, f, y], [g, h, i, z]]}          and, if you like, [0, 0, 0, 1]
//   {"translation": [x, y, z], "quaternion": [w, x, y, z]}          either may be left out
// SHAPE is one of these keys
//   "mesh": "leg.stl"                                    each of its objects is a part
//   "mesh": {"file": "leg.stl", "scale": 2 or [2, 2, 1], "unit": "mm"}     the last two optional
//   "points": [[x, y, z], ..]                            their convex hull
//   "box": {"size": [a, b, c]}                           edges along the axes, the middle in the origin
//   "rounded": {"points": [[x, y, z], ..], "radius": r}  all within r of their convex hull
//   "ball", "capsule", "cylinder", "cone", "ellipsoid"   as in space_objects.h
//
// What is exact: numbers are the doubles nearest to those in the file. A matrix and a translation are the map, exactly.
// A quaternion, which need not have length 1, becomes a matrix that is rounded to doubles; so is the product of a
// body's pose and a part's, where neither is the identity, and with a mesh's scale. The poses that come out are what
// answers are exact for. Radii and points have no error.
#pragma once

#include <sunder/base/error.h>
#include <sunder/certificate/origin.h>
#include <sunder/io/robot/robot_bodies.h>
#include <sunder/io/text/left_out.h>
#include <sunder/solid/object/pose.h>

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace sunder::io {

// What read_scene_file returns has these properties:
//   C1. There is a body. Names of bodies are unique, one line of UTF-8, and not empty; a body has a part.
//   C2. Names of parts are such, too, within a body, or empty where the file says none.
//   C3. Each pair that is allowed is of two bodies, the lower first; none comes twice.
//   C4. A body with a radius is where require_rigid (solid/round/round_body.h) allows.
struct SceneFile {
  struct Mesh {
    std::string file;                      // as written; relative names are relative to the scene's folder
    std::array<double, 3> scale{1, 1, 1};  // no entry is 0; negative ones reflect
    std::string unit{};                    // of its numbers, where that is known; else empty
  };
  struct Part {
    std::string name, format;  // of the shape: its key
    std::optional<Mesh> mesh;
    std::optional<solid::RoundBody> shape;  // of a part that is no mesh
    bool is_convex_by_kind = true;          // a box; not points, whose hull stands for them
    solid::Pose pose;                       // in the world
  };
  struct Body {
    std::string name;
    std::vector<Part> parts;
  };

  std::string unit;  // empty: the file says none
  std::vector<Body> bodies;
  std::vector<std::array<std::uint32_t, 2>> allowed;
};

// Does the file's name end in .json?
bool is_scene_file(std::string_view file);

// Meshes are not opened. inputs: as of read_file (file.h). Throws Error bad_file "FILE: PLACE: what is wrong; remedy",
// in one line, PLACE such as bodies[2].parts[0].ball: what is not JSON, with its line; unknown, missing and repeated
// keys; numbers that are none, or beyond the doubles; a part with no shape or two; a body that is named twice; an
// allowed pair of a body that is not there, or of one with itself; a scale of zero; a pose that is singular, or that
// scales a body with a radius. Cost: linear, and that of the hulls.
SceneFile read_scene_file(const std::filesystem::path& path, InputFiles* inputs = nullptr);

// As read_scene_file, from memory. place: the file's name for messages.
SceneFile parse_scene_file(std::string_view text, std::string_view place);

// Each body's parts, with their meshes read, and their places in the world. file: the scene's. meshes: gets the files
// that were opened. Throws Error as read_bodies (mesh_body.h) does.
std::vector<std::vector<BodyPart>> read_scene_parts(const SceneFile& scene, const std::filesystem::path& file,
                                                    bool require_convex, LeftOutList& left_out,
                                                    InputFiles* inputs = nullptr,
                                                    std::vector<std::filesystem::path>* meshes = nullptr,
                                                    PartsOf parts = PartsOf::objects);

}  // namespace sunder::io
