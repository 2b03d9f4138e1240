#include <cli/unbounded_certificate.h>

#include <sunder/base/error.h>
#include <sunder/base/random.h>
#include <sunder/planar/pair/polygon_line.h>
#include <sunder/planar/pair/polygon_ray.h>

#include <gtest/gtest.h>
#include <tests/support/scale.h>
#include <nlohmann/json.hpp>

#include <array>
#include <string>
#include <vector>

namespace sunder::cli {
namespace {

using Kind = io::PlanarObject::Kind;
using planar::ConvexPolygon;
using planar::Pose;

PlanarBody body_of(const ConvexPolygon& polygon, const Pose& pose) {
  PlanarBody body{"", "body", "", polygon.size(), polygon, pose, {}, planar::in_space(pose.affine())};
  for (const Point2& p : polygon.vertices()) body.vertices.push_back({p.x, p.y, 0});
  return body;
}

TEST(UnboundedCertificate, ExactImage) {
  EXPECT_EQ(exact_image(Pose(), {1e300, 5e-324}), (Point2{1e300, 5e-324}));
  EXPECT_EQ(exact_image(Pose::from_matrix({0, -2, 0.5, 0}, {3, 4}), {1, 6}), (Point2{-9, 4.5}));
  EXPECT_FALSE(exact_image(Pose::from_matrix({1, 0, 0, 1}, {0.1, 0}), {0.2, 0}));
  EXPECT_FALSE(exact_image(Pose::from_matrix({1, 0, 0, 1}, {0x1p-60, 0}), {1, 0}));
  EXPECT_FALSE(exact_image(Pose::from_matrix({2, 0, 0, 2}, {0, 0}), {1e308, 0}));
  EXPECT_FALSE(exact_image(Pose::from_matrix({0.5, 0, 0, 1}, {0, 0}), {5e-324, 0}));
}

// Small integers, so that touching, parallel and collinear are frequent: whatever is apart has statements that carry
// over to the whole; what meets has one where the piece has a common point.
TEST(UnboundedCertificate, Random) {
  const int count = tests::scaled_count(6000);
  Random random(tests::chosen_seed(20261121));
  const auto small = [&] { return static_cast<double>(random.between(-4, 4)); };
  std::array<int, 3> apart{}, meet{}, beyond{};
  int behind = 0;
  for (int i = 0; i < count; ++i) {
    std::vector<Point2> points;
    for (std::uint64_t n = 1 + random.below(6); n > 0; --n) {
      const double x = small(), y = small();
      points.push_back({x, y});
    }
    const ConvexPolygon polygon = ConvexPolygon::hull_of(points);
    const Pose pose = random.below(2) == 0   ? Pose()
                      : random.below(2) == 0 ? Pose::from_matrix({-1, 0.5, 0, 1}, {0.1, 3})
                                             : Pose::from_angle(0.7, {small(), 0});
    const PlanarBody body = body_of(polygon, pose);
    Unbounded u{static_cast<Kind>(static_cast<int>(Kind::line) + static_cast<int>(random.below(3))), {}, {}, "other"};
    const auto k = static_cast<std::size_t>(u.kind) - static_cast<std::size_t>(Kind::line);
    while (u.a == u.b) {
      const double ax = small(), ay = small(), bx = small(), by = small();
      u.a = {ax, ay};
      u.b = {bx, by};
    }
    const planar::PolygonCut line = planar::polygon_line(polygon, pose, {u.a, u.b});
    const planar::PolygonHalfPlane half = planar::polygon_half_plane(polygon, pose, {u.a, u.b});
    const bool meets = u.kind == Kind::line  ? line.meet()
                       : u.kind == Kind::ray ? planar::polygon_ray(polygon, pose, {u.a, u.b}).meet()
                                             : half.meet;
    std::string text;
    try {
      text = certificate_of_unbounded(body, u, meets, line, half.witness);
    } catch (const Error& error) {
      ASSERT_TRUE(meets) << error.what();
      ASSERT_NE(std::string(error.what()).find("not between the two points given"), std::string::npos) << error.what();
      ++beyond[k];
      continue;
    }
    ++(meets ? meet : apart)[k];
    const nlohmann::json file = nlohmann::json::parse(text);
    const auto& pairs = file["pairs"];
    EXPECT_EQ(file["bodies"][1]["vertices"].size(), u.kind == Kind::half_plane ? 3u : 2u);
    if (meets) {
      EXPECT_EQ(pairs.size(), 1u);
    } else if (u.kind == Kind::ray && line.meet()) {
      ++behind;
      ASSERT_EQ(pairs.size(), 1u);
      EXPECT_EQ(pairs[0]["extreme_b"], 0);
    } else {
      ASSERT_EQ(pairs.size(), 2u);
      EXPECT_EQ(pairs[0]["extreme_b"], 0);
      EXPECT_EQ(pairs[1]["extreme_b"], 1);
      EXPECT_EQ(pairs[0]["direction"], pairs[1]["direction"]);
    }
  }
  if (count < 1000) return;
  for (const int n : apart) EXPECT_GT(n, count / 25);
  for (const int n : meet) EXPECT_GT(n, count / 25);
  for (const int n : beyond) EXPECT_GT(n, count / 200);
  EXPECT_GT(behind, count / 100);
}

}  // namespace
}  // namespace sunder::cli
