// A mesh as it is: triangles over points, in pieces, each of which bounds a part of space or does not.
// Also called: triangle soup, polygon mesh; watertight, manifold, orientable mesh; boundary representation.
#pragma once

#include <sunder/base/error.h>
#include <sunder/predicate/point.h>
#include <sunder/predicate/posed.h>
#include <sunder/solid/mesh/mesh_convexity.h>
#include <sunder/solid/mesh/mesh_tree.h>
#include <sunder/solid/object/convex_polyhedron.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

namespace sunder::solid {

// Does a piece bound a part of space?
enum class PieceKind : std::uint8_t {
  oriented,    // each directed edge occurs as often as its opposite: a winding number tells what is inside
  unoriented,  // else, each edge is that of an even number of triangles: only a parity tells what is inside
  open,        // else: it is a surface
};
std::string_view name_of(PieceKind kind);  // "oriented", "unoriented", "open"

// Immutable; any number of threads may use it. Coordinates are exact, in any unit.
//   M1. No two points are equal, and each is a corner of a triangle.
//   M2. Faces of more corners are triangulated (face_triangles.h). A corner that repeats the one before, the last one
//       before the first, is left out; what has less than three then is a triangle that repeats a corner. Triangles may
//       have no area.
//   M3. Of an edge without direction, say how often triangles go along it there and back. If these numbers differ, it
//       is cut at each end of another such edge that is inside it and on its line, exactly (a T-junction). Parts of
//       edges that have the same ends are one then, and their numbers tell the kind of a piece.
//   M4. Two triangles are of one piece if they have a corner in common, or if an end of an edge of one cuts an edge of
//       the other. So a loose triangle at a corner of a closed body makes the piece open.
//   M5. Triangles stand in the order of the tree (mesh_tree.h), so that those of a leaf follow each other.
class Mesh {
 public:
  using Triangle = std::array<std::uint32_t, 3>;

  struct Piece {
    PieceKind kind = PieceKind::open;
    std::uint32_t first = 0;        // its first triangle
    std::uint32_t triangles = 0;    // how many it has
    std::uint64_t open_edges = 0;   // after the cuts: those of an odd number of triangles
    std::uint64_t t_junctions = 0;  // cuts: pairs of an edge and a point inside it
  };

  // Throws Error bad_shape where it has no face, or a face has no corner or names a vertex that is not there; bad_value
  // where a coordinate is not finite. Requires fewer than 2^31 points. Cost: n log n, and what faces of many corners
  // take.
  explicit Mesh(const MeshView& given);

  std::span<const Point3> points() const { return points_; }
  std::span<const Triangle> triangles() const { return triangles_; }
  std::uint32_t face_of(std::uint32_t triangle) const { return face_of_[triangle]; }
  std::uint32_t piece_of(std::uint32_t triangle) const { return piece_of_[triangle]; }
  std::span<const Piece> pieces() const { return pieces_; }  // in the order of their first faces
  // Faces that cross themselves, or touch themselves so that triangles may overlap (FaceTriangles::crosses_itself).
  std::span<const std::uint32_t> crossing_faces() const { return crossing_faces_; }

  // Is each piece closed, that is, not open? Is there a closed one? (It may be flat, and have no inner point.)
  bool is_closed() const;
  bool has_inside() const;
  // What is inside of the closed pieces: by the winding number of all together, if all of them are oriented; by the
  // number of times that a ray crosses them, if it is odd, where one is not.
  bool is_by_winding() const { return is_by_winding_; }

  // Has a triangle no area?
  bool has_needles() const { return has_needles_; }
  // Triangles that have the same three corners as one that stands before them.
  std::span<const std::uint32_t> repeated_triangles() const { return repeated_triangles_; }

  // The box of all triangles, and what searches walk on.
  const Box3& box() const { return tree_.box(); }
  const MeshTree& tree() const { return tree_; }
  const SizeRange& sizes() const { return sizes_; }  // of the coordinates

 private:
  void find_pieces();
  void find_repeated();

  std::vector<Point3> points_;
  std::vector<Triangle> triangles_;
  std::vector<std::uint32_t> face_of_, piece_of_, crossing_faces_, repeated_triangles_;
  std::vector<Piece> pieces_;
  bool is_by_winding_ = true, has_needles_ = false;
  MeshTree tree_;
  SizeRange sizes_;
};

// The surface of a convex body: a closed piece, without an inside where the body has none. Of a polygon it has both
// sides, of a segment or a point one triangle without area. Cost: n log n.
Mesh mesh_of(const ConvexPolyhedron& body);

// The same, made when it is first asked for and kept with the body: represent::of<HullMesh>(body).mesh.
struct HullMesh {
  static constexpr std::size_t slot = 8;  // see solid/represent/of.h
  static HullMesh make(const ConvexPolyhedron& body) { return {mesh_of(body)}; }

  Mesh mesh;
};

}  // namespace sunder::solid
