#include <sunder/predicate/disc/round_image.h>
#include <sunder/predicate/disc/round_shape.h>
#include <sunder/predicate/point/along.h>
#include <sunder/solid/round/round_proposals.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace sunder::solid::round_quick {

namespace {

constexpr int most_alternated = 16, most_steps = 20;
constexpr Affine3 in_place{};

bool is_ball(const RoundBody& body) { return !body.is_curved() && body.ends().size() == 1; }

RoundImage image_of_ball(const RoundBody& ball, const Pose& pose) {
  return ball_image(image_of(pose.affine(), ball.ends()[0]), ball.radius(), size_of(ball, pose));
}

// out: from the other body towards the ball.
bool parts_ball(const V& out, const RoundImage& ball, bool is_a, const RoundImage& other, RoundAnswer& answer,
                Point3& way) {
  return is_a ? parts({-out.x, -out.y, -out.z}, ball, other, answer, way) : parts(out, other, ball, answer, way);
}

// From a box to a point of its frame, which is as long as the world's.
V beyond_box(const RoundBody& of, const V& x) {
  const auto beyond = [](double along, double low, double high) { return along - std::clamp(along, low, high); };
  if (const AxisBox* box = of.axis_box()) {
    const auto& [low, high] = box->range;
    return {beyond(x.x, low.x, high.x), beyond(x.y, low.y, high.y), beyond(x.z, low.z, high.z)};
  }
  const RoundBox& box = *of.box();
  V way{0, 0, 0};
  for (std::size_t k = 0; k < 3; ++k) {
    const V half = vector(box.half[k]);
    way = sum(way, beyond(dot(x - vector(box.middle), half) * box.over_half2[k], -1.0, 1.0), half);
  }
  return way;
}

bool ball_and_box(const RoundImage& ball, bool is_a, const Side& box, RoundAnswer& answer, Point3& way) {
  const V beyond = beyond_box(box.body, box.pulled(ball.from - box.translation()));
  const double reach = ball.radius + box.image.radius;
  if (dot(beyond, beyond) > reach * reach) return parts_ball(box.turned(beyond), ball, is_a, box.image, answer, way);
  ++answer.cost.proposals;
  const Nearest found = in_box(box, ball.from);
  if (nearness_guess(ball.from, found.at, reach, ball.size + box.image.size) != Guess::positive) return false;
  const RoundCombination centre{{0}, {1}};
  answer.evidence = is_a ? PointBetweenCores{centre, found.made} : PointBetweenCores{found.made, centre};
  return true;
}

// In the half plane of the axis and the centre of the ball. A proposal waits for one root and no quotient: so what is
// along the axis and across it comes times the square of the axis, as it is.
bool ball_and_cylinder(const RoundImage& ball, bool is_a, const RoundImage& of, RoundAnswer& answer, Point3& way) {
  const V axis = of.to - of.from, from = ball.from - of.from;
  const double whole = dot(axis, axis), along = dot(from, axis);
  const V across{whole * from.x - along * axis.x, whole * from.y - along * axis.y, whole * from.z - along * axis.z};
  const double out = length(across), rim = whole * of.radius, reach = whole * ball.radius;
  const double far_along = along - std::clamp(along, 0.0, whole), far_out = std::max(out - rim, 0.0);
  const double far2 = whole * far_along * far_along + far_out * far_out;
  if (far2 > reach * reach) {
    const double up = far_out > 0 ? far_along * out : far_along;
    const V d{up * axis.x + far_out * across.x, up * axis.y + far_out * across.y, up * axis.z + far_out * across.z};
    return parts_ball(d, ball, is_a, of, answer, way);
  }
  // A point that is inside of the cylinder by a part of what is left over.
  const double over = 1 / whole,
               in = 0.25 * std::min(ball.radius - over * std::sqrt(far2), std::min(of.length, of.radius));
  const double in_along = in * of.length * over, by = std::min((of.radius - in) / out, over);
  const V x = sum(sum(of.from, std::clamp(over * along, in_along, 1 - in_along), axis), by, across);
  ++answer.cost.proposals;
  if (!(side_guess(of, x) == Guess::positive &&
        nearness_guess(ball.from, x, ball.radius, ball.size) == Guess::positive)) {
    return false;
  }
  PointInDoubles& found = answer.evidence.emplace<PointInDoubles>(PointInDoubles{point(x)});
  (is_a ? found.of_a : found.of_b) = {{0}, {1}};
  return true;
}

// Two balls.
bool balls(const RoundBody& a, const Pose& pose_a, const RoundBody& b, const Pose& pose_b, RoundAnswer& answer,
           Point3& way) {
  const RoundImage p = image_of_ball(a, pose_a), q = image_of_ball(b, pose_b);
  way = point(q.from - p.from);
  answer.cost.proposals = 1;
  switch (nearness_guess(p.from, q.from, a.radius() + b.radius(), p.size + q.size)) {
    case Guess::positive:
      answer.evidence.emplace<PointBetweenCores>(
          PointBetweenCores{RoundCombination{{0}, {1}}, RoundCombination{{0}, {1}}});
      return true;
    case Guess::negative:
      if (!make_tame(way)) return false;
      answer.evidence.emplace<SeparatingDirection>(SeparatingDirection{way});
      return true;
    default: return false;
  }
}

// Of others than boxes and cylinders nothing is said.
bool ball_and(bool is_a, const RoundBody& a, const Pose& pose_a, const RoundBody& b, const Pose& pose_b,
              RoundAnswer& answer, Point3& way) {
  const RoundBody &own = is_a ? a : b, &body = is_a ? b : a;
  const Pose &own_pose = is_a ? pose_a : pose_b, &pose = is_a ? pose_b : pose_a;
  if (body.kind() == RoundKind::cylinder) {
    const RoundImage ball = image_of_ball(own, own_pose);
    RoundImage cylinder;
    set_image(cylinder, RoundKind::cylinder, pose.affine(), body.ends().data(), 2, body.radius(), size_of(body, pose),
              pose.linear_range().greatest);
    return ball.is_tame && cylinder.is_tame && ball_and_cylinder(ball, is_a, cylinder, answer, way);
  }
  if (!(body.box() != nullptr && pose.is_rigid())) return false;
  const RoundImage ball = image_of_ball(own, own_pose);
  const Side box(body, pose);
  return ball.is_tame && box.image.is_tame && ball_and_box(ball, is_a, box, answer, way);
}

}  // namespace

std::optional<bool> decide_of_ball(const RoundBody& a, const Pose& pose_a, const RoundBody& b, const Pose& pose_b,
                                   RoundAnswer& answer, Point3& way) {
  const bool ball_a = is_ball(a), ball_b = is_ball(b);
  if (ball_a && ball_b) return balls(a, pose_a, b, pose_b, answer, way);
  if ((ball_a || ball_b) && ball_and(ball_a, a, pose_a, b, pose_b, answer, way)) return true;
  return std::nullopt;
}

bool parts(const V& direction, const RoundImage& a, const RoundImage& b, RoundAnswer& answer, Point3& way) {
  ++answer.cost.proposals;
  Point3 d = point(direction);
  if (!make_tame(d)) return false;
  way = d;
  if (gap_guess(vector(d), a, b) != Guess::positive) return false;
  answer.evidence.emplace<SeparatingDirection>(SeparatingDirection{d});
  return true;
}

std::optional<bool> Proposals::by_nearest_points() {
  const bool first = a.is_ball() || (a.is_capsule() && !b.is_ball());
  const Side &own = first ? a : b, &other = first ? b : a;
  if (!(own.is_ball() || own.is_capsule()) || !has_nearest(other)) return std::nullopt;
  if (own.is_capsule()) return capsule(own, other);
  const Nearest centre{own.image.from, {{0}, {1}}};
  return settles(own, centre, other, nearest_in(other, centre.at));
}

bool Proposals::capsule(const Side& own, const Side& other) {
  const RoundImage& image = own.image;
  const double length2 = dot(image.axis, image.axis);
  if (!(length2 > 0)) return false;
  // By how much the square of the distance grows, half of it.
  const auto look = [&](double t) {
    ++answer_.cost.iterations;
    const Nearest p = on_segment(image, t), q = nearest_in(other, p.at);
    const double growth = dot(p.at - q.at, image.axis);
    const bool held = settles(own, p, other, q);
    return std::pair(growth, held);
  };
  if (other.is_capsule()) return look(nearest_of_segments(image, other.image)).second;
  double t = std::clamp(dot(other.middle() - image.from, image.axis) / length2, 0.0, 1.0);
  double low = 0, high = 1, of_low = 0, of_high = 0;  // the growth there; 0: not known
  int last = 0;
  for (int i = 0; i < most_steps; ++i) {
    const auto [growth, held] = look(t);
    if (held) return true;
    if (growth == 0) return false;
    if (growth > 0) {
      if (t == 0) return false;
      high = t;
      of_high = growth;
      if (last > 0) of_low /= 2;
      last = 1;
    } else {
      if (t == 1) return false;
      low = t;
      of_low = growth;
      if (last < 0) of_high /= 2;
      last = -1;
    }
    const double next = of_low == 0 ? 0 : of_high == 0 ? 1 : low + (high - low) * (of_low / (of_low - of_high));
    if (next == t || !(next >= low && next <= high)) return false;
    t = next;
  }
  return false;
}

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
  const Nearest found = nearest_or_towards(own, middle);
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
    return sum(from, 1.5, nearest_or_towards(side, from).at - from);
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
  return side_of(shape_of(side.body, side.pose), {1, {Posed3{point(x), &in_place, false}}, {1}}, &tally_) ==
         Sign::positive;
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
    return side_of(shape_of(curved.body, curved.pose), x, &tally_) == Sign::positive;
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
