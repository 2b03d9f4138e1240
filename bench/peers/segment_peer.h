// The other libraries of bench_segments behind one interface.
//
// A way of asking is right on an input where it gives the answer that is known; of each library the fastest way that is
// right counts. Every library prepares its own segments, points, lines and boxes outside of the timed loop, as Sunder
// does with Segments and Polygon; what an algorithm builds to answer (trees, sorted boxes) is timed.
//
// Rules differ. Sunder allows exactly one common point that is an end of both, or nothing at all. The ways below that
// say "ends" never see such a contact, so they could not answer under the rule `nothing` in general; inputs asked under
// that rule have no shared ends, and they are let in.
#pragma once

#include <bench/contest/contest.h>
#include <bench/inputs/segment_scenarios.h>

#include <cstdint>
#include <functional>
#include <string_view>
#include <utility>
#include <vector>

namespace bench {

enum class SegmentQuestion : std::uint8_t {
  any,     // 1: some two meet in a way that counts; 0: none
  simple,  // 1: the ring is a simple polygon; 0: it is not
  all,     // lists the pairs that meet in a way that counts, as indices, in memory; says how many
  count,   // says how many
};

struct SegmentWay {
  std::string_view library, method;
  // Prepares the input; empty where the way does not answer the question. The input outlives it.
  Asked (*make)(const SegmentInput&, SegmentQuestion);
};

// CGAL: ways that sweep, and its boxes.
//   do_curves_intersect (ends): any; two segments that overlap, too. With exact constructions and cached segments, and
//     with predicates only, which suffices as it stops at the first contact.
//   compute_intersection_points (ends): the points, not which segments; a point of three segments once, not thrice.
//     (None of the inputs has one, but where ends are shared.)
//   box_self_intersection_d, of boxes and of pointers to them: pairs whose boxes meet, each then decided exactly.
//   is_simple_2: the polygon.
std::vector<SegmentWay> cgal_segment_ways();

// GEOS:
//   isSimple of the lines (ends): any.
//   FastNodingValidator (ends): any.
//   MCIndexNoder with a SegmentIntersector of ours that decides pairs: all.
//   STRtree: asked for each segment's box, then each pair decided with Orientation::index.
//   isValid and isSimple of the polygon. (The latter is of rings only; there is one.)
std::vector<SegmentWay> geos_segment_ways();

// Boost.Geometry (plain doubles):
//   is_simple of the lines (ends): any. intersects of the lines: any, where shared ends are not allowed.
//   rtree of boxes, and rtree of segments, packed; asked for each segment, then each pair decided with intersects.
//   is_valid of the polygon; is_simple of its boundary as a line. (Version 1.74 calls none of our closed lines simple.)
std::vector<SegmentWay> boost_segment_ways();

// What peers' ways have in common where they find candidate pairs and decide each.

struct Found {};  // thrown through libraries that cannot be stopped otherwise

// Does the pair count? turn(p, q, r): the sign of the turn; meet(): do they meet at all?
template <class Turn, class Meet>
bool pair_counts(const Line& s, const Line& t, bool shared_ends, const Turn& turn, const Meet& meet) {
  if (shared_ends) {
    const auto overlap = [&](const Xy& p, const Xy& q, const Xy& r) {  // pq and pr in one direction?
      if (turn(p, q, r) != 0) return false;
      return p.x == q.x ? (p.y < q.y) == (p.y < r.y) : (p.x < q.x) == (p.x < r.x);
    };
    if (s.a == t.a) return s.b == t.b || overlap(s.a, s.b, t.b);
    if (s.a == t.b) return s.b == t.a || overlap(s.a, s.b, t.a);
    if (s.b == t.a) return overlap(s.b, s.a, t.b);
    if (s.b == t.b) return overlap(s.b, s.a, t.a);
  }
  return meet();
}

// Takes the pairs that count.
class PairSink {
 public:
  explicit PairSink(SegmentQuestion question) : question_(question) {}
  // False: enough.
  bool take(std::uint32_t i, std::uint32_t j) {
    ++count_;
    if (question_ == SegmentQuestion::all) pairs_.emplace_back(i, j);
    return question_ != SegmentQuestion::any;
  }
  std::uint64_t count() const { return count_; }

 private:
  SegmentQuestion question_;
  std::uint64_t count_ = 0;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs_;
};

}  // namespace bench
