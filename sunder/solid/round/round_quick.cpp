#include <sunder/solid/round/round_balls.h>
#include <sunder/solid/round/round_newton.h>
#include <sunder/solid/round/round_quick.h>
#include <sunder/solid/search/gjk.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

namespace sunder::solid {

namespace round_quick {

namespace {

constexpr int most_steps = 20, most_searched = 30;

// Both bodies, in doubles; a hull's radius is left out. `size`: of both.
struct QuickSupport {
  QuickSupport(const Side& of_a, const Side& of_b, const double& of_both) : a(of_a), b(of_b), size(of_both) {}

  const Side& a;
  const Side& b;
  double size, scale = 1;
  Slots slots;
  V direction{};  // the last that was asked about

  static Point3 first_direction() { return {1, 0, 0}; }
  DifferenceVertex furthest(const Point3& d, const DifferenceSimplex& simplex, Cost&) {
    direction = vector(d);
    const std::uint32_t free = free_slot(simplex);
    auto& [p, q] = slots[free];
    p = far_along(a, direction);
    q = far_along(b, negated(direction));
    return {point(p.at - q.at), free, free};
  }
  static bool are_same(const DifferenceVertex&, const DifferenceVertex&) { return false; }
  double noise(const Point3& d, const DifferenceVertex&) const {
    return 0x1p-50 * size * std::sqrt(sunder::solid::dot(d, d));
  }
  static double noise2(const DifferenceVertex&) { return 0; }
  static bool is_coarse() { return false; }
  static void refine() {}
};

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
    const Nearest centre{own.image.from, {{0}, {1}}};
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
    Gjk<double, QuickSupport> search(a_, b_, pair_.size);
    const Slots& slots = search.support.slots;
    const V& d = search.support.direction;
    const double reach = a_.radius() + b_.radius();
    search.begin(point(first));
    const auto on_vertex = [&](const DifferenceVertex& w) {
      const double gap = search.gap_at(w);
      return gap > 0 && gap * gap > reach * reach * dot(d, d) && pair_.parts(d);
    };
    int steps = 0;
    const auto on_step = [&](bool is_nearer) {
      if (search.distance2 < reach * reach && meets_at(search.simplex, slots)) return true;
      ++steps;
      return is_nearer && steps >= 4 && steps % 2 == 0 &&
             refine(pair_, search.simplex, slots, vector(search.direction));
    };
    switch (search.run({most_searched, 1}, pair_.answer().cost, on_vertex, on_step)) {
      case GjkEnd::stopped: return true;
      case GjkEnd::too_long: return false;
      case GjkEnd::inside:
        if (meets_at(search.simplex, slots)) return true;
        break;
      case GjkEnd::no_gain:
      case GjkEnd::circling: break;
    }
    return refine(pair_, search.simplex, slots, d);
  }

  // The points that the simplex makes.
  bool meets_at(const DifferenceSimplex& simplex, const Slots& slots) {
    const auto mean = mean_nearest(simplex);
    if (!mean) return false;
    Nearest p{}, q{};
    for (const auto& [slot, weight] : *mean) {
      const auto& [of_a, of_b] = slots[slot];
      Proposals::add(a_, p, of_a, weight / mean->total);
      Proposals::add(b_, q, of_b, weight / mean->total);
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
