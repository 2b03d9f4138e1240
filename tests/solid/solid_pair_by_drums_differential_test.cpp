// Two polyhedra by the drums of both (IHH) against the scan, over the families of pairs: verdicts, certificates, and
// how often its own proposals hold.
#include <tests/support/solid_pairs.h>

#include <sunder/certificate/check.h>
#include <sunder/solid/pair/polyhedron_polyhedron.h>

#include <gtest/gtest.h>

#include <cstdint>
#include <cstdio>
#include <map>
#include <string>

namespace sunder::tests {
namespace {

struct PairByDrumsTally {
  int cases = 0, meets = 0, finished = 0, meets_finished = 0;
  std::uint64_t probes = 0;
};

// One in how many.
int part_that_may_be_finished(Family family) {
  switch (family) {
    case Family::grid: return 10;          // whole numbers put corners of cuts on edges of the other body
    case Family::tiny_or_huge: return 15;  // sizes far apart leave few digits
    case Family::shapes:
    case Family::shapes_touching:
    case Family::plates: return 20;
    default: return 60;
  }
}

TEST(SolidPairByDrumsDifferential, AgreesWithTheScan) {
  const int count = scaled_count(20000);
  const std::uint64_t seed = chosen_seed(20261129);
  SCOPED_TRACE("seed " + std::to_string(seed));
  SolidPairs pairs(seed);
  std::map<Family, PairByDrumsTally> tallies;
  for (int i = 0; i < count; ++i) {
    const PairCase c = pairs.next();
    SCOPED_TRACE(std::to_string(i) + " " + std::string(name_of(c.family)));
    const PairAnswer scan = polyhedron_polyhedron_by_scan(c.a, c.pose_a, c.b, c.pose_b);
    const PairAnswer drums = polyhedron_polyhedron_by_drums(c.a, c.pose_a, c.b, c.pose_b);
    ASSERT_EQ(drums.meet(), scan.meet());
    ASSERT_EQ(check_absolutely(drums.evidence, {c.a.vertices(), c.pose_a.affine(), false},
                               {c.b.vertices(), c.pose_b.affine(), false}),
              CheckResult::accepted);
    if (c.a.dimension() < 3 || c.b.dimension() < 3) continue;  // left to the front door
    PairByDrumsTally& t = tallies[c.family];
    const bool finished = drums.decided_by == DecidedBy::finishing;
    ++t.cases;
    t.meets += scan.meet();
    t.finished += finished;
    t.meets_finished += finished && scan.meet();
    t.probes += drums.cost.probes;
  }
  std::printf("%-16s %7s %7s | finished (meeting); probes\n", "family", "cases", "meet");
  for (const auto& [family, t] : tallies) {
    std::printf("%-16s %7d %7d | %7d (%d) %7.0f\n", std::string(name_of(family)).c_str(), t.cases, t.meets, t.finished,
                t.meets_finished, static_cast<double>(t.probes) / t.cases);
    if (count < 2000 || is_stretched(family)) continue;
    EXPECT_LE(t.finished, t.cases / part_that_may_be_finished(family) + 3) << name_of(family);
  }
  EXPECT_LE(tallies[Family::general].finished, tallies[Family::general].cases / 1000 + 1);
}

}  // namespace
}  // namespace sunder::tests
