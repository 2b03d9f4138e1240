// How far apart are two placed convex polyhedra? The closest features, the exact distance, and exact comparisons.
// Also called: separation distance; minimum distance of convex bodies; closest points, witness points.
//
//   D1. The features are those of the exact images: the distance between them is the distance of the bodies.
//   D2. `distance` encloses the exact distance: it is both ends where a double is it, else one unit in the last place
//       is between them. Beyond the range of doubles: the largest and infinity, zero and the least one.
//   D3. compare_distance is exact for every finite radius.
//   D4. The distance is the same for bodies that are swapped; scaled by a power of two, it is that much larger.
// What one might assume and does not hold: where facets or edges are parallel, the nearest points are not the only
// ones, nor are the features; swapped bodies may get others. None throws, but for want of memory. Allocates nothing
// while filters decide.
#pragma once

#include <sunder/certificate/pair_answer.h>
#include <sunder/number/exact_fraction.h>
#include <sunder/predicate/point.h>
#include <sunder/solid/object/convex_polyhedron.h>
#include <sunder/solid/object/pose.h>
#include <sunder/solid/search/closest_features.h>

#include <array>
#include <span>
#include <variant>

namespace sunder::solid {

// They are apart. A few vertices of A and a few of B: the nearest points lie in the insides of their hulls: at a vertex,
// on an edge, in a facet (of which three vertices are named, or two between which there is no edge). They are the only
// such vertices of these: the weights that make the points are unique, and positive.
class ClosestFeatures {
 public:
  static constexpr Verdict verdict = Verdict::apart;

  // Those of these vertices, under their poses. Keeps what it needs of them.
  ClosestFeatures(std::span<const Point3> a, const Pose& pose_a, std::span<const Point3> b, const Pose& pose_b,
                  const FeatureVertices& features);

  const FeatureVertices& features() const { return features_; }

  // Numbers of at most four vertices, made when asked for: in about 106 bits where these tell the last one of a double,
  // else exactly.
  Interval distance() const;
  ExactFraction squared() const;  // of the distance; positive
  ExactWay way() const;           // from A to B, and the weights of the vertices

  // The nearest points, of A and of B, each coordinate rounded to the nearest double; as `distance` is made.
  std::array<Point3, 2> nearest_points() const;

  // The images of the vertices named.
  std::array<Posed3, 4> images() const;

 private:
  template <class Number>
  auto arrows_in() const;
  template <class Number>
  auto way_in() const;
  template <class Number>
  auto ends_in() const;

  FeatureVertices features_;
  std::array<Point3, 4> points_;
  Affine3 pose_a_, pose_b_;
};

using PolyhedronDistance = Answer<std::variant<CommonVertices, ClosestFeatures>>;

// nullptr where they meet; and 0.
inline const ClosestFeatures* closest_of(const PolyhedronDistance& answer) {
  return std::get_if<ClosestFeatures>(&answer.evidence);
}
inline Interval distance_of(const PolyhedronDistance& answer) {
  const ClosestFeatures* closest = closest_of(answer);
  return closest != nullptr ? closest->distance() : Interval{0, 0};
}

// The front door. Distances are in the world, in the unit of its coordinates.
// Asks first whether they meet. Where they do not, the search of polyhedron_polyhedron_by_gjk goes on to the nearest
// features, in doubles, then in double-doubles; what it proposes is accepted only if, exactly, the shortest way between
// the features ends inside them, and no vertex of A is further along it, none of B less far. Where nothing holds, an
// exact descent decides: from features to vertices that are further along the way, and to the nearest features of
// these. Cost: that of polyhedron_polyhedron, and again at most 100 steps of search in each precision; the descent gets
// nearer with each step, of which there are some one to ten, each with a walk over both graphs and up to 132 exact
// ways. Sources: Gilbert, Johnson, Keerthi 1988; the descent is the same in exact numbers (solid/exact/exact_gjk.h).
PolyhedronDistance polyhedron_polyhedron_distance(const ConvexPolyhedron& a, const Pose& pose_a,  //
                                                  const ConvexPolyhedron& b, const Pose& pose_b);

// Of all vertices, edges and triangles of facets: the oracle. Cost: O(n m) ways, exact where intervals do not tell.
PolyhedronDistance polyhedron_polyhedron_distance_by_scan(const ConvexPolyhedron& a, const Pose& pose_a,  //
                                                          const ConvexPolyhedron& b, const Pose& pose_b);

// positive: further apart than the radius; zero: exactly so far; negative: closer. Requires a finite radius >= 0.
Sign compare_distance(const ClosestFeatures& closest, double radius);
Sign compare_distance(const PolyhedronDistance& distance, double radius);

}  // namespace sunder::solid
