// half_planes, linear_program and kernel, and their methods, against the oracles; and what symmetries keep.
#include <tests/support/half_plane_sets.h>
#include <tests/support/scale.h>
#include <tests/support/simple_polygons.h>

#include <sunder/base/error.h>
#include <sunder/planar/region/half_plane_intersection.h>
#include <sunder/planar/region/kernel.h>
#include <sunder/planar/region/linear_program.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <map>
#include <string>
#include <vector>

namespace sunder::tests {
namespace {

using planar::Constraints;
using planar::HalfPlanes;
using planar::LinearProgramAnswer;
using planar::Objective;
using planar::PolygonSides;
using planar::Region;
using planar::RegionKind;

constexpr planar::RegionOptions with_evidence{true};

template <class Given>
void expect_true_region(const Given& given, const Region& region, const Region& scan) {
  ASSERT_EQ(name_of(region.kind), name_of(scan.kind));
  if (!scan.empty()) {
    ASSERT_EQ(region.sides, scan.sides) << name_of(scan.kind);
  }
  ASSERT_TRUE(check(given, region)) << name_of(scan.kind);
}

template <class Family>
void print(const std::map<Family, std::map<RegionKind, int>>& kinds) {
  std::printf("%-10s", "family");
  for (int kind = 0; kind <= static_cast<int>(RegionKind::plane); ++kind) {
    std::printf(" %10s", std::string(name_of(static_cast<RegionKind>(kind))).c_str());
  }
  for (const auto& [family, of_family] : kinds) {
    std::printf("\n%-10s", std::string(name_of(family)).c_str());
    for (int kind = 0; kind <= static_cast<int>(RegionKind::plane); ++kind) {
      const auto found = of_family.find(static_cast<RegionKind>(kind));
      std::printf(" %10d", found == of_family.end() ? 0 : found->second);
    }
  }
  std::printf("\n");
}

template <class Given>
RegionKind region_by_all(const Given& given) {
  const Region scan = half_plane_intersection_by_scan(given, with_evidence);
  expect_true_region(given, scan, scan);
  expect_true_region(given, half_plane_intersection(given, with_evidence), scan);
  expect_true_region(given, half_plane_intersection_by_sort(given, with_evidence), scan);
  expect_true_region(given, half_plane_intersection_by_division(given, with_evidence), scan);
  return scan.kind;
}

TEST(RegionsDifferential, HalfPlanesAgreeWithTheScan) {
  const int count = scaled_count(20000);
  const std::uint64_t seed = chosen_seed(20261221);
  SCOPED_TRACE("seed " + std::to_string(seed));
  HalfPlaneSets sets(seed);
  std::map<HalfPlaneFamily, std::map<RegionKind, int>> kinds, kinds_of_arrows;
  std::map<RegionKind, int> all;
  for (int i = 0; i < count; ++i) {
    RegionKind kind = RegionKind::empty;
    if (i % 4 < 3) {
      kind = region_by_all(Constraints(sets.constraints()));
      ++kinds[sets.family()][kind];
    } else {
      const std::vector<planar::HalfPlane> arrows = sets.arrows();
      kind = region_by_all(HalfPlanes(arrows));
      ++kinds_of_arrows[sets.family()][kind];
    }
    ++all[kind];
    ASSERT_FALSE(testing::Test::HasFailure()) << i << " " << name_of(sets.family());
  }
  print(kinds);
  print(kinds_of_arrows);
  if (count < 20000) return;
  EXPECT_EQ(kinds.size(), half_plane_family_count);
  EXPECT_EQ(kinds_of_arrows.size(), 5u);
  for (int kind = 0; kind <= static_cast<int>(RegionKind::plane); ++kind) {
    EXPECT_GT(all[static_cast<RegionKind>(kind)], count / 500) << name_of(static_cast<RegionKind>(kind));
  }
  EXPECT_GT(all[RegionKind::empty], count / 5);
  EXPECT_LT(all[RegionKind::empty], count / 2);
}

bool is_set(std::uint32_t i) { return i != planar::no_half_plane; }

bool same_point(const ExactPoint2& p, const ExactPoint2& q) {
  return p.x * q.denominator == q.x * p.denominator && p.y * q.denominator == q.y * p.denominator;
}

// The outcome and the optimal points. That a feasible one is where the answer says is left to check.
template <class Given>
void expect_true_region(const Given& given, const Objective& objective, const LinearProgramAnswer& answer,
                        const LinearProgramAnswer& scan) {
  ASSERT_EQ(name_of(answer.verdict()), name_of(scan.verdict()));
  ASSERT_TRUE(check(given, objective, answer)) << name_of(scan.verdict());
  if (scan.verdict() == Optimum::one) {
    ASSERT_TRUE(same_point(point_of(given, answer), point_of(given, scan)));
  }
  if (scan.verdict() != Optimum::many) return;
  const auto &edge = std::get<planar::ManyOptima>(answer.evidence),
             &truth = std::get<planar::ManyOptima>(scan.evidence);
  ASSERT_EQ(is_set(edge.before), is_set(truth.before));
  ASSERT_EQ(is_set(edge.after), is_set(truth.after));
  const auto corner = [&](std::uint32_t i, std::uint32_t j) { return exact_corner(given[i], given[j]); };
  if (is_set(truth.before)) {
    ASSERT_TRUE(same_point(corner(edge.before, edge.side), corner(truth.before, truth.side)));
  }
  if (is_set(truth.after)) {
    ASSERT_TRUE(same_point(corner(edge.side, edge.after), corner(truth.side, truth.after)));
  }
}

template <class Given>
Optimum program_by_all(const Given& given, const Objective& objective) {
  const LinearProgramAnswer scan = linear_program_by_scan(given, objective);
  expect_true_region(given, objective, scan, scan);
  expect_true_region(given, objective, linear_program(given, objective), scan);
  expect_true_region(given, objective, linear_program_by_seidel(given, objective), scan);
  expect_true_region(given, objective, linear_program_by_sampling(given, objective), scan);
  const Region region = half_plane_intersection(given);
  EXPECT_EQ(region.empty(), !is_feasible(scan));
  expect_true_region(given, objective, linear_program_by_region(given, region, objective), scan);
  expect_true_region(given, objective,
                     linear_program_by_region(planar::PreparedRegion<Given>(given, region), objective), scan);
  return scan.verdict();
}

// With or against a normal, along its line, of small whole numbers, or any.
template <class Given>
Objective objective_for(const Given& given, Random& random) {
  const auto whole = [&] { return static_cast<double>(random.between(-3, 3)); };
  if (given.size() > 0 && random.below(2) == 0) {
    const ExactConstraint exact = exact_constraint(given[static_cast<std::uint32_t>(random.below(given.size()))]);
    const double a = exact.a.nearest(), b = exact.b.nearest();
    if (std::isfinite(a) && std::isfinite(b)) {
      const std::array<Objective, 3> ways{{{a, b}, {-a, -b}, {-b, a}}};
      return ways[random.below(3)];
    }
  }
  if (random.below(2) == 0) return {whole(), whole()};
  return {random.uniform(-1, 1), random.uniform(-1, 1)};
}

TEST(RegionsDifferential, LinearProgramsAgreeWithTheScan) {
  const int count = scaled_count(20000);
  const std::uint64_t seed = chosen_seed(20261222);
  SCOPED_TRACE("seed " + std::to_string(seed));
  HalfPlaneSets sets(seed);
  std::map<Optimum, int> outcomes;
  for (int i = 0; i < count; ++i) {
    if (i % 4 < 3) {
      const Constraints given(sets.constraints());
      ++outcomes[program_by_all(given, objective_for(given, sets.random()))];
    } else {
      const std::vector<planar::HalfPlane> arrows = sets.arrows();
      const HalfPlanes given(arrows);
      ++outcomes[program_by_all(given, objective_for(given, sets.random()))];
    }
    ASSERT_FALSE(testing::Test::HasFailure()) << i << " " << name_of(sets.family());
  }
  for (const auto& [outcome, times] : outcomes)
    std::printf("%-10s %6d\n", std::string(name_of(outcome)).c_str(), times);
  if (count < 20000) return;
  for (const Optimum outcome : {Optimum::one, Optimum::many, Optimum::unbounded, Optimum::infeasible}) {
    EXPECT_GT(outcomes[outcome], count / 20) << name_of(outcome);
  }
}

TEST(RegionsDifferential, KernelsAgreeWithTheScan) {
  const int count = scaled_count(20000);
  const std::uint64_t seed = chosen_seed(20261223);
  SCOPED_TRACE("seed " + std::to_string(seed));
  SimplePolygons polygons(seed);
  std::map<SimplePolygonFamily, std::map<RegionKind, int>> kinds;
  std::map<SimplePolygonFamily, std::uint32_t> vertices;
  std::map<RegionKind, int> all;
  for (int i = 0; i < count; ++i) {
    const planar::Polygon polygon = polygons.next();
    const PolygonSides sides(polygon);
    const Region scan = kernel_by_scan(sides, with_evidence);
    expect_true_region(sides, scan, scan);
    expect_true_region(sides, kernel(sides, with_evidence), scan);
    expect_true_region(sides, kernel_by_half_plane_intersection(sides, with_evidence), scan);
    expect_true_region(sides, kernel_by_lee_preparata(sides, with_evidence), scan);
    vertices[polygons.family()] += sides.size();
    ++kinds[polygons.family()][scan.kind];
    ++all[scan.kind];
    ASSERT_FALSE(testing::Test::HasFailure()) << i << " " << name_of(polygons.family());
  }
  print(kinds);
  if (count < 20000) return;
  EXPECT_EQ(kinds.size(), simple_polygon_family_count);
  for (const auto& [family, number] : vertices) {
    EXPECT_GT(6 * number, 5 * static_cast<std::uint32_t>(count)) << name_of(family);  // more than 5 each
  }
  EXPECT_GT(kinds[SimplePolygonFamily::grid][RegionKind::empty], count / 40);
  EXPECT_GT(all[RegionKind::empty], count / 10);
  EXPECT_GT(all[RegionKind::bounded], count / 3);
  EXPECT_GT(all[RegionKind::segment], count / 500);
  EXPECT_GT(all[RegionKind::point], count / 500);
}

// Reflected, in another order, moved by whole numbers: the same kind. Each scaled by a power of two: the same sides.
TEST(RegionsDifferential, SymmetriesKeepTheKind) {
  const int count = scaled_count(4000);
  HalfPlaneSets sets(chosen_seed(20261224));
  int empty = 0;
  for (int i = 0; i < count; ++i) {
    std::vector<Constraint> given = sets.constraints();
    const Region region = planar::half_plane_intersection(Constraints(given));
    empty += region.empty() ? 1 : 0;
    const auto changed = [&](auto&& change) {
      std::vector<Constraint> all;
      for (const Constraint& c : given) all.push_back(change(c));
      return planar::half_plane_intersection(Constraints(all));
    };
    ASSERT_EQ(changed([](const Constraint& c) { return Constraint{-c.a, c.b, c.c}; }).kind, region.kind) << i;
    ASSERT_EQ(changed([](const Constraint& c) { return Constraint{c.b, c.a, c.c}; }).kind, region.kind) << i;
    if (sets.family() == HalfPlaneFamily::grid || sets.family() == HalfPlaneFamily::concurrent) {
      ASSERT_EQ(changed([](const Constraint& c) { return Constraint{c.a, c.b, c.c + 5 * c.a - 9 * c.b}; }).kind,
                region.kind)
          << i;
      const Region scaled = changed([&](const Constraint& c) {
        const double scale = std::exp2(static_cast<double>(sets.random().between(-1000, 1000)));
        return Constraint{c.a * scale, c.b * scale, c.c * scale};
      });
      ASSERT_EQ(scaled.kind, region.kind) << i;
      if (!region.empty()) {
        ASSERT_EQ(scaled.sides, region.sides) << i;
      }
    }
    std::reverse(given.begin(), given.end());
    ASSERT_EQ(planar::half_plane_intersection(Constraints(given)).kind, region.kind) << i;
  }
  if (count < 4000) return;
  EXPECT_GT(empty, count / 5);
  EXPECT_LT(empty, count / 2);
}

}  // namespace
}  // namespace sunder::tests
