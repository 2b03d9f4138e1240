// The common parts of circles and of convex polygons: the methods against the scans, on small and nasty sets.
#include <tests/support/convex_polygon_sets.h>
#include <tests/support/disc_sets.h>
#include <tests/support/scale.h>

#include <sunder/base/random.h>
#include <sunder/planar/region/convex_polygon_intersection.h>
#include <sunder/planar/region/disc_intersection.h>
#include <sunder/predicate/disc/disc_powers.h>

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

using planar::ConvexPolygon;
using planar::DiscIntersection;
using planar::DiscIntersectionKind;
using planar::Discs;
using planar::PolygonsPart;
using planar::PolygonsPartKind;

// What the header says of the deepest point.
void expect_deepest(const Discs& circles, const DiscIntersection& part) {
  const planar::DiscBasis basis = planar::discs_of(circles.all(), part.deepest.basis());
  const Sign power = deepest_power(basis);
  ASSERT_EQ(power, part.deepest.power);
  ASSERT_EQ(part.kind, power == Sign::positive ? DiscIntersectionKind::empty
                       : power == Sign::zero   ? DiscIntersectionKind::point
                                               : DiscIntersectionKind::region);
  for (const Disc& c : circles.all()) ASSERT_NE(power_against(basis, c), Sign::positive);
  const DeepestWeights weights = deepest_weights(basis);
  ASSERT_EQ(weights.denominator.sign(), Sign::positive);
  Dyadic sum;
  for (std::uint32_t k = 0; k < 3; ++k) {
    ASSERT_EQ(weights.numerators[k].sign(), k < part.deepest.count ? Sign::positive : Sign::zero);
    sum = sum + weights.numerators[k];
  }
  ASSERT_EQ(sum, weights.denominator);
}

std::string text_of(const std::vector<Disc>& set) {
  std::string text;
  for (const Disc& c : set) {
    std::array<char, 200> line{};
    std::snprintf(line.data(), line.size(), "  {{%a, %a}, %a}  %g %g %g\n", c.center.x, c.center.y, c.radius,
                  c.center.x, c.center.y, c.radius);
    text += line.data();
  }
  return text;
}

TEST(CommonPartDifferential, DiscsAgreeWithTheScan) {
  const int count = scaled_count(20000);
  CommonDiscSets sets(chosen_seed(13));
  std::map<CommonDiscFamily, std::map<DiscIntersectionKind, int>> kinds;
  std::map<std::size_t, int> sizes;
  int repeated = 0;
  for (int i = 0; i < count; ++i) {
    const auto family = static_cast<CommonDiscFamily>(i % common_disc_family_count);
    const std::vector<Disc> set = sets.next(family);
    SCOPED_TRACE(std::to_string(i) + " " + common_disc_family_names[static_cast<std::size_t>(family)] + "\n" +
                 text_of(set));
    const Discs circles(set);
    const DiscIntersection scan = disc_intersection_by_scan(circles);
    for (const auto method : {planar::disc_intersection, planar::disc_intersection_by_division}) {
      const DiscIntersection part = method(circles);
      ASSERT_EQ(part.kind, scan.kind);
      ASSERT_EQ(part.arcs, scan.arcs);
      ASSERT_NO_FATAL_FAILURE(expect_deepest(circles, part));
    }
    ++kinds[family][scan.kind];
    ++sizes[scan.arcs.size()];
    std::vector<std::uint32_t> arcs = scan.arcs;
    std::sort(arcs.begin(), arcs.end());
    repeated += std::adjacent_find(arcs.begin(), arcs.end()) != arcs.end();
  }
  std::printf("%-12s %8s %8s %8s\n", "family", "empty", "point", "region");
  for (auto& [family, of] : kinds) {
    std::printf("%-12s %8d %8d %8d\n", common_disc_family_names[static_cast<std::size_t>(family)],
                of[DiscIntersectionKind::empty], of[DiscIntersectionKind::point], of[DiscIntersectionKind::region]);
  }
  std::printf("arcs:");
  for (const auto& [size, n] : sizes) std::printf(" %zu: %d", size, n);
  std::printf("; with one disc twice: %d\n", repeated);
  if (count < 2000) return;  // too few for the rates below
  const int of_family = count / common_disc_family_count;
  for (auto& [family, of] : kinds) {
    if (family != CommonDiscFamily::equal_radii) {
      EXPECT_GT(of[DiscIntersectionKind::empty], of_family / 5);
    }
    EXPECT_GT(of[DiscIntersectionKind::region], of_family / 5);
  }
  for (const CommonDiscFamily family :
       {CommonDiscFamily::grid, CommonDiscFamily::concurrent, CommonDiscFamily::any_scale}) {
    EXPECT_GT(kinds[family][DiscIntersectionKind::point], of_family / 100);
  }
  for (std::size_t size = 1; size <= 6; ++size) EXPECT_GT(sizes[size], count / 100) << size;
  EXPECT_GT(repeated, count / 500);
}

// With many others that hold one of them each, after them: the same part. So the batches have something to do.
TEST(CommonPartDifferential, DiscsAmongLargerOnes) {
  const int count = scaled_count(6000);
  CommonDiscSets sets(chosen_seed(23));
  Random random(chosen_seed(24));
  int regions = 0;
  for (int i = 0; i < count; ++i) {
    const auto family = static_cast<CommonDiscFamily>(i % (common_disc_family_count - 1));
    std::vector<Disc> set = sets.next(family);
    SCOPED_TRACE(std::to_string(i) + " " + common_disc_family_names[static_cast<std::size_t>(family)] + "\n" +
                 text_of(set));
    const DiscIntersection expected = disc_intersection_by_division(Discs(set));
    const std::size_t given = set.size();
    for (std::int64_t n = random.between(10, 50); n > 0; --n) {
      Disc c = set[random.below(given)];
      const double more = random.below(4) == 0 ? 0 : static_cast<double>(random.below(3));
      if (c.radius + more - more != c.radius) continue;
      c.radius += more;
      if (random.below(2)) c.center.x += random.below(2) ? more : -more;  // touches from inside
      set.push_back(c);
    }
    const Discs circles(set);
    const DiscIntersection division = disc_intersection_by_division(circles);
    const DiscIntersection part = disc_intersection_by_batches(circles);
    ASSERT_EQ(part.kind, division.kind);
    ASSERT_EQ(part.arcs, division.arcs);
    ASSERT_NO_FATAL_FAILURE(expect_deepest(circles, part));
    if (family != CommonDiscFamily::grid && family != CommonDiscFamily::concurrent) continue;  // else sums were rounded
    ASSERT_EQ(part.kind, expected.kind);
    ASSERT_EQ(part.arcs, expected.arcs);
    regions += part.kind == DiscIntersectionKind::region;
  }
  if (count < 2000) return;
  EXPECT_GT(regions, count / 8);
}

std::string text_of(const std::vector<ConvexPolygon>& set) {
  std::string text;
  for (const ConvexPolygon& p : set) {
    for (const Point2& v : p.vertices()) {
      std::array<char, 100> line{};
      std::snprintf(line.data(), line.size(), " {%.17g, %.17g},", v.x, v.y);
      text += line.data();
    }
    text += "\n";
  }
  return text;
}

bool is_same(const LinePoint& p, const LinePoint& q) {
  const ExactPoint2 a = exact_point(p), b = exact_point(q);
  if (a.denominator.sign() != Sign::positive || b.denominator.sign() != Sign::positive) return false;
  return a.x * b.denominator == b.x * a.denominator && a.y * b.denominator == b.y * a.denominator;
}

void expect_same_part(const std::vector<ConvexPolygon>& set, const PolygonsPart& part, const PolygonsPart& scan) {
  ASSERT_EQ(part.kind, scan.kind) << name_of(part.kind) << " for " << name_of(scan.kind);
  ASSERT_EQ(part.corners.size(), scan.corners.size());
  for (std::size_t k = 0; k < scan.corners.size(); ++k) {
    ASSERT_TRUE(is_same(corner_point(set, part.corners[k]), corner_point(set, scan.corners[k]))) << "corner " << k;
  }
  if (part.kind == PolygonsPartKind::empty) {
    ASSERT_TRUE(is_contradiction(set, part.supports()));
  } else {
    ASSERT_EQ(part.contradiction_size, 0u);
  }
}

TEST(CommonPartDifferential, ConvexPolygonsAgreeWithTheScan) {
  const int count = scaled_count(20000);
  CommonConvexSets sets(chosen_seed(14));
  std::map<CommonConvexFamily, std::map<PolygonsPartKind, int>> kinds;
  for (int i = 0; i < count; ++i) {
    const auto family = static_cast<CommonConvexFamily>(i % common_convex_family_count);
    const std::vector<ConvexPolygon> set = sets.next(family);
    SCOPED_TRACE(std::to_string(i) + " " + common_convex_family_names[static_cast<std::size_t>(family)] + "\n" +
                 text_of(set));
    const PolygonsPart scan = convex_polygon_intersection_by_scan(set);
    ASSERT_EQ(scan.kind == PolygonsPartKind::empty, is_contradiction(set, scan.supports()));
    const PolygonsPart division = convex_polygon_intersection_by_division(set);
    for (const auto method : {planar::convex_polygon_intersection, planar::convex_polygon_intersection_by_division,
                              planar::convex_polygon_intersection_by_edges}) {
      const PolygonsPart part = method(set);
      ASSERT_NO_FATAL_FAILURE(expect_same_part(set, part, scan));
      ASSERT_EQ(part.corners, division.corners);
    }
    ++kinds[family][scan.kind];
  }
  std::printf("%-10s %8s %8s %8s %8s\n", "family", "empty", "point", "segment", "polygon");
  for (auto& [family, of] : kinds) {
    std::printf("%-10s %8d %8d %8d %8d\n", common_convex_family_names[static_cast<std::size_t>(family)],
                of[PolygonsPartKind::empty], of[PolygonsPartKind::point], of[PolygonsPartKind::segment],
                of[PolygonsPartKind::polygon]);
  }
  if (count < 2000) return;  // too few for the rates below
  const int of_family = count / common_convex_family_count;
  for (auto& [family, of] : kinds) {
    EXPECT_GT(of[PolygonsPartKind::empty], of_family / 10);
    EXPECT_GT(of[PolygonsPartKind::polygon], of_family / 100);
    if (family == CommonConvexFamily::generic || family == CommonConvexFamily::nested) continue;
    EXPECT_GT(of[PolygonsPartKind::point], of_family / 50);
    EXPECT_GT(of[PolygonsPartKind::segment], of_family / 50);
  }
}

// With many others that hold one of them each, after them: the same part. So the batches have something to do.
TEST(CommonPartDifferential, ConvexPolygonsAmongLargerOnes) {
  const int count = scaled_count(6000);
  CommonConvexSets sets(chosen_seed(25));
  Random random(chosen_seed(26));
  std::map<PolygonsPartKind, int> kinds;
  for (int i = 0; i < count; ++i) {
    const auto family = static_cast<CommonConvexFamily>(i % common_convex_family_count);
    std::vector<ConvexPolygon> set = sets.next(family);
    SCOPED_TRACE(std::to_string(i) + " " + common_convex_family_names[static_cast<std::size_t>(family)] + "\n" +
                 text_of(set));
    const PolygonsPart expected = convex_polygon_intersection_by_division(set);
    const std::vector<ConvexPolygon> given = set;
    for (std::int64_t n = random.between(10, 50); n > 0; --n) {
      const auto vertices = given[random.below(given.size())].vertices();
      std::vector<Point2> points(vertices.begin(), vertices.end());
      for (std::uint64_t more = random.below(5); more > 0; --more) {
        points.push_back({static_cast<double>(random.between(-9, 9)), static_cast<double>(random.between(-9, 9))});
      }
      set.push_back(ConvexPolygon::hull_of(points));
    }
    const PolygonsPart part = convex_polygon_intersection_by_batches(set);
    ASSERT_NO_FATAL_FAILURE(expect_same_part(set, part, expected));
    ASSERT_EQ(part.corners, convex_polygon_intersection_by_division(set).corners);
    ++kinds[part.kind];
  }
  if (count < 2000) return;
  EXPECT_GT(kinds[PolygonsPartKind::polygon], count / 8);
  EXPECT_GT(kinds[PolygonsPartKind::segment], count / 50);
  EXPECT_GT(kinds[PolygonsPartKind::point], count / 50);
}

}  // namespace
}  // namespace sunder::tests
