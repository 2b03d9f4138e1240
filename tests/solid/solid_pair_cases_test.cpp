// Pairs on which something once failed (cases/solid-pair): every method gives the verdict that the file proves.
#include <sunder/certificate/check.h>
#include <sunder/solid/pair/polyhedron_polyhedron.h>

#include <tests/support/places.h>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <array>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

namespace sunder::tests {
namespace {

using nlohmann::json;
using solid::ConvexPolyhedron;
using solid::PairAnswer;
using solid::Pose;

double number(const json& text) { return std::strtod(text.get<std::string>().c_str(), nullptr); }

TEST(SolidPairCases, EveryMethodGivesTheProvedVerdict) {
  const std::filesystem::path folder = std::filesystem::path(tests::cases_folder()) / "solid-pair";
  int pairs = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (entry.path().extension() != ".json") continue;
    SCOPED_TRACE(entry.path().filename());
    const json file = json::parse(std::ifstream(entry.path()));
    std::vector<ConvexPolyhedron> bodies;
    std::vector<Pose> poses;
    for (const json& body : file.at("tables").at("bodies")) {
      if (!body.contains("of")) {
        std::vector<Point3> points;
        for (const json& v : body.at("points")) points.push_back({number(v.at(0)), number(v.at(1)), number(v.at(2))});
        bodies.emplace_back(points);
        poses.emplace_back();
        ASSERT_EQ(bodies.back().vertices().size(), points.size());
        continue;
      }
      std::array<double, 9> linear{};
      std::array<double, 3> translation{};
      for (std::size_t i = 0; i < 9; ++i) linear[i] = number(body.at("linear").at(i));
      for (std::size_t i = 0; i < 3; ++i) translation[i] = number(body.at("translation").at(i));
      poses.push_back(Pose::from_matrix(linear, translation));
      const ConvexPolyhedron of = bodies.at(body.at("of").get<std::size_t>());
      bodies.push_back(of);
    }
    for (const json& pair : file.at("statements")) {
      ++pairs;
      const std::size_t i = pair.at("a").get<std::size_t>(), j = pair.at("b").get<std::size_t>();
      const ConvexPolyhedron &a = bodies[i], &b = bodies[j];
      const bool meet = pair.at("verdict") == "meet";
      for (const PairAnswer& answer :
           {polyhedron_polyhedron(a, poses[i], b, poses[j]), polyhedron_polyhedron(b, poses[j], a, poses[i]),
            polyhedron_polyhedron_by_gjk(a, poses[i], b, poses[j]),
            polyhedron_polyhedron_by_hierarchy(a, poses[i], b, poses[j]),
            polyhedron_polyhedron_by_bounded(a, poses[i], b, poses[j]),
            polyhedron_polyhedron_by_scan(a, poses[i], b, poses[j])}) {
        EXPECT_EQ(answer.meet(), meet);
      }
      const PairAnswer answer = polyhedron_polyhedron(a, poses[i], b, poses[j]);
      EXPECT_EQ(check_absolutely(answer.evidence, {a.vertices(), poses[i].affine(), false},
                                 {b.vertices(), poses[j].affine(), false}),
                CheckResult::accepted);
    }
  }
  EXPECT_GE(pairs, 2);
}

}  // namespace
}  // namespace sunder::tests
