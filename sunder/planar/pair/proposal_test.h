// Pairs of polygons for the tests of the methods that search in doubles, and what every answer has to fulfil.
#pragma once

#include <sunder/base/random.h>
#include <sunder/certificate/check.h>
#include <sunder/planar/pair/polygon_polygon.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

namespace sunder::planar::proposal_test {

using Method = PairAnswer (*)(const ConvexPolygon&, const Pose&, const ConvexPolygon&, const Pose&);

inline std::vector<Point3> in_space(const ConvexPolygon& polygon) {
  std::vector<Point3> vertices;
  for (const Point2& p : polygon.vertices()) vertices.push_back({p.x, p.y, 0});
  return vertices;
}

// The certificate, checked against all vertices, proves the verdict.
inline bool is_proved(const PairAnswer& answer, const ConvexPolygon& a, const Pose& pose_a, const ConvexPolygon& b,
                      const Pose& pose_b) {
  const std::vector<Point3> of_a = in_space(a), of_b = in_space(b);
  const Affine3 map_a = planar::in_space(pose_a.affine()), map_b = planar::in_space(pose_b.affine());
  return check_absolutely(answer.evidence, {of_a, map_a, false}, {of_b, map_b, false}) == CheckResult::accepted;
}

inline std::size_t index_below(Random& random, std::size_t n) { return random.below(n); }

// Small integers: every coincidence there is.
inline ConvexPolygon on_grid(Random& random, double unit) {
  const std::uint64_t count = 1 + random.below(12), side = 3 + random.below(8);
  const double x = static_cast<double>(random.below(6)), y = static_cast<double>(random.below(6));
  std::vector<Point2> points;
  for (std::uint64_t k = 0; k < count; ++k) {
    points.push_back({unit * (x + static_cast<double>(random.below(side))),  //
                      unit * (y + static_cast<double>(random.below(side)))});
  }
  return ConvexPolygon::hull_of(points);
}
inline Pose on_grid_pose(Random& random, double unit) {
  if (random.below(2) == 0) return Pose();
  while (true) {
    std::array<double, 4> m{};
    for (double& x : m) x = static_cast<double>(random.between(-2, 2));
    if (m[0] * m[3] == m[1] * m[2]) continue;
    return Pose::from_matrix(
        m, {unit * static_cast<double>(random.between(-4, 4)), unit * static_cast<double>(random.between(-4, 4))});
  }
}

// On an ellipse of half axes 1 and `narrow`, turned; at random angles, or regular.
inline ConvexPolygon on_ellipse(std::uint32_t n, double narrow, bool regular, Random& random) {
  const double turn = random.uniform(0, 2 * std::numbers::pi), c = std::cos(turn), s = std::sin(turn);
  std::vector<Point2> points;
  for (std::uint32_t k = 0; k < n; ++k) {
    const double angle =
        2 * std::numbers::pi * (regular ? static_cast<double>(k) / static_cast<double>(n) : random.unit());
    const double x = std::cos(angle), y = narrow * std::sin(angle);
    points.push_back({x * c - y * s, x * s + y * c});
  }
  return ConvexPolygon::hull_of(points);
}

inline Point2 image(const Pose& pose, const Point2& p) {
  const auto& [m, t] = pose.affine();
  return {m[0] * p.x + m[1] * p.y + t[0], m[2] * p.x + m[3] * p.y + t[1]};
}
inline Pose moved_to(const Pose& pose, const Point2& to) {
  return Pose::from_matrix(pose.affine().linear, {to.x, to.y});
}
inline Pose turned(double scale, Random& random) {
  const double angle = random.uniform(0, 2 * std::numbers::pi);
  const double c = scale * std::cos(angle), s = scale * std::sin(angle);
  if (random.below(2) == 0) return Pose::from_matrix({c, -s, s, c}, {0, 0});
  return Pose::from_matrix({c, s, s, -c}, {0, 0});
}

// The pose that puts b before an inner point of an edge of a, its nearest vertex at this distance (negative: inside).
inline Pose before_edge(const ConvexPolygon& a, const Pose& pose_a, const ConvexPolygon& b, const Pose& turn_b,
                        double gap, Random& random) {
  const std::size_t i = index_below(random, a.size());
  const Point2 p = image(pose_a, a.vertices()[i]), q = image(pose_a, a.vertices()[(i + 1) % a.size()]);
  const double length = std::hypot(q.x - p.x, q.y - p.y) * (pose_a.reflects() ? -1 : 1);
  const Point2 out{(q.y - p.y) / length, (p.x - q.x) / length};
  Point2 near{};
  double least = HUGE_VAL;
  for (const Point2& v : b.vertices()) {
    const Point2 w = image(turn_b, v);
    const double height = w.x * out.x + w.y * out.y;
    if (height < least) least = height, near = w;
  }
  const double part = random.unit();
  return moved_to(turn_b, {p.x + part * (q.x - p.x) - near.x + gap * out.x,  //
                           p.y + part * (q.y - p.y) - near.y + gap * out.y});
}

enum class Regime { anywhere, apart, near_apart, near_meet, shallow, contained };
inline constexpr Regime regimes[] = {Regime::anywhere,  Regime::apart,   Regime::near_apart,
                                     Regime::near_meet, Regime::shallow, Regime::contained};

// The size of a is 1; gaps are at least `least_gap`.
inline Pose pose_in(Regime regime, const ConvexPolygon& a, const Pose& pose_a, const ConvexPolygon& b, double least_gap,
                    Random& random) {
  const double scale = random.log_uniform(0.1, regime == Regime::contained ? 1 : 10);
  const Pose turn = turned(scale, random);
  const auto before = [&](double gap) { return before_edge(a, pose_a, b, turn, gap, random); };
  switch (regime) {
    case Regime::anywhere: {
      const double reach = 1.5 * (1 + scale);
      return moved_to(turn, {random.uniform(-reach, reach), random.uniform(-reach, reach)});
    }
    case Regime::apart: return before(random.log_uniform(1e-2, 10));
    case Regime::near_apart: return before(random.log_uniform(least_gap, 1e-2));
    case Regime::near_meet: return before(-random.log_uniform(least_gap, 1e-2));
    case Regime::shallow: return before(-random.log_uniform(1e-2, 0.3));
    case Regime::contained: break;
  }
  return moved_to(turn, {random.uniform(-0.05, 0.05), random.uniform(-0.05, 0.05)});
}

// Polygons of 3 to `most` vertices, regular and random, round and narrow.
inline std::vector<ConvexPolygon> many(std::size_t count, double most, double narrow, Random& random) {
  std::vector<ConvexPolygon> polygons;
  while (polygons.size() < count) {
    const std::uint32_t n = std::max(3u, static_cast<std::uint32_t>(random.log_uniform(3, most)));
    polygons.push_back(on_ellipse(n, random.log_uniform(narrow, 1), random.below(3) == 0, random));
    if (polygons.back().size() < 3) polygons.pop_back();
  }
  return polygons;
}

// The tests that both methods pass.

inline void agrees_on_grids(Method method, std::uint64_t seed, double unit, int cases) {
  SCOPED_TRACE(seed);
  Random random(seed);
  int meet = 0, finished = 0, reflected = 0;
  for (int t = 0; t < cases; ++t) {
    const ConvexPolygon a = on_grid(random, unit), b = on_grid(random, unit);
    const Pose pose_a = on_grid_pose(random, unit), pose_b = on_grid_pose(random, unit);
    const PairAnswer answer = method(a, pose_a, b, pose_b);
    ASSERT_EQ(answer.meet(), polygon_polygon_by_scan(a, pose_a, b, pose_b).meet()) << "case " << t;
    ASSERT_TRUE(is_proved(answer, a, pose_a, b, pose_b)) << "case " << t;
    meet += answer.meet(), reflected += pose_a.reflects();
    finished += answer.decided_by == DecidedBy::finishing;
  }
  EXPECT_GT(meet, cases / 10);
  EXPECT_LT(meet, cases / 2);
  EXPECT_GT(reflected, cases / 10);
  EXPECT_LE(finished, cases / 1000);
}

// In each regime; at most `per_mille` of the answers are left to the exact search.
inline void seldom_finishes(Method method, std::uint64_t seed, double most, double narrow, double least_gap, int cases,
                            int per_mille) {
  SCOPED_TRACE(seed);
  Random random(seed);
  const std::vector<ConvexPolygon> polygons = many(60, most, narrow, random);
  for (const Regime regime : regimes) {
    SCOPED_TRACE(static_cast<int>(regime));
    int meet = 0, finished = 0;
    for (int t = 0; t < cases; ++t) {
      const ConvexPolygon &a = polygons[index_below(random, 60)], &b = polygons[index_below(random, 60)];
      const Pose pose_a = turned(1, random), pose_b = pose_in(regime, a, pose_a, b, least_gap, random);
      const PairAnswer answer = method(a, pose_a, b, pose_b);
      ASSERT_TRUE(is_proved(answer, a, pose_a, b, pose_b)) << "case " << t;
      meet += answer.meet();
      finished += answer.decided_by == DecidedBy::finishing;
    }
    EXPECT_LE(finished * 1000, per_mille * cases);
    const bool apart = regime == Regime::apart || regime == Regime::near_apart, anywhere = regime == Regime::anywhere;
    EXPECT_GE(meet, apart ? 0 : anywhere ? cases / 40 : cases / 2);
    EXPECT_LE(meet, apart ? cases / 5 : anywhere ? cases / 2 : cases);
  }
}

// Coordinates that searches in doubles cannot square, or at all; the verdict is that of the same polygons at size 1.
inline void scales(Method method, std::uint64_t seed, int exponent, bool same_evidence) {
  SCOPED_TRACE(exponent);
  Random random(seed);
  const double unit = std::ldexp(1.0, exponent);
  int meet = 0;
  for (int t = 0; t < 500; ++t) {
    const std::uint64_t before = random.next();
    Random at_one(before), at_unit(before);
    const ConvexPolygon a1 = on_grid(at_one, 1), b1 = on_grid(at_one, 1);
    const ConvexPolygon a = on_grid(at_unit, unit), b = on_grid(at_unit, unit);
    const Pose pose_a1 = on_grid_pose(at_one, 1), pose_a = on_grid_pose(at_unit, unit);
    const PairAnswer expected = method(a1, pose_a1, b1, Pose()), answer = method(a, pose_a, b, Pose());
    ASSERT_EQ(answer.meet(), expected.meet());
    ASSERT_TRUE(is_proved(answer, a, pose_a, b, Pose()));
    if (same_evidence) {
      EXPECT_EQ(answer.cost.probes, expected.cost.probes);
      if (const auto* common = std::get_if<CommonVertices>(&answer.evidence)) {
        EXPECT_EQ(common->vertices, std::get<CommonVertices>(expected.evidence).vertices);
      } else {
        EXPECT_EQ(std::get<Separation>(answer.evidence).extreme_a, std::get<Separation>(expected.evidence).extreme_a);
      }
    }
    meet += answer.meet();
  }
  EXPECT_GT(meet, 50);
}

// What no proposal can come from: products and differences that overflow, polygons with points of every size.
inline void survives_anything(Method method, std::uint64_t seed) {
  SCOPED_TRACE(seed);
  Random random(seed);
  const auto any = [&] {
    const double size = std::ldexp(random.uniform(0.5, 1), static_cast<int>(random.between(-1073, 1023)));
    return random.below(8) == 0 ? 0.0 : random.below(2) == 0 ? size : -size;
  };
  const auto polygon = [&] {
    std::vector<Point2> points;
    for (int k = 0; k < 8; ++k) points.push_back({any(), any()});
    if (random.below(2) == 0) points.push_back({1.7e308, -1.7e308}), points.push_back({-1.7e308, 1.7e308});
    return ConvexPolygon::hull_of(points);
  };
  for (int t = 0; t < 300; ++t) {
    const ConvexPolygon a = polygon(), b = polygon();
    const PairAnswer answer = method(a, Pose(), b, Pose());
    ASSERT_EQ(answer.meet(), polygon_polygon_by_difference(a, Pose(), b, Pose()).meet());
    ASSERT_TRUE(is_proved(answer, a, Pose(), b, Pose()));
  }
}

}  // namespace sunder::planar::proposal_test
