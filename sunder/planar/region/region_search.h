// The common part of half-planes that are sorted by angle: what the methods share. (The oracle does not use it.)
// Also called: envelope of lines, dual to a convex hull; half-plane intersection by sorting.
//
// A chain is the boundary of the common part of half-planes whose normals all point up, or all down: no two of them are
// antiparallel, so it is never empty, and a stack finds it (Andrew's hull, dual). A joint is where one chain ends and
// the other begins: the corner of a side of each that lies on both chains. It exists where the chains' outer sides turn
// by less than a half turn; elsewhere the region is unbounded that way.
//
// To find the joint of the chain B with the chain A after it, begin with the last side b of B and the first side a of
// A. While the corner of a and the next side of A is outside of b, all of a is: the half-plane of b, turning by less
// than a half turn to a, holds of the line of a what is after their corner. So a is dropped; where then the new a is a
// half turn or more from b, these two or three have no common point. The same for b, with the sides of B exchanged.
// Once neither is dropped the corner of a and b lies on both chains: the cut of b with a line of A only moves forward
// in B as sides are dropped. So then the region is not empty.
#pragma once

#include <sunder/base/interruption.h>
#include <sunder/planar/region/half_plane_intersection.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <type_traits>
#include <utility>
#include <vector>

namespace sunder::planar {

// The predicates by number, counted.
template <class Given>
class Signs {
 public:
  explicit Signs(const Given& given) : given_(given) {}

  bool points_down(std::uint32_t i) { return sunder::points_down(given_[i]); }
  Sign turn(std::uint32_t i, std::uint32_t j) { return ++probes_, sunder::turn(given_[i], given_[j], &tally_); }
  Sign facing(std::uint32_t i, std::uint32_t j) { return ++probes_, sunder::facing(given_[i], given_[j], &tally_); }
  Sign tighter(std::uint32_t i, std::uint32_t j) { return ++probes_, sunder::tighter(given_[i], given_[j], &tally_); }
  Sign gap(std::uint32_t i, std::uint32_t j) { return ++probes_, sunder::gap(given_[i], given_[j], &tally_); }
  Sign corner_side(std::uint32_t i, std::uint32_t j, std::uint32_t k) {
    return ++probes_, sunder::corner_side(given_[i], given_[j], given_[k], &tally_);
  }

  Sign counted(Sign sign) { return ++probes_, sign; }
  void count(std::uint64_t signs) { probes_ += signs; }

  bool same_direction(std::uint32_t i, std::uint32_t j) {
    return points_down(i) == points_down(j) && turn(i, j) == Sign::zero;
  }

  // By angle, then the tighter one first, then the lower number.
  bool is_before(std::uint32_t i, std::uint32_t j) {
    if (points_down(i) != points_down(j)) return points_down(j);
    const Sign by_angle = turn(i, j);
    if (by_angle != Sign::zero) return by_angle == Sign::positive;
    return is_tighter_or_lower(i, j);
  }

  // Of two of one direction: the tighter one first, then the lower number.
  bool is_tighter_or_lower(std::uint32_t i, std::uint32_t j) {
    const Sign by_offset = tighter(i, j);
    return by_offset != Sign::zero ? by_offset == Sign::positive : i < j;
  }

  // Half-planes are looked at in the order of angles, which in memory is any order.
  void prefetch(std::span<const std::uint32_t> numbers, std::size_t n) const {
    constexpr std::size_t ahead = 16;
    if constexpr (std::is_reference_v<decltype(given_[0])>) {
      if (n + ahead < numbers.size()) __builtin_prefetch(&given_[numbers[n + ahead]]);
    }
  }

  const Given& given() const { return given_; }
  void add_to(Cost& cost) const {
    cost.probes += probes_;
    cost.exact += tally_.exact;
  }

 private:
  const Given& given_;
  StageTally tally_;
  std::uint64_t probes_ = 0;
};

// Two chains with their joints. The region is that of the sides alone; ties of lower dimensions are not settled yet.
// Within a chain each side, between its neighbours, has more than a point of the boundary.
struct Chains {
  std::vector<std::uint32_t> contradiction;  // not empty: the region is
  std::vector<std::uint32_t> up, down;       // in the order of angles
  bool right = false, left = false;          // from `down` to `up`, from `up` to `down`: is there a corner?
};

namespace region_detail {

// One half-plane for each direction, those of normals that point up or those that point down, in the order of angles:
// leaves those with a part of the common boundary that is more than a point.
template <class Given>
void to_chain(Signs<Given>& signs, std::vector<std::uint32_t>& sides) {
  std::size_t count = 0;
  for (std::size_t n = 0; n < sides.size(); ++n) {
    if (n % 1024 == 0) may_be_interrupted(1024);
    const std::uint32_t next = sides[n];
    signs.prefetch(sides, n);
    while (count >= 2 && signs.corner_side(sides[count - 2], sides[count - 1], next) != Sign::negative) --count;
    sides[count++] = next;
  }
  sides.resize(count);
}

struct Joint {
  bool exists = false;
  std::size_t last_before = 0, first_after = 0;  // the last side of the chain before, the first of the one after
  std::vector<std::uint32_t> contradiction;
};

template <class Given>
Joint joint_of(Signs<Given>& signs, std::span<const std::uint32_t> before, std::span<const std::uint32_t> after) {
  if (before.empty() || after.empty()) return {};
  std::size_t b = before.size() - 1, a = 0;
  Joint none{false, b, a, {}};
  const Sign turn = signs.turn(before[b], after[a]);
  if (turn == Sign::negative) return none;
  if (turn == Sign::zero) {
    if (signs.gap(before[b], after[a]) != Sign::negative) return none;
    return {false, 0, 0, {before[b], after[a]}};
  }
  for (;;) {
    const bool drop_a = a + 1 < after.size() && signs.corner_side(after[a], after[a + 1], before[b]) == Sign::positive;
    const bool drop_b = !drop_a && b > 0 && signs.corner_side(before[b - 1], before[b], after[a]) == Sign::positive;
    if (!drop_a && !drop_b) return {true, b, a, {}};
    const std::array<std::uint32_t, 3> three =
        drop_a ? std::array{before[b], after[a], after[a + 1]} : std::array{before[b - 1], before[b], after[a]};
    if (drop_a) ++a;
    if (drop_b) --b;
    const Sign left = signs.turn(three[0], three[2]);
    if (left == Sign::zero) return {false, 0, 0, {three[0], three[2]}};
    if (left == Sign::negative) return {false, 0, 0, {three.begin(), three.end()}};
  }
}

}  // namespace region_detail

// The common part of half-planes in the order is_before, one of each direction: a tightest one.
// Cost: O(n) signs for n of them.
template <class Given>
Chains common_part_of_sorted(Signs<Given>& signs, std::span<const std::uint32_t> sorted) {
  Chains chains;
  const auto middle =
      std::partition_point(sorted.begin(), sorted.end(), [&](std::uint32_t i) { return !signs.points_down(i); });
  chains.up.assign(sorted.begin(), middle);
  chains.down.assign(middle, sorted.end());
  region_detail::to_chain(signs, chains.up);
  region_detail::to_chain(signs, chains.down);
  region_detail::Joint right = region_detail::joint_of(signs, chains.down, chains.up);
  if (right.contradiction.empty()) {
    region_detail::Joint left = region_detail::joint_of(signs, chains.up, chains.down);
    chains.right = right.exists;
    chains.left = left.exists;
    chains.contradiction = std::move(left.contradiction);
    const auto keep = [](std::vector<std::uint32_t>& chain, std::size_t first, std::size_t last) {
      chain.resize(last + 1);
      chain.erase(chain.begin(), chain.begin() + static_cast<std::ptrdiff_t>(first));
    };
    if (chains.up.empty() || chains.down.empty()) return chains;
    keep(chains.up, right.first_after, left.exists ? left.last_before : chains.up.size() - 1);
    keep(chains.down, left.exists ? left.first_after : 0, right.exists ? right.last_before : chains.down.size() - 1);
  } else {
    chains.contradiction = std::move(right.contradiction);
  }
  return chains;
}

// The chain that comes first, from the gap on where there is one joint alone.
inline const std::vector<std::uint32_t>& first_of(const Chains& chains) {
  return chains.right && !chains.left ? chains.down : chains.up;
}

// The sides of both chains, in turn.
inline std::vector<std::uint32_t> sides_in_turn(const Chains& chains) {
  const std::vector<std::uint32_t>& first = first_of(chains);
  const std::vector<std::uint32_t>& second = &first == &chains.up ? chains.down : chains.up;
  std::vector<std::uint32_t> sides;
  sides.reserve(first.size() + second.size());
  sides.insert(sides.end(), first.begin(), first.end());
  sides.insert(sides.end(), second.begin(), second.end());
  return sides;
}

// The region of the chains, whose common part is that of all that are given; ties are settled among these.
// Cost: O(sides) signs; O(N) for a point, a segment or a ray, and with evidence O(N log N).
template <class Given>
Region region_of(Signs<Given>& signs, const Chains& chains, const RegionOptions& options);

// For one of them: the position p in the sides of what Region::cones says. Requires that the region is a part of it.
template <class Given>
std::uint32_t cone_of(Signs<Given>& signs, const Region& region, std::uint32_t k);

// Fills in region.cones. Requires a region that is not empty. Cost: O(N log N) signs.
template <class Given>
void add_cones(Signs<Given>& signs, Region& region);

}  // namespace sunder::planar
