// Lines, section planes and planes beside one convex body for bench_lines, the same for every library.
//
// The body is a sphere: the hull of n random points on the unit sphere, whose coordinates are multiples of 2^-40; all
// of them are vertices. What is true of a query is known by construction; where a line goes in and out, by looking at
// all facets in doubles, apart from the searches under test.
#pragma once

#include <sunder/solid/line/polyhedron_cut.h>
#include <sunder/solid/object/convex_polyhedron.h>
#include <sunder/solid/object/line.h>
#include <sunder/solid/object/plane.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

namespace bench {

struct SphereBody {
  sunder::solid::ConvexPolyhedron hull;
  std::vector<std::array<std::uint32_t, 3>> triangles;  // counter-clockwise, of its vertices
};

// Throws std::logic_error where not all points are vertices.
SphereBody make_sphere_body(std::size_t n, std::uint64_t seed);

enum class LineFamily : std::uint8_t {
  hits,         // through a point of the ball of radius 0.9
  vertices,     // a third each: through a vertex and the inside; through two vertices and the inside; touching one
  edges,        // a third each: along an edge; through an edge and the inside; touching an edge in one point
  near_misses,  // past a vertex, at a distance log-uniform in 1e-6 to 1e-3
  far_misses,   // at a distance of 1.1 to 3 from the centre
};
inline constexpr std::array kLineFamilies{LineFamily::hits, LineFamily::vertices, LineFamily::edges,
                                          LineFamily::near_misses, LineFamily::far_misses};

std::string_view name_of(LineFamily);

// How far an end may be from where it is. It is there for peers: they round, and get that for nothing.
inline constexpr double kMostOff = 1e-3;

struct LineQuery {
  sunder::solid::Line line;  // exactly
  // Rounded: its point next to the centre, its direction of length 1, and how far along that its ends are.
  sunder::Point3 foot, way;
  sunder::CutKind kind = sunder::CutKind::nothing;
  double first = HUGE_VAL, last = -HUGE_VAL;

  bool meet() const { return kind != sunder::CutKind::nothing; }
  // An answer in a number: 0: nothing; 1: a common part with these ends; 2: one with others, which is wrong.
  std::uint64_t answer(double found_first, double found_last) const {
    if (found_first == HUGE_VAL && found_last == -HUGE_VAL) return 0;
    return std::fabs(found_first - first) <= kMostOff && std::fabs(found_last - last) <= kMostOff ? 1 : 2;
  }
  double along(double x, double y, double z) const {
    return (x - foot.x) * way.x + (y - foot.y) * way.y + (z - foot.z) * way.z;
  }
};

struct LineScenario {
  const SphereBody* body = nullptr;
  std::vector<LineQuery> queries;
};

// Keeps a pointer to the body.
LineScenario make_line_scenario(const SphereBody& body, LineFamily family, std::size_t queries, std::uint64_t seed);

enum class PlaneFamily : std::uint8_t {
  level,  // z = c
  any,    // normals of whole numbers up to 1,000
};

struct SectionQuery {
  sunder::solid::Plane plane;  // normal . x = offset; no vertex is on it
  std::uint64_t corners = 0;   // edges that cross it, counted in doubles without rounding
};

struct SectionScenario {
  const SphereBody* body = nullptr;
  std::vector<SectionQuery> queries;  // level ones from bottom to top
};

SectionScenario make_section_scenario(const SphereBody& body, PlaneFamily family, std::size_t queries,
                                      std::uint64_t seed);

// Planes beside a vertex, across the way from the centre to it. Half of them meet the body; gap or depth log-uniform in
// 1e-6 to 1e-3.
struct SideQuery {
  sunder::solid::Plane plane;
  bool meet = false;
};

struct SideScenario {
  const SphereBody* body = nullptr;
  std::vector<SideQuery> queries;
};

// Level polygons of kPolygonVertices vertices beside a vertex that is not near a pole. Half of them meet the body; gap
// or depth of the vertex that is nearest to the axis log-uniform in 1e-6 to 1e-3.
inline constexpr std::size_t kPolygonVertices = 100;
struct PolygonQuery {
  sunder::solid::ConvexPolyhedron polygon;  // of dimension 2
  bool meet = false;
};

struct PolygonScenario {
  const SphereBody* body = nullptr;
  std::vector<PolygonQuery> queries;
};

PolygonScenario make_polygon_scenario(const SphereBody& body, std::size_t queries, std::uint64_t seed);

SideScenario make_side_scenario(const SphereBody& body, std::size_t queries, std::uint64_t seed);

}  // namespace bench
