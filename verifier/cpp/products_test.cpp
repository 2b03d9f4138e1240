// Against products of big integers; factors are about as long as where short ones end.
#include <tests/support/scale.h>
#include <verifier/cpp/products.h>

#include <gtest/gtest.h>

#include <array>
#include <random>
#include <vector>

namespace sunder_verifier {
namespace {

class Factors {
 public:
  // Of many lengths; often with all bits set, or the highest only, or near to that.
  Integer next() {
    constexpr std::array<unsigned, 12> lengths{0, 1, 2, 63, 64, 65, 96, 127, 128, 129, 192, 256};
    Integer n = 0;
    const unsigned length = lengths[random_() % lengths.size()];
    if (random_() % 2 == 0) {
      n = (Integer(1) << length) - random_() % 3 + random_() % 2;
    } else {
      for (unsigned k = 0; k < length; k += 32) n = n << 32 | random_();
      n >>= 32 * ((length + 31) / 32) - length;
    }
    return random_() % 2 == 0 ? n : Integer(-n);
  }

  unsigned up_to(unsigned most) { return static_cast<unsigned>(random_() % (most + 1)); }

 private:
  std::mt19937 random_{20261123};
};

TEST(Products, AreComparedExactly) {
  Factors factors;
  int equal = 0, all_short = 0;
  const int count = sunder::tests::scaled_count(200000, 20000);
  for (int k = 0; k < count; ++k) {
    Integer a = factors.next(), b = factors.next(), c = factors.next(), d = factors.next();
    if (k % 2 == 0) {  // products that are equal, or nearly so
      c = a * b;
      b *= d;
      if (factors.up_to(2) == 0) c += static_cast<int>(factors.up_to(2)) - 1;
    }
    const int expected = Integer(a * b).compare(Integer(c * d));
    const int sign = expected < 0 ? -1 : expected > 0 ? 1 : 0;
    ASSERT_EQ(compare_products(a, b, c, d), sign) << a << " * " << b << ", " << c << " * " << d;
    equal += sign == 0 ? 1 : 0;
    bool is_short = true;
    for (const Integer* n : {&a, &b, &c, &d}) is_short = is_short && bits(*n) <= 128;
    all_short += is_short ? 1 : 0;
  }
  EXPECT_GT(equal, count / 4);
  EXPECT_GT(all_short, count / 4);
  EXPECT_LT(all_short, count / 4 * 3);
}

}  // namespace
}  // namespace sunder_verifier
