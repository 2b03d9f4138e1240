// Lines, rays and segments beside placed convex polyhedra for differential tests: random and nasty, from a seed.
#pragma once

#include <sunder/base/random.h>
#include <sunder/solid/line/polyhedron_cut.h>
#include <sunder/solid/object/convex_polyhedron.h>
#include <sunder/solid/object/pose.h>

#include <string_view>
#include <vector>

namespace sunder::tests {

enum class LineFamily : int {
  general,           // random bodies, rotations and points near them: half of the lines go through
  round,             // some hundred vertices on a sphere
  grid,              // small integers, bodies and lines: through vertices and edges, along edges and in facets
  features,          // through two features of a body that stands where it is: vertices, edges, points of facets
  last_bit,          // the same, with an end moved by a few units in the last place
  features_posed,    // through the rounded images of two features
  flat,              // points, segments and polygons
  boxes,             // along axes and diagonals, in the planes of facets
  prisms,            // facets of many vertices
  bipyramids,        // vertices of many edges
  heights,           // many vertices at one height: rings about an axis
  needles,           // thin and long: 1e6 : 1 : 1 and more
  far_away,          // points of the line up to 1e12 times further away than the body is long
  tiny_or_huge,      // scales from 1e-300 to 1e300
  stretched,         // 1e300 : 1 : 1e-300, along the axes
  stretched_turned,  // the same, turned: what decides lies hundreds of digits below the coordinates
  shapes,            // of tests/support/solid_shapes.h
};
inline constexpr int line_family_count = 17;
std::string_view name_of(LineFamily);

// A body, its pose, and two different points of the world. (Of a segment, b may be asked to be a.)
struct LineCase {
  LineFamily family;
  solid::ConvexPolyhedron body;
  solid::Pose pose;
  Point3 a, b;
};

// The same kind, ends and surface; and facets of both, or of neither. Which of several facets do is a method's own.
bool is_same_cut(const solid::PolyhedronCut& found, const solid::PolyhedronCut& other);

// An endless stream of cases, family after family in turn.
class SolidLines {
 public:
  explicit SolidLines(std::uint64_t seed);
  LineCase next();
  LineCase next(LineFamily family);

  Random& random() { return random_; }

 private:
  using Bodies = std::vector<solid::ConvexPolyhedron>;
  const solid::ConvexPolyhedron& one_of(const Bodies& bodies);
  solid::Pose some_pose();
  Point3 feature_point(const solid::ConvexPolyhedron& body);  // a vertex, or in the middle of an edge or facet
  Point3 near(const solid::ConvexPolyhedron& body, const solid::Pose& pose);

  Random random_;
  Bodies general_, round_, grid_, flat_, boxes_, prisms_, bipyramids_, heights_, needles_, stretched_, shapes_;
  int turn_ = 0;
};

}  // namespace sunder::tests
