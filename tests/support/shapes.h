// Plain shapes and plain random ones: of tests, and of benchmarks, for which there is no GoogleTest here. What is nasty
// by intent is in *_sets.h, *_pairs.h and *_polygons.h.
#pragma once

#include <sunder/base/random.h>
#include <sunder/planar/object/convex_polygon.h>
#include <sunder/planar/object/segments.h>
#include <sunder/predicate/disc/disc.h>
#include <sunder/predicate/point.h>
#include <sunder/solid/object/pose.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace sunder::tests {

template <class Item>
void shuffle(std::vector<Item>& items, Random& random) {
  for (std::size_t i = items.size(); i > 1; --i) std::swap(items[i - 1], items[random.below(i)]);
}

// The nearest multiple of 2^-bits.
inline double snapped(double x, int bits) { return std::ldexp(std::nearbyint(std::ldexp(x, bits)), -bits); }

// n angles of one turn, evenly spaced but for a jitter of up to so many spaces to both sides; from any angle on.
inline std::vector<double> jittered_angles(std::size_t n, double jitter, Random& random) {
  const double turn = 6.283185307179586, space = turn / static_cast<double>(n), start = random.uniform(0, turn);
  std::vector<double> angles;
  for (std::size_t k = 0; k < n; ++k) {
    angles.push_back(start + space * (static_cast<double>(k) + random.uniform(-jitter, jitter)));
  }
  return angles;
}

// --- Of the plane ----------------------------------------------------------------------------------------------------

// At this part of a turn around the centre.
Point2 on_circle(double turn, double radius = 1, const Point2& center = {0, 0});

// Counter-clockwise from its lower left corner.
inline std::vector<Point2> box_ring(double left, double bottom, double right, double top) {
  return {{left, bottom}, {right, bottom}, {right, top}, {left, top}};
}

// n vertices on a circle, rounded to doubles; about the origin with radius 1 all of them are vertices for n up to 2^24.
planar::ConvexPolygon regular_polygon(std::uint32_t n, double radius = 1, double first_angle = 0,
                                      const Point2& center = {0, 0});

// Each in a square from `low` on: segments that reach so far from there in x and y; discs of up to this radius.
std::vector<planar::Segment> short_segments(std::size_t n, const Point2& low, double size, double reach,
                                            Random& random);
std::vector<Disc> discs_in_square(std::size_t n, const Point2& low, double size, double radius, Random& random);

// About n edges of a jittered square mesh.
std::vector<planar::Segment> mesh_edges(std::size_t n, Random& random);

// n / 2 horizontals and n / 2 verticals in turn; each crosses all of the others.
std::vector<planar::Segment> hatch(std::size_t n);

// --- Of space --------------------------------------------------------------------------------------------------------

std::vector<Point3> in_space(const planar::ConvexPolygon& polygon);  // z = 0

Point3 in_cube(Random& random);                     // from -1 to 1
Point3 on_grid(Random& random, std::int64_t side);  // whole, from -side to side
Point3 on_sphere(Random& random);                   // of radius 1, rounded to doubles
std::vector<Point3> points_in_cube(std::size_t n, Random& random);
std::vector<Point3> points_on_sphere(std::size_t n, Random& random);

std::vector<Point3> cube_corners(double low, double high);
inline solid::Pose shift(double x, double y, double z) {
  return solid::Pose::from_matrix({1, 0, 0, 0, 1, 0, 0, 0, 1}, {x, y, z});
}

}  // namespace sunder::tests
