// The common parts of circles and of convex polygons: the methods against the scans, on small and nasty sets.
#include <tests/support/scale.h>

#include <sunder/base/random.h>
#include <sunder/planar/region/convex_polygon_intersection.h>
#include <sunder/planar/region/disc_intersection.h>
#include <sunder/predicate/disc_powers.h>

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

enum class DiscFamily : int {
  grid,         // whole numbers: touching, nested, equal, concentric
  concurrent,   // circles of whole numbers through a few points
  last_bit,     // those, a unit in the last place off
  generic,      // of about one size, some common part or nearly so
  equal_radii,  // many arcs
  any_scale,    // the same at 1e-300 to 1e300; or numbers of all sizes
};
constexpr int disc_family_count = 6;
constexpr std::array<const char*, disc_family_count> disc_family_names{"grid",    "concurrent",  "last bit",
                                                                       "generic", "equal radii", "any scale"};

// Arrows of whole length: circles about whole points through one whole point.
constexpr std::array<std::array<int, 3>, 9> whole_arrows{
    {{3, 4, 5}, {5, 12, 13}, {8, 6, 10}, {0, 5, 5}, {4, 3, 5}, {1, 0, 1}, {7, 24, 25}, {15, 8, 17}, {0, 10, 10}}};

class DiscSets {
 public:
  explicit DiscSets(std::uint64_t seed) : random_(seed) {}

  std::vector<Disc> next(DiscFamily family) {
    std::vector<Disc> set;
    switch (family) {
      case DiscFamily::grid: {
        const std::int64_t side = random_.between(1, 4);
        for (std::int64_t n = random_.between(1, 7); n > 0; --n) {
          set.push_back({{whole(-side, side), whole(-side, side)}, whole(random_.below(8) == 0 ? 0 : 1, 2 * side)});
        }
        break;
      }
      case DiscFamily::concurrent: {
        const std::int64_t reach = random_.between(0, 1) * 5;
        for (std::int64_t n = random_.between(1, 7); n > 0; --n) {
          set.push_back(through({whole(0, 1) * static_cast<double>(reach), whole(0, 1) * static_cast<double>(reach)}));
          if (random_.below(8) == 0) set.push_back(set[random_.below(set.size())]);
          if (random_.below(12) == 0) set.push_back({set.back().center, whole(0, 12)});
        }
        break;
      }
      case DiscFamily::last_bit:
        set = next(random_.below(2) ? DiscFamily::grid : DiscFamily::concurrent);
        for (Disc& c : set) {
          for (double* x : {&c.center.x, &c.center.y, &c.radius}) {
            if (random_.below(3) == 0)
              *x = std::nextafter(*x, random_.below(2) ? HUGE_VAL : x == &c.radius ? 0 : -HUGE_VAL);
          }
        }
        break;
      case DiscFamily::generic: {
        const double size = random_.uniform(0.3, 1.5);
        for (std::int64_t n = random_.between(1, 9); n > 0; --n) {
          set.push_back({{random_.uniform(-1, 1), random_.uniform(-1, 1)}, size * random_.uniform(0.7, 1.5)});
        }
        break;
      }
      case DiscFamily::equal_radii: {
        const double radius = random_.uniform(0.9, 3);
        for (std::int64_t n = random_.between(2, 10); n > 0; --n) {
          const double angle = random_.uniform(0, 7), far = random_.below(2) ? 1 : random_.unit();
          set.push_back({{far * std::cos(angle), far * std::sin(angle)}, radius});
        }
        break;
      }
      case DiscFamily::any_scale: {
        if (random_.below(2)) {
          set = next(static_cast<DiscFamily>(random_.below(5)));
          const int exponent =
              static_cast<int>(random_.below(2) ? random_.between(900, 1015) : -random_.between(900, 1000));
          for (Disc& c : set) {
            c = {{std::ldexp(c.center.x, exponent), std::ldexp(c.center.y, exponent)}, std::ldexp(c.radius, exponent)};
          }
          break;
        }
        const auto any = [&] { return random_.log_uniform(1e-300, 1e300) * (random_.below(2) ? 1 : -1); };
        for (std::int64_t n = random_.between(1, 4); n > 0; --n) {
          const double x = any(), y = any();
          set.push_back({{x, y}, std::fabs(random_.below(3) ? std::max(x, y) : any())});
        }
        break;
      }
    }
    return set;
  }

 private:
  double whole(std::int64_t low, std::int64_t high) { return static_cast<double>(random_.between(low, high)); }

  Disc through(const Point2& p) {
    const auto& [a, b, r] = whole_arrows[random_.below(whole_arrows.size())];
    const double x = random_.below(2) ? a : -a, y = random_.below(2) ? b : -b;
    return {random_.below(2) ? Point2{p.x + x, p.y + y} : Point2{p.x + y, p.y + x}, static_cast<double>(r)};
  }

  Random random_;
};

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
  DiscSets sets(chosen_seed(13));
  std::map<DiscFamily, std::map<DiscIntersectionKind, int>> kinds;
  std::map<std::size_t, int> sizes;
  int repeated = 0;
  for (int i = 0; i < count; ++i) {
    const auto family = static_cast<DiscFamily>(i % disc_family_count);
    const std::vector<Disc> set = sets.next(family);
    SCOPED_TRACE(std::to_string(i) + " " + disc_family_names[static_cast<std::size_t>(family)] + "\n" + text_of(set));
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
    std::printf("%-12s %8d %8d %8d\n", disc_family_names[static_cast<std::size_t>(family)],
                of[DiscIntersectionKind::empty], of[DiscIntersectionKind::point], of[DiscIntersectionKind::region]);
  }
  std::printf("arcs:");
  for (const auto& [size, n] : sizes) std::printf(" %zu: %d", size, n);
  std::printf("; with one disc twice: %d\n", repeated);
  if (count < 2000) return;  // too few for the rates below
  const int of_family = count / disc_family_count;
  for (auto& [family, of] : kinds) {
    if (family != DiscFamily::equal_radii) {
      EXPECT_GT(of[DiscIntersectionKind::empty], of_family / 5);
    }
    EXPECT_GT(of[DiscIntersectionKind::region], of_family / 5);
  }
  for (const DiscFamily family : {DiscFamily::grid, DiscFamily::concurrent, DiscFamily::any_scale}) {
    EXPECT_GT(kinds[family][DiscIntersectionKind::point], of_family / 100);
  }
  for (std::size_t size = 1; size <= 6; ++size) EXPECT_GT(sizes[size], count / 100) << size;
  EXPECT_GT(repeated, count / 500);
}

// With many others that hold one of them each, after them: the same part. So the batches have something to do.
TEST(CommonPartDifferential, DiscsAmongLargerOnes) {
  const int count = scaled_count(6000);
  DiscSets sets(chosen_seed(23));
  Random random(chosen_seed(24));
  int regions = 0;
  for (int i = 0; i < count; ++i) {
    const auto family = static_cast<DiscFamily>(i % (disc_family_count - 1));
    std::vector<Disc> set = sets.next(family);
    SCOPED_TRACE(std::to_string(i) + " " + disc_family_names[static_cast<std::size_t>(family)] + "\n" + text_of(set));
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
    if (family != DiscFamily::grid && family != DiscFamily::concurrent) continue;  // else sums were rounded
    ASSERT_EQ(part.kind, expected.kind);
    ASSERT_EQ(part.arcs, expected.arcs);
    regions += part.kind == DiscIntersectionKind::region;
  }
  if (count < 2000) return;
  EXPECT_GT(regions, count / 8);
}

enum class PolygonFamily : int {
  grid,      // hulls of whole points, points and segments among them
  touching,  // the same on sides of one point
  last_bit,  // those, a unit in the last place off
  generic,   // about one place, some common part or nearly so
  nested,    // large ones in which some edges matter
  thin,      // on one vertical or slanted line, nearly
  any_scale,
};
constexpr int polygon_family_count = 7;
constexpr std::array<const char*, polygon_family_count> polygon_family_names{
    "grid", "touching", "last bit", "generic", "nested", "thin", "any scale"};

class PolygonSets {
 public:
  explicit PolygonSets(std::uint64_t seed) : random_(seed) {}

  std::vector<ConvexPolygon> next(PolygonFamily family) {
    std::vector<ConvexPolygon> set;
    for (const std::vector<Point2>& points : points_of(family)) set.push_back(ConvexPolygon::hull_of(points));
    return set;
  }

 private:
  using Points = std::vector<std::vector<Point2>>;

  double whole(std::int64_t low, std::int64_t high) { return static_cast<double>(random_.between(low, high)); }

  Points points_of(PolygonFamily family) {
    Points set;
    const auto add = [&](std::int64_t count, const auto& point) {
      set.emplace_back();
      for (; count > 0; --count) set.back().push_back(point());
    };
    switch (family) {
      case PolygonFamily::grid: {
        const std::int64_t side = random_.between(2, 6);
        for (std::int64_t n = random_.between(1, 4); n > 0; --n) {
          add(random_.between(random_.below(4) == 0 ? 1 : 3, 5),
              [&] { return Point2{whole(0, side), whole(0, side)}; });
          if (random_.below(8) == 0) set.push_back(set[random_.below(set.size())]);
        }
        break;
      }
      case PolygonFamily::touching: {  // all hold the origin, or come to the line y = 0 or x = 0 near it
        const bool turned = random_.below(2) != 0;
        for (std::int64_t n = random_.between(2, 4); n > 0; --n) {
          const double side = random_.below(2) ? 1 : -1, reach = whole(0, 3);
          add(random_.between(1, 4), [&] {
            const Point2 p{whole(-4, 4), side * whole(0, 4)};
            return turned ? Point2{p.y, p.x} : p;
          });
          if (random_.below(3)) set.back().push_back({0, 0});
          if (random_.below(2)) set.back().push_back(turned ? Point2{0, reach} : Point2{reach, 0});
        }
        break;
      }
      case PolygonFamily::last_bit:
        set = points_of(static_cast<PolygonFamily>(random_.below(2)));
        for (auto& points : set) {
          for (Point2& p : points) {
            for (double* x : {&p.x, &p.y}) {
              if (random_.below(3) == 0) *x = std::nextafter(*x, random_.below(2) ? HUGE_VAL : -HUGE_VAL);
            }
          }
        }
        break;
      case PolygonFamily::generic:
        for (std::int64_t n = random_.between(1, 5); n > 0; --n) {
          add(random_.between(3, 6), [&] { return Point2{random_.uniform(-1, 1), random_.uniform(-1, 1)}; });
        }
        break;
      case PolygonFamily::nested:
        for (std::int64_t n = random_.between(2, 5); n > 0; --n) {
          const double size = random_.uniform(1, 1.3), x = random_.uniform(-0.2, 0.2), y = random_.uniform(-0.2, 0.2);
          add(random_.between(4, 7), [&] {
            const double angle = random_.uniform(0, 6.3);
            return Point2{x + size * std::cos(angle), y + size * std::sin(angle)};
          });
        }
        break;
      case PolygonFamily::thin: {
        const double slope = whole(0, 2), wide = random_.below(3) == 0 ? 1e-15 : 0;
        const bool vertical = random_.below(2) != 0;
        for (std::int64_t n = random_.between(1, 5); n > 0; --n) {
          add(random_.between(1, 3), [&] {
            const double t = whole(-5, 5), off = wide * whole(-1, 1);
            return vertical ? Point2{off, t} : Point2{t, slope * t + off};
          });
          if (random_.below(2)) add(4, [&] { return Point2{whole(-6, 6), whole(-6, 6)}; });
        }
        break;
      }
      case PolygonFamily::any_scale: {
        if (random_.below(2)) {
          set = points_of(static_cast<PolygonFamily>(random_.below(6)));
          const int exponent =
              static_cast<int>(random_.below(2) ? random_.between(900, 1015) : -random_.between(900, 1000));
          for (auto& points : set) {
            for (Point2& p : points) p = {std::ldexp(p.x, exponent), std::ldexp(p.y, exponent)};
          }
          break;
        }
        const auto any = [&] { return random_.log_uniform(1e-300, 1e300) * (random_.below(2) ? 1 : -1); };
        for (std::int64_t n = random_.between(1, 3); n > 0; --n) add(3, [&] { return Point2{any(), any()}; });
        break;
      }
    }
    return set;
  }

  Random random_;
};

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
  PolygonSets sets(chosen_seed(14));
  std::map<PolygonFamily, std::map<PolygonsPartKind, int>> kinds;
  for (int i = 0; i < count; ++i) {
    const auto family = static_cast<PolygonFamily>(i % polygon_family_count);
    const std::vector<ConvexPolygon> set = sets.next(family);
    SCOPED_TRACE(std::to_string(i) + " " + polygon_family_names[static_cast<std::size_t>(family)] + "\n" +
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
    std::printf("%-10s %8d %8d %8d %8d\n", polygon_family_names[static_cast<std::size_t>(family)],
                of[PolygonsPartKind::empty], of[PolygonsPartKind::point], of[PolygonsPartKind::segment],
                of[PolygonsPartKind::polygon]);
  }
  if (count < 2000) return;  // too few for the rates below
  const int of_family = count / polygon_family_count;
  for (auto& [family, of] : kinds) {
    EXPECT_GT(of[PolygonsPartKind::empty], of_family / 10);
    EXPECT_GT(of[PolygonsPartKind::polygon], of_family / 100);
    if (family == PolygonFamily::generic || family == PolygonFamily::nested) continue;
    EXPECT_GT(of[PolygonsPartKind::point], of_family / 50);
    EXPECT_GT(of[PolygonsPartKind::segment], of_family / 50);
  }
}

// With many others that hold one of them each, after them: the same part. So the batches have something to do.
TEST(CommonPartDifferential, ConvexPolygonsAmongLargerOnes) {
  const int count = scaled_count(6000);
  PolygonSets sets(chosen_seed(25));
  Random random(chosen_seed(26));
  std::map<PolygonsPartKind, int> kinds;
  for (int i = 0; i < count; ++i) {
    const auto family = static_cast<PolygonFamily>(i % polygon_family_count);
    std::vector<ConvexPolygon> set = sets.next(family);
    SCOPED_TRACE(std::to_string(i) + " " + polygon_family_names[static_cast<std::size_t>(family)] + "\n" +
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
