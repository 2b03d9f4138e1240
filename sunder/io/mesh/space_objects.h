// One object of space out of a small file: a point, a segment, a flat polygon, a box, a line, a ray or a plane, or a
// body with a radius. JSON, WKT Z.
//
//   {"point": [x, y, z]}
//   {"segment": [[x, y, z], [x, y, z]]}        its ends, which may be equal
//   {"ray": [[x, y, z], [x, y, z]]}            from the first point through the second
//   {"line": [[x, y, z], [x, y, z]]}           through both
//   {"plane": {"normal": [a, b, c], "point": [x, y, z]}}
//   {"plane": {"normal": [a, b, c], "offset": d}}                 the points with a x + b y + c z = d
//   {"polygon": [[x, y, z], ..]}               three vertices or more, in order, exactly in one plane
//   {"polygon": {"origin": [..], "u": [..], "v": [..], "vertices": [[s, t], ..]}}   a vertex is origin + s u + t v
//   {"box": {"size": [a, b, c]}}               edges along the axes, the middle in the origin
//   {"ball": {"center": [x, y, z], "radius": r}}
//   {"capsule": {"ends": [[x, y, z], [x, y, z]], "radius": r}}    all within r of the segment
//   {"cylinder": {"ends": [[x, y, z], [x, y, z]], "radius": r}}   the middles of its two discs, which differ
//   {"cone": {"base": [x, y, z], "apex": [x, y, z], "radius": r}}   the middle of its disc, and its tip
//   {"ellipsoid": {"center": [x, y, z], "semi_axes": [a, b, c]}}    along x, y, z; --pose turns it
//
// In WKT POINT Z, LINESTRING Z of two points, and POLYGON Z of one ring.
#pragma once

#include <sunder/base/error.h>
#include <sunder/io/mesh/mesh.h>
#include <sunder/predicate/point.h>
#include <sunder/solid/object/frame.h>
#include <sunder/solid/object/plane.h>
#include <sunder/solid/round/round_body.h>

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace sunder::io {

struct SpaceObject {
  enum class Kind : std::uint8_t {
    point,
    segment,
    polygon,
    box,
    line,
    ray,
    plane,
    ball,
    capsule,
    cylinder,
    cone,
    ellipsoid
  } kind = Kind::point;
  std::string format;  // for people: "JSON", "WKT"

  // Finite, and never -0. Of a polygon: as the file lists them, without the repeated last one. Of a line and a ray: its
  // two points, which differ; the ray begins in the first one. Of a box: its corners. Of a plane, and of bodies with a radius: none.
  std::vector<Point3> points;

  // Of a polygon: the points are (s, t, 0) in this frame. Exactly in one plane either way.
  std::optional<solid::Frame> frame;
  // Of a polygon that was projected on a frame: about how far the vertex moved that moved furthest.
  std::optional<double> moved;

  solid::Plane plane;  // meaningless but for a plane

  std::optional<solid::RoundBody> round{};  // of a ball, a capsule, a cylinder, a cone, an ellipsoid

  bool unbounded() const { return kind == Kind::line || kind == Kind::ray || kind == Kind::plane; }
};

std::string_view name_of(SpaceObject::Kind);  // "segment"

// The corners of the box with these edges, centred at the origin: corner i has +size/2 in x, y, z for its bits 0, 1, 2.
std::array<Point3, 8> box_corners(const std::array<double, 3>& size);

// Is this an object of space? JSON: an object without a "type", which GeoJSON has. WKT: the first word stands before a
// Z. Looks at the text only, and says nothing of whether it can be read.
bool is_space_text(std::string_view text);

// Has the file an ending of these formats (.json, .wkt), and is it a regular file with such a text? Reads it.
bool is_space_file(const std::filesystem::path& path);

// Coordinates are the doubles nearest to the numbers in the file. project: polygons that are given by points of space
// are projected on this frame: each vertex goes to the point of the plane nearest to it, in doubles.
// place: the file's name, for messages. Throws Error bad_file, "FILE:LINE: what; remedy" or "FILE: KEY: what; remedy":
// for what is none of these objects, or more than one; unknown, missing and repeated keys; numbers that are none, not
// finite or too large; lines and rays whose points are equal, and planes with a zero normal; frames with parallel
// directions; radii and edges below zero, semi-axes that are not above it; and a polygon of points that are not exactly in one
// plane (it says by how much). Cost: linear.
SpaceObject parse_space_object(std::string_view text, std::string_view place, const solid::Frame* project = nullptr);

// A bounded one as a mesh, whose body is then what a mesh's is (mesh_body.h): a polygon is its one face, the
// others have none. Its vertices are the object's points; where it has a frame, they are in that. Requires a bounded
// object without a radius.
Mesh mesh_of(const SpaceObject& object);

}  // namespace sunder::io
