// Writes a sample of certificate files of planar pairs: planar_certificate_sample FOLDER COUNT [SEED].
//
// Every family of tests/support/planar_pairs.h in turn but the large ones, the methods in turn, fifty pairs a file. The
// last line printed says how many.
#include <sunder/certificate/pair_claims.h>
#include <sunder/planar/pair/contact_evidence.h>
#include <sunder/planar/pair/polygon_polygon.h>
#include <tests/support/planar_pairs.h>

#include <array>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>
#include <vector>

namespace {

using namespace sunder;

struct Case {
  tests::PlanarCase planar;
  std::string name;
  std::vector<Point3> vertices_a, vertices_b;
  std::uint32_t a = 0, b = 0;
};

std::vector<Point3> in_space(const planar::ConvexPolygon& polygon) {
  std::vector<Point3> vertices;
  for (const Point2& p : polygon.vertices()) vertices.push_back({p.x, p.y, 0});
  return vertices;
}

// Every other one that meets tells how.
void add_answer(PairClaims& written, const Case& c, const PairCertificate& evidence, bool tells_contact) {
  const auto& [family, a, b, pose_a, pose_b, touches] = c.planar;
  const Relation contact = tells_contact ? planar::polygon_polygon_contact(a, pose_a, b, pose_b) : Relation::none;
  planar::add_claims(written, {c.a, c.b, a, pose_a, b, pose_b}, evidence, contact);
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 3) {
    std::fprintf(stderr, "usage: planar_certificate_sample FOLDER COUNT [SEED]\n");
    return 2;
  }
  const std::filesystem::path folder = argv[1];
  const int count = std::atoi(argv[2]);
  tests::PlanarPairs pairs(argc > 3 ? std::strtoull(argv[3], nullptr, 10) : 1);
  constexpr std::array methods{planar::polygon_polygon,
                               planar::polygon_polygon_by_difference,
                               planar::polygon_polygon_by_halving,
                               planar::polygon_polygon_by_triangles,
                               planar::polygon_polygon_by_gjk,
                               planar::polygon_polygon_by_scan};
  std::filesystem::create_directories(folder);
  int meets = 0, files = 0;
  for (int i = 0; i < count;) {
    std::vector<Case> cases;
    for (int k = 0; k < 50 && i + k < count; ++k) {
      tests::PlanarCase c = pairs.next();
      while (c.family == tests::PlanarFamily::large) c = pairs.next();
      const std::string name = std::string(tests::name_of(c.family)) + " " + std::to_string(i + k);
      std::vector<Point3> vertices_a = in_space(c.a), vertices_b = in_space(c.b);
      cases.push_back({std::move(c), name, std::move(vertices_a), std::move(vertices_b)});
    }
    std::ofstream file(folder / ("planar_" + std::to_string(files++) + ".json"), std::ios::binary);
    ClaimsWriter claims([&](std::string_view text) { file << text; });
    PairClaims written(claims, PairClaims::Space::planar);
    const auto add = [&](const std::string& name, const std::vector<Point3>& vertices, const planar::Pose& pose) {
      return written.add_placed(name, written.add_body(name, vertices), planar::in_space(pose.affine()));
    };
    for (Case& c : cases) {
      c.a = add(c.name + " a", c.vertices_a, c.planar.pose_a);
      c.b = add(c.name + " b", c.vertices_b, c.planar.pose_b);
    }
    for (const Case& c : cases) {
      const auto method = methods[static_cast<std::size_t>(i++) % methods.size()];
      const PairAnswer answer = method(c.planar.a, c.planar.pose_a, c.planar.b, c.planar.pose_b);
      add_answer(written, c, answer.evidence, i % 4 < 2);
      meets += answer.meet() ? 1 : 0;
    }
    written.end();
    if (!file.flush()) {
      std::fprintf(stderr, "%s: cannot be written\n", folder.c_str());
      return 2;
    }
  }
  std::printf("%d certificates in %d files, %d meet\n", count, files, meets);
  return 0;
}
