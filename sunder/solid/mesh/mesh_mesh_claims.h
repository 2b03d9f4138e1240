// Writes the answer about two meshes as they are into a certificate file: docs/claims.md, "Meshes". The table `meshes`
// has the points and triangles of each mesh in its own order (mesh.h, M5).
// Each throws only std::bad_alloc, and what the file's sink throws.
#pragma once

#include <sunder/certificate/asked_pair.h>
#include <sunder/certificate/claims.h>
#include <sunder/certificate/common_point.h>
#include <sunder/certificate/said.h>
#include <sunder/solid/mesh/mesh_cover.h>
#include <sunder/solid/mesh/mesh_crossings.h>
#include <sunder/solid/mesh/mesh_distance.h>
#include <sunder/solid/mesh/mesh_holders.h>
#include <sunder/solid/mesh/mesh_mesh.h>
#include <sunder/solid/mesh/mesh_motion.h>
#include <sunder/solid/mesh/mesh_relation.h>

#include <string>

namespace sunder::solid {

// A placed mesh with its name in the file, and the source that the file says it was made from.
struct NamedMesh {
  std::string name;
  const Mesh& mesh;
  const Pose& pose;
  Said said{};
};

// A point that the triangles have in common, with weights of points of the meshes. Requires that they do.
CommonPoint common_point(const Mesh& a, const Pose& pose_a, const Mesh& b, const Pose& pose_b,
                         const MeetingTriangles& evidence);

// A point of two triangles that cross (mesh_crossings.h): inside of one, or inside of an edge of each.
CommonPoint crossing_point(const Mesh& mesh, const CrossingTriangles& pair);

// A point that the meshes have in common, rounded. Requires that they meet.
Point3 rounded_point_of(const Mesh& a, const Pose& pose_a, const Mesh& b, const Pose& pose_b,
                        const MeshEvidence& evidence);

// The claim that the weights of corners of the triangle make the point of the statement; rule on_triangle_at: at its time.
void add_on_triangle(ClaimsWriter& file, std::uint32_t triangle, const Combination& weights,
                     const char* rule = "on_triangle");

// A placed mesh, and its index in the table.
struct StatedMesh {
  std::uint32_t index;
  const Mesh& mesh;
  const Pose& pose;
};

// A mesh that moves: where it begins, and the index of where it ends.
struct StatedMotion {
  StatedMesh begin;
  std::uint32_t end;
  const Translation& of;
};

// Calls follow the file: meshes and where they are placed, the end of the table, pairs. Keeps a reference to it.
class MeshClaims {
 public:
  explicit MeshClaims(ClaimsWriter& file) : file_(file) {}

  // Each adds an entry, and returns its index.
  std::uint32_t add_mesh(const std::string& name, const Mesh& mesh, const Said& said = {});
  std::uint32_t add_placed(const std::string& name, std::uint32_t mesh, const Pose& pose);
  void end_table();

  // The evidence must be true: what proves it is computed here. So must be the relation, if one is given; what it knows is
  // stated instead. Cost: that of mesh_cover() where surfaces are apart; else linear in both meshes and the partition.
  void add_pair(const StatedMesh& a, const StatedMesh& b, const MeshEvidence& evidence,
                const MeshRelation* relation = nullptr);

  // That the point is inside of both, which it must be.
  void add_overlapping(const StatedMesh& a, const StatedMesh& b, const FinePoint& inside);

  // That a body of the file holds all points of a mesh of the table.
  void add_around(std::uint32_t mesh, std::uint32_t body, const MeshHolders& holders);

  // How far apart they are, exactly; of meshes that meet nothing.
  void add_distance(const StatedMesh& a, const StatedMesh& b, const MeshDistance& distance);

  // That they are `least` apart, or two points that are nearer, or a point of one that is inside of the other.
  void add_clearance(const StatedMesh& a, const StatedMesh& b, const MeshDistance& distance, double least);

  // Whether they meet on the way, and when first.
  void add_motion(const StatedMotion& a, const StatedMotion& b, const MeshMotion& answer);

  // That two triangles of a mesh of the table cross. Requires that they do.
  void add_crossing(std::uint32_t index, const Mesh& mesh, const CrossingTriangles& pair);

  // That no two triangles of a mesh of the table cross.
  void add_no_crossings(std::uint32_t index, const MeshSelfCover& cover);

 private:
  void begin_entry(const std::string& name, const Said& said);

  ClaimsWriter& file_;
  std::uint32_t count_ = 0;
};

// Writes the table of one mesh, and where it is placed. What is stated of it and of bodies comes behind their table.
StatedMesh add_table(ClaimsWriter& file, const NamedMesh& of);

// What is stated besides whether they meet: how far apart they are, and whether that is `least`, where it is not 0.
struct MeshMeasures {
  const MeshDistance* distance = nullptr;  // not needed where neither is stated
  bool tells_distance = false;
  double least = 0;
};

// The table, and the statements; the file's origin stands before, and its end is not written. Cost: as of
// MeshClaims::add_pair(), for each.
void add_claims(ClaimsWriter& file, const NamedMesh& a, const NamedMesh& b, const MeshAnswer& answer,
                const MeshRelation* relation = nullptr, const MeshMeasures& measures = {});

// A mesh that moves, with its name in the file. Poses are those of the motion.
struct NamedMotion {
  std::string name;
  const Mesh& mesh;
  const Translation& of;
  Said said{};
};
void add_claims(ClaimsWriter& file, const NamedMotion& a, const NamedMotion& b, const MeshMotion& answer);

// The certificate file of the answer, whole (asked_pair.h). tells_relation: how they lie to each other, as far as that is
// found (mesh_relation.h).
void prove(const TextSink& sink, const AskedPair<Mesh, Pose>& asked, const MeshAnswer& answer);

}  // namespace sunder::solid
