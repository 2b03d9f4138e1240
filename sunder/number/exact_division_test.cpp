#include <sunder/base/random.h>
#include <sunder/number/exact_division_internal.h>

#include <gtest/gtest.h>

#include <utility>

namespace sunder {
namespace {

Integer some_integer(Random& random, std::size_t words) {
  Integer x = 0;
  for (std::size_t k = 0; k < words; ++k) {
    const std::uint64_t kind = random.below(4);
    x = (x << 64) + (kind == 0 ? 0 : kind == 1 ? ~std::uint64_t{0} : random.next());
  }
  if (x == 0) x = 1;
  x <<= static_cast<unsigned>(random.below(3) * random.below(150));
  return random.below(2) == 0 ? x : -x;
}

TEST(ExactDivision, OfAProductIsTheOtherFactor) {
  Random random(20261204);
  int long_ones = 0;
  for (int turn = 0; turn < 20000; ++turn) {
    const Integer a = some_integer(random, 1 + random.below(20)), b = some_integer(random, 1 + random.below(20));
    Integer x = a * b;
    long_ones += x.backend().size() >= 8;
    divide_exactly(x, b);
    ASSERT_EQ(x, a) << "by " << b;
  }
  EXPECT_GT(long_ones, 10000);
  Integer zero = 0;
  divide_exactly(zero, Integer(7));
  EXPECT_EQ(zero, 0);
}

}  // namespace
}  // namespace sunder
