// The order of multiples against integer arithmetic, and which stage decides.
#include <sunder/base/random.h>
#include <sunder/predicate/line/chord.h>
#include <sunder/predicate/multiples_test.h>

#include <tests/support/doubles.h>
#include <tests/support/scale.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace sunder {
namespace {

using tests::largest, tests::least, tests::Whole;
using MultiplePoint = std::array<Whole, 2>;

// The images of points are multiples of the square of 2^-1126.
MultiplePoint image_multiples(const Point2& p) {
  return {multiple(p.x) << multiple_bits, multiple(p.y) << multiple_bits};
}
MultiplePoint image_multiples(const Posed2& p) {
  const auto& [m, t] = *p.pose;
  const Whole x = multiple(p.point.x), y = multiple(p.point.y);
  return {multiple(m[0]) * x + multiple(m[1]) * y + (multiple(t[0]) << multiple_bits),
          multiple(m[2]) * x + multiple(m[3]) * y + (multiple(t[1]) << multiple_bits)};
}

// The oracle: (q - p) x (s - r) and (q - p) x (u - t), each times its number.
template <class P>
Sign by_integers(const std::array<P, 6>& p, std::uint32_t m, std::uint32_t n) {
  const auto reach = [&](const P& from, const P& to) -> Whole {
    const MultiplePoint a = image_multiples(p[0]), b = image_multiples(p[1]), c = image_multiples(from),
                        d = image_multiples(to);
    return (b[0] - a[0]) * (d[1] - c[1]) - (b[1] - a[1]) * (d[0] - c[0]);
  };
  const Whole left = m * reach(p[2], p[3]), right = n * reach(p[4], p[5]);
  return left > right ? Sign::positive : left < right ? Sign::negative : Sign::zero;
}

struct Chords {
  StageTally tally{};
  int zeros = 0;

  template <class P>
  void compare(const std::array<P, 6>& p, std::uint32_t m, std::uint32_t n) {
    const Sign truth = by_integers(p, m, n);
    ASSERT_EQ(chord_order(p[0], p[1], m, p[2], p[3], n, p[4], p[5], &tally), truth);
    ASSERT_EQ(chord_order(p[0], p[1], n, p[4], p[5], m, p[2], p[3]), -truth);
    ASSERT_EQ(chord_order(p[1], p[0], m, p[2], p[3], n, p[4], p[5]), -truth);
    if constexpr (std::is_same_v<P, Point2>) {
      ASSERT_EQ(chord_order_further(p[0], p[1], m, p[2], p[3], n, p[4], p[5], nullptr), truth);
    }
    zeros += truth == Sign::zero;
  }
  void expect_all_stages() const {
    std::printf("rounded %u interval %u exact %u, zero %d\n", tally.rounded, tally.interval, tally.exact, zeros);
    EXPECT_GT(tally.rounded, 100u);
    EXPECT_GT(tally.interval, 10u);
    EXPECT_GT(tally.exact, 100u);
  }
};

TEST(ChordTest, Examples) {
  const Point2 o{0, 0}, east{1, 0}, up{0, 1}, up_2{0, 2};
  EXPECT_EQ(chord_order(o, east, 2, o, up, 1, o, up_2), Sign::zero);
  EXPECT_EQ(chord_order(o, east, 3, o, up, 1, o, up_2), Sign::positive);
  EXPECT_EQ(chord_order(o, east, 2, o, up, 3, o, up_2), Sign::negative);
  EXPECT_EQ(chord_order(o, east, 0, o, up, 1, o, east), Sign::zero);
  EXPECT_EQ(chord_order(o, o, 1, o, up, 3, o, up_2), Sign::zero);
  // 2^32 - 1 times the least double against itself and one more.
  EXPECT_EQ(chord_order(o, {least, 0}, 4294967295u, o, {0, least}, 1, o, {0, 4294967295.0 * least}), Sign::zero);
  EXPECT_EQ(chord_order(o, {least, 0}, 4294967295u, o, {0, least}, 1, o, {0, 4294967296.0 * least}), Sign::negative);
  EXPECT_EQ(chord_order(o, {largest, 0}, 4294967295u, o, {0, largest}, 4294967294u, o, {0, largest}), Sign::positive);
}

// Numbers of every size.
double any(Random& random) {
  const double sign = random.below(2) == 0 ? 1 : -1;
  switch (random.below(6)) {
    case 0: return sign * least * static_cast<double>(random.below(9));
    case 1: return sign * largest;
    case 2: return sign * random.log_uniform(1e-160, 1e-100);
    case 3: return sign * random.log_uniform(1e100, 1e160);
    case 4: return sign * random.log_uniform(1e-307, 1e307);
    default: return static_cast<double>(random.between(-4, 4));
  }
}

TEST(ChordTest, AgreesWithIntegers) {
  Random random(tests::chosen_seed(20261130));
  Chords small, close, wild;
  const auto integer = [&] { return static_cast<double>(random.between(-4, 4)); };
  const auto unit = [&] { return random.uniform(-1, 1); };
  const auto points = [](const auto& number) {
    std::array<Point2, 6> p;
    for (Point2& q : p) q = {number(), number()};
    return p;
  };
  const auto times = [&] { return static_cast<std::uint32_t>(random.next() >> (32 + random.below(32))); };
  for (int i = 0; i < tests::scaled_count(20000, 1000); ++i) {
    small.compare(points(integer), static_cast<std::uint32_t>(random.below(4)),
                  static_cast<std::uint32_t>(random.below(4)));
    wild.compare(points([&] { return any(random); }), times(), times());
    // Next to a tie: rs is n / m times tu, rounded.
    auto p = points(unit);
    const std::uint32_t m = times() | 1, n = times();
    const double ratio = static_cast<double>(n) / m;
    p[3] = {p[2].x + ratio * (p[5].x - p[4].x), p[2].y + ratio * (p[5].y - p[4].y)};
    close.compare(p, m, n);
    const double scale = random.below(2) == 0 ? 0x1p900 : 0x1p-900;
    for (Point2& q : p) q = {scale * q.x, scale * q.y};
    p[2] = p[4] = {0, 0};  // a tie: powers of two
    p[5] = {4 * p[3].x, 4 * p[3].y};
    close.compare(p, 4 * (m >> 4), m >> 4);
    close.compare(p, 4 * (m >> 4) + 1, m >> 4);
  }
  if (tests::scaled_count(20000, 1000) < 20000) return;  // too few for the rates below
  EXPECT_GT(small.zeros, 1000);
  EXPECT_GT(small.tally.rounded, 1000u);
  EXPECT_GT(close.zeros, 1000);
  close.expect_all_stages();
  wild.expect_all_stages();
}

TEST(ChordTest, AgreesWithIntegersUnderPoses) {
  Random random(tests::chosen_seed(20261201));
  Chords small, wild;
  const auto integer = [&] { return static_cast<double>(random.between(-3, 3)); };
  for (int i = 0; i < tests::scaled_count(20000, 1000); ++i) {
    std::array<Affine2, 2> poses;
    for (Affine2& pose : poses) pose = {{integer(), integer(), integer(), integer()}, {integer(), integer()}};
    std::array<Posed2, 6> p{};
    for (Posed2& q : p) q = {{integer(), integer()}, &poses[random.below(2)], true};
    small.compare(p, static_cast<std::uint32_t>(random.below(4)), static_cast<std::uint32_t>(random.below(4)));
    for (Affine2& pose : poses) {
      for (double& x : pose.linear) x = any(random);
      for (double& x : pose.translation) x = any(random);
    }
    for (Posed2& q : p) {
      q.point = {any(random), any(random)};
      const SizeRange linear = size_range(std::span<const double>(q.pose->linear)),
                      translation = size_range(std::span<const double>(q.pose->translation));
      SizeRange coordinates;
      coordinates.include(q.point.x);
      coordinates.include(q.point.y);
      q.tame = images_are_tame(linear, translation, coordinates);
    }
    wild.compare(p, static_cast<std::uint32_t>(random.next() >> 32), static_cast<std::uint32_t>(random.below(9)));
  }
  if (tests::scaled_count(20000, 1000) < 20000) return;  // too few for the rates below
  EXPECT_GT(small.zeros, 1000);
  EXPECT_GT(small.tally.rounded, 1000u);
  EXPECT_GT(wild.tally.interval, 100u);
  EXPECT_GT(wild.tally.exact, 100u);
}

}  // namespace
}  // namespace sunder
