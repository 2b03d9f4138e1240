// Pairs of meshes that are not convex, with right answers (cases/assemblies): whether each mesh is closed, and whether
// they meet and how they lie to each other, in both orders, as they are and under maps, with proofs.
#include <tests/support/mesh_proofs.h>
#include <tests/support/places.h>
#include <tests/support/scale.h>

#include <sunder/base/random.h>
#include <sunder/solid/mesh/mesh_mesh.h>
#include <sunder/solid/mesh/mesh_relation.h>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <array>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <map>
#include <string>
#include <vector>

namespace sunder::tests {
namespace {

using nlohmann::json;
using solid::Mesh;
using solid::MeshAnswer;
using solid::MeshRelation;
using solid::MeshView;
using solid::Pose;

Mesh mesh_of_case(const json& given) {
  std::vector<Point3> points;
  for (const json& v : given.at("v")) {
    points.push_back({v.at(0).get<double>(), v.at(1).get<double>(), v.at(2).get<double>()});
  }
  std::vector<std::uint32_t> begin{0}, corners;
  for (const json& f : given.at("f")) {
    for (const json& corner : f) corners.push_back(corner.get<std::uint32_t>());
    begin.push_back(static_cast<std::uint32_t>(corners.size()));
  }
  return Mesh(MeshView{points, begin, corners});
}

bool has_status(const Mesh& mesh, const std::string& status) {
  if (status == "open") return !mesh.is_closed();
  return mesh.is_closed() && mesh.is_by_winding() == (status != "closed-misoriented");
}

// Small whole numbers, so that images of coordinates of few bits are exact, and others are not.
Pose some_map(Random& random) {
  while (true) {
    std::array<double, 9> linear;
    std::array<double, 3> shift;
    for (double& x : linear)
      x = static_cast<double>(random.between(-3, 3)) + (random.below(3) == 0 ? random.unit() : 0);
    for (double& x : shift) x = random.uniform(-4, 4);
    try {
      return Pose::from_matrix(linear, shift);
    } catch (const Error&) {  // singular
    }
  }
}

std::string word_of(const MeshRelation& found) {
  if (!found.is_known) return "unknown";
  switch (found.relation) {
    case Relation::none: return "apart";
    case Relation::touching: return "touch";
    case Relation::overlapping: return "overlap";
    case Relation::a_inside_b:
    case Relation::a_part_of_b: return "inside";
    case Relation::b_inside_a:
    case Relation::b_part_of_a: return "contains";
    case Relation::equal: return "equal";
    case Relation::meeting: break;
  }
  return "meet";
}

std::string proved_word(const std::string& verdict) {
  if (verdict == "touching") return "touch";
  if (verdict == "overlapping") return "overlap";
  if (verdict == "a_inside_b" || verdict == "a_part_of_b") return "inside";
  if (verdict == "b_inside_a" || verdict == "b_part_of_a") return "contains";
  return verdict;
}

TEST(MeshCases, MeetAsTheirAnswersSay) {
  Random random(chosen_seed(4001));
  const bool proves_all = scaled_count(4) == 4;  // else, where all takes long, each fourth
  int pairs = 0, within = 0, proofs = 0;
  std::map<std::string, int> relations;
  for (const char* file : {"hand.json", "reports.json", "voxels.json"}) {
    const json cases = json::parse(std::ifstream(std::filesystem::path(cases_folder()) / "assemblies" / file));
    for (const json& c : cases) {
      SCOPED_TRACE(c.at("name").get<std::string>());
      const Mesh a = mesh_of_case(c.at("A")), b = mesh_of_case(c.at("B"));
      ASSERT_TRUE(has_status(a, c.at("A").at("status")));
      ASSERT_TRUE(has_status(b, c.at("B").at("status")));
      const std::string relation = c.at("relation");
      ++relations[relation];
      const bool meet = relation != "apart";
      if (relation == "not-solid") continue;
      ++pairs;
      for (int k = 0; k < 2; ++k) {
        const Pose pose = k == 0 ? Pose() : some_map(random);
        const MeshAnswer answer = mesh_mesh(a, pose, b, pose), other = mesh_mesh(b, pose, a, pose);
        ASSERT_EQ(answer.meet(), meet) << k;
        ASSERT_EQ(other.meet(), meet) << k;
        if ((proves_all || pairs % 4 == 0) && a.triangles().size() + b.triangles().size() <= 3000) {
          EXPECT_EQ(proved_word(proved_pair(a, pose, b, pose, answer, true)), relation) << k;
          proved_pair(b, pose, a, pose, other, k == 1);
          ++proofs;
        }
        EXPECT_EQ(word_of(mesh_relation(a, pose, b, pose, answer)), relation) << k;
        within += std::holds_alternative<solid::PointWithin>(answer.evidence);
        ASSERT_EQ(answer.evidence.index(), other.evidence.index());
        if (a.triangles().size() * b.triangles().size() <= 3000) {
          ASSERT_EQ(mesh_mesh_by_scan(a, pose, b, pose).meet(), meet) << k;
        }
      }
    }
  }
  EXPECT_EQ(pairs, 405);
  EXPECT_GT(within, 10);
  EXPECT_GT(proofs, proves_all ? 750 : 180);
  EXPECT_EQ(relations["apart"], 58);
  EXPECT_EQ(relations["touch"], 167);
}

}  // namespace
}  // namespace sunder::tests
