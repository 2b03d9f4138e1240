// How the work of the front doors for sets of discs grows, under every rule and with groups; and that for their common
// part.
#include <tests/support/growth.h>
#include <tests/support/shapes.h>

#include <sunder/base/random.h>
#include <sunder/near/cover_order.h>
#include <sunder/planar/discs/disc_boxes.h>
#include <sunder/planar/discs/discs_all.h>
#include <sunder/planar/region/disc_intersection.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <numbers>
#include <string>
#include <vector>

namespace sunder::tests::discs_growth {
namespace {

using planar::Discs;

struct Set {
  std::vector<Disc> circles;
  double k = 0;  // pairs whose boxes meet, about
};

Set packed(std::size_t n, double spacing, double k) {
  Set set{{}, k};
  const std::size_t side = static_cast<std::size_t>(std::ceil(std::sqrt(number(n))));
  for (std::size_t i = 0; i < n; ++i) {
    set.circles.push_back({{spacing * number(i % side), spacing * number(i / side)}, 1});
  }
  return set;
}
Set apart(std::size_t n, Random&) { return packed(n, 2.5, 0); }
Set touching(std::size_t n, Random&) { return packed(n, 2, 4 * number(n)); }

// Along a diagonal: only boxes meet.
Set diagonal(std::size_t n, Random&) {
  Set set{{}, number(n)};
  for (std::size_t i = 0; i < n; ++i) set.circles.push_back({{1.5 * number(i), 1.5 * number(i)}, 1});
  return set;
}

// Such diagonals of 150, far apart.
Set diagonals(std::size_t n, Random&) {
  Set set{{}, number(n)};
  const std::size_t side = 1 + static_cast<std::size_t>(std::sqrt(number(n) / 150));
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t cluster = i / 150;
    const double x = 2000 * number(cluster % side), y = 2000 * number(cluster / side), along = 1.5 * number(i % 150);
    set.circles.push_back({{x + along, y + along}, 1});
  }
  return set;
}

Set nested(std::size_t n, Random&) {
  Set set{{}, number(n) * number(n - 1) / 2};
  for (std::size_t i = 0; i < n; ++i) set.circles.push_back({{0, 0}, 1 + number(i)});
  return set;
}

// All through the origin, each inside of the next.
Set through_one_point(std::size_t n, Random& random) {
  Set set = nested(n, random);
  for (Disc& c : set.circles) c.center.x = c.radius;
  return set;
}

Set one_huge(std::size_t n, Random& random) {
  Set set = apart(n - 1, random);
  set.circles.push_back({{0, 0}, 4 * std::sqrt(number(n))});
  set.k = number(n);
  return set;
}

Set somewhere(std::size_t n, Random& random) {
  return {discs_in_square(n, {0, 0}, 1, 2 / std::sqrt(number(n)), random), 8 * number(n)};
}

// In clusters in clusters.
Set clusters(std::size_t n, Random&) {
  Set set;
  const std::size_t side = static_cast<std::size_t>(std::sqrt(number(n))), levels = 16;
  for (std::size_t i = 0; i < n; ++i) {
    const double scale = std::ldexp(1, -static_cast<int>(20 * (i % levels)));
    const double x = 2.5 * number(1 + i / levels % side), y = 2.5 * number(1 + i / levels / side);
    set.circles.push_back({{scale * x, scale * y}, scale});
  }
  return set;
}

Set ring(std::size_t n, double radius) {
  Set set;
  for (std::size_t i = 0; i < n; ++i) {
    set.circles.push_back({on_circle(number(i) / number(n)), radius});
  }
  return set;
}
Set ring_apart(std::size_t n, Random&) { return ring(n, 1 / number(n)); }

// Apart from each other, in a row, of sizes that differ: as chance has it, or each larger than all before it together.
Set sized_row(std::size_t n, Random& random) {
  Set set;
  double x = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const double radius = std::exp2(random.uniform(-10, 4)), y = random.uniform(-1, 1);
    set.circles.push_back({{x + radius, y}, radius});
    x += 2.02 * radius;
  }
  return set;
}
Set growing_row(std::size_t n, Random&) {
  Set set;
  for (std::size_t i = 0; i < n; ++i) {
    const double x = std::exp2(600 * number(i) / number(n));
    set.circles.push_back({{x, 0}, 200 / number(n) * x});
  }
  return set;
}

// Small discs in the corners of the boxes of four big ones, and between them.
Set in_corners(std::size_t n, Random&) {
  Set set{{{{0, 0}, 1}, {{2.2, 0}, 1}, {{0, 2.2}, 1}, {{2.2, 2.2}, 1}}, number(n)};
  const std::size_t side = static_cast<std::size_t>(std::sqrt(number(n)));
  for (std::size_t i = 0; i < n - 4; ++i) {
    const double step = 0.8 / number(side);
    const double x = 0.7 + step * number(i % side), y = 0.7 + step * number(i / side);
    if (std::hypot(x < 1.1 ? x : 2.2 - x, y < 1.1 ? y : 2.2 - y) > 1 + step)
      set.circles.push_back({{x, y}, 0.3 * step});
  }
  return set;
}

struct Family {
  const char* name;
  std::function<Set(std::size_t, Random&)> make;
};

struct Grouping {
  const char* name;
  std::uint32_t (*group)(std::uint32_t i);
};
constexpr std::array groupings{Grouping{"", nullptr}, Grouping{", one group", [](std::uint32_t) { return 0u; }},
                               Grouping{", two groups", [](std::uint32_t i) { return i / 2 % 2; }}};

TEST(DiscsGrowth, OfEachFrontDoor) {
  constexpr double most_pairs = 4e6;
  Growth any(3.4), count(4.5), any_in_groups(7), count_in_groups(8), cover(3.0);
  for (const Family& family :
       {Family{"apart", apart}, Family{"touching", touching}, Family{"diagonal", diagonal},
        Family{"diagonals", diagonals}, Family{"nested", nested}, Family{"through one point", through_one_point},
        Family{"one huge", one_huge}, Family{"somewhere", somewhere}, Family{"clusters", clusters},
        Family{"ring", ring_apart}, Family{"sized row", sized_row}, Family{"growing row", growing_row},
        Family{"in corners", in_corners}}) {
    for (const Grouping& grouping : groupings) {
      for (const Allowed allowed : {Allowed::nothing, Allowed::touch}) {
        for (int power = least_growth_power; power <= greatest_growth_power(); power += 2) {
          Random random(20261123);
          const Set set = family.make(std::size_t{1} << power, random);
          if (set.k > most_pairs) break;
          const Discs circles(set.circles);
          std::vector<std::uint32_t> groups;
          for (std::uint32_t i = 0; grouping.group != nullptr && i < circles.size(); ++i) {
            groups.push_back(grouping.group(i));
          }
          const SetOptions options{allowed, groups};
          const std::string what =
              std::string(family.name) + grouping.name + ", allow " + std::string(name_of(allowed));
          const double n = circles.size();
          (groups.empty() ? any : any_in_groups).add("any: " + what, n, set.k, discs_any(circles, options).cost.probes);
          const std::uint64_t probes = discs_count(circles, options).cost.probes;
          (groups.empty() ? count : count_in_groups).add("count: " + what, n, set.k, probes);
          if (allowed == Allowed::nothing) {
            const std::vector<Box2> boxes = rounded_boxes(circles);
            const std::uint64_t looks = cover_looks(cover_order(boxes, groups), boxes, groups, ~std::uint64_t{0});
            cover.add("proof: " + what, n, set.k, looks);
          }
          if (power > 10) continue;
          EXPECT_EQ(discs_all(circles, options).cost.probes, probes);
        }
      }
    }
  }
  any.expect_no_growth();
  count.expect_no_growth();
  any_in_groups.expect_no_growth();
  count_in_groups.expect_no_growth();
  cover.expect_no_growth();
}

// Of discs that hold the origin, but for the first ring.
TEST(DiscsGrowth, OfTheirCommonPart) {
  const std::array families{Family{"ring, empty", [](std::size_t n, Random&) { return ring(n, 0.5); }},
                            Family{"ring, a point", [](std::size_t n, Random&) { return ring(n, 1); }},
                            Family{"ring", [](std::size_t n, Random&) { return ring(n, 1.5); }},
                            Family{"through one point", through_one_point},
                            Family{"nested", nested},
                            Family{"anywhere", [](std::size_t n, Random& random) {
                                     Set set;
                                     for (std::size_t i = 0; i < n; ++i) {
                                       set.circles.push_back({{random.unit(), random.unit()}, 2 + random.unit()});
                                     }
                                     return set;
                                   }}};
  Growth growth(3.5);
  for (const Family& family : families) {
    for (int power = least_growth_power; power <= greatest_growth_power(); power += 2) {
      Random random(20261123);
      const Discs circles(family.make(std::size_t{1} << power, random).circles);
      growth.add(family.name, circles.size(), 0, disc_intersection(circles).cost.probes);
    }
  }
  growth.expect_no_growth();
}

}  // namespace
}  // namespace sunder::tests::discs_growth
