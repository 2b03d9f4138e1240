// The kinds of regions, all methods against the oracle, the evidence, and how the number of signs grows.
#include <sunder/base/error.h>
#include <sunder/planar/region/half_plane_intersection.h>
#include <tests/support/half_plane_sets.h>
#include <tests/support/scale.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <string>
#include <vector>

namespace sunder::planar {
namespace {

using tests::HalfPlaneSets;

constexpr RegionOptions with_evidence{true};

// All methods, which must agree.
template <class Given>
Region by_all(const Given& given) {
  const Region scan = half_plane_intersection_by_scan(given, with_evidence);
  EXPECT_TRUE(check(given, scan)) << name_of(scan.kind);
  for (const auto method : {half_plane_intersection<Given>, half_plane_intersection_by_sort<Given>,
                            half_plane_intersection_by_division<Given>}) {
    const Region region = method(given, with_evidence);
    EXPECT_EQ(name_of(region.kind), name_of(scan.kind));
    if (!scan.empty()) {
      EXPECT_EQ(region.sides, scan.sides) << name_of(scan.kind);
    }
    EXPECT_TRUE(check(given, region)) << name_of(region.kind);
    EXPECT_TRUE(method(given, {}).cones.empty());
  }
  return scan;
}

Region region_of(const std::vector<Constraint>& given) { return by_all(Constraints(given)); }

using Numbers = std::vector<std::uint32_t>;

void expect(const std::vector<Constraint>& given, RegionKind kind, const Numbers& sides) {
  const Region region = region_of(given);
  EXPECT_EQ(name_of(region.kind), name_of(kind));
  EXPECT_EQ(region.sides, sides) << name_of(kind);
}

TEST(HalfPlanesTest, EachKind) {
  expect({}, RegionKind::plane, {});
  expect({{1, 0, 1}}, RegionKind::half_plane, {0});
  expect({{1, 0, 1}, {2, 0, 1}, {3, 0, 9}}, RegionKind::half_plane, {1});
  expect({{-1, 0, 1}, {1, 0, 1}, {1, 0, 2}}, RegionKind::strip, {1, 0});
  expect({{-1, 0, -1}, {1, 0, 1}, {2, 0, 2}}, RegionKind::line, {1, 0});
  expect({{-1, 0, -1}, {1, 0, 1}, {1, 2, 2}, {0, 3, 0}}, RegionKind::ray, {1, 3, 0});
  expect({{-1, 0, -1}, {1, 0, 1}, {0, -1, 1}, {0, 1, 1}}, RegionKind::segment, {1, 3, 0, 2});
  expect({{0, 1, 0}, {1, 0, 0}}, RegionKind::unbounded, {1, 0});
  expect({{0, -1, 0}, {1, 0, 0}}, RegionKind::unbounded, {0, 1});
  expect({{1, 1, 1}, {-1, 0, 0}, {0, -1, 0}, {1, 2, 4}}, RegionKind::bounded, {0, 1, 2});
  expect({{1, 1, 0}, {-1, 0, 0}, {0, -1, 0}}, RegionKind::point, {0, 1, 2});
  expect({{1, 0, 0}, {-1, 0, 0}, {0, -1, 0}, {0, 1, 0}}, RegionKind::point, {0, 3, 1, 2});
  EXPECT_TRUE(region_of({{1, 1, -1}, {-1, 0, 0}, {0, -1, 0}}).empty());
  EXPECT_TRUE(region_of({{1, 0, -1}, {-2, 0, 1}}).empty());
}

TEST(HalfPlanesTest, TiesGoToTheLowestNumber) {
  expect({{2, 0, 2}, {1, 0, 1}, {1, 0, 1}}, RegionKind::half_plane, {0});
  // A segment on the x axis whose end at 1 three lines go through.
  expect({{0, 1, 0}, {0, -1, 0}, {1, 7, 1}, {2, 0, 2}, {1, -3, 1}, {-1, 5, 0}, {-1, 0, 0}}, RegionKind::segment,
         {2, 0, 5, 1});
}

// Barely empty and barely not: one unit in the last place of one number decides.
TEST(HalfPlanesTest, OneUnitInTheLastPlace) {
  const double third = 1.0 / 3;
  const auto triangle = [&](double c) {
    return std::vector<Constraint>{{third, 0.7, c}, {-third, 0.1, 0.1}, {0, -0.8, -0.25}};
  };
  // y = 0.3125, and -x / 3 = 0.1 - 0.03125 rounded somewhere: find where it turns.
  double low = -1, high = 1;
  while (std::nextafter(low, high) < high) {
    const double middle = low + (high - low) / 2;
    (region_of(triangle(middle)).empty() ? low : high) = middle;
  }
  EXPECT_EQ(region_of(triangle(low)).kind, RegionKind::empty);
  EXPECT_NE(region_of(triangle(high)).kind, RegionKind::empty);
  EXPECT_EQ(region_of({{1, 0, -5e-324}, {-1, 0, 0}}).kind, RegionKind::empty);
  EXPECT_EQ(region_of({{1, 0, 5e-324}, {-1, 0, 0}}).kind, RegionKind::strip);
  EXPECT_EQ(region_of({{1e308, 1e308, 0}, {-1e308, 0, 0}, {0, -1e308, -5e-324}}).kind, RegionKind::empty);
}

TEST(HalfPlanesTest, BadNumbersAreRefused) {
  const auto code_and_place = [](const Constraint& bad) {
    try {
      Constraints(std::vector<Constraint>{{1, 2, 3}, bad});
    } catch (const Error& error) {
      EXPECT_EQ(error.place(), "half-plane 1");
      return static_cast<int>(error.code());
    }
    return -1;
  };
  const double infinity = std::numeric_limits<double>::infinity();
  EXPECT_EQ(code_and_place({0, 0, 1}), static_cast<int>(ErrorCode::bad_shape));
  EXPECT_EQ(code_and_place({infinity, 0, 1}), static_cast<int>(ErrorCode::bad_value));
  EXPECT_EQ(code_and_place({1, 0, std::nan("")}), static_cast<int>(ErrorCode::bad_value));
}

template <class Given>
void expect_points(const Given& given, const Region& region) {
  const auto value = [&](const ExactPoint2& p, std::uint32_t k) {
    const ExactConstraint half = exact_constraint(given[k]);
    return half.a * p.x + half.b * p.y - half.c * p.denominator;
  };
  if (region.empty()) {
    const std::vector<Dyadic> times = multipliers(given, region);
    Dyadic a, b, c;
    for (std::size_t p = 0; p < region.sides.size(); ++p) {
      const ExactConstraint half = exact_constraint(given[region.sides[p]]);
      EXPECT_EQ(times[p].sign(), Sign::positive);
      a = a + times[p] * half.a;
      b = b + times[p] * half.b;
      c = c + times[p] * half.c;
    }
    EXPECT_EQ(a.sign(), Sign::zero);
    EXPECT_EQ(b.sign(), Sign::zero);
    EXPECT_EQ(c.sign(), Sign::negative);
    return;
  }
  std::vector<ExactPoint2> points{point_of(given, region)};
  for (const auto& [i, j] : corners(region)) points.push_back(exact_corner(given[i], given[j]));
  for (const ExactPoint2& p : points) {
    EXPECT_EQ(p.denominator.sign(), Sign::positive);
    for (std::uint32_t k = 0; k < given.size(); ++k) EXPECT_NE(value(p, k).sign(), Sign::positive);
  }
}

// P1, P2 on nasty sets; the points and multipliers of the evidence, exactly.
TEST(HalfPlanesTest, MethodsAgreeWithTheScan) {
  const int count = tests::scaled_count(3000);
  HalfPlaneSets sets(tests::chosen_seed(20261201));
  std::map<RegionKind, int> kinds;
  for (int i = 0; i < count && !testing::Test::HasFailure(); ++i) {
    const Constraints given(sets.constraints());
    SCOPED_TRACE(std::to_string(i) + " " + std::string(name_of(sets.family())));
    const Region region = by_all(given);
    if (i % 4 == 0) expect_points(given, region);
    ++kinds[region.kind];
    const std::vector<HalfPlane> arrows = sets.arrows();
    const Region of_arrows = by_all(HalfPlanes(arrows));
    if (i % 4 == 0) expect_points(HalfPlanes(arrows), of_arrows);
    ++kinds[of_arrows.kind];
  }
  if (count < 3000) return;
  for (const auto& [kind, times] : kinds) std::printf("%-10s %6d\n", std::string(name_of(kind)).c_str(), times);
  for (int kind = 0; kind <= static_cast<int>(RegionKind::plane); ++kind) {
    EXPECT_GT(kinds[static_cast<RegionKind>(kind)], count / 200) << name_of(static_cast<RegionKind>(kind));
  }
}

// So many that samples are taken: of each kind, with ties, against the method that sorts.
TEST(HalfPlanesTest, LargeSetsBySamples) {
  Random random(20261206);
  std::map<RegionKind, int> kinds;
  constexpr int families = 9;
  for (int i = 0; i < tests::scaled_count(10 * families) && !testing::Test::HasFailure(); ++i) {
    const int family = i % families;
    SCOPED_TRACE(i);
    const std::size_t count = 2048 + random.below(4000);
    std::vector<Constraint> given;
    const double px = static_cast<double>(random.between(-9, 9)), py = static_cast<double>(random.between(-9, 9));
    while (given.size() < count) {
      const double angle = random.uniform(0, 7), x = std::cos(angle), y = std::sin(angle), off = random.uniform(1, 2);
      const double a = static_cast<double>(random.between(-9, 9)), b = static_cast<double>(random.between(-9, 9));
      const double size = std::fabs(a) + std::fabs(b), near = a * px + b * py;
      if (a == 0 && b == 0) continue;
      switch (family) {
        case 0: given.push_back({x, y, off}); break;
        case 1: given.push_back({x, y, 1}); break;
        case 2: given.push_back({x, std::fabs(y), off}); break;                                // up alone
        case 3: given.push_back({a, b, near + size}); break;                                   // each side many times
        case 4: given.push_back({a, b, near}); break;                                          // a point
        case 5: given.push_back({a, b, a == 0 ? near : near + size}); break;                   // a segment
        case 6: given.push_back({a < 0 ? 0 : a, b == 0 ? 1 : b, near}); break;                 // a ray or so
        case 7: given.push_back({0, b == 0 ? 1 : b, b * py + (random.below(9) == 0)}); break;  // a line
        default: given.push_back({x, y, given.size() == count / 2 ? -1e-3 : 1e-3 * random.unit()}); break;
      }
    }
    const Constraints constraints(given);
    const Region sort = half_plane_intersection_by_sort(constraints, with_evidence);
    EXPECT_TRUE(check(constraints, sort));
    ++kinds[sort.kind];
    for (const auto method : {half_plane_intersection<Constraints>, half_plane_intersection_by_division<Constraints>}) {
      const Region region = method(constraints, with_evidence);
      EXPECT_EQ(name_of(region.kind), name_of(sort.kind));
      if (!sort.empty()) {
        EXPECT_EQ(region.sides, sort.sides);
      }
      EXPECT_TRUE(check(constraints, region));
    }
  }
  if (tests::scaled_count(90) >= 90) {
    EXPECT_GE(kinds.size(), 7u);
  }
}

// Complexity (SH76, Theorem 9): signs within stated multiples of N log2 N, from 2^4 to 2^17, where all are sides, where
// few are, and where there is nothing. (By sort all but few comparisons are of keys, and not counted: linear.)
TEST(HalfPlanesTest, SignsGrowAsNLogN) {
  std::printf("%-10s %8s %10s %10s %10s\n", "family", "N", "front/N", "sort/N", "div/NlogN");
  for (int power = 4; power <= 17; ++power) {
    for (int family = 0; family < 3; ++family) {
      Random random(20261207);
      std::vector<Constraint> given;
      for (std::size_t k = 0; k < std::size_t{1} << power; ++k) {
        const double angle = random.uniform(0, 7), c = family == 0 ? 1 : random.uniform(family == 1 ? 1 : -0.01, 2);
        given.push_back({std::cos(angle), std::sin(angle), c});
      }
      const Constraints constraints(given);
      const auto probes = [&](auto method) { return static_cast<double>(method(constraints, {}).cost.probes); };
      const double n = constraints.size();
      const double front = probes(half_plane_intersection<Constraints>) / n,
                   sort = probes(half_plane_intersection_by_sort<Constraints>) / n,
                   division = probes(half_plane_intersection_by_division<Constraints>) / (n * std::log2(n));
      if (power % 4 == 1) std::printf("%-10d %8.0f %10.2f %10.2f %10.2f\n", family, n, front, sort, division);
      EXPECT_LT(front, 6) << family << " " << n;
      EXPECT_LT(sort, 6) << family << " " << n;
      EXPECT_LT(division, 6) << family << " " << n;
    }
  }
}

// What check refuses: each change of a region or its evidence that makes it untrue.
TEST(HalfPlanesTest, UntrueRegionsAreRefused) {
  HalfPlaneSets sets(20261208);
  int changed = 0, refused = 0;
  for (int i = 0; i < tests::scaled_count(1500); ++i) {
    const Constraints given(sets.constraints());
    const Region region = half_plane_intersection(given, with_evidence);
    const std::uint32_t n = given.size();
    ASSERT_TRUE(check(given, region));
    for (int kind = 0; kind <= static_cast<int>(RegionKind::plane); ++kind) {
      if (static_cast<RegionKind>(kind) == region.kind) continue;
      Region wrong = region;
      wrong.kind = static_cast<RegionKind>(kind);
      EXPECT_FALSE(check(given, wrong)) << name_of(region.kind) << " as " << name_of(wrong.kind);
    }
    if (region.sides.empty()) continue;
    const std::size_t p = sets.random().below(region.sides.size());
    Region wrong = region;
    wrong.sides.erase(wrong.sides.begin() + static_cast<std::ptrdiff_t>(p));
    // The sides that are left may still be those of a point, where there were four.
    if (region.kind != RegionKind::point) {
      EXPECT_FALSE(check(given, wrong)) << name_of(region.kind);
    }
    wrong = region;
    wrong.sides[p] = n;
    EXPECT_FALSE(check(given, wrong));
    wrong.sides[p] = static_cast<std::uint32_t>(sets.random().below(n));
    ++changed;
    if (!check(given, wrong)) ++refused;
    if (region.empty()) continue;
    wrong = region;
    wrong.cones.pop_back();
    EXPECT_FALSE(check(given, wrong));
    wrong.cones = region.cones;
    wrong.cones[sets.random().below(n)] = static_cast<std::uint32_t>(region.sides.size());
    EXPECT_FALSE(check(given, wrong));
  }
  if (tests::scaled_count(1500) >= 1500) {
    EXPECT_GT(refused, changed / 2);
  }
}

}  // namespace
}  // namespace sunder::planar
