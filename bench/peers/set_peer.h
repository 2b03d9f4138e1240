// The other libraries of bench_sets behind one interface.
//
// A way of asking is right on an input where it gives the answer that is known; of each library the fastest way that is
// right counts. Every library prepares its own discs, polygons, points, edges and boxes outside of the timed loop, as
// Sunder does; what is built over the set to answer (trees, sorted boxes), and indexes of single polygons, is timed.
// What a library does not offer of a disc or a polygon is done for it, in the simplest way that is fast: two discs are
// compared in doubles, exactly only where these can be wrong.
#pragma once

#include <bench/inputs/set_scenarios.h>
#include <bench/peers/segment_peer.h>

#include <algorithm>
#include <vector>

namespace bench {

using SetQuestion = SegmentQuestion;  // any: 1, some two meet; 0: none. all: lists the pairs, and says how many.

struct SetWay {
  std::string_view library, method;
  // Prepares the input; empty where the way does not answer the question. The input outlives it.
  Asked (*make)(const SetInput&, SetQuestion);
};

// CGAL:
//   box_self_intersection_d, of boxes and of pointers to them: pairs whose boxes meet, each then decided: discs
//   exactly;
//     polygons by their edges in the common part of both boxes (do_intersect of segments) and a vertex of each
//     (bounded_side_2), or by Boolean operations (do_intersect of polygons).
//   do_curves_intersect, a sweep of all edges or circles: any. It sees neither what is inside, nor contacts of a vertex
//     with a vertex.
//   compute_intersection_points of all circles: all. It gives two points of each pair, and sees nothing inside.
std::vector<SetWay> cgal_set_ways();

// GEOS:
//   TemplateSTRtree, asked for each box, then each pair decided: discs in doubles; polygons with intersects, the first
//     one as it is or prepared (once for each polygon whose box another one meets, in the call).
//   isValid of all polygons as one: any. Touching in points is valid.
std::vector<SetWay> geos_set_ways();

// Boost.Geometry (plain doubles):
//   rtree of boxes, packed, asked for each box, then each pair decided: discs by comparable_distance, polygons with
//     intersects.
//   is_valid of all polygons as one: any. Touching in points is valid.
std::vector<SetWay> boost_set_ways();

struct Frame {  // the box of an object, rounded to the nearest: all numbers are on a grid on which that is exact
  Xy low, high;
};

inline Frame frame_of(const Disc& d) {
  return {{d.center.x - d.radius, d.center.y - d.radius}, {d.center.x + d.radius, d.center.y + d.radius}};
}

inline Frame frame_of(const Ring& ring) {
  Frame frame{ring.front(), ring.front()};
  for (const Xy& p : ring) {
    frame.low = {std::min(frame.low.x, p.x), std::min(frame.low.y, p.y)};
    frame.high = {std::max(frame.high.x, p.x), std::max(frame.high.y, p.y)};
  }
  return frame;
}

// Of all discs or of all polygons.
inline std::vector<Frame> frames_of(const SetInput& input) {
  std::vector<Frame> frames;
  for (const Disc& disc : input.discs) frames.push_back(frame_of(disc));
  for (const Ring& ring : input.rings) frames.push_back(frame_of(ring));
  return frames;
}

}  // namespace bench
