#include <tests/support/nasty_polygons.h>
#include <tests/support/shapes.h>

#include <algorithm>
#include <array>

namespace sunder::tests {

std::string_view name_of(NastyFamily family) {
  constexpr std::array<std::string_view, nasty_family_count> names{"few places", "holes", "lattice", "cells", "parts"};
  return names[static_cast<std::size_t>(family)];
}

std::vector<NastyPolygons::Rings> NastyPolygons::next(NastyFamily family) {
  const auto of_family = [&] {
    switch (family) {
      case NastyFamily::few_places: return few_places();
      case NastyFamily::holes: return box_with_holes();
      case NastyFamily::lattice: return lattice();
      case NastyFamily::cells: return cells();
      default: return nested_parts();
    }
  };
  std::vector<Rings> parts = of_family();
  if (one_in(5)) change(parts);
  for (Rings& rings : parts) {
    for (Ring& ring : rings) dress(ring);
  }
  return parts;
}

NastyPolygons::Ring NastyPolygons::any_ring(std::uint64_t side) {
  Ring ring(3 + random_.below(4));
  for (Point2& p : ring) p = {at(side), at(side)};
  return ring;
}

// A triangle or a box, mostly within 0 to 8.
NastyPolygons::Ring NastyPolygons::small_ring() {
  const double x = at(8), y = at(8);
  if (one_in(2)) return box_ring(x, y, x + 1 + at(3), y + 1 + at(3));
  return {{x, y}, {x + 1 + at(3), y + at(3)}, {x + at(3), y + 1 + at(3)}};
}

std::vector<NastyPolygons::Rings> NastyPolygons::few_places() {
  std::vector<Rings> parts(one_in(4) ? 2 : 1);
  const std::uint64_t side = 3 + random_.below(3);
  for (Rings& rings : parts) {
    rings.push_back(any_ring(side));
    if (one_in(3)) rings.push_back(any_ring(side));
  }
  return parts;
}

std::vector<NastyPolygons::Rings> NastyPolygons::box_with_holes() {
  Rings rings{box_ring(0, 0, 8 + at(3), 8 + at(3))};
  if (one_in(3)) rings[0].insert(rings[0].begin() + 1, {at(8), at(3)});
  if (one_in(3)) rings.push_back(box_ring(0, 0, 5 + at(3), 5 + at(3)));
  if (one_in(2)) rings.back() = box_ring(1, 1, 6 + at(2), 7);
  for (std::uint64_t k = 1 + random_.below(4); k > 0; --k) rings.push_back(small_ring());
  return {rings};
}

// Triangles of a square lattice, of which no two share a side: they touch in corners, also those of the box.
std::vector<NastyPolygons::Rings> NastyPolygons::lattice() {
  const std::uint64_t side = 2 + random_.below(3);
  const double size = 2 * static_cast<double>(side);
  Rings rings{box_ring(one_in(2) ? 0 : -2, 0, size, one_in(2) ? size : size + 2)};
  const std::uint64_t rate = 2 + random_.below(4);
  for (std::uint64_t i = 0; i < side; ++i) {
    for (std::uint64_t j = 0; j < side; ++j) {
      if (!one_in(rate)) continue;
      const double x = 2 * static_cast<double>(i), y = 2 * static_cast<double>(j);
      const Ring cell = box_ring(x, y, x + 2, y + 2);
      const std::uint64_t from = random_.below(4);
      Ring triangle{cell[from], cell[(from + 1) % 4], {x + 1, y + 1}};
      if (one_in(2)) triangle = {cell[from], cell[(from + 2) % 4], {x + 1, y + (from % 2 == 0 ? 2.0 : 0.0)}};
      rings.push_back(triangle);
    }
  }
  return {rings};
}

// The outlines of a set of cells. Where two cells touch in a corner only, the outline may go on either way without
// crossing itself. Outlines that run counter-clockwise are shells; others are holes of any shell, mostly of the last.
std::vector<NastyPolygons::Rings> NastyPolygons::cells() {
  constexpr int side = 5;
  std::array<std::array<bool, side + 2>, side + 2> filled{};
  const std::uint64_t rate = 2 + random_.below(5);
  for (std::size_t i = 1; i <= side; ++i) {
    for (std::size_t j = 1; j <= side; ++j) filled[i][j] = !one_in(rate);
  }
  const auto is_filled = [&](int i, int j) { return filled[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)]; };
  // Unit edges with the filled cell to the left; direction d: right, up, left, down.
  constexpr std::array<int, 4> dx{1, 0, -1, 0}, dy{0, 1, 0, -1};
  const auto is_edge = [&](int x, int y, int d) {  // from the corner (x, y), the low one of the cell (x, y)
    constexpr std::array<int, 4> lx{0, -1, -1, 0}, ly{0, 0, -1, -1}, rx{0, 0, -1, -1}, ry{-1, 0, 0, -1};
    const auto k = static_cast<std::size_t>(d);
    const auto inside = [](int c) { return c >= 0 && c < side + 2; };
    const int a = x + lx[k], b = y + ly[k], e = x + rx[k], f = y + ry[k];
    if (!inside(a) || !inside(b) || !inside(e) || !inside(f)) return false;
    return is_filled(a, b) && !is_filled(e, f);
  };
  std::array<std::array<std::array<bool, 4>, side + 3>, side + 3> used{};
  const auto is_used = [&](int x, int y, int d) -> bool& {
    return used[static_cast<std::size_t>(x)][static_cast<std::size_t>(y)][static_cast<std::size_t>(d)];
  };
  std::vector<Rings> parts;
  Rings holes;
  // At a corner with two edges out, which of the turns the outline takes: the same for both passes.
  std::array<std::array<bool, side + 3>, side + 3> turns_left{};
  for (auto& row : turns_left) {
    for (bool& turn : row) turn = one_in(2);
  }
  for (int x = 0; x < side + 2; ++x) {
    for (int y = 0; y < side + 2; ++y) {
      for (int d = 0; d < 4; ++d) {
        if (!is_edge(x, y, d) || is_used(x, y, d)) continue;
        Ring ring;
        double area = 0;
        for (int u = x, v = y, e = d; !is_used(u, v, e);) {
          is_used(u, v, e) = true;
          ring.push_back({static_cast<double>(u), static_cast<double>(v)});
          area += u * (v + dy[static_cast<std::size_t>(e)]) - v * (u + dx[static_cast<std::size_t>(e)]);
          u += dx[static_cast<std::size_t>(e)];
          v += dy[static_cast<std::size_t>(e)];
          const int left = (e + 1) % 4, right = (e + 3) % 4;
          const bool both = is_edge(u, v, left) && is_edge(u, v, right);
          if (both) {
            e = turns_left[static_cast<std::size_t>(u)][static_cast<std::size_t>(v)] ? left : right;
          } else {
            e = is_edge(u, v, e) ? e : is_edge(u, v, left) ? left : right;
          }
        }
        if (area > 0) {
          parts.push_back({ring});
        } else {
          holes.push_back(ring);
        }
      }
    }
  }
  if (parts.empty()) parts.push_back({box_ring(0, 0, 2, 2)});
  for (const Ring& hole : holes) {
    parts[one_in(6) ? random_.below(parts.size()) : parts.size() - 1].push_back(hole);
  }
  if (parts.size() > 1 && one_in(3)) parts.resize(1);
  return parts;
}

std::vector<NastyPolygons::Rings> NastyPolygons::nested_parts() {
  std::vector<Rings> parts;
  const std::uint64_t count = 2 + random_.below(3);
  for (std::uint64_t k = 0; k < count; ++k) {
    const double d = 1 + at(6), x = one_in(2) ? 0 : 2 * at(4) - 3, y = one_in(2) ? 0 : 2 * at(4) - 3;
    Rings rings{box_ring(x - d, y - d, x + d, y + d)};
    if (one_in(3)) rings[0] = {{x - d, y}, {x, y - d}, {x + d, y}, {x, y + d}};
    const double e = at(static_cast<std::uint64_t>(d));
    if (e > 0 && !one_in(3)) rings.push_back(box_ring(x - e, y - e, x + e, y + e));
    if (rings.size() > 1 && one_in(3)) rings[1] = {{x - e, y}, {x, y - e}, {x + e, y}, {x, y + e}};
    parts.push_back(rings);
  }
  return parts;
}

void NastyPolygons::change(std::vector<Rings>& parts) {
  Rings& rings = parts[random_.below(parts.size())];
  Ring& ring = rings[random_.below(rings.size())];
  const std::size_t k = random_.below(ring.size());
  switch (random_.below(6)) {
    case 0: ring[k] = {ring[k].x + at(3) - 1, ring[k].y + at(3) - 1}; break;
    case 1: {  // a spike
      const Point2 p = ring[k];
      ring.insert(ring.begin() + static_cast<std::ptrdiff_t>(k), {p, {p.x + at(5) - 2, p.y + at(5) - 2}});
      break;
    }
    case 2: std::swap(ring[k], ring[random_.below(ring.size())]); break;
    case 3: rings.push_back(ring); break;
    case 4: std::swap(rings.front(), rings.back()); break;
    default: ring.resize(std::max<std::size_t>(2, ring.size() - 2)); break;
  }
}

void NastyPolygons::dress(Ring& ring) {
  std::rotate(ring.begin(), ring.begin() + static_cast<std::ptrdiff_t>(random_.below(ring.size())), ring.end());
  if (one_in(2)) std::reverse(ring.begin(), ring.end());
  while (one_in(4)) {
    const std::size_t k = random_.below(ring.size());
    const Point2 p = ring[k];
    ring.insert(ring.begin() + static_cast<std::ptrdiff_t>(k), p);
  }
  if (one_in(2)) ring.push_back(Point2{ring.front()});
}

}  // namespace sunder::tests
