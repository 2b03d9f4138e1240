#include <sunder/predicate/disc/round_image.h>
#include <sunder/predicate/disc/round_shape.h>
#include <sunder/solid/round/round_proposals.h>

#include <algorithm>
#include <cmath>

namespace sunder::solid::round_quick {

namespace {

constexpr int most_alternated = 16;
constexpr Affine3 in_place{};

RoundShape shape(const Side& side) {
  RoundShape made{side.image.kind, {}, &side.pose, side.image.radius};
  const std::span<const Point3> points = side.body.points();
  std::copy(points.begin(), points.end(), made.points.begin());
  return made;
}

}  // namespace

void Proposals::add(const Side& side, Nearest& made, const Far& far, double weight) {
  made.at = sum(made.at, weight, far.at);
  if (side.is_curved()) return;
  for (std::size_t k = 0; k < made.made.count(); ++k) {
    if (made.made.vertices[k] != far.piece) continue;
    made.made.weights[k] += weight;
    return;
  }
  put(made.made, far.piece, weight);
}

bool Proposals::meets_near(const Side& own, const Side& other, const V& middle) {
  if (!other.is_curved()) return false;
  if (own.is_box()) return holds(own, in_box(own, middle), other, {middle});
  if (!own.is_curved()) return false;
  const Nearest found = own.image.kind == RoundKind::ellipsoid ? in_ellipsoid(own, middle) : nearest_in(own, middle);
  return holds(sum(found.at, 0x1p-6, own.middle() - found.at));
}

bool Proposals::faces(const Side& own, const Side& other, const V& d) {
  const RoundImage& of = own.image;
  if (of.kind != RoundKind::cylinder && of.kind != RoundKind::cone) return false;
  const double along = dot(d, of.axis);
  if (along * along < 0.75 || (of.kind == RoundKind::cone && along > 0)) return false;
  const V out = along > 0 ? of.axis : V{-of.axis.x, -of.axis.y, -of.axis.z};
  const Far far = far_along(other, {-out.x, -out.y, -out.z});
  const V& centre = along > 0 ? of.to : of.from;
  const double gap = dot(far.at - centre, out);
  const V foot = sum(far.at, -gap, out), from = foot - centre;
  const double reach = own.radius() + other.radius();
  if (!(dot(from, from) <= of.radius * of.radius && gap >= -0x1p-10 * size)) return false;  // NaN too
  if (gap > reach) return parts(&own == &a ? out : V{-out.x, -out.y, -out.z});
  Nearest q{};
  add(other, q, far, 1);
  return &own == &a ? holds_thoroughly({foot}, q) : holds_thoroughly(q, {foot});
}

bool Proposals::alternates(V x) {
  const auto past = [](const Side& side, const V& from) {
    const V at = side.image.kind == RoundKind::ellipsoid ? in_ellipsoid(side, from).at : nearest_in(side, from).at;
    return sum(from, 1.5, at - from);
  };
  const bool hulls = !a.is_curved() || !b.is_curved();
  const Side &own = a.is_curved() ? b : a, &other = a.is_curved() ? a : b;
  if (hulls && !(own.is_box() && other.is_curved())) return false;
  for (int i = 0; i < most_alternated; ++i) {
    if (hulls) {
      const Nearest found = in_box(own, x);
      if (holds_core(own, found, other)) return true;
      x = past(other, found.at);
    } else {
      x = past(b, past(a, x));
      if (holds(x)) return true;
    }
  }
  return false;
}

bool Proposals::holds(const Nearest& p, const Nearest& q) {
  if (!a.is_curved()) return b.is_curved() ? holds(a, p, b, q) : settles(a, p, b, q);
  if (!b.is_curved()) return holds(b, q, a, p);
  const V way = p.at - q.at, middle_a = a.middle(), middle_b = b.middle(), between = sum(q.at, 0.5, way);
  if (holds(between)) return true;
  const double depth = length(way);
  const auto inwards = [&](const V& from, const V& to, double part) {
    const V in = to - from;
    const double deep = length(in);
    return sum(from, part > 0 ? part : deep > 0 ? std::min(0.5 * depth / deep, 0.5) : 0, in);
  };
  if (is_thorough_ && alternates(between)) return true;
  for (const double part : {0.0, 0x1p-6, 0x1p-24}) {
    if (holds(inwards(p.at, middle_a, part)) || holds(inwards(q.at, middle_b, part)) ||
        holds(inwards(between, sum(middle_a, 0.5, middle_b - middle_a), part))) {
      return true;
    }
  }
  return false;
}

bool Proposals::holds(const V& x) {
  ++answer_.cost.proposals;
  return is_inside(a, x) && is_inside(b, x) && is(PointInDoubles{point(x)});
}

bool Proposals::is_inside(const Side& side, const V& x) {
  if (!std::isfinite(x.x) || !std::isfinite(x.y) || !std::isfinite(x.z)) return false;
  const Guess guess = side_guess(side.image, x);
  if (is_sure(guess) || !is_thorough_) return guess == Guess::positive;
  return side_of(shape(side), {1, {Posed3{point(x), &in_place, false}}, {1}}, &tally_) == Sign::positive;
}

bool Proposals::holds(const Side& hull, const Nearest& p, const Side& curved, const Nearest& q) {
  if (p.made.count() == 0) return false;
  if (holds_core(hull, p, curved)) return true;
  const V way = q.at - p.at;
  const double far2 = dot(way, way);
  if (hull.radius() > 0) return far2 < hull.radius() * hull.radius() && settles(hull, p, curved, q);
  if (!hull.is_box()) return false;
  const V in = curved.middle() - q.at;
  const double deep = length(in), far = std::sqrt(far2);
  const auto inwards = [&](double part) { return holds_core(hull, in_box(hull, sum(q.at, part, in)), curved); };
  if (far > 0x1p-44 * size) return deep > 0 && inwards(std::min(0.5 * far / deep, 0.5));
  // The same point of both, which may be of the surface of the curved one.
  return inwards(0x1p-6) || inwards(0x1p-12) || inwards(0x1p-20);
}

bool Proposals::holds_core(const Side& hull, const Nearest& p, const Side& curved) {
  ++answer_.cost.proposals;
  const auto surely = [&] {
    WeightedPoint x;
    x.count = p.made.count();
    for (std::size_t k = 0; k < x.count; ++k) {
      x.points[k] = {hull.body.core().search_graph().vertices[p.made.vertices[k]], &hull.pose, false};
      x.weights[k] = p.made.weights[k];
    }
    return side_of(shape(curved), x, &tally_) == Sign::positive;
  };
  if (!is_whole(p)) return false;
  const Guess guess = side_guess(curved.image, p.at, hull.image.size);
  if (!(is_sure(guess) || !is_thorough_ ? guess == Guess::positive : surely())) return false;
  return is(PointOfCore{&hull == &a, p.made});
}

bool Proposals::holds_thoroughly(const Nearest& p, const Nearest& q) {
  is_thorough_ = true;
  const bool held = holds(p, q);
  is_thorough_ = false;
  return held;
}

}  // namespace sunder::solid::round_quick
