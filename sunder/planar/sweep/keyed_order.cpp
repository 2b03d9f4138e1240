#include <sunder/planar/sweep/keyed_order.h>

#include <array>
#include <utility>

namespace sunder::planar {

namespace {

constexpr int digit_bits = 11, digits = 3;

}  // namespace

int sort_by_leading_bits(std::vector<KeyedItem>& items) {
  std::uint64_t least = ~std::uint64_t{0}, greatest = 0;
  for (const KeyedItem& e : items) {
    least = std::min(least, e.key);
    greatest = std::max(greatest, e.key);
  }
  const int shift = std::max(0, static_cast<int>(std::bit_width(least ^ greatest)) - digits * digit_bits);
  const auto digit = [shift](const KeyedItem& e, std::size_t d) {
    return std::size_t{e.key >> shift >> (d * digit_bits)} & ((std::size_t{1} << digit_bits) - 1);
  };
  std::array<std::array<std::uint32_t, std::size_t{1} << digit_bits>, digits> place{};
  for (const KeyedItem& e : items) {
    for (std::size_t d = 0; d < digits; ++d) ++place[d][digit(e, d)];
  }
  std::vector<KeyedItem> other(items.size());
  for (std::size_t d = 0; d < digits; ++d) {
    std::uint32_t before = 0;
    for (std::uint32_t& p : place[d]) before += std::exchange(p, before);
    for (const KeyedItem& e : items) other[place[d][digit(e, d)]++] = e;
    std::swap(items, other);
  }
  return shift;
}

}  // namespace sunder::planar
