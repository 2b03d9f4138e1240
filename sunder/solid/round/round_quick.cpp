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

constexpr int most_searched = 30;

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
    if (const auto told = pair_.by_nearest_points()) return *told;
    const bool found = search();
    conclude(pair_.answer(), pair_.exact());
    return found;
  }

 private:
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
  if (const auto told = round_quick::decide_of_ball(a, pose_a, b, pose_b, answer, way)) return *told;
  const round_quick::Side of_a(a, pose_a), of_b(b, pose_b);
  round_quick::Proposals pair(of_a, of_b, answer, way);
  return round_quick::Quick(pair).run();
}

}  // namespace sunder::solid
