// Rules, details of the sweep, and how the number of comparisons grows.
#include <sunder/base/error.h>
#include <sunder/base/random.h>
#include <sunder/planar/segments/segments_any.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace sunder::planar {
namespace {

bool segments_meet(const std::vector<Segment>& given, Allowed allowed) {
  const Segments segments(given);
  const SegmentsAnswer sweep = segments_any_by_sweep(segments, {allowed});
  SweepEvents events;
  EXPECT_EQ(sweep.meet(), segments_any_with_transcript(segments, {allowed}, events).meet());
  EXPECT_EQ(sweep.meet(), segments_any_by_scan(segments, {allowed}).meet());
  EXPECT_EQ(sweep.meet(), segments_any(segments, {allowed}).meet());
  return sweep.meet();
}

TEST(SegmentsAnyTest, EachKindUnderEachRule) {
  const Segment s{{0, 0}, {4, 0}};
  const std::vector<Segment> apart{s, {{0, 1}, {4, 1}}}, shared{s, {{4, 0}, {5, 3}}}, touching{s, {{2, 0}, {2, 3}}},
      crossing{s, {{2, -1}, {3, 1}}}, overlapping{s, {{3, 0}, {6, 0}}};
  for (const Allowed allowed : {Allowed::nothing, Allowed::shared_endpoint, Allowed::touch}) {
    EXPECT_FALSE(segments_meet(apart, allowed));
    EXPECT_EQ(segments_meet(shared, allowed), allowed == Allowed::nothing);
    EXPECT_EQ(segments_meet(touching, allowed), allowed != Allowed::touch);
    EXPECT_TRUE(segments_meet(crossing, allowed));
    EXPECT_TRUE(segments_meet(overlapping, allowed));
  }
}

TEST(SegmentsAnyTest, NoneAndOne) {
  EXPECT_FALSE(segments_meet({}, Allowed::nothing));
  EXPECT_FALSE(segments_meet({{{0, 0}, {1, 1}}}, Allowed::nothing));
  EXPECT_FALSE(segments_meet({{{1, 1}, {1, 1}}}, Allowed::nothing));
}

// What the paper leaves out: many through one point, verticals in a row, points on everything.
TEST(SegmentsAnyTest, ManyAtOnePoint) {
  std::vector<Segment> fan, through;
  for (int k = 0; k < 12; ++k) {
    const double t = 0.5 * k;
    fan.push_back({{0, 0}, {std::cos(t), std::sin(t)}});
    through.push_back({{-std::cos(t / 2), -std::sin(t / 2)}, {std::cos(t / 2), std::sin(t / 2)}});
  }
  EXPECT_TRUE(segments_meet(fan, Allowed::nothing));
  EXPECT_FALSE(segments_meet(fan, Allowed::shared_endpoint));
  EXPECT_TRUE(segments_meet(through, Allowed::touch));
  fan.push_back({{0, 0}, {0, 0}});
  EXPECT_FALSE(segments_meet(fan, Allowed::shared_endpoint));
  fan.push_back({{-1e-9, 1e-12}, {0, 0}});
  EXPECT_FALSE(segments_meet(fan, Allowed::shared_endpoint));
  fan.push_back({{-1e-9, -1e-12}, {1e-9, 1e-12}});  // passes through
  EXPECT_TRUE(segments_meet(fan, Allowed::shared_endpoint));
  EXPECT_FALSE(segments_meet(fan, Allowed::touch));
  fan.push_back({{-1e-9, -2e-12}, {1e-9, 2e-12}});  // a second one does
  EXPECT_TRUE(segments_meet(fan, Allowed::touch));
}

TEST(SegmentsAnyTest, VerticalsAbove) {
  std::vector<Segment> tower;
  for (int k = 0; k < 8; ++k) tower.push_back({{1, 2.0 * k}, {1, 2.0 * k + 1}});
  EXPECT_FALSE(segments_meet(tower, Allowed::nothing));
  tower.push_back({{1, 1}, {1, 2}});
  EXPECT_TRUE(segments_meet(tower, Allowed::nothing));
  EXPECT_FALSE(segments_meet(tower, Allowed::shared_endpoint));
  tower.push_back({{0, 5.5}, {1, 5.5}});
  EXPECT_FALSE(segments_meet(tower, Allowed::shared_endpoint));
  tower.push_back({{0, 4.5}, {1, 4.5}});
  EXPECT_TRUE(segments_meet(tower, Allowed::shared_endpoint));
  EXPECT_FALSE(segments_meet(tower, Allowed::touch));
}

TEST(SegmentsAnyTest, BadNumbersAreRefused) {
  for (const double bad : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    try {
      Segments(std::vector<Segment>{{{0, 0}, {1, 1}}, {{0, bad}, {1, 1}}});
      ADD_FAILURE();
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ErrorCode::bad_value);
      EXPECT_EQ(error.place(), "segment 1");
    }
  }
}

using Numbers = std::vector<std::uint32_t>;

Numbers goes_on(const SweepEvents& events, std::size_t k) {
  return {events.goes_on(k).begin(), events.goes_on(k).end()};
}

// The transcript has an event at each point where one begins or ends, in the order of the plane.
TEST(SegmentsAnyTest, TheTranscript) {
  const Segments segments(std::vector<Segment>{{{0, 0}, {4, 0}}, {{1, 2}, {3, 1}}, {{2, 1}, {2, 1}}, {{2, 4}, {5, 5}}});
  SweepEvents events;
  ASSERT_FALSE(segments_any_with_transcript(segments, {}, events).meet());
  EXPECT_EQ(events.at, (Numbers{0, 2, 4, 6, 3, 1, 7}));
  EXPECT_EQ(events.below, (Numbers{no_segment, 0, 0, 1, 0, no_segment, no_segment}));
  EXPECT_EQ(goes_on(events, 0), Numbers{0});
  EXPECT_EQ(goes_on(events, 2), Numbers{2});  // a point comes and goes
  EXPECT_EQ(goes_on(events, 4), Numbers{});
}

// All that happens at one point is one event: what goes on from it stands from the lowest up, points before.
TEST(SegmentsAnyTest, TheTranscriptAtOnePoint) {
  const Segments segments(
      std::vector<Segment>{{{1, 1}, {2, 2}}, {{1, 1}, {1, 1}}, {{0, 0}, {1, 1}}, {{1, 1}, {3, 0}}, {{0, 3}, {1, 1}}});
  SweepEvents events;
  ASSERT_FALSE(segments_any_with_transcript(segments, {Allowed::shared_endpoint}, events).meet());
  ASSERT_EQ(events.size(), 5u);
  EXPECT_EQ(goes_on(events, 2), (Numbers{1, 3, 0}));
  EXPECT_EQ(events.below[2], no_segment);
}

// Members of a group that cross and overlap, three of them in one point.
TEST(SegmentsAnyTest, TheTranscriptOfAGroup) {
  const Segments segments(std::vector<Segment>{{{0, 0}, {4, 4}}, {{0, 4}, {4, 0}}, {{0, 2}, {4, 2}}, {{1, 2}, {3, 2}}});
  const Numbers groups{7, 7, 7, 7};
  SweepEvents events;
  ASSERT_FALSE(segments_any_with_transcript(segments, {Allowed::nothing, groups}, events).meet());
  EXPECT_EQ(std::count(events.at.begin(), events.at.end(), at_crossing), 1);
  const std::size_t k =
      static_cast<std::size_t>(std::find(events.at.begin(), events.at.end(), at_crossing) - events.at.begin());
  const Numbers row = goes_on(events, k);
  ASSERT_EQ(row.size(), 4u);
  EXPECT_EQ(row.front(), 1u);
  EXPECT_EQ(row.back(), 0u);
}

// Complexity (SH76, Theorem 3): comparisons within N log2 N, over four decades and more: on edges of a jittered grid,
// where a square root of N is cut at once, and on a star of long spikes, where half of all are.
TEST(SegmentsAnyTest, ComparisonsGrowAsNLogN) {
  Random random(103);
  for (std::uint32_t n = 64; n <= 1u << 20; n *= 4) {
    for (const bool star : {false, true}) {
      std::vector<Segment> given;
      if (star) {
        std::vector<Point2> p;
        for (std::uint32_t k = 0; k < n; ++k) {
          const double t = 6.283185307179586 * k / n, r = k % 2 == 0 ? 1 : random.uniform(0.05, 0.1);
          p.push_back({r * std::cos(t), r * std::sin(t)});
        }
        for (std::uint32_t k = 0; k < n; ++k) given.push_back({p[k], p[(k + 1) % n]});
      } else {
        const std::uint32_t side = static_cast<std::uint32_t>(std::sqrt(n / 2));
        std::vector<Point2> p;
        for (std::uint32_t k = 0; k < (side + 1) * (side + 1); ++k) {
          p.push_back({k % (side + 1) + random.uniform(-0.3, 0.3), k / (side + 1) + random.uniform(-0.3, 0.3)});
        }
        for (std::uint32_t y = 0; y <= side; ++y) {
          for (std::uint32_t x = 0; x <= side; ++x) {
            const std::uint32_t k = y * (side + 1) + x;
            if (x < side) given.push_back({p[k], p[k + 1]});
            if (y < side) given.push_back({p[k], p[k + side + 1]});
          }
        }
      }
      const Segments segments(given);
      const SegmentsAnswer answer = segments_any_by_sweep(segments, {Allowed::shared_endpoint});
      ASSERT_FALSE(answer.meet());
      const double size = segments.size();
      EXPECT_LE(answer.cost.probes, size * (std::log2(size) + 3)) << n << (star ? " star" : " grid");
    }
  }
}

}  // namespace
}  // namespace sunder::planar
