#include <sunder/predicate/exact_plane.h>

#include <sunder/base/contract.h>
#include <sunder/number/vector.h>

#include <algorithm>
#include <cstdint>
#include <utility>

namespace sunder {

namespace {

// The number times a power of two as an interval: the same power for all that are told together.
Interval enclosure(const Dyadic& x, std::int64_t top) { return x.scaled(-top).enclosure(); }

std::int64_t top_of(const Vector3<Dyadic>& v) {
  std::int64_t top = 0;
  bool is_first = true;
  for (const Dyadic* x : {&v.x, &v.y, &v.z}) {
    if (x->sign() == Sign::zero) continue;
    top = is_first ? x->top() : std::max(top, x->top());
    is_first = false;
  }
  return top;
}

}  // namespace

EnclosedPoint::EnclosedPoint(ExactPoint3 p) : exact(std::move(p)) {
  if (exact.denominator.sign() == Sign::negative) {
    exact = {-exact.x, -exact.y, -exact.z, -exact.denominator};
  }
  SUNDER_REQUIRE(exact.denominator.sign() == Sign::positive);
  const std::int64_t top = exact.denominator.top();
  const Interval w = enclosure(exact.denominator, top);
  about =
      w.low == 1 && w.high == 1
          ? Vector3<Interval>{enclosure(exact.x, top), enclosure(exact.y, top), enclosure(exact.z, top)}
          : Vector3<Interval>{enclosure(exact.x, top) / w, enclosure(exact.y, top) / w, enclosure(exact.z, top) / w};
}

ExactPlane::ExactPlane(Vector3<Dyadic> given_normal, Dyadic given_offset)
    : normal(std::move(given_normal)), offset(std::move(given_offset)) {
  const std::int64_t top = top_of(normal);
  normal_about = {enclosure(normal.x, top), enclosure(normal.y, top), enclosure(normal.z, top)};
  offset_about = enclosure(offset, top);
}

ExactPlane ExactPlane::across_axis(std::size_t axis, double at) {
  Vector3<Dyadic> normal;
  (axis == 0 ? normal.x : axis == 1 ? normal.y : normal.z) = Dyadic(1.0);
  return {std::move(normal), Dyadic(at)};
}

ExactPlane ExactPlane::through(const Vector3<Dyadic>& p, const Vector3<Dyadic>& q, const Vector3<Dyadic>& r) {
  Vector3<Dyadic> n = cross(q - p, r - p);
  Dyadic offset = dot(n, p);
  return {std::move(n), std::move(offset)};
}

bool ExactPlane::has_no_normal() const {
  return normal.x.sign() == Sign::zero && normal.y.sign() == Sign::zero && normal.z.sign() == Sign::zero;
}

Sign ExactPlane::side_of(const EnclosedPoint& p, StageTally* tally) const {
  const Guess guess = sign(dot(normal_about, p.about) - offset_about);
  if (is_sure(guess)) return counted(&StageTally::interval, tally, to_sign(guess));
  return counted(&StageTally::exact, tally, height(p.exact).sign());
}

Dyadic ExactPlane::height(const ExactPoint3& p) const { return dot(normal, p.numerators()) - offset * p.denominator; }

EnclosedPoint crossing_of(const ExactPlane& plane, const ExactPoint3& p, const ExactPoint3& q) {
  const Dyadic s = plane.height(p), t = plane.height(q);
  return EnclosedPoint(
      ExactPoint3{s * q.x - t * p.x, s * q.y - t * p.y, s * q.z - t * p.z, s * q.denominator - t * p.denominator});
}

EnclosedPoint common_point(const ExactPlane& f, const ExactPlane& g, const ExactPlane& h) {
  const Vector3<Dyadic> gh = cross(g.normal, h.normal), hf = cross(h.normal, f.normal), fg = cross(f.normal, g.normal);
  const auto sum = [&](const Dyadic& x, const Dyadic& y, const Dyadic& z) {
    return f.offset * x + g.offset * y + h.offset * z;
  };
  return EnclosedPoint(
      ExactPoint3{sum(gh.x, hf.x, fg.x), sum(gh.y, hf.y, fg.y), sum(gh.z, hf.z, fg.z), dot(f.normal, gh)});
}

}  // namespace sunder
