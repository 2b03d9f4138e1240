// The list of a sweep over segments: docs/claims.md, "Sweeps".
#pragma once

#include <verifier/cpp/reader.h>
#include <verifier/cpp/sets.h>
#include <verifier/cpp/values.h>

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace sunder_verifier {

// x / w, y / w; w > 0.
struct SweepPoint {
  Integer x, y, w = 1;

  bool is(const PlanarPoint& p) const { return x == p.x * w && y == p.y * w; }
};

SweepPoint place_of(const PlanarPoint& p);
// A point in units of 2^exponent.
SweepPoint place_in_units(Numbers point, std::int64_t exponent);

// Is p lexicographically before q?
bool is_before(const SweepPoint& p, const SweepPoint& q);

// 1: the point is above the segment's line: left of it, seen from its first end.
int side(const PlanarSegment& s, const SweepPoint& p);

// 1: t turns to the left of s.
int turn(const PlanarSegment& s, const PlanarSegment& t);

bool is_point(const PlanarSegment& s);
bool is_on(const PlanarSegment& s, const SweepPoint& p);
bool ends_at(const PlanarSegment& s, const SweepPoint& p);

// Of a ring the edges of which some part may be at a point, or below it; `place` is the point in units of the table.
// Takes the steps.
std::vector<std::size_t> edges_near(const PolygonTable& polygons, const EdgeRange& ring, const Numbers& point,
                                    const SweepPoint& place);
// Is a point, which is on no edge, above an odd number of these edges?
bool is_above_odd(const PolygonTable& polygons, const std::vector<std::size_t>& edges, const SweepPoint& p);

// Event by event, which segments hold its point. Throws Refused by the rule `sweep`.
class Sweep {
 public:
  Sweep(const SweepEvents& events, const Segments& segments);

  // Of the event passed last.
  SweepPoint point;
  std::vector<std::size_t> here;                         // what was in the list, and holds the point
  const std::size_t *row = nullptr, *row_end = nullptr;  // what goes on from it
  std::size_t below = no_index;                          // what is just below it; no_index: nothing

  // Passes the next event. False: there is none, and the list is empty.
  bool next();

 private:
  static constexpr std::size_t kOut = no_index;

  // The words of the refusal are texts and numbers, put together only where they are needed.
  template <class... Words>
  void require_event(bool condition, const Words&... words) const {
    if (!condition) require(false, "sweep", ("event " + std::to_string(k_) + ... + word(words)));
  }
  static std::string word(const char* text) { return text; }
  static std::string word(std::size_t number) { return std::to_string(number); }

  void come_to_point();
  std::size_t take_out_from(std::size_t lower);
  void put_in(std::size_t lower, std::size_t upper);

  const SweepEvents& events_;
  const Segments& segments_;
  std::size_t k_ = 0, begun_ = 0, stay_ = 0;
  std::vector<std::size_t> above_;  // by segment: the next one in the list; out: it is not in
  std::vector<bool> has_begun_, stays_;
};

// A sweep of edges that each have an owner, a polygon or ring. A label is the set of those that cover some place.
class LabelledSweep : public Sweep {
 public:
  LabelledSweep(const SweepEvents& events, const Segments& edges, const std::vector<std::size_t>& owner)
      : Sweep(events, edges), edges_(edges), owner_(owner), above_(edges.size()) {}

  // Of the event passed last.
  std::vector<std::size_t> going;  // the edges of some length that go on from its point
  std::vector<Set> labels;         // of what is just below the first of these, and just above each

  // As of Sweep. Takes the steps.
  bool next();

 private:
  const Segments& edges_;
  const std::vector<std::size_t>& owner_;
  std::vector<Set> above_;  // the label above each edge of the list
};

}  // namespace sunder_verifier
