// Writes a sample of certificate files of polytopes of two to six dimensions, for checkers other than the library's:
// polytope_certificate_sample FOLDER COUNT [SEED]. A file a pair: of all families of points in turn, and every third
// pair with half-spaces; by the front door and by trees in turn, and those apart by trees by several hyperplanes. The
// last line printed says how many.
#include <sunder/polytope/pair/hyperplanes.h>
#include <sunder/polytope/pair/polytope_claims.h>
#include <tests/support/polytope_pairs.h>

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>

int main(int argc, char** argv) {
  using namespace sunder;
  if (argc < 3) {
    std::fprintf(stderr, "usage: polytope_certificate_sample FOLDER COUNT [SEED]\n");
    return 2;
  }
  const std::filesystem::path folder = argv[1];
  const int count = std::atoi(argv[2]);
  tests::PolytopePairs pairs(argc > 3 ? std::strtoull(argv[3], nullptr, 10) : 1);
  std::filesystem::create_directories(folder);
  int meets = 0, by_hyperplanes = 0;
  for (int i = 0; i < count; ++i) {
    const tests::PolytopePair c = i % 3 == 0 ? pairs.next_of_half_spaces() : pairs.next();
    const std::string name(tests::name_of(c.family));
    const polytope::NamedPolytope a{name + " a", c.a, c.pose_a}, b{name + " b", c.b, c.pose_b};
    std::ofstream file(folder / ("polytopes_" + std::to_string(i) + ".json"), std::ios::binary);
    ClaimsWriter claims([&](std::string_view text) { file << text; });
    if (i % 2 == 0) {
      const polytope::PolytopeAnswer answer = polytope_polytope(c.a, c.pose_a, c.b, c.pose_b);
      meets += answer.meet();
      add_claims(claims, a, b, answer);
    } else {
      const polytope::HierarchicalTree tree_a = tests::small_tree(c.a), tree_b = tests::small_tree(c.b);
      const polytope::PolytopeAnswer answer = polytope_polytope_by_columns(tree_a, c.pose_a, tree_b, c.pose_b);
      meets += answer.meet();
      if (answer.meet()) {
        add_claims(claims, a, b, answer);
      } else {
        add_claims(claims, a, b, parting_hyperplanes(tree_a, c.pose_a, tree_b, c.pose_b, answer));
        ++by_hyperplanes;
      }
    }
    claims.end();
    if (!file.flush()) {
      std::fprintf(stderr, "%s: cannot be written\n", folder.c_str());
      return 2;
    }
  }
  std::printf("%d certificates of polytopes: %d meet, %d are apart by several hyperplanes\n", count, meets,
              by_hyperplanes);
}
