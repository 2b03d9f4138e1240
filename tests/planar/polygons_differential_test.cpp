// polygons_contact, polygons_any and polygons_all and their methods against the scan, on small nasty sets, under every
// rule; and how their probes grow.
#include <tests/support/allowed_rules.h>
#include <tests/support/polygon_sets.h>
#include <tests/support/scale.h>

#include <sunder/base/random.h>
#include <sunder/planar/polygons/polygon_edges.h>
#include <sunder/planar/polygons/polygon_simple.h>
#include <sunder/planar/polygons/polygon_valid.h>
#include <sunder/planar/polygons/polygons_all.h>
#include <sunder/planar/polygons/polygons_any.h>
#include <sunder/planar/polygons/polygons_claims.h>
#include <sunder/predicate/point/orient.h>
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

// What is shown is so: the edges meet in that way, or the vertex is inside. Overlapping by edges is as by scan.
void expect_shown(const PolygonsContact& c, const std::vector<Polygon>& polygons) {
  ASSERT_LT(c.i, c.j);
  ASSERT_LT(c.j, polygons.size());
  const Polygon &a = polygons[c.i], &b = polygons[c.j];
  if (c.kind != ContactKind::none) {
    ASSERT_LT(c.of_i, a.size());
    ASSERT_LT(c.of_j, b.size());
    ASSERT_EQ(planar::segment_segment(sorted(a.edge(c.of_i)), sorted(b.edge(c.of_j))), c.kind);
    return;
  }
  ASSERT_EQ(c.contact, Relation::overlapping);
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
  ASSERT_EQ(is_accepted(Allowed::touch), !answer.meet() || answer.found->contact != Relation::touching);
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
        for (std::size_t k = 0; k < length; ++k) take(contacts[k]);
      });
    });
  };
  const auto touching = static_cast<std::size_t>(std::count_if(
      contacts.begin(), contacts.end(), [](const PolygonsContact& c) { return c.contact == Relation::touching; }));
  const auto is_number = [&](std::size_t number) {
    return is_accepted(
        [&](ClaimsWriter& file) { planar::write_count(file, asked, events, number - touching, touching); });
  };
  ASSERT_TRUE(is_list(contacts.size()));
  ASSERT_TRUE(is_number(contacts.size()));
  ASSERT_FALSE(is_number(contacts.size() + 1));
  if (!contacts.empty()) {
    ASSERT_FALSE(is_list(contacts.size() - 1));
  }
}

struct PolygonRates {
  int sets = 0, proofs = 0;
  std::array<int, 3> meet{};
  std::array<int, 3> contacts{};                     // of pairs
  std::map<ContactKind, int> touching, overlapping;  // what shows them
};

void compare_on(const std::vector<Polygon>& polygons, Groups groups, PolygonRates& rates) {
  const PolygonsAllAnswer truth = planar::polygons_all_by_scan(polygons, {Allowed::nothing, groups, nullptr});
  for (std::size_t r = 0; r < allowed_rules.size(); ++r) {
    const SetOptions options{allowed_rules[r], groups, nullptr};
    std::vector<PolygonsContact> count_here;
    std::copy_if(truth.found.begin(), truth.found.end(), std::back_inserter(count_here),
                 [&](const PolygonsContact& c) { return counts(c, allowed_rules[r]); });
    rates.meet[r] += !count_here.empty();
    for (auto* method : {planar::polygons_any_by_boxes, planar::polygons_any_by_grid, planar::polygons_any_by_sweep}) {
      const PolygonsAnswer answer = method(polygons, options);
      ASSERT_EQ(answer.meet(), !count_here.empty()) << "allowed " << name_of(allowed_rules[r]);
      if (!answer.meet()) continue;
      ASSERT_NO_FATAL_FAILURE(expect_shown(*answer.found, polygons));
      const auto same_pair = [&](const PolygonsContact& c) { return c.i == answer.found->i && c.j == answer.found->j; };
      const auto at = std::find_if(count_here.begin(), count_here.end(), same_pair);
      ASSERT_NE(at, count_here.end());
      ASSERT_EQ(answer.found->contact, at->contact);
    }
    const planar::PolygonsCountAnswer counted = planar::polygons_count(polygons, options);
    const auto overlapping = std::count_if(count_here.begin(), count_here.end(),
                                           [](const PolygonsContact& c) { return c.contact == Relation::overlapping; });
    ASSERT_EQ(counted.count.overlapping, static_cast<std::uint64_t>(overlapping));
    ASSERT_EQ(counted.count.touching + counted.count.overlapping, count_here.size());
    for (auto* method : {planar::polygons_all_by_boxes, planar::polygons_all_by_grid, planar::polygons_all_by_sweep}) {
      const PolygonsAllAnswer all = method(polygons, options);
      ASSERT_EQ(all.found.size(), count_here.size()) << "allowed " << name_of(allowed_rules[r]);
      for (std::size_t k = 0; k < count_here.size(); ++k) {
        const PolygonsContact &c = all.found[k], &expected = count_here[k];
        ASSERT_NO_FATAL_FAILURE(expect_shown(c, polygons));
        ASSERT_EQ(c.i, expected.i);
        ASSERT_EQ(c.j, expected.j);
        ASSERT_EQ(c.contact, expected.contact) << c.i << " " << c.j;
        if (c.contact == Relation::touching) {
          ASSERT_EQ(c.kind, expected.kind);
        }
        if (r == 0) ++(c.contact == Relation::touching ? rates.touching : rates.overlapping)[c.kind];
      }
    }
  }
  const SetOptions options{allowed_rules[static_cast<std::size_t>(rates.sets) % allowed_rules.size()], groups, nullptr};
  for (auto* method : {planar::polygons_any_by_boxes, planar::polygons_any_by_grid, planar::polygons_any_by_sweep}) {
    const PolygonsAnswer answer = method(polygons, options);
    ASSERT_NO_FATAL_FAILURE(expect_certified(answer, polygons, options));
    rates.proofs += answer.meet() ? 0 : 1;
  }
  std::vector<PolygonsContact> listed;
  std::copy_if(truth.found.begin(), truth.found.end(), std::back_inserter(listed),
               [&](const PolygonsContact& c) { return counts(c, options.allowed); });
  ASSERT_NO_FATAL_FAILURE(expect_list_certified(listed, polygons, options));
  for (std::uint32_t i = 0; i < polygons.size(); ++i) {
    for (std::uint32_t j = i + 1; j < polygons.size() && groups.empty(); ++j) {
      const PolygonsContact pair = planar::polygons_contact(polygons[i], polygons[j]).found.value_or(PolygonsContact());
      const auto same_pair = [&](const PolygonsContact& c) { return c.i == i && c.j == j; };
      const auto at = std::find_if(truth.found.begin(), truth.found.end(), same_pair);
      const Relation expected = at == truth.found.end() ? Relation::none : at->contact;
      ASSERT_EQ(pair.contact, expected) << i << " " << j;
      if (pair.contact == Relation::touching) {
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
  std::map<PolygonFamily, PolygonRates> rates;
  for (int k = 0; k < count; ++k) {
    PolygonFamily family = static_cast<PolygonFamily>(k % polygon_family_count);
    if (family == PolygonFamily::any_scale && k % 9 != 0) family = PolygonFamily::simple;  // exact fractions are slow
    const std::vector<Polygon> polygons = polygons_of(sets.next(family));
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
    for (const int n : r.contacts) EXPECT_GT(n, r.sets / 40) << name_of(family);
  }
  for (const ContactKind kind : {ContactKind::shared_endpoint, ContactKind::touch, ContactKind::overlap}) {
    EXPECT_GT(touching[kind], count / 100) << name_of(kind);
    EXPECT_GT(overlapping[kind], count / 200) << name_of(kind);
  }
  EXPECT_GT(overlapping[ContactKind::none], count / 200);
  EXPECT_GT(proofs, count / 20);
  EXPECT_GT(overlapping[ContactKind::crossing], count / 20);
}

// Two polygons whose edges cross in the origin, where holes of both have a vertex. As they are, each has in its hole
// what it has in common with the other: they touch. Some vertices are moved.
class Notched {
 public:
  explicit Notched(std::uint64_t seed) : random_(seed) {}

  std::vector<Rings> next() {
    while (true) {
      std::vector<Rings> both = random_.below(2) == 0 ? with_holes_to_borders() : with_holes_within();
      const int fewer = static_cast<int>(random_.below(4));
      for (Rings& rings : both) {
        for (Ring& ring : rings) change(ring, fewer);
      }
      turn(both);
      if (is_fit(both[0]) && is_fit(both[1])) return both;
    }
  }

  Random& random() { return random_; }

 private:
  static std::vector<Rings> with_holes_to_borders() {
    return {{{{-8, 0}, {8, 0}, {-4, 12}}, {{0, 0}, {2, 4}, {0, 8}, {-2, 4}}},
            {{{0, -8}, {16, -8}, {16, 16}, {0, 16}}, {{0, 0}, {10, -2}, {10, 10}, {0, 8}, {1, 4}}}};
  }
  static std::vector<Rings> with_holes_within() {
    return {{{{-8, 0}, {8, 0}, {8, 8}, {-8, 8}}, {{0, 0}, {4, 4}, {-4, 4}}},
            {{{0, -8}, {8, -8}, {8, 8}, {0, 8}}, {{0, 0}, {4, -4}, {4, 4}}}};
  }

  void change(Ring& ring, int fewer) {
    for (Point2& p : ring) {
      if (p == Point2{0, 0} || random_.below(std::uint64_t{3} << fewer) != 0) continue;
      const auto step = [this] { return static_cast<double>(random_.between(-2, 2)); };
      p = {p.x + step(), p.y + step()};
    }
    std::rotate(ring.begin(), ring.begin() + static_cast<std::ptrdiff_t>(random_.below(ring.size())), ring.end());
    if (random_.below(2) == 0) std::reverse(ring.begin(), ring.end());
  }
  // By quarters, or into a mirror; and sheared.
  void turn(std::vector<Rings>& both) {
    const std::uint64_t way = random_.below(8);
    const double shear = static_cast<double>(random_.between(-1, 1));
    for (Rings& rings : both) {
      for (Ring& ring : rings) {
        for (Point2& p : ring) {
          p.x += shear * p.y;
          if (way % 2 != 0) p = {p.y, p.x};
          p = {way % 4 < 2 ? p.x : -p.x, way < 4 ? p.y : -p.y};
        }
      }
    }
    if (random_.below(2) == 0) std::swap(both[0], both[1]);
  }
  // As is required: rings neither cross nor overlap. The interior need not be connected.
  static bool is_fit(const Rings& rings) {
    const planar::PolygonDefects answer =
        planar::polygon_defects(std::span(&rings, 1), {planar::PolygonRule::self_touch});
    return std::none_of(answer.found.begin(), answer.found.end(),
                        [](const planar::PolygonDefect& d) { return d.kind < planar::PolygonDefectKind::self_touch; });
  }

  Random random_;
};

TEST(PolygonsDifferential, NotchesWhereEdgesCross) {
  const int count = scaled_count(2000);
  const std::uint64_t seed = chosen_seed(20261124);
  SCOPED_TRACE("seed " + std::to_string(seed));
  Notched notched(seed);
  PolygonRates rates;
  for (int k = 0; k < count; ++k) {
    std::vector<Rings> set = notched.next();
    if (k % 4 == 0) {
      const std::vector<Rings> others = notched.next();
      set.insert(set.end(), others.begin(), others.end());
    }
    std::vector<std::uint32_t> groups;
    for (std::size_t i = 0; k % 8 == 0 && i < set.size(); ++i) {
      groups.push_back(static_cast<std::uint32_t>(notched.random().below(3)));
    }
    ++rates.sets;
    ASSERT_NO_FATAL_FAILURE(compare_on(polygons_of(set), groups, rates)) << k;
  }
  for (const auto& [kind, n] : rates.touching) std::printf("touching by %s: %d\n", name_of(kind).data(), n);
  for (const auto& [kind, n] : rates.overlapping) std::printf("overlapping by %s: %d\n", name_of(kind).data(), n);
  if (count < 1000) return;  // too few for the rates below
  EXPECT_GT(rates.touching[ContactKind::crossing], count / 50);
  EXPECT_GT(rates.overlapping[ContactKind::crossing], count / 20);
}

}  // namespace
}  // namespace sunder::tests
