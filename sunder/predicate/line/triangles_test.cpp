// Sides of triangles against 128-bit integers: every bit that is called sure, and what the masks say of them.
#include <sunder/base/random.h>
#include <sunder/predicate/line/triangles.h>

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace sunder {
namespace {

__extension__ using Wide = __int128;

struct WidePoint {
  Wide x, y;
};
WidePoint wide_image(const Point2& p) { return {static_cast<std::int64_t>(p.x), static_cast<std::int64_t>(p.y)}; }
WidePoint wide_image(const Posed2& p) {
  const auto whole = [](double x) { return Wide{static_cast<std::int64_t>(x)}; };
  const auto& [m, t] = *p.pose;
  const auto [x, y] = wide_image(p.point);
  return {whole(m[0]) * x + whole(m[1]) * y + whole(t[0]), whole(m[2]) * x + whole(m[3]) * y + whole(t[1])};
}

template <class V>
int triangle_side(const V& p, const V& q, const V& r) {
  const WidePoint a = wide_image(p), b = wide_image(q), c = wide_image(r);
  const Wide value = (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
  return value > 0 ? 1 : value < 0 ? -1 : 0;
}

template <class V>
using Triangle = std::array<V, 3>;

struct Seen {
  int sure = 0, inside_first = 0, inside_second = 0, crossing = 0, apart = 0;
};

// Each mask by its definition; the signs of both triangles' edges by integers.
template <class V>
void expect_true_masks(const Triangle<V>& a, const Triangle<V>& b, Seen& seen) {
  const TriangleSides sides = sides_of_triangles(a, b);
  if (!sides.sure) return;
  ++seen.sure;
  std::array<std::array<int, 3>, 3> of_a{}, of_b{};  // [e][f]: vertex f of b beside edge e of a; [f][e]
  for (std::uint32_t e = 0; e < 3; ++e) {
    for (std::uint32_t f = 0; f < 3; ++f) {
      of_a[e][f] = triangle_side(a[e], a[(e + 1) % 3], b[f]);
      of_b[f][e] = triangle_side(b[f], b[(f + 1) % 3], a[e]);
      ASSERT_NE(of_a[e][f], 0);
      ASSERT_NE(of_b[f][e], 0);
      ASSERT_EQ(sides.left_of_first >> (3 * e + f) & 1, of_a[e][f] > 0);
      ASSERT_EQ(sides.left_of_second >> (3 * e + f) & 1, of_b[f][e] > 0);
    }
  }
  for (std::uint32_t k = 0; k < 3; ++k) {
    const bool in_a = of_a[0][k] > 0 && of_a[1][k] > 0 && of_a[2][k] > 0;
    const bool in_b = of_b[0][k] > 0 && of_b[1][k] > 0 && of_b[2][k] > 0;
    ASSERT_EQ(sides.inside_first() >> k & 1, in_a);
    ASSERT_EQ(sides.inside_second() >> (3 * k) & 1, in_b);
    seen.inside_first += in_a;
    seen.inside_second += in_b;
    for (std::uint32_t f = 0; f < 3; ++f) {
      const bool cross = of_a[k][f] != of_a[k][(f + 1) % 3] && of_b[f][k] != of_b[f][(k + 1) % 3];
      ASSERT_EQ(sides.crossings() >> (3 * k + f) & 1, cross);
      seen.crossing += cross;
    }
  }
  ASSERT_EQ(sides.inside_first() >> 3, 0u);
  ASSERT_EQ(sides.inside_second() & ~0111u, 0u);
  ASSERT_EQ(sides.crossings() >> 9, 0u);
  seen.apart += sides.inside_first() == 0 && sides.inside_second() == 0 && sides.crossings() == 0;
}

void expect_all_seen(const Seen& seen, int sure) {
  EXPECT_GT(seen.sure, sure);
  EXPECT_GT(seen.inside_first, 200);
  EXPECT_GT(seen.inside_second, 200);
  EXPECT_GT(seen.crossing, 1000);
  EXPECT_GT(seen.apart, 200);
}

// Coordinates that are small, that fill all 53 bits, and that differ in their last bits only.
TEST(TrianglesTest, PlainPoints) {
  Random random(51);
  Seen seen;
  for (int i = 0; i < 12000; ++i) {
    const auto number = [&]() -> double {
      const double small = static_cast<double>(random.between(-5, 5));
      switch (i % 3) {
        case 0: return small;
        case 1: return std::floor(random.uniform(-0x1p53, 0x1p53));
        default: return random.below(2) == 0 ? 0x1p52 + small : -0x1p52 + small;
      }
    };
    Triangle<Point2> a, b;
    for (Point2& p : a) p = {number(), number()};
    for (Point2& p : b) p = {number(), number()};
    ASSERT_NO_FATAL_FAILURE(expect_true_masks(a, b, seen)) << i;
  }
  expect_all_seen(seen, 5000);
}

// Images that doubles do not hold: their rounded values would tell some sides wrongly.
TEST(TrianglesTest, PosedPoints) {
  Random random(53);
  Seen seen;
  int wrong_if_trusted = 0;
  for (int i = 0; i < 12000; ++i) {
    const double shift = i % 2 == 0 ? 0x1p55 : 0x1p20;
    std::array<Affine2, 2> poses;
    for (Affine2& pose : poses) {
      for (double& x : pose.linear) x = std::floor(random.uniform(-0x1p8, 0x1p8));
    }
    for (std::size_t k = 0; k < 2; ++k) {
      poses[0].translation[k] = std::floor(random.uniform(-1, 1) * shift);
      poses[1].translation[k] = poses[0].translation[k] + static_cast<double>(random.between(-1, 1)) * 8;
    }
    std::array<Triangle<Posed2>, 2> t{};
    for (std::size_t k = 0; k < 2; ++k) {
      const double error = image_error(size_range(poses[k].linear), size_range(poses[k].translation), 8);
      for (Posed2& p : t[k]) {
        const auto number = [&] { return static_cast<double>(random.between(-8, 8)); };
        p = {{number(), number()}, &poses[k], true, error};
      }
    }
    ASSERT_NO_FATAL_FAILURE(expect_true_masks(t[0], t[1], seen)) << i;
    Triangle<Point2> a, b;
    for (std::size_t k = 0; k < 3; ++k) a[k] = t[0][k].rounded_image(), b[k] = t[1][k].rounded_image();
    const TriangleSides trusted = sides_of_triangles(a, b);
    for (std::uint32_t e = 0; e < 3; ++e) {
      for (std::uint32_t f = 0; f < 3 && trusted.sure; ++f) {
        const int truly = triangle_side(t[0][e], t[0][(e + 1) % 3], t[1][f]);
        wrong_if_trusted += (trusted.left_of_first >> (3 * e + f) & 1) != (truly > 0);
      }
    }
  }
  expect_all_seen(seen, 3000);
  EXPECT_GT(wrong_if_trusted, 5);
}

// What is no number, and what overflows, is not sure.
TEST(TrianglesTest, NothingSureBeyondDoubles) {
  const double inf = std::numeric_limits<double>::infinity(), most = std::numeric_limits<double>::max();
  const Triangle<Point2> plain{{{0, 0}, {1, 0}, {0, 1}}};
  for (const double x : {inf, -inf, std::nan("")}) {
    EXPECT_FALSE(sides_of_triangles(plain, Triangle<Point2>{{{x, 0}, {1, 3}, {2, 2}}}).sure);
  }
  const Triangle<Point2> large{{{-most, -most}, {most, -most}, {0, most}}};
  EXPECT_FALSE(sides_of_triangles(plain, large).sure);
  EXPECT_TRUE(sides_of_triangles(plain, Triangle<Point2>{{{0.25, 0.5}, {1, 3}, {2, 2}}}).sure);
  const Affine2 identity;
  const auto at = [&](double x, double y) { return Posed2{{x, y}, &identity, true}; };  // the error is not known
  const Triangle<Posed2> unknown{{at(0, 0), at(1, 0), at(0, 1)}};
  EXPECT_FALSE(sides_of_triangles(unknown, Triangle<Posed2>{{at(0.25, 0.5), at(1, 3), at(2, 2)}}).sure);
}

}  // namespace
}  // namespace sunder
