// Section 3 of Barba and Langerman 2015, Lemmas 3.1 to 3.6 and Theorem 3.7, on random polyhedra in whole numbers.
//
// Points are homogeneous, (x, y, z, w), w = 0 for directions. A half-space is a c with c.p >= 0 for its points. So both
// polars of anything are one formula: of a point p = (x, w) they have the half-spaces (-x, w), the one that holds the
// origin, and (x, -w). A polyhedron is what its half-spaces have in common, and is searched for its corners by trying
// all triples of them: what is unbounded has directions among its corners. The two sides of an "if and only if" are
// decided in different ways, so that a wrong sign in one is not met by the same in the other.
#include <sunder/base/random.h>
#include <sunder/predicate/point/orient.h>
#include <sunder/solid/object/convex_polyhedron.h>

#include <tests/support/exact.h>
#include <tests/support/scale.h>
#include <tests/support/shapes.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <set>
#include <utility>
#include <vector>

namespace sunder::solid {
namespace {

using tests::Whole;
using Homogeneous = std::array<Whole, 4>;  // a point, a direction, or a half-space

constexpr int fraction_bits = 20;  // coordinates are multiples of 2^-20

Whole dot(const Homogeneous& a, const Homogeneous& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2] + a[3] * b[3]; }
Homogeneous operator-(const Homogeneous& a) { return {-a[0], -a[1], -a[2], -a[3]}; }
bool is_point(const Homogeneous& p) { return p[3] > 0; }
bool has_direction(const Homogeneous& c) { return c[0] != 0 || c[1] != 0 || c[2] != 0; }

Homogeneous reduced(Homogeneous p) {
  Whole divisor = 0;
  for (const Whole& x : p) divisor = gcd(divisor, x);
  if (divisor > 1) {
    for (Whole& x : p) x /= divisor;
  }
  return p;
}

Homogeneous homogeneous(const Point3& p) {
  const auto whole = [](double x) { return Whole(static_cast<std::int64_t>(std::ldexp(x, fraction_bits))); };
  return reduced({whole(p.x), whole(p.y), whole(p.z), Whole(1) << fraction_bits});
}

// What is perpendicular to all three; zero where they depend on each other.
Homogeneous perpendicular(const Homogeneous& a, const Homogeneous& b, const Homogeneous& c) {
  const auto minor = [&](std::size_t i, std::size_t j, std::size_t k) -> Whole {
    return a[i] * (b[j] * c[k] - b[k] * c[j]) - a[j] * (b[i] * c[k] - b[k] * c[i]) + a[k] * (b[i] * c[j] - b[j] * c[i]);
  };
  return {minor(1, 2, 3), -minor(0, 2, 3), minor(0, 1, 3), -minor(0, 1, 2)};
}

bool holds(const std::vector<Homogeneous>& half_spaces, const Homogeneous& p) {
  return std::all_of(half_spaces.begin(), half_spaces.end(), [&](const Homogeneous& c) { return dot(c, p) >= 0; });
}

// Of the cone that half-spaces have in common, which holds no line.
std::vector<Homogeneous> extreme_rays(const std::vector<Homogeneous>& half_spaces) {
  std::set<Homogeneous> rays;
  for (std::size_t i = 0; i < half_spaces.size(); ++i) {
    for (std::size_t j = i + 1; j < half_spaces.size(); ++j) {
      for (std::size_t k = j + 1; k < half_spaces.size(); ++k) {
        const Homogeneous ray = perpendicular(half_spaces[i], half_spaces[j], half_spaces[k]);
        if (!has_direction(ray) && ray[3] == 0) continue;
        for (const Homogeneous& side : {ray, -ray}) {
          if (holds(half_spaces, side)) rays.insert(reduced(side));
        }
      }
    }
  }
  return {rays.begin(), rays.end()};
}

struct Polyhedron {
  std::vector<Homogeneous> half_spaces;
  std::vector<Homogeneous> corners;  // vertices, and the directions of its unbounded edges; none: it is empty

  bool is_empty() const { return corners.empty(); }
  bool is_bounded() const { return std::all_of(corners.begin(), corners.end(), is_point); }
  bool has(const Homogeneous& p) const { return holds(half_spaces, p); }
  bool lies_in(const Homogeneous& half_space) const { return holds(corners, half_space); }
  bool lies_in(const Polyhedron& other) const {
    return std::all_of(other.half_spaces.begin(), other.half_spaces.end(),
                       [&](const Homogeneous& c) { return lies_in(c); });
  }
};

Polyhedron common_part(std::vector<Homogeneous> half_spaces) {
  half_spaces.push_back({0, 0, 0, 1});
  std::vector<Homogeneous> corners = extreme_rays(half_spaces);
  half_spaces.pop_back();
  if (std::none_of(corners.begin(), corners.end(), is_point)) corners.clear();
  return {std::move(half_spaces), std::move(corners)};
}

Polyhedron common_part(const Polyhedron& a, const Polyhedron& b) {
  std::vector<Homogeneous> all = a.half_spaces;
  all.insert(all.end(), b.half_spaces.begin(), b.half_spaces.end());
  return common_part(std::move(all));
}

const Homogeneous homogeneous_origin{0, 0, 0, 1};

// rho_0(x) and rho_inf(x): the half-spaces of the plane rho(x), of all y with x.y = 1. It is a plane if x is not the
// origin.
Homogeneous near_half_space(const Homogeneous& x) { return {-x[0], -x[1], -x[2], x[3]}; }
Homogeneous far_half_space(const Homogeneous& x) { return {x[0], x[1], x[2], -x[3]}; }

// rho_0(P) and rho_inf(P). An unbounded P has directions, whose half-spaces have the origin on their boundaries.
Polyhedron near_polar(const std::vector<Homogeneous>& corners) {
  std::vector<Homogeneous> half_spaces;
  for (const Homogeneous& p : corners) half_spaces.push_back(near_half_space(p));
  return common_part(std::move(half_spaces));
}
Polyhedron far_polar(const std::vector<Homogeneous>& corners) {
  std::vector<Homogeneous> half_spaces;
  for (const Homogeneous& p : corners) half_spaces.push_back(far_half_space(p));
  return common_part(std::move(half_spaces));
}

// The point x whose rho(x) is the boundary of this half-space, c.x + d >= 0. Requires d != 0.
Homogeneous polar_of_plane(const Homogeneous& c) {
  return c[3] > 0 ? Homogeneous{-c[0], -c[1], -c[2], c[3]} : Homogeneous{c[0], c[1], c[2], -c[3]};
}

// The half-space of this inner normal, moved until its plane touches the polyhedron. None if it never does.
std::optional<Homogeneous> tangent(const Polyhedron& p, const Homogeneous& normal) {
  std::optional<Homogeneous> lowest;
  for (const Homogeneous& corner : p.corners) {
    const Whole height = normal[0] * corner[0] + normal[1] * corner[1] + normal[2] * corner[2];
    if (!is_point(corner)) {
      if (height < 0) return std::nullopt;
      continue;
    }
    const Homogeneous moved{normal[0] * corner[3], normal[1] * corner[3], normal[2] * corner[3], -height};
    if (!lowest || dot(*lowest, corner) < 0) lowest = moved;
  }
  return lowest;
}

// The planes that part two polyhedra weakly, as half-spaces that hold `inside`, their other sides holding `outside`.
// They are a cone; its extreme rays.
std::vector<Homogeneous> separators(const Polyhedron& outside, const Polyhedron& inside) {
  std::vector<Homogeneous> conditions = inside.corners;
  for (const Homogeneous& p : outside.corners) conditions.push_back(-p);
  return extreme_rays(conditions);
}

bool is_on_boundary(const Polyhedron& p, const Homogeneous& x) {
  return p.has(x) &&
         std::any_of(p.half_spaces.begin(), p.half_spaces.end(), [&](const Homogeneous& c) { return dot(c, x) == 0; });
}
bool has_inside(const Polyhedron& p, const Homogeneous& x) { return p.has(x) && !is_on_boundary(p, x); }

// A point of the polyhedron, from random weights.
Homogeneous random_point_of(const Polyhedron& p, Random& random) {
  if (p.is_empty()) {
    ADD_FAILURE() << "an empty polyhedron has no point";
    return homogeneous_origin;
  }
  Homogeneous sum{0, 0, 0, 0};
  while (sum[3] == 0) {
    for (const Homogeneous& corner : p.corners) {
      const std::int64_t weight = random.below(2) == 0 ? 0 : random.between(1, 3);
      for (std::size_t k = 0; k < 4; ++k) sum[k] += weight * corner[k];
    }
  }
  return reduced(sum);
}

Homogeneous random_direction(Random& random) {
  const Homogeneous d{random.between(-3, 3), random.between(-3, 3), random.between(-3, 3), 0};
  return has_direction(d) ? d : Homogeneous{1, 0, 0, 0};
}

Point3 half_of_grid(Random& random) {
  const Point3 p = tests::on_grid(random, 4);
  return {p.x / 2, p.y / 2, p.z / 2};
}

Polyhedron polyhedron_of(const std::vector<Point3>& points) {
  const ConvexPolyhedron body(points);
  Polyhedron result;
  for (const Point3& v : body.vertices()) result.corners.push_back(homogeneous(v));
  for (std::uint32_t f = 0; f < body.facet_count(); ++f) {
    const auto facet = body.facet(f);
    const Homogeneous plane =
        perpendicular(result.corners[facet[0]], result.corners[facet[1]], result.corners[facet[2]]);
    result.half_spaces.push_back(reduced(result.lies_in(plane) ? plane : -plane));
  }
  return result;
}

// Points whose hull is a body: on a small grid; anywhere; nearly flat. The origin may be in it, on it, or outside.
std::vector<Point3> random_points(Random& random, double size = 1) {
  for (;;) {
    const std::uint64_t kind = random.below(4), place = random.below(4);
    std::vector<Point3> points(4 + random.below(3));
    for (Point3& p : points) {
      p = kind < 2 ? half_of_grid(random) : tests::in_cube(random);
      if (kind == 3) p.z = std::ldexp(p.z, -16);
    }
    const Point3 move = place == 0   ? points[0]
                        : place == 1 ? Point3{(points[0].x + points[1].x) / 2, (points[0].y + points[1].y) / 2,
                                              (points[0].z + points[1].z) / 2}
                        : place == 2 ? half_of_grid(random)
                                     : Point3{};
    for (Point3& p : points) {
      for (std::size_t k = 0; k < 3; ++k) p[k] = tests::snapped(size * (p[k] - move[k]), fraction_bits);
    }
    if (ConvexPolyhedron(points).dimension() == 3) return points;
  }
}
Polyhedron random_polyhedron(Random& random, double size = 1) { return polyhedron_of(random_points(random, size)); }

// P with a vertex x and Q with a vertex z, x.z = 1, x.y <= 1 in Q, z.y >= 1 in P. So P and rho_0(Q) have x in common,
// and Q and rho_inf(P) have z, and the planes rho(z) and rho(x) part them: they touch. Products are exact.
std::pair<Polyhedron, Polyhedron> touching_pair(Random& random) {
  const auto product = [](const Point3& a, const Point3& b) { return a.x * b.x + a.y * b.y + a.z * b.z; };
  for (;;) {
    std::vector<Point3> of_p{half_of_grid(random)}, of_q{half_of_grid(random)};
    if (product(of_p[0], of_q[0]) != 1) continue;
    const std::size_t p_size = 4 + random.below(3), q_size = 4 + random.below(3);
    while (of_p.size() < p_size) {
      const Point3 y = half_of_grid(random);
      if (product(of_q[0], y) >= 1) of_p.push_back(y);
    }
    while (of_q.size() < q_size) {
      const Point3 y = half_of_grid(random);
      if (product(of_p[0], y) <= 1) of_q.push_back(y);
    }
    if (ConvexPolyhedron(of_p).dimension() < 3 || ConvexPolyhedron(of_q).dimension() < 3) continue;
    return {polyhedron_of(of_p), polyhedron_of(of_q)};
  }
}

// How often each of several outcomes was: all of them often.
template <std::size_t N>
void expect_often(const std::array<int, N>& hits, int runs) {
  if (runs < 100) return;  // too few to tell
  for (std::size_t i = 0; i < N; ++i) EXPECT_GE(hits[i], runs / 50) << "outcome " << i << " of " << runs << " runs";
}

// x in h_0 iff rho(h) in rho_0(x); the same with h_inf, rho_inf, and with h and rho(x). The left sides by orient_3d.
TEST(PolarProperty, Lemma31PointAndPlane) {
  const std::uint64_t seed = tests::chosen_seed(31);
  SCOPED_TRACE("seed " + std::to_string(seed));
  Random random(seed);
  const int runs = tests::scaled_count(20000);
  std::array<int, 3> hits{};
  for (int run = 0; run < runs; ++run) {
    const Point3 a = half_of_grid(random), b = half_of_grid(random), c = half_of_grid(random);
    const Point3 point = run % 4 == 0 ? a : half_of_grid(random);
    const Sign of_origin = orient_3d(a, b, c, Point3{}), of_point = orient_3d(a, b, c, point);
    if (of_origin == Sign::zero) continue;
    const Homogeneous x = homogeneous(point);
    const Homogeneous polar = polar_of_plane(perpendicular(homogeneous(a), homogeneous(b), homogeneous(c)));
    const bool is_in_plane = of_point == Sign::zero, is_with_origin = of_point == of_origin;
    ASSERT_EQ(is_in_plane || is_with_origin, dot(near_half_space(x), polar) >= 0);
    ASSERT_EQ(is_in_plane || !is_with_origin, dot(far_half_space(x), polar) >= 0);
    ASSERT_EQ(is_in_plane, dot(near_half_space(x), polar) == 0);
    ++hits[is_in_plane ? 0 : is_with_origin ? 1 : 2];
  }
  expect_often(hits, runs);
}

// rho_0(rho_0(P)) = P if P has the origin; else it is the hull of P and the origin. And what is said before it: P has
// the origin iff rho_inf(P) is empty; rho_0(P) is bounded iff the origin is inside P.
TEST(PolarProperty, Lemma32PolarOfThePolar) {
  const std::uint64_t seed = tests::chosen_seed(32);
  SCOPED_TRACE("seed " + std::to_string(seed));
  Random random(seed);
  const int runs = tests::scaled_count(1000);
  std::array<int, 3> hits{};
  for (int run = 0; run < runs; ++run) {
    const Polyhedron p = random_polyhedron(random), polar = near_polar(p.corners), twice = near_polar(polar.corners);
    const std::set<Homogeneous> vertices(p.corners.begin(), p.corners.end());
    ASSERT_EQ(std::set<Homogeneous>(twice.corners.begin(), twice.corners.end()) == vertices, p.has(homogeneous_origin));
    ASSERT_TRUE(p.lies_in(twice) && twice.has(homogeneous_origin) && twice.is_bounded());
    ASSERT_EQ(far_polar(p.corners).is_empty(), p.has(homogeneous_origin));
    ASSERT_EQ(polar.is_bounded(), has_inside(p, homogeneous_origin));
    ++hits[has_inside(p, homogeneous_origin) ? 0 : p.has(homogeneous_origin) ? 1 : 2];
  }
  expect_often(hits, runs);
}

// x in rho_0(P) iff P lies in rho_0(x); the same with infinity. The left side by P's vertices, the right side by what
// P's facets leave beyond rho(x).
TEST(PolarProperty, Lemma33PointsOfThePolar) {
  const std::uint64_t seed = tests::chosen_seed(33);
  SCOPED_TRACE("seed " + std::to_string(seed));
  Random random(seed);
  const int runs = tests::scaled_count(1000);
  std::array<int, 4> hits{};
  int ties = 0;
  for (int run = 0; run < runs; ++run) {
    const Polyhedron p = random_polyhedron(random), near = near_polar(p.corners), far = far_polar(p.corners);
    const Polyhedron& source = run % 2 == 0 || far.is_empty() ? near : far;
    const Homogeneous x = run % 4 < 2 ? random_point_of(source, random) : homogeneous(half_of_grid(random));
    if (!has_direction(x)) continue;
    const auto reaches_beyond = [&](const Homogeneous& half_space) {  // its complement meets P
      std::vector<Homogeneous> all = p.half_spaces;
      all.push_back(-half_space);
      const Polyhedron part = common_part(std::move(all));
      return !part.lies_in(half_space);
    };
    ASSERT_EQ(near.has(x), !reaches_beyond(near_half_space(x)));
    ASSERT_EQ(far.has(x), !reaches_beyond(far_half_space(x)));
    ASSERT_FALSE(near.has(x) && far.has(x));
    ++hits[near.has(x) ? 0 : 1];
    ++hits[far.has(x) ? 2 : 3];
    ties += is_on_boundary(near, x) || is_on_boundary(far, x) ? 1 : 0;
  }
  expect_often(hits, runs);
  expect_often(std::array{ties}, runs);
}

// If x is in P, then rho_0(P) lies in rho_0(x), and rho_inf(P) in rho_inf(x). The converse is false.
TEST(PolarProperty, Lemma34PolarsOfPoints) {
  const std::uint64_t seed = tests::chosen_seed(34);
  SCOPED_TRACE("seed " + std::to_string(seed));
  Random random(seed);
  const int runs = tests::scaled_count(1000);
  std::array<int, 4> hits{};
  for (int run = 0; run < runs; ++run) {
    const Polyhedron p = random_polyhedron(random), near = near_polar(p.corners), far = far_polar(p.corners);
    const Homogeneous x = run % 2 == 0 ? random_point_of(p, random) : homogeneous(half_of_grid(random));
    const bool is_in_near = near.lies_in(near_half_space(x)), is_in_far = far.lies_in(far_half_space(x));
    if (p.has(x)) {
      ASSERT_TRUE(is_in_near && is_in_far);
      ++hits[far.is_empty() ? 0 : 1];
    } else {
      ASSERT_FALSE(is_in_near && is_in_far && !far.is_empty());  // both halves together have a converse
      ++hits[is_in_near || is_in_far ? 2 : 3];
    }
  }
  expect_often(hits, runs);
}

// If a plane is tangent to rho_0(P) or to rho_inf(P), its polar is on the boundary of P.
TEST(PolarProperty, Lemma35TangentPlanes) {
  const std::uint64_t seed = tests::chosen_seed(35);
  SCOPED_TRACE("seed " + std::to_string(seed));
  Random random(seed);
  const int runs = tests::scaled_count(1000);
  std::array<int, 4> hits{};
  for (int run = 0; run < runs; ++run) {
    const Polyhedron p = random_polyhedron(random), near = near_polar(p.corners), far = far_polar(p.corners);
    // Along a point of P every plane finds where to touch the far polar, and against it the near one.
    const Homogeneous along = random_point_of(p, random);
    const Homogeneous normal = run % 2 == 0 ? random_direction(random) : along;
    if (!has_direction(normal)) continue;
    const std::optional<Homogeneous> at_near = tangent(near, -normal), at_far = tangent(far, normal);
    for (const std::optional<Homogeneous>& plane : {at_near, at_far}) {
      if (!plane) continue;
      ASSERT_NE((*plane)[3], 0);  // not through the origin
      ASSERT_TRUE(is_on_boundary(p, polar_of_plane(*plane)));
    }
    ++hits[at_near ? 0 : 1];
    ++hits[at_far ? 2 : 3];
  }
  expect_often(hits, runs);
}

// If P lies in Q, then rho_0(Q) lies in rho_0(P), and rho_inf(Q) in rho_inf(P). By Lemma 3.2 the first has a converse
// where Q, and so with it P, has the origin.
TEST(PolarProperty, Lemma36InclusionIsReversed) {
  const std::uint64_t seed = tests::chosen_seed(36);
  SCOPED_TRACE("seed " + std::to_string(seed));
  Random random(seed);
  const int runs = tests::scaled_count(1000);
  std::array<int, 4> hits{};
  for (int run = 0; run < runs; ++run) {
    const std::vector<Point3> of_q = random_points(random);
    std::vector<Point3> of_p = of_q;
    if (run % 2 == 0) {  // points of Q
      for (std::size_t i = 0; i + 1 < of_p.size(); i += 2) {
        for (std::size_t k = 0; k < 3; ++k) {
          of_p[i][k] = tests::snapped((of_q[i][k] + of_q[i + 1][k]) / 2, fraction_bits);
        }
      }
      if (ConvexPolyhedron(of_p).dimension() < 3) continue;
    } else {
      of_p = random_points(random, 0.5);
    }
    const Polyhedron p = polyhedron_of(of_p), q = polyhedron_of(of_q);
    const Polyhedron near_p = near_polar(p.corners), near_q = near_polar(q.corners);
    const Polyhedron far_p = far_polar(p.corners), far_q = far_polar(q.corners);
    if (p.lies_in(q)) {
      ASSERT_TRUE(near_q.lies_in(near_p));
      ASSERT_TRUE(far_q.lies_in(far_p));
      ++hits[far_q.is_empty() ? 0 : 1];
    } else if (p.has(homogeneous_origin) && q.has(homogeneous_origin)) {
      ASSERT_FALSE(near_q.lies_in(near_p));
      ++hits[2];
    } else {
      ++hits[3];
    }
  }
  expect_often(hits, runs);
}

// `first` and `second` meet iff a plane parts `outside` and `inside`, of which `inside` is on the side of the plane
// that has the origin, and `touched`, one of the two, is a polar: rho_inf(first), or rho_0(second).
// (1) x of both: rho(x) parts. (2) A plane that parts and is tangent to `touched`: its polar is in both.
struct Outcome {
  bool meet = false;
  bool is_trivial = false;  // nothing to part
  bool touch = false;       // they meet, and in no more than a plane
};
void check_theorem(const Polyhedron& first, const Polyhedron& second, const Polyhedron& outside,
                   const Polyhedron& inside, bool touches_outside, Random& random, Outcome& outcome) {
  const Polyhedron common = common_part(first, second);
  outcome.meet = !common.is_empty();
  outcome.is_trivial = outside.is_empty() || inside.is_empty();
  const std::vector<Homogeneous> parting =
      outcome.is_trivial ? std::vector<Homogeneous>{} : separators(outside, inside);
  // A plane through the origin has no polar, and does not count.
  const bool parts = std::any_of(parting.begin(), parting.end(), [](const Homogeneous& c) { return c[3] != 0; });
  ASSERT_EQ(outcome.meet, outcome.is_trivial || parts);
  if (!outcome.meet || outcome.is_trivial) return;

  for (int i = 0; i < 4; ++i) {  // (1)
    const Homogeneous x = random_point_of(common, random);
    ASSERT_TRUE(first.has(x) && second.has(x));
    if (!has_direction(x)) continue;
    ASSERT_TRUE(outside.lies_in(far_half_space(x)));
    ASSERT_TRUE(inside.lies_in(near_half_space(x)));
  }
  for (const Homogeneous& plane : parting) {  // (2)
    ASSERT_TRUE(has_direction(plane));
    const std::optional<Homogeneous> moved = touches_outside ? tangent(outside, -plane) : tangent(inside, plane);
    ASSERT_TRUE(moved);
    ASSERT_NE((*moved)[3], 0);
    const Homogeneous x = polar_of_plane(*moved);
    ASSERT_TRUE(first.has(x) && second.has(x));
  }
  Homogeneous middle{0, 0, 0, 0};
  for (const Homogeneous& corner : common.corners) {
    for (std::size_t k = 0; k < 4; ++k) middle[k] += is_point(corner) ? corner[k] : Whole(0);
  }
  outcome.touch = !has_inside(common, middle);
}

TEST(PolarProperty, Theorem37MeetingIsPartingInThePolar) {
  const std::uint64_t seed = tests::chosen_seed(37);
  SCOPED_TRACE("seed " + std::to_string(seed));
  Random random(seed);
  const int runs = tests::scaled_count(600);
  std::array<int, 4> plain{}, symmetric{};
  for (int run = 0; run < runs; ++run) {
    const bool is_touching = run % 8 == 0;
    const auto [p, q] = is_touching ? touching_pair(random)
                                    : std::pair{random_polyhedron(random), random_polyhedron(random, 1 + run % 2)};
    const Polyhedron far = far_polar(p.corners), near = near_polar(q.corners);
    const auto count = [](const Outcome& outcome, std::array<int, 4>& hits) {
      ++hits[!outcome.meet ? 0 : outcome.is_trivial ? 1 : outcome.touch ? 2 : 3];
    };
    Outcome outcome;
    // P and rho_0(Q) meet iff a plane parts rho_inf(P) and Q.
    ASSERT_NO_FATAL_FAILURE(check_theorem(p, near, far, q, true, random, outcome)) << "run " << run;
    count(outcome, plain);
    ASSERT_TRUE(!is_touching || outcome.touch);
    outcome = {};
    // Q and rho_inf(P) meet iff a plane parts rho_0(Q) and P.
    ASSERT_NO_FATAL_FAILURE(check_theorem(q, far, p, near, false, random, outcome)) << "run " << run;
    count(outcome, symmetric);
    ASSERT_TRUE(!is_touching || outcome.touch);
  }
  expect_often(plain, runs);
  expect_often(std::array{symmetric[0], symmetric[2], symmetric[3]}, runs);  // P and rho_0(Q) are never empty
}

}  // namespace
}  // namespace sunder::solid
