#include <sunder/planar/object/polygon.h>
#include <sunder/planar/polygons/polygon_simple.h>
#include <tests/support/gathered_polygons.h>
#include <tests/support/shapes.h>

#include <algorithm>
#include <array>

namespace sunder::tests {

GatheredPolygons::Ring GatheredPolygons::turned(Ring ring) {
  std::rotate(ring.begin(), ring.begin() + static_cast<std::ptrdiff_t>(random_.below(ring.size())), ring.end());
  if (one_in(2)) std::reverse(ring.begin(), ring.end());
  return ring;
}

std::vector<GatheredPolygons::Rings> GatheredPolygons::annuli() {
  std::vector<Rings> set;
  const std::uint64_t count = 3 + random_.below(4);
  for (std::uint64_t k = 1; k <= count; ++k) {
    const double outer = 4 * static_cast<double>(k), x = one_in(12) ? 1 : 0;
    const double inner = std::max(1.0, outer - (one_in(12) ? 4 + at(2) : 2));
    set.push_back({turned(box_ring(x - outer, -outer, x + outer, outer))});
    if (!one_in(16)) set.back().push_back(turned(box_ring(x - inner, -inner, x + inner, inner)));
  }
  return set;
}

std::vector<GatheredPolygons::Rings> GatheredPolygons::pie() {
  constexpr std::array<Point2, 12> rim{
      {{8, 0}, {8, 4}, {6, 6}, {0, 8}, {-4, 8}, {-6, 6}, {-8, 0}, {-8, -4}, {-6, -6}, {0, -8}, {4, -8}, {6, -6}}};
  std::vector<Rings> set;
  const auto add = [&](std::size_t from, std::size_t to) {
    const double size = one_in(2) ? 1 : 0.5;
    const auto on = [&](std::size_t k) { return Point2{size * rim[k % 12].x, size * rim[k % 12].y}; };
    set.push_back({turned({{0, 0}, on(from), on(to)})});
  };
  for (std::size_t k = 0; k < rim.size(); k += 1 + random_.below(2)) {
    if (!one_in(3)) add(k, k + 1);
  }
  const std::uint64_t more = random_.below(3);
  for (std::uint64_t k = 0; k < more; ++k) {
    switch (random_.below(7)) {
      case 0: {
        const std::size_t from = random_.below(12);
        add(from, from + 1 + random_.below(11));
        break;
      }
      case 1: set.push_back({turned(box_ring(-8, -8, 0, -8 + 8 * at(2)))}); break;
      case 2: set.push_back({turned({{-8, -4}, {8, 4}, {8, 9}})}); break;  // the point is on its side
      case 3: set.push_back({turned({{0, 0}, {9, 1}, {9, 3}}), turned({{5, 1}, {6, 1}, {6, 1.25}})}); break;
      case 4: set.push_back({turned(box_ring(-1, -1, 1, 1))}); break;
      case 5: set.push_back({turned(box_ring(-9, -9, 9, 9)), turned({{0, 0}, {8, 1}, {8, 2}})}); break;
      default: set.push_back({turned(box_ring(-12, -12, 12, 12)), turned(box_ring(-9, -9, 9, 9))});
    }
  }
  std::erase_if(set, [](const Rings& rings) { return planar::polygon_simple_by_scan(planar::Polygon(rings)).meet(); });
  return set;
}

std::vector<GatheredPolygons::Rings> GatheredPolygons::islands() {
  std::vector<Rings> set{{turned(box_ring(0, 0, 42, 20))}};
  for (const double x : {2.0, 12.0, 22.0, 32.0}) {
    if (one_in(5)) continue;
    set[0].push_back(turned(box_ring(x, 2, x + 8, 10)));
    if (one_in(5)) continue;
    const double slack = one_in(5) ? 0 : 1, shift = one_in(9) ? 1 + at(3) : 0;
    set.push_back({turned(box_ring(x + slack, 3 - shift, x + 8 - slack, 9))});
    if (one_in(2)) set.back().push_back(turned(box_ring(x + 3, 4, x + 5, 8)));
    if (one_in(2)) set.push_back({turned(box_ring(x + 3.5, 5, x + (one_in(4) ? 5 : 4.5), 6))});
    if (one_in(4)) set[0].push_back(turned(box_ring(x + 3.75, 5.25, x + 4.25, 5.75)));  // an island of the plate
  }
  if (one_in(3)) set.push_back({turned(box_ring(1, 12, 41 + at(2), 18))});
  return set;
}

std::vector<GatheredPolygons::Rings> GatheredPolygons::many_inside() {
  Ring star;
  const double arms = 3 + at(4);
  for (double k = 0; k < arms; ++k) {
    star.push_back({10 * k, 20 + at(3)});
    star.push_back({10 * k + 5, 2 + at(3)});
  }
  star.push_back({10 * arms, 20});
  star.push_back({10 * arms, 0});
  star.push_back({0, 0});
  std::vector<Rings> set{{turned(star)}};
  const std::uint64_t count = 3 + random_.below(6);
  const bool above = one_in(3);
  for (std::uint64_t k = 0; k < count; ++k) {
    const double x = (above ? 2 : 1) * at(static_cast<std::uint64_t>(5 * arms));
    const double y = above ? 22 + 2 * at(3) : one_in(2) ? at(2) : at(18);
    set.push_back({turned({{x, y}, {x + 1, y}, {x, y + 1}})});
    if (!above && one_in(4)) set.push_back({turned({{x, y}, {x + 1, y}, {x + 1, y + 1}})});
  }
  if (one_in(3)) set.push_back({turned(box_ring(-1, -1, 80, 30)), turned(box_ring((at(2) - 1) / 2, -0.5, 75, 29))});
  return set;
}

}  // namespace sunder::tests
