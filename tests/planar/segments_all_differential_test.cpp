// All methods of segments_all against every pair, under every rule, with and without groups; and segments_any with
// groups.
#include <tests/support/scale.h>
#include <tests/support/segment_sets.h>

#include <sunder/planar/segments/segments_all.h>
#include <sunder/planar/segments/segments_claims.h>
#include <verifier/cpp/verify.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <map>
#include <optional>

namespace sunder::tests {
namespace {

using planar::ContactKind;
using planar::Segments;
using planar::SegmentsContact;

bool is_accepted_certificate(const std::string& certificate) {
  return sunder_verifier::verify_text(certificate, "differential").accepted();
}

std::vector<SegmentsContact> listed(planar::SegmentsMethod& method, const Segments& segments,
                                    const SetOptions& options) {
  std::vector<SegmentsContact> contacts;
  method(segments, options, [&](const SegmentsContact& contact) {
    contacts.push_back(contact);
    return true;
  });
  std::sort(contacts.begin(), contacts.end());
  return contacts;
}

TEST(SegmentsAllDifferential, MethodsAgreeWithTheScan) {
  const int count = scaled_count(20000);
  const std::uint64_t seed = chosen_seed(20261122);
  SCOPED_TRACE("seed " + std::to_string(seed));
  SegmentSets sets(seed);
  std::map<SegmentFamily, std::array<std::size_t, 2>> contacts;  // without and with groups
  std::map<ContactKind, int> kinds;
  int any_meet = 0;
  for (int i = 0; i < count; ++i) {
    const SegmentSet set = sets.next();
    const Segments segments(set.segments);
    std::vector<std::uint32_t> groups;
    const std::uint64_t group_count = 1 + sets.random().below(4);
    for (std::uint32_t k = 0; k < segments.size(); ++k) {
      groups.push_back(static_cast<std::uint32_t>(sets.random().below(group_count)));
    }
    for (const bool grouped : {false, true}) {
      const Allowed allowed = static_cast<Allowed>(i % 3);
      SetOptions options{allowed};
      if (grouped) options.groups = groups;
      const std::vector<SegmentsContact> truth = listed(planar::segments_all_by_scan, segments, options);
      for (planar::SegmentsMethod* method : {&planar::segments_all_by_bentley_ottmann, &planar::segments_all_by_balaban,
                                             &planar::segments_all_by_grid, &planar::segments_visit}) {
        ASSERT_EQ(listed(*method, segments, options), truth)
            << i << " " << name_of(set.family) << " allowed " << name_of(allowed) << (grouped ? " groups" : "");
      }
      ASSERT_EQ(planar::segments_all(segments, options).found.size(), truth.size());
      ASSERT_EQ(planar::segments_count(segments, options).count, truth.size());
      if (i % 4 == 0) {  // proved: the list, and its length
        planar::SweepEvents events;
        const planar::SegmentsAllAnswer told = all_of<SegmentsContact>([&](const planar::SegmentsVisitor& visit) {
          return planar::segments_visit_with_transcript(segments, options, visit, events);
        });
        ASSERT_EQ(told.found.size(), truth.size()) << i;
        ASSERT_EQ(events, planar::sweep_events(segments)) << i;
        ASSERT_TRUE(is_accepted_certificate(planar::certificate_text(segments, allowed, told, options.groups))) << i;
        const CountAnswer<> counted = planar::segments_count(segments, options);
        ASSERT_TRUE(is_accepted_certificate(planar::certificate_text(segments, allowed, counted, options.groups))) << i;
      }
      for (const auto& answer :
           {planar::segments_any(segments, options), planar::segments_any_by_bentley_ottmann(segments, options),
            planar::segments_any_by_sweep(segments, options), planar::segments_any_by_scan(segments, options)}) {
        ASSERT_EQ(answer.meet(), !truth.empty()) << i;
        if (!answer.meet()) continue;
        const SegmentsContact found = *answer.found;
        ASSERT_TRUE(std::binary_search(truth.begin(), truth.end(), found)) << i;
      }
      any_meet += !truth.empty();
      contacts[set.family][grouped] += truth.size();
      for (const SegmentsContact& contact : truth) ++kinds[contact.kind];
    }
  }
  std::printf("%-10s %10s %12s\n", "family", "contacts", "with groups");
  for (const auto& [family, c] : contacts) {
    std::printf("%-10s %10zu %12zu\n", std::string(name_of(family)).c_str(), c[0], c[1]);
    if (count < 2000) continue;
    EXPECT_GT(c[1], static_cast<std::size_t>(count / 100)) << name_of(family);
    EXPECT_LT(c[1], c[0]) << name_of(family);
  }
  if (count < 2000) return;
  EXPECT_GT(any_meet, count / 5);
  EXPECT_LT(any_meet, 2 * count - count / 5);
  for (const ContactKind kind :
       {ContactKind::shared_endpoint, ContactKind::touch, ContactKind::crossing, ContactKind::overlap}) {
    EXPECT_GT(kinds[kind], count / 20) << planar::name_of(kind);
  }
}

// Larger sets on few places: crowded cells, many through one point, long rows.
TEST(SegmentsAllDifferential, CrowdsAgreeWithTheScan) {
  const int count = scaled_count(60);
  Random random(chosen_seed(20261123));
  std::size_t contacts = 0;
  for (int i = 0; i < count; ++i) {
    std::vector<planar::Segment> given;
    const int n = 100 + static_cast<int>(random.below(300));
    // Some far apart, so that the grid pays, and a few places where many are.
    for (int k = 0; k < n; ++k) {
      const double x = static_cast<double>(random.below(1000)), y = static_cast<double>(random.below(1000));
      given.push_back({{x, y}, {x + 3, y + static_cast<double>(random.below(5))}});
    }
    const auto near = [&](double at) { return at + static_cast<double>(random.below(i % 2 == 0 ? 8 : 40)) / 8; };
    for (int k = 0; k < n / 3; ++k) given.push_back({{near(500), near(500)}, {near(500), near(500)}});
    const Segments segments(given);
    const std::vector<SegmentsContact> truth = listed(planar::segments_all_by_scan, segments, {});
    ASSERT_EQ(listed(planar::segments_all_by_bentley_ottmann, segments, {}), truth) << i;
    ASSERT_EQ(listed(planar::segments_all_by_balaban, segments, {}), truth) << i;
    ASSERT_EQ(listed(planar::segments_all_by_grid, segments, {}), truth) << i;
    contacts += truth.size();
    for (const Allowed allowed : {Allowed::nothing, Allowed::shared_endpoint, Allowed::touch}) {
      const bool meet = std::any_of(truth.begin(), truth.end(), [&](const auto& c) { return counts(c.kind, allowed); });
      ASSERT_EQ(planar::segments_any_by_grid(segments, {allowed}).meet(), meet);
      ASSERT_EQ(planar::segments_any_by_sweep(segments, {allowed}).meet(), meet);
    }
  }
  EXPECT_GT(contacts, static_cast<std::size_t>(count) * 100);
}

// Many through few points, ending, passing and beginning there, along few lines, in few groups or many.
TEST(SegmentsAllDifferential, BundlesAgreeWithTheScan) {
  const int count = scaled_count(300);
  Random random(chosen_seed(20261124));
  std::array<std::size_t, 2> contacts{}, pairs{};
  for (int i = 0; i < count; ++i) {
    const std::uint64_t side = 2 + random.below(4), group_count = std::uint64_t{1} << random.below(6);
    std::vector<planar::Segment> given;
    std::vector<std::uint32_t> groups;
    for (std::uint64_t n = 20 + random.below(180); n > 0; --n) {
      const auto whole = [&] { return static_cast<double>(random.below(side)); };
      given.push_back({{whole(), whole()}, {whole(), whole()}});
      if (random.below(3) == 0) given.back().b = {3 * given.back().a.x, 3 * given.back().a.y};  // along lines from 0
      groups.push_back(static_cast<std::uint32_t>(random.below(group_count)));
    }
    const Segments segments(given);
    for (const bool grouped : {false, true}) {
      SetOptions options{static_cast<Allowed>(i % 3)};
      if (grouped) options.groups = groups;
      const std::vector<SegmentsContact> truth = listed(planar::segments_all_by_scan, segments, options);
      for (planar::SegmentsMethod* method : {&planar::segments_all_by_bentley_ottmann, &planar::segments_all_by_balaban,
                                             &planar::segments_all_by_sweep}) {
        ASSERT_EQ(listed(*method, segments, options), truth) << i << (grouped ? " groups" : "");
      }
      ASSERT_EQ(planar::segments_any_by_sweep(segments, options).meet(), !truth.empty()) << i;
      contacts[grouped] += truth.size();
      pairs[grouped] += given.size() * (given.size() - 1) / 2;
    }
  }
  EXPECT_GT(contacts[0], pairs[0] / 10);
  EXPECT_GT(contacts[1], pairs[1] / 20);
  EXPECT_LT(contacts[1], contacts[0]);
}

// A jittered grid's edges and a star's spikes, cut short so that none meet, and a few strokes across the middle of some
// edges: these cross and nothing else does.
TEST(SegmentsAllDifferential, LargeSetsWithAKnownAnswer) {
  const int side = std::clamp(scaled_count(150), 20, 400);
  for (const bool star : {false, true}) {
    Random random(chosen_seed(17));
    std::vector<planar::Segment> edges;
    const auto add = [&](const Point2& p, const Point2& q) {  // the middle 90 %
      const double x = (q.x - p.x) / 20, y = (q.y - p.y) / 20;
      edges.push_back({{p.x + x, p.y + y}, {q.x - x, q.y - y}});
    };
    std::vector<Point2> points;
    if (star) {
      const int n = side * side;
      for (int k = 0; k < n; ++k) {
        const double angle = 6.283185307179586 * k / n, r = k % 2 == 0 ? 1 : random.uniform(0.1, 0.2);
        points.push_back({r * std::cos(angle), r * std::sin(angle)});
      }
      for (std::size_t k = 0; k + 1 < points.size(); ++k) add(points[k], points[k + 1]);
    } else {
      const auto at = [&](int x, int y) { return points[static_cast<std::size_t>(y * side + x)]; };
      for (int y = 0; y < side; ++y) {
        for (int x = 0; x < side; ++x) points.push_back({x + random.uniform(-0.3, 0.3), y + random.uniform(-0.3, 0.3)});
      }
      for (int y = 1; y < side; ++y) {
        for (int x = 1; x < side; ++x) {
          add(at(x - 1, y), at(x, y));
          add(at(x, y - 1), at(x, y));
        }
      }
    }
    std::vector<SegmentsContact> truth;
    std::vector<planar::Segment> all = edges;
    for (std::uint32_t i = 0; i < edges.size(); i += 1 + static_cast<std::uint32_t>(edges.size() / 50)) {
      const Point2 middle{(edges[i].a.x + edges[i].b.x) / 2, (edges[i].a.y + edges[i].b.y) / 2};
      const double x = 1e-7 * (edges[i].b.y - edges[i].a.y), y = 1e-7 * (edges[i].a.x - edges[i].b.x);
      truth.push_back({i, static_cast<std::uint32_t>(all.size()), ContactKind::crossing});
      all.push_back({{middle.x - x, middle.y - y}, {middle.x + x, middle.y + y}});
    }
    EXPECT_FALSE(planar::segments_any(Segments(edges)).meet());
    EXPECT_FALSE(planar::segments_any_by_sweep(Segments(edges)).meet());
    const Segments segments(all);
    EXPECT_EQ(listed(planar::segments_all_by_grid, segments, {}), truth);
    EXPECT_EQ(listed(planar::segments_all_by_bentley_ottmann, segments, {}), truth);
    EXPECT_EQ(listed(planar::segments_all_by_balaban, segments, {}), truth);
    EXPECT_TRUE(planar::segments_any(segments).meet());
    EXPECT_TRUE(planar::segments_any_by_sweep(segments).meet());
  }
}

// Bentley and Ottmann's contacts come in the order of their first common points.
TEST(SegmentsAllDifferential, CrossingsComeInOrder) {
  const int count = scaled_count(2000);
  SegmentSets sets(chosen_seed(13));
  int compared = 0;
  for (int i = 0; i < count; ++i) {
    const Segments segments(sets.next().segments);
    std::optional<ExactPoint2> last;
    planar::segments_all_by_bentley_ottmann(segments, {}, [&](const SegmentsContact& contact) {
      const ExactPoint2 p = planar::common_point(segments[contact.i], segments[contact.j]);
      if (last) {
        const Sign by_x = (p.x * last->denominator - last->x * p.denominator).sign();
        const Sign by_y = (p.y * last->denominator - last->y * p.denominator).sign();
        EXPECT_TRUE(by_x == Sign::positive || (by_x == Sign::zero && by_y != Sign::negative)) << i;
        ++compared;
      }
      last = p;
      return true;
    });
  }
  EXPECT_GT(compared, count);
}

}  // namespace
}  // namespace sunder::tests
