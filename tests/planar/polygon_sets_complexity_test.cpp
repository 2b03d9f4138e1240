// How the probes of the front doors of sets of polygons grow, where boxes tell little or all that meet meet in one
// point: at most `most` times n log2 n + k, for n edges and k contacts, also those that do not count: pairs that are
// found, edges that cross and rings inside of others, also of one group; the edges at one point are one bundle, and are
// in n. The constants are at most 1.5 times the greatest value that is measured at n = 1,024, and hold from there to
// 65,536.
#include <sunder/planar/polygons/convex_polygons_any.h>
#include <sunder/planar/polygons/polygons_all.h>
#include <sunder/planar/polygons/polygons_any.h>

#include <tests/support/allowed_rules.h>
#include <tests/support/polygon_sets.h>
#include <tests/support/scale.h>
#include <tests/support/shapes.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <functional>
#include <map>
#include <numbers>
#include <string>
#include <vector>

namespace sunder::tests {
namespace {

using planar::ConvexPolygon;
using planar::Polygon;
using Ring = std::vector<Point2>;
using Rings = std::vector<Ring>;

struct SetFamily {
  std::string name;
  std::function<std::vector<Rings>(std::size_t n)> make;  // about n edges
  // Of N polygons, beside what is found: how many edges cross, or rings lie inside?
  std::function<double(double count)> contacts = [](double) { return 0.0; };
  std::size_t most_listed = 65536;  // edges, where all that touch are listed
};

// One polygon of `edges` edges for each k from 1 to n / edges, of `count`.
std::function<std::vector<Rings>(std::size_t)> each(std::size_t edges,
                                                    const std::function<Rings(double k, double count)>& make) {
  return [=](std::size_t n) {
    std::vector<Rings> set;
    const std::size_t count = n / edges;
    for (std::size_t k = 1; k <= count; ++k) set.push_back(make(static_cast<double>(k), static_cast<double>(count)));
    return set;
  };
}

Rings annulus(double k, double) { return {box_ring(-k, -k, k, k), box_ring(0.5 - k, 0.5 - k, k - 0.5, k - 0.5)}; }
Rings l_shape(double k, double count) {
  const double end = count + 1;
  return {{{k, k}, {end, k}, {end, k + 0.5}, {k + 0.5, k + 0.5}, {k + 0.5, end}, {k, end}}};
}
Rings bracket(double k, double count) {
  const double end = count, in = k - 0.5;
  return {{{-k, -k}, {end, -k}, {end, -in}, {-in, -in}, {-in, in}, {end, in}, {end, k}, {-k, k}}};
}
Rings diagonal(double k, double count) {
  return {{{k, 0}, {k + 0.5, 0}, {k + 0.5 + 4 * count, 4 * count}, {k + 4 * count, 4 * count}}};
}
// Of a needle the tip, of a slice of a pie or a fan all, is at this distance of the hub, and its width is a part of the
// angle that it has.
Rings needle(double k, double count, double tip, double width) {
  const double at = k / count;
  return {{on_circle(at, tip), on_circle(at, 100), on_circle((k + width) / count, 100)}};
}
// What is next to another one has a vertex in common with it.
Rings slice(double k, double count) {
  return {{{0, 0}, on_circle(k / count, 100), on_circle(k < count ? (k + 1) / count : 1 / count, 100)}};
}
Rings filled(double k, double) { return {box_ring(-k, -k, k, k)}; }
Rings bar(double k, double count) {
  const double at = std::floor(k / 2), end = count + 1;
  return static_cast<int>(k) % 2 == 0 ? Rings{box_ring(at, -1, at + 0.5, end)} : Rings{box_ring(-1, at, end, at + 0.5)};
}
Rings cell(double k, double count) {
  const double side = std::ceil(std::sqrt(count)), x = std::fmod(k, side), y = std::floor(k / side);
  return {box_ring(x, y, x + 1, y + 1)};
}

// A plate with holes, and a frame in each, and a square in that.
std::vector<Rings> islands(std::size_t n) {
  const std::size_t count = n / 16;
  const double side = std::ceil(std::sqrt(static_cast<double>(count)));
  std::vector<Rings> set{{box_ring(0, 0, side, side)}};
  for (std::size_t k = 0; k < count; ++k) {
    const double x = std::fmod(static_cast<double>(k), side), y = std::floor(static_cast<double>(k) / side);
    const auto inset = [&](double d) { return box_ring(x + d, y + d, x + 1 - d, y + 1 - d); };
    set[0].push_back(inset(0.1));
    set.push_back({inset(0.2), inset(0.3)});
    set.push_back({inset(0.4)});
  }
  return set;
}

// A plate with a hole, in which is a frame with a hole, in which ...; all of one polygon, and squares between.
std::vector<Rings> deep_islands(std::size_t n) {
  const std::size_t count = n / 8;
  std::vector<Rings> set{{}};
  for (std::size_t k = 1; k <= count; ++k) {
    const double d = 4 * static_cast<double>(k);
    set[0].push_back(box_ring(-d, -d, d, d));
    set.push_back({box_ring(d + 1, 0, d + 2, 1)});
  }
  return set;
}

// A star, and triangles within.
std::vector<Rings> inside_star(std::size_t n) {
  const std::size_t vertices = 4 * n / 7, count = n / 7;
  Ring star;
  for (std::size_t k = 0; k < vertices; ++k) {
    star.push_back(on_circle(static_cast<double>(k) / static_cast<double>(vertices), k % 2 == 0 ? 100 : 40));
  }
  std::vector<Rings> set{{star}};
  const double golden = 0.6180339887498949;
  for (std::size_t k = 0; k < count; ++k) {
    const double part = (static_cast<double>(k) + 0.5) / static_cast<double>(count);
    const Point2 at = on_circle(static_cast<double>(k) * golden, 30 * std::sqrt(part));
    const double size = 5 / std::sqrt(static_cast<double>(count));
    set.push_back({{at, {at.x + size, at.y}, {at.x, at.y + size}}});
  }
  return set;
}

// A star, with triangles at its tips.
std::vector<Rings> at_star(std::size_t n) {
  const std::size_t tips = n / 5;
  Ring star;
  std::vector<Rings> set;
  for (std::size_t k = 0; k < tips; ++k) {
    const double count = static_cast<double>(tips), at = static_cast<double>(k) / count;
    star.push_back(on_circle(at, 100));
    star.push_back(on_circle(at + 0.5 / count, 40));
    set.push_back({{star[2 * k], on_circle(at, 150), on_circle(at + 0.5 / count, 150)}});
  }
  set.push_back({star});
  return set;
}

std::vector<SetFamily> families() {
  const auto half_of_pairs = [](double count) { return count * count / 2; };
  const auto needles = [](double tip, double width) {
    return each(3, [=](double k, double count) { return needle(k, count, tip, width); });
  };
  std::vector<SetFamily> list{{"annuli", each(8, annulus)},
                              {"L shapes", each(6, l_shape)},
                              {"brackets", each(8, bracket)},
                              {"thin diagonals", each(4, diagonal)},
                              {"needles around a hub", needles(1, 0.5)},
                              {"fan", needles(0, 0.5), {}, 4096},
                              {"pie", each(3, slice), {}, 4096},
                              {"islands in holes", islands},
                              {"deep islands", deep_islands},
                              {"inside a star", inside_star},
                              {"at a star's tips", at_star},
                              {"cells", each(4, cell)},
                              {"one in another", each(4, filled), half_of_pairs, 1024},
                              {"cross-hatch", each(4, bar), [](double count) { return count * count; }, 1024}};
  for (SetFamily& family : list) {
    if (!family.contacts) family.contacts = [](double) { return 0.0; };
  }
  list[9].contacts = [](double count) { return count; };
  return list;
}

bool are_convex(const std::vector<Rings>& set) {
  return std::all_of(set.begin(), set.end(), [](const Rings& rings) {
    return rings.size() == 1 && ConvexPolygon::hull_of(rings[0]).size() == rings[0].size();
  });
}

// How the polygons are put into groups.
enum class Grouping : int { none, one, two, many };
std::vector<std::uint32_t> groups_of(std::size_t count, Grouping grouping) {
  std::vector<std::uint32_t> groups;
  for (std::uint32_t i = 0; i < count && grouping != Grouping::none; ++i) {
    groups.push_back(grouping == Grouping::one ? 0 : grouping == Grouping::two ? i % 2 : i / 2);
  }
  return groups;
}

// The greatest ratios of probes to n log2 n + k: at n = 1,024, and beyond.
struct PolygonGrowth {
  double first = 0, later = 0;
  std::string where;

  void note(std::size_t n, double ratio, const std::string& what) {
    if (n == 1024) first = std::max(first, ratio);
    if (n > 1024 && ratio > later) {
      later = ratio;
      where = what + ", " + std::to_string(n);
    }
  }
  void expect_at_most(double most, const char* question) const {
    std::printf("%-24s at 1,024: %7.2f, beyond: %7.2f (%s), stated: %.0f\n", question, first, later, where.c_str(),
                most);
    EXPECT_LE(later, most) << question << ": " << where;
    EXPECT_LE(first, most) << question;
    EXPECT_LE(most, 1.5 * first) << question;
  }
};

constexpr std::array<Grouping, 4> groupings{Grouping::none, Grouping::one, Grouping::two, Grouping::many};

// 65,536 edges, or fewer where SUNDER_TEST_SCALE asks for less.
std::size_t most_edges() { return static_cast<std::size_t>(std::min(65536, scaled_count(65536, 4096))); }

double bound(std::size_t edges, double contacts) {
  const double n = static_cast<double>(edges);
  return n * std::log2(n) + contacts;
}

TEST(PolygonSetsComplexity, EachFrontDoorUnderEachRule) {
  PolygonGrowth any, all, count;
  for (const SetFamily& family : families()) {
    for (std::size_t n = 256; n <= most_edges(); n *= 4) {
      if (n > family.most_listed && family.most_listed < 4096) continue;
      const std::vector<Polygon> polygons = polygons_of(family.make(n));
      std::size_t edges = 0;
      for (const Polygon& polygon : polygons) edges += polygon.size();
      const double hidden = family.contacts(static_cast<double>(polygons.size()));
      for (const Grouping grouping : groupings) {
        const std::vector<std::uint32_t> groups = groups_of(polygons.size(), grouping);
        for (const Allowed allowed : allowed_rules) {
          const SetOptions options{allowed, groups, nullptr};
          const std::string what = family.name + ", " + std::string(name_of(allowed)) + " allowed, grouping " +
                                   std::to_string(static_cast<int>(grouping));
          const planar::PolygonsAnswer some = planar::polygons_any(polygons, options);
          any.note(n, static_cast<double>(some.cost.probes) / bound(edges, hidden), what);
          const bool lists_touching = allowed == Allowed::nothing && grouping != Grouping::one;
          if (lists_touching && n > family.most_listed) continue;
          const planar::PolygonsCountAnswer pairs = planar::polygons_count(polygons, options);
          const double found = static_cast<double>(pairs.count.touching + pairs.count.overlapping);
          EXPECT_EQ(found > 0, some.meet()) << what;
          count.note(n, static_cast<double>(pairs.cost.probes) / bound(edges, hidden + found), what);
          const planar::PolygonsAllAnswer list = planar::polygons_all(polygons, options);
          EXPECT_EQ(static_cast<double>(list.found.size()), found) << what;
          all.note(n, static_cast<double>(list.cost.probes) / bound(edges, hidden + found), what);
        }
      }
    }
  }
  any.expect_at_most(10, "polygons_any");
  all.expect_at_most(10, "polygons_all");
  count.expect_at_most(10, "polygons_count");
}

// Convex ones, which are all but frames and stars.
TEST(PolygonSetsComplexity, ConvexPolygons) {
  PolygonGrowth growth;
  for (const SetFamily& family : families()) {
    const bool is_convex = are_convex(family.make(256));
    for (std::size_t n = 256; n <= most_edges() && is_convex; n *= 4) {
      if (n > family.most_listed && family.most_listed < 4096) continue;
      std::vector<ConvexPolygon> polygons;
      for (const Rings& rings : family.make(n)) polygons.push_back(ConvexPolygon::hull_of(rings[0]));
      const double hidden = family.contacts(static_cast<double>(polygons.size()));
      for (const Grouping grouping : groupings) {
        const std::vector<std::uint32_t> groups = groups_of(polygons.size(), grouping);
        for (const Allowed allowed : {Allowed::nothing, Allowed::touch}) {
          const planar::ConvexPolygonsAnswer some = planar::convex_polygons_any(polygons, {allowed, groups, nullptr});
          growth.note(n, static_cast<double>(some.cost.probes) / bound(n, hidden),
                      family.name + ", " + std::string(name_of(allowed)) + " allowed, grouping " +
                          std::to_string(static_cast<int>(grouping)));
        }
      }
    }
  }
  growth.expect_at_most(14, "convex_polygons_any");
}

}  // namespace
}  // namespace sunder::tests
