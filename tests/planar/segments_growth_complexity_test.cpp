// How the work of the front doors for sets of segments grows, under every rule and with groups, on families that are
// slow for one method or another.
#include <tests/support/growth.h>
#include <tests/support/shapes.h>

#include <sunder/base/random.h>
#include <sunder/planar/segments/segments_all.h>

#include <array>
#include <functional>
#include <numbers>
#include <string>
#include <vector>

namespace sunder::tests::segments_growth {
namespace {

using planar::Segment;
using planar::Segments;
using planar::SegmentsContact;

struct Set {
  std::vector<Segment> segments;
  double k = 0;  // contacts, those at one point as many as meet there
};

// The middle 90 %.
Segment shortened(const Segment& s) {
  const double x = (s.b.x - s.a.x) / 20, y = (s.b.y - s.a.y) / 20;
  return {{s.a.x + x, s.a.y + y}, {s.b.x - x, s.b.y - y}};
}

Set fan(std::size_t n, Random&) {
  Set set{{}, number(n)};
  for (std::size_t k = 0; k < n; ++k) set.segments.push_back({{0, 0}, {1000, number(k)}});
  return set;
}

// Fans of `blades`, apart from each other.
Set fans(std::size_t n, std::size_t blades) {
  Set set{{}, number(n)};
  const std::size_t columns = 1 + static_cast<std::size_t>(std::sqrt(number(n / blades)));
  for (std::size_t k = 0; k < n; ++k) {
    const std::size_t hub = k / blades;
    const double x = 10 * number(hub % columns), y = 10 * number(hub / columns);
    set.segments.push_back({{x, y}, on_circle(number(k % blades) / number(blades), 4, {x, y})});
  }
  return set;
}
Set fans_of_root(std::size_t n, Random&) { return fans(n, static_cast<std::size_t>(std::sqrt(number(n)))); }
Set fans_of_100(std::size_t n, Random&) { return fans(n, 100); }
Set crowded_fans(std::size_t n, Random&) { return fans(n, 250); }

// Lines through one point that is no end, every other one cut in two there.
Set pencil(std::size_t n, Random&) {
  Set set{{}, number(n)};
  for (std::size_t k = 0; k < n; ++k) {
    const double x = number(k / 3 + 1), y = number(n);
    set.segments.push_back(k % 3 == 0   ? Segment{{-x, -y}, {x, y}}
                           : k % 3 == 1 ? Segment{{0, 0}, {2 * x, y}}
                                        : Segment{{-3 * x, -y}, {0, 0}});
  }
  return set;
}

// Such lines, none of them cut, in pencils of about `lines`.
Set whole_pencils(std::size_t n, std::size_t lines) {
  Set set{{}, number(n)};
  for (std::size_t k = 0; k < n; ++k) {
    const double at = 10 * number(n) * number(k / lines), x = number(k % lines + 1), y = number(n);
    set.segments.push_back({{at - x, -y}, {at + 2 * x, 2 * y}});
  }
  return set;
}
Set whole_pencil(std::size_t n, Random&) { return whole_pencils(n, n); }
Set pencils(std::size_t n, Random&) { return whole_pencils(n, static_cast<std::size_t>(2 * std::sqrt(number(n)))); }

Set cross_hatch(std::size_t n, Random&) { return {hatch(n), number(n / 2) * number(n / 2)}; }

// Hatches of 32 by 32, one over the other in part.
Set hatches(std::size_t n, Random&) {
  Set set{{}, 16 * number(n)};
  for (std::size_t k = 0; k < n; ++k) {
    const double at = 50 * number(k / 64), along = number(k / 2 % 32);
    set.segments.push_back(k % 2 == 0 ? Segment{{at - 1, along}, {at + 32, along}}
                                      : Segment{{at + along, -1}, {at + along, 32}});
  }
  return set;
}

// A comb whose teeth end on its back.
Set comb(std::size_t n, Random&) {
  Set set{{{{-1, 0}, {number(n), 0}}}, number(n)};
  for (std::size_t k = 1; k < n; ++k) set.segments.push_back({{number(k), 0}, {number(k), 1000}});
  return set;
}

// Pieces of y = 2x.
Set on_one_line(std::size_t n, std::uint64_t longest, Random& random) {
  Set set;
  for (std::size_t k = 0; k < n; ++k) {
    const double a = number(random.below(n)), b = a + number(1 + random.below(longest));
    set.segments.push_back({{a, 2 * a}, {b, 2 * b}});
  }
  set.k = number(segments_count(Segments(set.segments)).count);
  return set;
}
Set overlaps(std::size_t n, Random& random) { return on_one_line(n, 32, random); }
Set long_overlaps(std::size_t n, Random& random) { return on_one_line(n, n, random); }

// Spokes that do not reach their hub.
Set needles(std::size_t n, Random&) {
  Set set;
  for (std::size_t k = 0; k < n; ++k) {
    set.segments.push_back({on_circle(number(k) / number(n)), on_circle(number(k) / number(n), 1000)});
  }
  return set;
}

// Diagonals side by side, whose boxes all meet.
Set diagonals(std::size_t n, Random&) {
  Set set;
  for (std::size_t k = 0; k < n; ++k) {
    const double at = number(k) / number(n);
    set.segments.push_back({{at, -at}, {100 + at, 100 - at}});
  }
  return set;
}

// Side by side, each a little shorter at both ends.
Set nested(std::size_t n, Random&) {
  Set set;
  for (std::size_t k = 0; k < n; ++k) {
    set.segments.push_back({{number(k), number(k)}, {3 * number(n) - number(k), number(k)}});
  }
  return set;
}

Set jittered_mesh(std::size_t n, Random& random) { return {mesh_edges(n, random), 2 * number(n)}; }

// A mesh, apart, and one that goes over it from corner to corner.
Set one_huge(std::size_t n, Random& random) {
  Set set;
  for (const Segment& s : mesh_edges(n, random)) set.segments.push_back(shortened(s));
  const double side = std::sqrt(number(n));
  set.segments.push_back({{-side, -side}, {2 * side, 2.1 * side}});
  set.k = 2 * side;
  return set;
}

// Clusters in clusters: no grid parts them all.
Set clusters(std::size_t n, Random& random) {
  Set set;
  for (const Segment& s : mesh_edges(n, random)) {
    const double scale = std::ldexp(1, -static_cast<int>(2 * random.below(20)));
    const Segment t = shortened(s);
    set.segments.push_back({{scale * t.a.x, scale * t.a.y}, {scale * t.b.x, scale * t.b.y}});
  }
  set.k = number(segments_count(Segments(set.segments)).count);
  return set;
}

Set random_short(std::size_t n, Random& random) {
  Set set{short_segments(n, {0, 0}, 1, 5 / std::sqrt(number(n)), random)};
  set.k = number(segments_count(Segments(set.segments)).count);
  return set;
}

// The edges of a star.
Set star(std::size_t n, Random&) {
  Set set{{}, number(n)};
  const auto at = [&](std::size_t k) { return on_circle(number(k % n) / number(n), k % 2 == 0 ? 10 : 1000); };
  for (std::size_t k = 0; k < n; ++k) set.segments.push_back({at(k), at(k + 1)});
  return set;
}

struct Family {
  const char* name;
  std::function<Set(std::size_t, Random&)> make;
};

const std::array families{Family{"fan", fan},
                          Family{"fans", fans_of_root},
                          Family{"fans of 100", fans_of_100},
                          Family{"crowded fans", crowded_fans},
                          Family{"pencil", pencil},
                          Family{"whole pencil", whole_pencil},
                          Family{"pencils", pencils},
                          Family{"cross-hatch", cross_hatch},
                          Family{"cross-hatches", hatches},
                          Family{"comb", comb},
                          Family{"overlaps", overlaps},
                          Family{"long overlaps", long_overlaps},
                          Family{"needles", needles},
                          Family{"diagonals", diagonals},
                          Family{"nested", nested},
                          Family{"mesh", jittered_mesh},
                          Family{"one huge", one_huge},
                          Family{"clusters", clusters},
                          Family{"random", random_short},
                          Family{"star", star}};

constexpr double most_contacts = 2e6;  // in a set of this test

// Of each segment, by number.
struct Grouping {
  const char* name;
  std::uint32_t (*group)(std::uint32_t i);
};
constexpr std::array groupings{Grouping{"", nullptr}, Grouping{", one group", [](std::uint32_t) { return 0u; }},
                               Grouping{", two groups", [](std::uint32_t i) { return i / 2 % 2; }},
                               Grouping{", one and others", [](std::uint32_t i) { return i % 64 == 0 ? i : 0u; }}};

TEST(SegmentsGrowth, OfEachFrontDoor) {
  Growth any(5.9), count(19), any_in_groups(17);
  for (const Family& family : families) {
    for (const Grouping& grouping : groupings) {
      for (const Allowed allowed : {Allowed::nothing, Allowed::shared_endpoint, Allowed::touch}) {
        double given = 0;  // by the set before
        for (int power = least_growth_power; power <= greatest_growth_power(); power += 2) {
          Random random(20261123);
          const Set set = family.make(std::size_t{1} << power, random);
          if (std::max(set.k, 16 * given) > most_contacts) break;
          const Segments segments(set.segments);
          std::vector<std::uint32_t> groups;
          for (std::uint32_t i = 0; grouping.group != nullptr && i < segments.size(); ++i) {
            groups.push_back(grouping.group(i));
          }
          const SetOptions options{allowed, groups};
          const std::string what =
              std::string(family.name) + grouping.name + ", allow " + std::string(name_of(allowed));
          const double n = segments.size();
          (groups.empty() ? any : any_in_groups)
              .add("any: " + what, n, set.k, segments_any(segments, options).cost.probes);
          const CountAnswer<> counted = segments_count(segments, options);
          given = number(counted.count);
          count.add("count: " + what, n, set.k + given, counted.cost.probes);
          if (power > 10) continue;
          EXPECT_EQ(segments_all(segments, options).cost.probes, counted.cost.probes);
        }
      }
    }
  }
  any.expect_no_growth();
  any_in_groups.expect_no_growth();
  count.expect_no_growth();
}

}  // namespace
}  // namespace sunder::tests::segments_growth
