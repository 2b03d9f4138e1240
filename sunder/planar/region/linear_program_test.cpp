// Each outcome, all methods against the oracle, the evidence, and how the number of signs grows.
#include <sunder/planar/region/half_plane_intersection.h>
#include <sunder/planar/region/linear_program.h>
#include <tests/support/half_plane_sets.h>
#include <tests/support/scale.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <string>
#include <variant>
#include <vector>

namespace sunder::planar {
namespace {

using tests::HalfPlaneSets;

bool same_point(const ExactPoint2& p, const ExactPoint2& q) {
  return p.x * q.denominator == q.x * p.denominator && p.y * q.denominator == q.y * p.denominator;
}

bool is_set(std::uint32_t i) { return i != no_half_plane; }

// The end of an optimal edge.
template <class Given>
ExactPoint2 end_of(const Given& given, const ManyOptima& edge, bool first) {
  return first ? exact_corner(given[edge.before], given[edge.side]) : exact_corner(given[edge.side], given[edge.after]);
}

template <class Given>
void expect_same(const Given& given, const LinearProgramAnswer& answer, const LinearProgramAnswer& scan) {
  ASSERT_EQ(name_of(answer.verdict()), name_of(scan.verdict()));
  if (scan.verdict() == Optimum::one) {
    ASSERT_TRUE(same_point(point_of(given, answer), point_of(given, scan)));
  }
  if (scan.verdict() != Optimum::many) return;
  const auto &edge = std::get<ManyOptima>(answer.evidence), &truth = std::get<ManyOptima>(scan.evidence);
  ASSERT_EQ(is_set(edge.before), is_set(truth.before));
  ASSERT_EQ(is_set(edge.after), is_set(truth.after));
  if (is_set(truth.before)) {
    ASSERT_TRUE(same_point(end_of(given, edge, true), end_of(given, truth, true)));
  }
  if (is_set(truth.after)) {
    ASSERT_TRUE(same_point(end_of(given, edge, false), end_of(given, truth, false)));
  }
  ASSERT_EQ(tighter(given[edge.side], given[truth.side]), Sign::zero);
}

// L1, L2: all methods, which must agree.
template <class Given>
LinearProgramAnswer optimum_by_all(const Given& given, const Objective& objective) {
  const LinearProgramAnswer scan = linear_program_by_scan(given, objective);
  EXPECT_TRUE(check(given, objective, scan)) << name_of(scan.verdict());
  const Region region = half_plane_intersection(given);
  const std::array answers{linear_program(given, objective), linear_program_by_seidel(given, objective),
                           linear_program_by_sampling(given, objective),
                           linear_program_by_region(given, region, objective),
                           linear_program_by_region(PreparedRegion<Given>(given, region), objective)};
  for (const LinearProgramAnswer& answer : answers) {
    EXPECT_TRUE(check(given, objective, answer)) << name_of(answer.verdict()) << " " << &answer - answers.data();
    expect_same(given, answer, scan);
  }
  return scan;
}

LinearProgramAnswer of(const std::vector<Constraint>& given, const Objective& objective) {
  return optimum_by_all(Constraints(given), objective);
}

TEST(LinearProgramTest, EachOutcome) {
  const std::vector<Constraint> triangle{{1, 1, 4}, {-1, 0, 0}, {0, -1, 0}};
  const LinearProgramAnswer corner = of(triangle, {2, 1});
  EXPECT_EQ(corner.verdict(), Optimum::one);
  EXPECT_EQ(nearest(point_of(Constraints(triangle), corner)), (Point2{4, 0}));
  EXPECT_EQ(of(triangle, {1, 1}).verdict(), Optimum::many);
  EXPECT_EQ(of(triangle, {0, 0}).verdict(), Optimum::all);
  EXPECT_EQ(of({{1, 1, 4}, {-1, 0, 0}}, {1, 1}).verdict(), Optimum::many);
  EXPECT_EQ(of({{1, 1, 4}}, {1, 1}).verdict(), Optimum::many);
  EXPECT_EQ(of({{1, 1, 4}}, {1, 0}).verdict(), Optimum::unbounded);
  EXPECT_EQ(of({{1, 1, 4}}, {-1, -1}).verdict(), Optimum::unbounded);
  EXPECT_EQ(of({}, {-1, -1}).verdict(), Optimum::unbounded);
  EXPECT_EQ(of({}, {0, 0}).verdict(), Optimum::all);
  EXPECT_EQ(of({{1, 1, -4}, {-1, 0, 0}, {0, -1, 0}}, {1, 1}).verdict(), Optimum::infeasible);
  EXPECT_EQ(of({{1, 1, -4}, {-1, -1, 3}}, {0, 0}).verdict(), Optimum::infeasible);
  // An edge that is a point: a segment upright, a point with four sides.
  EXPECT_EQ(of({{1, 0, 0}, {-1, 0, 0}, {0, 1, 1}, {0, -1, 1}}, {0, 1}).verdict(), Optimum::one);
  const std::vector<Constraint> point{{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}};
  EXPECT_EQ(of(point, {0, 1}).verdict(), Optimum::one);
  EXPECT_EQ(of(point, {0, 0}).verdict(), Optimum::all);  // of which there is one
}

Objective objective_for(const std::vector<Constraint>& given, Random& random, int turn) {
  if (turn % 3 == 0 && !given.empty()) {  // with or against a normal, or along its line
    const Constraint& i = given[random.below(given.size())];
    switch (random.below(3)) {
      case 0: return {i.a, i.b};
      case 1: return {-i.a, -i.b};
      default: return {-i.b, i.a};
    }
  }
  if (turn % 3 == 1) {
    return {static_cast<double>(random.between(-3, 3)), static_cast<double>(random.between(-3, 3))};
  }
  return {random.uniform(-1, 1), random.uniform(-1, 1)};
}

TEST(LinearProgramTest, MethodsAgreeWithTheScan) {
  const int count = tests::scaled_count(2000);
  HalfPlaneSets sets(tests::chosen_seed(20261202));
  std::map<Optimum, int> outcomes;
  for (int i = 0; i < count && !testing::Test::HasFailure(); ++i) {
    const std::vector<Constraint> given = sets.constraints();
    SCOPED_TRACE(std::to_string(i) + " " + std::string(name_of(sets.family())));
    ++outcomes[optimum_by_all(Constraints(given), objective_for(given, sets.random(), i)).verdict()];
    const std::vector<HalfPlane> arrows = sets.arrows();
    std::vector<Constraint> differences;
    for (const HalfPlane& h : arrows) differences.push_back({h.b.y - h.a.y, h.a.x - h.b.x, 0});
    const Objective objective = objective_for(differences, sets.random(), i);
    if (!std::isfinite(objective.p) || !std::isfinite(objective.q)) continue;
    ++outcomes[optimum_by_all(HalfPlanes(arrows), objective).verdict()];
  }
  if (count < 2000) return;
  for (const auto& [outcome, times] : outcomes)
    std::printf("%-10s %6d\n", std::string(name_of(outcome)).c_str(), times);
  for (const Optimum outcome : {Optimum::one, Optimum::many, Optimum::unbounded, Optimum::infeasible}) {
    EXPECT_GT(outcomes[outcome], count / 10) << name_of(outcome);
  }
}

// What sampling does with more than a few: rounds, violators, contradictions.
TEST(LinearProgramTest, SamplingAgreesWithSeidelOnLargeSets) {
  Random random(20261203);
  std::map<Optimum, int> outcomes;
  for (int i = 0; i < tests::scaled_count(60); ++i) {
    std::vector<Constraint> given;
    for (int k = 0; k < 1000; ++k) {
      const double angle = i % 4 == 0 ? random.uniform(0, 3) : random.uniform(0, 7);
      const double c = i % 4 == 3 ? random.uniform(-1e-3, 1) : i % 4 == 2 ? 1 : random.uniform(1, 2);
      given.push_back({std::cos(angle), std::sin(angle), c});
    }
    if (i % 8 == 1) given[500] = {0.6, 0.8, -2};
    const Constraints constraints(given);
    const Objective objective{random.uniform(-1, 1), random.uniform(-1, 1)};
    const LinearProgramAnswer seidel = linear_program_by_seidel(constraints, objective);
    const LinearProgramAnswer sampling = linear_program_by_sampling(constraints, objective);
    ASSERT_TRUE(check(constraints, objective, seidel));
    ASSERT_TRUE(check(constraints, objective, sampling));
    expect_same(constraints, sampling, seidel);
    const Region region = half_plane_intersection(constraints);
    expect_same(constraints, linear_program_by_region(constraints, region, objective), seidel);
    ++outcomes[seidel.verdict()];
  }
  if (tests::scaled_count(60) >= 60) {
    EXPECT_GE(outcomes.size(), 3u);
  }
}

// The table of angles finds the place by few signs, also where sides go across the x axis, or lie within a half turn.
TEST(LinearProgramTest, TheTableFindsThePlace) {
  struct Range {
    double from, to;
  };
  for (const auto& [from, to] : {Range{0, 6.28}, {-1, 2}, {2, 4.5}, {-3, 0}, {3.2, 3.3}}) {
    Random random(20261210);
    std::vector<Constraint> given;
    for (int k = 0; k < 1000; ++k) {
      const double angle = random.uniform(from, to);
      given.push_back({std::cos(angle), std::sin(angle), 1});
    }
    const Constraints constraints(given);
    const Region region = half_plane_intersection(constraints);
    const PreparedRegion prepared(constraints, region);
    double probes = 0;
    constexpr int times = 200;
    for (int i = 0; i < times; ++i) {
      const double angle = random.uniform(from, to);
      const Objective objective{std::cos(angle), std::sin(angle)};
      const LinearProgramAnswer answer = linear_program_by_region(prepared, objective);
      ASSERT_TRUE(check(constraints, objective, answer));
      expect_same(constraints, answer, linear_program_by_region(constraints, region, objective));
      probes += static_cast<double>(answer.cost.probes) / times;
    }
    // Two to confirm, one or two for the side, four for the gap, and those within the range: many where all sides have
    // nearly one angle.
    EXPECT_LT(probes, to - from > 4 ? 5 : to - from > 1 ? 10 : 14) << from;
  }
}

// Sides and objectives where ranges of the table meet, of one direction but for rounding: some lie in the wrong range.
TEST(LinearProgramTest, TheTableIsRounded) {
  Random random(20261211);
  constexpr int sides = 47;
  int searched = 0;
  for (int i = 0; i < 100; ++i) {
    const auto normal = [&](int n) {
      const double key = 2.0 * n / sides, q = key < 2 ? 1 - key : key - 3, scale = random.uniform(1, 2);
      return Objective{q * scale, (key < 2 ? 1 - std::fabs(q) : std::fabs(q) - 1) * scale};
    };
    std::vector<Constraint> given;
    for (int n = 0; n < 2 * sides; n += 2) {
      const auto [a, b] = normal(n);
      given.push_back({a, b, std::hypot(a, b)});
    }
    const Constraints constraints(given);
    const Region region = half_plane_intersection(constraints);
    const PreparedRegion prepared(constraints, region);
    ASSERT_EQ(region.sides.size(), given.size());
    for (int n = 0; n < 2 * sides; n += 2) {
      const Objective objective = normal(n);
      const LinearProgramAnswer answer = linear_program_by_region(prepared, objective);
      ASSERT_TRUE(check(constraints, objective, answer));
      expect_same(constraints, answer, linear_program_by_region(constraints, region, objective));
      if (answer.cost.probes > 6) ++searched;
    }
  }
  EXPECT_GT(searched, 10);
}

// Complexity: O(N) expected signs for Seidel and by sampling; O(log N) in a region, from 2^4 to 2^17.
TEST(LinearProgramTest, SignsGrowAsNAndAsLogN) {
  std::printf("%-8s %10s %10s %10s %10s\n", "N", "front/N", "seidel/N", "region", "prepared");
  for (int power = 4; power <= 17; ++power) {
    for (int family = 0; family < 3; ++family) {
      Random random(20261209);
      std::vector<Constraint> given;
      for (std::size_t k = 0; k < std::size_t{1} << power; ++k) {
        const double angle = random.uniform(0, 7), c = family == 0 ? 1 : random.uniform(family == 1 ? 1 : -0.01, 2);
        given.push_back({std::cos(angle), std::sin(angle), c});
      }
      const Constraints constraints(given);
      const Region region = half_plane_intersection(constraints);
      const PreparedRegion prepared(constraints, region);
      const double n = constraints.size();
      double front = 0, seidel = 0, by_region = 0, by_table = 0;
      constexpr int times = 8;
      for (int i = 0; i < times; ++i) {
        const double angle = random.uniform(0, 7);
        const Objective objective{std::cos(angle), std::sin(angle)};
        const auto probes = [](const LinearProgramAnswer& answer) { return static_cast<double>(answer.cost.probes); };
        front += probes(linear_program(constraints, objective)) / times;
        seidel += probes(linear_program_by_seidel(constraints, objective)) / times;
        by_region = std::max(by_region, probes(linear_program_by_region(constraints, region, objective)));
        by_table = std::max(by_table, probes(linear_program_by_region(prepared, objective)));
      }
      if (power % 4 == 1)
        std::printf("%-8.0f %10.2f %10.2f %10.0f %10.0f\n", n, front / n, seidel / n, by_region, by_table);
      EXPECT_LT(front, 12 * n + 60) << family << " " << n;
      EXPECT_LT(seidel, 14 * n + 60) << family << " " << n;
      EXPECT_LE(by_region, std::log2(n) + 5) << family << " " << n;
      EXPECT_LE(by_table, std::log2(n) + 7) << family << " " << n;
    }
  }
}

// Three numbers as the evidence of an outcome, and those of evidence.
struct NamedThree {
  std::uint32_t before = no_half_plane, side = no_half_plane, after = no_half_plane;
  bool backward = false;
  friend bool operator==(const NamedThree&, const NamedThree&) = default;
};
ProgramEvidence evidence_of(Optimum outcome, const NamedThree& numbers) {
  const auto [before, side, after, backward] = numbers;
  switch (outcome) {
    case Optimum::one: return OneOptimum{before, after, side};
    case Optimum::many: return ManyOptima{side, before, after};
    case Optimum::all: return AnyPoint{before, after};
    case Optimum::unbounded: return NoBound{{before, after}, side, backward};
    case Optimum::infeasible: break;
  }
  return NoPoint{before, after, side};
}
NamedThree numbers_of(const ProgramEvidence& evidence) {
  if (const auto* any = std::get_if<AnyPoint>(&evidence)) return {any->before, no_half_plane, any->after};
  if (const auto* far = std::get_if<NoBound>(&evidence)) {
    return {far->from.before, far->side, far->from.after, far->backward};
  }
  if (const auto* one = std::get_if<OneOptimum>(&evidence)) return {one->before, one->side, one->after};
  if (const auto* many = std::get_if<ManyOptima>(&evidence)) return {many->before, many->side, many->after};
  const auto& none = std::get<NoPoint>(evidence);
  return {none.before, none.side, none.after};
}

// What check refuses: another outcome, other half-planes.
TEST(LinearProgramTest, UntrueAnswersAreRefused) {
  HalfPlaneSets sets(20261210);
  int changed = 0, refused = 0;
  for (int i = 0; i < tests::scaled_count(2000); ++i) {
    const std::vector<Constraint> all = sets.constraints();
    const Constraints given(all);
    const Objective objective = objective_for(all, sets.random(), i);
    const LinearProgramAnswer answer = linear_program(given, objective);
    ASSERT_TRUE(check(given, objective, answer));
    for (const Optimum outcome : {Optimum::one, Optimum::many, Optimum::all, Optimum::unbounded, Optimum::infeasible}) {
      if (outcome == answer.verdict()) continue;
      const LinearProgramAnswer wrong{evidence_of(outcome, numbers_of(answer.evidence))};
      EXPECT_FALSE(check(given, objective, wrong)) << name_of(answer.verdict()) << " as " << name_of(outcome);
    }
    const NamedThree own = numbers_of(answer.evidence);
    NamedThree changes = own;
    changes.before = given.size();
    EXPECT_FALSE(check(given, objective, LinearProgramAnswer{evidence_of(answer.verdict(), changes)}));
    if (answer.verdict() == Optimum::unbounded) {
      changes = own;
      changes.backward = !changes.backward;
      EXPECT_FALSE(check(given, objective, LinearProgramAnswer{evidence_of(answer.verdict(), changes)}));
    }
    if (given.size() == 0) continue;
    const LinearProgramAnswer truth = linear_program_by_scan(given, objective);
    for (std::uint32_t NamedThree::* number : {&NamedThree::before, &NamedThree::side, &NamedThree::after}) {
      if (answer.verdict() == Optimum::all && number == &NamedThree::side) continue;  // it has none
      changes = own;
      changes.*number =
          sets.random().below(4) == 0 ? no_half_plane : static_cast<std::uint32_t>(sets.random().below(given.size()));
      const LinearProgramAnswer wrong{evidence_of(answer.verdict(), changes)};
      ++changed;
      if (!check(given, objective, wrong)) {
        ++refused;
      } else {
        expect_same(given, wrong, truth);  // another true one
      }
    }
  }
  if (tests::scaled_count(2000) >= 2000) {
    EXPECT_GT(refused, changed / 2);
  }
}

}  // namespace
}  // namespace sunder::planar
