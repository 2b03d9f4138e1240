// Sets of simple polygons with holes for differential tests: small and nasty, from a seed.
#pragma once

#include <tests/support/gathered_polygons.h>
#include <tests/support/nasty_polygons.h>
#include <tests/support/shapes.h>

#include <sunder/base/random.h>
#include <sunder/planar/object/polygon.h>
#include <sunder/planar/polygons/polygon_simple.h>
#include <sunder/planar/polygons/polygon_valid.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

namespace sunder::tests {

enum class PolygonFamily : int {
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
inline constexpr int polygon_family_count = 12;
inline std::string name_of(PolygonFamily family) {
  constexpr std::array<const char*, polygon_family_count> names{
      "simple", "tessellation", "nested", "twins",   "sliver",      "touching itself",
      "valid",  "annuli",       "pie",    "islands", "many inside", "any scale"};
  return names[static_cast<std::size_t>(family)];
}

class PolygonSets {
 public:
  using Ring = std::vector<Point2>;
  using Rings = std::vector<Ring>;

  explicit PolygonSets(std::uint64_t seed) : random_(seed), nasty_(seed + 1), gathered_(seed + 2) {}

  std::vector<Rings> next(PolygonFamily family) {
    switch (family) {
      case PolygonFamily::simple: return simple_ones(2 + random_.below(4), 9, 5);
      case PolygonFamily::tessellation: return tessellation();
      case PolygonFamily::nested: return nested();
      case PolygonFamily::twins: return twins();
      case PolygonFamily::sliver: return slivers();
      case PolygonFamily::touching_itself: return touching_itself();
      case PolygonFamily::valid: return valid_ones();
      case PolygonFamily::annuli: return gathered_.annuli();
      case PolygonFamily::pie: return gathered_.pie();
      case PolygonFamily::islands: return gathered_.islands();
      case PolygonFamily::many_inside: return gathered_.many_inside();
      case PolygonFamily::any_scale:
        return scaled(next(static_cast<PolygonFamily>(random_.below(polygon_family_count - 1))));
    }
    return {};
  }

  Random& random() { return random_; }

 private:
  double at(std::uint64_t below) { return static_cast<double>(random_.below(below)); }
  bool one_in(std::uint64_t n) { return random_.below(n) == 0; }

  static bool is_simple(const Rings& rings) {
    const auto closed = [](const Ring& ring) { return ring.front() == ring.back(); };
    return std::none_of(rings.begin(), rings.end(), closed) &&
           !planar::polygon_simple_by_scan(planar::Polygon(rings)).meet();
  }

  static Ring moved(Ring ring, double x, double y) {
    for (Point2& p : ring) p = {p.x + x, p.y + y};
    return ring;
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
        shuffle(ring, random_);
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
    std::vector<Rings> set{{turned(box_ring(0, 0, 20, 20)), turned(box_ring(2, 2, 10, 10))}};
    if (one_in(2)) set[0].push_back(turned(box_ring(12, 12, 18, 18)));
    if (one_in(3)) set[0].push_back(turned(box_ring(4, 4, 8, 8)));  // an island
    const std::uint64_t count = 1 + random_.below(3);
    for (std::uint64_t k = 0; k < count; ++k) {
      switch (random_.below(6)) {
        case 0: set.push_back({turned(box_ring(2, 2, 10, 10))}); break;                         // fills the hole
        case 1: set.push_back({turned(box_ring(2 + at(3), 2 + at(3), 10, 9 + at(3)))}); break;  // nearly so
        case 2: set.push_back({moved(simple_ring(5), 1 + at(8), 1 + at(8))}); break;
        case 3: set.push_back({turned({{at(3), 6}, {6, at(3)}, {10, 6}, {6, 10}})}); break;
        case 4:
          set.push_back({turned(box_ring(-2, -2, 22 + at(2), 22)), turned(box_ring(0, 0, 20 + at(2), 20))});
          break;
        default: set.push_back({turned(box_ring(12, 12, 18, 18)), turned(box_ring(14, 14, 15 + at(3), 16))});
      }
    }
    return set;
  }

  // Polygons of some of the same rings.
  std::vector<Rings> twins() {
    Rings pool{box_ring(0, 0, 3, 3),
               box_ring(4, 0, 7, 3),
               {{0, 4}, {3, 4}, {0, 7}},
               {{8, 0}, {11, 0}, {8, 3}},
               box_ring(4, 4, 7, 7)};
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
      case 0:
        set.push_back({turned(box_ring(0, 0, 8, 8)), turned({{0, 0}, {4, 2}, {2, 4}})});
        break;  // a hole at a corner
      case 1: set.push_back({turned(box_ring(0, 0, 8, 8)), turned({{4, 0}, {6, 4}, {2, 4}})}); break;  // on a side
      case 2: set.push_back({turned(box_ring(0, 0, 4, 4)), turned(box_ring(4, 4, 8, 8))}); break;      // in a corner
      default:  // one ring that comes back to a vertex
        set.push_back({turned({{0, 0}, {8, 0}, {8, 8}, {4, 8}, {6, 4}, {2, 4}, {4, 8}, {0, 8}})});
    }
    const std::uint64_t count = 1 + random_.below(3);
    for (std::uint64_t k = 0; k < count; ++k) {
      switch (random_.below(6)) {
        case 0: set.push_back({turned({{0, 0}, {4, 2}, {2, 4 - at(2)}})}); break;
        case 4: set.push_back({turned(box_ring(-1, -3, 9, 0))}); break;
        case 1: set.push_back({turned({{4, 0}, {6, 4}, {2 + at(2), 4}})}); break;
        case 2: set.push_back({turned({{4, 8}, {6, 4}, {2, 4 + at(2)}})}); break;
        case 3: set.push_back({turned(box_ring(4, 0, 8, 4))}); break;
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
      if (!planar::polygon_defects(parts, options).found.empty()) continue;
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

inline std::vector<planar::Polygon> polygons_of(const std::vector<PolygonSets::Rings>& set) {
  std::vector<planar::Polygon> polygons;
  for (const PolygonSets::Rings& rings : set) polygons.emplace_back(rings);
  return polygons;
}

}  // namespace sunder::tests
