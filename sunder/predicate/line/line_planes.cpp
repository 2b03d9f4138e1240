#include <sunder/predicate/filter/stages.h>
#include <sunder/predicate/line/line_planes.h>

#include <algorithm>
#include <cmath>

namespace sunder {

namespace {

// (b - a) x (c - a) . (d - a), as orient_3d: the first two differences are given.
template <class D, class P, class Q>
auto around(const D& d, const P& to_p, const Q& to_q) {
  return dot(cross(d, to_p), to_q);
}

template <class Stage>
auto normal(const PosedTriangle& t) {
  const auto from = lift<Stage>(t[0]);
  return cross(lift<Stage>(t[1]) - from, lift<Stage>(t[2]) - from);
}

constexpr auto facing_formula = [](const auto& a, const auto& b, const auto& u, const auto& v, const auto& w) {
  return dot(cross(v - u, w - u), b - a);
};

// Products of up to seven numbers: each is a coordinate of the line or of an image, or a difference of two, at most
// 2^62 in size. A product that underflows is off by at most 2^-1075, times at most 2^372 for what it is multiplied by:
// all of them together by less than 2^-600. Nothing overflows.
constexpr double most_coordinate = 0x1p60, underflow = 0x1p-600;

bool is_small(const Point3& p) { return std::max({std::fabs(p.x), std::fabs(p.y), std::fabs(p.z)}) <= most_coordinate; }
bool are_small(const PosedTriangle& t) {
  // The reach bounds products and the translation, of which an image is a sum of four.
  return std::max({t[0].reach, t[1].reach, t[2].reach}) <= most_coordinate / 4;
}

template <int K>
Guess sign_above_underflow(const Rounded<K>& x) {
  const double error = Rounded<K>::bound * x.magnitude + underflow;
  return x.value > error ? Guess::positive : x.value < -error ? Guess::negative : Guess::unsure;
}

template <class Stage>
auto first_and_second(const Point3& a, const Point3& b, const PosedTriangle& f, const PosedTriangle& g) {
  const auto from = lift<Stage>(a);
  const auto d = lift<Stage>(b) - from;
  const auto n_f = normal<Stage>(f), n_g = normal<Stage>(g);
  const auto f_d = dot(n_f, d), g_d = dot(n_g, d);
  const auto beyond = dot(n_f, from - lift<Stage>(f[0])) * g_d - dot(n_g, from - lift<Stage>(g[0])) * f_d;
  struct Result {
    std::remove_const_t<decltype(f_d)> facing_f;
    std::remove_const_t<decltype(g_d)> facing_g;
    std::remove_const_t<decltype(beyond)> further;
  };
  return Result{f_d, g_d, beyond};
}

}  // namespace

std::array<Sign, 3> turns_about_line(const Point3& a, const Point3& b, const PosedTriangle& t, StageTally* tally) {
  if (is_tame(a) && is_tame(b) && is_tame(t[0]) && is_tame(t[1]) && is_tame(t[2])) {
    const auto from = lift<RoundedStage>(a);
    const auto d = lift<RoundedStage>(b) - from;
    const auto p = lift<RoundedStage>(t[0]) - from, q = lift<RoundedStage>(t[1]) - from,
               r = lift<RoundedStage>(t[2]) - from;
    const Guess pq = sign(around(d, p, q)), qr = sign(around(d, q, r)), rp = sign(around(d, r, p));
    if (is_sure(pq) && is_sure(qr) && is_sure(rp)) {
      if (tally != nullptr) tally->rounded += 3;
      return {to_sign(pq), to_sign(qr), to_sign(rp)};
    }
  }
  return {decide(tally, orient_3d_formula, a, b, t[0], t[1]), decide(tally, orient_3d_formula, a, b, t[1], t[2]),
          decide(tally, orient_3d_formula, a, b, t[2], t[0])};
}

Sign facing(const Point3& a, const Point3& b, const PosedTriangle& t, StageTally* tally) {
  return decide(tally, facing_formula, a, b, t[0], t[1], t[2]);
}

LineAndPlanes line_and_planes(const Point3& a, const Point3& b, const PosedTriangle& f, const PosedTriangle& g,
                              StageTally* tally) {
  if (is_small(a) && is_small(b) && are_small(f) && are_small(g)) {
    const auto found = first_and_second<RoundedStage>(a, b, f, g);
    const Guess of_f = sign_above_underflow(found.facing_f), of_g = sign_above_underflow(found.facing_g),
                beyond = sign_above_underflow(found.further);
    if (is_sure(of_f) && is_sure(of_g) && is_sure(beyond)) {
      if (tally != nullptr) tally->rounded += 3;
      return {to_sign(of_f), to_sign(of_g), to_sign(beyond)};
    }
  }
  const Guess guess = sign(first_and_second<IntervalStage>(a, b, f, g).further);
  const Sign beyond = is_sure(guess)
                          ? counted(&StageTally::interval, tally, to_sign(guess))
                          : counted(&StageTally::exact, tally, first_and_second<ExactStage>(a, b, f, g).further.sign());
  return {facing(a, b, f, tally), facing(a, b, g, tally), beyond};
}

}  // namespace sunder
