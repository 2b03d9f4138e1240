// Balaban's staircases on sets that are large enough for stairs to be lent, full of degeneracies; and that they stop.
#include <sunder/base/random.h>
#include <sunder/planar/segments/segments_all.h>

#include <tests/support/scale.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace sunder::planar {
namespace {

std::vector<SegmentsContact> listed(SegmentsMethod& method, const Segments& segments, const SetOptions& options = {}) {
  std::vector<SegmentsContact> contacts;
  method(segments, options, [&](const SegmentsContact& contact) {
    contacts.push_back(contact);
    return true;
  });
  std::sort(contacts.begin(), contacts.end());
  return contacts;
}

// Layers of parallels of all lengths, the long ones far apart, so that many strips have large staircases; what is put
// in between crosses them, begins and ends on them, overlaps them, or stands upright.
std::vector<Segment> layers(Random& random, int n) {
  const auto whole = [&](std::int64_t low, std::int64_t high) {
    return static_cast<double>(random.between(low, high));
  };
  const int width = 1 << random.between(3, 7);
  const int height = static_cast<int>(random.between(4, 2 * n));
  const double slope = random.below(2) == 0 ? 0 : whole(-3, 3) / 4;
  const std::uint64_t others = 1 + random.below(8);  // out of 16
  std::vector<Segment> segments;
  while (segments.size() < static_cast<std::size_t>(n)) {
    const double y = whole(0, height);
    if (random.below(16) >= others) {
      const double length = width >> random.below(7), x = length * whole(0, 8);
      segments.push_back({{x, y + slope * x}, {x + length, y + slope * (x + length)}});
      continue;
    }
    const double x = whole(0, width);
    switch (random.below(6)) {
      case 0: segments.push_back({{x, y + slope * x}, {x, y + slope * x}}); break;
      case 1: segments.push_back({{x, y + slope * x}, {x, y + whole(0, height)}}); break;
      case 2: segments.push_back({{x, y + slope * x}, {whole(0, width), whole(0, height)}}); break;
      case 3: segments.push_back({{x + 0.5, y - 0.25}, {x + 0.75, y + whole(0, 6)}}); break;
      case 4: segments.push_back({{0, whole(0, height)}, {static_cast<double>(width), whole(0, height)}}); break;
      default: segments.push_back(segments.empty() ? Segment{} : segments[random.below(segments.size())]);
    }
  }
  return segments;
}

// Many through few points, which are ends of others or not.
std::vector<Segment> fans(Random& random, int n) {
  std::vector<Segment> segments;
  const std::int64_t side = random.between(3, 40);
  const auto whole = [&] { return static_cast<double>(random.between(-side, side)); };
  const int hubs = static_cast<int>(1 + random.below(4));
  for (int hub = 0; hub < hubs; ++hub) {
    const Point2 p{whole(), whole()};
    for (int k = 0; k < n / hubs; ++k) {
      const double dx = whole(), dy = whole(), before = whole() / 4, past = whole() / 4;
      segments.push_back({{p.x + before * dx, p.y + before * dy}, {p.x + past * dx, p.y + past * dy}});
    }
  }
  return segments;
}

TEST(VisitContactsByBalabanTest, LargeStaircasesAgreeWithTheScan) {
  const int count = tests::scaled_count(150, 4);
  Random random(tests::chosen_seed(20261125));
  std::size_t contacts = 0, pairs = 0;
  for (int i = 0; i < count; ++i) {
    const int n = static_cast<int>(random.between(20, 400));
    const Segments segments(i % 4 == 0 ? fans(random, n) : layers(random, n));
    std::vector<std::uint32_t> groups;
    for (std::uint32_t k = 0; k < segments.size(); ++k) groups.push_back(static_cast<std::uint32_t>(random.below(3)));
    for (const bool grouped : {false, true}) {
      SetOptions options{static_cast<Allowed>(i % 3)};
      if (grouped) options.groups = groups;
      const std::vector<SegmentsContact> truth = listed(segments_all_by_scan, segments, options);
      ASSERT_EQ(listed(segments_all_by_balaban, segments, options), truth) << i;
      contacts += truth.size();
      pairs += std::size_t{segments.size()} * (segments.size() - 1) / 2;
    }
  }
  EXPECT_GT(contacts, pairs / 100);
  EXPECT_LT(contacts, pairs / 2);
}

TEST(VisitContactsByBalabanTest, NoneAndOne) {
  EXPECT_TRUE(listed(segments_all_by_balaban, Segments({})).empty());
  const std::vector<Segment> one{{{0, 0}, {1, 1}}}, point{{{0, 0}, {-0.0, 0}}},
      points{{{0, 0}, {-0.0, 0}}, {{0, 0}, {0, -0.0}}};
  EXPECT_TRUE(listed(segments_all_by_balaban, Segments(one)).empty());
  EXPECT_TRUE(listed(segments_all_by_balaban, Segments(point)).empty());
  EXPECT_EQ(listed(segments_all_by_balaban, Segments(points)),
            (std::vector<SegmentsContact>{{0, 1, ContactKind::shared_endpoint}}));
}

// After each number of contacts, also in the midst of walks, rows and leaves.
TEST(VisitContactsByBalabanTest, StopsWhereTheVisitorSays) {
  Random random(20261126);
  for (int i = 0; i < 40; ++i) {
    const Segments segments(i % 2 == 0 ? fans(random, 30) : layers(random, 30));
    const std::vector<SegmentsContact> all = listed(segments_all_by_balaban, segments);
    for (std::size_t wanted = 1; wanted <= all.size(); ++wanted) {
      std::size_t calls = 0;
      segments_all_by_balaban(segments, {}, [&](const SegmentsContact&) { return ++calls < wanted; });
      ASSERT_EQ(calls, wanted);
    }
  }
}

}  // namespace
}  // namespace sunder::planar
