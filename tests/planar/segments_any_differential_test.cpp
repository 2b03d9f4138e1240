// segments_any and its methods against segments_any_by_scan, under every rule.
#include <tests/support/allowed_rules.h>
#include <tests/support/scale.h>
#include <tests/support/segment_sets.h>

#include <sunder/planar/segments/segments_all.h>
#include <sunder/planar/segments/segments_any.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <map>

namespace sunder::tests {
namespace {

using planar::ContactKind;
using planar::Segment;
using planar::Segments;
using planar::SegmentsAnswer;

void expect_true_segments(const SegmentsAnswer& answer, const SegmentsAnswer& scan, const Segments& segments,
                          Allowed allowed) {
  ASSERT_EQ(answer.meet(), scan.meet());
  if (!answer.meet()) return;
  ASSERT_LT(answer.found->i, answer.found->j);
  ASSERT_LT(answer.found->j, segments.size());
  ASSERT_EQ(planar::segment_segment(segments[answer.found->i], segments[answer.found->j]), answer.found->kind);
  ASSERT_TRUE(planar::counts(answer.found->kind, allowed));
}

TEST(SegmentsAnyDifferential, MethodsAgreeWithTheScan) {
  const int count = scaled_count(20000);
  const std::uint64_t seed = chosen_seed(20261121);
  SCOPED_TRACE("seed " + std::to_string(seed));
  SegmentSets sets(seed);
  std::map<SegmentFamily, std::array<int, 3>> meets;
  std::map<SegmentFamily, int> cases;
  std::map<ContactKind, int> kinds;
  for (int i = 0; i < count; ++i) {
    const SegmentSet set = sets.next();
    const Segments segments(set.segments);
    ++cases[set.family];
    for (std::size_t r = 0; r < allowed_rules.size(); ++r) {
      const SegmentsAnswer scan = planar::segments_any_by_scan(segments, {allowed_rules[r]});
      planar::SweepEvents events;
      const SegmentsAnswer sweep = planar::segments_any_by_sweep(segments, {allowed_rules[r]}),
                           told = planar::segments_any_with_transcript(segments, {allowed_rules[r]}, events);
      for (const SegmentsAnswer& answer : {sweep, told}) {
        ASSERT_NO_FATAL_FAILURE(expect_true_segments(answer, scan, segments, allowed_rules[r]))
            << i << " " << name_of(set.family) << " allowed " << name_of(allowed_rules[r]);
      }
      ASSERT_EQ(events.empty(), told.meet());
      if (!told.meet()) {
        ASSERT_EQ(events, planar::sweep_events(segments)) << i;
      }
      ++kinds[told.found.value_or(planar::SegmentsContact{}).kind];
      const SegmentsAnswer grid = planar::segments_any_by_grid(segments, {allowed_rules[r]});
      ASSERT_NO_FATAL_FAILURE(expect_true_segments(grid, scan, segments, allowed_rules[r]))
          << i << " " << name_of(set.family);
      const SegmentsAnswer front = planar::segments_any(segments, {allowed_rules[r]});
      ASSERT_NO_FATAL_FAILURE(expect_true_segments(front, scan, segments, allowed_rules[r]))
          << i << " " << name_of(set.family);
      meets[set.family][r] += scan.meet();
    }
  }
  std::printf("%-10s %8s %10s %16s %8s\n", "family", "cases", "some meet", "shared ends not", "touches not");
  for (const auto& [family, m] : meets) {
    std::printf("%-10s %8d %10d %16d %8d\n", std::string(name_of(family)).c_str(), cases[family], m[0], m[1], m[2]);
  }
  if (count < 2000) return;  // too few for the rates below
  // Both verdicts are common in each family, and every kind of contact is met.
  for (const auto& [family, m] : meets) {
    for (std::size_t r = 0; r < allowed_rules.size(); ++r) {
      if (family == SegmentFamily::mesh && r == 0) continue;  // a mesh's edges always share ends
      EXPECT_GT(m[r], cases[family] / 50) << name_of(family) << " " << name_of(allowed_rules[r]);
      EXPECT_LT(m[r], cases[family] - cases[family] / 50) << name_of(family) << " " << name_of(allowed_rules[r]);
    }
  }
  for (const ContactKind kind : {ContactKind::none, ContactKind::shared_endpoint, ContactKind::touch,
                                 ContactKind::crossing, ContactKind::overlap}) {
    EXPECT_GT(kinds[kind], count / 200) << planar::name_of(kind);
  }
}

// Reflected, scaled by a power of two, ends exchanged, order changed: the same verdict.
TEST(SegmentsAnyDifferential, SymmetriesKeepTheVerdict) {
  const int count = scaled_count(4000);
  SegmentSets sets(chosen_seed(11));
  int meets = 0;
  for (int i = 0; i < count; ++i) {
    const SegmentSet set = sets.next();
    const Allowed allowed = allowed_rules[static_cast<std::size_t>(i % 3)];
    const auto verdict = [&](auto&& changed) {
      std::vector<Segment> segments;
      for (const Segment& s : set.segments) segments.push_back(changed(s));
      return planar::segments_any(Segments(segments), {allowed}).meet();
    };
    const bool meet = verdict([](const Segment& s) { return s; });
    meets += meet;
    ASSERT_EQ(verdict([](const Segment& s) { return Segment{s.b, s.a}; }), meet) << i;
    ASSERT_EQ(verdict([](const Segment& s) { return Segment{{-s.a.x, s.a.y}, {-s.b.x, s.b.y}}; }), meet) << i;
    ASSERT_EQ(verdict([](const Segment& s) { return Segment{{s.a.y, s.a.x}, {s.b.y, s.b.x}}; }), meet) << i;
    if (set.family != SegmentFamily::any_scale) {
      ASSERT_EQ(verdict([](const Segment& s) { return Segment{{8 * s.a.x, 8 * s.a.y}, {8 * s.b.x, 8 * s.b.y}}; }), meet)
          << i;
    }
    std::vector<Segment> reversed(set.segments.rbegin(), set.segments.rend());
    ASSERT_EQ(planar::segments_any(Segments(reversed), {allowed}).meet(), meet) << i;
  }
  EXPECT_GT(meets, count / 5);
  EXPECT_LT(meets, count - count / 5);
}

}  // namespace
}  // namespace sunder::tests
