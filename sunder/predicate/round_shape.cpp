#include <sunder/base/contract.h>
#include <sunder/predicate/round_shape.h>
#include <sunder/predicate/stages.h>

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
    const Vector3<T> way = Vector3<T>{dot(adjoint.rows[0], from), dot(adjoint.rows[1], from),
                                      dot(adjoint.rows[2], from)} -
                           times(scale, lift<Stage>(s.points[0]));
    return sign(r2 * squared(scale) - squared(way));
  }
  const Vector3<T> axis = axis_of<Stage>(s);
  const Vector3<T> from = x.at - times(w, lift<Stage>(Posed3{s.points[0], s.pose, false}));
  const T length2 = squared(axis), along = dot(from, axis), rest = w * length2 - along;
  const T across = squared(cross(from, axis));  // times a a w^2
  const Guess within = lesser(sign(along), sign(rest));
  if (within == Guess::negative) return within;
  const T reach = s.kind == RoundKind::cylinder ? r2 * squared(w) * length2 - across
                                                : r2 * squared(rest) - across * length2;
  if (s.kind == RoundKind::cylinder) return lesser(within, sign(reach));
  return lesser(within, sign(reach));
}

template <class T>
Guess nearness_formula(const Homogeneous<T>& p, const Homogeneous<T>& q, const T& reach) {
  const Vector3<T> way = times(q.weight, p.at) - times(p.weight, q.at);
  return sign(squared(reach * p.weight * q.weight) - squared(way));
}

Homogeneous<Dyadic> homogeneous(const ExactPoint& p) { return {p.at, p.weight}; }

}  // namespace

ExactPoint exact_point(const WeightedPoint& point) {
  const auto [at, weight] = lift<ExactStage>(point);
  return {at, weight};
}

Sign gap_sign(const WorldDirection& direction, const RoundShape& a, const RoundShape& b, StageTally* tally) {
  const Guess guess = gap_formula<IntervalStage>(direction.enclosure(), a, b);
  if (is_sure(guess)) return counted(&StageTally::interval, tally, to_sign(guess));
  return counted(&StageTally::exact, tally, to_sign(gap_formula<ExactStage>(direction.exact(), a, b)));
}

Sign gap_sign(const Dyadic& g, const Dyadic& u, const Dyadic& v) {
  return to_sign(sign_less_roots(g, {u, Dyadic(1.0)}, {v, Dyadic(1.0)}));
}

Sign side_of(const RoundShape& shape, const WeightedPoint& point, StageTally* tally) {
  SUNDER_REQUIRE(shape.kind != RoundKind::hull);
  const Guess guess = side_formula<IntervalStage>(shape, lift<IntervalStage>(point));
  if (is_sure(guess)) return counted(&StageTally::interval, tally, to_sign(guess));
  return counted(&StageTally::exact, tally, to_sign(side_formula<ExactStage>(shape, lift<ExactStage>(point))));
}

Sign side_of(const RoundShape& shape, const ExactPoint& point) {
  SUNDER_REQUIRE(shape.kind != RoundKind::hull);
  return to_sign(side_formula<ExactStage>(shape, homogeneous(point)));
}

Sign nearness(const WeightedPoint& p, double radius_p, const WeightedPoint& q, double radius_q, StageTally* tally) {
  const Guess guess = nearness_formula(lift<IntervalStage>(p), lift<IntervalStage>(q),
                                       Interval(radius_p) + Interval(radius_q));
  if (is_sure(guess)) return counted(&StageTally::interval, tally, to_sign(guess));
  return counted(&StageTally::exact, tally, nearness(exact_point(p), radius_p, exact_point(q), radius_q));
}

Sign nearness(const ExactPoint& p, double radius_p, const ExactPoint& q, double radius_q) {
  return to_sign(nearness_formula(homogeneous(p), homogeneous(q), Dyadic(radius_p) + Dyadic(radius_q)));
}

std::array<Dyadic, 9> adjoint(const Affine3& pose) {
  const auto rows = adjoint_of<ExactStage>(pose).rows;
  return {rows[0].x, rows[0].y, rows[0].z, rows[1].x, rows[1].y, rows[1].z, rows[2].x, rows[2].y, rows[2].z};
}

}  // namespace sunder
