// Writes a sample of certificate files about circles, half-planes, linear programs and polygons, for checkers other
// than the library's: sets_certificate_sample FOLDER COUNT [SEED]. COUNT files in all, the questions in turn.
#include <sunder/base/random.h>
#include <sunder/planar/region/disc_intersection_json.h>
#include <sunder/planar/region/half_plane_intersection.h>
#include <sunder/planar/region/linear_program_json.h>
#include <sunder/planar/region/regions_json.h>
#include <sunder/planar/set/convex_polygons_any_json.h>
#include <sunder/planar/set/discs_any_json.h>
#include <sunder/planar/set/polygon_simple.h>
#include <sunder/planar/set/polygons_json.h>

#include <array>
#include <cmath>
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
using Rings = std::vector<std::vector<Point2>>;

// Whole numbers, so that touching, parallel and concurrent things are common; or doubles of any scale.
class Numbers {
 public:
  explicit Numbers(std::uint64_t seed) : random_(seed) {}

  void next() {
    size_ = 1 + static_cast<int>(random_.below(8));
    kind_ = random_.below(4);
    scale_ = std::ldexp(1.0, static_cast<int>(random_.below(1800)) - 1000);
  }
  double whole() { return static_cast<double>(random_.below(2 * static_cast<std::uint64_t>(size_) + 1)) - size_; }
  double number() {
    if (kind_ == 0) return random_.uniform(-1, 1);
    if (kind_ == 1) return whole() * scale_;
    return whole();
  }
  std::uint64_t below(std::uint64_t n) { return random_.below(n); }

 private:
  Random random_;
  int size_ = 1;
  std::uint64_t kind_ = 0;
  double scale_ = 1;
};

std::vector<Disc> some_circles(Numbers& numbers, std::uint64_t most, std::uint64_t divisor) {
  numbers.next();
  const std::uint64_t count = 1 + numbers.below(most);
  std::vector<Disc> circles;
  while (circles.size() < count) {
    const double x = numbers.number(), y = numbers.number(), r = numbers.number();
    circles.push_back({{x, y}, std::fabs(r) / static_cast<double>(divisor)});
  }
  return circles;
}

std::vector<Constraint> some_constraints(Numbers& numbers) {
  numbers.next();
  const std::uint64_t count = numbers.below(12);
  const bool around = numbers.below(3) > 0;  // the origin is common
  std::vector<Constraint> all;
  while (all.size() < count) {
    if (!all.empty() && numbers.below(5) == 0) {  // an opposite one, often of the same line
      const Constraint h = all[numbers.below(all.size())];
      all.push_back({-h.a, -h.b, numbers.below(3) == 0 ? h.c : -h.c});
      continue;
    }
    const double a = numbers.number(), b = numbers.number(), c = numbers.number();
    if (a != 0 || b != 0) all.push_back({a, b, around ? std::fabs(c) : c});
  }
  return all;
}

std::vector<HalfPlane> some_arrows(Numbers& numbers) {
  numbers.next();
  const std::uint64_t count = numbers.below(12);
  std::vector<HalfPlane> all;
  while (all.size() < count) {
    const double ax = numbers.number(), ay = numbers.number(), bx = numbers.number(), by = numbers.number();
    if (ax != bx || ay != by) all.push_back(HalfPlane::left_of({ax, ay}, {bx, by}));
  }
  return all;
}

template <class Given>
std::string region_text(const Given& given) {
  return certificate_text(given, half_plane_intersection(given, {true}));
}

template <class Given>
std::string program_text(const Given& given, const Objective& objective) {
  return certificate_text(given, objective, linear_program(given, objective));
}

std::vector<ConvexPolygon> some_polygons(Numbers& numbers) {
  numbers.next();
  const std::uint64_t count = 1 + numbers.below(8);
  const double divisor = static_cast<double>(1 + numbers.below(8));
  std::vector<ConvexPolygon> all;
  while (all.size() < count) {
    const double x = numbers.number(), y = numbers.number();
    std::vector<Point2> points{{x, y}};
    for (std::uint64_t k = numbers.below(6); k > 0; --k) {
      const double dx = numbers.number(), dy = numbers.number();
      points.push_back({x + dx / divisor, y + dy / divisor});
    }
    all.push_back(ConvexPolygon::hull_of(points));
  }
  return all;
}

// Simple ones; of whole numbers half are cells of a grid, which have borders in common, and a few have a hole.
std::vector<Polygon> some_simple_polygons(Numbers& numbers) {
  numbers.next();
  const std::uint64_t count = 1 + numbers.below(8);
  const double divisor = static_cast<double>(2 + numbers.below(6));
  std::vector<Polygon> all;
  while (all.size() < count) {
    double x = numbers.number(), y = numbers.number();
    std::vector<Point2> ring;
    if (numbers.below(2) == 0) {
      x = numbers.whole();
      y = numbers.whole();
      ring = {{x, y}, {x + 1, y}, {x + 1, y + 1}, {x, y + 1}};
    } else {
      for (std::uint64_t k = 3 + numbers.below(4); k > 0; --k) {
        const double dx = numbers.number(), dy = numbers.number();
        ring.push_back({x + dx / divisor, y + dy / divisor});
      }
    }
    Rings rings{ring};
    if (numbers.below(4) == 0 && y + 0.25 != y + 0.75)
      rings.push_back({{x + 0.25, y + 0.25}, {x + 0.5, y + 0.25}, {x + 0.25, y + 0.75}});
    if (ring.front() == ring.back()) continue;
    const Polygon polygon(rings);
    if (polygon_simple(polygon).simple()) all.push_back(polygon);
  }
  return all;
}

std::string some_text(Numbers& numbers, int question) {
  if (question == 5) {  // few, so that they have something in common often enough
    std::vector<ConvexPolygon> polygons = some_polygons(numbers);
    const std::size_t most = 1 + numbers.below(3);
    while (polygons.size() > most) polygons.pop_back();
    return certificate_text(polygons);
  }
  if (question == 6) {
    const std::vector<Polygon> polygons = some_simple_polygons(numbers);
    const Allowed allowed = std::array{Allowed::nothing, Allowed::shared_endpoint, Allowed::touch}[numbers.below(3)];
    return certificate_text(polygons, allowed, polygons_any(polygons, {allowed, {}, nullptr}));
  }
  if (question == 4) {
    const std::vector<ConvexPolygon> polygons = some_polygons(numbers);
    const Allowed allowed = numbers.below(2) == 0 ? Allowed::nothing : Allowed::touch;
    return certificate_text(polygons, allowed, convex_polygons_any(polygons, {.allowed = allowed}));
  }
  if (question == 0) {
    const std::uint64_t divisor = 1 + numbers.below(6);
    const Discs circles(some_circles(numbers, 12, divisor));
    const Allowed allowed = numbers.below(2) == 0 ? Allowed::nothing : Allowed::touch;
    std::vector<std::uint32_t> groups;
    if (numbers.below(2) == 0) {
      for (std::uint32_t i = 0; i < circles.size(); ++i) groups.push_back(static_cast<std::uint32_t>(numbers.below(3)));
    }
    const SetOptions options{allowed, groups, nullptr};
    const std::uint64_t asked = numbers.below(3);
    if (asked == 0) return certificate_text(circles, allowed, discs_all(circles, options), groups);
    if (asked == 1) return certificate_text(circles, allowed, discs_count(circles, options), groups);
    return certificate_text(circles, allowed, discs_any(circles, options), groups);
  }
  if (question == 1) {
    const Discs circles(some_circles(numbers, 4, 1));
    return certificate_text(circles, disc_intersection(circles));
  }
  const bool is_region = question == 2;
  const bool of_arrows = numbers.below(3) == 0;
  const std::vector<HalfPlane> arrows = some_arrows(numbers);
  const Constraints constraints(some_constraints(numbers));
  const double p = numbers.whole(), q = numbers.whole();
  if (of_arrows) return is_region ? region_text(HalfPlanes(arrows)) : program_text(HalfPlanes(arrows), {p, q});
  return is_region ? region_text(constraints) : program_text(constraints, {p, q});
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
  Numbers numbers(argc > 3 ? std::strtoull(argv[3], nullptr, 10) : 1);
  std::filesystem::create_directories(folder);
  std::map<std::string, int> verdicts;
  for (int i = 0; i < count; ++i) {
    const std::string text = some_text(numbers, i % 7);
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
