// Counted probes of polyhedron_line on every family of hard bodies: at most a constant times log2^2 n.
#include <tests/support/scale.h>
#include <tests/support/shapes.h>
#include <tests/support/solid_shapes.h>

#include <sunder/base/random.h>
#include <sunder/solid/line/polyhedron_line.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>

namespace sunder::tests {
namespace {

// Small bodies pay for the tries of all searches.
constexpr double bound = 40, bound_of_large = 22;  // from 2^10 vertices on

class Probes {
 public:
  void add(const std::string& what, const solid::ConvexPolyhedron& body, const solid::Pose& pose,
           const solid::Line& line) {
    const solid::PolyhedronCut cut = polyhedron_line(body, pose, line);
    const double log = std::log2(static_cast<double>(body.vertices().size()));
    const double ratio = static_cast<double>(cut.cost.probes) / (log * log);
    ++(cut.meet() ? meet_ : apart_);
    if (cut.decided_by == DecidedBy::finishing) {  // as many steps more, with exact signs
      ++finished_;
      return;
    }
    const bool is_large = body.vertices().size() >= 1000;
    if (is_large) greatest_of_large_ = std::max(greatest_of_large_, ratio);
    EXPECT_LE(ratio, is_large ? bound_of_large : bound) << what << " n = " << body.vertices().size();
    if (ratio <= greatest_) return;
    greatest_ = ratio;
    std::printf("%-14s n %6zu  probes %6llu  steps %3u  ratio %.2f  %s\n", what.c_str(), body.vertices().size(),
                static_cast<unsigned long long>(cut.cost.probes), cut.cost.iterations, ratio,  // NOLINT: for printf
                std::string(name_of(cut.decided_by)).c_str());
  }
  int meet() const { return meet_; }
  int apart() const { return apart_; }
  int finished() const { return finished_; }
  double greatest() const { return greatest_; }
  double greatest_of_large() const { return greatest_of_large_; }

 private:
  double greatest_ = 0, greatest_of_large_ = 0;
  int meet_ = 0, apart_ = 0, finished_ = 0;
};

TEST(SolidLineComplexity, ProbesGrowAsLogSquare) {
  const int most_power = std::min(17, scaled_count(17, 12)), count = scaled_count(60, 20);
  Random random(chosen_seed(20261125));
  Probes probes;
  for (const SolidShape& shape : all_solid_shapes()) {
    for (int power = 4; power <= most_power; ++power) {
      const solid::ConvexPolyhedron body(shape.make(std::size_t{1} << static_cast<unsigned>(power), random));
      const auto vertices = body.vertices();
      const auto some = [&] { return vertices[random.below(vertices.size())]; };
      const auto [low, high] = body.box();
      const auto inside = [&](const Point3& from, const Point3& to) {
        const double s = random.uniform(-0.25, 1.25), t = random.uniform(-0.25, 1.25), u = random.uniform(-0.25, 1.25);
        return Point3{from.x + s * (to.x - from.x), from.y + t * (to.y - from.y), from.z + u * (to.z - from.z)};
      };
      for (int i = 0; i < count; ++i) {
        // Near the box; through vertices; close to one, where the surface is.
        const Point3 v = some();
        const Point3 a = i % 3 == 0 ? inside(low, high) : v;
        const Point3 b = i % 3 == 1 ? some() : inside(low, high);
        if (a == b) continue;
        probes.add(std::string(shape.name), body, solid::Pose(), solid::Line::through(a, b));
      }
    }
  }
  std::printf("greatest %.2f, of large bodies %.2f; %d apart, %d meet, %d finished\n", probes.greatest(),
              probes.greatest_of_large(), probes.apart(), probes.meet(), probes.finished());
  EXPECT_LE(probes.finished(), (probes.apart() + probes.meet()) / 20);
  EXPECT_GT(probes.apart(), probes.meet() / 10);
  EXPECT_GT(probes.meet(), probes.apart() / 10);
}

}  // namespace
}  // namespace sunder::tests
