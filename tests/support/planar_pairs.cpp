#include <tests/support/planar_pairs.h>

#include <tests/support/doubles.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace sunder::tests {

using planar::ConvexPolygon;

std::string_view name_of(PlanarFamily family) {
  constexpr std::array<std::string_view, planar_family_count> names{
      "grid",       "general", "near contact", "touching",  "last bit",
      "degenerate", "sliver",  "any scale",    "contained", "large"};
  return names[static_cast<std::size_t>(family)];
}

namespace {

constexpr double full_turn = 2 * std::numbers::pi;

std::vector<Point2> mapped_vertices(const ConvexPolygon& polygon, auto map) {
  std::vector<Point2> out;
  for (const Point2& p : polygon.vertices()) out.push_back(map(p));
  return out;
}

ConvexPolygon stretched_polygon(const ConvexPolygon& polygon, double x, double y) {
  return ConvexPolygon::hull_of(mapped_vertices(polygon, [&](const Point2& p) { return Point2{p.x * x, p.y * y}; }));
}

}  // namespace

PlanarPairs::PlanarPairs(std::uint64_t seed) : random_(seed) {
  for (const std::uint32_t n : {1000u, 3000u}) {
    large_.push_back(regular_polygon(n));
    std::vector<Point2> points;
    for (std::uint32_t k = 0; k < n; ++k) {
      const double angle = random_.uniform(0, full_turn);
      points.push_back({2 * std::cos(angle), std::sin(angle)});
    }
    large_.push_back(ConvexPolygon::hull_of(points));
  }
}

// Points on a circle, on an ellipse, or in a square: 3 to some 40 vertices, 1 in size.
ConvexPolygon PlanarPairs::some_polygon() {
  const auto n = static_cast<int>(3 + random_.below(random_.below(3) == 0 ? 60 : 9));
  const auto kind = random_.below(3);
  while (true) {
    std::vector<Point2> points;
    for (int k = 0; k < n; ++k) {
      const double angle = random_.uniform(0, full_turn);
      points.push_back(kind == 0   ? Point2{std::cos(angle), std::sin(angle)}
                       : kind == 1 ? Point2{std::cos(angle), 0.5 * std::sin(angle)}
                                   : Point2{random_.uniform(-1, 1), random_.uniform(-1, 1)});
    }
    ConvexPolygon polygon = ConvexPolygon::hull_of(points);
    if (polygon.size() >= 3) return polygon;
  }
}

ConvexPolygon PlanarPairs::some_grid_polygon(int most) {
  const auto n = 1 + random_.below(static_cast<std::uint64_t>(most));
  const auto side = static_cast<std::int64_t>(2 + random_.below(6));
  const auto x = static_cast<double>(random_.between(-2, 2)), y = static_cast<double>(random_.between(-2, 2));
  std::vector<Point2> points;
  for (std::uint64_t k = 0; k < n; ++k) {
    points.push_back(
        {x + static_cast<double>(random_.between(0, side)), y + static_cast<double>(random_.between(0, side))});
  }
  return ConvexPolygon::hull_of(points);
}

// A point or a segment, in the grid.
ConvexPolygon PlanarPairs::some_short_one() {
  while (true) {
    ConvexPolygon p = some_grid_polygon(2);
    if (p.size() <= 2) return p;
  }
}

planar::Pose PlanarPairs::some_turn(double distance) {
  const double angle = random_.uniform(0, full_turn), towards = random_.uniform(0, full_turn);
  return planar::Pose::from_angle(angle, {distance * std::cos(towards), distance * std::sin(towards)});
}

planar::Pose PlanarPairs::some_grid_pose() {
  const auto number = [this](std::int64_t most) { return static_cast<double>(random_.between(-most, most)); };
  while (true) {
    const std::array<double, 4> m{number(2), number(2), number(2), number(2)};
    if (m[0] * m[3] != m[1] * m[2]) return planar::Pose::from_matrix(m, {number(4), number(4)});
  }
}

// p and 2 c - p for c on the boundary: exact, because all coordinates are multiples of 2^-20 and small.
PlanarCase PlanarPairs::touching_case(PlanarFamily family) {
  while (true) {
    const auto grid = [](double x) { return std::round(x * 0x1p20) * 0x1p-20; };
    ConvexPolygon a = ConvexPolygon::hull_of(
        mapped_vertices(some_polygon(), [&](const Point2& p) { return Point2{grid(p.x), grid(p.y)}; }));
    const auto v = static_cast<std::uint32_t>(random_.below(a.size()));
    const Point2 &p = a[v], &q = a[(v + 1) % a.size()];
    const double at = static_cast<double>(random_.below(5)) / 4;  // a vertex, or on the edge
    const Point2 c{p.x + (q.x - p.x) * at, p.y + (q.y - p.y) * at};
    ConvexPolygon b = ConvexPolygon::hull_of(
        mapped_vertices(a, [&](const Point2& r) { return Point2{2 * c.x - r.x, 2 * c.y - r.y}; }));
    if (family == PlanarFamily::touching) return {family, std::move(a), std::move(b), {}, {}, true};
    const std::array<double, 2> shift{moved_by_bits(0, 0) + static_cast<double>(random_.between(-3, 3)) * 0x1p-52,
                                      static_cast<double>(random_.between(-3, 3)) * 0x1p-52};
    if (random_.below(2) == 0)
      return {family, std::move(a), std::move(b), {}, planar::Pose::from_matrix({1, 0, 0, 1}, shift)};
    const auto moved = mapped_vertices(b, [&](const Point2& r) {
      return Point2{moved_by_bits(r.x, random_.between(-2, 2)), moved_by_bits(r.y, random_.between(-2, 2))};
    });
    return {family, std::move(a), ConvexPolygon::hull_of(moved), {}, {}};
  }
}

PlanarCase PlanarPairs::next() {
  const auto family = static_cast<PlanarFamily>(turn_);
  turn_ = (turn_ + 1) % planar_family_count;
  return next(family);
}

PlanarCase PlanarPairs::next(PlanarFamily family) {
  switch (family) {
    case PlanarFamily::grid: {
      PlanarCase c{family, some_grid_polygon(9), some_grid_polygon(9)};
      if (random_.below(2) == 0) c.pose_a = some_grid_pose();
      if (random_.below(2) == 0) c.pose_b = some_grid_pose();
      return c;
    }
    case PlanarFamily::general:
      return {family, some_polygon(), some_polygon(), some_turn(0), some_turn(random_.uniform(0.5, 2.5))};
    case PlanarFamily::near_contact: {
      // Along x from the rightmost vertex of one to the leftmost of the other, with an overlap or a gap.
      ConvexPolygon a = some_polygon(), b = some_polygon();
      const double gap = std::exp2(random_.uniform(-52, -3)) * (random_.below(2) == 0 ? 1 : -1);
      const Point2 &p = a[a.rightmost()], &q = b[b.leftmost()];
      const std::array<double, 2> shift{p.x - q.x + gap, p.y - q.y};
      if (random_.below(2) == 0)
        return {family, std::move(a), std::move(b), {}, planar::Pose::from_matrix({1, 0, 0, 1}, shift)};
      const auto moved = mapped_vertices(b, [&](const Point2& r) { return Point2{r.x + shift[0], r.y + shift[1]}; });
      return {family, std::move(a), ConvexPolygon::hull_of(moved)};
    }
    case PlanarFamily::touching:
    case PlanarFamily::last_bit: return touching_case(family);
    case PlanarFamily::degenerate: {
      ConvexPolygon a = some_short_one(), b = random_.below(2) == 0 ? some_short_one() : some_grid_polygon(6);
      if (random_.below(3) == 0) a = ConvexPolygon::hull_of(std::array{b[0]});
      if (random_.below(2) == 0) std::swap(a, b);
      return {family, std::move(a), std::move(b), random_.below(4) == 0 ? some_grid_pose() : planar::Pose()};
    }
    case PlanarFamily::sliver: {
      const double thin = std::exp2(random_.uniform(-50, -5));
      ConvexPolygon a = stretched_polygon(some_polygon(), 1, thin),
                    b = stretched_polygon(some_polygon(), random_.below(2) == 0 ? 1 : thin, 1);
      return {family, std::move(a), std::move(b), some_turn(0), some_turn(random_.uniform(0, 1.5))};
    }
    case PlanarFamily::any_scale: {
      const auto scale = [this] { return std::exp2(static_cast<double>(random_.between(-1000, 1000))); };
      const double one = scale(), other = random_.below(3) == 0 ? scale() : one;
      const PlanarCase c = next(random_.below(2) == 0 ? PlanarFamily::grid : PlanarFamily::touching);
      return {family, stretched_polygon(c.a, one, one), stretched_polygon(c.b, other, other)};
    }
    case PlanarFamily::contained: {
      ConvexPolygon a = some_polygon();
      const double size = std::exp2(random_.uniform(-12, 0));
      if (random_.below(3) == 0) {  // some of its own vertices
        std::vector<Point2> some;
        for (const Point2& p : a.vertices()) {
          if (random_.below(2) == 0 || some.empty()) some.push_back(p);
        }
        ConvexPolygon b = ConvexPolygon::hull_of(some);
        return {family, std::move(b), std::move(a)};
      }
      ConvexPolygon b = stretched_polygon(some_polygon(), size, size);
      if (random_.below(2) == 0) return {family, std::move(a), std::move(b), {}, some_turn(0)};
      return {family, std::move(b), std::move(a), some_turn(random_.uniform(0, 0.3)), {}};
    }
    case PlanarFamily::large: {
      const ConvexPolygon& a = large_[random_.below(large_.size())];
      const ConvexPolygon& b = large_[random_.below(large_.size())];
      if (random_.below(2) == 0) return {family, a, some_polygon(), {}, some_turn(random_.uniform(1, 3))};
      return {family, a, b, some_turn(0), some_turn(random_.uniform(1, 4))};
    }
  }
  return {family, some_polygon(), some_polygon()};
}

}  // namespace sunder::tests
