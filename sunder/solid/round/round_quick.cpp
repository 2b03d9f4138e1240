#include <sunder/solid/round/round_balls.h>
#include <sunder/solid/round/round_newton.h>
#include <sunder/solid/round/round_quick.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

namespace sunder::solid {

namespace round_quick {

namespace {

constexpr int most_steps = 20, most_searched = 30;

class Quick {
 public:
  explicit Quick(Proposals& pair) : pair_(pair), a_(pair.a), b_(pair.b) {}

  bool run() {
    if (!(a_.image.is_tame && b_.image.is_tame)) return false;
    const bool first = a_.is_ball() || (a_.is_capsule() && !b_.is_ball());
    if (first || b_.is_ball() || b_.is_capsule()) {
      const Side &own = first ? a_ : b_, &other = first ? b_ : a_;
      if (has_nearest(other)) return own.is_ball() ? ball(own, other) : capsule(own, other);
    }
    const bool found = search();
    conclude(pair_.answer(), pair_.exact());
    return found;
  }

 private:
  bool ball(const Side& own, const Side& other) {
    const Nearest centre{own.image.from, {1, {0}, {1}}};
    return pair_.settles(own, centre, other, nearest_in(other, centre.at));
  }

  // A ball that moves along the axis: its distance is convex. Where it is least: by the false position, as Illinois
  // has it. Source: Dowell and Jarratt 1971.
  bool capsule(const Side& own, const Side& other) {
    const RoundImage& image = own.image;
    const double length2 = dot(image.axis, image.axis);
    if (!(length2 > 0)) return false;
    // By how much the square of the distance grows, half of it.
    const auto look = [&](double t) {
      ++pair_.answer().cost.iterations;
      const Nearest p = on_segment(image, t), q = nearest_in(other, p.at);
      const double growth = dot(p.at - q.at, image.axis);
      const bool held = pair_.settles(own, p, other, q);
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

  // Gilbert, Johnson and Keerthi's search, and Newton's method where it has come near.
  bool search() {
    const V middle_a = a_.middle(), middle_b = b_.middle(), first = middle_b - middle_a;
    return pair_.parts(first) || pair_.meets_near(a_, b_, middle_b) || pair_.meets_near(b_, a_, middle_a) ||
           walk(first) || pair_.alternates(sum(middle_a, 0.5, first));
  }

  bool walk(const V& first) {
    const double reach = a_.radius() + b_.radius();
    DifferenceSimplex simplex;
    Slots slots;
    Point3 direction = point(first);
    double distance2 = 0, nearest2 = HUGE_VAL;
    if (!(sunder::solid::dot(direction, direction) > 0)) direction = {1, 0, 0};
    for (int i = 0; i < most_searched; ++i) {
      ++pair_.answer().cost.iterations;
      const V d = vector(direction);
      std::uint32_t free = 0;
      const auto is_used = [&](std::uint32_t slot) {
        for (int k = 0; k < simplex.count; ++k) {
          if (simplex.vertex[static_cast<std::size_t>(k)].a == slot) return true;
        }
        return false;
      };
      while (is_used(free)) ++free;
      auto& [p, q] = slots[free];
      p = far_along(a_, d);
      q = far_along(b_, {-d.x, -d.y, -d.z});
      const V w = p.at - q.at;
      const double gap = -dot(d, w), length2 = dot(d, d);
      if (gap > 0 && gap * gap > reach * reach * length2 && pair_.parts(d)) return true;
      const bool is_new =
          simplex.count == 0 || dot(d, w - vector(simplex.vertex[0].at)) > 0x1p-50 * pair_.size * std::sqrt(length2);
      if (!is_new) return refine(pair_, simplex, slots, d);
      simplex.vertex[static_cast<std::size_t>(simplex.count++)] = {point(w), free, free};
      const bool is_outside = reduce_to_closest_face(simplex, direction, distance2) && distance2 > 0;
      if (!is_outside || distance2 < reach * reach) {
        if (meets_at(simplex, slots)) return true;
      }
      if (!is_outside || !(distance2 < nearest2)) return refine(pair_, simplex, slots, d);
      nearest2 = distance2;
      if (i >= 3 && i % 2 == 1 && refine(pair_, simplex, slots, vector(direction))) return true;
    }
    return false;
  }

  // The points that the simplex makes.
  bool meets_at(const DifferenceSimplex& simplex, const Slots& slots) {
    const std::array<double, 4> weights = weights_of_nearest(simplex);
    double total = 0;
    const std::size_t n = static_cast<std::size_t>(simplex.count);
    for (std::size_t k = 0; k < n; ++k) total += std::max(weights[k], 0.0);
    if (!(total > 0)) return false;
    Nearest p{}, q{};
    for (std::size_t k = 0; k < n; ++k) {
      if (!(weights[k] > 0)) continue;
      const auto& [of_a, of_b] = slots[simplex.vertex[k].a];
      Proposals::add(a_, p, of_a, weights[k] / total);
      Proposals::add(b_, q, of_b, weights[k] / total);
    }
    return pair_.holds(p, q);
  }

  Proposals& pair_;
  const Side &a_, &b_;
};

}  // namespace

}  // namespace round_quick

bool decide_quickly(const RoundBody& a, const Pose& pose_a, const RoundBody& b, const Pose& pose_b, RoundAnswer& answer,
                    Point3& way) {
  const bool ball_a = round_quick::is_ball(a), ball_b = round_quick::is_ball(b);
  if (ball_a && ball_b) return round_quick::balls(a, pose_a, b, pose_b, answer, way);
  if ((ball_a || ball_b) && round_quick::ball_and(a, pose_a, b, pose_b, answer, way)) return true;
  const round_quick::Side of_a(a, pose_a), of_b(b, pose_b);
  round_quick::Proposals pair(of_a, of_b, answer, way);
  return round_quick::Quick(pair).run();
}

}  // namespace sunder::solid
