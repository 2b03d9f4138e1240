// sunder pair where A and B are in space: meshes, and points, segments, flat polygons, lines, rays and planes out of
// JSON and WKT Z.
#pragma once

#include <sunder/ask/objects.h>
#include <sunder/ask/pair/pair_question.h>

#include <sunder/io/mesh/space_objects.h>
#include <sunder/solid/line/flat_body.h>
#include <sunder/solid/line/polyhedron_cut.h>
#include <sunder/solid/object/pose.h>

#include <cstdint>
#include <optional>
#include <span>
#include <string>

namespace sunder::ask {

// A bounded one in its place.
struct PlacedBody {
  MeshBody mesh;
  solid::Pose pose;                         // with the frame of a polygon that has one
  std::optional<io::SpaceObject> object{};  // where it is none of a mesh file
  Said said{};                              // in proofs; so below
  Said said_as_it_is{};                     // of a mesh that is asked about as it is

  bool is_hull() const { return mesh.shape == io::BodyShape::hull; }
};

// As the answer tells of it; keeps a view of its vertices.
PairObject object_of(const PlacedBody& placed);
std::string exact_text(const Point3& p);  // as (1, 2, 3)

// A line, a ray or a plane in its place, in doubles.
struct PlacedFlat {
  std::string file, name;
  io::SpaceObject object;
  solid::Flat flat;
  std::optional<solid::FlatBody> body;  // nothing: a plane without a point of three doubles
  Said said{};

  // Throws Error where a proof is asked for, and there is no body for it.
  PairObject object_of(const PairCall& call) const;
};

// A body with a radius in its place, and what it was made of: a ball and so on, or a bounded one and --radius.
struct PlacedRoundBody {
  std::string file, name;
  io::SpaceObject object;
  std::optional<PlacedBody> core{};  // of --radius
  solid::RoundBody body;
  solid::Pose pose;
  Said said{};
  std::optional<double> around{};  // of a core: its radius, where that is above 0

  bool is_hull() const { return core && core->is_hull(); }
  PairObject object_of() const;
};

// A or B as it was read: one of these.
struct SpaceInput {
  std::optional<PlacedBody> bounded;
  std::optional<PlacedFlat> flat;
  std::optional<PlacedRoundBody> round{};
};

// As a body with a radius, which of a bounded one without is 0. Requires one of the two.
PlacedRoundBody round_of(const SpaceInput& input);

// The image of the point, where its coordinates are doubles. (Decided exactly.)
std::optional<Point3> exact_image(const solid::Pose& pose, const Point3& p);

// Is the file one of an object of space?
bool is_space_input(const PairCall& call, const std::string& file);

// A mesh, or an object of space; of standard input the text tells. Throws Error for bad input; for a pose under which
// what is not a body is not of doubles any more.
SpaceInput read_space_input(const PairCall& call, const PairSide& side, PairFiles& files);

// Throws Error where a frame is given, and no polygon was projected on it.
void require_projected(const PairCall& call, const SpaceInput& a, const SpaceInput& b);

// Answers a pair of which at least one object is unbounded. Throws Error for --distance and --clearance.
Report run_flat_pair(const PairCall& call, const SpaceInput& a, const SpaceInput& b, const PairFiles& files);

// Answers a pair of bounded objects, with a radius or without. Throws Error if one of them is unbounded, and if a
// certificate is asked for and the pair is undecided.
Report run_body_pair(const PairCall& call, const SpaceInput& a, const SpaceInput& b, const PairFiles& files);

// The first of the meshes of A and B that is not convex; null: there is none.
const MeshBody* mesh_that_is_not_convex(const SpaceInput& a, const SpaceInput& b);

// Answers a pair of which one is such a mesh, as they are. Throws Error for the options of convex objects; where a
// certificate is asked for and the pair is undecided.
Report run_mesh_pair(const PairCall& call, const SpaceInput& a, const SpaceInput& b, const PairFiles& files);

// The same where the other one has a radius; where it is a line, a ray or a plane.
Report run_mesh_round_pair(const PairCall& call, const SpaceInput& a, const SpaceInput& b, const PairFiles& files);
Report run_mesh_flat_pair(const PairCall& call, const SpaceInput& a, const SpaceInput& b, const PairFiles& files);

// Answers a pair of bounded bodies, with a radius or without, of which one moves, or both (--to-a, --to-b). Throws
// Error where a body turns, where a polygon in a frame moves, for options of bodies at rest, and where a certificate is
// asked for and the pair is undecided.
Report run_motion_pair(const PairCall& call, const SpaceInput& a, const SpaceInput& b, const PairFiles& files);

// A body and a plane, a body and a line or ray.
Report run_plane_pair(const PairCall& call, const PlacedBody& body, const PlacedFlat& plane, bool body_is_a,
                      const PairFiles& files);
Report run_line_pair(const PairCall& call, const PlacedBody& body, const PlacedFlat& line, bool body_is_a,
                     const PairFiles& files);

// Their methods, for help texts.
std::string plane_method_names();
std::string line_method_names();
std::string mesh_method_names();
std::string support_method_names();  // of --support

// Few vertices of a body, which is called so, that span a part of its surface: a vertex, an edge, a part of a facet.
Told surface_part(const solid::ConvexPolyhedron& body, std::span<const std::uint32_t> vertices, const char* letter);

// What a segment has in common with a body. Nothing, where the other one is none, or its ends in the world are no
// doubles.
struct SegmentCut {
  solid::Segment segment;  // in the world
  solid::PolyhedronCut cut;
  Told told;
};
std::optional<SegmentCut> segment_cut(const PlacedBody& body, const char* letter, const PlacedBody& segment);

}  // namespace sunder::ask
