// polyhedron_polyhedron_distance, of all families of pairs: against polyhedron_polyhedron_distance_by_scan where that
// is not too slow; by certificates, which both say how far apart the bodies are and that so far is kept; and against
// itself under symmetries.
#include <tests/support/solid_pairs.h>

#include <sunder/certificate/pair_claims.h>
#include <sunder/solid/pair/contact_evidence.h>
#include <sunder/solid/pair/polyhedron_polyhedron.h>
#include <sunder/solid/pair/polyhedron_polyhedron_distance.h>

#include <verifier/cpp/verify.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <map>
#include <string>
#include <vector>

namespace sunder::tests {
namespace {

using solid::ConvexPolyhedron;
using solid::PolyhedronDistance;
using solid::Pose;

// What the library says of the pair: parted, how far, and of clearances that are kept barely, and not quite.
std::string distance_certificate(const PairCase& c, const PolyhedronDistance& distance) {
  std::string text;
  ClaimsWriter file([&](std::string_view piece) { text += piece; });
  PairClaims pairs(file);
  const auto a = pairs.add_placed("a", pairs.add_body("a", c.a.vertices()), c.pose_a.affine());
  const auto b = pairs.add_placed("b", pairs.add_body("b", c.b.vertices()), c.pose_b.affine());
  const solid::ClaimedPair pair{a, b, c.a, c.pose_a, c.b, c.pose_b};
  add_claims(pairs, pair, polyhedron_polyhedron(c.a, c.pose_a, c.b, c.pose_b).evidence, Relation::none);
  add_distance(pairs, pair, distance);
  const auto [low, high] = distance_of(distance);
  for (const double least : {low, high, std::nextafter(high, HUGE_VAL)}) {
    if (least > 0 && std::isfinite(least)) add_clearance(pairs, pair, distance, least);
  }
  pairs.end();
  return text;
}

// D2: low^2 <= numerator / denominator <= high^2, and the two are neighbours, or equal where a double is the distance.
void expect_narrow_distance(const PolyhedronDistance& d) {
  const auto compared = [square = closest_of(d)->squared()](double x) {
    return compare(ExactFraction{Dyadic(x) * Dyadic(x)}, square);
  };
  const auto [low, high] = distance_of(d);
  ASSERT_NE(compared(low), Sign::positive);
  ASSERT_EQ(low == high, compared(low) == Sign::zero);
  if (low == high) return;
  ASSERT_EQ(high, std::nextafter(low, HUGE_VAL));
  if (std::isfinite(high)) {
    ASSERT_EQ(compared(high), Sign::positive);
  }
}

struct DistanceTally {
  int cases = 0, apart = 0, scanned = 0, filter = 0, evidence = 0, finishing = 0, proved = 0;
  std::array<std::array<int, 4>, 4> features{};
};

TEST(SolidDistanceDifferential, AgreesWithTheScanAndIsProved) {
  const int count = scaled_count(20000);
  const std::uint64_t seed = chosen_seed(20261201);
  SCOPED_TRACE("seed " + std::to_string(seed));
  SolidPairs pairs(seed);
  std::map<Family, DistanceTally> tallies;
  std::array<std::array<int, 4>, 4> features{};
  for (int i = 0; i < count; ++i) {
    const PairCase c = pairs.next();
    const PolyhedronDistance d = polyhedron_polyhedron_distance(c.a, c.pose_a, c.b, c.pose_b);
    DistanceTally& t = tallies[c.family];
    ++t.cases;
    ASSERT_EQ(d.meet(), !closest_of(d)) << i;
    if (c.touches_exactly) {
      ASSERT_TRUE(d.meet()) << i;
    }
    const bool small = c.a.vertices().size() + c.b.vertices().size() <= 24;
    if (small && t.cases % 2 == 0) {
      const PolyhedronDistance scan = polyhedron_polyhedron_distance_by_scan(c.a, c.pose_a, c.b, c.pose_b);
      ASSERT_EQ(d.meet(), scan.meet()) << i << " " << name_of(c.family);
      if (!d.meet()) {
        ++t.scanned;
        ASSERT_EQ(closest_of(d)->squared(), closest_of(scan)->squared())
            << i << " " << name_of(c.family) << " " << distance_of(d).low << " " << distance_of(scan).low;
      }
    }
    if (d.meet()) {
      ASSERT_EQ(distance_of(d).high, 0);
      continue;
    }
    ++t.apart;
    t.filter += d.decided_by == DecidedBy::filter;
    t.evidence += d.decided_by == DecidedBy::evidence;
    t.finishing += d.decided_by == DecidedBy::finishing;
    const solid::FeatureVertices& f = closest_of(d)->features();
    ASSERT_TRUE(f.count_a >= 1 && f.count_b >= 1 && f.count_a + f.count_b <= 4) << i;
    ++features[f.count_a][f.count_b];
    const ExactWay exact = closest_of(d)->way();
    for (std::size_t k = 0; k < std::size_t{f.count_a} + f.count_b; ++k) {
      ASSERT_EQ(exact.weight[k].sign(), Sign::positive) << i;
    }
    ASSERT_NO_FATAL_FAILURE(expect_narrow_distance(d)) << i << " " << name_of(c.family);
    if (t.cases % 4 == 0 || !small) {
      ++t.proved;
      const std::string text = distance_certificate(c, d);
      const auto result = sunder_verifier::verify_text(text, "certificate", sunder_verifier::Limit::none);
      ASSERT_TRUE(result.accepted()) << i << " " << name_of(c.family) << result.failed_form << result.error << "\n"
                                     << text.substr(0, 5000);
      ASSERT_GE(result.statements.size(), 3u);
    }
  }
  std::printf("%-14s %8s %8s %8s %8s %8s %9s %8s\n", "family", "cases", "apart", "scanned", "filter", "evidence",
              "finishing", "proved");
  for (const auto& [family, t] : tallies) {
    std::printf("%-14s %8d %8d %8d %8d %8d %9d %8d\n", std::string(name_of(family)).c_str(), t.cases, t.apart,
                t.scanned, t.filter, t.evidence, t.finishing, t.proved);
  }
  int apart = 0;
  for (std::size_t p = 1; p < 4; ++p) {
    for (std::size_t q = 1; p + q <= 4; ++q) {
      std::printf("%zu of A, %zu of B: %d\n", p, q, features[p][q]);
      apart += features[p][q];
    }
  }
  if (count < 2000) return;  // too few for the rates below
  // The test tested something: all kinds of features are common, and so are the families, but those that meet.
  for (std::size_t p = 1; p < 4; ++p) {
    for (std::size_t q = 1; p + q <= 4; ++q) EXPECT_GT(features[p][q], apart / 40) << p << " " << q;
  }
  for (const auto& [family, t] : tallies) {
    if (family == Family::touching || family == Family::shapes_touching || family == Family::contained) continue;
    EXPECT_GT(t.apart, t.cases / 5) << name_of(family);
    EXPECT_GE(t.proved, t.apart / 5) << name_of(family);
    // Of bodies that are made once and used again it depends on the seed how many of them are small.
    const bool is_of_few_bodies = is_stretched(family) || family == Family::shapes || family == Family::caps;
    if (family != Family::large) {
      EXPECT_GT(t.scanned, is_of_few_bodies ? 0 : t.apart / 20) << name_of(family);
    }
    // The proposals hold, but where the bodies' sizes are further apart than the numbers of the search reach. Lengths
    // of such needles mix all three sizes: no stretching of axes keeps them, and each is finished exactly.
    if (is_stretched(family)) continue;
    EXPECT_LE(t.finishing, family == Family::tiny_or_huge ? t.apart / 6 : t.apart / 200) << name_of(family);
  }
  // In general position filters see it, but for facets of more than three vertices.
  EXPECT_GT(tallies[Family::general].filter, tallies[Family::general].apart / 2);
}

// D4, and what else leaves distances as they are: swapping, reflecting, shifting exactly, permuting the input.
TEST(SolidDistanceDifferential, SymmetriesKeepTheDistance) {
  const int count = scaled_count(3000);
  SolidPairs pairs(chosen_seed(23));
  int apart = 0, shifts = 0, scales = 0;
  for (int i = 0; i < count; ++i) {
    const PairCase c = pairs.next();
    const PolyhedronDistance d = polyhedron_polyhedron_distance(c.a, c.pose_a, c.b, c.pose_b);
    const auto same = [&](const PolyhedronDistance& other, double factor) {
      if (d.meet() || other.meet()) return d.meet() == other.meet();
      const auto [numerator, denominator] = closest_of(d)->squared();
      return ExactFraction{Dyadic(factor) * Dyadic(factor) * numerator, denominator} == closest_of(other)->squared();
    };
    apart += !d.meet();
    ASSERT_TRUE(same(polyhedron_polyhedron_distance(c.b, c.pose_b, c.a, c.pose_a), 1)) << "swapped " << i;
    const auto changed = [&](const auto& change) {
      return polyhedron_polyhedron_distance(c.a, change(c.pose_a), c.b, change(c.pose_b));
    };
    ASSERT_TRUE(same(changed(reflected), 1)) << "reflected " << i;
    if (c.family != Family::tiny_or_huge && !is_stretched(c.family)) {
      for (const double s : {0x1p-40, 0x1p300, 0x1p-300}) {
        ++scales;
        ASSERT_TRUE(same(changed([&](const Pose& pose) { return scaled_pose(pose, s); }), s))
            << "scaled " << i << " by " << s;
      }
    }
    if (c.family == Family::grid) {
      const double far = static_cast<double>(pairs.random().between(-1000, 1000));
      ++shifts;
      ASSERT_TRUE(same(changed([&](const Pose& pose) { return shifted(pose, far); }), 1)) << "shifted " << i;
    }
    if (c.a.vertices().size() < 100) {
      std::vector<Point3> points(c.a.vertices().begin(), c.a.vertices().end());
      for (std::size_t k = points.size(); k > 1; --k) std::swap(points[k - 1], points[pairs.random().below(k)]);
      ASSERT_TRUE(same(polyhedron_polyhedron_distance(ConvexPolyhedron(points), c.pose_a, c.b, c.pose_b), 1))
          << "permuted " << i;
    }
  }
  if (count < 1000) return;
  EXPECT_GT(apart, count / 5);
  EXPECT_GT(shifts, count / 20);
  EXPECT_GT(scales, count / 2);
}

}  // namespace
}  // namespace sunder::tests
