// Pairs of which other libraries were reported to give a wrong distance or a wrong verdict near contact
// (cases/near-contact): the distance of each is what exact fractions give, and so is every clearance beside it.
#include <sunder/solid/round/round_distance.h>
#include <sunder/solid/round/round_round.h>

#include <tests/support/places.h>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <vector>

namespace sunder::tests {
namespace {

using nlohmann::json;
using solid::Pose;
using solid::RoundBody;

RoundBody body_of(const json& object) {
  if (object.contains("ball")) return RoundBody::ball({0, 0, 0}, object.at("ball"));
  if (object.contains("cylinder")) {
    const double half = object.at("length").get<double>() / 2;
    return RoundBody::cylinder({0, 0, -half}, {0, 0, half}, object.at("cylinder"));
  }
  std::vector<Point3> corners;
  const auto half = [&](std::size_t k) { return object.at("box").at(k).get<double>() / 2; };
  for (int k = 0; k < 8; ++k) {
    corners.push_back({(k & 1) == 0 ? -half(0) : half(0), (k & 2) == 0 ? -half(1) : half(1),  //
                       (k & 4) == 0 ? -half(2) : half(2)});
  }
  return RoundBody::rounded(solid::ConvexPolyhedron(corners), 0);
}

Pose pose_of(const json& rows) {
  std::array<double, 9> linear{};
  std::array<double, 3> translation{};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) linear[3 * i + j] = rows.at(i).at(j);
    translation[i] = rows.at(i).at(3);
  }
  return Pose::from_matrix(linear, translation);
}

TEST(NearContactCases, TheDistanceAndEachClearanceBesideItAreRight) {
  const json file = json::parse(std::ifstream(std::filesystem::path(cases_folder()) / "near-contact/pairs.json"));
  ASSERT_EQ(file.size(), 8);
  constexpr double infinity = std::numeric_limits<double>::infinity();
  for (const json& pair : file) {
    SCOPED_TRACE(pair.at("source").get<std::string>());
    const RoundBody a = body_of(pair.at("a")), b = body_of(pair.at("b"));
    const Pose at = pose_of(pair.at("pose_a")), bt = pose_of(pair.at("pose_b"));
    const double distance = pair.at("distance");
    const auto answer = round_round(a, at, b, bt);
    ASSERT_FALSE(answer.undecided());
    EXPECT_EQ(answer.meet(), distance == 0);
    const auto [low, high] = distance_of(round_distance(a, at, b, bt));
    if (distance == 0) {
      EXPECT_EQ(high, 0);
      EXPECT_TRUE(is_broken(round_clearance(a, at, b, bt, 1e-300)));
      continue;
    }
    // Of a curved body the file has what the drawing shows, to 15 digits.
    const double slack = b.is_curved() ? 1e-15 : 0;
    EXPECT_LE(low, std::nextafter(distance, infinity) + slack);
    EXPECT_GE(low, std::nextafter(distance, 0.0) - slack);
    EXPECT_GE(high, std::nextafter(distance, 0.0) - slack);
    EXPECT_LE(high, std::nextafter(distance, infinity) + slack);
    EXPECT_TRUE(is_kept(round_clearance(a, at, b, bt, low)));
    EXPECT_TRUE(is_broken(round_clearance(a, at, b, bt, std::nextafter(high, infinity))));
    EXPECT_TRUE(is_kept(round_clearance(b, bt, a, at, low)));
    EXPECT_TRUE(is_broken(round_clearance(b, bt, a, at, std::nextafter(high, infinity))));
  }
}

}  // namespace
}  // namespace sunder::tests
