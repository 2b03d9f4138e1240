// polygon_polygon and its methods against polygon_polygon_by_scan, and every certificate against the absolute check.
#include <tests/support/planar_pairs.h>
#include <tests/support/scale.h>
#include <tests/support/shapes.h>

#include <sunder/certificate/check.h>
#include <sunder/planar/pair/polygon_polygon.h>

#include <gtest/gtest.h>

#include <array>
#include <cstdio>
#include <map>
#include <string>

namespace sunder::tests {
namespace {

using planar::ConvexPolygon;
using planar::Pose;

using Method = PairAnswer (*)(const ConvexPolygon&, const Pose&, const ConvexPolygon&, const Pose&);
struct NamedMethod {
  const char* name;
  Method method;
};
constexpr std::array pair_methods{NamedMethod{"front door", planar::polygon_polygon},
                                  NamedMethod{"difference", planar::polygon_polygon_by_difference},
                                  NamedMethod{"halving", planar::polygon_polygon_by_halving},
                                  NamedMethod{"triangles", planar::polygon_polygon_by_triangles},
                                  NamedMethod{"gjk", planar::polygon_polygon_by_gjk}};

CheckResult check(const PairAnswer& answer, const PlanarCase& c) {
  const auto a = in_space(c.a), b = in_space(c.b);
  const Affine3 pose_a = planar::in_space(c.pose_a.affine()), pose_b = planar::in_space(c.pose_b.affine());
  return check_absolutely(answer.evidence, {a, pose_a, false}, {b, pose_b, false});
}

std::string as_text(const PlanarCase& c) {
  std::string text(name_of(c.family));
  char number[64];
  for (const auto& [polygon, pose] : {std::pair(&c.a, &c.pose_a), std::pair(&c.b, &c.pose_b)}) {
    text += "\n ";
    for (const Point2& p : polygon->vertices()) {
      std::snprintf(number, sizeof number, " (%a, %a)", p.x, p.y);
      text += number;
      if (text.size() > 4000) break;
    }
    text += " at";
    const auto& [linear, translation] = pose->affine();
    for (const std::span<const double> row : {std::span<const double>(linear), std::span<const double>(translation)}) {
      for (const double x : row) {
        std::snprintf(number, sizeof number, " %a", x);
        text += number;
      }
    }
  }
  return text;
}

struct Tally {
  int cases = 0, meet = 0, touching = 0;
  std::map<std::string, int> exact, finishing;
};

TEST(PlanarPairDifferential, MethodsAgreeWithTheScan) {
  const int count = scaled_count(20000);
  const std::uint64_t seed = chosen_seed(20261124);
  SCOPED_TRACE("seed " + std::to_string(seed));
  PlanarPairs pairs(seed);
  std::map<PlanarFamily, Tally> tallies;
  for (int i = 0; i < count; ++i) {
    const PlanarCase c = pairs.next();
    Tally& t = tallies[c.family];
    // The scan takes (n + m)^2 looks; where that is much, the absolute check of the certificate decides alone.
    const bool scanned = c.a.size() + c.b.size() < 200;
    const PairAnswer front = planar::polygon_polygon(c.a, c.pose_a, c.b, c.pose_b);
    const PairAnswer scan = scanned ? planar::polygon_polygon_by_scan(c.a, c.pose_a, c.b, c.pose_b) : front;
    ASSERT_EQ(check(scan, c), CheckResult::accepted) << i << " scan " << as_text(c);
    for (const auto& [name, method] : pair_methods) {
      const PairAnswer answer = method(c.a, c.pose_a, c.b, c.pose_b);
      ASSERT_EQ(answer.meet(), scan.meet()) << i << " " << name << " " << as_text(c);
      ASSERT_EQ(check(answer, c), CheckResult::accepted) << i << " " << name << " " << as_text(c);
      if (i % 8 == 0) {
        const PlanarCase exchanged_case{c.family, c.b, c.a, c.pose_b, c.pose_a};
        ASSERT_EQ(check(exchanged(answer), exchanged_case), CheckResult::accepted) << i << " " << name;
      }
      const PairAnswer swapped = method(c.b, c.pose_b, c.a, c.pose_a);
      ASSERT_EQ(swapped.meet(), scan.meet()) << i << " " << name << ", swapped " << as_text(c);
      t.exact[name] += answer.cost.exact > 0;
      t.finishing[name] += answer.decided_by == DecidedBy::finishing;
    }
    const Relation contact = planar::polygon_polygon_contact(c.a, c.pose_a, c.b, c.pose_b);
    ASSERT_EQ(contact != Relation::none, scan.meet()) << i << " " << as_text(c);
    if (c.touches_exactly) {
      ASSERT_EQ(contact, Relation::touching) << i << " " << as_text(c);
    }
    ++t.cases;
    t.meet += scan.meet();
    t.touching += contact == Relation::touching;
  }
  std::printf("%-12s %8s %8s %9s", "family", "cases", "meet", "touching");
  for (const auto& m : pair_methods) std::printf("  %10s: exact, finishing", m.name);
  std::printf("\n");
  for (const auto& [family, t] : tallies) {
    std::printf("%-12s %8d %8d %9d", std::string(name_of(family)).c_str(), t.cases, t.meet, t.touching);
    for (const auto& m : pair_methods) std::printf("  %18d %15d", t.exact.at(m.name), t.finishing.at(m.name));
    std::printf("\n");
  }
  if (count < 2000) return;  // too few for the rates below
  for (const auto& [family, t] : tallies) {
    if (family != PlanarFamily::touching && family != PlanarFamily::contained) {
      EXPECT_GT(t.meet, t.cases / 20) << name_of(family);
      EXPECT_LT(t.meet, t.cases - t.cases / 20) << name_of(family);
    }
  }
  for (const PlanarFamily family : {PlanarFamily::grid, PlanarFamily::degenerate}) {
    EXPECT_GT(tallies[family].touching, tallies[family].cases / 50) << name_of(family);
  }
  // In general position the searches' evidence holds: none is left to the exact method; of the front door 0.5 % at
  // most.
  Tally& general = tallies[PlanarFamily::general];
  for (const auto& m : pair_methods) {
    const bool is_front = m.method == planar::polygon_polygon;
    EXPECT_LE(general.finishing[m.name], is_front ? general.cases / 200 : 0) << m.name;
  }
}

// A million vertices: the answer is known, and the certificate is checked against every vertex.
TEST(PlanarPairDifferential, PolygonsOfAMillionVertices) {
  const std::uint32_t n = scaled_count(1 << 20) < (1 << 20) ? 1u << 14 : 1u << 20;
  const ConvexPolygon one = regular_polygon(n), other = regular_polygon(n - 1, 1, 0.5),
                      small = regular_polygon(5, 1e-3);
  const auto at = [](double x, double y) { return Pose::from_matrix({1, 0, 0, 1}, {x, y}); };
  const std::array cases{
      std::pair(PlanarCase{PlanarFamily::large, one, other, Pose(), at(2.5, 1)}, false),
      std::pair(PlanarCase{PlanarFamily::large, one, other, Pose(), at(2 + 1e-9, 0)}, false),
      std::pair(PlanarCase{PlanarFamily::large, one, other, Pose(), at(1.3, 1.5)}, true),
      std::pair(PlanarCase{PlanarFamily::large, one, small, Pose(), at(0.3, 0.2)}, true),
      std::pair(PlanarCase{PlanarFamily::large, one, one, Pose(), Pose::from_matrix({-1, 0, 0, -1}, {2, 0}), true},
                true)};  // its image in the vertex (1, 0)
  for (const auto& [c, meet] : cases) {
    for (const auto& [name, method] : pair_methods) {
      const PairAnswer answer = method(c.a, c.pose_a, c.b, c.pose_b);
      EXPECT_EQ(answer.meet(), meet) << name;
      EXPECT_EQ(check(answer, c), CheckResult::accepted) << name;
    }
    const Relation contact = planar::polygon_polygon_contact(c.a, c.pose_a, c.b, c.pose_b);
    EXPECT_EQ(contact == Relation::touching, c.touches_exactly);
  }
}

// Touching and overlapping against the definition: the interiors meet iff a pair shrunk a little does. On integer grids
// with at least three vertices each, a shift by less than any distance that can be between them tells.
TEST(PlanarPairDifferential, ContactsOfGrids) {
  const int count = scaled_count(4000);
  PlanarPairs pairs(chosen_seed(12));
  std::map<Relation, int> seen;
  for (int i = 0; i < count; ++i) {
    PlanarCase c = pairs.next(PlanarFamily::grid);
    c.pose_a = c.pose_b = Pose();
    if (c.a.size() < 3 || c.b.size() < 3) continue;
    const Relation contact = planar::polygon_polygon_contact(c.a, c.pose_a, c.b, c.pose_b);
    ++seen[contact];
    // They overlap iff no edge of either has the other on its right or on it.
    const auto parts_weakly = [](const ConvexPolygon& p, const ConvexPolygon& q) {
      for (std::uint32_t k = 0; k < p.size(); ++k) {
        bool all = true;
        for (const Point2& r : q.vertices()) {
          const Point2 &s = p[k], &t = p[(k + 1) % p.size()];
          all = all && (t.x - s.x) * (r.y - s.y) - (t.y - s.y) * (r.x - s.x) <= 0;  // small integers: exact
        }
        if (all) return true;
      }
      return false;
    };
    ASSERT_EQ(contact == Relation::overlapping, !parts_weakly(c.a, c.b) && !parts_weakly(c.b, c.a)) << as_text(c);
  }
  if (count < 2000) return;
  for (const Relation contact : {Relation::none, Relation::touching, Relation::overlapping}) {
    EXPECT_GT(seen[contact], count / 100) << name_of(contact);
  }
}

// Scaled by a power of two, shifted exactly, reflected, turned by a right angle, numbered from another vertex.
TEST(PlanarPairDifferential, SymmetriesKeepTheVerdict) {
  const int count = scaled_count(2000);
  PlanarPairs pairs(chosen_seed(13));
  for (int i = 0; i < count; ++i) {
    const PlanarCase c = pairs.next();
    if (c.family == PlanarFamily::any_scale) continue;
    for (const auto& [name, method] : pair_methods) {
      const bool meet = method(c.a, c.pose_a, c.b, c.pose_b).meet();
      const auto changed = [&](const std::array<double, 4>& by) {  // the product with signs, swaps and powers of two
        const auto pose = [&](const Pose& p) {
          const auto& [m, t] = p.affine();
          return Pose::from_matrix({by[0] * m[0] + by[1] * m[2], by[0] * m[1] + by[1] * m[3],  //
                                    by[2] * m[0] + by[3] * m[2], by[2] * m[1] + by[3] * m[3]},
                                   {by[0] * t[0] + by[1] * t[1], by[2] * t[0] + by[3] * t[1]});
        };
        return method(c.a, pose(c.pose_a), c.b, pose(c.pose_b)).meet();
      };
      for (const auto& by : {std::array<double, 4>{-1, 0, 0, 1}, {0, -1, 1, 0}, {0, 1, 1, 0}, {0x1p30, 0, 0, 0x1p30}}) {
        ASSERT_EQ(changed(by), meet) << i << " " << name << " " << as_text(c);
      }
      const auto renumbered = [&](const ConvexPolygon& p) {
        std::vector<Point2> v(p.vertices().begin(), p.vertices().end());
        std::rotate(v.begin(), v.begin() + static_cast<std::ptrdiff_t>(pairs.random().below(v.size())), v.end());
        return ConvexPolygon::from_vertices(v);
      };
      ASSERT_EQ(method(renumbered(c.a), c.pose_a, renumbered(c.b), c.pose_b).meet(), meet) << i << " " << name;
    }
  }
}

}  // namespace
}  // namespace sunder::tests
