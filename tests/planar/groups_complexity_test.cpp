// How the work of the front doors for sets with groups grows where the members of a group crowd on each other: pairs of
// one group are not looked at, however many they are, and what is looked at is counted. k are the pairs of different
// groups whose boxes meet.
#include <tests/support/growth.h>
#include <tests/support/shapes.h>

#include <sunder/base/random.h>
#include <sunder/near/box_pairs.h>
#include <sunder/planar/boxes/boxes.h>
#include <sunder/planar/discs/discs_all.h>
#include <sunder/planar/discs/discs_any_claims.h>
#include <sunder/planar/polygons/convex_polygons_any.h>
#include <sunder/planar/polygons/polygons_all.h>
#include <sunder/planar/segments/segments_all.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace sunder::tests::boxes_of_groups {
namespace {

using planar::Polygon;
using planar::Segment;

struct Set {
  std::vector<Box2> boxes;
  std::vector<std::uint32_t> groups;
  double k = 0;

  void add(double x, double y, double width, double height, std::size_t group) {
    boxes.push_back({{x, y}, {x + width, y + height}});
    groups.push_back(static_cast<std::uint32_t>(group));
  }
};

// All of a group have the upper corner of the least in common.
Set one_group(std::size_t n, Random& random) {
  Set set;
  for (std::size_t i = 0; i < n; ++i) set.add(0.1 * random.unit(), 0.1 * random.unit(), 1, 1, 0);
  return set;
}
Set one_group_and_one(std::size_t n, Random& random) {
  Set set = one_group(n - 1, random);
  set.add(100, 100, 1, 1, 1);
  return set;
}
Set one_group_and_few(std::size_t n, Random& random) {
  Set set = one_group(n - 8, random);
  for (std::size_t i = 0; i < 8; ++i) set.add(1.05 + 0.01 * number(i), 0.5, 0.001, 0.001, 1 + i);
  set.k = 8 * number(n);
  return set;
}
Set two_groups(std::size_t n, Random& random) {
  Set set;
  for (std::size_t i = 0; i < n; ++i) set.add(2 * number(i % 2) + 0.1 * random.unit(), random.unit(), 1, 1, i % 2);
  return set;
}
// Groups by turns, one above the other: the widths of all are the same.
Set layers(std::size_t n, Random& random) {
  Set set;
  for (std::size_t i = 0; i < n; ++i) set.add(random.unit(), 2 * number(i % 16) + 0.1 * random.unit(), 10, 1, i % 2);
  return set;
}
Set small_groups(std::size_t n, Random& random) {
  Set set;
  const std::size_t count = static_cast<std::size_t>(std::sqrt(number(n)));
  for (std::size_t i = 0; i < n; ++i) {
    set.add(3 * number(i % count % 20) + random.unit(), 3 * number(i % count / 20) + random.unit(), 1, 1, i % count);
  }
  return set;
}
// Around one centre, in each gap between some of one group one of another; below them others.
Set nested(std::size_t n, Random&) {
  Set set;
  for (std::size_t i = 0; i < n; ++i) {
    const double at = number(i);
    if (i % 4 == 3) {
      set.add(-at, -2 * number(n) - at, 2 * at, 0.5, 1);
    } else {
      set.add(-at, -at, 2 * at + 1, 2 * at + 1, 0);
    }
  }
  return set;
}
// Bars of one group across bars of the same, others beside and between these two by two.
Set lattice(std::size_t n, Random&) {
  Set set;
  for (std::size_t i = 0; i < n; ++i) {
    const double at = number(i / 3), end = number(n);
    if (i % 3 == 0) set.add(0, at + 0.1, end, 0.1, 0);
    if (i % 3 == 1) set.add(at + 0.1, 0, 0.1, end, 0);
    if (i % 3 == 2) set.add(at + 0.4, at + 0.4, 0.1, 0.1, i / 3 % 5 + 1);
  }
  return set;
}
// Steps down a stair: their boxes meet side by side, of a group 32 by 32.
Set stairs(std::size_t n, Random& random) {
  Set set;
  for (std::size_t i = 0; i < n; ++i) {
    const double at = number(i / 32);
    set.add(at + 0.4 * random.unit(), -at + 0.4 * random.unit(), 0.5, 0.5, i / 32);
  }
  return set;
}
// Of some of a group, and of one of another each, boxes meet.
Set in_pairs(std::size_t n, Random& random) {
  Set set = two_groups(n, random);
  for (std::size_t i = 0; i < n; ++i) {
    if (i % 2 == 1) set.boxes[i].high = {4 + number(i), 4 + number(i)};
  }
  for (std::size_t i = 1; i < n; i += 2) set.add(3.5 + number(i), 3.5 + number(i), 1, 1, 0);
  set.k = number(n) * number(n) / 4;
  return set;
}

struct Family {
  const char* name;
  std::function<Set(std::size_t, Random&)> make;
  std::size_t most = std::size_t{1} << 16;
};
const std::array families{Family{"one group", one_group},
                          Family{"one group and one other", one_group_and_one},
                          Family{"one group and few others", one_group_and_few},
                          Family{"two groups", two_groups},
                          Family{"layers", layers},
                          Family{"small groups", small_groups},
                          Family{"nested", nested},
                          Family{"lattice", lattice},
                          Family{"stairs", stairs},
                          Family{"in pairs", in_pairs, std::size_t{1} << 10}};

// Calls look(what, set, n) for sets of all sizes.
void for_each_set(const std::function<void(const std::string&, const Set&, double)>& look) {
  for (const Family& family : families) {
    for (int power = least_growth_power; power <= greatest_growth_power(); power += 2) {
      if (std::size_t{1} << power > family.most) break;
      Random random(20261128);
      const Set set = family.make(std::size_t{1} << power, random);
      look(family.name, set, number(set.boxes.size()));
    }
  }
}

// The work of any and count: at least a look at each member, and at most what growth states, to look at a pair
// `weight`.
void add(Growth& growth, const std::string& what, const Set& set, const Cost& any, const Cost& count,
         double weight = 1) {
  const double n = number(set.boxes.size());
  EXPECT_GE(count.probes, set.boxes.size()) << what << ": what is looked at is not counted";
  growth.add("any: " + what, n, weight * set.k, any.probes);
  growth.add("count: " + what, n, weight * set.k, count.probes);
}

TEST(GroupsComplexity, PairsOfBoxes) {
  for_each_set([](const std::string& what, const Set& set, double n) {
    std::uint64_t looks = 0, pairs = 0;
    for_each_box_pair(
        set.boxes,
        [&](std::uint32_t i, std::uint32_t j) {
          EXPECT_NE(set.groups[i], set.groups[j]);
          ++pairs;
          return true;
        },
        nullptr, &looks, set.groups);
    EXPECT_LE(number(pairs), set.k) << what;
    EXPECT_LE(number(looks), 10 * (n * std::log2(n) + set.k)) << what;
  });
}

TEST(GroupsComplexity, Boxes) {
  Growth growth(10);
  for_each_set([&](const std::string& what, const Set& set, double) {
    const planar::Boxes boxes(set.boxes);
    const SetOptions options{Allowed::nothing, set.groups};
    add(growth, what, set, contacts_any(boxes, options).cost, contacts_count(boxes, options).cost);
  });
  growth.expect_no_growth();
}

// In the boxes.
TEST(GroupsComplexity, Circles) {
  Growth growth(10);
  for_each_set([&](const std::string& what, const Set& set, double) {
    std::vector<Disc> discs;
    for (const Box2& b : set.boxes) {
      const double radius = std::min(b.high.x - b.low.x, b.high.y - b.low.y) / 2;
      discs.push_back({{b.low.x + radius, b.low.y + radius}, radius});
    }
    const planar::Discs circles(discs);
    const SetOptions options{Allowed::nothing, set.groups};
    add(growth, what, set, discs_any(circles, options).cost, discs_count(circles, options).cost);
    EXPECT_EQ(discs_count(circles, options).count, contacts_count(circles, options).count) << what;
  });
  growth.expect_no_growth();
}

// Their diagonals, by turns up and down.
TEST(GroupsComplexity, Segments) {
  Growth growth(10);
  for_each_set([&](const std::string& what, const Set& set, double) {
    std::vector<Segment> given;
    for (const Box2& b : set.boxes) {
      given.push_back(given.size() % 3 == 0 ? Segment{{b.low.x, b.high.y}, {b.high.x, b.low.y}}
                                            : Segment{b.low, b.high});
    }
    const planar::Segments segments(given);
    const SetOptions options{Allowed::nothing, set.groups};
    add(growth, what, set, segments_any(segments, options).cost, segments_count(segments, options).cost);
  });
  growth.expect_no_growth();
}

// Quadrangles with a vertex on each side.
TEST(GroupsComplexity, Polygons) {
  Growth growth(10), convex(10);
  for_each_set([&](const std::string& what, const Set& set, double n) {
    std::vector<Polygon> polygons;
    std::vector<planar::ConvexPolygon> hulls;
    for (const Box2& b : set.boxes) {
      const double x = b.high.x - b.low.x, y = b.high.y - b.low.y;
      const std::vector<Point2> ring{{b.low.x + 0.25 * x, b.low.y},
                                     {b.high.x, b.low.y + 0.25 * y},
                                     {b.high.x - 0.25 * x, b.high.y},
                                     {b.low.x, b.high.y - 0.25 * y}};
      polygons.emplace_back(std::vector<std::vector<Point2>>{ring});
      hulls.push_back(planar::ConvexPolygon::hull_of(ring));
    }
    const SetOptions options{Allowed::nothing, set.groups};
    const Cost any = polygons_any(polygons, options).cost, count = polygons_count(polygons, options).cost;
    add(growth, what, set, any, count, 16);
    convex.add("convex: " + what, n, set.k, convex_polygons_any(hulls, options).cost.probes);
  });
  growth.expect_no_growth();
  convex.expect_no_growth();
}

}  // namespace
}  // namespace sunder::tests::boxes_of_groups
