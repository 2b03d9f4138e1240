// Proposals, true and false: what is accepted is a certificate, what is false is refused, and what a search would
// propose in the plain cases is accepted.
#include <sunder/base/random.h>
#include <sunder/certificate/check.h>
#include <sunder/solid/object/bodies_test.h>
#include <sunder/solid/object/search_graph_walk.h>
#include <sunder/solid/pair/polyhedron_polyhedron_answer.h>
#include <sunder/solid/search/caratheodory.h>
#include <sunder/solid/search/placed_check_test.h>
#include <sunder/solid/search/simplex_proposals.h>

#include <sunder/solid/pair/polyhedron_polyhedron.h>

#include <tests/support/scale.h>
#include <tests/support/shapes.h>
#include <tests/support/solid_pairs.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <vector>

namespace sunder::solid {
namespace {

using tests::shift;

Point3 image(const Placed& body, std::uint32_t v) {
  const Point3& p = body.graph.vertices[v];
  const auto& m = body.pose.linear;
  return {m[0] * p.x + m[1] * p.y + m[2] * p.z, m[3] * p.x + m[4] * p.y + m[5] * p.z,
          m[6] * p.x + m[7] * p.y + m[8] * p.z};
}

// As the search makes it.
DifferenceVertex difference(const Placed& a, const Placed& b, std::uint32_t v, std::uint32_t w) {
  DifferenceVertex d;
  d.a = v;
  d.b = w;
  const Point3 p = image(a, v), q = image(b, w);
  const auto &s = a.pose.translation, &t = b.pose.translation;
  d.at = {(p.x - q.x) - (t[0] - s[0]), (p.y - q.y) - (t[1] - s[1]), (p.z - q.z) - (t[2] - s[2])};
  return d;
}

DifferenceSimplex simplex_of(const Placed& a, const Placed& b, const std::vector<std::array<std::uint32_t, 2>>& pairs) {
  DifferenceSimplex s;
  for (const auto& [v, w] : pairs) s.vertex[static_cast<std::size_t>(s.count++)] = difference(a, b, v, w);
  return s;
}

// The same vertices in twice the precision, so with the exact differences where the numbers are short.
DifferenceSimplexOf<DoubleDouble> finer(const Placed& a, const Placed& b, const DifferenceSimplex& coarse) {
  DifferenceSimplexOf<DoubleDouble> s;
  s.count = coarse.count;
  const auto &from = a.pose.translation, &to = b.pose.translation;
  for (std::size_t i = 0; i < static_cast<std::size_t>(s.count); ++i) {
    const DifferenceVertex& w = coarse.vertex[i];
    const auto p = a.turned<DoubleDouble>(w.a, 1), q = b.turned<DoubleDouble>(w.b, 1);
    s.vertex[i] = {{p.x - q.x - exact_sum(to[0], -from[0]), p.y - q.y - exact_sum(to[1], -from[1]),
                    p.z - q.z - exact_sum(to[2], -from[2])},
                   w.a,
                   w.b};
  }
  return s;
}

double dot_product(const Point3& a, const Point3& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }

// What a search would do with a direction or a simplex.
bool check_apart(const Placed& a, const Placed& b, const Point3& direction, std::uint32_t near_a, std::uint32_t near_b,
                 PairCertificate& c, StageTally& tally) {
  Cost cost;
  return dispose(a, b, apart_along(direction, near_a, near_b), c, cost, tally);
}
auto disposing(const Placed& a, const Placed& b, PairCertificate& c, StageTally& tally) {
  return [&](const Proposal& p) {
    Cost cost;
    return dispose(a, b, p, c, cost, tally);
  };
}
template <class Real>
bool check_meet(const Placed& a, const Placed& b, const DifferenceSimplexOf<Real>& s, PairCertificate& c,
                StageTally& tally) {
  return propose_meet(a, b, s, disposing(a, b, c, tally));
}
bool check_apart_by_features(const Placed& a, const Placed& b, const DifferenceSimplex& s, const Point3& towards,
                             PairCertificate& c, StageTally& tally) {
  return propose_apart_along_features(s, towards, disposing(a, b, c, tally));
}
bool check_apart_perpendicular(const Placed& a, const Placed& b, const DifferenceSimplexOf<DoubleDouble>& s,
                               std::uint32_t near_a, std::uint32_t near_b, PairCertificate& c, StageTally& tally) {
  return propose_apart_along_perpendicular(s, near_a, near_b, disposing(a, b, c, tally));
}

class PolyhedronPolyhedronAnswerTest : public testing::Test {
 protected:
  ConvexPolyhedron some_body() {
    std::vector<Point3> points;
    const auto coordinate = [&] { return static_cast<double>(random_.between(-2, 2)); };
    for (std::int64_t n = random_.between(1, 10); n > 0; --n)
      points.push_back({coordinate(), coordinate(), coordinate()});
    return ConvexPolyhedron(points);
  }
  std::uint32_t some_vertex(const Placed& p) {
    return static_cast<std::uint32_t>(random_.below(p.graph.vertices.size()));
  }

  Random random_{tests::chosen_seed(89)};
  StageTally tally_;
};

// Whatever vertices the walk begins at, the answer is that of all vertices. Small integers: doubles are exact.
TEST_F(PolyhedronPolyhedronAnswerTest, CheckApartIsThePlainTruthFromAnyStart) {
  int accepted = 0, refused = 0, ties = 0;
  for (int i = 0; i < 5000; ++i) {
    const ConvexPolyhedron body_a = some_body(), body_b = some_body();
    const Pose here, there = shift(static_cast<double>(random_.between(0, 5)), 1, 0);
    const Placed a(body_a, here), b(body_b, there);
    const auto coordinate = [&] { return static_cast<double>(random_.between(-2, 2)); };
    const Point3 d{coordinate() + 2, coordinate(), coordinate()};
    double most = -1e9, lowest = 1e9;
    for (const Point3& p : body_a.vertices()) most = std::max(most, dot_product(d, p));
    for (const Point3& p : body_b.vertices())
      lowest = std::min(lowest, dot_product(d, {p.x + there.affine().translation[0], p.y + 1, p.z}));
    PairCertificate c;
    const bool parted = check_apart(a, b, d, some_vertex(a), some_vertex(b), c, tally_);
    ASSERT_EQ(parted, most < lowest) << i;
    ties += most == lowest;
    ++(parted ? accepted : refused);
    if (!parted) continue;
    ASSERT_EQ(verdict_of(c), Verdict::apart);
    ASSERT_EQ(std::get<Separation>(c).direction.kind, Direction::Kind::given);
    ASSERT_EQ(std::get<Separation>(c).direction.given, d);
    ASSERT_EQ(check_placed(c, a, b), CheckResult::accepted);
  }
  EXPECT_GT(accepted, 500);
  EXPECT_GT(refused, 500);
  EXPECT_GT(ties, 100);
}

// Simplices at random, most of them not what a search would leave: what is accepted holds.
TEST_F(PolyhedronPolyhedronAnswerTest, WhatIsAcceptedHolds) {
  std::map<Direction::Kind, int> kinds;
  std::map<int, int> counts, finer_counts, perpendicular;
  int refused = 0;
  const int runs = tests::scaled_count(30000, 1000);
  for (int i = 0; i < runs; ++i) {
    const ConvexPolyhedron body_a = some_body(), body_b = some_body();
    const Pose here = random_.below(2) ? Pose() : Pose::from_matrix({1, 0.5, 0, 0, 1, 0.25, 0.1, 0, -1}, {0.1, 0, 0});
    const Pose there = shift(static_cast<double>(random_.between(0, 5)), 0, 0);
    const Placed a(body_a, here), b(body_b, there);
    std::vector<std::array<std::uint32_t, 2>> pairs;
    for (std::int64_t n = random_.between(1, 4); n > 0; --n) pairs.push_back({some_vertex(a), some_vertex(b)});
    const DifferenceSimplex s = simplex_of(a, b, pairs);
    PairCertificate c;
    if (check_apart_by_features(a, b, s, {1, random_.uniform(-1, 1), random_.uniform(-1, 1)}, c, tally_)) {
      ASSERT_EQ(verdict_of(c), Verdict::apart);
      ASSERT_EQ(check_placed(c, a, b), CheckResult::accepted) << i;
      ++kinds[std::get<Separation>(c).direction.kind];
    } else {
      ++refused;
    }
    if (check_meet(a, b, s, c, tally_)) {
      ASSERT_EQ(verdict_of(c), Verdict::meet);
      ASSERT_EQ(check_placed(c, a, b), CheckResult::accepted) << i;
      ++counts[std::get<CommonVertices>(c).count_a + std::get<CommonVertices>(c).count_b];
    } else {
      ++refused;
    }
    const DifferenceSimplexOf<DoubleDouble> t = finer(a, b, s);
    if (check_meet(a, b, t, c, tally_)) {
      ASSERT_EQ(verdict_of(c), Verdict::meet);
      ASSERT_EQ(check_placed(c, a, b), CheckResult::accepted) << i;
      ++finer_counts[std::get<CommonVertices>(c).count_a + std::get<CommonVertices>(c).count_b];
    }
    if (check_apart_perpendicular(a, b, t, some_vertex(a), some_vertex(b), c, tally_)) {
      ASSERT_EQ(verdict_of(c), Verdict::apart);
      ASSERT_EQ(std::get<Separation>(c).direction.kind, Direction::Kind::exact);
      ASSERT_EQ(check_placed(c, a, b), CheckResult::accepted) << i;
      ++perpendicular[s.count];
    } else {
      ++refused;
    }
  }
  EXPECT_EQ(perpendicular[4], 0);
  if (runs < 30000) return;  // a smaller run may miss a kind
  for (const auto kind : {Direction::Kind::normal_of_a, Direction::Kind::normal_of_b, Direction::Kind::edge_cross_edge,
                          Direction::Kind::difference}) {
    EXPECT_GT(kinds[kind], 20) << static_cast<int>(kind);
  }
  for (const int count : {2, 3, 4, 5}) {
    EXPECT_GT(counts[count], 5) << count;
    EXPECT_GT(finer_counts[count], 5) << count;
  }
  for (const int count : {1, 2, 3}) EXPECT_GT(perpendicular[count], 100) << count;
  EXPECT_GT(refused, runs / 3);
}

// Gaps that no direction of doubles can show: 5e-324 beyond a facet, an edge, a vertex.
TEST_F(PolyhedronPolyhedronAnswerTest, FeaturesPartWhatDoublesCannot) {
  // Irregular numbers: the features' exact directions are no triples of doubles.
  const Pose pose = Pose::from_matrix({0.1, 0.7, -0.3, 0.4, 0.2, 0.9, -0.8, 0.3, 0.35}, {0.1, 0.2, 0.3});
  const ConvexPolyhedron cube(tests::cube_corners(-1, 1));
  const Placed a(cube, pose);
  const auto apart = [&](const ConvexPolyhedron& other, const std::vector<std::array<Point3, 2>>& pairs,
                         const Point3& outward, PairCertificate& c) {
    const Placed b(other, pose);
    std::vector<std::array<std::uint32_t, 2>> numbers;
    for (const auto& [p, q] : pairs) numbers.push_back({vertex_at(cube, p), vertex_at(other, q)});
    const bool parted = check_apart_by_features(a, b, simplex_of(a, b, numbers), outward, c, tally_);
    EXPECT_TRUE(!parted || check_placed(c, a, b) == CheckResult::accepted);
    return parted;
  };
  const auto turned = [&](const Point3& p) {  // normals go with the inverse transpose: by cross products of columns
    const auto& m = pose.affine().linear;
    const std::array<Point3, 3> column{Point3{m[0], m[3], m[6]}, Point3{m[1], m[4], m[7]}, Point3{m[2], m[5], m[8]}};
    const auto cross = [](const Point3& u, const Point3& v) {
      return Point3{u.y * v.z - u.z * v.y, u.z * v.x - u.x * v.z, u.x * v.y - u.y * v.x};
    };
    const Point3 n[3] = {cross(column[1], column[2]), cross(column[2], column[0]), cross(column[0], column[1])};
    const double sense = dot_product(n[0], column[0]) > 0 ? 1 : -1;
    return Point3{sense * (p.x * n[0].x + p.y * n[1].x + p.z * n[2].x),
                  sense * (p.x * n[0].y + p.y * n[1].y + p.z * n[2].y),
                  sense * (p.x * n[0].z + p.y * n[1].z + p.z * n[2].z)};
  };
  constexpr double bit = 0x1p-52;
  for (const double gap : {bit, 0.0}) {
    PairCertificate c;
    const ConvexPolyhedron point(std::vector<Point3>{{1 + gap, 0.1, 0.2}});
    const Point3 q = point.vertices()[0];
    EXPECT_EQ(apart(point, {{Point3{1, 1, 1}, q}, {Point3{1, -1, 1}, q}, {Point3{1, -1, -1}, q}}, turned({1, 0, 0}), c),
              gap > 0);
    EXPECT_TRUE(gap == 0 || std::get<Separation>(c).direction.kind == Direction::Kind::normal_of_a);

    const ConvexPolyhedron plate(std::vector<Point3>{{1 + gap, 5, 7}, {1 + gap, -9, 5}, {1 + gap, 4, -8}, {3, 0, 0}});
    const Point3 r{1, 1, 1};
    EXPECT_EQ(apart(plate, {{r, Point3{1 + gap, 5, 7}}, {r, Point3{1 + gap, -9, 5}}, {r, Point3{1 + gap, 4, -8}}},
                    turned({1, 0, 0}), c),
              gap > 0);
    EXPECT_TRUE(gap == 0 || std::get<Separation>(c).direction.kind == Direction::Kind::normal_of_b);

    const ConvexPolyhedron edge(std::vector<Point3>{{2 + gap, 0, 0.25}, {0 + gap, 2, 0.25}, {3, 3, 0.5}, {3, 3, -0.5}});
    EXPECT_EQ(apart(edge, {{Point3{1, 1, 1}, Point3{2 + gap, 0, 0.25}}, {Point3{1, 1, -1}, Point3{gap, 2, 0.25}}},
                    turned({1, 1, 0}), c),
              gap > 0);
    EXPECT_TRUE(gap == 0 || std::get<Separation>(c).direction.kind == Direction::Kind::edge_cross_edge);
  }
}

// The nearest parts of a vertex and an edge's inside, or of a vertex and a vertex, one unit in the last place apart.
TEST_F(PolyhedronPolyhedronAnswerTest, ThePerpendicularPartsWhatDoublesCannot) {
  const Pose pose = Pose::from_matrix({0.1, 0.7, -0.3, 0.4, 0.2, 0.9, -0.8, 0.3, 0.35}, {0.1, 0.2, 0.3});
  const ConvexPolyhedron cube(tests::cube_corners(-1, 1));
  const Placed a(cube, pose);
  for (const double gap : {0x1p-52, 0.0, -0x1p-52}) {
    // Beyond the edge x = y = 1, and beyond the corner.
    for (const double z : {0.3, 1 + gap}) {
      const ConvexPolyhedron needle(std::vector<Point3>{{1 + gap, 1 + gap, z}, {3, 3, 3}});
      const Placed b(needle, pose);
      const std::uint32_t tip = vertex_at(needle, {1 + gap, 1 + gap, z});
      std::vector<std::array<std::uint32_t, 2>> pairs{{vertex_at(cube, {1, 1, 1}), tip}};
      if (z == 0.3) pairs.push_back({vertex_at(cube, {1, 1, -1}), tip});
      PairCertificate c;
      const bool parted =
          check_apart_perpendicular(a, b, finer(a, b, simplex_of(a, b, pairs)), pairs[0][0], tip, c, tally_);
      // The perpendicular of a sheared cube's edge or corner need not part even what is apart; what it says holds.
      if (gap <= 0) {
        EXPECT_FALSE(parted);
      }
      EXPECT_TRUE(!parted || check_placed(c, a, b) == CheckResult::accepted);
    }
  }
  // With right angles it does.
  const Pose turn = Pose::from_matrix({0.6, -0.8, 0, 0.8, 0.6, 0, 0, 0, 1}, {0.1, 0.2, 0.3});
  const Placed straight(cube, turn);
  for (const double z : {0.3, 1 + 0x1p-52}) {
    const ConvexPolyhedron needle(std::vector<Point3>{{1 + 0x1p-52, 1 + 0x1p-52, z}, {3, 3, 3}});
    const Placed b(needle, turn);
    const std::uint32_t tip = vertex_at(needle, {1 + 0x1p-52, 1 + 0x1p-52, z});
    std::vector<std::array<std::uint32_t, 2>> pairs{{vertex_at(cube, {1, 1, 1}), tip}};
    if (z == 0.3) pairs.push_back({vertex_at(cube, {1, 1, -1}), tip});
    PairCertificate c;
    EXPECT_TRUE(check_apart_perpendicular(straight, b, finer(straight, b, simplex_of(straight, b, pairs)), pairs[0][0],
                                          tip, c, tally_));
    EXPECT_EQ(check_placed(c, straight, b), CheckResult::accepted);
  }
}

// Proper overlaps: the plain case.
TEST_F(PolyhedronPolyhedronAnswerTest, TetrahedraAroundTheOriginAreAccepted) {
  const int count = tests::scaled_count(1000, 200);
  int enclosing = 0, accepted = 0, at_once = 0, finer_accepted = 0;
  for (int i = 0; i < 40 * count && enclosing < count; ++i) {
    std::vector<Point3> p, q;
    for (int k = 0; k < 6; ++k) {
      p.push_back({random_.uniform(-1, 1), random_.uniform(-1, 1), random_.uniform(-1, 1)});
      q.push_back({random_.uniform(-1, 1), random_.uniform(-1, 1), random_.uniform(-1, 1)});
    }
    const ConvexPolyhedron body_a(p), body_b(q);
    const Pose pose;
    const Placed a(body_a, pose), b(body_b, pose);
    std::vector<std::array<std::uint32_t, 2>> pairs;
    for (int k = 0; k < 4; ++k) pairs.push_back({some_vertex(a), some_vertex(b)});
    const DifferenceSimplex s = simplex_of(a, b, pairs);
    const std::array<double, 4> w = weights_of_origin(s);
    if (*std::min_element(w.begin(), w.end()) < 1e-6) continue;
    ++enclosing;
    PairCertificate c;
    Proposal five;
    if (name_five_of_tetrahedron(a, s, w, five)) {
      // Never a vertex twice, whatever the tetrahedron shares.
      std::array<std::uint32_t, 5> names{};
      std::copy_n(five.vertices.begin(), 5, names.begin());
      for (std::size_t k = five.count_a; k < 5; ++k) names[k] += 100;
      std::sort(names.begin(), names.end());
      EXPECT_EQ(std::unique(names.begin(), names.end()), names.end());
      at_once += disposing(a, b, c, tally_)(five) && check_placed(c, a, b) == CheckResult::accepted;
    }
    finer_accepted += check_meet(a, b, finer(a, b, s), c, tally_);
    if (!check_meet(a, b, s, c, tally_)) continue;
    ++accepted;
    ASSERT_EQ(check_placed(c, a, b), CheckResult::accepted);
  }
  EXPECT_EQ(enclosing, count);
  EXPECT_GE(accepted, enclosing - enclosing / 100);
  EXPECT_GE(at_once, enclosing - enclosing / 100);
  EXPECT_GE(finer_accepted, enclosing - enclosing / 100);
}

// Touching: the nearest face is a corner, an edge or a triangle that holds the origin, some weights are zero.
TEST_F(PolyhedronPolyhedronAnswerTest, TouchingPairsAreAccepted) {
  const ConvexPolyhedron cube(tests::cube_corners(-1, 1));
  const Pose here, there = shift(2, 0.5, -0.25);
  const Placed a(cube, here), b(cube, there);
  const auto v = [&](double x, double y, double z) { return vertex_at(cube, {x, y, z}); };
  PairCertificate c;
  // (1, 1, 1) - (-1, -1, 1) and others: the facets x = 1 and x = -1 have common points.
  const DifferenceSimplex s =
      simplex_of(a, b, {{v(1, 1, 1), v(-1, -1, -1)}, {v(1, -1, 1), v(-1, 1, -1)}, {v(1, -1, -1), v(-1, -1, 1)}});
  ASSERT_TRUE(check_meet(a, b, s, c, tally_));
  EXPECT_EQ(check_placed(c, a, b), CheckResult::accepted);

  const Pose corner = shift(2, 2, 2);
  const Placed at_corner(cube, corner);
  ASSERT_TRUE(check_meet(a, at_corner, simplex_of(a, at_corner, {{v(1, 1, 1), v(-1, -1, -1)}}), c, tally_));
  EXPECT_EQ(std::get<CommonVertices>(c).count_a + std::get<CommonVertices>(c).count_b, 2);
  EXPECT_EQ(check_placed(c, a, at_corner), CheckResult::accepted);

  const Pose off = shift(2, 2, std::nextafter(2.0, 3.0));
  const Placed off_corner(cube, off);
  EXPECT_FALSE(check_meet(a, off_corner, simplex_of(a, off_corner, {{v(1, 1, 1), v(-1, -1, -1)}}), c, tally_));
}

TEST_F(PolyhedronPolyhedronAnswerTest, AnEmptySimplexProposesNothing) {
  const ConvexPolyhedron cube(tests::cube_corners(-1, 1));
  const Pose pose;
  const Placed a(cube, pose);
  PairCertificate c;
  EXPECT_FALSE(check_meet(a, a, DifferenceSimplex(), c, tally_));
  EXPECT_FALSE(check_apart_by_features(a, a, {}, {1, 0, 0}, c, tally_));
}

// Proposals about two cubes with a gap between them, right and wrong in each way.
TEST_F(PolyhedronPolyhedronAnswerTest, WrongProposalsDoNotHold) {
  using Claim = Proposal::Claim;
  const ConvexPolyhedron cube(tests::cube_corners(-1, 1));
  const Pose here, there = shift(3, 0, 0), close = shift(1.5, 0, 0);
  const Placed a(cube, here), b(cube, there), c(cube, close);
  const auto v = [&](double x, double y, double z) { return vertex_at(cube, {x, y, z}); };
  PairCertificate certificate;
  const auto apart = disposing(a, b, certificate, tally_), meeting = disposing(a, c, certificate, tally_);
  const std::uint32_t p = v(1, 1, 1), q = v(1, -1, 1), r = v(1, 1, -1), u = v(-1, 1, 1), t = v(-1, -1, 1),
                      w = v(-1, 1, -1);
  const Point3 right{1, 0, 0}, left{-1, 0, 0}, up{0, 1, 0};
  const std::vector<Proposal> true_ones{
      apart_along(right, p, u),
      apart_along(right, u, p),  // the walk finds the extreme vertices
      {Claim::apart_along_sum, 0, 0, {}, p, u, {}, right},
      {Claim::apart_along_sum, 0, 0, {}, p, u, {1, 0x1p60, 0}, {0, -0x1p60, 0}},
      {Claim::apart_along_normal_of_a, 3, 0, {p, q, r}, p, u, right},
      {Claim::apart_along_normal_of_b, 0, 3, {u, t, w}, p, u, right},
      {Claim::apart_along_edge_x_edge, 2, 2, {p, q, u, w}, p, u, right},
      {Claim::apart_along_difference, 1, 1, {p, u}, p, u, right},
      {Claim::apart_along_perpendicular, 1, 1, {p, u}, p, u, {}},
      {Claim::apart_along_perpendicular, 3, 3, {p, q, r, u, u, u}, p, u, {}},
      apart_at_vertices(p, u),
  };
  for (std::size_t k = 0; k < true_ones.size(); ++k) {
    const Proposal& one = true_ones[k];
    EXPECT_TRUE(apart(one)) << k;
    EXPECT_EQ(check_placed(certificate, a, b), CheckResult::accepted) << k;
    EXPECT_FALSE(meeting(one)) << k;                              // the wrong claim
    for (const std::uint32_t wrong : {8u, 1000u, 0xffffffffu}) {  // features that there are not
      Proposal other = one;
      other.near_a = wrong;
      EXPECT_FALSE(apart(other)) << k;
      other = one;
      other.near_b = wrong;
      EXPECT_FALSE(apart(other)) << k;
      for (std::size_t i = 0; i < std::size_t{one.count_a} + one.count_b; ++i) {
        other = one;
        other.vertices[i] = wrong;
        EXPECT_FALSE(apart(other)) << k << " " << i;
      }
      if (one.count_a == 0) continue;
      other = one;
      other.count_a = 200;
      EXPECT_FALSE(apart(other)) << k;
    }
  }
  // A wrong direction, or one that is none.
  EXPECT_FALSE(apart({Claim::apart_along_sum, 0, 0, {}, p, u, right, left}));
  EXPECT_FALSE(apart({Claim::apart_along_sum, 0, 0, {}, p, u, right, {-2, 0, 0}}));
  EXPECT_FALSE(apart({Claim::apart_along_sum, 0, 0, {}, p, u, right, {0, HUGE_VAL, 0}}));
  for (const Point3& d : {left, up, Point3{0, 0, 0}, Point3{HUGE_VAL, 0, 0}, Point3{1, std::nan(""), 0}}) {
    EXPECT_FALSE(apart(apart_along(d, p, u)));
  }
  EXPECT_FALSE(apart({Claim::apart_along_normal_of_a, 3, 0, {p, q, r}, p, u, left}));   // the wrong sense
  EXPECT_FALSE(apart({Claim::apart_along_normal_of_a, 3, 0, {p, q, u}, p, u, right}));  // another facet
  EXPECT_FALSE(apart({Claim::apart_along_normal_of_a, 3, 0, {p, p, p}, p, u, right}));
  EXPECT_FALSE(apart(apart_at_vertices(u, p)));
  // A corner of one cube on an edge of the other; other vertices.
  const std::uint32_t x = v(-1, -1, -1);
  EXPECT_TRUE(meeting({Claim::meet, 2, 1, {u, p, u}, 0, 0, {}}));
  EXPECT_EQ(check_placed(certificate, a, c), CheckResult::accepted);
  EXPECT_FALSE(meeting({Claim::meet, 2, 1, {u, p, t}, 0, 0, {}}));
  EXPECT_FALSE(meeting({Claim::meet, 2, 1, {x, p, u}, 0, 0, {}}));
  EXPECT_FALSE(apart({Claim::meet, 4, 1, {x, p, q, r, u}, 0, 0, {}}));
  EXPECT_FALSE(meeting({Claim::meet, 1, 1, {p, u}, 0, 0, {}}));
  EXPECT_FALSE(meeting({Claim::meet, 0, 1, {p, u}, 0, 0, {}}));
  EXPECT_FALSE(meeting({Claim::meet, 5, 1, {p, u}, 0, 0, {}}));
  EXPECT_FALSE(meeting({Claim::meet, 1, 1, {p, 8}, 0, 0, {}}));
}

// A search that proposes anything: what holds is true, and where nothing does, the answer is right all the same.
TEST_F(PolyhedronPolyhedronAnswerTest, AnswersAreRightWhateverIsProposed) {
  tests::SolidPairs pairs(tests::chosen_seed(91));
  std::map<Proposal::Claim, int> held;
  int finished = 0;
  const int count = tests::scaled_count(2000);
  for (int i = 0; i < count; ++i) {
    const tests::PairCase c = pairs.next();
    if (c.a.vertices().size() + c.b.vertices().size() > 100) continue;
    const Placed a(c.a, c.pose_a), b(c.b, c.pose_b);
    const PairAnswer answer = answer_by(a, b, [&](const auto& holds, Cost&) {
      for (int k = 0; k < 6; ++k) {
        Proposal p{static_cast<Proposal::Claim>(random_.below(9)), 0, 0, {}, some_vertex(a), some_vertex(b), {}};
        using Counts = std::array<std::uint8_t, 2>;
        constexpr std::array<Counts, 9> counts{Counts{0, 0}, {0, 0}, {3, 0}, {0, 3}, {2, 2},
                                               {1, 1},       {2, 2}, {0, 0}, {4, 1}};
        const auto& [count_a, count_b] =
            counts[random_.below(8) == 0 ? random_.below(9) : static_cast<std::size_t>(p.claim)];
        p.count_a = count_a, p.count_b = count_b;
        for (std::size_t n = 0; n < 6; ++n) p.vertices[n] = n < count_a ? some_vertex(a) : some_vertex(b);
        p.direction = {random_.uniform(-1, 1), random_.uniform(-1, 1), random_.uniform(-1, 1)};
        p.rest = {random_.uniform(-0.1, 0.1), 0, random_.uniform(-0x1p-60, 0x1p-60)};
        if (!holds(p)) continue;
        ++held[p.claim];
        return true;
      }
      return false;
    });
    ASSERT_EQ(answer.meet(), polyhedron_polyhedron_by_scan(c.a, c.pose_a, c.b, c.pose_b).meet()) << i;
    ASSERT_EQ(check_placed(answer.evidence, a, b), CheckResult::accepted) << i;
    if (answer.decided_by == DecidedBy::finishing) {
      EXPECT_EQ(answer.cost.proposals, 6u);
      EXPECT_GT(answer.cost.exact, 0u);
      ++finished;
    }
  }
  if (count < 1000) return;
  for (int k = 0; k < 9; ++k) EXPECT_GT(held[static_cast<Proposal::Claim>(k)], 0) << k;
  EXPECT_GT(finished, count / 10);
}

// The share of answers that come from proposals, by family: all in general position; elsewhere what was reached.
TEST_F(PolyhedronPolyhedronAnswerTest, HitRateByFamily) {
  tests::SolidPairs pairs(tests::chosen_seed(92));
  const int count = tests::scaled_count(500);
  for (int f = 0; f < tests::family_count; ++f) {
    const auto family = static_cast<tests::Family>(f);
    int hits = 0;
    std::uint64_t proposals = 0;
    for (int i = 0; i < count; ++i) {
      const tests::PairCase c = pairs.next(family);
      const PairAnswer answer = polyhedron_polyhedron(c.a, c.pose_a, c.b, c.pose_b);
      hits += answer.decided_by != DecidedBy::finishing;
      EXPECT_EQ(answer.decided_by == DecidedBy::filter, answer.cost.exact == 0);
      proposals += answer.cost.proposals;
    }
    std::printf("%-14s %5d per mille, %.2f proposals a pair\n", std::string(name_of(family)).c_str(),
                hits * 1000 / count, static_cast<double>(proposals) / count);
    if (family == tests::Family::stretched_turned) continue;  // no search reaches across 600 decimal digits
    const bool plain = family == tests::Family::general;
    EXPECT_GE(1000 * hits, (plain                                   ? 1000
                            : family == tests::Family::tiny_or_huge ? 900
                                                                    : 990) *
                               count)
        << name_of(family);
  }
}

// A pyramid and its copy, turned by a little less than a bit of single precision, with the apex in its base: what
// doubles and double-doubles propose does not hold. An ordinary size is no promise that nothing is to be finished.
TEST_F(PolyhedronPolyhedronAnswerTest, APyramidOfOrdinarySizeIsFinished) {
  std::vector<Point3> points{{0, 0, 1}};
  for (int i = 0; i < 4; ++i) points.push_back({std::cos(2 * M_PI * i / 4), std::sin(2 * M_PI * i / 4), 0});
  const ConvexPolyhedron pyramid(points);
  constexpr double s = 0x1.97bc0c83a2d44p-31, t = 0x1.70c293018f74fp-31;
  const Pose there = Pose::from_matrix({1, 0, -s, 0, 1, -t, s, t, 1}, {0, 0, 1});
  const PairAnswer answer = polyhedron_polyhedron(pyramid, Pose(), pyramid, there);
  EXPECT_EQ(answer.decided_by, DecidedBy::finishing);
  EXPECT_EQ(answer.meet(), polyhedron_polyhedron_by_scan(pyramid, Pose(), pyramid, there).meet());
  EXPECT_EQ(check_placed(answer.evidence, Placed(pyramid, Pose()), Placed(pyramid, there)), CheckResult::accepted);
  EXPECT_GT(answer.cost.exact, 20u);  // pivots are counted, too
  EXPECT_EQ(polyhedron_polyhedron_by_scan(pyramid, Pose(), pyramid, there).decided_by, DecidedBy::scan);
}

// An exact walk is not free: each vertex that it looks at is a probe. Around a facet of many vertices it does not go.
TEST_F(PolyhedronPolyhedronAnswerTest, WalksOfChecksAreCounted) {
  constexpr int n = 1000;
  std::vector<Point3> points;
  for (int i = 0; i < n; ++i) {
    const double x = std::cos(2 * M_PI * i / n), y = std::sin(2 * M_PI * i / n);
    points.push_back({x, y, 0});
    points.push_back({x, y, 1});
  }
  const ConvexPolyhedron prism(points);
  const Pose here, there = shift(0, 0, 3);
  const Placed a(prism, here), b(prism, there);
  PairCertificate c;
  Cost cost;
  StageTally tally;
  // Nearly along the axis, from the far side of the cap.
  const std::uint32_t far_a = vertex_at(prism, {1, 0, 1}), far_b = vertex_at(prism, {1, 0, 0});
  EXPECT_TRUE(dispose(a, b, apart_along({-0x1p-20, 0, 1}, far_a, far_b), c, cost, tally));
  EXPECT_GE(cost.probes, 3 * (most_steps + 1));  // of one at least up to where the hierarchy takes over
  EXPECT_LE(cost.probes, 2 * 3 * (most_steps + 1) + 2 * 40);
}

}  // namespace
}  // namespace sunder::solid
