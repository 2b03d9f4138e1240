// polygons_contact, polygons_any and polygons_all and their methods against the scan, on small nasty sets, under every
// rule; and how their probes grow.
#include <tests/support/gathered_polygons.h>
#include <tests/support/nasty_polygons.h>
#include <tests/support/scale.h>

#include <sunder/base/random.h>
#include <sunder/planar/set/polygon_edges.h>
#include <sunder/planar/set/polygon_simple.h>
#include <sunder/planar/set/polygon_valid.h>
#include <sunder/planar/set/polygons_all.h>
#include <sunder/planar/set/polygons_any.h>
#include <sunder/planar/set/polygons_json.h>
#include <sunder/predicate/orient.h>
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

using planar::ContactKind;
using planar::Polygon;
using planar::PolygonsAllAnswer;
using planar::PolygonsAnswer;
using planar::PolygonsContact;
using Ring = std::vector<Point2>;
using Rings = std::vector<Ring>;

enum class Family : int {
  simple,
  tessellation,
  nested,
  twins,
  sliver,
  touching_itself,
  valid,
  annuli,
  pie,
  islands,
  many_inside,
  any_scale
};
constexpr int family_count = 12;
std::string name_of(Family family) {
  constexpr std::array<const char*, family_count> names{"simple", "tessellation",    "nested",      "twins",
                                                        "sliver", "touching itself", "valid",       "annuli",
                                                        "pie",    "islands",         "many inside", "any scale"};
  return names[static_cast<std::size_t>(family)];
}

class PolygonSets {
 public:
  explicit PolygonSets(std::uint64_t seed) : random_(seed), nasty_(seed + 1), gathered_(seed + 2) {}

  std::vector<Rings> next(Family family) {
    switch (family) {
      case Family::simple: return simple_ones(2 + random_.below(4), 9, 5);
      case Family::tessellation: return tessellation();
      case Family::nested: return nested();
      case Family::twins: return twins();
      case Family::sliver: return slivers();
      case Family::touching_itself: return touching_itself();
      case Family::valid: return valid_ones();
      case Family::annuli: return gathered_.annuli();
      case Family::pie: return gathered_.pie();
      case Family::islands: return gathered_.islands();
      case Family::many_inside: return gathered_.many_inside();
      case Family::any_scale: return scaled(next(static_cast<Family>(random_.below(family_count - 1))));
    }
    return {};
  }

  Random& random() { return random_; }

 private:
  double at(std::uint64_t below) { return static_cast<double>(random_.below(below)); }
  bool one_in(std::uint64_t n) { return random_.below(n) == 0; }

  static bool is_simple(const Rings& rings) {
    const auto closed = [](const Ring& ring) { return ring.front() == ring.back(); };
    return std::none_of(rings.begin(), rings.end(), closed) && planar::polygon_simple_by_scan(Polygon(rings)).simple();
  }

  static Ring moved(Ring ring, double x, double y) {
    for (Point2& p : ring) p = {p.x + x, p.y + y};
    return ring;
  }
  static Ring box(double left, double bottom, double right, double top) {
    return {{left, bottom}, {right, bottom}, {right, top}, {left, top}};
  }
  // It begins elsewhere and may run the other way.
  Ring turned(Ring ring) {
    std::rotate(ring.begin(), ring.begin() + static_cast<std::ptrdiff_t>(random_.below(ring.size())), ring.end());
    if (one_in(2)) std::reverse(ring.begin(), ring.end());
    return ring;
  }

  // 3 to 7 points of a square grid, in an order that makes a simple ring.
  Ring simple_ring(std::uint64_t side) {
    while (true) {
      Ring ring(3 + random_.below(5));
      for (Point2& p : ring) p = {at(side), at(side)};
      for (int trial = 0; trial < 8; ++trial) {
        if (is_simple({ring})) return ring;
        for (std::size_t k = ring.size(); k-- > 1;) std::swap(ring[k], ring[random_.below(k + 1)]);
      }
    }
  }

  std::vector<Rings> simple_ones(std::uint64_t count, std::uint64_t range, std::uint64_t side) {
    std::vector<Rings> set(count);
    for (Rings& rings : set) rings = {moved(simple_ring(side), at(range), at(range))};
    return set;
  }

  // Cells with common vertices and sides, some cut in two, with vertices inside sides; a few are changed a little.
  std::vector<Rings> tessellation() {
    constexpr std::size_t side = 3;
    std::array<std::array<Point2, side + 1>, side + 1> corner;
    for (std::size_t i = 0; i <= side; ++i) {
      for (std::size_t j = 0; j <= side; ++j) {
        corner[i][j] = {6 * static_cast<double>(i) + at(3), 6 * static_cast<double>(j) + at(3)};
      }
    }
    std::vector<Rings> set;
    for (std::size_t i = 0; i < side; ++i) {
      for (std::size_t j = 0; j < side; ++j) {
        if (one_in(4)) continue;
        Ring cell{corner[i][j], corner[i + 1][j], corner[i + 1][j + 1], corner[i][j + 1]};
        if (one_in(3)) {
          set.push_back({turned({cell[0], cell[1], cell[2]})});
          set.push_back({turned({cell[0], cell[2], cell[3]})});
          continue;
        }
        if (one_in(3)) {
          const std::size_t k = random_.below(4);
          const Point2 p = cell[k], q = cell[(k + 1) % 4];
          cell.insert(cell.begin() + static_cast<std::ptrdiff_t>(k) + 1, {(p.x + q.x) / 2, (p.y + q.y) / 2});
        }
        if (one_in(3)) {  // a hole, and what fills it, or nearly so
          Ring hole;
          const Point2 p = cell[0];
          for (const Point2& q : {Point2{3, 3}, Point2{4, 3}, Point2{3, 4}}) hole.push_back({p.x + q.x, p.y + q.y});
          if (!is_simple({cell, hole})) continue;
          set.push_back({turned(cell), turned(hole)});
          if (one_in(3)) hole[0].x -= at(2);
          if (one_in(2)) set.push_back({turned(hole)});
          continue;
        }
        set.push_back({turned(cell)});
      }
    }
    if (!set.empty() && one_in(3)) {
      Rings& rings = set[random_.below(set.size())];
      Rings changed = rings;
      Point2& p = changed.front()[random_.below(changed.front().size())];
      p = {p.x + at(3) - 1, p.y + at(3) - 1};
      if (is_simple(changed)) rings = changed;
    }
    return set;
  }

  // A frame with one or two holes, and others in the holes, on their sides, around it.
  std::vector<Rings> nested() {
    std::vector<Rings> set{{turned(box(0, 0, 20, 20)), turned(box(2, 2, 10, 10))}};
    if (one_in(2)) set[0].push_back(turned(box(12, 12, 18, 18)));
    if (one_in(3)) set[0].push_back(turned(box(4, 4, 8, 8)));  // an island
    const std::uint64_t count = 1 + random_.below(3);
    for (std::uint64_t k = 0; k < count; ++k) {
      switch (random_.below(6)) {
        case 0: set.push_back({turned(box(2, 2, 10, 10))}); break;                         // fills the hole
        case 1: set.push_back({turned(box(2 + at(3), 2 + at(3), 10, 9 + at(3)))}); break;  // nearly so
        case 2: set.push_back({moved(simple_ring(5), 1 + at(8), 1 + at(8))}); break;
        case 3: set.push_back({turned({{at(3), 6}, {6, at(3)}, {10, 6}, {6, 10}})}); break;
        case 4: set.push_back({turned(box(-2, -2, 22 + at(2), 22)), turned(box(0, 0, 20 + at(2), 20))}); break;
        default: set.push_back({turned(box(12, 12, 18, 18)), turned(box(14, 14, 15 + at(3), 16))});
      }
    }
    return set;
  }

  // Polygons of some of the same rings.
  std::vector<Rings> twins() {
    Rings pool{box(0, 0, 3, 3), box(4, 0, 7, 3), {{0, 4}, {3, 4}, {0, 7}}, {{8, 0}, {11, 0}, {8, 3}}, box(4, 4, 7, 7)};
    std::vector<Rings> set(2 + random_.below(2));
    for (Rings& rings : set) {
      for (const Ring& ring : pool) {
        if (one_in(3)) rings.push_back(turned(ring));
      }
      if (rings.empty()) rings.push_back(turned(pool[random_.below(pool.size())]));
      if (one_in(4)) rings = {turned(simple_ring(8))};
    }
    return set;
  }

  std::vector<Rings> slivers() {
    std::vector<Rings> set;
    const std::uint64_t count = 2 + random_.below(3);
    while (set.size() < count) {
      const double y = at(24);
      const Ring ring{{at(4), y}, {40 + at(4), y + at(4)}, {20 + at(4), y + at(3)}};
      if (is_simple({ring})) set.push_back({turned(ring)});
    }
    return set;
  }

  // Rings that touch themselves or one another in vertices or on edges; one to fill a gap, or not quite.
  std::vector<Rings> touching_itself() {
    std::vector<Rings> set;
    switch (random_.below(4)) {
      case 0: set.push_back({turned(box(0, 0, 8, 8)), turned({{0, 0}, {4, 2}, {2, 4}})}); break;  // a hole at a corner
      case 1: set.push_back({turned(box(0, 0, 8, 8)), turned({{4, 0}, {6, 4}, {2, 4}})}); break;  // on a side
      case 2: set.push_back({turned(box(0, 0, 4, 4)), turned(box(4, 4, 8, 8))}); break;           // in a corner
      default:  // one ring that comes back to a vertex
        set.push_back({turned({{0, 0}, {8, 0}, {8, 8}, {4, 8}, {6, 4}, {2, 4}, {4, 8}, {0, 8}})});
    }
    const std::uint64_t count = 1 + random_.below(3);
    for (std::uint64_t k = 0; k < count; ++k) {
      switch (random_.below(6)) {
        case 0: set.push_back({turned({{0, 0}, {4, 2}, {2, 4 - at(2)}})}); break;
        case 4: set.push_back({turned(box(-1, -3, 9, 0))}); break;
        case 1: set.push_back({turned({{4, 0}, {6, 4}, {2 + at(2), 4}})}); break;
        case 2: set.push_back({turned({{4, 8}, {6, 4}, {2, 4 + at(2)}})}); break;
        case 3: set.push_back({turned(box(4, 0, 8, 4))}); break;
        default: set.push_back({moved(simple_ring(5), at(7) - 1, at(7) - 1)});
      }
    }
    return set;
  }

  // Parts of multipolygons that are valid, also with rings that touch themselves; moved a little. Vertices are
  // repeated, holes touch their shells and one another.
  std::vector<Rings> valid_ones() {
    std::vector<Rings> set;
    const std::size_t count = 2 + random_.below(3);
    const planar::ValidOptions options{one_in(3) ? planar::PolygonRule::self_touch : planar::PolygonRule::valid};
    while (set.size() < count) {
      const std::vector<Rings> parts = nasty_.next(static_cast<NastyFamily>(random_.below(nasty_family_count)));
      if (!planar::polygon_defects(parts, options).valid()) continue;
      const double x = at(3), y = one_in(4) ? 8 : at(3);
      for (const Rings& rings : parts) {
        set.emplace_back();
        for (const Ring& ring : rings) set.back().push_back(turned(moved(ring, x, y)));
      }
    }
    return set;
  }

  // By a power of two, so that they stay what they are.
  std::vector<Rings> scaled(std::vector<Rings> set) {
    const double scale = std::ldexp(1, static_cast<int>(random_.between(-1060, 1000)));
    for (Rings& rings : set) {
      for (Ring& ring : rings) {
        for (Point2& p : ring) p = {2 * scale * p.x, 2 * scale * p.y};
      }
    }
    return set;
  }

  Random random_;
  NastyPolygons nasty_;
  GatheredPolygons gathered_;
};

std::vector<Polygon> made(const std::vector<Rings>& set) {
  std::vector<Polygon> polygons;
  for (const Rings& rings : set) polygons.emplace_back(rings);
  return polygons;
}

// What is shown is so: the edges meet in that way, or the vertex is inside. Overlapping by edges is as by scan.
void expect_shown(const PolygonsContact& c, const std::vector<Polygon>& polygons) {
  ASSERT_LT(c.i, c.j);
  ASSERT_LT(c.j, polygons.size());
  const Polygon &a = polygons[c.i], &b = polygons[c.j];
  if (c.kind != ContactKind::none) {
    ASSERT_LT(c.of_i, a.size());
    ASSERT_LT(c.of_j, b.size());
    ASSERT_EQ(planar::segment_segment(sorted(a.edge(c.of_i)), sorted(b.edge(c.of_j))), c.kind);
    if (c.kind == ContactKind::crossing) {
      ASSERT_EQ(c.contact, Contact::overlapping);
    }
    return;
  }
  ASSERT_EQ(c.contact, Contact::overlapping);
  const Polygon &inner = c.i_inside ? a : b, &outer = c.i_inside ? b : a;
  const std::uint32_t vertex = c.i_inside ? c.of_i : c.of_j;
  ASSERT_LT(vertex, inner.size());
  const Point2 p = inner.vertices()[vertex];
  bool inside = false;
  for (std::uint32_t k = 0; k < outer.size(); ++k) {
    const planar::Segment e = sorted(outer.edge(k));
    ASSERT_EQ(planar::segment_segment({p, p}, e), ContactKind::none);
    if (!planar::lexicographically_less(p, e.a) && planar::lexicographically_less(p, e.b)) {
      inside ^= orient_2d(e.a, e.b, p) == Sign::positive;
    }
  }
  ASSERT_TRUE(inside);
}

// The answer in a file, as the verifier reads it. Where two overlap, the point says so: it is inside of both.
void expect_certified(const PolygonsAnswer& answer, const std::vector<Polygon>& polygons, const SetOptions& options) {
  const auto is_accepted = [&](Allowed allowed) {
    const std::string text = certificate_text(polygons, allowed, answer, options.groups);
    return sunder_verifier::verify_text(text, "differential").accepted();
  };
  ASSERT_TRUE(is_accepted(options.allowed)) << certificate_text(polygons, options.allowed, answer, options.groups);
  ASSERT_EQ(is_accepted(Allowed::touch), !answer.meet() || answer.found->contact != Contact::touching);
}

// A list, and its length, in a file, as the verifier reads it; and neither of another length.
void expect_list_certified(const std::vector<PolygonsContact>& contacts, const std::vector<Polygon>& polygons,
                           const SetOptions& options) {
  const planar::PolygonsAsked asked{polygons, options.allowed, options.groups};
  const planar::SweepEvents events = *planar::polygon_events(polygons);
  const auto is_accepted = [&](const auto& write) {
    std::string text;
    ClaimsWriter file([&](std::string_view piece) { text += piece; });
    write(file);
    file.end();
    return sunder_verifier::verify_text(text, "differential").accepted();
  };
  const auto is_list = [&](std::size_t length) {
    return is_accepted([&](ClaimsWriter& file) {
      planar::write_these(file, asked, events, [&](const auto& take) {
        for (std::size_t k = 0; k < length; ++k) take(contacts[k].i, contacts[k].j);
      });
    });
  };
  const auto is_number = [&](std::size_t number) {
    return is_accepted([&](ClaimsWriter& file) { planar::write_count(file, asked, events, number); });
  };
  ASSERT_TRUE(is_list(contacts.size()));
  ASSERT_TRUE(is_number(contacts.size()));
  ASSERT_FALSE(is_number(contacts.size() + 1));
  if (!contacts.empty()) {
    ASSERT_FALSE(is_list(contacts.size() - 1));
  }
}

constexpr std::array<Allowed, 3> rules{Allowed::nothing, Allowed::shared_endpoint, Allowed::touch};

struct Rates {
  int sets = 0, proofs = 0;
  std::array<int, 3> meet{};
  std::array<int, 3> contacts{};                     // of pairs
  std::map<ContactKind, int> touching, overlapping;  // what shows them
};

void compare_on(const std::vector<Polygon>& polygons, Groups groups, Rates& rates) {
  const PolygonsAllAnswer truth = planar::polygons_all_by_scan(polygons, {Allowed::nothing, groups, nullptr});
  for (std::size_t r = 0; r < rules.size(); ++r) {
    const SetOptions options{rules[r], groups, nullptr};
    std::vector<PolygonsContact> count_here;
    std::copy_if(truth.contacts.begin(), truth.contacts.end(), std::back_inserter(count_here),
                 [&](const PolygonsContact& c) { return counts(c, rules[r]); });
    rates.meet[r] += !count_here.empty();
    for (auto* method : {planar::polygons_any_by_boxes, planar::polygons_any_by_grid, planar::polygons_any_by_sweep}) {
      const PolygonsAnswer answer = method(polygons, options);
      ASSERT_EQ(answer.meet(), !count_here.empty()) << "allowed " << name_of(rules[r]);
      if (!answer.meet()) continue;
      ASSERT_NO_FATAL_FAILURE(expect_shown(*answer.found, polygons));
      const auto same_pair = [&](const PolygonsContact& c) { return c.i == answer.found->i && c.j == answer.found->j; };
      const auto at = std::find_if(count_here.begin(), count_here.end(), same_pair);
      ASSERT_NE(at, count_here.end());
      ASSERT_EQ(answer.found->contact, at->contact);
    }
    const planar::PolygonsCountAnswer counted = planar::polygons_count(polygons, options);
    const auto overlapping = std::count_if(count_here.begin(), count_here.end(),
                                           [](const PolygonsContact& c) { return c.contact == Contact::overlapping; });
    ASSERT_EQ(counted.overlapping, static_cast<std::uint64_t>(overlapping));
    ASSERT_EQ(counted.touching + counted.overlapping, count_here.size());
    for (auto* method : {planar::polygons_all_by_boxes, planar::polygons_all_by_grid, planar::polygons_all_by_sweep}) {
      const PolygonsAllAnswer all = method(polygons, options);
      ASSERT_EQ(all.contacts.size(), count_here.size()) << "allowed " << name_of(rules[r]);
      for (std::size_t k = 0; k < count_here.size(); ++k) {
        const PolygonsContact &c = all.contacts[k], &expected = count_here[k];
        ASSERT_NO_FATAL_FAILURE(expect_shown(c, polygons));
        ASSERT_EQ(c.i, expected.i);
        ASSERT_EQ(c.j, expected.j);
        ASSERT_EQ(c.contact, expected.contact) << c.i << " " << c.j;
        if (c.contact == Contact::touching) {
          ASSERT_EQ(c.kind, expected.kind);
        }
        if (r == 0) ++(c.contact == Contact::touching ? rates.touching : rates.overlapping)[c.kind];
      }
    }
  }
  const SetOptions options{rules[static_cast<std::size_t>(rates.sets) % rules.size()], groups, nullptr};
  for (auto* method : {planar::polygons_any_by_boxes, planar::polygons_any_by_grid, planar::polygons_any_by_sweep}) {
    const PolygonsAnswer answer = method(polygons, options);
    ASSERT_NO_FATAL_FAILURE(expect_certified(answer, polygons, options));
    rates.proofs += answer.meet() ? 0 : 1;
  }
  std::vector<PolygonsContact> listed;
  std::copy_if(truth.contacts.begin(), truth.contacts.end(), std::back_inserter(listed),
               [&](const PolygonsContact& c) { return counts(c, options.allowed); });
  ASSERT_NO_FATAL_FAILURE(expect_list_certified(listed, polygons, options));
  for (std::uint32_t i = 0; i < polygons.size(); ++i) {
    for (std::uint32_t j = i + 1; j < polygons.size() && groups.empty(); ++j) {
      const PolygonsContact pair = planar::polygons_contact(polygons[i], polygons[j]).found.value_or(PolygonsContact());
      const auto same_pair = [&](const PolygonsContact& c) { return c.i == i && c.j == j; };
      const auto at = std::find_if(truth.contacts.begin(), truth.contacts.end(), same_pair);
      const Contact expected = at == truth.contacts.end() ? Contact::none : at->contact;
      ASSERT_EQ(pair.contact, expected) << i << " " << j;
      if (pair.contact == Contact::touching) {
        ASSERT_EQ(pair.kind, at->kind);
      }
      ++rates.contacts[static_cast<std::size_t>(expected)];
    }
  }
}

TEST(PolygonsDifferential, MethodsAgreeWithTheScan) {
  const int count = scaled_count(20000);
  const std::uint64_t seed = chosen_seed(20261123);
  SCOPED_TRACE("seed " + std::to_string(seed));
  PolygonSets sets(seed);
  std::map<Family, Rates> rates;
  for (int k = 0; k < count; ++k) {
    Family family = static_cast<Family>(k % family_count);
    if (family == Family::any_scale && k % 9 != 0) family = Family::simple;  // exact fractions are slow
    const std::vector<Polygon> polygons = made(sets.next(family));
    std::vector<std::uint32_t> groups;
    if (k % 5 == 1) {
      for (std::size_t i = 0; i < polygons.size(); ++i) {
        groups.push_back(static_cast<std::uint32_t>(sets.random().below(3)));
      }
    }
    ++rates[family].sets;
    ASSERT_NO_FATAL_FAILURE(compare_on(polygons, groups, rates[family])) << k << " " << name_of(family);
  }
  std::printf("%-16s %6s %10s %14s %6s | %8s %9s %12s\n", "family", "sets", "some meet", "not at ends", "over",  //
              "apart", "touching", "overlapping");
  std::map<ContactKind, int> touching, overlapping;
  int proofs = 0;
  for (const auto& [family, r] : rates) {
    std::printf("%-16s %6d %10d %14d %6d | %8d %9d %12d\n", name_of(family).c_str(), r.sets, r.meet[0], r.meet[1],
                r.meet[2], r.contacts[0], r.contacts[1], r.contacts[2]);
    proofs += r.proofs;
    for (const auto& [kind, n] : r.touching) touching[kind] += n;
    for (const auto& [kind, n] : r.overlapping) overlapping[kind] += n;
  }
  for (const auto& [kind, n] : touching) std::printf("touching by %s: %d\n", name_of(kind).data(), n);
  for (const auto& [kind, n] : overlapping) std::printf("overlapping by %s: %d\n", name_of(kind).data(), n);
  std::printf("%d proofs that none meet\n", proofs);
  if (count < 10000) return;  // too few for the rates below
  for (const auto& [family, r] : rates) {
    EXPECT_GT(r.meet[2], r.sets / 12) << name_of(family);
    EXPECT_LT(r.meet[2], r.sets - r.sets / 12) << name_of(family);
    for (const int n : r.contacts) EXPECT_GT(n, r.sets / 20) << name_of(family);
  }
  for (const ContactKind kind : {ContactKind::shared_endpoint, ContactKind::touch, ContactKind::overlap}) {
    EXPECT_GT(touching[kind], count / 100) << name_of(kind);
    EXPECT_GT(overlapping[kind], count / 200) << name_of(kind);
  }
  EXPECT_GT(overlapping[ContactKind::none], count / 200);
  EXPECT_GT(proofs, count / 20);
  EXPECT_GT(overlapping[ContactKind::crossing], count / 20);
}

}  // namespace
}  // namespace sunder::tests
