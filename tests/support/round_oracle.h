// Is what is said of two bodies with a radius true? Fractions and plain formulas: shares no code with what it checks.
#pragma once

#include <sunder/number/integer_internal.h>
#include <sunder/solid/round/round_round.h>
#include <tests/support/fraction.h>

#include <array>
#include <cstddef>
#include <vector>

namespace sunder::tests {

inline Fraction fraction(double x) { return Fraction(x); }
inline Fraction fraction(const Dyadic& x) { return Fraction(Integer(mantissa_of(x).str())).scaled(x.exponent()); }

using Triple = std::array<Fraction, 3>;

inline Fraction dot(const Triple& p, const Triple& q) { return p[0] * q[0] + p[1] * q[1] + p[2] * q[2]; }
inline Triple less(const Triple& p, const Triple& q) { return {p[0] - q[0], p[1] - q[1], p[2] - q[2]}; }

inline Triple triple(const ExactPoint3& p) {
  Triple x;
  for (std::size_t i = 0; i < 3; ++i) x[i] = fraction(p[i]) / fraction(p.denominator);
  return x;
}

// A body as the page of certificates defines it.
struct OracleBody {
  RoundKind kind;
  std::vector<Triple> points;  // placed
  Fraction radius;
  std::array<Triple, 3> columns;  // of the pose's linear part
  Triple moved;                   // its translation

  explicit OracleBody(const solid::PlacedRound& placed) : kind(placed.kind()), radius(fraction(placed.radius())) {
    const Affine3& pose = placed.pose.affine();
    for (std::size_t j = 0; j < 3; ++j) {
      for (std::size_t i = 0; i < 3; ++i) columns[j][i] = fraction(pose.linear[3 * i + j]);
      moved[j] = fraction(pose.translation[j]);
    }
    for (const Point3& p : placed.body.points()) points.push_back(image({p.x, p.y, p.z}));
  }
  Triple image(const Triple& p) const {
    Triple x = moved;
    for (std::size_t j = 0; j < 3; ++j) {
      for (std::size_t i = 0; i < 3; ++i) x[i] += columns[j][i] * p[j];
    }
    return x;
  }

  // The greatest of q + sqrt(u) over the body along d, as a list of (q, u).
  std::vector<std::array<Fraction, 2>> reaches(const Triple& d) const {
    std::vector<std::array<Fraction, 2>> out;
    const Fraction dd = dot(d, d);
    if (kind == RoundKind::ellipsoid) {
      Fraction u = 0;
      for (const Triple& c : columns) u += dot(c, d) * dot(c, d);
      return {{dot(points[0], d), radius * radius * u}};
    }
    if (kind == RoundKind::hull) {
      for (const Triple& p : points) out.push_back({dot(p, d), radius * radius * dd});
      return out;
    }
    const Triple a = less(points[1], points[0]);
    const Fraction u = radius * radius * (dd - dot(d, a) * dot(d, a) / dot(a, a));
    return {{dot(points[0], d), u}, {dot(points[1], d), kind == RoundKind::cone ? Fraction(0) : u}};
  }

  // Does it hold the point, as these weights say?
  bool holds(const Triple& x, const Combination& c) const {
    Triple y{0, 0, 0};
    Fraction sum = 0;
    const Fraction over = fraction(c.denominator);
    std::vector<Fraction> weight(points.size(), 0);
    for (const auto& [entry, numerator] : c.parts) {
      if (entry >= points.size()) return false;
      weight[entry] += fraction(numerator) / over;
    }
    for (std::size_t k = 0; k < points.size(); ++k) {
      if (weight[k] < 0) return false;
      sum += weight[k];
      for (std::size_t i = 0; i < 3; ++i) y[i] += weight[k] * points[k][i];
    }
    if (sum != 1) return false;
    if (kind == RoundKind::ellipsoid) {
      if (!c.from) return false;
      const Triple v = triple(*c.from);
      return image(v) == x && dot(v, v) <= radius * radius;  // the ball's centre is the origin
    }
    if (c.from) return false;
    const Triple way = less(x, y);
    if (kind == RoundKind::hull) return dot(way, way) <= radius * radius;
    if (dot(way, less(points[1], points[0])) != 0) return false;
    const Fraction reach = kind == RoundKind::cone ? radius * weight[0] : radius;
    return dot(way, way) <= reach * reach;
  }
};

// g > sqrt(u) + sqrt(v)?
inline bool is_beyond(const Fraction& g, const Fraction& u, const Fraction& v) {
  if (g <= 0) return false;
  const Fraction rest = g * g - u - v;  // > 2 sqrt(u v)?
  return rest > 0 ? rest * rest > 4 * u * v : false;
}

inline bool is_parted(const OracleBody& a, const OracleBody& b, const Triple& d) {
  const Triple back{-d[0], -d[1], -d[2]};
  for (const auto& [q, u] : a.reaches(d)) {
    for (const auto& [minus_p, v] : b.reaches(back)) {
      if (!is_beyond(-minus_p - q, u, v)) return false;
    }
  }
  return true;
}

// g >= sqrt(u) + sqrt(v) + sqrt(w)?
inline bool is_as_far(const Fraction& g, const Fraction& u, const Fraction& v, const Fraction& w) {
  if (g <= 0) return g == 0 && u == 0 && v == 0 && w == 0;
  if (g * g < u) return false;
  // (g - sqrt(u))^2 >= (sqrt(v) + sqrt(w))^2, which is e >= 2 g sqrt(u) + 2 sqrt(v w).
  const Fraction e = g * g + u - v - w, rest = e * e - 4 * g * g * u - 4 * v * w;  // >= 8 g sqrt(u v w)?
  return e >= 0 && rest >= 0 && rest * rest >= 64 * g * g * u * v * w;
}

// Along the direction, is B as far beyond A as that?
inline bool is_clear(const OracleBody& a, const OracleBody& b, const Triple& d, const Fraction& distance) {
  const Triple back{-d[0], -d[1], -d[2]};
  const Fraction w = distance * distance * dot(d, d);
  if (dot(d, d) == 0) return false;
  for (const auto& [q, u] : a.reaches(d)) {
    for (const auto& [minus_p, v] : b.reaches(back)) {
      if (!is_as_far(-minus_p - q, u, v, w)) return false;
    }
  }
  return true;
}

// Points of both bodies, as they say: the square of how far apart they are; -1 where one of them does not hold its own.
inline Fraction squared_way(const OracleBody& a, const OracleBody& b, const std::array<PointOf, 2>& points) {
  const Triple p = triple(points[0].at), q = triple(points[1].at), way = less(q, p);
  return a.holds(p, points[0].of_body) && b.holds(q, points[1].of_body) ? dot(way, way) : Fraction(-1);
}

// Is the answer's evidence that of its verdict? Nothing of undecided ones.
inline bool is_proved(const solid::PlacedRound& a, const solid::PlacedRound& b, const solid::RoundEvidence& evidence) {
  const OracleBody of_a(a), of_b(b);
  if (verdict_of(evidence) == Verdict::apart) {
    const std::array<Dyadic, 3> d = solid::direction_of(a, b, evidence);
    return is_parted(of_a, of_b, {fraction(d[0]), fraction(d[1]), fraction(d[2])});
  }
  const CommonPoint point = solid::common_point_of(a, b, evidence);
  const Triple x = triple(point.at);
  return of_a.holds(x, point.of_a) && of_b.holds(x, point.of_b);
}

}  // namespace sunder::tests
