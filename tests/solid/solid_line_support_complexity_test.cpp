// Counted probes of planes of support through lines, on every family of hard bodies, of 2^4 to 2^13 vertices,
// some of them and in soaks all of 2^17. Lemma 12:
// at most a constant times the logarithm of the edges at a vertex. Of lines that miss the body: at most a constant
// times log2 n down the hierarchy, and over the vertex graph beyond what polyhedron_line takes; by drums times log2^2 n
// and the steps of an access beyond what polyhedron_line_by_drums takes.
#include <tests/support/doubles.h>
#include <tests/support/scale.h>
#include <tests/support/shapes.h>
#include <tests/support/solid_shapes.h>

#include <sunder/base/random.h>
#include <sunder/solid/line/polyhedron_line.h>
#include <sunder/solid/line/polyhedron_line_support.h>
#include <sunder/solid/represent/drums.h>
#include <sunder/solid/represent/of.h>

#include <gtest/gtest.h>

#include <algorithm>
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
using solid::Line;
using solid::LineSupport;
using solid::Pose;

class SupportRatios {
 public:
  // As DrumRatios of solid_drums_complexity_test.cpp.
  SupportRatios(std::string_view question, double most) : question_(question), bound_(most) {}

  void add(std::string_view what, std::size_t n, double of, const LineSupport& answer, std::uint64_t besides) {
    ++all_;
    if (answer.decided_by == DecidedBy::finishing) {
      ++finished_;
      return;
    }
    const double ratio = static_cast<double>(answer.cost.probes - besides) / of;
    EXPECT_LE(ratio, n >= 1000 ? bound_ : 2 * bound_) << question_ << " " << what << " " << n;
    greatest_of_row_ = std::max(greatest_of_row_, ratio);
    greatest_ = std::max(greatest_, ratio);
    if (n >= 1000 && n <= 1100) at_a_thousand_ = std::max(at_a_thousand_, ratio);
  }
  double take_greatest_of_row() { return std::exchange(greatest_of_row_, 0); }
  void expect_no_growth(bool is_of_many) const {
    std::printf("%.*s: greatest %.2f, at n = 1,000 %.2f; %d, %d finished\n", static_cast<int>(question_.size()),
                question_.data(), greatest_, at_a_thousand_, all_, finished_);
    if (is_of_many) {
      EXPECT_LE(bound_, 1.5 * at_a_thousand_) << question_;
    }
    EXPECT_LE(finished_, all_ / 15) << question_;
  }

 private:
  std::string_view question_;
  double bound_;
  double greatest_ = 0, at_a_thousand_ = 0, greatest_of_row_ = 0;
  int all_ = 0, finished_ = 0;
};

TEST(SolidLineSupportComplexity, ProbesGrowAsPowersOfTheLogarithm) {
  const std::uint64_t seed = chosen_seed(20261129);
  SCOPED_TRACE("seed " + std::to_string(seed));
  Random random(seed);
  SupportRatios graph("over the graph", 140), hierarchy("by the hierarchy", 215), drums("by drums", 16);
  std::printf("%-14s %7s %9s %9s %9s\n", "family", "n", "graph", "hierarchy", "drums");
  for (const SolidShape& shape : all_solid_shapes()) {
    for (const int power : {4, 7, 10, 13, 17}) {
      const bool is_hard = shape.name == "helix" || shape.name == "chain" || shape.name == "bipyramid";
      if (power == 17 && (scaled_count(10) < 10 || (scaled_count(10) == 10 && !is_hard))) continue;
      const int queries = scaled_count(power == 10 ? 600 : power < 10 ? 200 : 40, 40);
      const ConvexPolyhedron body(shape.make(std::size_t{1} << static_cast<unsigned>(power), random));
      const auto vertices = body.vertices();
      const std::size_t n = vertices.size();
      if (body.dimension() < 3 || n < 8) continue;
      const double log_n = std::log2(static_cast<double>(n));
      const double steps = solid::represent::of<solid::Drums>(body).steps_of_access();
      std::size_t most_edges = 0;
      for (std::uint32_t v = 0; v < n; ++v) most_edges = std::max(most_edges, body.neighbours(v).size());
      const auto [low, high] = body.box();
      const auto near = [&] {
        const auto between = [&](double a, double b) { return a + random.uniform(-0.3, 1.3) * (b - a); };
        return Point3{between(low.x, high.x), between(low.y, high.y), between(low.z, high.z)};
      };
      for (int i = 0; i < queries; ++i) {
        // Near the body, or beside it; through a vertex, the same moved by some bits, or any.
        Point3 a = i % 3 == 0 ? near() : vertices[random.below(n)], b = near();
        if (i % 3 == 2) a[random.below(3)] = moved_by_bits(a[random.below(3)], random.between(-2, 2));
        if (i % 4 == 1) {
          b = {a.x + (high.x - low.x) * random.uniform(-1, 1), a.y + (high.y - low.y) * random.uniform(-1, 1), a.z};
        }
        if (a == b) continue;
        const Line line = Line::through(a, b);
        const LineSupport found = polyhedron_line_support(body, Pose(), line);
        const std::uint64_t of_cut = polyhedron_line(body, Pose(), line).cost.probes;
        if (found.meet()) {
          EXPECT_LE(static_cast<double>(found.cost.probes - of_cut),
                    6 * std::log2(static_cast<double>(most_edges)) + 16);
          continue;
        }
        graph.add(shape.name, n, log_n, found, of_cut);
        hierarchy.add(shape.name, n, log_n, polyhedron_line_support_by_hierarchy(body, Pose(), line), 0);
        drums.add(shape.name, n, log_n * log_n * steps, polyhedron_line_support_by_drums(body, Pose(), line),
                  polyhedron_line_by_drums(body, Pose(), line).cost.probes);
      }
      std::printf("%-14.*s %7zu %9.2f %9.2f %9.2f\n", static_cast<int>(shape.name.size()), shape.name.data(), n,
                  graph.take_greatest_of_row(), hierarchy.take_greatest_of_row(), drums.take_greatest_of_row());
    }
  }
  const bool is_of_many = scaled_count(200) >= 200;
  for (const SupportRatios* ratios : {&graph, &hierarchy, &drums}) ratios->expect_no_growth(is_of_many);
}

// Lines through the two hubs of bipyramids, each a vertex of half of the edges there are.
TEST(SolidLineSupportComplexity, Lemma12TakesTheLogarithmOfTheDegree) {
  const std::uint64_t seed = chosen_seed(20261130);
  SCOPED_TRACE("seed " + std::to_string(seed));
  Random random(seed);
  for (int power = 3; power <= 17; ++power) {
    const ConvexPolyhedron body(solid_shapes::bipyramid(std::size_t{1} << static_cast<unsigned>(power)));
    std::uint32_t hub = 0;
    for (std::uint32_t v = 0; v < body.vertices().size(); ++v) {
      if (body.neighbours(v).size() > body.neighbours(hub).size()) hub = v;
    }
    const double log_k = std::log2(static_cast<double>(body.neighbours(hub).size()));
    const Point3& p = body.vertices()[hub];
    std::uint64_t most = 0;
    for (int i = scaled_count(200, 20); i > 0; --i) {
      const double t = random.uniform(0, 6.3);
      Point3 q{p.x + std::cos(t), p.y + std::sin(t), p.z};
      if (i % 2 == 0) q.z += random.uniform(-1e-3, 1e-3);
      const LineSupport found =
          planes_of_support_at(body, Pose(), Line::through(p, q), {solid::CutPlace::vertex, hub, 0});
      ASSERT_EQ(found.evidence.index(), 1u);
      if (power <= 10) {
        const LineSupport scan = polyhedron_line_support_by_scan(body, Pose(), Line::through(p, q));
        ASSERT_EQ(scan.evidence.index(), 1u);
        const auto planes = planes_of(found.evidence), others = planes_of(scan.evidence);
        for (std::size_t k = 0; k < 2; ++k) EXPECT_EQ(planes[k].touches, others[k].touches);
      }
      most = std::max(most, found.cost.probes);
    }
    EXPECT_LE(static_cast<double>(most), 6 * log_k + 16) << power;
    std::printf("%7zu edges: %llu signs\n", body.neighbours(hub).size(), static_cast<unsigned long long>(most));
  }
}

}  // namespace
}  // namespace sunder::tests
