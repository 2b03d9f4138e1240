// Sets of segments for differential tests: small and nasty, from a seed.
#pragma once

#include <sunder/base/random.h>
#include <sunder/planar/object/segments.h>

#include <string_view>
#include <vector>

namespace sunder::tests {

enum class SegmentFamily : int {
  grid,       // on integer grids of side 4 to 8: every degeneracy is common
  sparse,     // short segments in the unit square, few of which meet
  collinear,  // along one line, nearly or exactly
  last_bit,   // ends on, or one unit in the last place off, other segments
  star,       // long ones that all pass near one place and do not meet, or two do
  any_scale,  // 1e-300 to 1e300, mixed
  mesh,       // edges of a jittered grid: shared ends everywhere
};
inline constexpr int segment_family_count = 7;
std::string_view name_of(SegmentFamily);

struct SegmentSet {
  SegmentFamily family;
  std::vector<planar::Segment> segments;
};

// An endless stream of sets, family after family in turn.
class SegmentSets {
 public:
  explicit SegmentSets(std::uint64_t seed) : random_(seed) {}
  SegmentSet next();
  Random& random() { return random_; }

 private:
  Random random_;
  int turn_ = 0;
};

}  // namespace sunder::tests
