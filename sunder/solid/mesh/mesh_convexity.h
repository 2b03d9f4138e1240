// Is a mesh exactly convex, that is, does it bound the convex hull of its vertices?
// Also called: convexity test.
#pragma once

#include <sunder/predicate/point.h>
#include <sunder/solid/object/convex_polyhedron.h>

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace sunder::solid {

// Polygons as cycles of vertex numbers: polygon p is polygon_vertices[polygon_begin[p] .. polygon_begin[p + 1]).
// Equal points count as one vertex. Polygons may be turned either way and repeat corners.
struct MeshView {
  std::span<const Point3> vertices;
  std::span<const std::uint32_t> polygon_begin;  // one entry more than there are polygons
  std::span<const std::uint32_t> polygon_vertices;

  std::uint32_t polygon_count() const { return static_cast<std::uint32_t>(polygon_begin.size() - 1); }
  std::span<const std::uint32_t> polygon(std::uint32_t p) const {
    return polygon_vertices.subspan(polygon_begin[p], polygon_begin[p + 1] - polygon_begin[p]);
  }
};

// Why a mesh is not exactly convex: the first of these that is found.
struct MeshDefect {
  enum class Kind : std::uint8_t {
    none,         // it is convex
    thin,         // all vertices are on one line
    open_edge,    // `edge` belongs to an odd number of polygons: the mesh has a hole there
    bent_face,    // the corners of `face` are not in one plane
    reflex_edge,  // the mesh bends inwards at `edge`
    inner_face,   // `face` is not on the boundary of the hull, though no reflex edge shows it (a mesh of several
                  // shells, or one that is turned inconsistently, or crosses itself)
    doubled,      // the polygons cover the boundary of the hull an even number of times
  };
  Kind kind = Kind::none;
  std::uint32_t face = 0;               // meaningless but for bent_face and inner_face
  std::array<std::uint32_t, 2> edge{};  // vertex numbers; meaningless but for open_edge and reflex_edge
};

// Exact. `hull` must be the hull of the mesh's vertices, and the mesh have a polygon.
//
// A mesh is convex iff
//   C1. the corners of every polygon lie on one facet of the hull,
//   C2. every edge belongs to an even number of polygons (of a flat mesh: every edge but those on the hull's edges),
//   and C3. beside the first edge of the hull's first facet the polygons cover that facet an odd number of times.
// By C1 and C2 the polygons, counted modulo two, are a cycle on the hull's boundary, a sphere (or a disc relative to
// its rim); so they cover all of it an odd number of times, or all of it an even number: C3 tells which. What the mesh
// encloses by the even-odd rule is then exactly the hull.
// Vertices within facets and edges of the hull are allowed; so are facets cut into any polygons, convex or not.
// Cost: n log n in floating point, plus the number of facets for each polygon without a corner that is extreme.
MeshDefect find_mesh_defect(const MeshView& mesh, const ConvexPolyhedron& hull);

// Of a convex mesh, for each polygon a facet of the hull that holds its corners (C1). Cost: likewise.
std::vector<std::uint32_t> facets_beneath(const MeshView& mesh, const ConvexPolyhedron& hull);

// The first polygon whose corners no facet of the hull holds (against C1), if there is one. Cost: likewise.
std::optional<std::uint32_t> face_off_hull(const MeshView& mesh, const ConvexPolyhedron& hull);

}  // namespace sunder::solid
