#include <sunder/planar/boxes/boxes.h>

#include <tests/support/scale.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <random>
#include <vector>

namespace sunder::planar {
namespace {

DiscContact kind(const Box2& a, const Box2& b) {
  const DiscContact one = contact_kind(Boxes({a, b}), 0, 1);
  EXPECT_EQ(one, contact_kind(Boxes({b, a}), 0, 1));
  return one;
}

TEST(Boxes, HowTwoMeet) {
  const Box2 box{{0, 0}, {4, 2}};
  EXPECT_EQ(kind(box, {{5, 0}, {6, 2}}), DiscContact::none);
  EXPECT_EQ(kind(box, {{4, 0}, {6, 2}}), DiscContact::touching);  // along a side
  EXPECT_EQ(kind(box, {{4, 2}, {6, 3}}), DiscContact::touching);  // at a corner
  EXPECT_EQ(kind(box, {{3, 1}, {6, 3}}), DiscContact::overlapping);
  EXPECT_EQ(kind(box, {{1, -1}, {2, 3}}), DiscContact::overlapping);  // a cross
  EXPECT_EQ(kind(box, {{1, 0}, {4, 2}}), DiscContact::inside);
  EXPECT_EQ(kind(box, box), DiscContact::inside);
  // Flat ones: segments and points.
  EXPECT_EQ(kind(box, {{1, 1}, {1, 1}}), DiscContact::inside);
  EXPECT_EQ(kind(box, {{0, 1}, {0, 1}}), DiscContact::touching);
  EXPECT_EQ(kind(box, {{2, -1}, {2, 3}}), DiscContact::overlapping);
  EXPECT_EQ(kind(box, {{4, -1}, {4, 3}}), DiscContact::touching);
  EXPECT_EQ(kind({{0, 0}, {4, 0}}, {{2, -1}, {2, 1}}), DiscContact::overlapping);
  EXPECT_EQ(kind({{0, 0}, {4, 0}}, {{2, 0}, {2, 1}}), DiscContact::touching);
  EXPECT_EQ(kind({{1, 1}, {1, 1}}, {{1, 1}, {1, 1}}), DiscContact::inside);
}

TEST(Boxes, RefusesWhatIsNone) {
  const double nan = std::numeric_limits<double>::quiet_NaN(), infinity = std::numeric_limits<double>::infinity();
  for (const Box2& wrong : {Box2{{1, 0}, {0, 1}}, Box2{{0, 1}, {1, 0}}, Box2{{nan, 0}, {1, 1}}, Box2{{0, 0}, {1, nan}},
                            Box2{{-infinity, 0}, {1, 1}}}) {
    EXPECT_THROW(Boxes({Box2{}, wrong}), Error);
  }
  EXPECT_FALSE(contacts_any(Boxes({})).meet());
}

// Many at equal coordinates; the front door against every pair, under both rules, with groups and without.
TEST(Boxes, AsByScan) {
  std::mt19937_64 random(tests::chosen_seed(41));
  const auto below = [&](std::uint64_t n) { return static_cast<double>(random() % n); };
  std::size_t with_contacts = 0, without = 0;
  for (int k = 0; k < tests::scaled_count(2000); ++k) {
    std::vector<Box2> some;
    std::vector<std::uint32_t> groups;
    const double size = below(2) == 0 ? 10 : 1000;
    for (std::uint64_t n = random() % (k % 20 == 0 ? 400 : 12); n > 0; --n) {
      const Point2 low{below(static_cast<std::uint64_t>(size)), below(static_cast<std::uint64_t>(size))};
      some.push_back({low, {low.x + below(4), low.y + below(k % 7 == 0 ? 400 : 4)}});
      groups.push_back(static_cast<std::uint32_t>(random() % 3));
    }
    const Boxes boxes(some);
    const SetOptions options{k % 2 == 0 ? Allowed::nothing : Allowed::touch, k % 3 == 0 ? Groups(groups) : Groups()};
    std::vector<ContactOfTwo<DiscContact>> all = contacts_all(boxes, options).found, truth;
    contacts_visit_by_scan(boxes, options, [&](const auto& contact) {
      truth.push_back(contact);
      return true;
    });
    std::sort(all.begin(), all.end());
    ASSERT_EQ(all, truth) << k;
    ASSERT_EQ(contacts_count(boxes, options).count, truth.size());
    const auto any = contacts_any(boxes, options);
    ASSERT_EQ(any.meet(), !truth.empty());
    ASSERT_TRUE(!any.meet() || std::find(truth.begin(), truth.end(), *any.found) != truth.end());
    ++(truth.empty() ? without : with_contacts);
  }
  EXPECT_TRUE(tests::scaled_count(1000) < 1000 || std::min(with_contacts, without) > 200);
}

}  // namespace
}  // namespace sunder::planar
