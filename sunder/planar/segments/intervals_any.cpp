#include <sunder/base/error.h>
#include <sunder/planar/segments/intervals_any.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>

namespace sunder::planar {

namespace {

void check(std::span<const LineInterval> intervals) {
  if (intervals.size() >= std::size_t{1} << 31) {
    throw Error(ErrorCode::bad_shape, "there are 2^31 intervals or more; split them");
  }
  for (std::size_t i = 0; i < intervals.size(); ++i) {
    const auto [low, high] = intervals[i];
    if (std::isfinite(low) && std::isfinite(high) && low <= high) continue;
    throw Error(ErrorCode::bad_value, "ends are finite, and the low one is not above the high one",
                "interval " + std::to_string(i));
  }
}

ContactKind kind_of(const LineInterval& a, const LineInterval& b) {
  const double low = std::max(a.low, b.low), high = std::min(a.high, b.high);
  if (low > high) return ContactKind::none;
  if (low < high) return ContactKind::overlap;
  const auto is_end = [&](const LineInterval& c) { return c.low == low || c.high == low; };
  return is_end(a) && is_end(b) ? ContactKind::shared_endpoint : ContactKind::touch;
}

bool report(IntervalsAnswer& answer, ContactKind kind, std::uint32_t i, std::uint32_t j, Allowed allowed) {
  ++answer.cost.probes;
  if (!counts(kind, allowed)) return false;
  answer.found = contact_of(i, j, kind);
  return true;
}

std::vector<std::uint32_t> in_order(std::span<const LineInterval> intervals, Cost& cost) {
  std::vector<std::uint32_t> order(intervals.size());
  std::iota(order.begin(), order.end(), 0u);
  std::sort(order.begin(), order.end(), [&](std::uint32_t i, std::uint32_t j) {
    ++cost.probes;
    const LineInterval &a = intervals[i], &b = intervals[j];
    if (a.low != b.low) return a.low < b.low;
    return a.high != b.high ? a.high < b.high : i < j;
  });
  return order;
}

}  // namespace

std::vector<std::uint32_t> intervals_in_order(std::span<const LineInterval> intervals) {
  check(intervals);
  Cost cost;
  return in_order(intervals, cost);
}

// By low end, then by high end. Whatever of those before meets the next one in a way that counts, the one that reaches
// furthest does too: it holds the next one's low end as well, as an inner point where the other does.
IntervalsAnswer intervals_any(std::span<const LineInterval> intervals, Allowed allowed) {
  check(intervals);
  IntervalsAnswer answer;
  const std::vector<std::uint32_t> order = in_order(intervals, answer.cost);
  for (std::size_t k = 1, furthest = 0; k < order.size(); ++k) {
    const LineInterval &a = intervals[order[furthest]], &b = intervals[order[k]];
    if (report(answer, kind_of(a, b), order[furthest], order[k], allowed)) return answer;
    if (b.high > a.high) furthest = k;
  }
  return answer;
}

IntervalsAnswer intervals_any_by_scan(std::span<const LineInterval> intervals, Allowed allowed) {
  check(intervals);
  IntervalsAnswer answer;
  for (std::uint32_t i = 0; i < intervals.size(); ++i) {
    for (std::uint32_t j = i + 1; j < intervals.size(); ++j) {
      if (report(answer, kind_of(intervals[i], intervals[j]), i, j, allowed)) return answer;
    }
  }
  return answer;
}

}  // namespace sunder::planar
