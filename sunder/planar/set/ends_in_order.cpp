// Radix sort by the leading bits of x, then comparisons among those that are equal there.
#include <sunder/planar/set/ends_in_order.h>

#include <algorithm>
#include <array>
#include <bit>
#include <utility>

namespace sunder::planar {

namespace {

struct Entry {
  std::uint64_t key;  // in the order of x
  std::uint32_t end;
};

// Numbers in the order of doubles. -0 and 0 have one.
std::uint64_t key_of(double x) {
  const std::uint64_t bits = std::bit_cast<std::uint64_t>(x + 0.0), sign = std::uint64_t{1} << 63;
  return (bits & sign) != 0 ? ~bits : bits | sign;
}

// Last ends, then points, then first ends.
int rank(const Segment& s, std::uint32_t end) { return s.a == s.b ? 1 : end % 2 == 0 ? 2 : 0; }

class Less {
 public:
  explicit Less(std::span<const Segment> segments) : segments_(segments) {}
  bool operator()(const Entry& e, const Entry& f) const {
    if (e.key != f.key) return e.key < f.key;
    const double y = end_point(segments_, e.end).y, z = end_point(segments_, f.end).y;
    if (y != z) return y < z;
    const int r = rank(segments_[e.end / 2], e.end), q = rank(segments_[f.end / 2], f.end);
    return r != q ? r < q : e.end < f.end;
  }

 private:
  std::span<const Segment> segments_;
};

constexpr int digit_bits = 11, digits = 3;
constexpr std::size_t worth_a_radix_sort = 2000;

// Sorts by (key >> shift), of digits * digit_bits bits.
void sort_by_digits(std::vector<Entry>& entries, int shift) {
  std::vector<Entry> other(entries.size());
  std::array<std::array<std::uint32_t, 1 << digit_bits>, digits> place{};
  const auto digit = [&](const Entry& e, int d) {
    return std::size_t{e.key >> (shift + d * digit_bits)} & ((1 << digit_bits) - 1);
  };
  for (const Entry& e : entries) {
    for (int d = 0; d < digits; ++d) ++place[static_cast<std::size_t>(d)][digit(e, d)];
  }
  for (int d = 0; d < digits; ++d) {
    std::uint32_t before = 0;
    for (std::uint32_t& p : place[static_cast<std::size_t>(d)]) before += std::exchange(p, before);
    for (const Entry& e : entries) other[place[static_cast<std::size_t>(d)][digit(e, d)]++] = e;
    std::swap(entries, other);
  }
}

}  // namespace

std::vector<std::uint32_t> ends_in_order(std::span<const Segment> segments) {
  std::vector<Entry> entries;
  entries.reserve(2 * segments.size());
  std::uint64_t least = ~std::uint64_t{0}, greatest = 0;
  for (std::uint32_t i = 0; i < segments.size(); ++i) {
    const std::uint64_t first = key_of(segments[i].a.x), last = key_of(segments[i].b.x);
    least = std::min(least, first);
    greatest = std::max(greatest, last);
    entries.push_back({first, 2 * i});
    entries.push_back({last, 2 * i + 1});
  }
  const Less less(segments);
  if (entries.size() < worth_a_radix_sort) {
    std::sort(entries.begin(), entries.end(), less);
  } else {
    // The bits in which keys differ, or the leading ones of these.
    const int shift = std::max(0, static_cast<int>(std::bit_width(least ^ greatest)) - digits * digit_bits);
    sort_by_digits(entries, shift);
    const auto are_equal = [&](std::size_t k, std::size_t l) {
      return entries[k].key >> shift == entries[l].key >> shift;
    };
    constexpr std::size_t ahead = 16;
    for (std::size_t run = 0, end; run < entries.size(); run = end) {
      for (end = run + 1; end < entries.size() && are_equal(run, end);) ++end;
      for (std::size_t k = run + ahead; k < std::min(end + ahead, entries.size()); ++k) {  // where it will compare
        if (are_equal(k - 1, k)) {
          __builtin_prefetch(&segments[entries[k - 1].end / 2]);
          __builtin_prefetch(&segments[entries[k].end / 2]);
        }
      }
      const auto at = entries.begin() + static_cast<std::ptrdiff_t>(run);
      if (end - run > 1) std::sort(at, at + static_cast<std::ptrdiff_t>(end - run), less);
    }
  }
  std::vector<std::uint32_t> ends(entries.size());
  std::transform(entries.begin(), entries.end(), ends.begin(), [](const Entry& e) { return e.end; });
  return ends;
}

}  // namespace sunder::planar
