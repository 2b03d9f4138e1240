#include <sunder/base/contract.h>
#include <sunder/predicate/disc/round_shape.h>
#include <sunder/predicate/filter/stages.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace sunder {

namespace {

// sqrt(square / over): a square that is not negative over a number above zero.
template <class T>
struct Root {
  T square, over;
};

template <class T>
struct EndOf {
  Vector3<T> at;
  Root<T> root;
};

template <class T>
Vector3<T> operator+(const Vector3<T>& p, const Vector3<T>& q) {
  return {p.x + q.x, p.y + q.y, p.z + q.z};
}

template <class T>
T squared(const T& x) {
  return x * x;
}
template <class T>
T squared(const Vector3<T>& v) {
  return dot(v, v);
}
// Squares of intervals that hold zero reach no lower than it.
Interval squared(const Interval& x) {
  const Interval product = x * x;
  return {std::max(product.low, 0.0), product.high};
}
Interval squared(const Vector3<Interval>& v) { return squared(v.x) + squared(v.y) + squared(v.z); }

template <class Stage, class Vector>
auto turned(const Affine3& pose, const Vector& v) {
  const auto& m = pose.linear;
  const auto row = [&](std::size_t i) {
    return (Stage::read(m[i]) * v.x + Stage::read(m[i + 1]) * v.y) + Stage::read(m[i + 2]) * v.z;
  };
  return Vector3<decltype(row(0))>{row(0), row(3), row(6)};
}

template <class Stage, class Vector>
auto pulled(const Affine3& pose, const Vector& v) {
  const auto& m = pose.linear;
  const auto column = [&](std::size_t j) {
    return (Stage::read(m[j]) * v.x + Stage::read(m[3 + j]) * v.y) + Stage::read(m[6 + j]) * v.z;
  };
  return Vector3<decltype(column(0))>{column(0), column(1), column(2)};
}

// The image of points[1] less that of points[0].
template <class Stage>
auto axis_of(const RoundShape& s) {
  return turned<Stage>(*s.pose, lift<Stage>(s.points[1]) - lift<Stage>(s.points[0]));
}

template <class Stage, class T>
std::array<EndOf<T>, 2> ends_along(const RoundShape& s, const Vector3<T>& d) {
  const auto image = [&](std::size_t k) { return lift<Stage>(Posed3{s.points[k], s.pose, false}); };
  const T r2 = squared(Stage::read(s.radius)), zero(0.0), one(1.0);
  std::array<EndOf<T>, 2> ends{EndOf<T>{image(0), {zero, one}}, EndOf<T>{{zero, zero, zero}, {zero, one}}};
  if (s.kind == RoundKind::hull) {
    ends[0].root.square = r2 * squared(d);
  } else if (s.kind == RoundKind::ellipsoid) {
    ends[0].root.square = r2 * squared(pulled<Stage>(*s.pose, d));
  } else {
    const Vector3<T> axis = axis_of<Stage>(s);
    ends[0].root = {r2 * squared(cross(d, axis)), squared(axis)};
    ends[1].at = image(1);
    if (s.kind == RoundKind::cylinder) ends[1].root = ends[0].root;
  }
  return ends;
}

// The sign of g - sqrt(u) - sqrt(v).
Guess sign_less_roots(const Interval& g, const Root<Interval>& u, const Root<Interval>& v) {
  return sign(g - square_root(u.square / u.over) - square_root(v.square / v.over));
}
Guess sign_less_roots(const Dyadic& g, const Root<Dyadic>& u, const Root<Dyadic>& v) {
  const Guess of_g = sign(g);
  const bool no_roots = u.square.sign() == Sign::zero && v.square.sign() == Sign::zero;
  if (no_roots || of_g == Guess::negative) return of_g;
  if (of_g == Guess::zero) return Guess::negative;
  // g^2 against u + v + 2 sqrt(u v), times both denominators.
  const Dyadic p = u.square * v.over, q = v.square * u.over;
  const Dyadic rest = g * g * u.over * v.over - p - q;
  if (rest.sign() == Sign::negative) return Guess::negative;
  return sign(rest * rest - Dyadic(4.0) * p * q);
}

// The least over all pairs of ends.
template <class Stage, class T>
Guess gap_formula(const Vector3<T>& d, const RoundShape& a, const RoundShape& b) {
  const auto ends_a = ends_along<Stage>(a, d), ends_b = ends_along<Stage>(b, d);
  Guess least = Guess::positive;
  for (std::size_t i = 0; i < a.ends(); ++i) {
    for (std::size_t j = 0; j < b.ends(); ++j) {
      const Guess gap = sign_less_roots(dot(d, ends_b[j].at - ends_a[i].at), ends_a[i].root, ends_b[j].root);
      if (gap == Guess::negative || gap == Guess::unsure) return gap;
      if (gap == Guess::zero) least = gap;
    }
  }
  return least;
}

// The sign of g - sqrt(u) - sqrt(v) - sqrt(w).
Guess sign_less_roots(const Interval& g, const Root<Interval>& u, const Root<Interval>& v, const Interval& w) {
  return sign(g - square_root(u.square / u.over) - square_root(v.square / v.over) - square_root(w));
}
Guess sign_less_roots(const Dyadic& g, const Root<Dyadic>& u, const Root<Dyadic>& v, const Dyadic& w) {
  if (w.sign() == Sign::zero) return sign_less_roots(g, u, v);
  if (g.sign() != Sign::positive) return Guess::negative;
  // Times both denominators all is whole. If g >= sqrt(w): (g - sqrt(w))^2 against (sqrt(u) + sqrt(v))^2, which leaves
  // two roots.
  const Dyadic over = u.over * v.over, h = g * over, p = u.square * over * v.over, q = v.square * over * u.over;
  const Dyadic h2 = h * h, w2 = w * over * over, four(4.0), one(1.0);
  if ((h2 - w2).sign() == Sign::negative) return Guess::negative;
  return sign_less_roots(h2 + w2 - p - q, {four * h2 * w2, one}, {four * p * q, one});
}

// The least over all pairs of ends.
template <class Stage, class T>
Guess clear_formula(const Vector3<T>& d, const RoundShape& a, const RoundShape& b, double least) {
  const auto ends_a = ends_along<Stage>(a, d), ends_b = ends_along<Stage>(b, d);
  const T w = squared(Stage::read(least)) * squared(d);
  Guess all = Guess::positive;
  for (std::size_t i = 0; i < a.ends(); ++i) {
    for (std::size_t j = 0; j < b.ends(); ++j) {
      const Guess gap = sign_less_roots(dot(d, ends_b[j].at - ends_a[i].at), ends_a[i].root, ends_b[j].root, w);
      if (gap == Guess::negative || gap == Guess::unsure) return gap;
      if (gap == Guess::zero) all = gap;
    }
  }
  return all;
}

template <class T>
struct Homogeneous {
  Vector3<T> at;
  T weight;
};

template <class Stage>
auto lift(const WeightedPoint& p) {
  using T = decltype(Stage::read(0.0));
  Homogeneous<T> sum{{T(0.0), T(0.0), T(0.0)}, T(0.0)};
  for (std::size_t k = 0; k < p.count; ++k) {
    const T w = Stage::read(p.weights[k]);
    const Vector3<T> image = lift<Stage>(p.points[k]);
    sum.at = sum.at + Vector3<T>{w * image.x, w * image.y, w * image.z};
    sum.weight = sum.weight + w;
  }
  return sum;
}

template <class T>
Vector3<T> times(const T& w, const Vector3<T>& v) {
  return {w * v.x, w * v.y, w * v.z};
}

template <class Stage>
auto adjoint_of(const Affine3& pose) {
  const auto row = [&](std::size_t i) {
    const auto& m = pose.linear;
    return lift<Stage>(Point3{m[3 * i], m[3 * i + 1], m[3 * i + 2]});
  };
  const auto x = row(0), y = row(1), z = row(2);
  const auto p = cross(y, z), q = cross(z, x), r = cross(x, y);  // the columns
  using T = decltype(Stage::read(0.0));
  struct Adjoint {
    std::array<Vector3<T>, 3> rows;
    T determinant;
  };
  return Adjoint{{Vector3<T>{p.x, q.x, r.x}, Vector3<T>{p.y, q.y, r.y}, Vector3<T>{p.z, q.z, r.z}}, dot(x, p)};
}

// The least of two guesses, of which a negative one tells.
Guess lesser(Guess a, Guess b) {
  if (a == Guess::negative || b == Guess::negative) return Guess::negative;
  if (!is_sure(a) || !is_sure(b)) return Guess::unsure;
  return a == Guess::zero ? a : b;
}

template <class Stage, class T>
Guess side_formula(const RoundShape& s, const Homogeneous<T>& x) {
  const T r2 = squared(Stage::read(s.radius));
  const T& w = x.weight;
  if (s.kind == RoundKind::ellipsoid) {
    // adj(L) (x - t) - det c against det r, times the weight.
    const auto adjoint = adjoint_of<Stage>(*s.pose);
    const auto& t = s.pose->translation;
    const Vector3<T> from = x.at - times(w, lift<Stage>(Point3{t[0], t[1], t[2]}));
    const T scale = w * adjoint.determinant;
    const Vector3<T> way =
        Vector3<T>{dot(adjoint.rows[0], from), dot(adjoint.rows[1], from), dot(adjoint.rows[2], from)} -
        times(scale, lift<Stage>(s.points[0]));
    return sign(r2 * squared(scale) - squared(way));
  }
  const Vector3<T> axis = axis_of<Stage>(s);
  const Vector3<T> from = x.at - times(w, lift<Stage>(Posed3{s.points[0], s.pose, false}));
  const T length2 = squared(axis), along = dot(from, axis), rest = w * length2 - along;
  const T across = squared(cross(from, axis));  // times a a w^2
  const Guess within = lesser(sign(along), sign(rest));
  if (within == Guess::negative) return within;
  const T reach =
      s.kind == RoundKind::cylinder ? r2 * squared(w) * length2 - across : r2 * squared(rest) - across * length2;
  return lesser(within, sign(reach));
}

template <class T>
Guess nearness_formula(const Homogeneous<T>& p, const Homogeneous<T>& q, const T& reach) {
  const Vector3<T> way = times(q.weight, p.at) - times(p.weight, q.at);
  return sign(squared(reach * p.weight * q.weight) - squared(way));
}

// ---- The first stage: doubles, with one bound for the error of all roundings.
//
// A vector comes with the sizes of what it was summed from: no component is off by more than 2^-49 of its size, a
// product of such vectors by no more than 2^-47 of the product of the sizes (each has at most 16 roundings of 2^-53). A
// length |v| is off by at most the length of what v is off, and one of a quotient by |a| by that over |a|, where |a| is
// at least 2^-20 of the size of a: 2^-46 of the sizes pays for all of a formula here. Numbers of at most 2^60 in size
// see to it that nothing overflows. Squares that underflow make a length wrong by at most 2^-536, and a quotient of one
// by an axis of at least 2^-100 by 2^-436: errors of at least 2^-400 pay for that.

constexpr double part_off = 0x1p-46, least_error = 0x1p-400, moderate = 0x1p60, least_axis = 0x1p-100;

struct Sized {
  Vector3<double> at, size;
};
Sized operator-(const Sized& p, const Sized& q) { return {p.at - q.at, p.size + q.size}; }

double length(const Vector3<double>& v) { return std::sqrt(dot(v, v)); }
double sum_of(const Vector3<double>& v) { return v.x + v.y + v.z; }
bool is_moderate(const Vector3<double>& size) { return size.x <= moderate && size.y <= moderate && size.z <= moderate; }

Sized turned_sized(const Affine3& pose, const Point3& p, const Point3& from) {
  const auto& m = pose.linear;
  const double x = p.x - from.x, y = p.y - from.y, z = p.z - from.z;
  const double u = std::fabs(x), v = std::fabs(y), w = std::fabs(z);
  const auto row = [&](std::size_t i) { return m[i] * x + m[i + 1] * y + m[i + 2] * z; };
  const auto size = [&](std::size_t i) {
    return std::fabs(m[i]) * u + std::fabs(m[i + 1]) * v + std::fabs(m[i + 2]) * w;
  };
  return {{row(0), row(3), row(6)}, {size(0), size(3), size(6)}};
}
Sized image_sized(const Affine3& pose, const Point3& p) {
  Sized image = turned_sized(pose, p, {});
  const auto& t = pose.translation;
  image.at = image.at + Vector3<double>{t[0], t[1], t[2]};
  image.size = image.size + Vector3<double>{std::fabs(t[0]), std::fabs(t[1]), std::fabs(t[2])};
  return image;
}
Sized image_sized(const WeightedPoint& p) {
  Sized sum{{0, 0, 0}, {0, 0, 0}};
  double weight = 0;
  for (std::size_t k = 0; k < p.count; ++k) {
    const Sized image = image_sized(*p.points[k].pose, p.points[k].point);
    sum.at = sum.at + Vector3<double>{p.weights[k] * image.at.x, p.weights[k] * image.at.y, p.weights[k] * image.at.z};
    sum.size = sum.size +
               Vector3<double>{p.weights[k] * image.size.x, p.weights[k] * image.size.y, p.weights[k] * image.size.z};
    weight += p.weights[k];
  }
  const auto over = [&](const Vector3<double>& v) { return Vector3<double>{v.x / weight, v.y / weight, v.z / weight}; };
  return {over(sum.at), over(sum.size)};
}

Guess sure(double value, double size) {
  const double error = part_off * size;
  if (!(error >= least_error && size <= moderate * moderate)) return Guess::unsure;
  return value > error ? Guess::positive : value < -error ? Guess::negative : Guess::unsure;
}

// What a shape reaches beyond its points along d, with the size of what it was made of.
struct Reach {
  double value, size;
};
Reach reach_along(const RoundShape& s, const Vector3<double>& d, double length_d) {
  if (s.kind == RoundKind::hull) return {s.radius * length_d, s.radius * length_d};
  if (s.kind == RoundKind::ellipsoid) {
    const auto& m = s.pose->linear;
    const auto column = [&](std::size_t j) { return m[j] * d.x + m[3 + j] * d.y + m[6 + j] * d.z; };
    const auto size = [&](std::size_t j) {
      return std::fabs(m[j] * d.x) + std::fabs(m[3 + j] * d.y) + std::fabs(m[6 + j] * d.z);
    };
    return {s.radius * length({column(0), column(1), column(2)}), s.radius * (size(0) + size(1) + size(2))};
  }
  const Sized a = turned_sized(*s.pose, s.points[1], s.points[0]);
  const double of_axis = length(a.at), all = sum_of(a.size);
  if (!(of_axis >= 0x1p-20 * all && of_axis >= least_axis)) return {0, std::numeric_limits<double>::infinity()};
  return {s.radius * length(cross(d, a.at)) / of_axis,
          s.radius * (std::fabs(d.x) + std::fabs(d.y) + std::fabs(d.z)) * (all / of_axis)};
}

Guess gap_in_doubles(const Point3& direction, const RoundShape& a, const RoundShape& b) {
  const Vector3<double> d{direction.x, direction.y, direction.z};
  const Vector3<double> size_d{std::fabs(d.x), std::fabs(d.y), std::fabs(d.z)};
  const double length_d = length(d);
  const Reach of_a = reach_along(a, d, length_d), of_b = reach_along(b, d, length_d);
  Guess least = Guess::positive;
  for (std::size_t i = 0; i < a.ends(); ++i) {
    const Sized p = image_sized(*a.pose, a.points[i]);
    for (std::size_t j = 0; j < b.ends(); ++j) {
      const Sized way = image_sized(*b.pose, b.points[j]) - p;
      const Reach u = i == 1 && a.kind == RoundKind::cone ? Reach{0, 0} : of_a;
      const Reach v = j == 1 && b.kind == RoundKind::cone ? Reach{0, 0} : of_b;
      if (!is_moderate(way.size)) return Guess::unsure;
      const Guess gap = sure(dot(d, way.at) - u.value - v.value, dot(size_d, way.size) + u.size + v.size);
      if (gap == Guess::negative) return gap;
      if (gap == Guess::unsure) least = gap;
    }
  }
  return least;
}

Guess nearness_in_doubles(const WeightedPoint& p, const WeightedPoint& q, double reach) {
  const Sized way = image_sized(q) - image_sized(p);
  if (!is_moderate(way.size) || !(reach <= moderate)) return Guess::unsure;
  return sure(reach - length(way.at), reach + sum_of(way.size));
}

Guess side_in_doubles(const RoundShape& s, const WeightedPoint& x) {
  if (s.kind == RoundKind::ellipsoid) return Guess::unsure;
  const Sized from = image_sized(x) - image_sized(*s.pose, s.points[0]);
  const Sized axis = turned_sized(*s.pose, s.points[1], s.points[0]);
  const double of_axis = length(axis.at), all = sum_of(axis.size), size = sum_of(from.size) * (all / of_axis);
  if (!(of_axis >= 0x1p-20 * all && of_axis >= least_axis) || !is_moderate(from.size) ||
      !(of_axis <= moderate && s.radius <= moderate)) {
    return Guess::unsure;
  }
  const double along = dot(from.at, axis.at) / of_axis, rest = of_axis - along;
  const double across = length(cross(from.at, axis.at)) / of_axis;
  const Guess within = lesser(sure(along, size), sure(rest, size + all));
  if (within == Guess::negative) return within;
  if (s.kind == RoundKind::cylinder) return lesser(within, sure(s.radius - across, s.radius + size));
  const double slope = s.radius / of_axis;
  if (!(slope <= moderate)) return Guess::unsure;
  return lesser(within, sure(slope * rest - across, slope * (size + all) * (all / of_axis) + size));
}

Homogeneous<Dyadic> homogeneous(const ExactPoint3& p) { return {p.numerators(), p.denominator}; }

}  // namespace

ExactPoint3 exact_point(const WeightedPoint& point) {
  const auto [at, weight] = lift<ExactStage>(point);
  return exact_point(at, weight);
}

Sign gap_sign(const WorldDirection& direction, const RoundShape& a, const RoundShape& b, StageTally* tally) {
  if (direction.is_tame()) {
    const Guess first = gap_in_doubles(direction.doubles(), a, b);
    if (is_sure(first)) return counted(&StageTally::rounded, tally, to_sign(first));
  }
  const Guess guess = gap_formula<IntervalStage>(direction.enclosure(), a, b);
  if (is_sure(guess)) return counted(&StageTally::interval, tally, to_sign(guess));
  return counted(&StageTally::exact, tally, to_sign(gap_formula<ExactStage>(direction.exact(), a, b)));
}

Sign clear_sign(const WorldDirection& direction, const RoundShape& a, const RoundShape& b, double least,
                StageTally* tally) {
  SUNDER_REQUIRE(least >= 0 && std::isfinite(least));
  const Guess guess = clear_formula<IntervalStage>(direction.enclosure(), a, b, least);
  if (is_sure(guess)) return counted(&StageTally::interval, tally, to_sign(guess));
  return counted(&StageTally::exact, tally, to_sign(clear_formula<ExactStage>(direction.exact(), a, b, least)));
}

Sign gap_sign(const Dyadic& g, const Dyadic& u, const Dyadic& v) {
  return to_sign(sign_less_roots(g, {u, Dyadic(1.0)}, {v, Dyadic(1.0)}));
}

std::vector<ReachAlong> reaches_along(const Vector3<Dyadic>& direction, const RoundShape& shape) {
  std::vector<ReachAlong> reaches;
  const auto ends = ends_along<ExactStage>(shape, direction);
  for (std::size_t k = 0; k < shape.ends(); ++k) {
    reaches.push_back({dot(direction, ends[k].at), {ends[k].root.square, ends[k].root.over}});
  }
  return reaches;
}

Sign side_of(const RoundShape& shape, const WeightedPoint& point, StageTally* tally) {
  SUNDER_REQUIRE(shape.kind != RoundKind::hull);
  const Guess first = side_in_doubles(shape, point);
  if (is_sure(first)) return counted(&StageTally::rounded, tally, to_sign(first));
  const Guess guess = side_formula<IntervalStage>(shape, lift<IntervalStage>(point));
  if (is_sure(guess)) return counted(&StageTally::interval, tally, to_sign(guess));
  return counted(&StageTally::exact, tally, to_sign(side_formula<ExactStage>(shape, lift<ExactStage>(point))));
}

Sign side_of(const RoundShape& shape, const ExactPoint3& point) {
  SUNDER_REQUIRE(shape.kind != RoundKind::hull);
  return to_sign(side_formula<ExactStage>(shape, homogeneous(point)));
}

Sign nearness(const WeightedPoint& p, double radius_p, const WeightedPoint& q, double radius_q, StageTally* tally) {
  const Guess first = nearness_in_doubles(p, q, radius_p + radius_q);
  if (is_sure(first)) return counted(&StageTally::rounded, tally, to_sign(first));
  const Guess guess =
      nearness_formula(lift<IntervalStage>(p), lift<IntervalStage>(q), Interval(radius_p) + Interval(radius_q));
  if (is_sure(guess)) return counted(&StageTally::interval, tally, to_sign(guess));
  return counted(&StageTally::exact, tally, nearness(exact_point(p), radius_p, exact_point(q), radius_q));
}

Sign nearness(const ExactPoint3& p, double radius_p, const ExactPoint3& q, double radius_q) {
  return to_sign(nearness_formula(homogeneous(p), homogeneous(q), Dyadic(radius_p) + Dyadic(radius_q)));
}

Sign nearness_within(const WeightedPoint& p, double radius_p, const WeightedPoint& q, double radius_q, double least,
                     StageTally* tally) {
  SUNDER_REQUIRE(least >= 0 && std::isfinite(least));
  const Guess first = nearness_in_doubles(p, q, radius_p + radius_q + least);
  if (is_sure(first)) return counted(&StageTally::rounded, tally, to_sign(first));
  const Guess guess = nearness_formula(lift<IntervalStage>(p), lift<IntervalStage>(q),
                                       Interval(radius_p) + Interval(radius_q) + Interval(least));
  if (is_sure(guess)) return counted(&StageTally::interval, tally, to_sign(guess));
  const Dyadic reach = Dyadic(radius_p) + Dyadic(radius_q) + Dyadic(least);
  return counted(&StageTally::exact, tally, to_sign(nearness_formula(lift<ExactStage>(p), lift<ExactStage>(q), reach)));
}

std::array<Dyadic, 9> adjoint(const Affine3& pose) {
  const auto rows = adjoint_of<ExactStage>(pose).rows;
  return {rows[0].x, rows[0].y, rows[0].z, rows[1].x, rows[1].y, rows[1].z, rows[2].x, rows[2].y, rows[2].z};
}

}  // namespace sunder
