// Counted probes of what goes by drums, on every family of hard bodies, of 2^4 to 2^17 vertices: at most a constant
// times log2^2 n of a plane (IHP) and a line (IHL), times the steps of an access to a drum's edge: 1 in lists, at most
// 2 log2 n in the persistent form. Flat polygons, which need no drums; and the space that either form takes. Of two
// objects: solid_pair_by_drums_complexity_test.cpp.
#include <tests/support/scale.h>
#include <tests/support/shapes.h>
#include <tests/support/solid_shapes.h>

#include <sunder/base/random.h>
#include <sunder/solid/line/polyhedron_line.h>
#include <sunder/solid/pair/polyhedron_polyhedron.h>
#include <sunder/solid/represent/drums.h>
#include <sunder/solid/represent/of.h>
#include <sunder/solid/section/polyhedron_plane.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace sunder::tests {
namespace {

using solid::ConvexPolyhedron;
using solid::Pose;

class DrumRatios {
 public:
  // At most `bound` for a thousand vertices and more, which is at most 1.5 times the greatest ratio of bodies of about
  // 1,000; twice that for smaller ones.
  DrumRatios(std::string_view question, double bound) : question_(question), bound_(bound) {}

  template <class Answer>
  void add(std::string_view what, std::size_t n, double of, const Answer& answer) {
    ++(answer.meet() ? meet_ : apart_);
    if (answer.decided_by == DecidedBy::finishing) {  // an exact walk more, or exact pivots
      ++finished_;
      return;
    }
    const double ratio = static_cast<double>(answer.cost.probes) / of;
    EXPECT_LE(ratio, n >= 1000 ? bound_ : 2 * bound_) << question_ << " " << what << " " << n;
    greatest_of_row_ = std::max(greatest_of_row_, ratio);
    greatest_ = std::max(greatest_, ratio);
    if (n >= 1000 && n <= 1100) at_a_thousand_ = std::max(at_a_thousand_, ratio);
  }
  double take_greatest_of_row() { return std::exchange(greatest_of_row_, 0); }
  void expect_no_growth(bool is_of_many, int part) const {
    std::printf("%.*s: greatest %.2f, at n = 1,000 %.2f; %d apart, %d meet, %d finished\n",
                static_cast<int>(question_.size()), question_.data(), greatest_, at_a_thousand_, apart_, meet_,
                finished_);
    if (is_of_many) {
      EXPECT_LE(bound_, 1.5 * at_a_thousand_) << question_;
    }
    EXPECT_LE(finished_, (apart_ + meet_) / part) << question_;
    EXPECT_GT(apart_, meet_ / 10) << question_;
    EXPECT_GT(meet_, apart_ / 10) << question_;
  }

 private:
  std::string_view question_;
  double bound_;
  double greatest_ = 0, at_a_thousand_ = 0, greatest_of_row_ = 0;
  int meet_ = 0, apart_ = 0, finished_ = 0;
};

ConvexPolyhedron flat_polygon(std::size_t n) {
  std::vector<Point3> points;
  for (std::size_t k = 0; k < n; ++k) {
    const Point2 p = on_circle(static_cast<double>(k) / static_cast<double>(n));
    points.push_back({p.x, p.y, 0});
  }
  return ConvexPolyhedron(points);
}

TEST(SolidDrumsComplexity, ProbesGrowAsPowersOfTheLogarithm) {
  const std::uint64_t seed = chosen_seed(20261128);
  SCOPED_TRACE("seed " + std::to_string(seed));
  Random random(seed);
  DrumRatios plane("plane", 2), line("line", 45);
  std::printf("%-14s %7s %9s %9s\n", "family", "n", "plane", "line");
  for (const SolidShape& shape : all_solid_shapes()) {
    for (int power = 4; power <= (scaled_count(10) < 10 ? 12 : 17); ++power) {
      const int queries = scaled_count(power <= 10 ? 200 : 20, 20);
      const ConvexPolyhedron body(shape.make(std::size_t{1} << static_cast<unsigned>(power), random));
      const auto vertices = body.vertices();
      const std::size_t n = vertices.size();
      const double log_n = std::log2(static_cast<double>(n));
      if (n < 8) continue;
      const std::uint32_t steps = solid::represent::of<solid::Drums>(body).steps_of_access();
      EXPECT_LE(steps, 2 * log_n);
      const double of = log_n * log_n * steps;
      const auto [low, high] = body.box();
      const auto near = [&] {
        const auto between = [&](double a, double b) { return a + random.uniform(-0.3, 1.3) * (b - a); };
        return Point3{between(low.x, high.x), between(low.y, high.y), between(low.z, high.z)};
      };
      const auto some = [&](int i) { return i % 3 == 0 ? vertices[random.below(n)] : near(); };
      const Point3 size{high.x - low.x, high.y - low.y, high.z - low.z};
      const auto across = [](double s) { return s > 0 ? 1 / s : 1; };
      for (int i = 0; i < queries; ++i) {
        const Point3 normal{random.uniform(-1, 1) * across(size.x), random.uniform(-1, 1) * across(size.y),
                            random.uniform(-1, 1) * across(size.z)};
        const auto answer = polyhedron_plane_by_drums(body, Pose(), solid::Plane::through(some(i), normal));
        plane.add(shape.name, n, of, answer);
        if (body.dimension() < 3) continue;  // lines and polygons of others are not searched for
        const Point3 a = some(i), b = some(i / 3);
        if (a != b) {
          line.add(shape.name, n, of, polyhedron_line_by_drums(body, Pose(), solid::Line::through(a, b)));
        }
      }
      std::printf("%-14.*s %7zu %9.2f %9.2f\n", static_cast<int>(shape.name.size()), shape.name.data(), n,
                  plane.take_greatest_of_row(), line.take_greatest_of_row());
    }
  }
  const bool is_of_many = scaled_count(200) >= 200;
  plane.expect_no_growth(is_of_many, 1000);
  line.expect_no_growth(is_of_many, 20);
}

// The rest of the paper's Figure 1, which needs no drums: flat polygons of space against a plane, a line (through the
// polygon's plane, and in it) and each other (crossing, and in one plane), against the sum of logarithms. Below 64
// vertices searches look at all.
TEST(SolidDrumsComplexity, ProbesOfFlatPolygonsGrowAsTheLogarithm) {
  const std::uint64_t seed = chosen_seed(20261131);
  SCOPED_TRACE("seed " + std::to_string(seed));
  Random random(seed);
  DrumRatios plane("flat and plane", 6), line("flat and line", 2.4), in_plane("flat and line in its plane", 14),
      polygons("flat and flat", 24);
  std::printf("%-14s %7s %9s %9s %9s %9s\n", "family", "n", "flats", "line", "in plane", "flat");
  for (int power = 6; power <= 17; ++power) {
    const ConvexPolyhedron polygon = flat_polygon(std::size_t{1} << static_cast<unsigned>(power));
    const std::size_t n = polygon.vertices().size();
    const double log_n = std::log2(static_cast<double>(n));
    const auto number = [&] { return random.uniform(-1.2, 1.2); };
    for (int i = scaled_count(power <= 10 ? 1600 : 480, 20); i > 0; --i) {
      const Pose pose = Pose::from_quaternion(number(), number(), number(), 1.3, {number(), number(), number()});
      const Point3 a{number(), number(), number()}, b{number(), number(), number()};
      plane.add("", n, log_n, polyhedron_plane(polygon, pose, solid::Plane::through({a.x, a.y, a.z}, b)));
      line.add("", n, log_n, polyhedron_line(polygon, Pose(), solid::Line::through(a, b)));
      in_plane.add("", n, log_n,
                   polyhedron_line(polygon, Pose(), solid::Line::through({a.x, 1.4 * a.y, 0}, {b.x, 1.4 * b.y, 0})));
      polygons.add("", n, 2 * log_n, polyhedron_polyhedron(polygon, Pose(), polygon, pose));
      const double w = number(), z = number();
      polygons.add(
          "", n, 2 * log_n,
          polyhedron_polyhedron(polygon, Pose(), polygon, Pose::from_quaternion(w, 0, 0, z, {2 * a.x, 2 * a.y, 0})));
    }
    std::printf("%-14s %7zu %9.2f %9.2f %9.2f %9.2f\n", "flat", n, plane.take_greatest_of_row(),
                line.take_greatest_of_row(), in_plane.take_greatest_of_row(), polygons.take_greatest_of_row());
  }
  const bool is_of_many = scaled_count(1600) >= 1600;
  for (const DrumRatios* ratios : {&plane, &line, &in_plane, &polygons}) ratios->expect_no_growth(is_of_many, 100);
}

// Bytes of both forms: of the listed one the entries of its lists, which grow faster than n log n on round bodies and
// are a quadratic number of some.
TEST(SolidDrumsComplexity, Space) {
  std::printf("%-14s %7s %14s %14s %12s\n", "family", "n", "persistent", "listed", "/ n log2 n");
  for (const SolidShape& shape : all_solid_shapes()) {
    for (const int power : {10, 13, 17}) {
      if (power == 17 && shape.name != "prism" && shape.name != "helix" &&
          (shape.name != "sphere" || scaled_count(10) <= 10)) {  // that of a sphere takes 600 MB, listed
        continue;
      }
      Random random(7);
      const ConvexPolyhedron body(shape.make(std::size_t{1} << static_cast<unsigned>(power), random));
      const auto n = static_cast<double>(body.vertices().size());
      const Point3 direction = solid::Drums::make(body).direction();
      const solid::Drums drums(body, direction, solid::DrumsForm::persistent);
      const auto persistent = static_cast<double>(drums.memory());
      EXPECT_LE(persistent, 64 * n * std::log2(n)) << shape.name;
      double listed = 0;  // 0: too long
      try {
        listed = static_cast<double>(solid::Drums(body, direction, solid::DrumsForm::listed).memory());
      } catch (const Error&) {
      }
      std::printf("%-14.*s %7.0f %14.0f %14.0f %12.1f\n", static_cast<int>(shape.name.size()), shape.name.data(), n,
                  persistent, listed, persistent / (n * std::log2(n)));
    }
  }
}

}  // namespace
}  // namespace sunder::tests
