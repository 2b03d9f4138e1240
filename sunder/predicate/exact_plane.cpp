#include <sunder/predicate/exact_plane.h>

#include <sunder/base/contract.h>
#include <sunder/number/vector.h>

#include <algorithm>
#include <array>
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
  const bool has_x = n.x.sign() != Sign::zero, has_y = n.y.sign() != Sign::zero, has_z = n.z.sign() != Sign::zero;
  if (has_x + has_y + has_z == 1) {
    const auto of_length_1 = [](const Dyadic& x) { return Dyadic(static_cast<double>(static_cast<int>(x.sign()))); };
    n = {of_length_1(n.x), of_length_1(n.y), of_length_1(n.z)};
  }
  Dyadic offset = dot(n, p);
  return {std::move(n), std::move(offset)};
}

ExactPlane ExactPlane::seen_from(const Affine3& frame) const {
  const auto column = [&](std::size_t c) {
    const auto& m = frame.linear;
    return normal.x * Dyadic(m[c]) + normal.y * Dyadic(m[3 + c]) + normal.z * Dyadic(m[6 + c]);
  };
  const auto& t = frame.translation;
  const Vector3<Dyadic> move{t[0], t[1], t[2]};
  return {{column(0), column(1), column(2)}, offset - dot(normal, move)};
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

namespace {

// Over a denominator.
template <class Number>
struct Common {
  Vector3<Number> numerators;
  Number denominator;
};

template <class Number>
Common<Number> cramer(const std::array<Vector3<Number>, 3>& normals, const std::array<Number, 3>& offsets) {
  const auto& [f, g, h] = normals;
  const Vector3<Number> gh = cross(g, h), hf = cross(h, f), fg = cross(f, g);
  const auto sum = [&](const Number& x, const Number& y, const Number& z) {
    return offsets[0] * x + offsets[1] * y + offsets[2] * z;
  };
  return {{sum(gh.x, hf.x, fg.x), sum(gh.y, hf.y, fg.y), sum(gh.z, hf.z, fg.z)}, dot(f, gh)};
}

std::optional<Vector3<Interval>> ratio(const Vector3<Interval>& v, const Interval& w) {
  if (!is_sure(sign(w)) || sign(w) == Guess::zero) return std::nullopt;
  return Vector3<Interval>{v.x / w, v.y / w, v.z / w};
}

}  // namespace

EnclosedPoint common_point(const ExactPlane& f, const ExactPlane& g, const ExactPlane& h) {
  const auto [at, denominator] = cramer<Dyadic>({f.normal, g.normal, h.normal}, {f.offset, g.offset, h.offset});
  return EnclosedPoint(exact_point(at, denominator));
}

std::optional<Vector3<Interval>> crossing_about(const ExactPlane& plane, const Vector3<Interval>& p,
                                                const Vector3<Interval>& q) {
  const auto height = [&](const Vector3<Interval>& x) { return dot(plane.normal_about, x) - plane.offset_about; };
  const Interval s = height(p), t = height(q);
  return ratio({s * q.x - t * p.x, s * q.y - t * p.y, s * q.z - t * p.z}, s - t);
}

std::optional<Vector3<Interval>> common_point_about(const ExactPlane& f, const ExactPlane& g, const ExactPlane& h) {
  const auto [at, denominator] = cramer<Interval>({f.normal_about, g.normal_about, h.normal_about},
                                                  {f.offset_about, g.offset_about, h.offset_about});
  return ratio(at, denominator);
}

}  // namespace sunder
