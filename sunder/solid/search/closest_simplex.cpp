#include <sunder/solid/search/closest_simplex.h>

#include <cmath>
#include <limits>

namespace sunder::solid {

namespace {

template <class V>
auto determinant(const V& a, const V& b, const V& c) {
  return dot(cross(a, b), c);
}

// What is nearest within one part of the simplex: which corners span it, in increasing order, and how near.
template <class Real>
struct Nearest {
  std::array<int, 3> corner;
  int count;
  VectorOf<Real> towards;
  Real distance2;
};

template <class Real>
const VectorOf<Real>& corner(const DifferenceSimplexOf<Real>& s, int i) {
  return s.vertex[static_cast<std::size_t>(i)].at;
}

template <class Real>
Nearest<Real> at_corner(const DifferenceSimplexOf<Real>& s, int i) {
  const VectorOf<Real>& p = corner(s, i);
  return {{i, 0, 0}, 1, negated(p), dot(p, p)};
}

// Of the segment from the newest corner to an older one.
template <class Real>
Nearest<Real> of_segment(const DifferenceSimplexOf<Real>& s, int newest, int older) {
  using Vector = VectorOf<Real>;
  const Vector& a = corner(s, newest);
  const Vector e = minus(corner(s, older), a);
  const Real t = -dot(a, e);
  if (!(t > 0)) return at_corner(s, newest);
  const Real length2 = dot(e, e);
  if (t >= length2) return at_corner(s, older);
  const Real part = t / length2;
  Vector d{-(a.x + part * e.x), -(a.y + part * e.y), -(a.z + part * e.z)};
  const Real distance2 = dot(d, d);
  // Made perpendicular to the edge once more: near contact, d is small and carries the error of large numbers.
  const Real off = dot(d, e) / length2;
  d = {d.x - off * e.x, d.y - off * e.y, d.z - off * e.z};
  return {{older, newest, 0}, 2, d, distance2};
}

// Of the triangle of the newest corner a and two older ones, b before c, with n = (b - a) x (c - a). What is nearest
// has a among its corners, because the search went from the edge b c towards the origin.
template <class Real>
Nearest<Real> of_triangle(const DifferenceSimplexOf<Real>& s, int newest, int b, int c, const VectorOf<Real>& n) {
  const VectorOf<Real>& a = corner(s, newest);
  const VectorOf<Real> ab = minus(corner(s, b), a), ac = minus(corner(s, c), a);
  const bool beyond_ab = dot(cross(ab, n), a) < 0;
  const bool beyond_ac = dot(cross(n, ac), a) < 0;
  if (beyond_ab) {
    const Nearest<Real> on_ab = of_segment(s, newest, b);
    if (!beyond_ac || on_ab.count == 2) return on_ab;
  }
  if (beyond_ac) return of_segment(s, newest, c);
  const Real height = dot(n, a);
  const Real area2 = dot(n, n);
  const double sense = -std::copysign(1.0, nearest(height));
  return {{b, c, newest}, 3, {sense * n.x, sense * n.y, sense * n.z}, area2 > 0 ? height * height / area2 : Real(0)};
}

}  // namespace

template <class Real>
bool reduce_to_closest_face(DifferenceSimplexOf<Real>& s, VectorOf<Real>& towards, Real& distance2) {
  using Vector = VectorOf<Real>;
  Nearest<Real> nearest;
  switch (s.count) {
    case 1: nearest = at_corner(s, 0); break;
    case 2: nearest = of_segment(s, 1, 0); break;
    case 3: {
      const Vector& a = corner(s, 2);
      nearest = of_triangle(s, 2, 0, 1, cross(minus(corner(s, 0), a), minus(corner(s, 1), a)));
      break;
    }
    default: {
      // The three faces of the newest corner a: the origin beyond one makes it a candidate. The face b, c, d is not
      // one: the search went from it towards the origin.
      const Vector& a = corner(s, 3);
      const Vector ab = minus(corner(s, 0), a), ac = minus(corner(s, 1), a), ad = minus(corner(s, 2), a);
      const Vector bc = cross(ab, ac), cd = cross(ac, ad), bd = cross(ab, ad);
      const Real volume = dot(bc, ad);
      nearest.count = 0;
      nearest.distance2 = std::numeric_limits<double>::infinity();
      const auto consider = [&](int i, int j, const Vector& n, const Real& side) {
        // The fourth corner is on the side of n where `side` is positive.
        if (side * dot(n, a) < 0) return;
        const Nearest<Real> found = of_triangle(s, 3, i, j, n);
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

template <class Real>
std::array<Real, 4> weights_of_nearest(const DifferenceSimplexOf<Real>& s) {
  using Vector = VectorOf<Real>;
  const Vector &a = s.vertex[0].at, &b = s.vertex[1].at, &c = s.vertex[2].at;
  switch (s.count) {
    case 1: return {1};
    case 2: {
      const Vector e = minus(b, a);
      return {dot(b, e), -dot(a, e)};
    }
    case 3: {
      const Vector u = minus(b, a), v = minus(c, a);
      const Real uu = dot(u, u), uv = dot(u, v), vv = dot(v, v), ua = -dot(u, a), va = -dot(v, a);
      const Real wb = vv * ua - uv * va, wc = uu * va - uv * ua;
      return {(uu * vv - uv * uv) - wb - wc, wb, wc};
    }
    default: return weights_of_origin(s);
  }
}

template <class Real>
std::array<Real, 4> weights_of_origin(const DifferenceSimplexOf<Real>& t) {
  const auto &a = t.vertex[0].at, &b = t.vertex[1].at, &c = t.vertex[2].at, &d = t.vertex[3].at;
  const Real wa = determinant(b, c, d), wb = -determinant(a, c, d), wc = determinant(a, b, d),
             wd = -determinant(a, b, c);
  return wa + wb + wc + wd < 0 ? std::array<Real, 4>{-wa, -wb, -wc, -wd} : std::array<Real, 4>{wa, wb, wc, wd};
}

template bool reduce_to_closest_face(DifferenceSimplexOf<double>&, Point3&, double&);
template bool reduce_to_closest_face(DifferenceSimplexOf<DoubleDouble>&, Vector3<DoubleDouble>&, DoubleDouble&);
template std::array<double, 4> weights_of_nearest(const DifferenceSimplexOf<double>&);
template std::array<DoubleDouble, 4> weights_of_nearest(const DifferenceSimplexOf<DoubleDouble>&);
template std::array<double, 4> weights_of_origin(const DifferenceSimplexOf<double>&);
template std::array<DoubleDouble, 4> weights_of_origin(const DifferenceSimplexOf<DoubleDouble>&);

}  // namespace sunder::solid
