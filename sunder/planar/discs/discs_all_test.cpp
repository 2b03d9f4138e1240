// Known answers, stopping, groups, crowds, and how the work grows.
#include <sunder/base/random.h>
#include <sunder/planar/discs/discs_all.h>

#include <tests/support/shapes.h>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <map>
#include <set>
#include <utility>

namespace sunder::planar {
namespace {

using tests::discs_in_square;

constexpr std::array disc_methods{&discs_all_by_scan, &discs_all_by_sweep, &discs_all_by_grid, &discs_visit};

using DiscKinds = std::map<DiscContact, std::size_t>;

// What all methods list, kind by kind.
DiscKinds disc_kinds_of(const std::vector<Disc>& given, Allowed allowed = Allowed::nothing, Groups groups = {}) {
  const Discs circles(given);
  const SetOptions options{allowed, groups, nullptr};
  std::set<DiscsContact> first;
  for (std::size_t m = 0; m < disc_methods.size(); ++m) {
    std::set<DiscsContact> contacts;
    disc_methods[m](circles, options, [&](const DiscsContact& contact) {
      EXPECT_LT(contact.i, contact.j);
      EXPECT_TRUE(contacts.insert(contact).second) << m << ": " << contact.i << ", " << contact.j;
      return true;
    });
    if (m == 0) first = contacts;
    EXPECT_TRUE(contacts == first) << m;
    EXPECT_EQ(discs_all(circles, options).found.size(), first.size());
    EXPECT_EQ(discs_count(circles, options).count, first.size());
  }
  DiscKinds kinds;
  for (const DiscsContact& contact : first) ++kinds[contact.kind];
  return kinds;
}

TEST(DiscsAllTest, NoneAndOne) {
  EXPECT_EQ(disc_kinds_of({}), DiscKinds{});
  EXPECT_EQ(disc_kinds_of({{{0, 0}, 1}}), DiscKinds{});
  EXPECT_EQ(disc_kinds_of({{{0, 0}, 1}, {{3, 0}, 1}}), DiscKinds{});
}

TEST(DiscsAllTest, KnownSets) {
  for (const std::size_t n : {1u, 2u, 7u, 20u}) {
    std::vector<Disc> touching, nested, same, points, ring;
    for (std::size_t k = 0; k < n * n; ++k) {
      touching.push_back({{2.0 * static_cast<double>(k % n), 2.0 * static_cast<double>(k / n)}, 1});
    }
    const std::size_t pairs = n * (n - 1) / 2, near = 2 * n * (n - 1);
    for (std::size_t k = 0; k < n; ++k) {
      nested.push_back({{static_cast<double>(k), 0}, static_cast<double>(k) + 1});  // all touch at (-1, 0)
      same.push_back({{1, 2}, 3});
      points.push_back({{1, 2}, 0});
      const double t = 6.28 * static_cast<double>(k) / static_cast<double>(n);
      ring.push_back({{9 * std::cos(t), 9 * std::sin(t)}, 9.5});  // all hold the middle
    }
    const auto only = [](DiscContact kind, std::size_t count) {
      return count == 0 ? DiscKinds{} : DiscKinds{{kind, count}};
    };
    EXPECT_EQ(disc_kinds_of(touching), only(DiscContact::touching, near));
    EXPECT_EQ(disc_kinds_of(touching, Allowed::touch), DiscKinds{});
    EXPECT_EQ(disc_kinds_of(nested), only(DiscContact::inside, pairs));
    EXPECT_EQ(disc_kinds_of(nested, Allowed::touch), only(DiscContact::inside, pairs));
    EXPECT_EQ(disc_kinds_of(same), only(DiscContact::inside, pairs));
    EXPECT_EQ(disc_kinds_of(points), only(DiscContact::touching, pairs));
    EXPECT_EQ(disc_kinds_of(ring), only(DiscContact::overlapping, pairs));
  }
}

// Boxes that reach beyond the doubles, below what ordinates there are, and on both sides.
TEST(DiscsAllTest, BeyondTheDoubles) {
  constexpr double greatest = 0x1.fffffffffffffp1023;
  EXPECT_EQ(
      disc_kinds_of({{{0, -greatest}, greatest}, {{1, 0}, 0}, {{2, greatest}, greatest}, {{greatest, 0}, greatest}}),
      (DiscKinds{{DiscContact::overlapping, 2}, {DiscContact::inside, 1}}));
  EXPECT_EQ(disc_kinds_of({{{0, 5}, 1}, {{0, -greatest}, greatest}, {{9, 9}, 1}, {{0, -greatest}, greatest}}),
            (DiscKinds{{DiscContact::inside, 1}}));
}

TEST(DiscsAllTest, Groups) {
  const std::vector<Disc> discs{{{0, 0}, 2}, {{1, 0}, 2}, {{0, 1}, 2}};
  const std::vector<std::uint32_t> all_one{4, 4, 4}, two{0, 9, 0}, own{0, 1, 2};
  EXPECT_EQ(disc_kinds_of(discs, Allowed::nothing, all_one), DiscKinds{});
  EXPECT_EQ(disc_kinds_of(discs, Allowed::nothing, two), (DiscKinds{{DiscContact::overlapping, 2}}));
  EXPECT_EQ(disc_kinds_of(discs, Allowed::nothing, own), (DiscKinds{{DiscContact::overlapping, 3}}));
}

// Many in one place, which the grid leaves to the sweep, with such as reach out of it, and all too large for a grid.
TEST(DiscsAllTest, Crowds) {
  Random random(41);
  std::vector<Disc> discs = discs_in_square(800, {0, 0}, 1, 0.02, random);
  for (const Disc& c : discs_in_square(300, {0.5, 0.5}, 0.01, 0.002, random)) discs.push_back(c);
  for (const Disc& c : discs_in_square(100, {0.47, 0.47}, 0.06, 0.03, random)) discs.push_back(c);
  const DiscKinds kinds = disc_kinds_of(discs);
  EXPECT_GT(kinds.at(DiscContact::overlapping), 5000u);
  EXPECT_GT(kinds.at(DiscContact::inside), 500u);
  std::vector<std::uint32_t> groups;
  for (std::size_t k = 0; k < discs.size(); ++k) groups.push_back(static_cast<std::uint32_t>(k % 3));
  EXPECT_LT(disc_kinds_of(discs, Allowed::nothing, groups).at(DiscContact::overlapping),
            kinds.at(DiscContact::overlapping));
  EXPECT_GT(disc_kinds_of(discs_in_square(500, {0, 0}, 1, 1, random)).at(DiscContact::overlapping), 10000u);
}

// After the visitor says so, it is not called again.
TEST(DiscsAllTest, Stops) {
  Random random(42);
  std::vector<Disc> discs = discs_in_square(800, {0, 0}, 1, 0.02, random);
  for (const Disc& c : discs_in_square(300, {0.5, 0.5}, 0.01, 0.002, random)) discs.push_back(c);
  const Discs circles(discs);
  const std::uint64_t count = discs_count(circles).count;
  for (const auto method : disc_methods) {
    for (const std::uint64_t most : {std::uint64_t{1}, count / 2, count - 1}) {
      std::uint64_t calls = 0;
      method(circles, {}, [&](const DiscsContact&) { return ++calls < most; });
      EXPECT_EQ(calls, most);
    }
  }
}

TEST(DiscsAllTest, ProgressIsCalled) {
  Random random(43);
  const Discs circles(discs_in_square(150000, {0, 0}, 1, 0.0005, random));
  for (const auto method : {&discs_all_by_sweep, &discs_all_by_grid}) {
    double last = -1;
    int calls = 0;
    const auto progress = [&](double part) {
      EXPECT_GT(part, last);
      EXPECT_LE(part, 1);
      last = part;
      ++calls;
    };
    method(circles, {Allowed::nothing, {}, progress}, [](const DiscsContact&) { return true; });
    EXPECT_GE(calls, 2);
  }
}

// The sweep compares those pairs only whose boxes meet: of random discs, a constant times the contacts.
TEST(DiscsAllTest, PairsGrowAsTheContacts) {
  Random random(44);
  for (std::size_t n = 8; n <= 1u << 17; n *= 4) {
    const double radius = 2 / std::sqrt(static_cast<double>(n));
    const Discs circles(discs_in_square(n, {0, 0}, 1, radius, random));
    std::uint64_t count = 0;
    const auto visit = [&](const DiscsContact&) { return ++count > 0; };
    const Cost sweep = discs_all_by_sweep(circles, {}, visit);
    EXPECT_GT(count, n);
    EXPECT_LT(sweep.probes, count * 4 / 3 + 64);  // squares against discs: 4 / pi at most
    // The grid compares these too, and the boxes of a cell.
    const std::uint64_t contacts = count, by_grid = discs_all_by_grid(circles, {}, visit).probes;
    EXPECT_GE(by_grid, sweep.probes);
    EXPECT_LT(by_grid, 8 * contacts + 64);
  }
}

}  // namespace
}  // namespace sunder::planar
