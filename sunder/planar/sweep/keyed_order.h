// Numbers in the order of doubles, many of them, fast: a radix sort by the leading bits in which they differ, then
// comparisons among those that are equal there.
// Also called: radix sort; bucket sort.
#pragma once

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace sunder::planar {

struct KeyedItem {
  std::uint64_t key;  // key_of a double
  std::uint32_t item;
};

// Numbers in the order of doubles, also infinite ones. -0 and 0 have one.
inline std::uint64_t key_of(double x) {
  const std::uint64_t bits = std::bit_cast<std::uint64_t>(x + 0.0), sign = std::uint64_t{1} << 63;
  return (bits & sign) != 0 ? ~bits : bits | sign;
}

// Sorts by `key >> shift` for the shift that it returns: keeps the order given where these are equal. Linear.
int sort_by_leading_bits(std::vector<KeyedItem>& items);

// Sorts by key; of equal keys by `before`(item, item), a strict order. Cost: O(N log N) comparisons at worst; for many
// that differ in their leading bits, or where those that do not are given in order, three passes and little more.
template <class Before>
void sort_by_key(std::vector<KeyedItem>& items, const Before& before) {
  const auto less = [&before](const KeyedItem& a, const KeyedItem& b) {
    return a.key != b.key ? a.key < b.key : before(a.item, b.item);
  };
  constexpr std::size_t worth_a_radix_sort = 2000;
  if (items.size() < worth_a_radix_sort) {
    std::sort(items.begin(), items.end(), less);
    return;
  }
  const int shift = sort_by_leading_bits(items);
  for (std::size_t run = 0, end; run < items.size(); run = end) {
    for (end = run + 1; end < items.size() && items[run].key >> shift == items[end].key >> shift;) ++end;
    const auto from = items.begin() + static_cast<std::ptrdiff_t>(run);
    const auto to = items.begin() + static_cast<std::ptrdiff_t>(end);
    if (end - run > 1 && !std::is_sorted(from, to, less)) std::sort(from, to, less);  // long runs often are
  }
}

}  // namespace sunder::planar
