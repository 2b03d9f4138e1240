// With c_i the origin, d and e the centres of j and l, and E, F, G the leads of j, l and k at c_i: the deepest point q
// of i and j is E / (2 |d|^2) d; of three, the solution of 2 d q = E, 2 e q = F. The power of k at q minus that of i is
// G - 2 (c_k - c_i) q, and the power of i there |q|^2 - r_i^2. All is multiplied by 2 |d|^2 or by 2 d x e.
#include <sunder/number/integer_internal.h>
#include <sunder/predicate/disc/disc_powers.h>
#include <sunder/predicate/disc/disc_stages.h>

#include <algorithm>

namespace sunder {

namespace {

constexpr auto against_one = [](const auto& i, const auto& k) { return sign(lead(i, k)); };

constexpr auto against_two = [](const auto& i, const auto& j, const auto& k) {
  const auto d = center_from(i, j);
  return sign(dot(d, d) * lead(i, k) - lead(i, j) * dot(d, center_from(i, k)));
};

constexpr auto turn_of_centers = [](const auto& i, const auto& j, const auto& l) {
  return sign(cross(center_from(i, j), center_from(i, l)));
};

constexpr auto against_three = [](const auto& i, const auto& j, const auto& l, const auto& k) {
  const auto d = center_from(i, j);
  const auto e = center_from(i, l);
  const auto f = center_from(i, k);
  return sign((cross(d, e) * lead(i, k) - lead(i, j) * cross(f, e)) - lead(i, l) * cross(d, f));
};

constexpr auto power_of_two = [](const auto& i, const auto& j) { return sign(crossing_area(i, j)); };

constexpr auto power_of_three = [](const auto& i, const auto& j, const auto& l) {
  const auto d = center_from(i, j);
  const auto e = center_from(i, l);
  const auto at_j = lead(i, j);
  const auto at_l = lead(i, l);
  const auto x = at_j * e.x - at_l * d.x;
  const auto y = at_j * e.y - at_l * d.y;
  const auto reach = (i.z + i.z) * cross(d, e);
  return sign((x * x + y * y) - reach * reach);
};

using Exact = Vector3<Dyadic>;

// The deepest point as seen from c_i, over 2 |d|^2 or 2 d x e, which the weights are over, too.
ExactPoint2 deepest_from_center(const Exact& i, const Exact& j) {
  const auto d = center_from(i, j);
  const Dyadic at_j = lead(i, j);
  return {at_j * d.x, at_j * d.y, Dyadic(2) * dot(d, d)};
}

ExactPoint2 deepest_from_center(const Exact& i, const Exact& j, const Exact& l) {
  const auto d = center_from(i, j);
  const auto e = center_from(i, l);
  const Dyadic at_j = lead(i, j), at_l = lead(i, l), denominator = Dyadic(2) * cross(d, e);
  const Vector2<Dyadic> q{at_j * e.y - at_l * d.y, at_l * d.x - at_j * e.x};
  if (denominator.sign() == Sign::positive) return {q.x, q.y, denominator};
  return {-q.x, -q.y, -denominator};
}

ExactPoint2 deepest_from_center(std::span<const Disc> basis) {
  const auto at = [&](std::size_t k) { return lift<ExactStage>(basis[k]); };
  return basis.size() == 1   ? ExactPoint2{}
         : basis.size() == 2 ? deepest_from_center(at(0), at(1))
                             : deepest_from_center(at(0), at(1), at(2));
}

// From the first centre.
Vector2<Interval> enclosure_from_center(std::span<const Disc> basis) {
  if (basis.size() == 1) return {0.0, 0.0};
  const auto at = [&](std::size_t k) { return lift<IntervalStage>(basis[k]); };
  const auto d = center_from(at(0), at(1));
  const Interval of_j = lead(at(0), at(1)), half = 0.5;
  if (basis.size() == 2) {
    const Interval t = half * of_j / dot(d, d);
    return {t * d.x, t * d.y};
  }
  const auto e = center_from(at(0), at(2));
  const Interval of_l = lead(at(0), at(2)), turn = cross(d, e);
  return {half * (of_j * e.y - of_l * d.y) / turn, half * (of_l * d.x - of_j * e.x) / turn};
}

}  // namespace

PowerBound power_bound(std::span<const Disc> basis) {
  const Vector2<Interval> q = enclosure_from_center(basis);
  const Interval radius = basis[0].radius, power = (q.x * q.x + q.y * q.y) - radius * radius;
  return {{q.x + basis[0].center.x, q.y + basis[0].center.y}, power.low};
}

Sign power_against(std::span<const Disc> basis, const Disc& k, StageTally* tally) {
  if (basis.size() == 1) return decide_discs(tally, against_one, basis[0], k);
  if (basis.size() == 2) return decide_discs(tally, against_two, basis[0], basis[1], k);
  const Sign turn = decide_discs(tally, turn_of_centers, basis[0], basis[1], basis[2]);
  return turn * decide_discs(tally, against_three, basis[0], basis[1], basis[2], k);
}

Sign deepest_power(std::span<const Disc> basis, StageTally* tally) {
  if (basis.size() == 1) return -sign_of(basis[0].radius);
  if (basis.size() == 2) return -decide_discs(tally, power_of_two, basis[0], basis[1]);
  return decide_discs(tally, power_of_three, basis[0], basis[1], basis[2]);
}

ExactPoint2 deepest_point(std::span<const Disc> basis) {
  const auto [x, y, n] = deepest_from_center(basis);
  return {Dyadic(basis[0].center.x) * n + x, Dyadic(basis[0].center.y) * n + y, n};
}

DeepestWeights deepest_weights(std::span<const Disc> basis) {
  if (basis.size() == 1) return {{Dyadic(1), Dyadic(), Dyadic()}, Dyadic(1)};
  const ExactPoint2 deepest = deepest_from_center(basis);
  const Exact i = lift<ExactStage>(basis[0]), j = lift<ExactStage>(basis[1]);
  if (basis.size() == 2) {
    const Dyadic of_j = lead(i, j);
    return {{deepest.denominator - of_j, of_j, Dyadic()}, deepest.denominator};
  }
  // q = w_j d + w_l e by Cramer's rule.
  const Exact l = lift<ExactStage>(basis[2]);
  const auto d = center_from(i, j);
  const auto e = center_from(i, l);
  const auto q = deepest.numerators();
  Dyadic turn = cross(d, e), of_j = cross(q, e), of_l = cross(d, q);
  if (turn.sign() == Sign::negative) {
    turn = -turn;
    of_j = -of_j;
    of_l = -of_l;
  }
  const Dyadic denominator = deepest.denominator * turn;
  return {{denominator - of_j - of_l, of_j, of_l}, denominator};
}

Sign power_at(const Point2& p, const Disc& k, StageTally* tally) {
  return decide_discs(tally, against_one, Disc{p, 0}, k);
}

Sign power_at(const Viewpoint& p, const Disc& k) {
  const Dyadic x = p.x - Dyadic(k.center.x), y = p.y - Dyadic(k.center.y), radius = k.radius;
  return ((x * x + y * y) - radius * radius).sign();
}

Viewpoint deepest_viewpoint(std::span<const Disc> basis, std::uint32_t bits) {
  const ExactPoint2 p = deepest_point(basis);
  const auto top_of = [](const Dyadic& a) {  // |a| < 2^top
    return a.sign() == Sign::zero ? std::int64_t{-100000} : a.top() + 1;
  };
  const std::int64_t unit = std::max(top_of(p.x), top_of(p.y)) - top_of(p.denominator) - std::int64_t{bits};
  // The whole part of a / (denominator 2^unit).
  const auto cut = [&](const Dyadic& a) {
    Integer n = mantissa_of(a), d = mantissa_of(p.denominator);
    const std::int64_t shift = a.exponent() - p.denominator.exponent() - unit;
    (shift > 0 ? n : d) <<= static_cast<unsigned long>(shift > 0 ? shift : -shift);
    return dyadic_of(n / d, unit);
  };
  Viewpoint out{cut(p.x), cut(p.y), {}};
  out.in = {out.x.enclosure(), out.y.enclosure()};
  return out;
}

}  // namespace sunder
