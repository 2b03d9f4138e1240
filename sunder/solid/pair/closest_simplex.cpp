#include <sunder/solid/pair/closest_simplex.h>

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

// What is nearest within one part: which of its corners span it, and how near.
struct Nearest {
  std::array<int, 3> corner{};
  int count = 0;
  Point3 towards;
  double distance2 = std::numeric_limits<double>::infinity();
};

Nearest at_corner(const DifferenceSimplex& s, int i) {
  const Point3& p = s.vertex[static_cast<std::size_t>(i)].at;
  return {{i}, 1, negated(p), dot(p, p)};
}

Nearest on_edge(const DifferenceSimplex& s, int i, int j, double weight_j) {
  const Point3& a = s.vertex[static_cast<std::size_t>(i)].at;
  const Point3 e = minus(s.vertex[static_cast<std::size_t>(j)].at, a);
  Point3 d{-(a.x + weight_j * e.x), -(a.y + weight_j * e.y), -(a.z + weight_j * e.z)};
  const double distance2 = dot(d, d);
  // Made perpendicular to the edge once more: near contact, d is small and carries the error of large numbers.
  const double off = dot(d, e) / dot(e, e);
  d = {d.x - off * e.x, d.y - off * e.y, d.z - off * e.z};
  return {{i, j}, 2, d, distance2};
}

Nearest of_segment(const DifferenceSimplex& s, int i, int j) {
  const Point3& a = s.vertex[static_cast<std::size_t>(i)].at;
  const Point3 e = minus(s.vertex[static_cast<std::size_t>(j)].at, a);
  const double t = -dot(a, e);
  if (!(t > 0)) return at_corner(s, i);
  const double length2 = dot(e, e);
  if (t >= length2) return at_corner(s, j);
  return on_edge(s, i, j, t / length2);
}

Nearest of_triangle(const DifferenceSimplex& s, int i, int j, int k) {
  const Point3& a = s.vertex[static_cast<std::size_t>(i)].at;
  const Point3& b = s.vertex[static_cast<std::size_t>(j)].at;
  const Point3& c = s.vertex[static_cast<std::size_t>(k)].at;
  const Point3 ab = minus(b, a), ac = minus(c, a);
  const double d1 = -dot(ab, a), d2 = -dot(ac, a);
  if (d1 <= 0 && d2 <= 0) return at_corner(s, i);
  const double d3 = -dot(ab, b), d4 = -dot(ac, b);
  if (d3 >= 0 && d4 <= d3) return at_corner(s, j);
  const double vc = d1 * d4 - d3 * d2;
  if (vc <= 0 && d1 >= 0 && d3 <= 0) return on_edge(s, i, j, d1 / (d1 - d3));
  const double d5 = -dot(ab, c), d6 = -dot(ac, c);
  if (d6 >= 0 && d5 <= d6) return at_corner(s, k);
  const double vb = d5 * d2 - d1 * d6;
  if (vb <= 0 && d2 >= 0 && d6 <= 0) return on_edge(s, i, k, d2 / (d2 - d6));
  const double va = d3 * d6 - d5 * d4;
  if (va <= 0 && d4 - d3 >= 0 && d5 - d6 >= 0) return on_edge(s, j, k, (d4 - d3) / ((d4 - d3) + (d5 - d6)));
  const Point3 n = cross(ab, ac);
  const double height = dot(n, a);
  const double area2 = dot(n, n);
  return {{i, j, k}, 3, height > 0 ? negated(n) : n, area2 > 0 ? height * height / area2 : 0};
}

}  // namespace

bool reduce_to_closest_face(DifferenceSimplex& s, Point3& towards) {
  Nearest nearest;
  switch (s.count) {
    case 1: nearest = at_corner(s, 0); break;
    case 2: nearest = of_segment(s, 0, 1); break;
    case 3: nearest = of_triangle(s, 0, 1, 2); break;
    default: {
      // Each face of the newest corner d: the origin beyond it makes it a candidate. The face a, b, c is not one: the
      // search went from it towards the origin.
      const Point3 &a = s.vertex[0].at, &b = s.vertex[1].at, &c = s.vertex[2].at, &d = s.vertex[3].at;
      const double volume = determinant(minus(b, a), minus(c, a), minus(d, a));
      const double orientation = volume < 0 ? -1 : 1;
      // With weights of the origin w: w_d = -det(a, b, c) / volume and so on.
      const auto beyond = [&](const Point3& p, const Point3& q, const Point3& r) {
        return !(orientation * determinant(p, q, r) < 0);
      };
      bool inside = true;
      const auto consider = [&](int i, int j, int k) {
        inside = false;
        const Nearest found = of_triangle(s, i, j, k);
        if (found.distance2 < nearest.distance2) nearest = found;
      };
      if (beyond(a, d, b)) consider(0, 3, 1);
      if (beyond(a, c, d)) consider(0, 2, 3);
      if (beyond(b, d, c)) consider(1, 3, 2);
      if (inside) return false;
    }
  }
  DifferenceSimplex face;
  face.count = nearest.count;
  for (int i = 0; i < nearest.count; ++i) {
    face.vertex[static_cast<std::size_t>(i)] =
        s.vertex[static_cast<std::size_t>(nearest.corner[static_cast<std::size_t>(i)])];
  }
  s = face;
  towards = nearest.towards;
  return true;
}

std::array<double, 4> weights_of_origin(const DifferenceSimplex& t) {
  const Point3 &a = t.vertex[0].at, &b = t.vertex[1].at, &c = t.vertex[2].at, &d = t.vertex[3].at;
  const double wa = determinant(b, c, d), wb = -determinant(a, c, d), wc = determinant(a, b, d),
               wd = -determinant(a, b, c);
  return wa + wb + wc + wd < 0 ? std::array{-wa, -wb, -wc, -wd} : std::array{wa, wb, wc, wd};
}

}  // namespace sunder::solid
