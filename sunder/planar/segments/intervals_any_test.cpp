// Intervals on a line: as segments of the x-axis they have the same contacts; the order proves that there are none.
#include <sunder/base/error.h>
#include <sunder/base/random.h>
#include <sunder/planar/segments/intervals_any.h>
#include <sunder/planar/segments/segments_any.h>

#include <tests/support/shapes.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

namespace sunder::planar {
namespace {

constexpr Allowed rules[] = {Allowed::nothing, Allowed::shared_endpoint, Allowed::touch};

TEST(IntervalsAnyTest, AgreesWithTheScanAndWithSegments) {
  Random random(211);
  int meets = 0, none = 0;
  for (int k = 0; k < 20000; ++k) {
    std::vector<LineInterval> intervals;
    std::vector<Segment> segments;
    const std::uint64_t n = random.below(7), side = 3 + random.below(20);
    for (std::uint64_t i = 0; i < n; ++i) {
      const double low = static_cast<double>(random.below(side)), high = low + static_cast<double>(random.below(4));
      intervals.push_back({low, high});
      segments.push_back({{low, 0}, {high, 0}});
    }
    for (const Allowed allowed : rules) {
      const IntervalsAnswer answer = intervals_any(intervals, allowed);
      ASSERT_EQ(answer.meet(), intervals_any_by_scan(intervals, allowed).meet()) << k;
      ASSERT_EQ(answer.meet(), segments_any_by_scan(Segments(segments), {allowed}).meet()) << k;
      ++(answer.meet() ? meets : none);
      if (answer.meet()) {
        ASSERT_LT(answer.found->i, answer.found->j);
        ASSERT_EQ(answer.found->kind, segment_segment(segments[answer.found->i], segments[answer.found->j]));
        continue;
      }
      const std::vector<std::uint32_t> order = intervals_in_order(intervals);
      ASSERT_EQ(std::set<std::uint32_t>(order.begin(), order.end()).size(), n);
      std::vector<LineInterval> in_turn;
      for (const std::uint32_t i : order) {
        const bool is_point = intervals[i].low == intervals[i].high;
        if (allowed != Allowed::touch || !is_point) in_turn.push_back(intervals[i]);
      }
      for (std::size_t i = 1; i < in_turn.size(); ++i) {
        const LineInterval &a = in_turn[i - 1], &b = in_turn[i];
        ASSERT_TRUE(a.high < b.low || (allowed != Allowed::nothing && a.high == b.low)) << k;
      }
    }
  }
  EXPECT_GT(meets, 10000);
  EXPECT_GT(none, 10000);
}

TEST(IntervalsAnyTest, ComparisonsGrowAsNLogN) {
  Random random(223);
  for (std::uint32_t n = 64; n <= 1u << 18; n *= 4) {
    std::vector<LineInterval> intervals;
    for (std::uint32_t i = 0; i < n; ++i) intervals.push_back({3.0 * i, 3.0 * i + 2});
    tests::shuffle(intervals, random);
    const IntervalsAnswer answer = intervals_any(intervals);
    EXPECT_FALSE(answer.meet());
    EXPECT_LE(static_cast<double>(answer.cost.probes), 1.5 * n * std::log2(n)) << n;
  }
}

TEST(IntervalsAnyTest, BadIntervalsAreRefused) {
  for (const LineInterval bad : {LineInterval{2, 1}, {std::nan(""), 1}, {0, std::numeric_limits<double>::infinity()}}) {
    try {
      static_cast<void>(intervals_any(std::vector<LineInterval>{{0, 1}, bad}));
      ADD_FAILURE();
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ErrorCode::bad_value);
      EXPECT_EQ(error.place(), "interval 1");
    }
  }
}

}  // namespace
}  // namespace sunder::planar
