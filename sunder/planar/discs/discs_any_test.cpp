// Rules, details of the sweep, groups, crowds, and how the number of pairs grows.
#include <sunder/base/random.h>
#include <sunder/planar/discs/discs_any.h>

#include <gtest/gtest.h>

#include <bit>
#include <numeric>
#include <vector>

namespace sunder::planar {
namespace {

bool discs_meet(const std::vector<Disc>& given, Allowed allowed = Allowed::nothing, Groups groups = {}) {
  const Discs circles(given);
  const DiscsAnswer scan = discs_any_by_scan(circles, {allowed, groups});
  for (const auto method : {&discs_any, &discs_any_by_sweep, &discs_any_by_grid}) {
    const DiscsAnswer answer = method(circles, {allowed, groups, nullptr});
    EXPECT_EQ(answer.meet(), scan.meet());
    if (!answer.meet()) continue;
    EXPECT_LT(answer.found->i, answer.found->j);
    EXPECT_EQ(answer.found->kind, disc_disc(circles[answer.found->i], circles[answer.found->j]));
    EXPECT_TRUE(counts(answer.found->kind, allowed));
    EXPECT_FALSE(may_meet(groups, answer.found->i, answer.found->j));
  }
  return scan.meet();
}

TEST(DiscsAnyTest, EachKindUnderEachRule) {
  const Disc c{{0, 0}, 5};
  for (const Allowed allowed : {Allowed::nothing, Allowed::shared_endpoint, Allowed::touch}) {
    EXPECT_FALSE(discs_meet({c, {{9, 12}, 9}}, allowed));
    EXPECT_EQ(discs_meet({c, {{9, 12}, 10}}, allowed), allowed == Allowed::nothing);
    EXPECT_TRUE(discs_meet({c, {{9, 12}, 11}}, allowed));
    EXPECT_TRUE(discs_meet({c, {{3, 0}, 1}}, allowed));
    EXPECT_TRUE(discs_meet({c, {{3, 0}, 2}}, allowed));  // touching from inside
    EXPECT_TRUE(discs_meet({c, c}, allowed));
    EXPECT_TRUE(discs_meet({c, {{1, 1}, 0}}, allowed));
    EXPECT_EQ(discs_meet({c, {{3, 4}, 0}}, allowed), allowed == Allowed::nothing);
    EXPECT_EQ(discs_meet({{{1, 1}, 0}, {{1, 1}, 0}}, allowed), allowed == Allowed::nothing);
  }
}

TEST(DiscsAnyTest, NoneAndOne) {
  EXPECT_FALSE(discs_meet({}));
  EXPECT_FALSE(discs_meet({{{1, 1}, 1}}));
  EXPECT_FALSE(discs_meet({{{1, 1}, 0}}));
  EXPECT_FALSE(discs_meet({{{-1e308, 0}, 1e308}}));
}

// Touching in the sweep's own directions, where one ends and another begins, or has its lowest or highest point.
TEST(DiscsAnyTest, TouchingAlongTheAxes) {
  for (const Point2 along : {Point2{2, 0}, Point2{0, 2}, Point2{-2, 0}, Point2{0, -2}}) {
    std::vector<Disc> row;
    for (int k = 0; k < 9; ++k) row.push_back({{k * along.x, k * along.y}, 1});
    EXPECT_TRUE(discs_meet(row));
    EXPECT_FALSE(discs_meet(row, Allowed::touch));
    for (int k = 0; k < 9; ++k) row.push_back({{(k + 0.5) * along.x, (k + 0.5) * along.y}, 0});  // points between
    EXPECT_FALSE(discs_meet(row, Allowed::touch));
    for (int k = 0; k < 9; ++k) row.push_back({{(k + 0.5) * along.x, (k + 0.5) * along.y}, 0});  // twice
    EXPECT_FALSE(discs_meet(row, Allowed::touch));
    row.push_back({{8.5 * along.x, 8.5 * along.y}, 0x1p-50});
    EXPECT_TRUE(discs_meet(row, Allowed::touch));
  }
}

// Neighbours only once what stood between them is over; one below all.
TEST(DiscsAnyTest, MetWhenAnotherEnds) {
  std::vector<Disc> discs{{{1.25, 0}, 0.75}, {{5, -4}, 4.25}, {{5, 4}, 4}};
  EXPECT_TRUE(discs_meet(discs));
  discs[1].radius = 3.75;
  EXPECT_FALSE(discs_meet(discs));
  discs = {{{0, 0}, 1}, {{4, 3}, 1}, {{8, 6}, 1}, {{4, -200}, 199}};
  EXPECT_FALSE(discs_meet(discs));
  discs[3].radius = 200;
  EXPECT_TRUE(discs_meet(discs));
}

TEST(DiscsAnyTest, BeyondTheDoubles) {
  constexpr double greatest = 0x1.fffffffffffffp1023;
  EXPECT_TRUE(discs_meet({{{greatest, 0}, greatest}, {{-greatest, 0}, greatest}}));
  EXPECT_FALSE(discs_meet({{{greatest, 0}, greatest}, {{-greatest, 0}, greatest}}, Allowed::touch));
  EXPECT_FALSE(discs_meet({{{greatest, 0}, greatest}, {{-greatest, 0}, 0x1.ffffffffffffep1023}}));
  EXPECT_FALSE(discs_meet({{{greatest, greatest}, greatest}, {{-greatest, -greatest}, greatest}}));
  EXPECT_TRUE(discs_meet({{{0, greatest}, greatest}, {{0, 0}, 5e-324}}));
  EXPECT_FALSE(discs_meet({{{5e-324, 0}, 0}, {{0, 0}, 0}, {{0, 1e-323}, 0}}));
  EXPECT_TRUE(discs_meet({{{5e-324, 0}, 0}, {{0, 0}, 5e-324}}));
}

// Members of one group meet at will, the others not; neighbours alone would not tell.
TEST(DiscsAnyTest, Groups) {
  const std::vector<Disc> discs{{{0, 0}, 10}, {{0, 0}, 1}, {{0, 11}, 1.5}};
  const std::vector<std::uint32_t> two{7, 7, 8}, one{3, 3, 3}, own{0, 1, 2};
  EXPECT_TRUE(discs_meet(discs, Allowed::nothing, two));
  EXPECT_FALSE(discs_meet(discs, Allowed::nothing, one));
  EXPECT_TRUE(discs_meet(discs, Allowed::touch, own));
  EXPECT_FALSE(discs_meet({discs[0], discs[1], {{0, 12}, 1.5}}, Allowed::nothing, two));
}

// Discs that do not meet: a jittered lattice, spread over the square [0, 1), of any sizes up to what its cells allow.
std::vector<Disc> lattice(std::uint32_t side, Random& random) {
  std::vector<Disc> discs;
  for (std::uint32_t k = 0; k < side * side; ++k) {
    const double r = random.log_uniform(0.0005, 0.49), free = 0.5 - r;
    const double x = 0.5 + random.uniform(-free, free), y = 0.5 + random.uniform(-free, free);
    discs.push_back({{(k % side + x) / side, (k / side + y) / side}, r / side});
  }
  return discs;
}

// A place with so many small ones that the grid leaves them to the sweep.
TEST(DiscsAnyTest, Crowds) {
  Random random(31);
  std::vector<Disc> discs = lattice(40, random), crowd = lattice(15, random);
  discs.erase(discs.begin() + 50);
  for (const Disc& c : crowd) {
    discs.push_back({{(10.4 + 0.1 * c.center.x) / 40, (1.4 + 0.1 * c.center.y) / 40}, c.radius / 400});
  }
  EXPECT_FALSE(discs_meet(discs));
  const Disc last = discs.back();
  for (const double move : {0.0, 0.3, -0.3}) {
    discs.push_back({{last.center.x + move * last.radius, last.center.y}, last.radius / 9});
    EXPECT_TRUE(discs_meet(discs));
    std::vector<std::uint32_t> groups(discs.size());  // each for itself, but for the two
    std::iota(groups.begin(), groups.end(), 0u);
    EXPECT_TRUE(discs_meet(discs, Allowed::nothing, groups));
    groups.back() = groups[groups.size() - 2];
    EXPECT_FALSE(discs_meet(discs, Allowed::nothing, groups));
    discs.pop_back();
  }
  discs.push_back({discs[0].center, 0});
  EXPECT_TRUE(discs_meet(discs));
}

TEST(DiscsAnyTest, ProgressIsCalled) {
  Random random(32);
  const Discs circles(lattice(300, random));
  for (const auto method : {&discs_any_by_sweep, &discs_any_by_grid}) {
    double last = -1;
    int calls = 0;
    const auto progress = [&](double part) {
      EXPECT_GT(part, last);
      EXPECT_LE(part, 1);
      last = part;
      ++calls;
    };
    EXPECT_FALSE(method(circles, {Allowed::nothing, {}, progress}).meet());
    EXPECT_GE(calls, 2);
  }
}

// Complexity (SH76, Theorem 8): each event compares two pairs or one, over four decades and more; on a lattice, where
// a square root of N is cut at once, and on a tower, where all are.
TEST(DiscsAnyTest, PairsGrowAsN) {
  Random random(33);
  for (std::uint32_t n = 16; n <= 1u << 18; n *= 4) {
    std::vector<Disc> tower;
    for (std::uint32_t k = 0; k < n; ++k) tower.push_back({{random.unit(), 3.0 * k}, 1 + 0.4 * random.unit()});
    for (const std::vector<Disc>& discs : {lattice(1u << (std::bit_width(n) / 2), random), tower}) {
      const Discs circles(discs);
      const DiscsAnswer answer = discs_any_by_sweep(circles);
      ASSERT_FALSE(answer.meet());
      EXPECT_LE(answer.cost.probes, 3 * std::uint64_t{n});
      EXPECT_GE(answer.cost.probes, n / 4);
      EXPECT_LE(discs_any(circles).cost.probes, 4 * std::uint64_t{n});
    }
  }
}

}  // namespace
}  // namespace sunder::planar
