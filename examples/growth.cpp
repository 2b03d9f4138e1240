// How the cost of the papers' methods grows: makes inputs of 2^3, 2^4, .. vertices, segments or half-planes, and draws
// the probes (or signs, or comparisons) that a question takes, beside what the theorem says, up to a constant.
//
//   example_growth [METHOD [MOST]]     all methods, unless one is named; up to 2^MOST (default 12)
#include <sunder/base/random.h>
#include <sunder/planar/object/convex_polygon.h>
#include <sunder/planar/pair/polygon_polygon.h>
#include <sunder/planar/region/half_plane_intersection.h>
#include <sunder/planar/segments/segments_any.h>
#include <sunder/solid/pair/polyhedron_polyhedron.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <functional>
#include <iostream>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

namespace {

using sunder::Point2;
using sunder::Point3;
using sunder::Random;

constexpr int queries = 20;  // of pairs, whose mean is told

std::vector<Point2> circle_points(int n) {
  std::vector<Point2> points;
  for (int k = 0; k < n; ++k) {
    const double turn = 2 * std::numbers::pi * (k + 0.5) / n;
    points.push_back({std::cos(turn), std::sin(turn)});
  }
  return points;
}

std::vector<Point3> sphere_points(int n, Random& random) {
  std::vector<Point3> points;
  while (points.size() < static_cast<std::size_t>(n)) {
    const Point3 p{random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)};
    const double length = std::hypot(p.x, p.y, p.z);
    if (length > 0.1 && length < 1) points.push_back({p.x / length, p.y / length, p.z / length});
  }
  return points;
}

// Two of n vertices each, nearly touching: half of the pairs meet.
template <class Method>
double of_polygons(int n, Method method) {
  Random random(1);
  const auto body = sunder::planar::ConvexPolygon::hull_of(circle_points(n));
  std::uint64_t probes = 0;
  for (int k = 0; k < queries; ++k) {
    const double turn = random.uniform(0, 6), at = k % 2 == 0 ? 2.001 : 1.999;
    const sunder::planar::Pose pose = sunder::planar::Pose::from_angle(0, {at * std::cos(turn), at * std::sin(turn)});
    probes += method(body, {}, body, pose).cost.probes;
  }
  return static_cast<double>(probes) / queries;
}

template <class Method>
double of_bodies(int n, Method method) {
  Random random(1);
  const sunder::solid::ConvexPolyhedron a(sphere_points(n, random)), b(sphere_points(n, random));
  std::uint64_t probes = 0;
  for (int k = 0; k < queries; ++k) {
    const double turn = random.uniform(0, 6), at = k % 2 == 0 ? 1.999 : 1.9;
    const auto pose = sunder::solid::Pose::from_quaternion(1, 0, 0, 0, {at * std::cos(turn), at * std::sin(turn), 0});
    probes += method(a, {}, b, pose).cost.probes;
  }
  return static_cast<double>(probes) / queries;
}

double of_segments(int n) {  // slanted, one above the other: none meet
  Random random(1);
  std::vector<sunder::planar::Segment> segments;
  for (int k = 0; k < n; ++k) {
    const double x = random.uniform(0, n), y = 2.0 * k;
    segments.push_back({{x, y}, {x + random.uniform(0, n), y + 1}});
  }
  return static_cast<double>(segments_any_by_sweep(sunder::planar::Segments(segments)).cost.probes);
}

double of_half_planes(int n) {  // tangents of a circle, in any order
  Random random(1);
  std::vector<sunder::Constraint> given;
  for (const Point2& p : circle_points(n)) given.push_back({p.x, p.y, 1});
  for (std::size_t k = given.size(); k > 1; --k) std::swap(given[k - 1], given[random.below(k)]);
  return static_cast<double>(half_plane_intersection_by_division(sunder::planar::Constraints(given)).cost.probes);
}

double log_of(double n) { return std::log2(n); }

struct Method {
  std::string name, theorem, bound;
  std::function<double(int)> ask;
  std::function<double(double)> grows_as;
};

const std::vector<Method>& methods() {
  namespace planar = sunder::planar;
  namespace solid = sunder::solid;
  static const std::vector<Method> all{
      {"sweep", "Shamos and Hoey, Theorem 3", "n log n", of_segments, [](double n) { return n * log_of(n); }},
      {"division", "Shamos and Hoey, Theorem 9", "n log n", of_half_planes, [](double n) { return n * log_of(n); }},
      {"halving", "Chazelle and Dobkin, Theorem 4", "log n",
       [](int n) { return of_polygons(n, planar::polygon_polygon_by_halving); }, log_of},
      {"drums", "Chazelle and Dobkin, Theorem 13", "log^3 n",
       [](int n) { return of_bodies(n, solid::polyhedron_polyhedron_by_drums); },
       [](double n) { return std::pow(log_of(n), 3); }},
      {"triangles", "Barba and Langerman, Theorem 2.1", "log n",
       [](int n) { return of_polygons(n, planar::polygon_polygon_by_triangles); }, log_of},
      {"hierarchy", "Barba and Langerman, section 4", "log^2 n",
       [](int n) { return of_bodies(n, solid::polyhedron_polyhedron_by_hierarchy); },
       [](double n) { return log_of(n) * log_of(n); }},
      {"bounded", "Barba and Langerman, Lemma 4.1", "log n",
       [](int n) { return of_bodies(n, solid::polyhedron_polyhedron_by_bounded); }, log_of},
      {"polar", "Barba and Langerman, Theorem 5.1", "log n",
       [](int n) { return of_bodies(n, solid::polyhedron_polyhedron_by_polar); }, log_of}};
  return all;
}

void draw(const Method& method, int most) {
  std::vector<double> counts;
  for (int power = 3; power <= most; ++power) counts.push_back(method.ask(1 << power));
  double greatest = 1;
  for (const double count : counts) greatest = std::max(greatest, count);
  std::cout << method.name << " (" << method.theorem << ")\n";
  for (int power = 3; power <= most; ++power) {
    const double n = std::ldexp(1, power), count = counts[static_cast<std::size_t>(power - 3)];
    const auto text = [](double x) { return std::to_string(std::lround(x)); };
    const std::string ratio = std::to_string(count / method.grows_as(n)).substr(0, 5);
    std::cout << "  2^" << power << '\t' << text(count) << '\t' << ratio << " times " << method.bound << '\t'
              << std::string(static_cast<std::size_t>(40 * count / greatest), '#') << '\n';
  }
}

}  // namespace

int main(int count, char** words) {
  const std::string name = count > 1 ? words[1] : "";
  const int most = count > 2 ? std::atoi(words[2]) : 12;
  if (most < 3 || most > 20) {
    std::cerr << "MOST is 3 to 20\n";
    return 2;
  }
  bool is_known = false;
  for (const Method& method : methods()) {
    if (!name.empty() && name != method.name) continue;
    is_known = true;
    draw(method, most);
  }
  if (is_known) return 0;
  std::cerr << "there is no method " << name << "; give one of";
  for (const Method& method : methods()) std::cerr << ' ' << method.name;
  std::cerr << '\n';
  return 2;
}
