#include <bench/inputs/region_count.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <stdexcept>

namespace bench {
namespace {

__extension__ using Wide = __int128;

std::int64_t whole(double v, int bits) {
  const double scaled = std::ldexp(v, bits);
  if (!(std::fabs(scaled) <= std::ldexp(2.0, bits)) || scaled != std::nearbyint(scaled)) {
    throw std::logic_error("a number is not on the grid");
  }
  return static_cast<std::int64_t>(scaled);
}

Wide turn(const WholeInequality& i, const WholeInequality& j) { return Wide{i.a} * j.b - Wide{i.b} * j.a; }

// The turn of the polar points (a, b) / c.
Wide turn(const WholeInequality& i, const WholeInequality& j, const WholeInequality& k) {
  return k.c * turn(i, j) + i.c * turn(j, k) + j.c * turn(k, i);
}

bool points_down(const WholeInequality& i) { return i.b < 0 || (i.b == 0 && i.a < 0); }

// Of one direction: is i a proper part of j?
bool tighter(const WholeInequality& i, const WholeInequality& j) {
  const Wide of_i = i.a != 0 ? std::abs(i.a) : std::abs(i.b), of_j = i.a != 0 ? std::abs(j.a) : std::abs(j.b);
  return i.c * of_j < j.c * of_i;
}

using Real = long double;

struct Wheel {  // a disc
  Real x, y, radius;
};

}  // namespace

std::vector<WholeInequality> whole(std::span<const Inequality> half_planes) {
  std::vector<WholeInequality> made;
  for (const Inequality& h : half_planes) made.push_back({whole(h.a, 40), whole(h.b, 40), whole(h.c, 40)});
  return made;
}

std::vector<WholeInequality> whole(std::span<const Ring> rings) {
  std::vector<WholeInequality> made;
  for (const Ring& ring : rings) {
    for (std::size_t v = 0; v < ring.size(); ++v) {
      const Xy &p = ring[v], &q = ring[v + 1 == ring.size() ? 0 : v + 1];
      const std::int64_t px = whole(p.x, 26), py = whole(p.y, 26), qx = whole(q.x, 26), qy = whole(q.y, 26);
      made.push_back({qy - py, px - qx, px * qy - py * qx});
    }
  }
  return made;
}

std::vector<std::uint32_t> essential_sides(std::span<const WholeInequality> given) {
  std::vector<std::uint32_t> order(given.size());
  std::iota(order.begin(), order.end(), 0u);
  std::sort(order.begin(), order.end(), [&](std::uint32_t i, std::uint32_t j) {
    const WholeInequality &p = given[i], &q = given[j];
    if (points_down(p) != points_down(q)) return points_down(q);
    if (const Wide t = turn(p, q); t != 0) return t > 0;
    if (tighter(p, q)) return true;
    return !tighter(q, p) && i < j;
  });
  const auto same = [&](std::uint32_t i, std::uint32_t j) {
    return points_down(given[i]) == points_down(given[j]) && turn(given[i], given[j]) == 0;
  };
  order.erase(std::unique(order.begin(), order.end(), same), order.end());
  // The corners of the convex hull of the polar points, from the one furthest to the right on.
  const auto first = std::max_element(order.begin(), order.end(), [&](std::uint32_t i, std::uint32_t j) {
    const WholeInequality &p = given[i], &q = given[j];
    const Wide of_p = Wide{p.a} * q.c, of_q = Wide{q.a} * p.c;
    return of_p != of_q ? of_p < of_q : Wide{p.b} * q.c < Wide{q.b} * p.c;
  });
  std::rotate(order.begin(), first, order.end());
  order.push_back(order.front());
  std::vector<std::uint32_t> hull;
  for (const std::uint32_t k : order) {
    while (hull.size() > 1 && turn(given[hull[hull.size() - 2]], given[hull.back()], given[k]) <= 0) hull.pop_back();
    hull.push_back(k);
  }
  for (std::size_t k = 0; k + 1 < hull.size(); ++k) {
    if (turn(given[hull[k]], given[hull[k + 1]]) <= 0) throw std::logic_error("the common part is not bounded");
  }
  hull.pop_back();
  return hull;
}

std::uint64_t count_arcs(std::span<const Disc> discs) {
  constexpr Real pi = 3.14159265358979323846L, tiny = 1e-11L;
  if (discs.empty()) throw std::logic_error("there are no discs");
  std::vector<Wheel> wheels;
  for (const Disc& d : discs) {
    wheels.push_back({static_cast<Real>(d.center.x), static_cast<Real>(d.center.y), static_cast<Real>(d.radius)});
  }
  // Where the ray from the origin, to the right, leaves the first of them.
  std::size_t at = 0;
  Real nearest = std::numeric_limits<Real>::infinity();
  for (std::size_t i = 0; i < discs.size(); ++i) {
    const Real x = wheels[i].x, y = wheels[i].y, r = wheels[i].radius;
    const Real leaves = x + std::sqrt(r * r - y * y);
    if (!(leaves >= 0)) throw std::logic_error("a disc does not hold the origin");
    if (leaves < nearest) at = i;
    nearest = std::min(nearest, leaves);
  }
  Real x = nearest, y = 0, seen = 0;  // where we are; how far round, seen from the origin
  for (std::uint64_t arcs = 0; arcs <= 2 * discs.size(); ++arcs) {
    // Disc j holds of this circle the angles up to half a width from the direction of its centre. Which ends first?
    const Wheel& disc = wheels[at];
    const Real here = std::atan2(y - disc.y, x - disc.x);
    Real first = std::numeric_limits<Real>::infinity(), second = first;
    std::size_t next = at;
    for (std::size_t j = 0; j < discs.size(); ++j) {
      const Real dx = wheels[j].x - disc.x, dy = wheels[j].y - disc.y;
      const Real distance = std::hypot(dx, dy), r = disc.radius, s = wheels[j].radius;
      if (j == at || distance + r <= s) continue;
      const Real half = std::acos((distance * distance + r * r - s * s) / (2 * distance * r));
      Real ahead = std::fmod(std::atan2(dy, dx) + half - here, 2 * pi);
      if (ahead < 0) ahead += 2 * pi;
      if (2 * pi - ahead < tiny) ahead = 0;  // the circle that we come from
      if (ahead == 0) continue;
      if (ahead < first) {
        second = first;
        first = ahead;
        next = j;
      } else {
        second = std::min(second, ahead);
      }
    }
    if (next == at) return 1;
    if (first < tiny || second - first < tiny) throw std::logic_error("an arc is too short to be sure of");
    const Real then_x = disc.x + disc.radius * std::cos(here + first);
    const Real then_y = disc.y + disc.radius * std::sin(here + first);
    seen += std::atan2(x * then_y - y * then_x, x * then_x + y * then_y);
    x = then_x;
    y = then_y;
    at = next;
    if (seen > 2 * pi) return arcs;  // the first one was counted when it was left, and is now left again
  }
  throw std::logic_error("the walk around the common part does not end");
}

}  // namespace bench
