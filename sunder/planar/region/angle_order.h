// Half-planes in the order of their normals' angles.
// Also called: angular sort, polar sort.
//
// A key in doubles that grows with the angle sorts what it can tell apart; half-planes whose keys are nearer than its
// error are sorted by exact signs.
#pragma once

#include <sunder/planar/region/region_search.h>
#include <sunder/planar/region/side_table.h>

#include <algorithm>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace sunder::planar {

namespace angle_order_detail {

struct Keyed {
  double key;
  std::uint32_t number;
};

}  // namespace angle_order_detail

// Of those numbers one half-plane for each direction, the tightest one of the lowest number, in the order of angles.
// Cost: O(N log N) comparisons, of which signs only where directions are nearly the same.
template <class Given>
std::vector<std::uint32_t> tightest_by_angle(Signs<Given>& signs, std::vector<angle_order_detail::Keyed> keyed) {
  using angle_order_detail::Keyed;
  std::sort(keyed.begin(), keyed.end(),
            [](const Keyed& x, const Keyed& y) { return x.key < y.key || (x.key == y.key && x.number < y.number); });
  std::vector<std::uint32_t> sorted;
  sorted.reserve(keyed.size());
  for (auto first = keyed.begin(), last = first; first != keyed.end(); first = last) {
    for (last = first + 1; last != keyed.end(); ++last) {
      if (last->key - (last - 1)->key > 2 * side_table_detail::key_error) break;
    }
    // Nearly always all of one direction. Sorted are those of which one follows the other that are not.
    auto kept = first;
    for (auto next = first + 1; next != last; ++next) {
      if (!signs.same_direction(kept->number, next->number)) {
        *++kept = *next;
      } else if (signs.is_tighter_or_lower(next->number, kept->number)) {
        *kept = *next;
      }
    }
    std::sort(first, kept + 1, [&](const Keyed& x, const Keyed& y) { return signs.is_before(x.number, y.number); });
    sorted.push_back(first->number);
    for (auto next = first + 1; next != kept + 1; ++next) {
      if (!signs.same_direction(sorted.back(), next->number)) sorted.push_back(next->number);
    }
  }
  return sorted;
}

template <class Given>
std::vector<std::uint32_t> tightest_by_angle(Signs<Given>& signs) {
  std::vector<angle_order_detail::Keyed> keyed(signs.given().size());
  for (std::uint32_t i = 0; i < keyed.size(); ++i) keyed[i] = {side_table_detail::key_of(signs.given()[i]), i};
  return tightest_by_angle(signs, std::move(keyed));
}

template <class Given>
std::vector<std::uint32_t> tightest_by_angle(Signs<Given>& signs, std::span<const std::uint32_t> numbers) {
  std::vector<angle_order_detail::Keyed> keyed;
  keyed.reserve(numbers.size());
  for (const std::uint32_t i : numbers) keyed.push_back({side_table_detail::key_of(signs.given()[i]), i});
  return tightest_by_angle(signs, std::move(keyed));
}

// The position p in the sides, where the table proposes one so that the normal of k lies between those of sides p and
// p + 1, or is one of them. Cost: two signs. Requires that the region has a corner.
template <class Given>
std::optional<std::uint32_t> cone_in(Signs<Given>& signs, const Region& region, const SideTable& table,
                                     std::uint32_t k) {
  const auto n = static_cast<std::uint32_t>(region.sides.size());
  const bool open = region.kind == RegionKind::unbounded || region.kind == RegionKind::ray;
  std::uint32_t p = table.position(signs.given()[k]);
  if (open && p + 1 == n) --p;
  const std::uint32_t next = p + 1 == n ? 0 : p + 1;
  const bool is_between =
      signs.turn(region.sides[p], k) != Sign::negative && signs.turn(k, region.sides[next]) != Sign::negative;
  return is_between ? std::optional(p) : std::nullopt;
}

}  // namespace sunder::planar
