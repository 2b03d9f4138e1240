#include <sunder/predicate/filter/along_columns.h>

#include <sunder/base/random.h>
#include <sunder/predicate/filter/column_kernels_internal.h>
#include <tests/support/exact.h>
#include <tests/support/scale.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>
#include <vector>

namespace sunder {
namespace {

using tests::Exact;

struct Points {
  std::size_t dimension;
  std::uint32_t count;
  std::vector<double> numbers;  // by columns

  PointColumns columns() const {
    PointColumns result{numbers.data(), numbers.size() / dimension, count, dimension, {}};
    for (std::size_t c = 0; c < dimension; ++c) {
      for (std::uint32_t k = 0; k < count; ++k) {
        result.reach[c] = std::max(result.reach[c], std::fabs(result.at(k, c)));
      }
    }
    return result;
  }
  Exact product(std::uint32_t k, const std::vector<double>& direction) const {
    Exact sum(0.0);
    for (std::size_t c = 0; c < dimension; ++c) sum = sum + Exact(columns().at(k, c)) * Exact(direction[c]);
    return sum;
  }
};

template <class Number>
Points points_of(std::size_t d, std::uint32_t count, const Number& number) {
  const std::size_t stride = (count + PointColumns::block - 1) / PointColumns::block * PointColumns::block;
  Points result{d, count, std::vector<double>(stride * d)};
  for (std::size_t c = 0; c < d; ++c) {
    for (std::size_t k = 0; k < stride; ++k) {
      result.numbers[c * stride + k] = k < count ? number() : result.numbers[c * stride + count - 1];
    }
  }
  return result;
}

TEST(AlongColumns, ErrorsAreBoundedAndTheExactFurthestIsFound) {
  const int cases = tests::scaled_count(2000, 80);
  Random random(tests::chosen_seed(20261126));
  int sure = 0, ties = 0, many_looks = 0, zeros = 0;
  for (int i = 0; i < cases; ++i) {
    const std::size_t d = 2 + random.below(6);
    const auto count = static_cast<std::uint32_t>(1 + random.below(100));
    const std::uint64_t kind = random.below(4);
    const auto number = [&] {
      const double sign = random.below(2) == 0 ? 1.0 : -1.0;
      switch (kind) {
        case 0: return random.uniform(-1, 1);
        case 1: return static_cast<double>(random.between(-2, 2));
        case 2: return sign * random.log_uniform(1e-300, 1e300);
        default: return sign * random.log_uniform(5e-324, 1e-300);  // underflow
      }
    };
    const Points points = points_of(d, count, number);
    std::vector<double> direction(d);
    for (double& x : direction) x = kind == 1 ? static_cast<double>(random.between(-1, 1)) : random.uniform(-1, 1);
    ColumnNumbers rounded{}, sizes{};
    for (std::size_t c = 0; c < d; ++c) {
      rounded[c] = direction[c];
      sizes[c] = std::fabs(direction[c]);
    }
    const FurthestPoint found = furthest_along(points.columns(), rounded);
    const double error = product_error(points.columns(), sizes, 0);
    ASSERT_LT(found.index, count);
    std::uint32_t best = 0;
    for (std::uint32_t k = 1; k < count; ++k) {
      if (!(points.product(k, direction) <= points.product(best, direction))) best = k;
    }
    if (std::isfinite(error)) {
      const Exact off = points.product(best, direction) - Exact(found.product);
      ASSERT_TRUE(off <= Exact(error) && -off <= Exact(error)) << i << " of kind " << kind;
    }
    std::uint32_t looks = 0;
    const std::vector<Dyadic> exact(direction.begin(), direction.end());
    const ExactFurthest furthest = exactly_furthest_along(points.columns(), exact, looks);
    std::uint32_t looks_at_sign = 0;
    ASSERT_EQ(is_any_positive_along(points.columns(), exact, looks_at_sign), furthest.product.sign() == Sign::positive)
        << i << " of kind " << kind;
    sure += looks_at_sign == 0;
    bool is_zero = true;
    for (const double x : direction) is_zero = is_zero && x == 0;
    ASSERT_EQ(furthest.index, is_zero ? 0 : best) << i << " of kind " << kind;
    ASSERT_TRUE(Exact(furthest.product) == points.product(best, direction));
    std::vector<std::uint32_t> at_greatest;
    for (std::uint32_t k = 0; k < count; ++k) {
      if (points.product(k, direction) == points.product(best, direction)) at_greatest.push_back(k);
    }
    std::uint32_t looks_at_face = 0;
    const ExactFace face = exact_face_along(points.columns(), exact, looks_at_face);
    ASSERT_EQ(face.indices, at_greatest) << i << " of kind " << kind;
    ASSERT_TRUE(Exact(face.product) == points.product(best, direction));
    ASSERT_GE(looks_at_face, at_greatest.size());
    std::vector<std::uint32_t> at_zero;
    for (std::uint32_t k = 0; k < count; ++k) {
      if (points.product(k, direction) == Exact(0.0)) at_zero.push_back(k);
    }
    zeros += static_cast<int>(at_zero.size());
    std::uint32_t looks_at_zero = 0;
    ASSERT_EQ(at_zero_along(points.columns(), exact, looks_at_zero), at_zero) << i << " of kind " << kind;
    ASSERT_GE(looks_at_zero, at_zero.size());
    ties += kind == 1 && looks > 1;
    many_looks += kind == 0 && looks > 2;
  }
  EXPECT_GT(sure, cases / 2);
  EXPECT_GT(ties, cases / 20);
  EXPECT_GT(zeros, cases);
  EXPECT_LT(many_looks, cases / 50);
}

// Products that differ by less than their roundings, and such as overflow, where all exact ones are negative.
TEST(AlongColumns, ExactLooksDecideWhereFloatingPointMayErr) {
  Random random(tests::chosen_seed(20261130));
  int misled = 0;
  const int cases = tests::scaled_count(600, 100);
  for (int i = 0; i < cases; ++i) {
    const std::size_t d = 2 + random.below(6);
    const auto count = static_cast<std::uint32_t>(2 + random.below(100));
    const bool is_huge = i % 4 == 0;
    Points points =
        points_of(d, count, [&] { return is_huge ? -random.uniform(0.5, 1) * 0x1p1023 : random.uniform(-1, 1); });
    std::vector<double> direction(d);
    for (double& x : direction) x = random.uniform(0.5, 1);
    const std::size_t stride = points.numbers.size() / d;
    for (std::size_t k = 0; k < stride && !is_huge; ++k) {
      double rest = 1;
      for (std::size_t c = 1; c < d; ++c) rest -= direction[c] * points.numbers[c * stride + k];
      points.numbers[k] = rest / direction[0];
    }
    std::uint32_t best = 0;
    for (std::uint32_t k = 1; k < count; ++k) {
      if (!(points.product(k, direction) <= points.product(best, direction))) best = k;
    }
    ColumnNumbers rounded{};
    std::copy(direction.begin(), direction.end(), rounded.begin());
    misled += furthest_along(points.columns(), rounded).index != best;
    const std::vector<Dyadic> exact(direction.begin(), direction.end());
    std::uint32_t looks = 0;
    const ExactFurthest furthest = exactly_furthest_along(points.columns(), exact, looks);
    ASSERT_EQ(furthest.index, best) << i;
    ASSERT_TRUE(Exact(furthest.product) == points.product(best, direction)) << i;
    ASSERT_EQ(exact_face_along(points.columns(), exact, looks).indices.at(0), best) << i;
  }
  EXPECT_GT(misled, cases / 4);
}

// Products that are zero but for roundings, along directions that are doubles, or have more bits than these.
TEST(AlongColumns, TheSignOfTheGreatestIsThatOfTheExactOne) {
  Random random(tests::chosen_seed(20261128));
  const int cases = tests::scaled_count(4000, 1000);
  int too_high = 0, too_low = 0, zero = 0;
  for (int i = 0; i < cases; ++i) {
    const std::size_t d = 2 + random.below(6);
    const auto count = static_cast<std::uint32_t>(1 + random.below(i % 8 == 0 ? 80 : 3));
    const double size = std::ldexp(1.0, static_cast<int>(i % 3 == 0 ? random.between(-1060, 1010) : 0));
    Points points = points_of(d, count, [&] { return random.uniform(-1, 1) * size; });
    ColumnNumbers rounded{};
    for (std::size_t c = 0; c < d; ++c) rounded[c] = random.uniform(0.5, 1);
    std::vector<Dyadic> direction(rounded.begin(), rounded.begin() + static_cast<std::ptrdiff_t>(d));
    const std::size_t stride = points.numbers.size() / d;
    for (std::size_t k = 0; k < stride; ++k) {
      double rest = 0;
      for (std::size_t c = 1; c < d; ++c) rest -= rounded[c] * points.numbers[c * stride + k];
      points.numbers[k] = rest / rounded[0];
    }
    if (i % 7 == 0) std::fill(points.numbers.begin(), points.numbers.end(), 0.0);
    for (std::size_t c = 0; c < d && i % 2 == 0; ++c) {
      direction[c] =
          direction[c] + Dyadic(std::ldexp(random.uniform(-1, 1), -static_cast<int>(random.between(52, 70))));
    }
    Sign greatest = Sign::negative;
    for (std::uint32_t k = 0; k < count; ++k) {
      Dyadic product;
      for (std::size_t c = 0; c < d; ++c) product = product + direction[c] * Dyadic(points.columns().at(k, c));
      greatest = std::max(greatest, product.sign());
    }
    std::uint32_t looks = 0;
    ASSERT_EQ(is_any_positive_along(points.columns(), direction, looks), greatest == Sign::positive) << i;
    const double said = furthest_along(points.columns(), rounded).product;
    too_high += said > 0 && greatest != Sign::positive;
    too_low += said < 0 && greatest == Sign::positive;
    zero += greatest == Sign::zero;
  }
  EXPECT_GT(too_high, cases / 100);
  EXPECT_GT(too_low, cases / 100);
  EXPECT_GT(zero, cases / 100);
}

// Of many points one is about at zero: only that is looked at exactly.
TEST(AlongColumns, TheSignTakesFewExactLooks) {
  std::uint32_t k = 0;
  const Points points = points_of(2, 300, [&] { return k++ % 300 == 177 ? 0.0 : -1.0; });
  std::uint32_t looks = 0;
  EXPECT_FALSE(is_any_positive_along(points.columns(), std::vector<Dyadic>{1.0, 0x1p-60}, looks));
  EXPECT_EQ(looks, 1u);
}

// Directions of many bits, along which many points are about equally far, some of them exactly.
TEST(AlongColumns, TheFurthestAlongDirectionsOfManyBits) {
  const int cases = tests::scaled_count(400, 60);
  Random random(tests::chosen_seed(20261127));
  int ties = 0, nearly = 0;
  for (int i = 0; i < cases; ++i) {
    const std::size_t d = 2 + random.below(6);
    const auto count = static_cast<std::uint32_t>(40 + random.below(60));
    const double unit = std::ldexp(1.0, static_cast<int>(random.below(200)) - 100);
    Points points =
        points_of(d, count, [&] { return static_cast<double>(random.between(-(1 << 20), 1 << 20)) * unit; });
    // Along (1, s, s^2, ..) x1 makes of each product 0 or 1, and along what differs from it by a 2^-70th about that.
    std::vector<Dyadic> direction(d, Dyadic(1.0));
    const Dyadic slant(static_cast<double>(random.between(-9, 9)));
    for (std::size_t c = 1; c < d; ++c) direction[c] = direction[c - 1] * slant;
    const std::size_t stride = points.numbers.size() / d;
    for (std::uint32_t k = 0; k < stride; ++k) {
      double sum = 0;
      for (std::size_t c = 1; c < d; ++c) sum += direction[c].nearest() * points.numbers[c * stride + k];
      points.numbers[k] = -sum + (std::min(k, count - 1) % 3 == 0 ? unit : 0);
    }
    const Dyadic large(static_cast<double>(random.between(1, 1 << 30)));
    for (Dyadic& x : direction) x = x * large * large * large;
    if (i % 2 == 0) direction[d - 1] = direction[d - 1] + Dyadic(0x1p-70);
    std::uint32_t looks = 0, best = 0;
    const ExactFurthest found = exactly_furthest_along(points.columns(), direction, looks);
    const auto product = [&](std::uint32_t k) {
      Dyadic sum;
      for (std::size_t c = 0; c < d; ++c) sum = sum + direction[c] * Dyadic(points.columns().at(k, c));
      return sum;
    };
    for (std::uint32_t k = 1; k < count; ++k) {
      if ((product(k) - product(best)).sign() == Sign::positive) best = k;
    }
    ASSERT_EQ(found.index, best) << i;
    ASSERT_TRUE(found.product == product(best)) << i;
    ties += i % 2 != 0 && looks > 12;
    nearly += i % 2 == 0 && looks > 12;
    std::uint32_t more = 0;
    ASSERT_EQ(is_any_positive_along(points.columns(), direction, more), found.product.sign() == Sign::positive);
  }
  EXPECT_GT(ties, cases / 4);
  EXPECT_GT(nearly, cases / 4);
}

// Products that differ in the last bits of one number, and far below these: more bits than integers of few words have,
// of one column or of all together.
TEST(AlongColumns, TheFurthestOfNumbersOfVeryDifferentSizes) {
  Random random(tests::chosen_seed(20261201));
  const int cases = tests::scaled_count(400, 80);
  int near = 0;
  for (int i = 0; i < cases; ++i) {
    const std::size_t d = 2 + random.below(6);
    const auto count = static_cast<std::uint32_t>(2 + random.below(60));
    const auto odd = [&] { return static_cast<double>(random.between(-9, 9)); };
    Points points = points_of(d, count, [&] { return odd(); });
    const std::size_t stride = points.numbers.size() / d;
    const int far = 60 + static_cast<int>(random.below(800));
    for (std::size_t k = 0; k < stride; ++k) {
      const std::size_t of = std::min<std::size_t>(k, count - 1);
      points.numbers[k] = 1 - static_cast<double>(of % 3) * 0x1p-53;
      // In one column: of one point in two far below the others.
      for (std::size_t c = 1; c < d; ++c) {
        double& x = points.numbers[c * stride + k];
        if (i % 2 == 0) x = std::ldexp(x, of % 2 == 0 ? -60 : -60 - far);
      }
    }
    std::vector<Dyadic> direction(d, Dyadic(1.0));
    for (std::size_t c = 1; c < d && i % 2 == 1; ++c) direction[c] = Dyadic(std::ldexp(1.0, -60 - far));
    const auto product = [&](std::uint32_t k) {
      Dyadic sum;
      for (std::size_t c = 0; c < d; ++c) sum = sum + direction[c] * Dyadic(points.columns().at(k, c));
      return sum;
    };
    std::uint32_t best = 0, looks = 0;
    for (std::uint32_t k = 1; k < count; ++k) {
      if ((product(k) - product(best)).sign() == Sign::positive) best = k;
    }
    const ExactFurthest found = exactly_furthest_along(points.columns(), direction, looks);
    ASSERT_EQ(found.index, best) << i;
    ASSERT_TRUE(found.product == product(best)) << i;
    near += looks > 1;
  }
  EXPECT_GT(near, cases * 9 / 10);
}

TEST(AlongColumns, OfEqualsTheFirst) {
  for (std::uint32_t count = 1; count < 70; ++count) {
    for (std::uint32_t first = 0; first < count; ++first) {
      std::uint32_t k = 0;
      const Points points = points_of(2, count, [&] { return k++ % count < first ? 0.0 : 1.0; });
      EXPECT_EQ(furthest_along(points.columns(), {1, 0}).index, first);
      std::uint32_t looks = 0;
      EXPECT_EQ(exactly_furthest_along(points.columns(), std::vector<Dyadic>{1.0, 0.0}, looks).index, first);
    }
  }
}

// Registers of four hold the same numbers as those of two, bit for bit: ties and infinities included. (Of what is no
// number either may say another.)
TEST(AlongColumns, WiderRegistersSayTheSame) {
  if (column_kernels_of_four(2) == nullptr) GTEST_SKIP() << "this machine has none";
  Random random(tests::chosen_seed(20261127));
  for (int round = 0; round < tests::scaled_count(2000, 200); ++round) {
    const std::size_t d = 2 + random.below(6);
    const std::uint32_t count = 1 + static_cast<std::uint32_t>(random.below(2500));
    const int kind = round % 5;
    const Points points = points_of(d, count, [&]() -> double {
      if (kind == 0) return random.uniform(-1, 1);
      if (kind == 1) return static_cast<double>(random.between(-2, 2));
      if (kind == 2) return random.below(50) == 0 ? HUGE_VAL : random.uniform(-1, 1);
      if (kind == 4) return random.below(2) == 0 ? -1.0 : random.below(2) == 0 ? -0.0 : 0.0;
      return random.log_uniform(1e-320, 1e300);
    });
    const PointColumns columns = points.columns();
    ColumnNumbers direction{};
    for (std::size_t c = 0; c < d; ++c) {
      direction[c] = kind == 1   ? static_cast<double>(random.between(-1, 1))
                     : kind == 2 ? random.uniform(0.5, 1)
                     : kind == 4 ? static_cast<double>(random.below(2))
                                 : random.uniform(-1, 1);
    }
    const ColumnKernels &two = column_kernels_of_two(d), &four = *column_kernels_of_four(d);
    const std::size_t every = 1 + random.below(4);
    const FurthestBlock best = two.furthest_block(columns, direction, every),
                        other = four.furthest_block(columns, direction, every);
    ASSERT_EQ(best.first, other.first);
    ASSERT_EQ(std::memcmp(&best.product, &other.product, sizeof(double)), 0);
    std::array<double, PointColumns::block> products, others;
    two.products_of_block(columns, direction, best.first, products.data());
    four.products_of_block(columns, direction, best.first, others.data());
    ASSERT_EQ(std::memcmp(products.data(), others.data(), sizeof products), 0);
    const double limit = products[random.below(products.size())];
    for (std::size_t first = 0; first < columns.stride; first += PointColumns::block) {
      ASSERT_EQ(two.next_block(columns, direction, first, limit), four.next_block(columns, direction, first, limit));
    }
    ColumnTops tops, wide_tops;
    for (ColumnTops* of : {&tops, &wide_tops}) {
      of->products.fill(-HUGE_VAL);
      of->indices.fill(0);
    }
    two.find_tops(columns, direction, tops);
    four.find_tops(columns, direction, wide_tops);
    ASSERT_EQ(std::memcmp(tops.products.data(), wide_tops.products.data(), sizeof tops.products), 0);
    ASSERT_EQ(tops.indices, wide_tops.indices);
  }
}

TEST(AlongColumns, ASampleIsEverySomeBlock) {
  std::uint32_t k = 0;
  const Points points = points_of(2, 300, [&] { return static_cast<double>(k++); });  // later points are further
  EXPECT_EQ(furthest_along(points.columns(), {1, 0}).index, 299u);
  EXPECT_EQ(furthest_along(points.columns(), {1, 0}, 2).index, 9u * 32 - 1);  // of blocks 0, 2, .., 8
  EXPECT_EQ(furthest_along(points.columns(), {1, 0}, 7).index, 8u * 32 - 1);
  EXPECT_EQ(furthest_along(points.columns(), {-1, 0}, 7).index, 0u);
}

// In each place of the shortlist stands the furthest point of the pieces of 16 that share it; the last point may stand
// in those of what fills the last block.
TEST(AlongColumns, AShortlistHasTheFurthestOfEachPiece) {
  Random random(tests::chosen_seed(20261127));
  int shared = 0, whole = 0;
  for (int i = 0; i < tests::scaled_count(400, 40); ++i) {
    const std::size_t d = 2 + random.below(6);
    const auto count = static_cast<std::uint32_t>(1 + random.below(i % 2 == 0 ? 3000 : 100));
    const Points points = points_of(d, count, [&] { return random.uniform(-1, 1); });
    const PointColumns columns = points.columns();
    ColumnNumbers direction{};
    for (std::size_t c = 0; c < d; ++c) direction[c] = random.uniform(-1, 1);
    const auto product = [&](std::uint32_t k) {
      double sum = direction[0] * columns.at(k, 0);
      for (std::size_t c = 1; c < d; ++c) sum += direction[c] * columns.at(k, c);
      return sum;
    };
    Shortlist list;
    const FurthestPoint found = furthest_along(columns, direction, list);
    const FurthestPoint plain = furthest_along(columns, direction);
    ASSERT_EQ(found.index, plain.index) << i;
    ASSERT_EQ(found.product, plain.product) << i;
    std::vector<double> greatest(Shortlist::most, -std::numeric_limits<double>::infinity());
    const auto end = static_cast<std::uint32_t>(columns.stride);
    for (std::uint32_t k = 0; k < end; ++k) {
      double& place = greatest[k / 16 % Shortlist::most];
      place = std::max(place, product(std::min(k, count - 1)));
    }
    ASSERT_EQ(list.count(), std::min<std::size_t>(end / 16, Shortlist::most));
    for (std::uint32_t k = 0; k < list.count(); ++k) {
      const std::uint32_t index = list.index(k);
      ASSERT_LT(index, count);
      ASSERT_EQ(product(index), greatest[k]);
      ASSERT_TRUE(index / 16 % Shortlist::most == k || index == count - 1);
      for (std::size_t c = 0; c < d; ++c) ASSERT_EQ(list.columns().at(k, c), columns.at(index, c));
    }
    const FurthestPoint among = furthest_along(list.columns(), direction);
    ASSERT_EQ(list.index(among.index), found.index);
    shared += count > 16 * Shortlist::most;
    whole += count <= 16 * Shortlist::most;
  }
  EXPECT_GT(shared, 4);
  EXPECT_GT(whole, 4);
}

TEST(AlongColumns, ProductsThatMayOverflowAreNotBounded) {
  const Points points = points_of(2, 1, [] { return 1e308; });
  EXPECT_EQ(product_error(points.columns(), {1, 1}, 0), std::numeric_limits<double>::infinity());
  EXPECT_EQ(compare(BoundedProduct{0, 0}, BoundedProduct{1, tests::infinity}), Guess::unsure);
  EXPECT_EQ(compare(BoundedProduct{0, 0.25}, BoundedProduct{1, 0.5}), Guess::positive);
  EXPECT_EQ(compare(BoundedProduct{0, 0.5}, BoundedProduct{1, 0.5}), Guess::unsure);
  EXPECT_EQ(compare(BoundedProduct{1, 0.25}, BoundedProduct{0, 0.5}), Guess::negative);
}

}  // namespace
}  // namespace sunder
