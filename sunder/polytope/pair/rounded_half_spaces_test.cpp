#include <sunder/base/random.h>
#include <sunder/polytope/pair/placed.h>
#include <sunder/polytope/pair/rounded_half_spaces.h>
#include <tests/support/scale.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace sunder::polytope {
namespace {

// Under poses that are far from symmetric: rows are about those of the exact image, and the one that is broken most
// has about the number that they say.
TEST(RoundedHalfSpaces, AreAboutTheExactOnes) {
  Random random(tests::chosen_seed(20261127));
  const int count = tests::scaled_count(300, 60);
  for (int i = 0; i < count; ++i) {
    const std::size_t d = 2 + random.below(5), n = 1 + random.below(40);
    const auto some = [&](std::size_t numbers, double size) {
      std::vector<double> result(numbers);
      for (double& x : result) x = random.uniform(-size, size);
      return result;
    };
    std::vector<double> linear = some(d * d, 0.1);
    for (std::size_t r = 0; r < d; ++r) linear[r * d + (r + 1) % d] += r % 2 == 0 ? 1.5 : -1;  // turned, and reflected
    const Polytope body = Polytope::from_half_spaces(d, some(n * (d + 1), 1));
    const Pose pose = i % 4 == 0 ? Pose(d) : Pose::from_matrix(d, linear, some(d, 10));
    const RoundedHalfSpaces rounded(body, pose);
    ASSERT_TRUE(rounded.is_usable());
    Placed exact(body, pose);
    ColumnNumbers x{};
    for (std::size_t c = 0; c < d; ++c) x[c] = random.uniform(-1, 1);
    const double w = random.uniform(0.1, 1);
    double greatest = -HUGE_VAL;
    for (std::uint32_t k = 0; k < n; ++k) {
      const ColumnNumbers row = rounded.row(k);
      const ExactVector image = exact.half_space(k);
      double product = -w * row[d];
      for (std::size_t c = 0; c <= d; ++c) {
        ASSERT_NEAR(row[c], nearest_ratio(image[c], exact.scale()), 0x1p-40) << i;
        if (c < d) product += row[c] * x[c];
      }
      greatest = std::max(greatest, product);
    }
    CandidateRows candidates(body);
    Cost cost;
    ASSERT_NEAR(rounded.most_broken(x, w, candidates, cost).product, greatest, 0x1p-40) << i;
  }
}

// All numbers of the rows and of the point are in the bound, where only one of them is not zero, too.
TEST(RoundedHalfSpaces, KeepBeyondTheErrorsOfAllColumns) {
  const Pose here(3);
  for (std::size_t c = 0; c <= 3; ++c) {
    std::vector<double> row(4);
    row[c] = c < 3 ? -1 : 1;
    const Polytope body = Polytope::from_half_spaces(3, row);
    const RoundedHalfSpaces rounded(body, here);
    ColumnNumbers x{};
    if (c < 3) x[c] = -1;
    EXPECT_FALSE(rounded.keeps(x, 1, -0x1p-51)) << c;
    EXPECT_TRUE(rounded.keeps(x, 1, -0x1p-48)) << c;
  }
}

// Where products cancel, and where they underflow or overflow, no point is kept that one is broken at, or touches.
TEST(RoundedHalfSpaces, KeepNothingThatIsNotInside) {
  Random random(tests::chosen_seed(20261128));
  const int count = tests::scaled_count(6000, 600);
  int kept = 0, not_inside = 0;
  for (int i = 0; i < count; ++i) {
    const std::size_t d = 2 + random.below(5), n = 1 + random.below(3);
    const int kind = i % 3;
    const auto number = [&] {
      const double x = random.uniform(-1, 1);
      return kind == 0
                 ? x
                 : std::ldexp(x, static_cast<int>(kind == 1 ? random.between(-545, -525) : random.between(490, 511)));
    };
    ColumnNumbers x{};
    for (std::size_t c = 0; c < d; ++c) x[c] = number();
    const double w = std::fabs(number());
    std::vector<double> rows;
    for (std::size_t k = 0; k < n; ++k) {
      double level = 0;
      for (std::size_t c = 0; c < d; ++c) {
        rows.push_back(number());
        level += rows.back() * x[c];
      }
      rows.push_back(
          level / w *
          (1 + static_cast<double>(random.between(-1, 1)) * std::ldexp(1, static_cast<int>(random.between(-54, -38)))));
      if (!std::isfinite(rows.back())) rows.back() = 1;
    }
    const Polytope body = Polytope::from_half_spaces(d, rows);
    const Pose here(d);
    const RoundedHalfSpaces rounded(body, here);
    CandidateRows candidates(body);
    Cost cost;
    const bool keeps = rounded.keeps(x, w, rounded.most_broken(x, w, candidates, cost).product);
    bool is_inside = true;
    for (std::uint32_t k = 0; k < n; ++k) {
      Dyadic product = -(Dyadic(w) * Dyadic(body.row(k)[d]));
      for (std::size_t c = 0; c < d; ++c) product = product + Dyadic(x[c]) * Dyadic(body.row(k)[c]);
      is_inside = is_inside && product.sign() == Sign::negative;
    }
    ASSERT_TRUE(!keeps || is_inside) << i;
    kept += keeps;
    not_inside += !is_inside;
  }
  EXPECT_GT(kept, count / 50);
  EXPECT_GT(not_inside, count / 4);
}

TEST(RoundedHalfSpaces, SizeIsThatOfTheImage) {
  const Polytope box = Polytope::from_half_spaces(2, {1, 0, 2, -1, 0, 2, 0, 1, 2, 0, -1, 2});
  const std::vector<double> linear{0, 16, -16, 0}, none{0, 0}, far{0, -100};
  const auto size = [&](const Pose& pose) { return RoundedHalfSpaces(box, pose).size(); };
  EXPECT_EQ(size(Pose(2)), 2);
  EXPECT_EQ(size(Pose::from_matrix(2, linear, none)), 32);
  EXPECT_EQ(size(Pose::from_matrix(2, linear, far)), 132);
}

}  // namespace
}  // namespace sunder::polytope
