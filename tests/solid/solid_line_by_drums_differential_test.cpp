// Lines, rays and segments against polyhedra by drums: against the scans, and how often its own proposals hold.
#include <tests/support/scale.h>
#include <tests/support/solid_lines.h>

#include <sunder/base/random.h>
#include <sunder/solid/line/polyhedron_line.h>
#include <sunder/solid/line/polyhedron_ray.h>
#include <sunder/solid/line/polyhedron_segment.h>
#include <sunder/solid/represent/drums.h>
#include <sunder/solid/represent/of.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <map>
#include <string>
#include <vector>

namespace sunder::tests {
namespace {

using solid::PolyhedronCut;

struct LineByDrumsTally {
  int cases = 0, meets = 0, finished = 0;
  std::uint64_t probes = 0;
};

void expect_same(const PolyhedronCut& found, const PolyhedronCut& scan) { ASSERT_TRUE(is_same_cut(found, scan)); }

TEST(SolidLineByDrumsDifferential, AgreesWithTheScans) {
  const int count = scaled_count(20000);
  const std::uint64_t seed = chosen_seed(20261126);
  SCOPED_TRACE("seed " + std::to_string(seed));
  SolidLines lines(seed);
  std::map<LineFamily, LineByDrumsTally> tallies;
  for (int i = 0; i < count; ++i) {
    const LineCase c = lines.next();
    SCOPED_TRACE(std::to_string(i) + " " + std::string(name_of(c.family)));
    const solid::Line line = solid::Line::through(c.a, c.b);
    const PolyhedronCut found = polyhedron_line_by_drums(c.body, c.pose, line);
    expect_same(found, polyhedron_line_by_scan(c.body, c.pose, line));
    const solid::Ray ray = solid::Ray::from(c.a, c.b);
    expect_same(polyhedron_ray_by_drums(c.body, c.pose, ray), polyhedron_ray_by_scan(c.body, c.pose, ray));
    const solid::Segment segment = solid::Segment::between(c.a, i % 16 == 0 ? c.a : c.b);
    expect_same(polyhedron_segment_by_drums(c.body, c.pose, segment),
                polyhedron_segment_by_scan(c.body, c.pose, segment));
    if (HasFatalFailure()) return;
    if (c.body.dimension() < 3) continue;  // decided exactly, without a search
    LineByDrumsTally& tally = tallies[c.family];
    ++tally.cases;
    tally.meets += found.meet();
    tally.finished += found.decided_by == DecidedBy::finishing;
    tally.probes += found.cost.probes;
  }
  std::printf("%-15s %7s %7s %9s %7s\n", "family", "cases", "meet", "finishing", "probes");
  for (const auto& [family, t] : tallies) {
    std::printf("%-15s %7d %7d %9d %7.0f\n", std::string(name_of(family)).c_str(), t.cases, t.meets, t.finished,
                static_cast<double>(t.probes) / t.cases);
  }
  if (count < 2000) return;
  for (const auto& [family, t] : tallies) {
    // Of needles of 600 decimal digits that are turned, no search in floating point sees the thickness, and
    // no line of doubles goes through them.
    if (family == LineFamily::stretched_turned) continue;
    EXPECT_GT(t.meets, t.cases / 5) << name_of(family);
    const bool is_general = family == LineFamily::general || family == LineFamily::round;
    EXPECT_LE(t.finished, is_general ? 1 + t.cases / 1000 : t.cases / 10) << name_of(family);
  }
}

// A body that leans so far that upright planes go between its two slices: the section is all in one drum.
TEST(SolidLineByDrumsDifferential, SectionsBetweenSlices) {
  Random random(chosen_seed(3));
  std::vector<Point3> points;
  for (int k = 0; k < 64; ++k) {
    const double t = 6.283185307179586 * k / 64;
    points.push_back({std::cos(t), std::sin(t), 0});
    points.push_back({std::cos(t) + 8, 0.75 * std::sin(t), 1});
  }
  const solid::ConvexPolyhedron body(points);
  ASSERT_EQ(solid::represent::of<solid::Drums>(body).drum_count(), 1u);
  int meets = 0;
  const int count = scaled_count(400);
  for (int i = 0; i < count; ++i) {
    const double s = random.uniform(0.2, 0.8), t = random.uniform(0, 3.14);
    const Point3 a{8 * s, random.uniform(-1, 1), s + random.uniform(-0.05, 0.05)};
    const solid::Line line =
        solid::Line::through(a, {a.x + random.uniform(-0.01, 0.01), a.y + std::cos(t), a.z + std::sin(t)});
    const PolyhedronCut found = polyhedron_line_by_drums(body, solid::Pose(), line);
    expect_same(found, polyhedron_line_by_scan(body, solid::Pose(), line));
    EXPECT_NE(found.decided_by, DecidedBy::finishing) << i;
    meets += found.meet();
  }
  EXPECT_GT(meets, count / 2);
}

}  // namespace
}  // namespace sunder::tests
