// Writes a sample of certificate files of planar pairs: planar_certificate_sample FOLDER COUNT [SEED].
//
// Every family of tests/support/planar_pairs.h in turn but the large ones, the methods in turn, fifty pairs a file. The
// last line printed says how many.
#include <sunder/certificate/json.h>
#include <sunder/planar/pair/polygon_polygon.h>
#include <tests/support/planar_pairs.h>

#include <array>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

int main(int argc, char** argv) {
  using namespace sunder;
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
    CertificateWriter writer;
    for (int k = 0; k < 50 && i < count; ++k, ++i) {
      tests::PlanarCase c = pairs.next();
      while (c.family == tests::PlanarFamily::large) c = pairs.next();
      const PairAnswer answer = methods[static_cast<std::size_t>(i) % methods.size()](c.a, c.pose_a, c.b, c.pose_b);
      const std::string name = std::string(tests::name_of(c.family)) + " " + std::to_string(i);
      const auto add = [&](const char* letter, const planar::ConvexPolygon& polygon, const planar::Pose& pose) {
        std::vector<Point3> vertices;
        for (const Point2& p : polygon.vertices()) vertices.push_back({p.x, p.y, 0});
        return writer.add_placed(name + letter, writer.add_body(name + letter, vertices),
                                 planar::in_space(pose.affine()));
      };
      const auto a = add(" a", c.a, c.pose_a), b = add(" b", c.b, c.pose_b);
      writer.add_pair(a, b, answer.certificate());
      meets += answer.meet() ? 1 : 0;
    }
    std::ofstream file(folder / ("planar_" + std::to_string(files++) + ".json"), std::ios::binary);
    file << writer.text();
    if (!file.flush()) {
      std::fprintf(stderr, "%s: cannot be written\n", folder.c_str());
      return 2;
    }
  }
  std::printf("%d certificates in %d files, %d meet\n", count, files, meets);
  return 0;
}
