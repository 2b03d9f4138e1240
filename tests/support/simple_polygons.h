// Polygons of one ring for tests of kernels: simple but nasty, from a seed.
#pragma once

#include <sunder/base/random.h>
#include <sunder/planar/object/polygon.h>
#include <sunder/planar/polygons/polygon_simple.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

namespace sunder::tests {

enum class SimplePolygonFamily : std::uint8_t {
  grid,     // vertices on a small grid, in any order that is simple
  star,     // around a point of a small grid, by angle
  needles,  // long spikes around a small circle, of doubles
  pinched,  // edges on two lines through a point and others: kernels that are flat
  spiral,   // turning one way several times, and back
  convex,   // and its like with dents
};
inline constexpr std::size_t simple_polygon_family_count = 6;

inline std::string_view name_of(SimplePolygonFamily family) {
  constexpr std::array<std::string_view, simple_polygon_family_count> names{"grid",    "star",   "needles",
                                                                            "pinched", "spiral", "convex"};
  return names[static_cast<std::size_t>(family)];
}

class SimplePolygons {
 public:
  explicit SimplePolygons(std::uint64_t seed) : random_(seed) {}

  SimplePolygonFamily family() const { return family_; }  // of the one that was made last
  Random& random() { return random_; }

  // Simple; turned either way, beginning anywhere.
  planar::Polygon next() {
    family_ = static_cast<SimplePolygonFamily>(turn_++ % simple_polygon_family_count);
    for (;;) {
      const planar::Polygon polygon = candidate();
      if (!planar::polygon_simple_by_scan(polygon).meet()) return polygon;
    }
  }

  // As above, simple or not.
  planar::Polygon candidate() {
    std::vector<Point2> ring = ring_of_family();
    if (random_.below(2) == 0) std::reverse(ring.begin(), ring.end());
    std::rotate(ring.begin(), ring.begin() + static_cast<std::ptrdiff_t>(random_.below(ring.size())), ring.end());
    if (ring.size() < 3 || ring.front() == ring.back()) ring = {{0, 0}, {1, 0}, {0, 1}};
    return planar::Polygon(std::vector<std::vector<Point2>>{ring});
  }

 private:
  double whole(std::int64_t most) { return static_cast<double>(random_.between(-most, most)); }

  static void sort_around(std::vector<Point2>& ring) {
    std::sort(ring.begin(), ring.end(), [](const Point2& p, const Point2& q) {
      const double t = std::atan2(p.y, p.x), u = std::atan2(q.y, q.x);
      return t < u || (t == u && p.x * p.x + p.y * p.y < q.x * q.x + q.y * q.y);
    });
  }

  static void add_new(std::vector<Point2>& ring, const Point2& p) {
    if (std::find(ring.begin(), ring.end(), p) == ring.end()) ring.push_back(p);
  }

  // Turns round what is between two edges that cross, for as long as that may help.
  static void untangle(std::vector<Point2>& ring) {
    for (int n = 0; n < 40 && ring.size() >= 3; ++n) {
      const planar::PolygonSimpleAnswer answer =
          planar::polygon_simple_by_scan(planar::Polygon(std::vector<std::vector<Point2>>{ring}));
      if (!answer.meet()) return;
      std::reverse(ring.begin() + answer.found->i + 1, ring.begin() + answer.found->j + 1);
    }
  }

  std::vector<Point2> ring_of_family() {
    std::vector<Point2> ring;
    switch (family_) {
      case SimplePolygonFamily::grid:
        for (std::size_t n = 5 + random_.below(9); n > 0; --n) add_new(ring, {whole(3), whole(3)});
        untangle(ring);
        break;
      case SimplePolygonFamily::star:
        for (std::size_t n = 3 + random_.below(14); n > 0; --n) add_new(ring, {whole(4), whole(4)});
        sort_around(ring);
        break;
      case SimplePolygonFamily::needles: {
        const std::size_t n = 2 * (3 + random_.below(10));
        for (std::size_t k = 0; k < n; ++k) {
          const double t =
              6.283185307179586 * (static_cast<double>(k) + random_.uniform(-0.4, 0.4)) / static_cast<double>(n);
          const double r = k % 2 == 0 ? random_.uniform(0.5, 1.5) : random_.uniform(1, 9);
          ring.push_back({r * std::cos(t), r * std::sin(t)});
        }
        break;
      }
      case SimplePolygonFamily::pinched: {
        // Spokes on a few lines through the origin: edges that lie on them leave little of a kernel.
        const std::array<Point2, 4> ways{{{1, 0}, {0, 1}, {1, 1}, {2, -1}}};
        for (std::size_t n = 2 + random_.below(4); n > 0; --n) {
          const Point2 way = ways[random_.below(4)];
          const double t = whole(3), s = whole(3);
          add_new(ring, {t * way.x, t * way.y});
          add_new(ring, {s * way.x, s * way.y});
        }
        if (random_.below(2) == 0) sort_around(ring);
        untangle(ring);
        break;
      }
      case SimplePolygonFamily::spiral: {
        const std::size_t n = 4 + random_.below(20);
        std::vector<Point2> inner;
        const double wide = random_.uniform(0.1, 0.5), turns = random_.uniform(0.3, 3);
        for (std::size_t k = 0; k < n; ++k) {
          const double part = static_cast<double>(k) / static_cast<double>(n), t = 6.283185307179586 * turns * part;
          const double r = 1 + turns * part;
          ring.push_back({r * std::cos(t), r * std::sin(t)});
          inner.push_back({(r - wide) * std::cos(t), (r - wide) * std::sin(t)});
        }
        ring.insert(ring.end(), inner.rbegin(), inner.rend());
        break;
      }
      case SimplePolygonFamily::convex: {
        const std::size_t n = 3 + random_.below(12);
        for (std::size_t k = 0; k < n; ++k) {
          const double t = 6.283185307179586 * static_cast<double>(k) / static_cast<double>(n);
          const double r = random_.below(6) == 0 ? 0.9 : 1;
          ring.push_back({r * std::cos(t), r * std::sin(t)});
          if (random_.below(4) == 0) ring.push_back(ring.back());
        }
        for (std::size_t k = 0; k + 1 < ring.size(); ++k) {  // halfway: collinear, or nearly
          if (ring[k] == ring[k + 1])
            ring[k] = {(ring[k].x + ring[k == 0 ? ring.size() - 1 : k - 1].x) / 2,
                       (ring[k].y + ring[k == 0 ? ring.size() - 1 : k - 1].y) / 2};
        }
        break;
      }
    }
    return ring;
  }

  Random random_;
  std::size_t turn_ = 0;
  SimplePolygonFamily family_ = SimplePolygonFamily::grid;
};

}  // namespace sunder::tests
