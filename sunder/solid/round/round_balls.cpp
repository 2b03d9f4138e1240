#include <sunder/predicate/point/along.h>
#include <sunder/solid/round/round_balls.h>

#include <algorithm>
#include <cmath>

namespace sunder::solid::round_quick {

namespace {

RoundImage image_of_ball(const RoundBody& ball, const Pose& pose) {
  return ball_image(image_of(pose.affine(), ball.ends()[0]), ball.radius(), size_of(ball, pose));
}

class BallAndBox {
 public:
  BallAndBox(const RoundImage& ball, bool is_a, const Side& other, RoundAnswer& answer, Point3& way)
      : ball_(ball), is_a_(is_a), other_(other), answer_(answer), way_(way) {}

  // In the frame of the box, which is as long as the world's.
  bool decide() {
    const V beyond = beyond_box(other_.pulled(ball_.from - other_.translation()));
    const double reach = ball_.radius + other_.image.radius;
    if (dot(beyond, beyond) > reach * reach) return parts_from_other(other_.turned(beyond));
    ++answer_.cost.proposals;
    const Nearest found = in_box(other_, ball_.from);
    if (nearness_guess(ball_.from, found.at, reach, size()) != Guess::positive) return false;
    const RoundCombination centre{{0}, {1}};
    answer_.evidence = is_a_ ? PointBetweenCores{centre, found.made} : PointBetweenCores{found.made, centre};
    return true;
  }

 private:
  // From the box to a point of its frame.
  V beyond_box(const V& x) const {
    const auto beyond = [](double along, double low, double high) { return along - std::clamp(along, low, high); };
    if (const AxisBox* box = other_.body.axis_box()) {
      const auto& [low, high] = box->range;
      return {beyond(x.x, low.x, high.x), beyond(x.y, low.y, high.y), beyond(x.z, low.z, high.z)};
    }
    const RoundBox& box = *other_.body.box();
    V way{0, 0, 0};
    for (std::size_t k = 0; k < 3; ++k) {
      const V half = vector(box.half[k]);
      way = sum(way, beyond(dot(x - vector(box.middle), half) * box.over_half2[k], -1.0, 1.0), half);
    }
    return way;
  }
  bool parts_from_other(const V& way) {
    return is_a_ ? parts({-way.x, -way.y, -way.z}, ball_, other_.image, answer_, way_)
                 : parts(way, other_.image, ball_, answer_, way_);
  }
  double size() const { return ball_.size + other_.image.size; }

  const RoundImage& ball_;
  bool is_a_;
  const Side& other_;
  RoundAnswer& answer_;
  Point3& way_;
};

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
    return is_a ? parts({-d.x, -d.y, -d.z}, ball, of, answer, way) : parts(d, of, ball, answer, way);
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

}  // namespace

bool parts(const V& direction, const RoundImage& a, const RoundImage& b, RoundAnswer& answer, Point3& way) {
  ++answer.cost.proposals;
  Point3 d = point(direction);
  if (!make_tame(d)) return false;
  way = d;
  if (gap_guess(vector(d), a, b) != Guess::positive) return false;
  answer.evidence.emplace<SeparatingDirection>(SeparatingDirection{d});
  return true;
}

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

bool ball_and(const RoundBody& a, const Pose& pose_a, const RoundBody& b, const Pose& pose_b, RoundAnswer& answer,
              Point3& way) {
  const bool is_a = is_ball(a);
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
  return ball.is_tame && box.image.is_tame && BallAndBox(ball, is_a, box, answer, way).decide();
}

}  // namespace sunder::solid::round_quick
