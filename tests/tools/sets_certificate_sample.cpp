// Writes a sample of certificate files about circles, half-planes, linear programs and polygons, for checkers other
// than the library's: sets_certificate_sample FOLDER COUNT [SEED]. COUNT files in all, the questions in turn.
#include <tests/support/convex_polygon_sets.h>
#include <tests/support/disc_sets.h>
#include <tests/support/half_plane_sets.h>
#include <tests/support/polygon_sets.h>

#include <sunder/base/error.h>
#include <sunder/base/random.h>
#include <sunder/planar/discs/discs_any_claims.h>
#include <sunder/planar/polygons/convex_polygons_any_claims.h>
#include <sunder/planar/polygons/polygons_claims.h>
#include <sunder/planar/region/disc_intersection_claims.h>
#include <sunder/planar/region/half_plane_intersection.h>
#include <sunder/planar/region/linear_program_claims.h>
#include <sunder/planar/region/regions_claims.h>

#include <array>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <string>
#include <vector>

namespace {

using namespace sunder;
using namespace sunder::planar;

template <class Given>
std::string region_text(const Given& given) {
  return certificate_text(given, half_plane_intersection(given, {true}));
}

template <class Given>
std::string program_text(const Given& given, const Objective& objective) {
  return certificate_text(given, objective, linear_program(given, objective));
}

struct Streams {
  explicit Streams(std::uint64_t seed)
      : random(seed), discs(seed), common_discs(seed), common_polygons(seed), polygons(seed), half_planes(seed) {}

  std::uint32_t below(std::size_t n) { return static_cast<std::uint32_t>(random.below(n)); }

  Random random;
  tests::DiscSets discs;
  tests::CommonDiscSets common_discs;
  tests::CommonConvexSets common_polygons;
  tests::PolygonSets polygons;
  tests::HalfPlaneSets half_planes;
};

std::string some_text(Streams& some, int question) {
  const Allowed touch = some.below(2) == 0 ? Allowed::nothing : Allowed::touch;
  if (question == 5) {
    const auto family = static_cast<tests::CommonConvexFamily>(some.below(tests::common_convex_family_count));
    return certificate_text(some.common_polygons.next(family));
  }
  if (question == 6) {
    const auto family = static_cast<tests::PolygonFamily>(some.below(tests::polygon_family_count));
    const std::vector<Polygon> polygons = tests::polygons_of(some.polygons.next(family));
    const Allowed allowed = std::array{Allowed::nothing, Allowed::shared_endpoint, Allowed::touch}[some.below(3)];
    return certificate_text(polygons, allowed, polygons_any(polygons, {allowed, {}, nullptr}));
  }
  if (question == 4) {
    const int family = static_cast<int>(some.below(tests::convex_family_count));
    const std::vector<ConvexPolygon> polygons = tests::some_convex_polygons(some.random, family);
    return certificate_text(polygons, touch, convex_polygons_any(polygons, {.allowed = touch}));
  }
  if (question == 0) {
    const Discs circles(some.discs.next());
    std::vector<std::uint32_t> groups;
    if (some.below(2) == 0) {
      for (std::uint32_t i = 0; i < circles.size(); ++i) groups.push_back(some.below(3));
    }
    const SetOptions options{touch, groups, nullptr};
    const std::uint32_t asked = some.below(3);
    if (asked == 0) return certificate_text(circles, touch, discs_all(circles, options), groups);
    if (asked == 1) return certificate_text(circles, touch, discs_count(circles, options), groups);
    return certificate_text(circles, touch, discs_any(circles, options), groups);
  }
  if (question == 1) {
    const auto family = static_cast<tests::CommonDiscFamily>(some.below(tests::common_disc_family_count));
    const Discs circles(some.common_discs.next(family));
    return certificate_text(circles, disc_intersection(circles));
  }
  const bool is_region = question == 2;
  const double p = static_cast<double>(some.random.between(-8, 8)), q = static_cast<double>(some.random.between(-8, 8));
  if (some.below(3) == 0) {
    const std::vector<HalfPlane> given = some.half_planes.arrows();  // of which HalfPlanes is a view
    const HalfPlanes arrows(given);
    return is_region ? region_text(arrows) : program_text(arrows, {p, q});
  }
  const Constraints constraints(some.half_planes.constraints());
  return is_region ? region_text(constraints) : program_text(constraints, {p, q});
}

// Of a set of nothing there is no certificate: the next one that has one.
std::string next_text(Streams& some, int question) {
  while (true) {
    try {
      return some_text(some, question);
    } catch (const Error&) {
    }
  }
}

std::string verdict_of(const std::string& text) {
  const std::string key = "\"verdict\": \"";
  const std::size_t begin = text.find(key) + key.size();
  return text.substr(begin, text.find('"', begin) - begin);
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 3) {
    std::fprintf(stderr, "usage: sets_certificate_sample FOLDER COUNT [SEED]\n");
    return 2;
  }
  const std::filesystem::path folder = argv[1];
  const int count = std::atoi(argv[2]);
  Streams streams(argc > 3 ? std::strtoull(argv[3], nullptr, 10) : 1);
  std::filesystem::create_directories(folder);
  std::map<std::string, int> verdicts;
  for (int i = 0; i < count; ++i) {
    const std::string text = next_text(streams, i % 7);
    ++verdicts[verdict_of(text)];
    std::ofstream file(folder / ("sets_" + std::to_string(i) + ".json"), std::ios::binary);
    file << text;
    if (!file.flush()) {
      std::fprintf(stderr, "%s: cannot be written\n", folder.c_str());
      return 2;
    }
  }
  std::printf("%d certificates of circles, half-planes, linear programs and polygons:", count);
  for (const auto& [verdict, times] : verdicts) std::printf(" %s %d", verdict.c_str(), times);
  std::printf("\n");
  return 0;
}
