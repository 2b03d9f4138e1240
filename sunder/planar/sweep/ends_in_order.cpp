// Radix sort by the leading bits of x, then comparisons among those that are equal there.
#include <sunder/base/contract.h>
#include <sunder/base/interruption.h>
#include <sunder/base/prefetch.h>
#include <sunder/planar/sweep/ends_in_order.h>
#include <sunder/planar/sweep/keyed_order.h>

#include <algorithm>
#include <array>
#include <bit>
#include <span>
#include <utility>
#include <vector>

namespace sunder::planar {

namespace {

// The leading 32 bits in which abscissas differ, then the number of the end.
using Entry = std::uint64_t;
std::uint32_t end_of(Entry e) { return static_cast<std::uint32_t>(e); }
std::uint64_t leading_bits(Entry e) { return e >> 32; }

// Last ends, then points, then first ends.
int rank(const Segment& s, std::uint32_t end) { return s.a == s.b ? 1 : end % 2 == 0 ? 2 : 0; }

class Less {
 public:
  explicit Less(std::span<const Segment> segments) : segments_(segments) {}
  bool operator()(Entry e, Entry f) const {
    if (leading_bits(e) != leading_bits(f)) return e < f;
    const Point2 &p = end_point(segments_, end_of(e)), &q = end_point(segments_, end_of(f));
    if (p.x != q.x) return p.x < q.x;
    if (p.y != q.y) return p.y < q.y;
    const int r = rank(segments_[end_of(e) / 2], end_of(e)), s = rank(segments_[end_of(f) / 2], end_of(f));
    return r != s ? r < s : end_of(e) < end_of(f);
  }

 private:
  std::span<const Segment> segments_;
};

constexpr std::size_t key_digits = 3;
constexpr std::array<int, key_digits + 1> digit_begins{32, 43, 54, 64};
constexpr std::size_t worth_a_radix_sort = 2000;

void sort_by_digits(std::vector<Entry>& entries) {
  std::vector<Entry> other(entries.size());
  std::array<std::array<std::uint32_t, 1 << 11>, key_digits> place{};
  const auto digit = [](Entry e, std::size_t d) {
    const int bits = digit_begins[d + 1] - digit_begins[d];
    return std::size_t{e >> digit_begins[d]} & ((std::size_t{1} << bits) - 1);
  };
  for (const Entry e : entries) {
    for (std::size_t d = 0; d < key_digits; ++d) ++place[d][digit(e, d)];
  }
  for (std::size_t d = 0; d < key_digits; ++d) {
    std::uint32_t before = 0;
    for (std::uint32_t& p : place[d]) before += std::exchange(p, before);
    for (const Entry e : entries) other[place[d][digit(e, d)]++] = e;
    may_be_interrupted(static_cast<std::uint32_t>(std::min<std::size_t>(entries.size() / 16, 1u << 30)));
    std::swap(entries, other);
  }
}

std::vector<Entry> entries_of(std::span<const Segment> segments) {
  std::uint64_t least = ~std::uint64_t{0}, greatest = 0;
  for (const Segment& s : segments) {
    least = std::min(least, key_of(s.a.x));
    greatest = std::max(greatest, key_of(s.b.x));
  }
  // The bits in which keys differ, or the leading ones of these.
  const int shift = std::max(0, static_cast<int>(std::bit_width(least ^ greatest)) - 32);
  std::vector<Entry> entries;
  entries.reserve(2 * segments.size());
  for (std::uint32_t i = 0; i < segments.size(); ++i) {
    entries.push_back(key_of(segments[i].a.x) >> shift << 32 | 2 * i);
    entries.push_back(key_of(segments[i].b.x) >> shift << 32 | (2 * i + 1));
  }
  return entries;
}

// Of many ends in the order of their numbers, where all are at one point: puts them in order without comparisons.
bool put_in_order_at_one_point(std::span<const Segment> segments, std::span<Entry> entries) {
  constexpr std::size_t many = 32;
  if (entries.size() < many) return false;
  const Point2& p = end_point(segments, end_of(entries[0]));
  if (!std::all_of(entries.begin(), entries.end(), [&](Entry e) { return end_point(segments, end_of(e)) == p; })) {
    return false;
  }
  const auto rank_of = [&](Entry e) { return static_cast<std::size_t>(rank(segments[end_of(e) / 2], end_of(e))); };
  std::array<std::size_t, 3> place{};
  for (const Entry e : entries) ++place[rank_of(e)];
  std::size_t before = 0;
  for (std::size_t& next : place) before += std::exchange(next, before);
  std::vector<Entry> ordered(entries.size());
  for (const Entry e : entries) ordered[place[rank_of(e)]++] = e;
  std::copy(ordered.begin(), ordered.end(), entries.begin());
  return true;
}

}  // namespace

std::vector<std::uint32_t> ends_in_order(std::span<const Segment> segments) {
  SUNDER_REQUIRE(segments.size() < std::size_t{1} << 31);
  std::vector<Entry> entries = entries_of(segments);
  const Less less(segments);
  if (entries.size() < worth_a_radix_sort) {
    std::sort(entries.begin(), entries.end(), less);
  } else {
    sort_by_digits(entries);
    const auto are_equal = [&](std::size_t k, std::size_t l) {
      return leading_bits(entries[k]) == leading_bits(entries[l]);
    };
    constexpr std::size_t ahead = 16;
    for (std::size_t run = 0, end; run < entries.size(); run = end) {
      for (end = run + 1; end < entries.size() && are_equal(run, end);) ++end;
      if (run / 4096 != end / 4096) may_be_interrupted(4096);
      for (std::size_t k = run + ahead; k < std::min(end + ahead, entries.size()); ++k) {  // where it will compare
        if (are_equal(k - 1, k)) {
          prefetch(segments[end_of(entries[k - 1]) / 2]);
          prefetch(segments[end_of(entries[k]) / 2]);
        }
      }
      const std::span<Entry> same(entries.data() + run, end - run);
      if (same.size() > 1 && !put_in_order_at_one_point(segments, same)) std::sort(same.begin(), same.end(), less);
    }
  }
  std::vector<std::uint32_t> ends(entries.size());
  std::transform(entries.begin(), entries.end(), ends.begin(), end_of);
  return ends;
}

}  // namespace sunder::planar
