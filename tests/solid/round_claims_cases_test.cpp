// Bodies with a radius, written by the library, are to the checker what they are said to be: one statement of each
// verdict, with each kind, and the same with one number changed, which is refused by the rule that is about it.
#include <sunder/certificate/pair_claims.h>

#include <verifier/cpp/verify.h>

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace sunder::tests {
namespace {

// The sentence of what is accepted, or the rule that fails.
std::string told(const std::function<void(PairClaims& pairs)>& write) {
  std::string text;
  ClaimsWriter file([&](std::string_view piece) { text += piece; });
  PairClaims pairs(file);
  write(pairs);
  pairs.end();
  const sunder_verifier::FileResult result = sunder_verifier::verify_text(text, "test");
  if (!result.error.empty() || !result.failed_form.empty()) return result.error + result.failed_form;
  const sunder_verifier::StatementResult& first = result.statements.at(0);
  return first.accepted ? first.sentence : first.failed_check;
}

const std::vector<Point3> origin{{0, 0, 0}}, up{{0, 0, -1}, {0, 0, 3}}, far{{6, 8, -5}, {6, 8, 5}};
const Combination all_of_one{{{0, 1.0}}, 1.0};

Affine3 stretched() {
  Affine3 pose;
  pose.linear = {3, 0, 0, 0, 4, 0, 0, 0, 1};
  return pose;
}

TEST(RoundClaims, ApartToTheLastBit) {
  // The capsule's axis is 10 from the other one.
  const auto beside = [](RoundKind kind, double radius) {
    return told([=](PairClaims& pairs) {
      const auto a = pairs.add_round_body("a", kind == RoundKind::ellipsoid ? origin : up, kind, radius);
      const auto b = pairs.add_round_body("b", far, RoundKind::hull, 5);
      pairs.add_apart(a, b, {3.0, 4.0, 0.0});
    });
  };
  const double below = std::nextafter(5.0, 0.0);
  const std::string radius = " of radius 0x1.3ffffffffffffp+2 of the ";
  const std::string apart = R"(of "a" and the capsule of radius 0x1.4p+2 of the 2 points of "b" are apart)";
  EXPECT_EQ(beside(RoundKind::hull, below), "the capsule" + radius + "2 points " + apart);
  EXPECT_EQ(beside(RoundKind::cylinder, below), "the cylinder" + radius + "2 points " + apart);
  EXPECT_EQ(beside(RoundKind::cone, below), "the cone" + radius + "2 points " + apart);
  EXPECT_EQ(beside(RoundKind::ellipsoid, below), "the ball" + radius + "1 point " + apart);
  for (const RoundKind kind : {RoundKind::hull, RoundKind::cylinder, RoundKind::cone, RoundKind::ellipsoid}) {
    EXPECT_EQ(beside(kind, 5), "parted");
  }
}

TEST(RoundClaims, TouchingAndOverlapping) {
  // A quarter of the way up its axis, the cylinder touches the capsule between its ends.
  const auto touching = [](double radius, double y) {
    return told([=](PairClaims& pairs) {
      const auto a = pairs.add_round_body("a", up, RoundKind::cylinder, radius);
      const auto b = pairs.add_round_body("b", far, RoundKind::hull, 5);
      pairs.add_touching(a, b, {{3.0, y, 0.0}, {{{0, 3.0}, {1, 1.0}}, 4.0}, {{{0, 1.0}, {1, 1.0}}, 2.0}},
                         {3.0, 4.0, 0.0});
    });
  };
  EXPECT_EQ(touching(5, 4),
            R"(the cylinder of radius 0x1.4p+2 of the 2 points of "a" and the capsule of radius 0x1.4p+2 )"
            R"(of the 2 points of "b" touch at (3, 4, 0))");
  EXPECT_EQ(touching(std::nextafter(5.0, 0.0), 4), "holds");
  EXPECT_EQ(touching(std::nextafter(5.0, 9.0), 4), "parted");
  EXPECT_EQ(touching(5, std::nextafter(4.0, 5.0)), "holds");
  // Halfway to the apex the cone is half as wide.
  const auto overlapping = [](double x) {
    return told([=](PairClaims& pairs) {
      const auto a = pairs.add_round_body("a", up, RoundKind::cone, 2);
      const auto b = pairs.add_round_body("b", origin, RoundKind::hull, 4);
      pairs.add_overlapping(a, b, {{x, 0.0, 1.0}, {{{0, 1.0}, {1, 1.0}}, 2.0}, all_of_one});
    });
  };
  EXPECT_EQ(overlapping(0.5), R"(the cone of radius 0x1p+1 of the 2 points of "a" and the ball of radius 0x1p+2 )"
                              R"(of the 1 point of "b" overlap at (1/2, 0, 1))");
  EXPECT_EQ(overlapping(1), "inside");
  EXPECT_EQ(overlapping(1.5), "holds");
}

TEST(RoundClaims, EllipsoidsAndClearances) {
  const auto meet = [](double radius, double y) {
    return told([=](PairClaims& pairs) {
      const auto ball = pairs.add_round_body("ball", origin, RoundKind::ellipsoid, radius);
      const auto a = pairs.add_placed("a", ball, stretched()), b = pairs.add_body("b", far);
      const Combination of_a{{{0, 1.0}}, 1.0, ExactPoint3{6.0, 2.0 * y, 0.0, 3.0}};
      pairs.add_meet(a, b, {{6.0, 8.0, 0.0}, of_a, {{{0, 1.0}, {1, 1.0}}, 2.0}});
    });
  };
  // (6, 8, 0) comes from (2, 2, 0), which is the root of 8 from the middle.
  EXPECT_EQ(meet(3, 3), R"(the image of the ball of radius 0x1.8p+1 of the 1 point of "a" and the convex hull of the )"
                        R"(2 points of "b" meet at (6, 8, 0))");
  EXPECT_EQ(meet(2.75, 3), "holds");
  EXPECT_EQ(meet(3, 3.5), "holds");
  const auto kept = [](double least) {
    return told([=](PairClaims& pairs) {
      const auto a = pairs.add_round_body("a", origin, RoundKind::hull, 2);
      const auto b = pairs.add_round_body("b", far, RoundKind::cylinder, 5);
      pairs.add_clearance(a, b, least, {3.0, 4.0, 0.0});
    });
  };
  EXPECT_EQ(kept(3), R"(the ball of radius 0x1p+1 of the 1 point of "a" and the cylinder of radius 0x1.4p+2 )"
                     R"(of the 2 points of "b" are 0x1.8p+1 apart, or more)");
  EXPECT_EQ(kept(std::nextafter(3.0, 4.0)), "clear");
  const auto broken = [](double least) {
    return told([=](PairClaims& pairs) {
      const auto a = pairs.add_round_body("a", origin, RoundKind::hull, 5);
      const auto b = pairs.add_round_body("b", far, RoundKind::cylinder, 5.0 / 2);
      pairs.add_clearance_broken(a, b, least, {{3.0, 4.0, 0.0}, all_of_one},
                                 {{9.0, 12.0, 0.0, 2.0}, {{{0, 1.0}, {1, 1.0}}, 2.0}});
    });
  };
  EXPECT_EQ(broken(std::nextafter(2.5, 3.0)).substr(0, 145),
            R"(the ball of radius 0x1.4p+2 of the 1 point of "a" and the cylinder of radius 0x1.4p+1 )"
            R"(of the 2 points of "b" are nearer than 0x1.4000000000001p+1)");
  EXPECT_EQ(broken(2.5), "nearer");
}

}  // namespace
}  // namespace sunder::tests
