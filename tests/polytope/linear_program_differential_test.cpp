// Linear programs and regions of half-spaces of two to six dimensions: all methods against the scan, and in the plane
// against planar/region.
#include <sunder/planar/region/half_plane_intersection.h>
#include <sunder/planar/region/linear_program.h>
#include <sunder/polytope/region/half_space_region.h>
#include <sunder/polytope/region/linear_program.h>

#include <tests/support/half_space_sets.h>
#include <tests/support/scale.h>

#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <string>
#include <variant>
#include <vector>

namespace sunder::polytope {
namespace {

bool are_equal(const ExactPointN& p, const ExactPointN& q) {
  bool equal = p.numbers.size() == q.numbers.size();
  for (std::size_t c = 0; equal && c < p.numbers.size(); ++c) {
    equal = p.numbers[c] * q.denominator == q.numbers[c] * p.denominator;
  }
  return equal;
}

TEST(LinearProgramDifferential, MethodsAgreeWithTheScan) {
  tests::HalfSpaceSets sets(tests::chosen_seed(21005));
  std::array<std::array<int, 5>, 7> outcomes{};  // by dimension
  int finished = 0;
  const int count = tests::scaled_count(8000, 400);
  for (int k = 0; k < count; ++k) {
    const tests::HalfSpaceSet set = sets.next(k % 8 == 0 ? 24 : 12);
    const std::string what = std::string(tests::name_of(set.family)) + ", " + std::to_string(k);
    const LinearProgramAnswer truth = linear_program_by_scan(set.half_spaces, set.objective);
    ASSERT_TRUE(check(set.half_spaces, set.objective, truth)) << what;
    ++outcomes[set.half_spaces.dimension()][static_cast<std::size_t>(truth.verdict())];
    for (const auto& method : {linear_program, linear_program_by_seidel}) {
      const LinearProgramAnswer answer = method(set.half_spaces, set.objective);
      ASSERT_EQ(name_of(answer.verdict()), name_of(truth.verdict())) << what;
      ASSERT_TRUE(check(set.half_spaces, set.objective, answer)) << what;
      if (truth.verdict() == Optimum::one) {
        ASSERT_TRUE(are_equal(*named_point(answer.evidence), *named_point(truth.evidence))) << what;
      }
      finished += answer.decided_by == DecidedBy::finishing ? 1 : 0;
    }
  }
  for (std::size_t d = least_dimension; d <= most_dimension; ++d) {
    for (const int n : outcomes[d]) EXPECT_GT(n, count / 400) << d;
  }
  EXPECT_LT(finished, count / 4);  // of two methods
}

Weights* multipliers_in(ProgramEvidence& evidence) {
  if (auto* one = std::get_if<OneOptimum>(&evidence)) return &one->multipliers;
  if (auto* many = std::get_if<ManyOptima>(&evidence)) return &many->multipliers;
  if (auto* none = std::get_if<NoPoint>(&evidence)) return &none->multipliers;
  return nullptr;
}

// An answer with a number that is another one is refused, or as true.
TEST(LinearProgramDifferential, SpoiltAnswersAreRefused) {
  tests::HalfSpaceSets sets(tests::chosen_seed(21006));
  int tried = 0;
  for (int k = 0; k < tests::scaled_count(1000, 100); ++k) {
    const tests::HalfSpaceSet set = sets.next();
    LinearProgramAnswer answer = linear_program(set.half_spaces, set.objective);
    Weights* const multipliers = multipliers_in(answer.evidence);
    if (multipliers == nullptr || multipliers->parts.empty()) continue;
    ++tried;
    Weights::Part& part = multipliers->parts.front();
    part.numerator = part.numerator + part.numerator;
    if (is_feasible(answer) || multipliers->parts.size() > 1) {  // one alone may be any multiple
      EXPECT_FALSE(check(set.half_spaces, set.objective, answer));
    }
    multipliers->parts.erase(multipliers->parts.begin());
    EXPECT_FALSE(check(set.half_spaces, set.objective, answer));
    if (answer.verdict() == Optimum::many) {
      answer = linear_program(set.half_spaces, set.objective);
      const ManyOptima many = std::get<ManyOptima>(answer.evidence);
      answer.evidence = ManyOptima{many.point, many.point, many.multipliers};
      EXPECT_FALSE(check(set.half_spaces, set.objective, answer));
      answer.evidence = OneOptimum{many.point, many.multipliers};
      EXPECT_FALSE(check(set.half_spaces, set.objective, answer));
    }
  }
  EXPECT_GT(tried, 20);
}

// Of the plane, whose half-planes have a normal that is not zero.
TEST(LinearProgramDifferential, InThePlane) {
  tests::HalfSpaceSets sets(tests::chosen_seed(21007));
  std::array<int, 5> outcomes{};
  std::array<int, 10> kinds{};
  const int count = tests::scaled_count(4000, 400);
  for (int k = 0; k < count; ++k) {
    const auto family = static_cast<tests::HalfSpaceFamily>(k % static_cast<int>(tests::half_space_family_count));
    const tests::HalfSpaceSet set = sets.next(family, 2, static_cast<std::size_t>(k) / 8 % 12);
    std::vector<Constraint> rows;
    for (std::uint32_t i = 0; i < set.half_spaces.size(); ++i) {
      const std::span<const double> row = set.half_spaces.row(i);
      if (row[0] != 0 || row[1] != 0) rows.push_back({row[0], row[1], row[2]});
    }
    std::vector<double> numbers;
    for (const Constraint& row : rows) numbers.insert(numbers.end(), {row.a, row.b, row.c});
    const Polytope body = Polytope::from_half_spaces(2, std::move(numbers));
    const planar::Constraints constraints(std::move(rows));
    const auto truth = planar::linear_program(constraints, planar::Objective{set.objective[0], set.objective[1]});
    const LinearProgramAnswer answer = linear_program(body, set.objective);
    ASSERT_EQ(name_of(answer.verdict()), name_of(truth.verdict())) << k;
    ++outcomes[static_cast<std::size_t>(answer.verdict())];
    if (answer.verdict() == Optimum::one) {
      const ExactPoint2 p = planar::point_of(constraints, truth);
      const bool is_negative = p.denominator.sign() == Sign::negative;
      const auto of = [&](const Dyadic& x) { return is_negative ? -x : x; };
      EXPECT_TRUE(are_equal(*named_point(answer.evidence), {{of(p.x), of(p.y)}, of(p.denominator)})) << k;
    }
    const planar::Region known = planar::half_plane_intersection(constraints, {});
    const HalfSpaceRegion region = half_space_region(body);
    ++kinds[static_cast<std::size_t>(known.kind)];
    using planar::RegionKind;
    const bool is_bounded =
        known.kind == RegionKind::point || known.kind == RegionKind::segment || known.kind == RegionKind::bounded;
    const bool is_of_line =
        known.kind == RegionKind::segment || known.kind == RegionKind::ray || known.kind == RegionKind::line;
    const RegionExtent* const extent = extent_of(region);
    EXPECT_EQ(extent == nullptr, known.empty()) << k;
    if (extent == nullptr) continue;
    EXPECT_EQ(region.verdict() == polytope::RegionKind::bounded, is_bounded) << k;
    EXPECT_EQ(extent->dimension, known.kind == RegionKind::point ? 0u : is_of_line ? 1u : 2u) << k;
  }
  for (const int n : outcomes) EXPECT_GT(n, count / 200);
  for (const int n : kinds) EXPECT_GT(n, count / 1000);
}

// Looks at rows grow as their number, and no faster: the scans that a search takes hardly do.
TEST(LinearProgramDifferential, RowsLookedAtGrowAsN) {
  tests::HalfSpaceSets sets(tests::chosen_seed(21008));
  for (std::size_t d = least_dimension; d <= most_dimension; ++d) {
    for (std::size_t n = 1000; n <= 64000; n *= 8) {
      const tests::HalfSpaceSet set = sets.next(tests::HalfSpaceFamily::tangents, d, n);
      const std::vector<double> along(d, 1.0);
      const LinearProgramAnswer answer = linear_program(set.half_spaces, along);
      EXPECT_EQ(answer.verdict(), Optimum::one);
      EXPECT_EQ(answer.decided_by, DecidedBy::evidence);
      EXPECT_LE(answer.cost.probes, 12 * d * n) << d << " " << n;
      const LinearProgramAnswer by_seidel = linear_program_by_seidel(set.half_spaces, along);
      EXPECT_TRUE(are_equal(*named_point(answer.evidence), *named_point(by_seidel.evidence)));
      double factorial = 1;
      for (std::size_t k = 2; k <= d; ++k) factorial *= static_cast<double>(k);
      EXPECT_LE(static_cast<double>(by_seidel.cost.probes), 4 * factorial * static_cast<double>(n)) << d << " " << n;
    }
  }
}

}  // namespace
}  // namespace sunder::polytope
