#include <sunder/base/random.h>
#include <sunder/planar/pair/polygon_half_plane.h>
#include <sunder/planar/pair/polygon_line.h>
#include <sunder/planar/pair/polygon_unbounded.h>

#include <gtest/gtest.h>
#include <tests/support/scale.h>
#include <verifier/cpp/verify.h>
#include <nlohmann/json.hpp>

#include <map>
#include <string>
#include <vector>

namespace sunder::planar {
namespace {

const char* name_of(const Unbounded& other) {
  return std::holds_alternative<Line>(other) ? "line" : std::holds_alternative<Ray>(other) ? "ray" : "half-plane";
}

Unbounded unbounded(std::uint64_t kind, const Point2& a, const Point2& b) {
  if (kind == 0) return Line::through(a, b);
  if (kind == 1) return Ray::from(a, b);
  return HalfPlane::left_of(a, b);
}

// The file that states what was found, with the polygon as A.
std::string certificate_of(const ConvexPolygon& polygon, const Pose& pose, const Unbounded& other,
                           const PolygonCommon& common, bool tells_contact) {
  std::string text;
  std::vector<Point3> vertices;
  for (const Point2& p : polygon.vertices()) vertices.push_back({p.x, p.y, 0});
  const UnboundedBody body = body_of(other);
  ClaimsWriter file([&](std::string_view piece) { text += piece; });
  PairClaims pairs(file, PairClaims::Space::planar);
  const std::uint32_t a = pairs.add_placed("polygon", pairs.add_body("polygon", vertices), in_space(pose.affine()));
  const std::uint32_t b = pairs.add_body("other", body.points, body.ways);
  add_claims(pairs, a, b, polygon, pose, other, common, tells_contact);
  pairs.end();
  return text;
}

TEST(PolygonUnbounded, ExactImage) {
  EXPECT_EQ(exact_image(Pose(), {1e300, 5e-324}), (Point2{1e300, 5e-324}));
  EXPECT_EQ(exact_image(Pose::from_matrix({0, -2, 0.5, 0}, {3, 4}), {1, 6}), (Point2{-9, 4.5}));
  EXPECT_FALSE(exact_image(Pose::from_matrix({1, 0, 0, 1}, {0.1, 0}), {0.2, 0}));
  EXPECT_FALSE(exact_image(Pose::from_matrix({1, 0, 0, 1}, {0x1p-60, 0}), {1, 0}));
  EXPECT_FALSE(exact_image(Pose::from_matrix({2, 0, 0, 2}, {0, 0}), {1e308, 0}));
  EXPECT_FALSE(exact_image(Pose::from_matrix({0.5, 0, 0, 1}, {0, 0}), {5e-324, 0}));
}

// Small integers, so that touching, parallel and collinear are frequent: each answer is proved, also far from the two
// points given, and another verdict is not.
TEST(PolygonUnbounded, Random) {
  const int count = tests::scaled_count(6000);
  Random random(tests::chosen_seed(20261121));
  const auto small = [&] { return static_cast<double>(random.between(-4, 4)); };
  std::map<std::string, int> tally;
  std::map<CutKind, int> kinds;
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
    const std::uint64_t kind = random.below(3);
    Point2 p, q;
    while (p == q) {
      const double px = small(), py = small(), qx = small(), qy = small();
      p = {px, py};
      q = {qx, qy};
    }
    if (random.below(4) == 0) q = {q.x * 0x1p70, q.y * 0x1p70 + 0x1p-30};  // the difference is no double
    const Unbounded u = unbounded(kind, p, q);
    const bool tells_contact = random.below(2) == 0;
    const PolygonCommon answer = polygon_unbounded(polygon, pose, u);
    const PolygonCommon scanned = polygon_unbounded_by_scan(polygon, pose, u);
    ASSERT_EQ(kind_of(answer), kind_of(scanned));
    const Relation contact = contact_of(polygon, u, answer);
    ASSERT_EQ(contact, contact_of(polygon, u, scanned));
    ASSERT_EQ(answer.meet(), contact != Relation::none);
    ASSERT_EQ(answer.meet(), kind_of(answer) != CutKind::nothing);
    if (kind == 2) {
      ASSERT_EQ(furthest_of(answer), polygon_half_plane(polygon, pose, std::get<HalfPlane>(u)).witness);
    }
    if (kind == 0) {
      ASSERT_EQ(kind_of(polygon_unbounded_by_fibonacci(polygon, pose, u)), kind_of(scanned));
    }
    if (kind == 1 && !answer.meet() && polygon_line(polygon, pose, {p, q}).meet()) ++behind;
    const std::string text = certificate_of(polygon, pose, u, answer, tells_contact);
    const auto verified = sunder_verifier::verify_text(text, "certificate");
    ASSERT_TRUE(verified.accepted()) << text;
    ASSERT_EQ(verified.statements.size(), kind == 1 && !answer.meet() ? 1u : 2u);
    const std::string verdict = !answer.meet()  ? "apart"
                                : tells_contact ? std::string(sunder::name_of(contact))
                                                : "meet";
    EXPECT_EQ(verified.statements[0].verdict, verdict);
    const nlohmann::json other = nlohmann::json::parse(text)["tables"]["bodies"].back();
    EXPECT_EQ(other["points"].size(), 1u);
    EXPECT_EQ(other["ways"].size(), kind == 1 ? 1u : kind == 0 ? 2u : 3u);
    ++tally[std::string(name_of(u)) + " " + verdict];
    ++kinds[kind_of(answer)];
  }
  if (count < 1000) return;
  for (const char* kind : {"line", "ray", "half-plane"}) {
    for (const char* verdict : {"apart", "meet", "touching", "overlapping"}) {
      EXPECT_GT(tally[std::string(kind) + " " + verdict], count / 300) << kind << " " << verdict;
    }
  }
  EXPECT_GT(behind, count / 100);
  EXPECT_EQ(kinds.size(), 6u);
}

}  // namespace
}  // namespace sunder::planar
