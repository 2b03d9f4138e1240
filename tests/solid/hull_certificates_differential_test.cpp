// Certificates of convex hulls of nasty sets of points, written by the library and checked without it. What the
// verifier accepts is proved, so this also checks the hull itself.
#include <tests/support/scale.h>
#include <tests/support/shapes.h>

#include <sunder/base/random.h>
#include <sunder/solid/object/hull_claims.h>

#include <verifier/cpp/verify.h>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace sunder::tests {
namespace {

constexpr std::array<const char*, 8> families{"few places", "ball",  "shell",     "flat",
                                              "line",       "prism", "last bits", "scales"};

std::vector<Point3> some_points(std::size_t family, Random& random) {
  std::vector<Point3> points;
  const auto count = static_cast<std::size_t>(random.between(1, 60));
  const auto whole = [&](int most) { return static_cast<double>(random.between(-most, most)); };
  const int scale = static_cast<int>(random.between(-1000, 1000));
  for (std::size_t k = 0; k < count; ++k) {
    const Point3 p = in_cube(random);
    const double length = std::sqrt(p.x * p.x + p.y * p.y + p.z * p.z), angle = random.uniform(0, 7);
    switch (family) {
      case 0: points.push_back({whole(2), whole(2), whole(2)}); break;
      case 1: points.push_back(p); break;
      case 2: points.push_back({p.x / length, p.y / length, p.z / length}); break;
      case 3: {
        const double x = whole(20), y = whole(20);
        points.push_back({x, y, 2 * x - y});
        break;
      }
      case 4: {
        const double x = whole(9);
        points.push_back({x, -3 * x, 2 * x});
        break;
      }
      case 5: points.push_back({std::cos(angle), std::sin(angle), whole(1)}); break;  // caps of many corners
      case 6: points.push_back({whole(2), whole(2), std::nextafter(whole(1), whole(5))}); break;
      default: points.push_back({std::ldexp(p.x, scale), std::ldexp(p.y, scale), std::ldexp(whole(3), scale)});
    }
  }
  return points;
}

std::string hull_proof(const std::vector<Point3>& points) {
  std::string text;
  ClaimsWriter file([&](std::string_view piece) { text += piece; });
  solid::write_hull(file, "points", points, solid::ConvexPolyhedron(points));
  file.end();
  return text;
}

TEST(HullCertificatesDifferential, EachHullIsProved) {
  const int count = scaled_count(2000);
  const std::uint64_t seed = chosen_seed(20261125);
  SCOPED_TRACE("seed " + std::to_string(seed));
  Random random(seed);
  std::map<std::string, int> total;
  for (int k = 0; k < count; ++k) {
    const std::size_t family = static_cast<std::size_t>(k) % families.size();
    const std::vector<Point3> points = some_points(family, random);
    const std::string text = hull_proof(points);
    const auto result = sunder_verifier::verify_text(text, "certificate", sunder_verifier::Limit::none);
    ASSERT_EQ(result.statements.size(), 1u) << families[family] << result.failed_form << result.error;
    ASSERT_TRUE(result.accepted()) << k << " " << families[family] << ": " << result.statements[0].reason << "\n"
                                   << text;
    ++total[result.statements[0].verdict];
  }
  for (const auto& [verdict, n] : total) std::printf("%s %d\n", verdict.c_str(), n);
  if (count < 500) return;
  for (const char* verdict : {"solid", "flat", "segment", "point"}) EXPECT_GT(total[verdict], count / 200) << verdict;
}

// Most points are inside: each has its home behind one of many facets.
TEST(HullCertificatesDifferential, ABallOfManyPoints) {
  Random random(20261126);
  std::vector<Point3> points;
  for (int k = 0; k < scaled_count(20000); ++k) {
    points.push_back(in_cube(random));
    const Point3& p = points.back();
    if (p.x * p.x + p.y * p.y + p.z * p.z > 1) points.pop_back();
  }
  const auto result = sunder_verifier::verify_text(hull_proof(points), "certificate", sunder_verifier::Limit::by_size);
  EXPECT_TRUE(result.accepted()) << result.error;
}

}  // namespace
}  // namespace sunder::tests
