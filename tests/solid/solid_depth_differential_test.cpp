// polyhedron_polyhedron_depth, of all families of pairs: against the least width of the difference along all normals of
// triples of vertices and of pairs of pairs, in fractions, where the bodies are small; by certificates, which say that
// the depth is at most `high` and at least `low`; and against itself under symmetries.
#include <tests/support/round_oracle.h>
#include <tests/support/solid_pairs.h>

#include <sunder/certificate/pair_claims.h>
#include <sunder/solid/pair/polyhedron_polyhedron_depth.h>

#include <verifier/cpp/verify.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace sunder::tests {
namespace {

using solid::ConvexPolyhedron;
using solid::PolyhedraOverlap;
using solid::PolyhedronDepth;
using solid::Pose;

// A vector of integers, in a unit that all of a pair have.
using Whole = std::array<Integer, 3>;

Whole minus(const Whole& p, const Whole& q) { return {p[0] - q[0], p[1] - q[1], p[2] - q[2]}; }
Integer product(const Whole& p, const Whole& q) { return p[0] * q[0] + p[1] * q[1] + p[2] * q[2]; }
Whole across(const Whole& p, const Whole& q) {
  return {p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0]};
}

// x times 2^1100, and 2^2200 for a product of two doubles: integers.
Integer scaled_integer(double x, int by) {
  int exponent = 0;
  const double mantissa = std::frexp(x, &exponent);
  const Integer whole(static_cast<std::int64_t>(std::ldexp(mantissa, 53)));
  return whole << static_cast<unsigned>(exponent - 53 + by);
}
constexpr int unit = 1130;

std::vector<Whole> images(const ConvexPolyhedron& body, const Pose& pose) {
  std::vector<Whole> all;
  const auto& [m, t] = pose.affine();
  for (const Point3& p : body.vertices()) {
    Whole image;
    for (std::size_t i = 0; i < 3; ++i) {
      image[i] = scaled_integer(t[i], 2 * unit);
      for (std::size_t j = 0; j < 3; ++j) image[i] += scaled_integer(m[3 * i + j], unit) * scaled_integer(p[j], unit);
    }
    all.push_back(image);
  }
  return all;
}

class Oracle {
 public:
  Oracle(std::vector<Whole> a, std::vector<Whole> b) : a_(std::move(a)), b_(std::move(b)) {
    std::vector<Whole> edges_a = normals_of(a_), edges_b = normals_of(b_);
    for (const Whole& e : edges_a) {
      for (const Whole& f : edges_b) look_along(across(e, f));
    }
  }

  // The square of the depth, in the unit; of a difference within a line nothing, and the depth is 0.
  std::optional<Fraction> least_;

 private:
  // Looks along the normals of all triples; the differences of all pairs.
  std::vector<Whole> normals_of(const std::vector<Whole>& points) {
    std::vector<Whole> edges;
    for (std::size_t i = 0; i < points.size(); ++i) {
      for (std::size_t j = i + 1; j < points.size(); ++j) {
        edges.push_back(minus(points[j], points[i]));
        for (std::size_t k = j + 1; k < points.size(); ++k) {
          look_along(across(edges.back(), minus(points[k], points[i])));
        }
      }
    }
    return edges;
  }
  void look_along(const Whole& n) {
    const Integer square = product(n, n);
    if (square == 0) return;
    Integer most_a = product(n, a_[0]), least_a = most_a, most_b = product(n, b_[0]), least_b = most_b;
    for (const Whole& p : a_) {
      const Integer along = product(n, p);
      most_a = std::max(most_a, along);
      least_a = std::min(least_a, along);
    }
    for (const Whole& p : b_) {
      const Integer along = product(n, p);
      most_b = std::max(most_b, along);
      least_b = std::min(least_b, along);
    }
    const Integer beyond = std::min(most_a - least_b, most_b - least_a);
    const Fraction depth2(beyond * beyond, square);
    if (!least_ || depth2 < *least_) least_ = depth2;
  }

  std::vector<Whole> a_, b_;
};

std::string depth_certificate(const PairCase& c, const PolyhedraOverlap& overlap) {
  return claims_text({}, [&](ClaimsWriter& file) {
    PairClaims pairs(file);
    const auto a = pairs.add_placed("a", pairs.add_body("a", c.a.vertices()), c.pose_a.affine());
    const auto b = pairs.add_placed("b", pairs.add_body("b", c.b.vertices()), c.pose_b.affine());
    pairs.add_pair(a, b, overlap.common);
    add_depth(file, a, b, overlap);
  });
}

// P2: low^2 <= numerator / denominator <= high^2, and the two are neighbours, or equal where a double is the depth.
void expect_narrow_depth(const PolyhedraOverlap& d) {
  const auto compared = [&](double x) { return compare(ExactFraction{Dyadic(x) * Dyadic(x)}, d.exact->squared); };
  const auto [low, high] = d.depth;
  ASSERT_NE(compared(low), Sign::positive);
  ASSERT_EQ(low == high, compared(low) == Sign::zero);
  if (low == high) return;
  ASSERT_EQ(high, std::nextafter(low, HUGE_VAL));
  if (std::isfinite(high)) {
    ASSERT_EQ(compared(high), Sign::positive);
  }
}

struct DepthTally {
  int cases = 0, meet = 0, deep = 0, scanned = 0, exact = 0, proved = 0;
};

TEST(SolidDepthDifferential, AgreesWithAllNormalsAndIsProved) {
  const int count = scaled_count(600);
  const std::uint64_t seed = chosen_seed(20261127);
  SCOPED_TRACE("seed " + std::to_string(seed));
  SolidPairs pairs(seed);
  std::map<Family, DepthTally> tallies;
  for (int i = 0; i < count; ++i) {
    const PairCase c = pairs.next();
    const PolyhedronDepth answer = polyhedron_polyhedron_depth(c.a, c.pose_a, c.b, c.pose_b);
    DepthTally& t = tallies[c.family];
    ++t.cases;
    if (c.touches_exactly) {
      ASSERT_TRUE(answer.meet()) << i;
    }
    const PolyhedraOverlap* overlap = overlap_of(answer);
    if (overlap == nullptr) continue;
    const PolyhedraOverlap& d = *overlap;
    if (c.touches_exactly) {
      ASSERT_EQ(d.depth.high, 0) << i << " " << name_of(c.family);
    }
    ++t.meet;
    t.deep += d.depth.low > 0;
    t.exact += d.exact.has_value();
    const std::size_t m = c.a.vertices().size(), n = c.b.vertices().size();
    if (m * n <= PolyhedraOverlap::all_are_exact) {
      ASSERT_TRUE(d.exact) << i;
    }
    if (d.exact) {
      ASSERT_NO_FATAL_FAILURE(expect_narrow_depth(d)) << i << " " << name_of(c.family);
    }
    ASSERT_LE(d.depth.low, d.depth.high);
    if (m <= 9 && n <= 9 && !is_stretched(c.family)) {
      ++t.scanned;
      const Oracle oracle(images(c.a, c.pose_a), images(c.b, c.pose_b));
      const Fraction square = oracle.least_.value_or(0) / Fraction(Integer(1) << (4 * unit));
      ASSERT_TRUE(fraction(d.exact->squared.numerator) == square * fraction(d.exact->squared.denominator))
          << i << " " << name_of(c.family);
    }
    if (!std::isfinite(d.depth.high)) continue;
    ++t.proved;
    const std::string text = depth_certificate(c, d);
    const auto result = sunder_verifier::verify_text(text, "certificate", sunder_verifier::Limit::none);
    ASSERT_TRUE(result.accepted()) << i << " " << name_of(c.family) << result.failed_form << result.error << "\n"
                                   << (result.statements.empty() ? "" : result.statements.back().reason) << "\n"
                                   << text.substr(0, 5000);
    ASSERT_EQ(result.statements.size(), d.depth.low > 0 ? 3u : 2u);
  }
  std::printf("%-16s %8s %8s %8s %8s %8s %8s\n", "family", "cases", "meet", "deep", "exact", "scanned", "proved");
  for (const auto& [family, t] : tallies) {
    std::printf("%-16s %8d %8d %8d %8d %8d %8d\n", std::string(name_of(family)).c_str(), t.cases, t.meet, t.deep,
                t.exact, t.scanned, t.proved);
  }
  if (count < 500) return;  // too few for the rates below
  int scanned = 0;
  for (const auto& [family, t] : tallies) {
    scanned += t.scanned;
    EXPECT_GT(t.proved, t.cases / 10) << name_of(family);
    EXPECT_GE(t.exact, t.meet * 9 / 10) << name_of(family);
  }
  EXPECT_GT(scanned, count / 20);
}

// P4, and what else leaves depths as they are: swapping, reflecting.
TEST(SolidDepthDifferential, SymmetriesKeepTheDepth) {
  const int count = scaled_count(400);
  SolidPairs pairs(chosen_seed(29));
  int deep = 0;
  for (int i = 0; i < count; ++i) {
    const PairCase c = pairs.next();
    const PolyhedronDepth d = polyhedron_polyhedron_depth(c.a, c.pose_a, c.b, c.pose_b);
    const PolyhedraOverlap* overlap = overlap_of(d);
    if (overlap == nullptr || !overlap->exact) continue;
    deep += overlap->depth.low > 0;
    const auto same = [&](const PolyhedronDepth& answer, double factor) {
      const PolyhedraOverlap* other = overlap_of(answer);
      if (other == nullptr || !other->exact) return false;
      const auto& [numerator, denominator] = overlap->exact->squared;
      return ExactFraction{Dyadic(factor) * Dyadic(factor) * numerator, denominator} == other->exact->squared;
    };
    ASSERT_TRUE(same(polyhedron_polyhedron_depth(c.b, c.pose_b, c.a, c.pose_a), 1)) << "swapped " << i;
    const auto changed = [&](const auto& change) {
      return polyhedron_polyhedron_depth(c.a, change(c.pose_a), c.b, change(c.pose_b));
    };
    ASSERT_TRUE(same(changed(reflected), 1)) << "reflected " << i;
    if (c.family == Family::tiny_or_huge || is_stretched(c.family)) continue;
    for (const double s : {0x1p-40, 0x1p300, 0x1p-300}) {
      ASSERT_TRUE(same(changed([&](const Pose& pose) { return scaled_pose(pose, s); }), s))
          << "scaled " << i << " by " << s;
    }
  }
  if (count >= 400) {
    EXPECT_GT(deep, count / 8);
  }
}

}  // namespace
}  // namespace sunder::tests
