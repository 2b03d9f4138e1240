#include <sunder/solid/pair/closest_simplex.h>

#include <cmath>
#include <limits>

namespace sunder::solid {

namespace {

Point3 minus(const Point3& a, const Point3& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
Point3 negated(const Point3& a) { return {-a.x, -a.y, -a.z}; }
double dot(const Point3& a, const Point3& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
Point3 cross(const Point3& a, const Point3& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
double determinant(const Point3& a, const Point3& b, const Point3& c) { return dot(cross(a, b), c); }

// What is nearest within one part of the simplex: which corners span it, in increasing order, and how near.
struct Nearest {
  std::array<int, 3> corner;
  int count;
  Point3 towards;
  double distance2;
};

const Point3& corner(const DifferenceSimplex& s, int i) { return s.vertex[static_cast<std::size_t>(i)].at; }

Nearest at_corner(const DifferenceSimplex& s, int i) {
  const Point3& p = corner(s, i);
  return {{i, 0, 0}, 1, negated(p), dot(p, p)};
}

// Of the segment from the newest corner to an older one.
Nearest of_segment(const DifferenceSimplex& s, int newest, int older) {
  const Point3& a = corner(s, newest);
  const Point3 e = minus(corner(s, older), a);
  const double t = -dot(a, e);
  if (!(t > 0)) return at_corner(s, newest);
  const double length2 = dot(e, e);
  if (t >= length2) return at_corner(s, older);
  const double part = t / length2;
  Point3 d{-(a.x + part * e.x), -(a.y + part * e.y), -(a.z + part * e.z)};
  const double distance2 = dot(d, d);
  // Made perpendicular to the edge once more: near contact, d is small and carries the error of large numbers.
  const double off = dot(d, e) / length2;
  d = {d.x - off * e.x, d.y - off * e.y, d.z - off * e.z};
  return {{older, newest, 0}, 2, d, distance2};
}

// Of the triangle of the newest corner a and two older ones, b before c, with n = (b - a) x (c - a). What is nearest
// has a among its corners, because the search went from the edge b c towards the origin.
Nearest of_triangle(const DifferenceSimplex& s, int newest, int b, int c, const Point3& n) {
  const Point3& a = corner(s, newest);
  const Point3 ab = minus(corner(s, b), a), ac = minus(corner(s, c), a);
  const bool beyond_ab = dot(cross(ab, n), a) < 0;
  const bool beyond_ac = dot(cross(n, ac), a) < 0;
  if (beyond_ab) {
    const Nearest on_ab = of_segment(s, newest, b);
    if (!beyond_ac || on_ab.count == 2) return on_ab;
  }
  if (beyond_ac) return of_segment(s, newest, c);
  const double height = dot(n, a);
  const double area2 = dot(n, n);
  const double sense = -std::copysign(1.0, height);
  return {{b, c, newest}, 3, {sense * n.x, sense * n.y, sense * n.z}, area2 > 0 ? height * height / area2 : 0};
}

}  // namespace

bool reduce_to_closest_face(DifferenceSimplex& s, Point3& towards, double& distance2) {
  Nearest nearest;
  switch (s.count) {
    case 1: nearest = at_corner(s, 0); break;
    case 2: nearest = of_segment(s, 1, 0); break;
    case 3: {
      const Point3& a = corner(s, 2);
      nearest = of_triangle(s, 2, 0, 1, cross(minus(corner(s, 0), a), minus(corner(s, 1), a)));
      break;
    }
    default: {
      // The three faces of the newest corner a: the origin beyond one makes it a candidate. The face b, c, d is not
      // one: the search went from it towards the origin.
      const Point3& a = corner(s, 3);
      const Point3 ab = minus(corner(s, 0), a), ac = minus(corner(s, 1), a), ad = minus(corner(s, 2), a);
      const Point3 bc = cross(ab, ac), cd = cross(ac, ad), bd = cross(ab, ad);
      const double volume = dot(bc, ad);
      nearest.count = 0;
      nearest.distance2 = std::numeric_limits<double>::infinity();
      const auto consider = [&](int i, int j, const Point3& n, double side) {
        // The fourth corner is on the side of n where `side` is positive.
        if (side * dot(n, a) < 0 && side != 0) return;
        const Nearest found = of_triangle(s, 3, i, j, n);
        if (found.distance2 < nearest.distance2) nearest = found;
      };
      consider(0, 1, bc, volume);
      consider(1, 2, cd, volume);
      consider(0, 2, bd, -volume);
      if (nearest.count == 0) return false;
    }
  }
  for (std::size_t i = 0; i < static_cast<std::size_t>(nearest.count); ++i) {
    const std::size_t from = static_cast<std::size_t>(nearest.corner[i]);
    if (from != i) s.vertex[i] = s.vertex[from];
  }
  s.count = nearest.count;
  towards = nearest.towards;
  distance2 = nearest.distance2;
  return true;
}

std::array<double, 4> weights_of_origin(const DifferenceSimplex& t) {
  const Point3 &a = t.vertex[0].at, &b = t.vertex[1].at, &c = t.vertex[2].at, &d = t.vertex[3].at;
  const double wa = determinant(b, c, d), wb = -determinant(a, c, d), wc = determinant(a, b, d),
               wd = -determinant(a, b, c);
  return wa + wb + wc + wd < 0 ? std::array{-wa, -wb, -wc, -wd} : std::array{wa, wb, wc, wd};
}

}  // namespace sunder::solid
