// Comparisons along directions against integer arithmetic, by the public functions and by the stages' own formula.
#include <sunder/base/random.h>
#include <sunder/predicate/exact_image_test.h>
#include <sunder/predicate/point/along.h>

#include <tests/support/exact.h>
#include <tests/support/scale.h>
#include <tests/support/shapes.h>

#include <gtest/gtest.h>

#include <array>

namespace sunder {
namespace {

using tests::in_cube, tests::on_grid;

using tests::Exact, tests::largest, tests::least;

ExactVector exact_direction(const WorldDirection& d) {
  const Vector3<Dyadic> v = d.exact();
  return {Exact(v.x), Exact(v.y), Exact(v.z)};
}
Sign further(const ExactVector& d, const ExactVector& a, const ExactVector& b) {
  return sign_of(d[0] * b[0] + d[1] * b[1] + d[2] * b[2] - (d[0] * a[0] + d[1] * a[1] + d[2] * a[2]));
}

// What the stages said over many instances.
struct AlongRecord {
  int count = 0, zero = 0, rounded = 0, interval = 0, exact = 0;

  void check(Sign answer, Sign expected, const StageTally& tally) {
    ++count;
    ASSERT_EQ(answer, expected);
    ASSERT_EQ(tally.rounded + tally.interval + tally.exact, 1u);
    if (expected == Sign::zero) ++zero;
    rounded += static_cast<int>(tally.rounded);
    interval += static_cast<int>(tally.interval);
    exact += static_cast<int>(tally.exact);
  }
};

// A body's two points, its pose and a direction: Along compares the points.
struct Question {
  Point3 direction;
  Affine3 pose;
  Point3 from, to;

  bool tame() const {
    const std::array<Point3, 2> points{from, to};
    return images_are_tame(size_range(std::span<const double>(pose.linear)),
                           size_range(std::span<const double>(pose.translation)),
                           size_range(std::span<const Point3>(points)));
  }
};

// `to` is moved so that both are equally far along, but for rounding and a log-uniform offset.
void make_near_tie(Random& random, Question& q) {
  const auto& m = q.pose.linear;
  const Point3& d = q.direction;
  const Point3 e{m[0] * d.x + m[3] * d.y + m[6] * d.z, m[1] * d.x + m[4] * d.y + m[7] * d.z,
                 m[2] * d.x + m[5] * d.y + m[8] * d.z};
  const double offset = random.below(2) ? 0 : random.log_uniform(0x1p-70, 1) * (random.below(2) ? 1 : -1);
  const double z = q.from.z - ((q.to.x - q.from.x) * e.x + (q.to.y - q.from.y) * e.y) / e.z + offset;
  if (std::isfinite(z)) q.to.z = z;
}

enum QuestionKind { generic_question, grid_question, near_tied_question, question_kinds };

Question question(Random& random, QuestionKind kind) {
  Question q{in_cube(random), {}, in_cube(random), in_cube(random)};
  for (double& m : q.pose.linear) m = random.uniform(-1, 1);
  for (double& t : q.pose.translation) t = random.uniform(-1, 1) * power_of_two(random.between(-30, 70));
  if (kind == grid_question) {
    q.direction = on_grid(random, 3);
    q.from = on_grid(random, 3);
    q.to = on_grid(random, 3);
    for (double& m : q.pose.linear) m = static_cast<double>(random.between(-2, 2));
    q.direction = {q.direction.x / 4, q.direction.y / 4, q.direction.z / 4};
  } else {
    // Sizes that differ, within the tame range and a little beyond it.
    const auto spread = [&] { return random.below(3) ? 1 : power_of_two(random.between(-64, 0)); };
    q.direction = {q.direction.x * spread(), q.direction.y * spread(), q.direction.z * spread()};
  }
  if (kind == near_tied_question) make_near_tie(random, q);
  return q;
}

TEST(AlongTest, TameDirections) {
  const auto tame = [](double x, double y, double z) { return WorldDirection(Point3{x, y, z}).is_tame(); };
  EXPECT_TRUE(tame(1, -1, 0x1p-60));
  EXPECT_TRUE(tame(0, -0.0, -0x1p-60));
  EXPECT_TRUE(tame(0, 0, 0));
  EXPECT_FALSE(tame(1, 0, std::nextafter(0x1p-60, 0)));
  EXPECT_FALSE(tame(std::nextafter(1, 2), 0, 0));
  EXPECT_FALSE(tame(0, -least, 1));
  EXPECT_FALSE(tame(0, largest, 1));
}

TEST(AlongTest, DirectionOfDoublesIsExact) {
  const WorldDirection d(Point3{1e300, -5e-324, 0});
  EXPECT_TRUE(d.is_doubles());
  EXPECT_EQ(d.doubles(), (Point3{1e300, -5e-324, 0}));
  EXPECT_EQ(exact_direction(d), image(Point3{1e300, -5e-324, 0}));
  const Vector3<Interval> e = d.enclosure();
  EXPECT_TRUE(e.x.low == 1e300 && e.x.high == 1e300 && e.y.low == -5e-324 && e.y.high == -5e-324);
  EXPECT_TRUE(e.z.low == 0 && e.z.high == 0);
}

// The enclosure encloses the exact numbers divided by one power of two, and the largest of them lies in [1, 2].
void expect_enclosed(const WorldDirection& d) {
  ASSERT_FALSE(d.is_doubles());
  const ExactVector x = exact_direction(d);
  const Vector3<Interval> v = d.enclosure();
  const std::array<Interval, 3> e{v.x, v.y, v.z};
  int top = -100000;
  for (const Exact& c : x) {
    if (c.n != 0) top = std::max(top, static_cast<int>(msb(abs(c.n))) + c.e);
  }
  double size = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const Exact scaled(x[i].n, x[i].e - top);
    ASSERT_TRUE(Exact(e[i].low) <= scaled && scaled <= Exact(e[i].high));
    ASSERT_LE(e[i].high, std::nextafter(e[i].low, 4));
    if (x[i].n == 0) {
      ASSERT_EQ(e[i].high, 0);
    }
    size = std::max(size, std::max(std::fabs(e[i].low), std::fabs(e[i].high)));
  }
  if (top > -100000) {
    ASSERT_GE(size, 1);
    ASSERT_LE(size, 2);
  }
}

TEST(AlongTest, DirectionsOfFeatures) {
  Random random(tests::chosen_seed(1));
  const int n = tests::scaled_count(4000, 1000);
  int zero = 0;
  for (int i = 0; i < n; ++i) {
    Affine3 p, q;
    const bool whole = i % 4 == 0;
    for (double& m : p.linear) m = whole ? static_cast<double>(random.between(-1, 1)) : random.uniform(-1, 1);
    for (double& t : q.translation) t = whole ? 1 : random.uniform(-1, 1) * power_of_two(random.between(-100, 100));
    const double scale = power_of_two(random.between(-900, 900));
    std::array<Point3, 4> x;
    for (Point3& y : x) {
      y = whole ? on_grid(random, 1) : in_cube(random);
      y = {y.x * scale, y.y * scale, y.z * scale};
    }
    const Posed3 a = posed(x[0], p), b = posed(x[1], p), c = posed(x[2], q), d = posed(x[3], q);
    const ExactVector ia = image(a), ib = image(b), ic = image(c), id = image(d);
    const WorldDirection normal = cross_direction(a, b, c, d), difference = difference_direction(a, c);
    ExactVector u = ia, v = ic;
    for (std::size_t j = 0; j < 3; ++j) {
      u[j] = ib[j] - ia[j];
      v[j] = id[j] - ic[j];
      ASSERT_EQ(exact_direction(difference)[j], ic[j] - ia[j]) << i;
    }
    for (std::size_t j = 0; j < 3; ++j) {
      const std::size_t k = (j + 1) % 3, l = (j + 2) % 3;
      ASSERT_EQ(exact_direction(normal)[j], u[k] * v[l] - u[l] * v[k]) << i;
    }
    if (exact_direction(normal)[0].n == 0 && exact_direction(normal)[1].n == 0 && exact_direction(normal)[2].n == 0)
      ++zero;
    expect_enclosed(normal);
    expect_enclosed(difference);
    if (HasFatalFailure()) FAIL() << "instance " << i;
  }
  EXPECT_GT(zero, n / 200);
}

TEST(AlongTest, ComparesPointsOfOneBody) {
  Random random(tests::chosen_seed(2));
  const int n = tests::scaled_count(60000, 1000);
  std::array<AlongRecord, question_kinds> plain, scaled;
  int tame = 0;
  for (int i = 0; i < n; ++i) {
    const QuestionKind kind = static_cast<QuestionKind>(i % question_kinds);
    Question q = question(random, kind);
    const bool is_plain = i / question_kinds % 2 == 0;
    if (!is_plain) {  // the inverse scale in the pose, so that only the way to the result underflows or overflows
      const int e = static_cast<int>(random.between(-970, 970));
      for (Point3* p : {&q.from, &q.to}) *p = {std::ldexp(p->x, e), std::ldexp(p->y, e), std::ldexp(p->z, e)};
      const int f = static_cast<int>(random.between(-30, 30)) - e;
      for (double& m : q.pose.linear) m = std::ldexp(m, f);
    }
    if (q.tame()) ++tame;
    const WorldDirection direction(q.direction);
    Along along(direction, q.pose, q.tame());
    AlongRecord& record = (is_plain ? plain : scaled)[kind];
    const Posed3 from = posed(q.from, q.pose), to = posed(q.to, q.pose);
    const Sign expected = further(image(q.direction), image(from), image(to));
    StageTally tally, there, back, other, slow;
    record.check(along.compare(q.from, q.to, &tally), expected, tally);
    ASSERT_EQ(along.compare(q.to, q.from, &back), -expected);
    ASSERT_EQ(along.compare(q.from, q.to, &there), expected);  // now from what it keeps
    ASSERT_EQ(there.exact, tally.exact);
    ASSERT_EQ(compare_along(direction, from, to, &other), expected);
    ASSERT_EQ(other.rounded + other.interval + other.exact, 1u);
    const WorldDirection by_numbers(direction.exact());  // the same, but not known to be doubles
    ASSERT_FALSE(by_numbers.is_doubles());
    Along along_numbers(by_numbers, q.pose, q.tame());
    ASSERT_EQ(along_numbers.compare(q.from, q.to, &slow), expected);
    ASSERT_EQ(slow.rounded, 0u);
    if (HasFatalFailure()) FAIL() << "instance " << i << ", kind " << kind;
  }
  EXPECT_GT(tame, n / 2);
  EXPECT_GE(plain[generic_question].rounded, plain[generic_question].count * 4 / 5);  // directions are not all tame
  EXPECT_EQ(plain[generic_question].exact, 0);
  EXPECT_GT(plain[grid_question].zero, plain[grid_question].count / 200);
  EXPECT_GE(plain[grid_question].exact, plain[grid_question].count / 400);
  EXPECT_GT(plain[near_tied_question].exact, plain[near_tied_question].count / 4);
  EXPECT_GT(plain[near_tied_question].interval, 0);
  EXPECT_GT(scaled[generic_question].rounded, scaled[generic_question].count / 2);
  EXPECT_GT(scaled[near_tied_question].exact, scaled[near_tied_question].count / 4);
}

// Matrix times direction underflows although images are of ordinary size.
TEST(AlongTest, TinyMatrixOfHugeBody) {
  Random random(tests::chosen_seed(3));
  const int n = tests::scaled_count(20000, 1000);
  int sure = 0;
  for (int i = 0; i < n; ++i) {
    Question q = question(random, near_tied_question);
    for (double* d : {&q.direction.x, &q.direction.y, &q.direction.z}) {
      *d = std::copysign(power_of_two(random.between(-59, -50)) * random.uniform(0.5, 1), *d);
    }
    make_near_tie(random, q);
    const int e = static_cast<int>(random.between(850, 1020));
    q.pose.translation = {};
    for (double& m : q.pose.linear) m = std::ldexp(m, -e);
    for (Point3* p : {&q.from, &q.to}) *p = {std::ldexp(p->x, e), std::ldexp(p->y, e), std::ldexp(p->z, e)};
    if (!std::isfinite(q.to.z)) continue;
    const WorldDirection direction(q.direction);
    ASSERT_TRUE(direction.is_tame());
    Along along(direction, q.pose, q.tame());
    StageTally tally;
    const Posed3 from = posed(q.from, q.pose), to = posed(q.to, q.pose);
    const Sign expected = further(image(q.direction), image(from), image(to));
    ASSERT_EQ(along.compare(q.from, q.to, &tally), expected) << i << " " << e;
    ASSERT_EQ(compare_along(direction, from, to), expected) << i << " " << e;
    if (tally.exact == 0) ++sure;
  }
  EXPECT_GT(sure, n / 10);
}

// Numbers of ten bits, so that scaling by powers of two is exact down to the subnormal numbers.
TEST(AlongTest, DirectionsOfAnySize) {
  Random random(tests::chosen_seed(6));
  const int n = tests::scaled_count(20000, 1000);
  int zero = 0, sure = 0;
  const auto any = [&] { return static_cast<double>(random.between(-512, 512)) / 512; };
  for (int i = 0; i < n; ++i) {
    Question q{{any(), any(), any()}, {}, {any(), any(), any()}, {any(), any(), any()}};
    for (double& m : q.pose.linear) m = static_cast<double>(random.between(-2, 2));
    if (i % 2 == 0) {  // a tie: along (to - from) x (the image of something)
      const Point3 a{q.to.x - q.from.x, q.to.y - q.from.y, q.to.z - q.from.z};
      q.pose.linear = {1, 0, 0, 0, 1, 0, 0, 0, 1};
      q.direction = {a.y / 2, -a.x / 2, 0};
    }
    const double size = power_of_two(-random.between(0, 60));
    for (Point3* p : {&q.from, &q.to}) *p = {size * p->x, size * p->y, size * p->z};
    const int e = static_cast<int>(random.below(2) ? random.between(-1060, 1000) : random.between(-1060, -1000));
    q.direction = {std::ldexp(q.direction.x, e), std::ldexp(q.direction.y, e), std::ldexp(q.direction.z, e)};
    const WorldDirection direction(q.direction);
    const Posed3 from = posed(q.from, q.pose), to = posed(q.to, q.pose);
    ASSERT_TRUE(from.tame && to.tame);
    Along along(direction, q.pose, true);
    StageTally tally;
    const Sign expected = further(image(q.direction), image(from), image(to));
    ASSERT_EQ(along.compare(q.from, q.to, &tally), expected) << i << " " << e;
    ASSERT_EQ(compare_along(direction, from, to), expected) << i << " " << e;
    if (expected == Sign::zero) ++zero;
    if (tally.exact == 0) ++sure;
  }
  EXPECT_GT(zero, n / 4);
  EXPECT_LT(zero, n * 3 / 4);
  EXPECT_GT(sure, n / 10);
}

// One body is tame, the image of the other is not zero but would be in floating point.
TEST(AlongTest, OneBodyUnderflows) {
  const Affine3 identity, tiny{{1e-200, 0, 0, 0, 1e-200, 0, 0, 0, 1e-200}, {}};
  const Posed3 a = posed({0, 0, 0}, identity), b = posed({1e-200, 0, 0}, tiny);
  ASSERT_TRUE(a.tame);
  ASSERT_FALSE(b.tame);
  const WorldDirection direction(Point3{1, 0, 0});
  EXPECT_EQ(compare_along(direction, a, b), Sign::positive);
  EXPECT_EQ(compare_along(direction, b, a), Sign::negative);
}

// Many points at once against one: never sure of what is not so, and sure of most that is.
TEST(AlongTest, ManyPointsAtOnce) {
  Random random(tests::chosen_seed(5));
  const int n = tests::scaled_count(20000, 1000);
  int all_less = 0, sure = 0, near = 0;
  for (int i = 0; i < n; ++i) {
    const bool is_near = i % 2 == 1;
    Question q = question(random, generic_question);
    q.direction = {q.direction.x + 1, q.direction.y / 2, q.direction.z / 2};
    const int e = i % 3 == 0 ? static_cast<int>(random.between(-900, 900)) : 0;
    for (double& m : q.pose.linear) m = std::ldexp(m, -e);
    const std::size_t count = is_near ? 1 : 3;
    std::array<double, 4> x{}, y{}, z{};
    double reach = 0;
    const Point3 at{std::ldexp(q.from.x, e), std::ldexp(q.from.y, e), std::ldexp(q.from.z, e)};
    for (std::size_t j = 0; j < count; ++j) {
      q.to = in_cube(random);
      if (is_near) make_near_tie(random, q);
      x[j] = std::ldexp(q.to.x, e);
      y[j] = std::ldexp(q.to.y, e);
      z[j] = std::ldexp(q.to.z, e);
      for (const double c : {x[j], y[j], z[j], at.x, at.y, at.z}) reach = std::max(reach, std::fabs(c));
    }
    if (!std::isfinite(reach)) continue;
    // To an even count, with the first point once more; in any order.
    const std::size_t even = count + 1;
    x[count] = x[0], y[count] = y[0], z[count] = z[0];
    const std::size_t other = random.below(even);
    std::swap(x[0], x[other]), std::swap(y[0], y[other]), std::swap(z[0], z[other]);
    const WorldDirection direction(q.direction);
    q.direction = {-q.direction.x, -q.direction.y, -q.direction.z};
    const WorldDirection opposite(q.direction);
    bool tame = true, less = true;
    for (std::size_t j = 0; j < count; ++j) {
      const Posed3 p = posed({x[j], y[j], z[j]}, q.pose), r = posed(at, q.pose);
      tame = tame && p.tame && r.tame;
      less = less && further(exact_direction(direction), image(r), image(p)) == Sign::negative;
    }
    const Along along(direction, q.pose, tame), along_opposite(opposite, q.pose, tame);
    const bool answer = along.surely_less_far(x.data(), y.data(), z.data(), even, at, reach);
    ASSERT_TRUE(!answer || less) << i << " " << e;
    ASSERT_EQ(along_opposite.surely_further(x.data(), y.data(), z.data(), even, at, reach), answer) << i;
    if (!tame || !direction.is_tame()) {
      ASSERT_FALSE(answer) << i;
    } else if (less) {
      ++(is_near ? near : all_less);
      if (answer && !is_near) ++sure;
    }
    ASSERT_FALSE(answer && along.surely_further(x.data(), y.data(), z.data(), even, at, reach));
  }
  EXPECT_GT(all_less, n / 40);
  EXPECT_GE(sure, all_less * 98 / 100);
  EXPECT_GT(near, n / 100);
}

Point3 rough_image(const Point3& p, const Affine3& pose) {
  const auto& [m, t] = pose;
  return {m[0] * p.x + m[1] * p.y + m[2] * p.z + t[0], m[3] * p.x + m[4] * p.y + m[5] * p.z + t[1],
          m[6] * p.x + m[7] * p.y + m[8] * p.z + t[2]};
}

TEST(AlongTest, ComparesPointsOfTwoBodies) {
  Random random(tests::chosen_seed(4));
  const int n = tests::scaled_count(30000, 1000);
  std::array<AlongRecord, question_kinds> records;
  int untame = 0;
  for (int i = 0; i < n; ++i) {
    const QuestionKind kind = static_cast<QuestionKind>(i % question_kinds);
    const Question q = question(random, kind), r = question(random, kind);
    Affine3 first = q.pose, second = r.pose;
    if (kind == grid_question) {
      first.translation = {1, 2, -1};
      second.translation = {-1, 0, 3};
    }
    if (kind == near_tied_question) {
      // The second translation takes one point to the other, but for rounding and an offset.
      const Point3 s = rough_image(q.from, first), t = rough_image(r.from, second);
      const double size = std::max(std::fabs(s.x), std::max(std::fabs(s.y), std::fabs(s.z)));
      second.translation[0] += s.x - t.x;
      second.translation[1] += s.y - t.y;
      second.translation[2] += s.z - t.z + random.log_uniform(0x1p-60, 1) * size;
    }
    const int e = i % 5 == 0 ? static_cast<int>(random.between(-400, 400)) : 0;
    for (Affine3* pose : {&first, &second}) {
      for (double& m : pose->linear) m = std::ldexp(m, e);
      for (double& t : pose->translation) t = std::ldexp(t, e);
    }
    const Posed3 a = posed(q.from, first), b = posed(r.from, second);
    if (!a.tame || !b.tame) ++untame;
    const WorldDirection direction(q.direction);
    StageTally tally;
    const Sign expected = further(image(q.direction), image(a), image(b));
    records[kind].check(compare_along(direction, a, b, &tally), expected, tally);
    ASSERT_EQ(compare_along(direction, b, a), -expected);
    ASSERT_EQ(compare_along(WorldDirection(direction.exact()), a, b), expected);
    if (HasFatalFailure()) FAIL() << "instance " << i << ", kind " << kind;
  }
  EXPECT_GT(untame, n / 20);
  EXPECT_GT(records[generic_question].rounded, records[generic_question].count / 2);
  EXPECT_GE(records[grid_question].zero, records[grid_question].count / 300);
  EXPECT_GT(records[near_tied_question].exact, records[near_tied_question].count / 100);
}

TEST(AlongTest, ExtremeNumbers) {
  const Affine3 identity, tiny{{least, 0, 0, 0, least, 0, 0, 0, least}, {}},
      huge{{1e300, 0, 0, 0, 1e300, 0, 0, 0, 1e300}, {}};
  for (const double s : {least, 1e-300, 1e300, largest}) {
    for (const Affine3* pose : {&identity, &tiny, &huge}) {
      for (const double d : {least, 1.0, largest}) {
        const WorldDirection direction(Point3{d, -d, 0});
        const Point3 a{s, s, 5}, b{s, 0, -5}, c{0, -s, largest};
        for (const bool tame : {false, posed(a, *pose).tame && posed(b, *pose).tame && posed(c, *pose).tame}) {
          Along along(direction, *pose, tame);
          EXPECT_EQ(along.compare(a, b), Sign::positive);
          EXPECT_EQ(along.compare(b, a), Sign::negative);
          EXPECT_EQ(along.compare(b, c), Sign::zero);
          EXPECT_EQ(along.compare(a, a), Sign::zero);
        }
        EXPECT_EQ(compare_along(direction, posed(a, *pose), posed(b, *pose)), Sign::positive);
        EXPECT_EQ(compare_along(direction, posed(c, *pose), posed(a, *pose)), Sign::negative);
        EXPECT_EQ(compare_along(direction, posed(c, *pose), posed(b, *pose)), Sign::zero);
      }
    }
  }
  // The direction zero: nothing is further.
  StageTally tally;
  EXPECT_EQ(
      compare_along(WorldDirection(Point3{}), posed(Point3{1, 2, 3}, identity), posed(Point3{}, identity), &tally),
      Sign::zero);
  EXPECT_EQ(tally.rounded, 1u);
}

}  // namespace
}  // namespace sunder
