#include <sunder/base/random.h>
#include <sunder/polytope/pair/common_weights.h>
#include <sunder/polytope/pair/null_vector_internal.h>
#include <sunder/polytope/pair/polytope_polytope.h>
#include <tests/support/scale.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <vector>

namespace sunder::polytope {
namespace {

// Of integers small enough for int64, and of numbers of very different sizes.
TEST(NullVector, IsARelation) {
  Random random(tests::chosen_seed(20261128));
  int found = 0, lower = 0;
  const int count = tests::scaled_count(2000, 200);
  for (int round = 0; round < count; ++round) {
    const std::size_t d = 2 + random.below(5), n = 1 + random.below(d + 1);
    std::vector<ExactVector> vectors(n, ExactVector(d));
    for (ExactVector& v : vectors) {
      for (Dyadic& x : v) {
        const double size = round % 3 == 0 ? std::ldexp(1.0, static_cast<int>(random.between(-900, 900))) : 1;
        x = Dyadic(static_cast<double>(random.between(-3, 3)) * size);
      }
    }
    if (n > 1 && n <= d) {  // dependent by construction
      vectors[n - 1] = ExactVector(d);
      for (std::size_t k = 0; k + 1 < n; ++k) {
        const Dyadic by = static_cast<double>(random.between(-2, 2));
        for (std::size_t c = 0; c < d; ++c) vectors[n - 1][c] = vectors[n - 1][c] + by * vectors[k][c];
      }
    }
    const auto numbers = null_vector(vectors);
    if (!numbers) continue;
    ++found;
    lower += n <= d;
    EXPECT_GE((*numbers)[n - 1], 0);
    EXPECT_TRUE(std::any_of(numbers->begin(), numbers->end(), [](const Integer& x) { return x != 0; }));
    for (std::size_t c = 0; c < d; ++c) {
      Dyadic sum;
      for (std::size_t k = 0; k < n; ++k) sum = sum + dyadic_of((*numbers)[k], 0) * vectors[k][c];
      EXPECT_EQ(sum.sign(), Sign::zero);
    }
  }
  EXPECT_GT(found, count / 4);
  EXPECT_GT(lower, count / 8);
  EXPECT_FALSE(null_vector(std::vector<ExactVector>{{1.0, 0.0}, {1.0, 0x1p-1074}}));
}

Integer random_integer(Random& random, std::size_t bits) {
  Integer x = 0;
  for (std::size_t k = 0; k < bits; ++k) x = 2 * x + static_cast<int>(random.below(2));
  return random.below(2) == 0 ? x : -x;
}
FewWords::Entry entry_of(const Integer& x) {
  const Integer size = boost::multiprecision::abs(x), low = size % (Integer(1) << 64), high = size >> 64;
  return {FewWords::Word2{static_cast<std::uint64_t>(high)} << 64 | static_cast<std::uint64_t>(low), x < 0};
}

// Sums of products are those of integers of any size, in all words and in as few as hold them.
TEST(FewWords, AreIntegers) {
  Random random(tests::chosen_seed(20261127));
  for (int round = 0; round < tests::scaled_count(2000, 200); ++round) {
    FewWords::Number sum{}, power{1}, words{};
    Integer expected = 0, expected_power = 1;
    for (int k = 0; k < 3; ++k) {
      const Integer e = random_integer(random, random.below(127));
      FewWords::Number next{};
      FewWords::add_product(next, entry_of(e), power, false);
      power = next;
      expected_power *= e;
      const Integer f = random_integer(random, random.below(60));
      const bool is_negative = random.below(2) == 0;
      FewWords::add_product(sum, entry_of(f), power, is_negative);
      expected += is_negative ? -f * expected_power : f * expected_power;
    }
    ASSERT_EQ(FewWords::integer(sum), expected);
    ASSERT_EQ(FewWords::is_negative(sum), expected < 0);
    ASSERT_EQ(FewWords::is_zero(sum), expected == 0);
    // A product of 126 + 60 bits and a sign, in three words.
    const Integer e = random_integer(random, random.below(127)), f = random_integer(random, random.below(60));
    FewWords::Number x{};
    FewWords::add_product(x, entry_of(f), {1}, false);
    FewWords::add_product(words, entry_of(e), x, true, 3);
    FewWords::extend(words, 3);
    ASSERT_EQ(FewWords::integer(words), -e * f);
    const Integer g = random_integer(random, random.below(300)), h = random_integer(random, random.below(300));
    const auto shift = static_cast<unsigned>(random.below(200));
    const FewWords::Number of_g = FewWords::number(g, shift), of_h = FewWords::number(h, 0);
    ASSERT_EQ(FewWords::integer(of_g), g << shift);
    ASSERT_EQ(FewWords::is_less(of_g, of_h), (g << shift) < h);
    ASSERT_EQ(FewWords::is_less(of_h, FewWords::number(h + 1, 0)), true);
    ASSERT_EQ(FewWords::is_less(of_h, of_h), false);
  }
}

// Of vectors of integers of up to 85 bits.
TEST(NullVector, OfFewWordsIsThatOfIntegersOfAnySize) {
  Random random(tests::chosen_seed(20261127));
  const int count = tests::scaled_count(1000, 100);
  int found = 0;
  for (int round = 0; round < count; ++round) {
    FewWordVectors few;
    few.equations = 2 + random.below(5);
    few.count = few.equations + 1;
    std::vector<ExactVector> vectors(few.count, ExactVector(few.equations));
    for (std::size_t r = 0; r < few.equations; ++r) {
      few.bits[r] = static_cast<std::int64_t>(1 + random.below(480 / few.equations));
      few.bits[r] = std::min(few.bits[r], static_cast<std::int64_t>(FewWords::most_bits));
      for (std::size_t j = 0; j < few.count; ++j) {
        const Integer x = random_integer(random, static_cast<std::size_t>(few.bits[r]));
        few.numbers[r][j] = entry_of(x);
        vectors[j][r] = dyadic_of(x, 0);
      }
    }
    ASSERT_TRUE(few.fit());
    const auto numbers = null_vector(few);
    if (!numbers) continue;
    ++found;
    EXPECT_FALSE(FewWords::is_negative((*numbers)[few.count - 1]));
    for (std::size_t r = 0; r < few.equations; ++r) {
      Dyadic sum;
      for (std::size_t j = 0; j < few.count; ++j) {
        sum = sum + dyadic_of(FewWords::integer((*numbers)[j]), 0) * vectors[j][r];
      }
      EXPECT_EQ(sum.sign(), Sign::zero);
    }
  }
  EXPECT_GT(found, count / 2);
}

std::vector<std::uint32_t> all_of(const Polytope& body) {
  std::vector<std::uint32_t> rows(body.size());
  std::iota(rows.begin(), rows.end(), 0u);
  return rows;
}

// Two simplices, often touching or flat: where weights are found, they are a proof; where the bodies meet, they mostly
// are.
TEST(CommonWeights, AreAProof) {
  const int count = tests::scaled_count(2000, 200);
  Random random(tests::chosen_seed(20261128));
  int meets = 0, found = 0;
  for (int round = 0; round < count; ++round) {
    const std::size_t d = 2 + random.below(5);
    const auto simplex = [&] {
      std::vector<double> rows(d * (1 + random.below(d + 1)));
      for (double& x : rows) x = static_cast<double>(random.between(-2, 2));
      return Polytope::from_points(d, rows);
    };
    const Polytope a = simplex(), b = simplex();
    Pose there(d);
    if (round % 2 == 0) there = Pose::from_matrix(d, Pose(d).linear(), std::vector<double>(d, random.uniform(-1, 1)));
    const std::vector<std::uint32_t> rows_a = all_of(a), rows_b = all_of(b);
    const auto common = common_point_by_determinants(a, there, b, there, {rows_a, rows_b});
    const bool meet = polytope_polytope_by_scan(a, there, b, there).meet();
    meets += meet;
    if (!common) continue;
    ++found;
    ASSERT_TRUE(meet);
    EXPECT_TRUE(check(a, there, b, there, Verdict::meet, *common));
    EXPECT_LE(common->of_a.parts.size() + common->of_b.parts.size(), d + 2);
  }
  EXPECT_GT(meets, count / 20);
  EXPECT_GT(found, meets / 2);
}

// Doubles of all bits, of one size (integers of few words) and of many (of any size); each is a proof.
TEST(CommonWeights, OfDoublesOfAllBits) {
  const int count = tests::scaled_count(1000, 100);
  Random random(tests::chosen_seed(20261127));
  int meets = 0, found = 0, few = 0;
  for (int round = 0; round < count; ++round) {
    const std::size_t d = 2 + random.below(5);
    const bool is_of_one_size = round % 2 == 0;
    const auto simplex = [&](std::size_t points) {
      std::vector<double> rows(d * points);
      for (double& x : rows) {
        x = is_of_one_size ? random.uniform(-1, 1) : random.uniform(-1, 1) * random.log_uniform(1e-30, 1);
      }
      return Polytope::from_points(d, rows);
    };
    const Polytope a = simplex(1 + random.below(d + 1)), b = simplex(d + 1);
    const Pose here(d);
    const std::vector<std::uint32_t> rows_a = all_of(a), rows_b = all_of(b);
    const auto common = common_point_by_determinants(a, here, b, here, {rows_a, rows_b});
    const bool meet = polytope_polytope_by_scan(a, here, b, here).meet();
    meets += meet;
    if (!common) continue;
    ASSERT_TRUE(meet);
    ++found;
    few += is_of_one_size;
    EXPECT_TRUE(check(a, here, b, here, Verdict::meet, *common));
  }
  EXPECT_GT(meets, count / 10);
  EXPECT_GT(found, meets / 2);
  EXPECT_GT(few, count / 50);
  EXPECT_GT(found - few, count / 50);
}

// Bodies with the same centre meet where the search's simplex is of few points.
TEST(CommonWeights, ProveWhatIsOnALowFace) {
  for (std::size_t d = 2; d <= 6; ++d) {
    std::vector<double> rows;
    for (std::size_t k = 0; k < std::size_t{1} << d; ++k) {
      for (std::size_t c = 0; c < d; ++c) rows.push_back((k >> c) & 1 ? 1.0 : -1.0);
    }
    const Polytope cube = Polytope::from_points(d, rows);
    const Pose here(d);
    const PolytopeAnswer answer = polytope_polytope(cube, here, cube, here);
    EXPECT_TRUE(answer.meet());
    EXPECT_EQ(answer.decided_by, DecidedBy::evidence);
    EXPECT_TRUE(check(cube, here, cube, here, Verdict::meet, exact_evidence(cube, here, cube, here, answer)));
  }
}

}  // namespace
}  // namespace sunder::polytope
