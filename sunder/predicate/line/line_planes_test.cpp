#include <sunder/base/random.h>
#include <sunder/predicate/exact_image_test.h>
#include <sunder/predicate/line/line_planes.h>
#include <sunder/predicate/point/orient.h>

#include <gtest/gtest.h>
#include <tests/support/exact.h>
#include <tests/support/scale.h>

#include <array>
#include <cmath>

namespace sunder {
namespace {

using tests::Exact;

ExactVector difference(const ExactVector& a, const ExactVector& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
ExactVector cross_product(const ExactVector& a, const ExactVector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
Exact dot_product(const ExactVector& a, const ExactVector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
ExactVector image(const Affine3& pose, const Point3& p) {
  const auto row = [&](std::size_t i) {
    const auto& m = pose.linear;
    return Exact(m[3 * i]) * Exact(p.x) + Exact(m[3 * i + 1]) * Exact(p.y) + Exact(m[3 * i + 2]) * Exact(p.z) +
           Exact(pose.translation[i]);
  };
  return {row(0), row(1), row(2)};
}
// Whole numbers, near-ties, and sizes from 1e-300 to 1e300.
TEST(LinePlanes, AgreeWithExactNumbers) {
  const int count = tests::scaled_count(3000);
  Random random(tests::chosen_seed(20261127));
  StageTally tally;
  int zeros = 0;
  for (int i = 0; i < count; ++i) {
    const int kind = i % 3;
    const double scale = kind == 2 ? std::ldexp(1.0, static_cast<int>(random.between(-300, 300))) : 1;
    const auto number = [&] { return kind == 0 ? static_cast<double>(random.between(-2, 2)) : random.uniform(-1, 1); };
    const auto point = [&] {
      const double x = number(), y = number(), z = number();
      return Point3{x * scale, y * scale, z * scale};
    };
    Affine3 pose;
    if (random.below(2) == 0) {
      for (double& m : pose.linear) m = number();
      for (double& t : pose.translation) t = number() * scale;
    }
    std::array<Point3, 6> p;
    for (Point3& q : p) q = point();
    const Point3 a = point(), b = point();
    const auto of = [&](std::size_t k) { return posed(p[k], pose); };
    const PosedTriangle f{of(0), of(1), of(2)}, g{of(3), of(4), of(5)};
    std::array<ExactVector, 6> v{image(pose, p[0]), image(pose, p[1]), image(pose, p[2]),
                                 image(pose, p[3]), image(pose, p[4]), image(pose, p[5])};
    const ExactVector from = image(a), d = difference(image(b), from);
    const auto turns = turns_about_line(a, b, f, &tally);
    for (std::size_t k = 0; k < 3; ++k) {
      EXPECT_EQ(turns[k],
                sign_of(dot_product(cross_product(d, difference(v[k], from)), difference(v[(k + 1) % 3], from))));
    }
    const ExactVector n_f = cross_product(difference(v[1], v[0]), difference(v[2], v[0])),
                      n_g = cross_product(difference(v[4], v[3]), difference(v[5], v[3]));
    const auto [of_f, of_g, beyond] = line_and_planes(a, b, f, g, &tally);
    EXPECT_EQ(of_f, sign_of(dot_product(n_f, d)));
    EXPECT_EQ(of_g, sign_of(dot_product(n_g, d)));
    EXPECT_EQ(facing(a, b, f), of_f);
    const Exact left = dot_product(n_f, difference(from, v[0])) * dot_product(n_g, d),
                right = dot_product(n_g, difference(from, v[3])) * dot_product(n_f, d);
    EXPECT_EQ(beyond, sign_of(left - right));
    zeros += beyond == Sign::zero;
  }
  if (count < 1000) return;
  EXPECT_GT(zeros, 10);
  EXPECT_GT(tally.rounded, 0u);
  EXPECT_GT(tally.exact, 0u);
}

}  // namespace
}  // namespace sunder
