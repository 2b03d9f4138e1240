#include <sunder/ask/pair/unbounded_certificate.h>

#include <sunder/base/random.h>
#include <sunder/planar/pair/polygon_half_plane.h>
#include <sunder/planar/pair/polygon_line.h>
#include <sunder/planar/pair/polygon_ray.h>

#include <gtest/gtest.h>
#include <tests/support/scale.h>
#include <verifier/cpp/verify.h>
#include <nlohmann/json.hpp>

#include <map>
#include <string>
#include <vector>

namespace sunder::ask {
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

// Small integers, so that touching, parallel and collinear are frequent: each answer is proved, also far from the two
// points given, and another verdict is not.
TEST(UnboundedCertificate, Random) {
  const int count = tests::scaled_count(6000);
  Random random(tests::chosen_seed(20261121));
  const auto small = [&] { return static_cast<double>(random.between(-4, 4)); };
  std::map<std::string, int> tally;
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
    while (u.a == u.b) {
      const double ax = small(), ay = small(), bx = small(), by = small();
      u.a = {ax, ay};
      u.b = {bx, by};
    }
    if (random.below(4) == 0) u.b = {u.b.x * 0x1p70, u.b.y * 0x1p70 + 0x1p-30};  // the difference is no double
    UnboundedAnswer answer;
    answer.tells_contact = random.below(2) == 0;
    answer.of_line = planar::polygon_line(polygon, pose, {u.a, u.b});
    if (u.kind == Kind::half_plane) {
      const planar::PolygonHalfPlane half = planar::polygon_half_plane(polygon, pose, {u.a, u.b});
      answer.witness = half.witness;
      answer.contact = !half.meet ? Contact::none : half.touching ? Contact::touching : Contact::overlapping;
      answer.cut = answer.of_line;
    } else {
      answer.cut = u.kind == Kind::line ? answer.of_line : planar::polygon_ray(polygon, pose, {u.a, u.b});
      answer.contact = contact_of(answer.cut, polygon.size());
    }
    if (u.kind == Kind::ray && answer.contact == Contact::none && answer.of_line.meet()) ++behind;
    const std::string text = certificate_of_unbounded(body, u, answer);
    const auto verified = sunder_verifier::verify_text(text, "certificate");
    ASSERT_TRUE(verified.accepted()) << text;
    ASSERT_EQ(verified.statements.size(), 1u);
    const std::string verdict = answer.contact == Contact::none ? "apart"
                                : answer.tells_contact          ? std::string(name_of(answer.contact))
                                                                : "meet";
    EXPECT_EQ(verified.statements[0].verdict, verdict);
    const nlohmann::json other = nlohmann::json::parse(text)["tables"]["bodies"].back();
    EXPECT_EQ(other["points"].size(), 1u);
    EXPECT_EQ(other["ways"].size(), u.kind == Kind::ray ? 1u : u.kind == Kind::line ? 2u : 3u);
    ++tally[std::string(io::name_of(u.kind)) + " " + verdict];
  }
  if (count < 1000) return;
  for (const char* kind : {"line", "ray", "half-plane"}) {
    for (const char* verdict : {"apart", "meet", "touching", "overlapping"}) {
      EXPECT_GT(tally[std::string(kind) + " " + verdict], count / 300) << kind << " " << verdict;
    }
  }
  EXPECT_GT(behind, count / 100);
}

}  // namespace
}  // namespace sunder::ask
