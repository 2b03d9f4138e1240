#include <sunder/base/error.h>
#include <sunder/base/random.h>
#include <sunder/solid/object/pose.h>

#include <tests/support/doubles.h>
#include <tests/support/scale.h>

#include <gtest/gtest.h>
#include <boost/multiprecision/cpp_int.hpp>

#include <string>

namespace sunder::solid {
namespace {

using tests::infinity, tests::largest, tests::least;

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

using Rows = std::array<double, 9>;
constexpr Rows identity{1, 0, 0, 0, 1, 0, 0, 0, 1};
constexpr std::array<double, 3> nowhere{0, 0, 0};

// In plain floating point.
Point3 image(const Affine3& pose, const Point3& p) {
  const auto& [m, t] = pose;
  return {m[0] * p.x + m[1] * p.y + m[2] * p.z + t[0], m[3] * p.x + m[4] * p.y + m[5] * p.z + t[1],
          m[6] * p.x + m[7] * p.y + m[8] * p.z + t[2]};
}

double determinant(const Rows& m) {
  return m[0] * (m[4] * m[8] - m[5] * m[7]) - m[1] * (m[3] * m[8] - m[5] * m[6]) + m[2] * (m[3] * m[7] - m[4] * m[6]);
}

void expect_near(const Rows& a, const Rows& b, double tolerance) {
  for (std::size_t i = 0; i < 9; ++i) EXPECT_NEAR(a[i], b[i], tolerance) << "entry " << i;
}

// `make` throws Error bad_pose, with the place "pose" and `word` in its text.
template <class Make>
void expect_refused(const Make& make, const std::string& word) {
  try {
    make();
    ADD_FAILURE() << "accepted: " << word;
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::bad_pose);
    EXPECT_EQ(error.place(), "pose");
    EXPECT_NE(std::string(error.what()).find(word), std::string::npos) << error.what();
    EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos);
  }
}

TEST(PoseTest, IdentityByDefault) {
  const Pose pose;
  EXPECT_EQ(pose.affine(), (Affine3{identity, nowhere}));
  EXPECT_EQ(pose.linear_range().least, 1);
  EXPECT_EQ(pose.linear_range().greatest, 1);
  EXPECT_EQ(pose.translation_range().least, infinity);
  EXPECT_EQ(pose.translation_range().greatest, 0);
}

TEST(PoseTest, MatrixIsKeptAsItIs) {
  const Rows linear{0, -2, 0, 3, 0, 0, 0, 0.5, 7};
  const Pose pose = Pose::from_matrix(linear, {-4, 0, 1e300});
  EXPECT_EQ(pose.affine(), (Affine3{linear, {-4, 0, 1e300}}));
  EXPECT_EQ(pose.linear_range().least, 0.5);
  EXPECT_EQ(pose.linear_range().greatest, 7);
  EXPECT_EQ(pose.translation_range().least, 4);
  EXPECT_EQ(pose.translation_range().greatest, 1e300);
  EXPECT_NO_THROW(Pose::from_matrix({-1, 0, 0, 0, 1, 0, 0, 0, 1}, nowhere));  // a reflection
}

TEST(PoseTest, Matrix4IsRowByRow) {
  const Pose pose = Pose::from_matrix4({1, 2, 3, 10, 4, 5, 6, 11, 7, 8, 10, 12, 0, 0, 0, 1});
  EXPECT_EQ(pose.affine(), (Affine3{{1, 2, 3, 4, 5, 6, 7, 8, 10}, {10, 11, 12}}));
  const Point3 p = image(pose.affine(), {1, 0, 0});
  EXPECT_EQ(p, (Point3{11, 15, 19}));
}

TEST(PoseTest, Matrix4NeedsItsLastRow) {
  const std::array<double, 16> good{1, 0, 0, 5, 0, 1, 0, 6, 0, 0, 1, 7, 0, 0, 0, 1};
  EXPECT_NO_THROW(Pose::from_matrix4(good));
  for (std::size_t i = 12; i < 16; ++i) {
    for (const double x : {2.0, -1e-300, not_a_number, infinity}) {
      std::array<double, 16> bad = good;
      bad[i] = x;
      expect_refused([&] { Pose::from_matrix4(bad); }, "last row");
    }
  }
  // Columns instead of rows.
  expect_refused([] { Pose::from_matrix4({1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 5, 6, 7, 1}); }, "rows");
  std::array<double, 16> singular = good;
  singular[0] = 0;
  expect_refused([&] { Pose::from_matrix4(singular); }, "singular");
}

TEST(PoseTest, NumbersMustBeFinite) {
  for (const double x : {infinity, -infinity, not_a_number}) {
    for (std::size_t i = 0; i < 9; ++i) {
      Rows linear = identity;
      linear[i] = x;
      expect_refused([&] { Pose::from_matrix(linear, nowhere); }, "not finite");
    }
    for (std::size_t i = 0; i < 3; ++i) {
      std::array<double, 3> translation = nowhere;
      translation[i] = x;
      expect_refused([&] { Pose::from_matrix(identity, translation); }, "not finite");
      expect_refused([&] { Pose::from_quaternion(1, 0, 0, 0, translation); }, "not finite");
    }
    expect_refused([&] { Pose::from_quaternion(x, 0, 0, 0, nowhere); }, "not finite");
    expect_refused([&] { Pose::from_quaternion(1, 0, 0, x, nowhere); }, "not finite");
  }
}

TEST(PoseTest, SingularIsDecidedExactly) {
  const auto singular = [](const Rows& m) { expect_refused([&] { Pose::from_matrix(m, nowhere); }, "singular"); };
  const auto regular = [](const Rows& m) { EXPECT_NO_THROW(Pose::from_matrix(m, nowhere)); };
  singular({0, 0, 0, 0, 0, 0, 0, 0, 0});
  singular({1, 2, 3, 4, 5, 6, 7, 8, 9});
  regular({1, 2, 3, 4, 5, 6, 7, 8, 9 + 0x1p-49});
  singular({0.1, 0.2, 0.3, 0.1, 0.2, 0.3, 5, 6, 7});
  regular({1 + 0x1p-52, 1, 0, 1, 1 - 0x1p-53, 0, 0, 0, 1});
  // A determinant that doubles cannot hold: 2^-3222, 10^900, and products that cancel.
  regular({least, 0, 0, 0, least, 0, 0, 0, least});
  regular({1e300, 0, 0, 0, 1e300, 0, 0, 0, 1e300});
  singular({1e300, 1e300, 0, 1e300, 1e300, 0, 0, 0, 1});
  regular({largest, largest, 0, largest, std::nextafter(largest, 0), 0, 0, 0, least});
  singular({1e300, 1e-300, 1, 1e300, 1e-300, 1, 0, 0, 1});
}

TEST(PoseTest, SingularAgainstIntegers) {
  using Whole = boost::multiprecision::cpp_int;
  Random random(tests::chosen_seed(1));
  const int n = tests::scaled_count(4000, 1000);
  int refused = 0;
  for (int i = 0; i < n; ++i) {
    // Up to 2^50, the last row nearly or exactly a combination of the others.
    const std::int64_t size = std::int64_t{1} << random.between(0, 46);
    std::array<std::int64_t, 9> m{};
    for (std::size_t j = 0; j < 6; ++j) m[j] = random.between(-size, size);
    const std::int64_t s = random.between(-3, 3), t = random.between(-3, 3);
    for (std::size_t j = 0; j < 3; ++j) m[6 + j] = s * m[j] + t * m[3 + j];
    m[6] += random.between(-1, 1);
    const auto w = [&](std::size_t j) { return Whole(m[j]); };
    const Whole det =
        w(0) * (w(4) * w(8) - w(5) * w(7)) - w(1) * (w(3) * w(8) - w(5) * w(6)) + w(2) * (w(3) * w(7) - w(4) * w(6));
    Rows linear{};
    const int scale = static_cast<int>(random.between(-1074, 970));
    for (std::size_t j = 0; j < 9; ++j) linear[j] = std::ldexp(static_cast<double>(m[j]), scale);
    bool accepted = true;
    try {
      Pose::from_matrix(linear, nowhere);
    } catch (const Error&) {
      accepted = false;
      ++refused;
    }
    ASSERT_EQ(accepted, det != 0) << i;
  }
  EXPECT_GT(refused, n / 5);
  EXPECT_LT(refused, n * 4 / 5);
}

TEST(PoseTest, KnownRotations) {
  const auto linear = [](double w, double x, double y, double z) {
    return Pose::from_quaternion(w, x, y, z, nowhere).affine().linear;
  };
  const Rows about_z{0, -1, 0, 1, 0, 0, 0, 0, 1}, about_x{1, 0, 0, 0, 0, -1, 0, 1, 0},
      about_y{0, 0, 1, 0, 1, 0, -1, 0, 0};
  // Quarter turns, from quaternions of any length: exact.
  EXPECT_EQ(linear(1, 0, 0, 0), identity);
  EXPECT_EQ(linear(-3, 0, 0, 0), identity);
  EXPECT_EQ(linear(1, 0, 0, 1), about_z);
  EXPECT_EQ(linear(-1, 0, 0, -1), about_z);
  EXPECT_EQ(linear(1, 1, 0, 0), about_x);
  EXPECT_EQ(linear(1, 0, 1, 0), about_y);
  EXPECT_EQ(linear(0, 0, 0, 1), (Rows{-1, 0, 0, 0, -1, 0, 0, 0, 1}));
  EXPECT_EQ(linear(0, 1, 0, 0), (Rows{1, 0, 0, 0, -1, 0, 0, 0, -1}));
  EXPECT_EQ(linear(1, 1, 1, 1), (Rows{0, 0, 1, 1, 0, 0, 0, 1, 0}));  // a third of a turn about (1, 1, 1)
  for (const double s : {least, 1e-300, 3e-160, 1e160, 1e300, largest}) {
    EXPECT_EQ(linear(s, 0, 0, s), about_z) << s;
    EXPECT_EQ(linear(0, -s, 0, 0), (Rows{1, 0, 0, 0, -1, 0, 0, 0, -1})) << s;
  }
  const double h = std::sqrt(0.5);
  EXPECT_EQ(linear(h, 0, 0, h), about_z);
  EXPECT_EQ(linear(0.1, 0.1, 0, 0), about_x);
  EXPECT_EQ(linear(0.7, 0, 0.7, 0), about_y);
  const double angle = 0.3;
  expect_near(linear(std::cos(angle / 2), 0, 0, std::sin(angle / 2)),
              {std::cos(angle), -std::sin(angle), 0, std::sin(angle), std::cos(angle), 0, 0, 0, 1}, 1e-15);
  expect_near(linear(1, 0, 1e-300, 0), identity, 1e-290);
  EXPECT_EQ(linear(1, 0, 1e-300, 0)[2], 2e-300);
  const Pose moved = Pose::from_quaternion(1, 0, 0, 1, {7, -8, 1e300});
  EXPECT_EQ(moved.affine().translation, (std::array<double, 3>{7, -8, 1e300}));
  expect_refused([] { Pose::from_quaternion(0, -0.0, 0, 0, nowhere); }, "length zero");
}

TEST(PoseTest, RandomRotations) {
  Random random(tests::chosen_seed(2));
  const int n = tests::scaled_count(4000, 1000);
  for (int i = 0; i < n; ++i) {
    const double w = random.uniform(-1, 1), x = random.uniform(-1, 1), y = random.uniform(-1, 1),
                 z = random.uniform(-1, 1);
    const Rows m = Pose::from_quaternion(w, x, y, z, nowhere).affine().linear;
    ASSERT_NEAR(determinant(m), 1, 1e-14) << i;
    for (std::size_t r = 0; r < 3; ++r) {
      for (std::size_t s = 0; s < 3; ++s) {
        ASSERT_NEAR(m[3 * r] * m[3 * s] + m[3 * r + 1] * m[3 * s + 1] + m[3 * r + 2] * m[3 * s + 2], r == s ? 1 : 0,
                    1e-14);
      }
    }
    // The axis stays, and the angle's cosine is that of the quaternion.
    const double length = std::sqrt(w * w + x * x + y * y + z * z);
    const Point3 axis = image({m, nowhere}, {x / length, y / length, z / length});
    ASSERT_NEAR(axis.x, x / length, 1e-14);
    ASSERT_NEAR(axis.y, y / length, 1e-14);
    ASSERT_NEAR(axis.z, z / length, 1e-14);
    ASSERT_NEAR(m[0] + m[4] + m[8], 4 * (w / length) * (w / length) - 1, 1e-14);
    // A power of two changes nothing.
    const int e = static_cast<int>(random.between(-950, 1020));
    ASSERT_EQ(Pose::from_quaternion(std::ldexp(w, e), std::ldexp(x, e), std::ldexp(y, e), std::ldexp(z, e), nowhere)
                  .affine()
                  .linear,
              m)
        << i << " " << e;
    ASSERT_EQ(Pose::from_quaternion(-w, -x, -y, -z, nowhere).affine().linear, m);
  }
}

TEST(PoseTest, ComposeAppliesTheInnerFirst) {
  const Pose turn = Pose::from_quaternion(1, 0, 0, 1, {1, 2, 3});  // (x, y, z) -> (1 - y, 2 + x, 3 + z)
  const Pose stretch = Pose::from_matrix({2, 0, 0, 0, 3, 0, 0, 0, -1}, {10, 20, 30});
  const Point3 p{5, 6, 7};
  EXPECT_EQ(image(compose(turn, stretch).affine(), p), image(turn.affine(), image(stretch.affine(), p)));
  EXPECT_EQ(image(compose(stretch, turn).affine(), p), image(stretch.affine(), image(turn.affine(), p)));
  EXPECT_EQ(compose(turn, stretch).affine(), (Affine3{{0, -3, 0, 2, 0, 0, 0, 0, -1}, {-19, 12, 33}}));
  EXPECT_EQ(compose(stretch, turn).affine(), (Affine3{{0, -2, 0, 3, 0, 0, 0, 0, -1}, {12, 26, 27}}));
  EXPECT_EQ(compose(Pose(), turn).affine(), turn.affine());
  EXPECT_EQ(compose(turn, Pose()).affine(), turn.affine());
  EXPECT_EQ(compose(turn, stretch).linear_range().greatest, 3);
  EXPECT_EQ(compose(turn, stretch).translation_range().greatest, 33);
}

TEST(PoseTest, ComposeOfWholeNumbersIsExact) {
  Random random(tests::chosen_seed(3));
  const int n = tests::scaled_count(4000, 1000);
  int made = 0;
  const auto any = [&]() -> Pose {
    for (;;) {
      Rows linear;
      std::array<double, 3> translation;
      for (double& m : linear) m = static_cast<double>(random.between(-9, 9));
      for (double& t : translation) t = static_cast<double>(random.between(-99, 99));
      if (determinant(linear) != 0) return Pose::from_matrix(linear, translation);
    }
  };
  for (int i = 0; i < n; ++i) {
    const Pose a = any(), b = any(), c = any();
    const Point3 p{static_cast<double>(random.between(-9, 9)), 1, static_cast<double>(random.between(-9, 9))};
    ASSERT_EQ(image(compose(a, b).affine(), p), image(a.affine(), image(b.affine(), p))) << i;
    ASSERT_EQ(compose(compose(a, b), c).affine(), compose(a, compose(b, c)).affine()) << i;
    ++made;
  }
  EXPECT_EQ(made, n);
}

TEST(PoseTest, ComposeRefusesWhatOverflowsOrBecomesSingular) {
  const auto scale = [](double s, double t) { return Pose::from_matrix({s, 0, 0, 0, s, 0, 0, 0, s}, {t, 0, 0}); };
  expect_refused([&] { compose(scale(1e200, 0), scale(1e200, 0)); }, "matrix has a number that is not finite");
  expect_refused([&] { compose(scale(1e-200, 0), scale(1e-200, 0)); }, "singular");
  expect_refused([&] { compose(scale(1e200, 0), scale(1, 1e200)); }, "translation has a number that is not finite");
  expect_refused([&] { compose(scale(1, largest), scale(1, largest)); }, "translation has a number that is not finite");
  EXPECT_NO_THROW(compose(scale(1e-200, 0), scale(1e200, 0)));
  // Only rounded products: this one is singular though its factors are not.
  const Pose thin = Pose::from_matrix({1, 1, 0, 1, 1 + 0x1p-52, 0, 0, 0, 1}, nowhere);
  expect_refused([&] { compose(thin, Pose::from_matrix({1, 2, 0, 1, 1, 0, 0, 0, 1}, nowhere)); }, "singular");
}

// Each pair of columns, and each column's length, within 2^-20.
TEST(Pose, IsRigid) {
  const Pose turned = Pose::from_quaternion(1, 2, -3, 4, {5, 6, 7});
  EXPECT_TRUE(Pose().is_rigid());
  EXPECT_TRUE(turned.is_rigid());
  EXPECT_TRUE(Pose::from_matrix({0, 1, 0, 1, 0, 0, 0, 0, 1}, {1e300, 0, 0}).is_rigid());  // a reflection
  EXPECT_TRUE(Pose::from_matrix({1 + 0x1p-22, 0, 0, 0, 1, 0, 0, 0, 1}, {0, 0, 0}).is_rigid());
  EXPECT_TRUE(Pose::from_matrix({1, 0x1p-20, 0, 0, 1, 0, 0, 0, 1}, {0, 0, 0}).is_rigid());
  for (std::size_t k = 0; k < 9; ++k) {
    for (const double by : {0x1p-18, -0x1p-18, 1e300}) {
      Rows axes = identity, m = turned.affine().linear;
      axes[k] += by;
      m[k] += by;
      EXPECT_FALSE(Pose::from_matrix(axes, nowhere).is_rigid()) << k << ' ' << by;
      EXPECT_FALSE(Pose::from_matrix(m, nowhere).is_rigid()) << k << ' ' << by;
    }
  }
}

}  // namespace
}  // namespace sunder::solid
