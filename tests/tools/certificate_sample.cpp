// Writes a sample of certificate files, for checkers other than the library's: certificate_sample FOLDER COUNT [SEED].
//
// Every family of tests/support/solid_pairs.h in turn, fifty pairs a file: whether they meet, and how far apart they
// are. The last line printed says how many.
#include <sunder/certificate/pair_claims.h>
#include <sunder/solid/pair/contact_evidence.h>
#include <sunder/solid/pair/polyhedron_polyhedron.h>
#include <sunder/solid/pair/polyhedron_polyhedron_distance.h>
#include <tests/support/solid_pairs.h>

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>
#include <vector>

int main(int argc, char** argv) {
  using namespace sunder;
  if (argc < 3) {
    std::fprintf(stderr, "usage: certificate_sample FOLDER COUNT [SEED]\n");
    return 2;
  }
  const std::filesystem::path folder = argv[1];
  const int count = std::atoi(argv[2]);
  tests::SolidPairs pairs(argc > 3 ? std::strtoull(argv[3], nullptr, 10) : 1);
  std::filesystem::create_directories(folder);
  int meets = 0, files = 0;
  for (int i = 0; i < count;) {
    std::vector<tests::PairCase> cases;
    for (int k = 0; k < 50 && i + k < count; ++k) cases.push_back(pairs.next());
    std::ofstream file(folder / ("sample_" + std::to_string(files++) + ".json"), std::ios::binary);
    ClaimsWriter claims([&](std::string_view text) { file << text; });
    PairClaims written(claims);
    struct Placed {
      std::uint32_t a, b;
    };
    std::vector<Placed> placed;
    for (const tests::PairCase& c : cases) {
      const std::string name = std::string(tests::name_of(c.family)) + " " + std::to_string(i++);
      const auto a = written.add_placed(name + " a", written.add_body(name + " a", c.a.vertices()), c.pose_a.affine());
      const auto b = written.add_placed(name + " b", written.add_body(name + " b", c.b.vertices()), c.pose_b.affine());
      placed.push_back({a, b});
    }
    for (std::size_t k = 0; k < cases.size(); ++k) {
      const tests::PairCase& c = cases[k];
      const auto [a, b] = placed[k];
      const auto distance = solid::polyhedron_polyhedron_distance(c.a, c.pose_a, c.b, c.pose_b);
      written.add_pair(a, b, solid::polyhedron_polyhedron(c.a, c.pose_a, c.b, c.pose_b).evidence);
      meets += distance.meet();
      if (distance.meet()) continue;
      const auto [of_a, of_b] = solid::closest_points(*closest_of(distance));
      written.add_distance(a, b, of_a, of_b);
      const double least = distance_of(distance).low;
      if (least > 0) written.add_clearance(a, b, least, way_between(of_a, of_b));
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
