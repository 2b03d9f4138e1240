// Sets of convex polygons for differential tests: small and nasty, from a seed.
#pragma once

#include <sunder/base/random.h>
#include <sunder/planar/object/convex_polygon.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

namespace sunder::tests {

inline constexpr int convex_family_count = 7;

// Sets of which some meet, of the family by number: of hulls on a grid, of triangles and squares of a tessellation,
// nested, slivers, of all scales.
inline std::vector<planar::ConvexPolygon> some_convex_polygons(Random& random, int family) {
  std::vector<planar::ConvexPolygon> polygons;
  const auto hull = [](const std::vector<Point2>& points) { return planar::ConvexPolygon::hull_of(points); };
  const auto at = [&](std::uint64_t side) { return static_cast<double>(random.below(side)); };
  const std::size_t count = 2 + random.below(7);
  switch (family) {
    case 0:
      for (std::size_t k = 0; k < count; ++k) {  // small ones on a larger grid
        const double x = at(12), y = at(12);
        std::vector<Point2> points(1 + random.below(5));
        for (Point2& p : points) p = {x + at(4), y + at(4)};
        polygons.push_back(hull(points));
      }
      break;
    case 1:  // parts of the plane that share sides and corners, and some more
      for (double x = 0; x < 3; ++x) {
        for (double y = 0; y < 3; ++y) {
          const std::array<Point2, 4> corners{{{x, y}, {x + 1, y}, {x + 1, y + 1}, {x, y + 1}}};
          const std::size_t first = random.below(2);
          for (const std::size_t from : {first, first + 2}) {
            if (random.below(3) == 0) continue;
            polygons.push_back(hull({corners[from], corners[(from + 1) % 4], corners[(from + 2) % 4]}));
          }
          if (random.below(9) == 0) polygons.push_back(hull({corners[first], corners[first + 1]}));
          if (random.below(9) == 0) polygons.push_back(hull({corners[first]}));
        }
      }
      if (random.below(4) == 0) {
        polygons.push_back(hull({{at(7) / 2, at(7) / 2}, {at(7) / 2, at(7) / 2}, {at(7) / 2, at(7) / 2}}));
      }
      break;
    case 2:  // slivers through a small grid, nearly parallel
      for (std::size_t k = 0; k < count; ++k) {
        const double y = at(40);
        polygons.push_back(hull({{at(3), y}, {20 + at(3), y + at(4)}, {10 + at(3), y + at(3)}}));
      }
      break;
    case 3:  // one on or next to a vertex or edge of another one, to the last bit
      for (std::size_t k = 0; k < 2 + count / 3; ++k) {
        std::vector<Point2> points(1 + random.below(4));
        for (Point2& p : points) p = {random.uniform(-3, 3), random.uniform(-3, 3)};
        if (k > 0) {
          const planar::ConvexPolygon& other = polygons.back();
          const Point2 p = other[static_cast<std::uint32_t>(random.below(other.size()))];
          const double right = 4 * static_cast<double>(random.below(3)) - 4;
          const Point2 on = random.below(2) == 0 ? p : Point2{std::nextafter(p.x, right), p.y};
          for (Point2& q : points) q = {on.x + std::fabs(q.x), on.y + std::fabs(q.y)};
          points.push_back(on);
        }
        polygons.push_back(hull(points));
      }
      break;
    case 4:  // stacked: each inside of, above or touching the last one
      for (std::size_t k = 0; k < count; ++k) {
        const double x = at(4), y = 3 * static_cast<double>(k);
        polygons.push_back(hull({{x, y}, {x + at(9), y + at(5)}, {x + at(9), y + at(4)}, {x + at(9), y}}));
      }
      break;
    case 5:  // two long ones that may meet at their far ends, with short ones between their near ends
      polygons.push_back(hull({{0, 0}, {1, -at(4)}, {30, 10 + at(3)}}));
      polygons.push_back(hull({{0, 30}, {1, 30 + at(4)}, {30, 11 + at(3)}}));
      for (std::size_t k = 0; k < count; ++k) {
        const double x = at(6), y = 5 + 3 * static_cast<double>(k);
        polygons.push_back(hull({{x, y}, {x + 1 + at(4), y + at(3)}, {x + 1, y + at(3)}}));
      }
      break;
    default:  // some scale
      polygons = some_convex_polygons(random, static_cast<int>(random.below(6)));
      const double scale = std::ldexp(1, static_cast<int>(random.between(-1000, 1000)));
      for (planar::ConvexPolygon& polygon : polygons) {
        std::vector<Point2> points;
        for (const Point2& p : polygon.vertices()) points.push_back({scale * p.x, scale * p.y});
        polygon = hull(points);
      }
  }
  return polygons;
}

// --- With something in common, or nearly so --------------------------------------------------------------------------

enum class CommonConvexFamily : int {
  grid,      // hulls of whole points, points and segments among them
  touching,  // the same on sides of one point
  last_bit,  // those, a unit in the last place off
  generic,   // about one place, some common part or nearly so
  nested,    // large ones in which some edges matter
  thin,      // on one vertical or slanted line, nearly
  any_scale,
};
inline constexpr int common_convex_family_count = 7;
inline constexpr std::array<const char*, common_convex_family_count> common_convex_family_names{
    "grid", "touching", "last bit", "generic", "nested", "thin", "any scale"};

class CommonConvexSets {
 public:
  explicit CommonConvexSets(std::uint64_t seed) : random_(seed) {}

  std::vector<planar::ConvexPolygon> next(CommonConvexFamily family) {
    std::vector<planar::ConvexPolygon> set;
    for (const std::vector<Point2>& points : points_of(family)) set.push_back(planar::ConvexPolygon::hull_of(points));
    return set;
  }

 private:
  using Points = std::vector<std::vector<Point2>>;

  double whole(std::int64_t low, std::int64_t high) { return static_cast<double>(random_.between(low, high)); }

  Points points_of(CommonConvexFamily family) {
    Points set;
    const auto add = [&](std::int64_t count, const auto& point) {
      set.emplace_back();
      for (; count > 0; --count) set.back().push_back(point());
    };
    switch (family) {
      case CommonConvexFamily::grid: {
        const std::int64_t side = random_.between(2, 6);
        for (std::int64_t n = random_.between(1, 4); n > 0; --n) {
          add(random_.between(random_.below(4) == 0 ? 1 : 3, 5),
              [&] { return Point2{whole(0, side), whole(0, side)}; });
          if (random_.below(8) == 0) set.push_back(set[random_.below(set.size())]);
        }
        break;
      }
      case CommonConvexFamily::touching: {  // all hold the origin, or come to the line y = 0 or x = 0 near it
        const bool turned = random_.below(2) != 0;
        for (std::int64_t n = random_.between(2, 4); n > 0; --n) {
          const double side = random_.below(2) ? 1 : -1, reach = whole(0, 3);
          add(random_.between(1, 4), [&] {
            const Point2 p{whole(-4, 4), side * whole(0, 4)};
            return turned ? Point2{p.y, p.x} : p;
          });
          if (random_.below(3)) set.back().push_back({0, 0});
          if (random_.below(2)) set.back().push_back(turned ? Point2{0, reach} : Point2{reach, 0});
        }
        break;
      }
      case CommonConvexFamily::last_bit:
        set = points_of(static_cast<CommonConvexFamily>(random_.below(2)));
        for (auto& points : set) {
          for (Point2& p : points) {
            for (double* x : {&p.x, &p.y}) {
              if (random_.below(3) == 0) *x = std::nextafter(*x, random_.below(2) ? HUGE_VAL : -HUGE_VAL);
            }
          }
        }
        break;
      case CommonConvexFamily::generic:
        for (std::int64_t n = random_.between(1, 5); n > 0; --n) {
          add(random_.between(3, 6), [&] { return Point2{random_.uniform(-1, 1), random_.uniform(-1, 1)}; });
        }
        break;
      case CommonConvexFamily::nested:
        for (std::int64_t n = random_.between(2, 5); n > 0; --n) {
          const double size = random_.uniform(1, 1.3), x = random_.uniform(-0.2, 0.2), y = random_.uniform(-0.2, 0.2);
          add(random_.between(4, 7), [&] {
            const double angle = random_.uniform(0, 6.3);
            return Point2{x + size * std::cos(angle), y + size * std::sin(angle)};
          });
        }
        break;
      case CommonConvexFamily::thin: {
        const double slope = whole(0, 2), wide = random_.below(3) == 0 ? 1e-15 : 0;
        const bool vertical = random_.below(2) != 0;
        for (std::int64_t n = random_.between(1, 5); n > 0; --n) {
          add(random_.between(1, 3), [&] {
            const double t = whole(-5, 5), off = wide * whole(-1, 1);
            return vertical ? Point2{off, t} : Point2{t, slope * t + off};
          });
          if (random_.below(2)) add(4, [&] { return Point2{whole(-6, 6), whole(-6, 6)}; });
        }
        break;
      }
      case CommonConvexFamily::any_scale: {
        if (random_.below(2)) {
          set = points_of(static_cast<CommonConvexFamily>(random_.below(6)));
          const int exponent =
              static_cast<int>(random_.below(2) ? random_.between(900, 1015) : -random_.between(900, 1000));
          for (auto& points : set) {
            for (Point2& p : points) p = {std::ldexp(p.x, exponent), std::ldexp(p.y, exponent)};
          }
          break;
        }
        const auto any = [&] { return random_.log_uniform(1e-300, 1e300) * (random_.below(2) ? 1 : -1); };
        for (std::int64_t n = random_.between(1, 3); n > 0; --n) add(3, [&] { return Point2{any(), any()}; });
        break;
      }
    }
    return set;
  }

  Random random_;
};

}  // namespace sunder::tests
