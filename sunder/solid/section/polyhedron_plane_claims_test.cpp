#include <sunder/base/random.h>
#include <sunder/predicate/point/plane_side.h>
#include <sunder/solid/section/polyhedron_plane_claims.h>

#include <gtest/gtest.h>
#include <tests/support/scale.h>
#include <verifier/cpp/verify.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <map>
#include <string>
#include <vector>

namespace sunder::solid {
namespace {

using nlohmann::json;

bool is_on(const Plane& plane, const Point3& p) {
  return side_of_plane(plane.normal, plane.point, plane.offset, posed(p, Affine3())) == Sign::zero;
}

TEST(FlatBody, ExactPointOfPlane) {
  EXPECT_EQ(exact_point_of(Plane::through({0.1, 0.2, 0.3}, {0.4, 0.5, 0.6})), (Point3{0.1, 0.2, 0.3}));
  EXPECT_EQ(exact_point_of(Plane::at({0, 0, 1}, 0.1)), (Point3{0, 0, 0.1}));
  EXPECT_EQ(exact_point_of(Plane::at({3, 0, 4}, 1)), (Point3{0, 0, 0.25}));
  // 3 x = 1 holds no point of three doubles; nor does 3 x + 3 y + 3 z = 1.
  EXPECT_FALSE(exact_point_of(Plane::at({3, 0, 0}, 1)));
  EXPECT_FALSE(exact_point_of(Plane::at({3, 3, 3}, 1)));
  EXPECT_TRUE(exact_point_of(Plane::at({3, 5, 0}, 1)));
  Plane both = Plane::through({0.5, 0, 2}, {0, 2, 0});
  both.offset = 6;
  EXPECT_EQ(exact_point_of(both), (Point3{0.5, 3, 2}));
}

// Any decimals: two of the normal's numbers are enough to find a point near the plane's foot.
TEST(FlatBody, ExactPointOfAnyPlane) {
  const int count = tests::scaled_count(2000);
  Random random(tests::chosen_seed(3));
  int found = 0;
  for (int i = 0; i < count; ++i) {
    const auto any = [&] { return random.uniform(-0.5, 0.5) * std::exp2(static_cast<double>(random.between(-6, 6))); };
    const double a = any(), b = any(), c = any(), d = any();
    const Plane plane = Plane::at({a, b, c}, d);
    const auto point = exact_point_of(plane);
    if (!point) continue;
    ++found;
    ASSERT_TRUE(is_on(plane, *point));
  }
  EXPECT_GT(found, count * 9 / 10);
}

std::string plane_certificate(const ConvexPolyhedron& body, const Pose& pose, const Plane& plane,
                              const FlatBody& in_file, const PolyhedronPlane& answer, Relation contact) {
  std::string text;
  ClaimsWriter file([&](std::string_view piece) { text += piece; });
  PairClaims pairs(file);
  const std::uint32_t a = pairs.add_placed("body", pairs.add_body("body", body.vertices()), pose.affine());
  const std::uint32_t b = pairs.add_body("plane", in_file.points, in_file.ways);
  add_claims(pairs, a, b, body, pose, plane, in_file, answer, contact);
  pairs.end();
  return text;
}

bool is_accepted(const json& file) { return sunder_verifier::verify_text(file.dump(), "certificate").accepted(); }

std::string negated(const std::string& number) { return number[0] == '-' ? number.substr(1) : "-" + number; }

// What is not true of this pair must be refused: another plane, beside; the opposite direction; another verdict.
void expect_mutations_refused(const json& file, const Plane& plane) {
  json moved = file;
  json& point = moved["tables"]["bodies"].back()["points"][0];
  const bool apart = file["statements"][0]["verdict"] == "apart";
  if (apart) {
    json turned = file;
    for (json& x : turned["statements"][0]["claims"][0]["direction"]) x = negated(x);
    EXPECT_FALSE(is_accepted(turned));
    json met = file;
    met["statements"][0]["verdict"] = "meet";
    EXPECT_FALSE(is_accepted(met));
    return;
  }
  const std::size_t axis = plane.normal.x != 0 ? 0 : plane.normal.y != 0 ? 1 : 2;
  point[axis] = "0x1p+900";
  EXPECT_FALSE(is_accepted(moved));
  json claims = file;
  claims["statements"][0]["point"][axis] = "0x1.8p+700";
  EXPECT_FALSE(is_accepted(claims));
  for (const char* verdict : {"touching", "overlapping", "apart"}) {
    if (file["statements"][0]["verdict"] == verdict) continue;
    json other = file;
    other["statements"][0]["verdict"] = verdict;
    EXPECT_FALSE(is_accepted(other));
  }
  if (file["statements"][0]["verdict"] == "touching") {
    json turned = file;
    for (json& x : turned["statements"][0]["claims"][2]["direction"]) x = negated(x);
    EXPECT_FALSE(is_accepted(turned));
    json inside = file;
    inside["statements"][0]["verdict"] = "overlapping";
    inside["statements"][0]["claims"].erase(2);
    for (json& claim : inside["statements"][0]["claims"]) claim["claim"] = "inside";
    EXPECT_FALSE(is_accepted(inside));
  }
}

// Small integers, so that planes go through vertices, edges and facets often.
TEST(PolyhedronPlaneClaims, Random) {
  const int count = tests::scaled_count(4000);
  Random random(tests::chosen_seed(20261125));
  const auto small = [&] { return static_cast<double>(random.between(-3, 3)); };
  const auto small_point = [&] {
    const double x = small(), y = small(), z = small();
    return Point3{x, y, z};
  };
  std::map<std::string, int> tally;
  int no_point = 0;
  for (int i = 0; i < count; ++i) {
    std::vector<Point3> points;
    const bool flat = random.below(4) == 0;
    for (std::uint64_t n = 1 + random.below(9); n > 0; --n) {
      points.push_back(small_point());
      if (flat) points.back().z = points.back().x;
    }
    const ConvexPolyhedron body(points);
    const Pose pose = random.below(2) == 0   ? Pose()
                      : random.below(2) == 0 ? Pose::from_matrix({-1, 0.5, 0, 0, 1, 0, 0.25, 0, 1}, {0.1, 3, -1})
                                             : Pose::from_quaternion(1, small(), small(), 2, {small(), 0, 1});
    Point3 normal;
    while (normal == Point3{}) normal = small_point();
    Plane plane = random.below(2) == 0 ? Plane::at(normal, small()) : Plane::through(small_point(), normal);
    if (flat && random.below(2) == 0) plane = Plane::at({1, 0, -1}, 0);
    const auto in_file = body_of(plane);
    if (!in_file) {
      ++no_point;
      continue;
    }
    const PolyhedronPlane answer =
        random.below(2) == 0 ? polyhedron_plane(body, pose, plane) : polyhedron_plane_by_scan(body, pose, plane);
    const bool tells = random.below(2) == 0;
    const Relation contact = tells ? polyhedron_plane_contact(body, pose, plane) : Relation::none;
    const std::string text = plane_certificate(body, pose, plane, *in_file, answer, contact);
    const auto verified = sunder_verifier::verify_text(text, "certificate");
    ASSERT_TRUE(verified.accepted()) << text;
    const std::string verdict = !answer.meet() ? "apart" : tells ? std::string(name_of(contact)) : "meet";
    ASSERT_EQ(verified.statements[0].verdict, verdict);
    if (answer.meet()) {
      const ExactPoint3 x = common_point(body, pose, plane, answer);
      ASSERT_EQ(height(plane, x).sign(), Sign::zero);
    }
    ++tally[verdict + std::to_string(body.dimension())];
    if (i % 8 == 0) expect_mutations_refused(json::parse(text), plane);
  }
  if (count < 1000) return;
  EXPECT_LT(no_point, count / 5);
  for (const char* verdict : {"apart", "meet", "touching", "overlapping"}) {
    for (const char* dimension : {"0", "1", "2", "3"}) {
      if (verdict + std::string(dimension) == "touching0") continue;  // a point is its own inside
      EXPECT_GT(tally[verdict + std::string(dimension)], count / 2000) << verdict << dimension;
    }
  }
}

}  // namespace
}  // namespace sunder::solid
