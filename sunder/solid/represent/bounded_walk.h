// From the top of a bounded hierarchy to the vertex of the polyhedron that is extreme along a direction.
// Also called: extreme vertex query, support.
//
// Let v be extreme on a level.
//   V1. If v is a vertex of the level below, then it is extreme there too, or one of its neighbours that come there is
//       strictly further, and that one is extreme (BL15 Lemma 4.2): all of them are looked at, of which there are at
//       most half as many as v has neighbours.
//   V2. If v is a cut point whose parent w comes, then w is extreme. For v is inside of an edge of the level below, from
//       w to x. If x were further than v, then so would be x, or the cut point near it, on the level of v. So w is at
//       least as far as v. And if w were not extreme, then an edge from w would lead to what is further, and the cut
//       point on it would be further than w.
// Ranks on the way ascend, so the list of each vertex is read from its beginning.
//
// Source: BL15 section 4; Dobkin and Kirkpatrick 1990 have the same walk on a hierarchy without bounded degrees.
#pragma once

#include <sunder/number/sign.h>
#include <sunder/solid/represent/bounded_hierarchy.h>

#include <cstdint>

namespace sunder::solid {

// compare(i, j): is rank j further along than rank i? Where it is exact, so is the answer; else it is some vertex. Adds
// the vertices asked about to `probes`. Cost: O(log n) probes.
template <class Compare>
class BoundedWalk {
 public:
  BoundedWalk(const BoundedHierarchy& hierarchy, const Compare& compare, std::uint64_t& probes)
      : hierarchy_(hierarchy), compare_(compare), probes_(probes) {}

  // The rank of the extreme vertex of the level with this end; of the polyhedron.
  std::uint32_t run(std::uint32_t end = BoundedHierarchy::none) {
    start();
    return go_on(end);
  }

  // In pieces: from the top, along what may be another direction than before, and then on to ever lower levels.
  void start() {
    std::uint32_t best = 0;
    const std::uint32_t corners = hierarchy_.levels.front().end;
    for (std::uint32_t k = 1; k < corners; ++k) {
      if (compare_(best, k) == Sign::positive) best = k;
    }
    probes_ += corners;
    go_to(best);
  }
  std::uint32_t go_on(std::uint32_t end) {
    for (std::uint32_t w = next(); w < end; w = next()) {
      if (is_further(w)) {
        go_to(w);
      } else {
        pass(w);
      }
    }
    return at_;
  }

  // A step at a time: the rank that comes next where the walk is, or none; is it further than what it is at, or the
  // parent of it? Then go_to it, else pass it.
  std::uint32_t next() const { return place_ < end_ ? hierarchy_.comers[place_] : parent_; }
  bool is_further(std::uint32_t w) {
    ++probes_;
    return w == parent_ || compare_(at_, w) == Sign::positive;
  }
  // w may be any rank: the walk goes on from where w comes, along what may be another direction than before, along
  // which w must be extreme there.
  void go_to(std::uint32_t w) {
    at_ = w;
    place_ = hierarchy_.nodes[w].begin;
    end_ = hierarchy_.nodes[w].end;
    parent_ = hierarchy_.parent_of(w);
  }
  void pass(std::uint32_t) { ++place_; }

  std::uint32_t at() const { return at_; }  // the rank that is extreme so far

 private:
  const BoundedHierarchy& hierarchy_;
  const Compare& compare_;
  std::uint64_t& probes_;
  std::uint32_t at_ = 0;               // the extreme one so far
  std::uint32_t place_ = 0, end_ = 0;  // what is left of its list
  std::uint32_t parent_ = BoundedHierarchy::none;
};

}  // namespace sunder::solid
