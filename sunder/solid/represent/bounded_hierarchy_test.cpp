// B1 to B4 of every level, exactly, on every family of hard bodies; and the walk down by exact signs.
#include <sunder/base/random.h>
#include <sunder/predicate/point/along.h>
#include <sunder/predicate/point/orient.h>
#include <sunder/solid/object/convex_polyhedron.h>
#include <sunder/solid/represent/bounded_hierarchy.h>
#include <sunder/solid/represent/bounded_walk.h>

#include <tests/support/scale.h>
#include <tests/support/shapes.h>
#include <tests/support/solid_shapes.h>

#include <gtest/gtest.h>
#include <boost/multiprecision/cpp_int.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <set>
#include <utility>
#include <vector>

namespace sunder::solid {
namespace {

using Whole = boost::multiprecision::cpp_int;

constexpr std::uint32_t none = BoundedHierarchy::none;

// A point with one denominator, which is positive: the oracle's own fractions.
struct Fraction3 {
  std::array<Whole, 3> x;
  Whole w;
};

// The levels of one hierarchy, as whole numbers: coordinates in units of the last bit that any of them has.
class Exactly {
 public:
  explicit Exactly(const BoundedHierarchy& h) : h_(h), of_(h.nodes.size()) {
    int least = 2000;
    for (const BoundedHierarchy::Node& node : h.nodes) {
      if (node.copy != none) continue;
      for (const double x : {node.at.x, node.at.y, node.at.z}) {
        if (x != 0) least = std::min(least, std::max(std::ilogb(x), -1022) - 52);
      }
    }
    unit_ = least;
  }

  const Fraction3& operator[](std::uint32_t rank) {
    if (of_[rank].w == 0) of_[rank] = make(rank);
    return of_[rank];
  }

  Sign orient(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) {
    const auto is_vertex = [&](std::uint32_t v) { return h_.nodes[v].copy == none; };
    if (is_vertex(a) && is_vertex(b) && is_vertex(c) && is_vertex(d)) {
      return orient_3d(h_.nodes[a].at, h_.nodes[b].at, h_.nodes[c].at, h_.nodes[d].at);
    }
    const auto u = difference(a, b), v = difference(a, c), w = difference(a, d);
    const Whole value =
        w[0] * (u[1] * v[2] - u[2] * v[1]) + w[1] * (u[2] * v[0] - u[0] * v[2]) + w[2] * (u[0] * v[1] - u[1] * v[0]);
    return value > 0 ? Sign::positive : value < 0 ? Sign::negative : Sign::zero;
  }

  // From one to the other, times a positive number.
  std::array<Whole, 3> difference(std::uint32_t from, std::uint32_t to) {
    const Fraction3 &p = (*this)[from], &q = (*this)[to];
    std::array<Whole, 3> result;
    for (std::size_t k = 0; k < 3; ++k) result[k] = q.x[k] * p.w - p.x[k] * q.w;
    return result;
  }

  // Is the point strictly between two others, on their line?
  bool is_between(std::uint32_t p, std::uint32_t a, std::uint32_t b) {
    const auto u = difference(a, p), v = difference(p, b);
    Whole product = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      if (u[k] * v[(k + 1) % 3] != u[(k + 1) % 3] * v[k]) return false;
      product += u[k] * v[k];
    }
    return product > 0;
  }

 private:
  Whole whole(double x) const {
    int e = 0;
    const Whole m = static_cast<std::int64_t>(std::ldexp(std::frexp(x, &e), 53));
    return m == 0 ? m : Whole(m << static_cast<unsigned>(e - 53 - unit_));
  }
  // The product of both sides of the plane's equation with a power of two makes both whole: 2^-4000 is below all bits.
  static Whole whole(const Dyadic& x) {
    Whole result = 0;
    Dyadic rest = x;
    while (rest.sign() != Sign::zero) {
      const double high = rest.scaled(-rest.top()).nearest();
      const Whole m = static_cast<std::int64_t>(std::ldexp(high, 52));
      result += m << static_cast<unsigned>(rest.top() - 52 + 4000);
      rest = rest - Dyadic(high).scaled(rest.top());
    }
    return result;
  }

  Fraction3 make(std::uint32_t rank) {
    const BoundedHierarchy::Node& node = h_.nodes[rank];
    if (node.copy == none) return {{whole(node.at.x), whole(node.at.y), whole(node.at.z)}, 1};
    const BoundedHierarchy::Copy& copy = h_.copies[node.copy];
    const BoundedHierarchy::Cut& cut = h_.cuts[copy.cut];
    const Fraction3 w = (*this)[copy.parent], u = (*this)[copy.toward];
    // w + t (u - w) with t = height / (direction . (u - w)), in units: u - w is D / (w.w u.w).
    const std::array<Whole, 3> d = difference(copy.parent, copy.toward),
                               n{whole(cut.direction.x), whole(cut.direction.y), whole(cut.direction.z)};
    const Whole along = n[0] * d[0] + n[1] * d[1] + n[2] * d[2];
    const Whole height = Whole(1) << static_cast<unsigned>(cut.exponent - unit_ + 4000);
    EXPECT_GT(along, 0);
    Fraction3 p{{}, w.w * along};
    for (std::size_t k = 0; k < 3; ++k) p.x[k] = w.x[k] * along + height * w.w * d[k];
    const Whole common = gcd(gcd(p.x[0], p.x[1]), gcd(p.x[2], p.w));
    for (Whole& x : p.x) x /= common;
    p.w /= common;
    return p;
  }

  const BoundedHierarchy& h_;
  std::vector<Fraction3> of_;
  int unit_;
};

// The vertices of the level, from what the header says.
std::set<std::uint32_t> vertices_of(const BoundedHierarchy& h, std::uint32_t end) {
  std::set<std::uint32_t> found;
  for (std::uint32_t v = 0; v < end; ++v) {
    if (h.parent_of(v) == none || h.parent_of(v) >= end) found.insert(v);
  }
  return found;
}

struct Shape {
  std::set<std::uint32_t> vertices;
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> left;  // of each edge
  std::map<std::uint32_t, std::uint32_t> degree;
};

// A closed surface on exactly these vertices, of genus 0, and no edge of it is reflex: so it is their hull's.
void check_level(Exactly& exactly, const BoundedHierarchy::Surface& triangles, Shape& shape) {
  ASSERT_EQ(triangles.size(), 2 * shape.vertices.size() - 4);
  for (const auto& t : triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      ASSERT_TRUE(shape.vertices.contains(t[k]));
      ASSERT_TRUE(shape.left.insert({{t[k], t[(k + 1) % 3]}, t[(k + 2) % 3]}).second);
      ++shape.degree[t[k]];
    }
  }
  ASSERT_EQ(shape.degree.size(), shape.vertices.size());
  for (const auto& [edge, apex] : shape.left) {
    const auto twin = shape.left.find({edge.second, edge.first});
    ASSERT_NE(twin, shape.left.end());
    if (edge.first > edge.second) continue;
    ASSERT_NE(exactly.orient(edge.first, edge.second, apex, twin->second), Sign::positive);
  }
}

// B2 and B4, between two levels: a smaller polyhedron, and the next larger one.
void check_step(const BoundedHierarchy& h, Exactly& exactly, const Shape& inner, const Shape& outer,
                const BoundedHierarchy::Limits& limits) {
  const auto is_cut_off = [&](std::uint32_t w) {
    return std::any_of(inner.vertices.begin(), inner.vertices.end(),
                       [&](std::uint32_t v) { return h.parent_of(v) == w && !outer.vertices.contains(v); });
  };
  std::set<std::uint32_t> gone, cut;
  for (const std::uint32_t w : outer.vertices) {
    if (!inner.vertices.contains(w)) gone.insert(w);
  }
  ASSERT_FALSE(gone.empty());
  // New vertices: on an edge of the outer one, between the vertex that was cut off and the other end, which is there
  // too, or was cut off before and its cut point is there.
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> split;
  for (const std::uint32_t v : inner.vertices) {
    if (outer.vertices.contains(v)) continue;
    const std::uint32_t w = h.parent_of(v), u = h.copies[h.nodes[v].copy].toward;
    ASSERT_TRUE(gone.contains(w));
    cut.insert(w);
    std::uint32_t end = none;
    for (auto edge = outer.left.lower_bound({w, 0}); edge != outer.left.end() && edge->first.first == w; ++edge) {
      const std::uint32_t x = edge->first.second;
      if (x == u || (h.parent_of(x) == u && h.copies[h.nodes[x].copy].toward == w)) end = x;
    }
    ASSERT_NE(end, none);
    ASSERT_TRUE(exactly.is_between(v, w, end));
    ASSERT_TRUE(split.insert({{w, end}, v}).second);
  }
  // Where both ends of an edge were cut off their points do not pass each other.
  for (const auto& [edge, v] : split) {
    const auto other = split.find({edge.second, edge.first});
    if (other == split.end()) continue;
    ASSERT_TRUE(exactly.is_between(v, edge.first, other->second));
  }
  for (const std::uint32_t w : gone) {
    const auto degree = outer.degree.at(w);
    ASSERT_EQ(cut.contains(w), is_cut_off(w));
    if (cut.contains(w)) {
      ASSERT_GT(degree, limits.most_kept);
    } else {
      ASSERT_LE(degree, limits.most_taken);
    }
    for (auto edge = outer.left.lower_bound({w, 0}); edge != outer.left.end() && edge->first.first == w; ++edge) {
      const std::uint32_t x = edge->first.second;
      // A true edge: the triangles beside it are not of one plane.
      const bool is_true = exactly.orient(w, x, edge->second, outer.left.at({x, w})) != Sign::zero;
      if (cut.contains(w)) {
        ASSERT_EQ(split.contains({w, x}), is_true);
      } else {
        ASSERT_FALSE(gone.contains(x));
        const auto comers = h.comers_of(x);
        ASSERT_TRUE(std::binary_search(comers.begin(), comers.end(), w));
      }
    }
  }
}

struct Tally {
  std::size_t generations = 0, cut_points = 0;
};

std::size_t generation(const BoundedHierarchy& h, std::uint32_t v) {
  if (h.nodes[v].copy == none) return 0;
  const BoundedHierarchy::Copy& copy = h.copies[h.nodes[v].copy];
  return 1 + std::max(generation(h, copy.parent), generation(h, copy.toward));
}

// B1, and what needs no surface.
void check_counts(const ConvexPolyhedron& body, const BoundedHierarchy& h, const BoundedHierarchy::Limits& limits,
                  Tally& tally) {
  ASSERT_EQ(h.levels.front().size, 4u);
  ASSERT_EQ(h.levels.front().end, 4u);
  ASSERT_EQ(h.levels.back().size, body.vertices().size());
  ASSERT_EQ(h.levels.back().end, h.nodes.size());
  ASSERT_EQ(h.nodes.size(), body.vertices().size() + h.copies.size());
  std::vector<bool> seen(body.vertices().size(), false);
  for (std::uint32_t v = 0; v < h.nodes.size(); ++v) {
    tally.generations = std::max(tally.generations, generation(h, v));
    std::uint32_t first = v;
    while (h.parent_of(first) != none) first = h.parent_of(first);
    ASSERT_EQ(h.nodes[v].vertex, h.nodes[first].vertex);
    const auto comers = h.comers_of(v);
    ASSERT_TRUE(std::is_sorted(comers.begin(), comers.end()));
    if (!comers.empty()) {
      ASSERT_GT(comers.front(), v);
      ASSERT_LT(comers.back(), h.parent_of(v));
    }
    if (h.nodes[v].copy != none) continue;
    ASSERT_FALSE(seen[h.nodes[v].vertex]);
    seen[h.nodes[v].vertex] = true;
    ASSERT_EQ(h.nodes[v].at, body.vertices()[h.nodes[v].vertex]);
  }
  for (std::size_t i = 0; i + 1 < h.levels.size(); ++i) ASSERT_LE(h.levels[i].greatest_degree, 5 * limits.most_kept);
  tally.cut_points += h.copies.size();
}

void check(const ConvexPolyhedron& body, const BoundedHierarchy::Limits& limits, Tally& tally) {
  std::vector<BoundedHierarchy::Surface> surfaces;
  const BoundedHierarchy h = BoundedHierarchy::make(body, limits, &surfaces);
  ASSERT_NO_FATAL_FAILURE(check_counts(body, h, limits, tally));
  ASSERT_EQ(surfaces.size(), h.levels.size());
  Exactly exactly(h);
  Shape inner;
  for (std::size_t i = 0; i < surfaces.size(); ++i) {
    Shape outer{vertices_of(h, h.levels[i].end), {}, {}};
    ASSERT_EQ(outer.vertices.size(), h.levels[i].size);
    ASSERT_NO_FATAL_FAILURE(check_level(exactly, surfaces[i], outer));
    std::uint32_t greatest = 0;
    for (const auto& [v, degree] : outer.degree) greatest = std::max(greatest, degree);
    ASSERT_EQ(greatest, h.levels[i].greatest_degree);
    if (i > 0) {
      ASSERT_NO_FATAL_FAILURE(check_step(h, exactly, inner, outer, limits));
    }
    inner = std::move(outer);
  }
  // The tetrahedron has an inside.
  ASSERT_NE(exactly.orient(0, 1, 2, 3), Sign::zero);
  // What doubles have of cut points.
  for (std::uint32_t v = 0; v < h.nodes.size(); ++v) {
    if (h.nodes[v].copy == none) continue;
    const ExactPoint3 p = h.exact(v);
    const Point3& rest = h.copies[h.nodes[v].copy].rest;
    for (std::size_t k = 0; k < 3; ++k) {
      ASSERT_LE(std::fabs(nearest_ratio(p[k], p.denominator) - h.nodes[v].at[k]), h.error / 2);
      ASSERT_LE(std::fabs(rest[k]), h.error);
    }
  }
}

// Bodies of so many vertices are for whole runs of the tests.
bool is_of_this_run(std::size_t n) {
  return n <= 200 || tests::scaled_count(1000) >= (n <= 1000 ? 500 : n <= 4096 ? 5000 : 10000);
}

TEST(BoundedHierarchyTest, LevelsOfEveryFamily) {
  Random random(tests::chosen_seed(111));
  for (const std::size_t n : {8u, 20u, 200u, 1000u, 4096u}) {
    if (!is_of_this_run(n)) continue;
    Tally tally;
    for (const tests::SolidShape& shape : tests::all_solid_shapes()) {
      SCOPED_TRACE(shape.name);
      const ConvexPolyhedron body(shape.make(n, random));
      if (body.dimension() < 3) continue;
      ASSERT_NO_FATAL_FAILURE(check(body, {}, tally)) << n;
    }
    EXPECT_LE(tally.generations, 1u);
    if (n >= 200) {
      EXPECT_GT(tally.cut_points, n);
    }
  }
}

// Small limits: cut points are cut off in turn, and bodies with no large degrees are cut, needles and flat chains too.
TEST(BoundedHierarchyTest, LevelsWithCutsOfCuts) {
  Random random(tests::chosen_seed(113));
  Tally tally;
  const int times = tests::scaled_count(6);
  for (int i = 0; i < times; ++i) {
    for (const tests::SolidShape& shape : tests::all_solid_shapes()) {
      SCOPED_TRACE(shape.name);
      const ConvexPolyhedron body(shape.make(20 + random.below(40), random));
      if (body.dimension() < 3) continue;
      ASSERT_NO_FATAL_FAILURE(check(body, {8, 12, 2}, tally));
    }
  }
  EXPECT_EQ(tally.generations, 2u);
}

// Whole coordinates in a small cube: facets of many coplanar vertices, whose diagonals are not cut.
TEST(BoundedHierarchyTest, LevelsOfWholeNumbers) {
  Random random(tests::chosen_seed(127));
  Tally tally;
  const int bodies = tests::scaled_count(60);
  for (int i = 0; i < bodies; ++i) {
    const std::uint64_t side = 3 + random.below(12);
    std::vector<Point3> points;
    const auto part = [&] { return static_cast<double>(random.below(side)); };
    for (std::uint64_t k = 10 + random.below(200); k > 0; --k) points.push_back({part(), part(), part()});
    const ConvexPolyhedron body(points);
    if (body.dimension() < 3) continue;
    ASSERT_NO_FATAL_FAILURE(check(body, {8, 10, 2}, tally)) << i;
  }
  EXPECT_GT(tally.cut_points, 0u);
}

// A blunt vertex under a ring that is 10^7 times as long as it is wide, and skew: normals are rounded there, so that
// their mean does not have all of the ring above it, and three exact normals tell along which direction to cut.
TEST(BoundedHierarchyTest, LevelsWithBluntHubsOfNarrowRings) {
  Tally tally;
  for (int power = -44; power <= -22; power += 2) {
    const double below = std::ldexp(1.0, power);
    const Point3 along{1, 0.3, 0.7}, across{-0.5e-7, 1e-7, 0.2e-7}, up{-0.64, -0.55, 1.15};
    std::vector<Point3> points{{0, 0, 5}, {-below * up.x, -below * up.y, -below * up.z}};
    for (int k = 0; k < 40; ++k) {
      const double t = 6.283185307179586 * k / 40, x = std::cos(t), y = std::sin(t);
      points.push_back({x * along.x + y * across.x, x * along.y + y * across.y, x * along.z + y * across.z});
    }
    const ConvexPolyhedron body(points);
    ASSERT_NO_FATAL_FAILURE(check(body, {}, tally)) << power;
  }
  EXPECT_GT(tally.cut_points, 800u);
}

// --- The walk --------------------------------------------------------------------------------------------------------

bool is_furthest(const ConvexPolyhedron& body, const Point3& d, std::uint32_t v) {
  const WorldDirection direction(d);
  const Affine3 identity;
  Along along(direction, identity, false);
  return std::all_of(body.vertices().begin(), body.vertices().end(),
                     [&](const Point3& p) { return along.compare(body.vertices()[v], p) != Sign::positive; });
}

// By exact signs alone, of a hierarchy with other limits.
std::uint32_t extreme(const BoundedHierarchy& h, const Point3& d) {
  const WorldDirection direction(d);
  const Affine3 identity;
  Along along(direction, identity, false);
  const auto compare = [&](std::uint32_t i, std::uint32_t j) { return along.compare(h.exact(i), h.exact(j)); };
  std::uint64_t probes = 0;
  return h.nodes[BoundedWalk(h, compare, probes).run()].vertex;
}

// Normals of facets: the corners of one tie, and cut points with them.
TEST(BoundedHierarchyTest, TiesAlongNormalsOfFacets) {
  Random random(tests::chosen_seed(139));
  const int bodies = tests::scaled_count(100);
  for (int i = 0; i < bodies; ++i) {
    std::vector<Point3> points;
    const auto part = [&] { return static_cast<double>(random.between(-6, 6)); };
    for (std::uint64_t k = 10 + random.below(100); k > 0; --k) points.push_back({part(), part(), part()});
    const ConvexPolyhedron body(points);
    if (body.dimension() < 3) continue;
    const BoundedHierarchy h = BoundedHierarchy::make(body, {8, 9, 2});
    for (std::uint32_t f = 0; f < std::min(body.facet_count(), 30u); ++f) {
      const auto facet = body.facet(f);
      const Point3 &a = body.vertices()[facet[0]], &b = body.vertices()[facet[1]], &c = body.vertices()[facet[2]];
      const Point3 p{b.x - a.x, b.y - a.y, b.z - a.z}, q{c.x - a.x, c.y - a.y, c.z - a.z};
      const Point3 normal{p.y * q.z - p.z * q.y, p.z * q.x - p.x * q.z, p.x * q.y - p.y * q.x};
      for (const Point3& d : {normal, Point3{-normal.x, -normal.y, -normal.z}, p, Point3{part(), part(), part()}}) {
        ASSERT_TRUE(is_furthest(body, d, extreme(h, d))) << i;
      }
    }
  }
}

}  // namespace
}  // namespace sunder::solid
