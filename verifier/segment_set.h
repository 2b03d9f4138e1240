// Segments and the groups they are of, for the parts of the C++ verifier that look at edges: how two segments meet, and
// check T6 of docs/certificates.md.
#pragma once

#include "statement_reader.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace sunder_verifier {

struct Point {
  Integer x, y;

  friend bool operator==(const Point& p, const Point& q) { return p.x == q.x && p.y == q.y; }
  friend bool operator<(const Point& p, const Point& q) { return p.x < q.x || (p.x == q.x && p.y < q.y); }
};

// The first end is lexicographically not after the last.
struct Segment {
  Point first, last;
};

// The segments in units of 2^e. Where the file has no groups, each segment is one of its own.
struct SegmentSet {
  std::vector<Segment> segments;
  std::vector<std::int64_t> groups;
  bool has_groups = false;
  std::int64_t e = 0;
  std::size_t bits = 0;  // of the longest coordinate

  bool is_one_group(std::size_t i, std::size_t j) const { return groups[i] == groups[j]; }

  // Event 2 i is the first end of segment i, 2 i + 1 its last.
  const Point& end_of(std::size_t event) const {
    const Segment& s = segments[event / 2];
    return event % 2 == 1 ? s.last : s.first;
  }
};

// 1: p, q, r turn left; -1: right; 0: on one line.
int turn(const Point& p, const Point& q, const Point& r);

inline bool is_end(const Point& p, const Segment& s) { return p == s.first || p == s.last; }

inline constexpr std::array<const char*, 4> contact_kinds{"shared-endpoint", "touch", "crossing", "overlap"};

// How two segments meet: a kind, or "none".
std::string kind_of(const Segment& s, const Segment& t);

// T6: the ends at one point, and a segment that holds the point inside.
class Holders {
 public:
  explicit Holders(const SegmentSet& set) : set_(set) {}

  // The next end, and what stands next to its segment in the list; there, the number of segments is none. Throws
  // Refused where the check fails.
  void look(std::size_t event, std::size_t lower, std::size_t upper);

 private:
  const SegmentSet& set_;
  std::size_t first_ = 0, holder_ = 0;
  bool any_ = false, are_mixed_ = false, has_holder_ = false;
};

}  // namespace sunder_verifier
