// long because: each step of the search is a few lines that share the bodies, the answer and what is left to try.
#include <sunder/predicate/round_image.h>
#include <sunder/predicate/round_shape.h>
#include <sunder/solid/pair/closest_simplex.h>
#include <sunder/solid/round/round_balls.h>
#include <sunder/solid/round/round_pieces.h>
#include <sunder/solid/round/round_quick.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <utility>

namespace sunder::solid {

namespace round_quick {

namespace {

class Quick {
 public:
  Quick(const Side& a, const Side& b, RoundAnswer& answer, Point3& way)
      : a_(a), b_(b), answer_(answer), way_(way), size_(a.image.size + b.image.size) {}

  bool run() {
    if (!(a_.image.is_tame && b_.image.is_tame)) return false;
    const bool first = a_.is_ball() || (a_.is_capsule() && !b_.is_ball());
    if (first || b_.is_ball() || b_.is_capsule()) {
      const Side &own = first ? a_ : b_, &other = first ? b_ : a_;
      if (has_nearest(other)) return own.is_ball() ? ball(own, other) : capsule(own, other);
    }
    const bool found = search();
    conclude(answer_, tally_.exact);
    return found;
  }

 private:
  bool ball(const Side& own, const Side& other) {
    const Nearest centre{own.image.from, {1, {0}, {1}}};
    return settles(own, centre, other, nearest_in(other, centre.at));
  }

  // A ball that moves along the axis: its distance is convex. Where it is least: by the false position, as Illinois
  // has it. Source: Dowell and Jarratt 1971.
  bool capsule(const Side& own, const Side& other) {
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

  // Gilbert, Johnson and Keerthi's search, and Newton's method where it has come near.
  bool search() {
    const V middle_a = a_.middle(), middle_b = b_.middle(), first = middle_b - middle_a;
    return parts(first) || meets_near(a_, b_, middle_b) || meets_near(b_, a_, middle_a) || walk(first) ||
           alternates(sum(middle_a, 0.5, first));
  }

  bool walk(const V& first) {
    const double reach = a_.radius() + b_.radius();
    DifferenceSimplex simplex;
    std::array<std::pair<Far, Far>, 5> slots;
    Point3 direction = point(first);
    double distance2 = 0, nearest2 = HUGE_VAL;
    if (!(sunder::solid::dot(direction, direction) > 0)) direction = {1, 0, 0};
    for (int i = 0; i < most_searched; ++i) {
      ++answer_.cost.iterations;
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
      if (gap > 0 && gap * gap > reach * reach * length2 && parts(d)) return true;
      const bool is_new =
          simplex.count == 0 || dot(d, w - vector(simplex.vertex[0].at)) > 0x1p-50 * size_ * std::sqrt(length2);
      if (!is_new) return refine(simplex, slots, d);
      simplex.vertex[static_cast<std::size_t>(simplex.count++)] = {point(w), free, free};
      const bool is_outside = reduce_to_closest_face(simplex, direction, distance2) && distance2 > 0;
      if (!is_outside || distance2 < reach * reach) {
        if (meets_at(simplex, slots)) return true;
      }
      if (!is_outside || !(distance2 < nearest2)) return refine(simplex, slots, d);
      nearest2 = distance2;
      if (i >= 3 && i % 2 == 1 && refine(simplex, slots, vector(direction))) return true;
    }
    return false;
  }

  using Slots = std::array<std::pair<Far, Far>, 5>;

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
      add(a_, p, of_a, weights[k] / total);
      add(b_, q, of_b, weights[k] / total);
    }
    return holds(p, q);
  }

  // Is the point in doubles that of the combination, whose weights are over their sum? (round_image.h)
  static bool is_whole(const Nearest& p) {
    double total = 0;
    for (std::size_t k = 0; k < p.made.count; ++k) total += p.made.weights[k];
    return std::fabs(total - 1) <= 0x1p-50;
  }

  static void add(const Side& side, Nearest& made, const Far& far, double weight) {
    made.at = sum(made.at, weight, far.at);
    if (side.is_curved()) return;
    for (std::size_t k = 0; k < made.made.count; ++k) {
      if (made.made.vertices[k] != far.piece) continue;
      made.made.weights[k] += weight;
      return;
    }
    put(made.made, far.piece, weight);
  }

  // Does the point of `own` that is nearest to the other's middle lie in the other?
  bool meets_near(const Side& own, const Side& other, const V& middle) {
    if (!other.is_curved()) return false;
    if (own.is_box()) return holds(own, in_box(own, middle), other, {middle});
    if (!own.is_curved()) return false;
    const Nearest found = own.image.kind == RoundKind::ellipsoid ? in_ellipsoid(own, middle) : nearest_in(own, middle);
    return holds(sum(found.at, 0x1p-6, own.middle() - found.at));
  }

  // Is it the base or the top, flat, that faces the other? d: about, from `own` on, of length 1.
  bool faces(const Side& own, const Side& other, const V& d) {
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
    if (!(dot(from, from) <= of.radius * of.radius && gap >= -0x1p-10 * size_)) return false;  // NaN too
    if (gap > reach) return parts(&own == &a_ ? out : V{-out.x, -out.y, -out.z});
    Nearest q{};
    add(other, q, far, 1);
    is_thorough_ = true;
    const bool held = &own == &a_ ? holds({foot}, q) : holds(q, {foot});
    is_thorough_ = false;
    return held;
  }

  // From body to body, and a little further than to the surface: where they overlap this comes to a common point, even
  // where sharp edges leave little room. Source: the method of alternating projections, Bregman 1965.
  bool alternates(V x) {
    const auto past = [](const Side& side, const V& from) {
      const V at = side.image.kind == RoundKind::ellipsoid ? in_ellipsoid(side, from).at : nearest_in(side, from).at;
      return sum(from, 1.5, at - from);
    };
    const bool hulls = !a_.is_curved() || !b_.is_curved();
    const Side &own = a_.is_curved() ? b_ : a_, &other = a_.is_curved() ? a_ : b_;
    if (hulls && !(own.is_box() && other.is_curved())) return false;
    for (int i = 0; i < most_alternated; ++i) {
      if (hulls) {
        const Nearest found = in_box(own, x);
        if (holds_core(own, found, other)) return true;
        x = past(other, found.at);
      } else {
        x = past(b_, past(a_, x));
        if (holds(x)) return true;
      }
    }
    return false;
  }

  // Do p of the core of A and q of that of B, which are nearest to each other or deepest in the other body, lead to a
  // common point?
  bool holds(const Nearest& p, const Nearest& q) {
    if (!a_.is_curved()) return b_.is_curved() ? holds(a_, p, b_, q) : settles(a_, p, b_, q);
    if (!b_.is_curved()) return holds(b_, q, a_, p);
    const V way = p.at - q.at, middle_a = a_.middle(), middle_b = b_.middle(), between = sum(q.at, 0.5, way);
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
  bool holds(const V& x) {
    ++answer_.cost.proposals;
    return is_inside(a_, x) && is_inside(b_, x) && meets(RoundEvidence::Source::point, point(x), {}, {});
  }
  bool is_inside(const Side& side, const V& x) {
    if (!std::isfinite(x.x) || !std::isfinite(x.y) || !std::isfinite(x.z)) return false;
    const Guess guess = side_guess(side.image, x);
    if (is_sure(guess) || !is_thorough_) return guess == Guess::positive;
    return side_of(shape(side), {1, {Posed3{point(x), &in_place, false}}, {1}}, &tally_) == Sign::positive;
  }
  static RoundShape shape(const Side& side) {
    RoundShape made{side.image.kind, {}, &side.pose, side.image.radius};
    const std::span<const Point3> points = side.body.points();
    std::copy(points.begin(), points.end(), made.points.begin());
    return made;
  }
  bool holds(const Side& hull, const Nearest& p, const Side& curved, const Nearest& q) {
    if (p.made.count == 0) return false;
    if (holds_core(hull, p, curved)) return true;
    const V way = q.at - p.at;
    const double far2 = dot(way, way);
    if (hull.radius() > 0) return far2 < hull.radius() * hull.radius() && settles(hull, p, curved, q);
    if (!hull.is_box()) return false;
    const V in = curved.middle() - q.at;
    const double deep = length(in), far = std::sqrt(far2);
    const auto inwards = [&](double part) { return holds_core(hull, in_box(hull, sum(q.at, part, in)), curved); };
    if (far > 0x1p-44 * size_) return deep > 0 && inwards(std::min(0.5 * far / deep, 0.5));
    // The same point of both, which may be of the surface of the curved one.
    return inwards(0x1p-6) || inwards(0x1p-12) || inwards(0x1p-20);
  }
  // Does the curved body hold a point of the hull's core?
  bool holds_core(const Side& hull, const Nearest& p, const Side& curved) {
    ++answer_.cost.proposals;
    const auto surely = [&] {
      WeightedPoint x;
      x.count = p.made.count;
      for (std::size_t k = 0; k < x.count; ++k) {
        x.points[k] = {hull.body.core().search_graph().vertices[p.made.vertices[k]], &hull.pose, false};
        x.weights[k] = p.made.weights[k];
      }
      return side_of(shape(curved), x, &tally_) == Sign::positive;
    };
    if (!is_whole(p)) return false;
    const Guess guess = side_guess(curved.image, p.at, hull.image.size);
    if (!(is_sure(guess) || !is_thorough_ ? guess == Guess::positive : surely())) return false;
    return &hull == &a_ ? meets(RoundEvidence::Source::of_a, {}, p.made, {})
                        : meets(RoundEvidence::Source::of_b, {}, {}, p.made);
  }

  // The direction along which the pieces that the simplex is of are furthest apart, or least deep in each other: where
  // the reaches of these are equal, by Newton's method, and the derivative of the gap vanishes along what is left of
  // the sphere.
  bool refine(const DifferenceSimplex& simplex, const Slots& slots, V d) {
    const double far = length(d);
    if (!(far > 0)) return false;
    d = {d.x / far, d.y / far, d.z / far};
    if (faces(a_, b_, d) || faces(b_, a_, {-d.x, -d.y, -d.z})) return true;
    Pieces of_a, of_b;
    const std::array<double, 4> weights = weights_of_nearest(simplex);
    for (std::size_t k = 0; k < static_cast<std::size_t>(simplex.count); ++k) {
      const auto& [p, q] = slots[simplex.vertex[k].a];
      admit(of_a, p, weights[k]);
      admit(of_b, q, weights[k]);
    }
    // Two may be equal to one another beside the first of each.
    while (of_a.count + of_b.count > 4) {
      const std::size_t k = of_a.least(), l = of_b.least();
      const bool is_of_a = of_b.count == 1 || (of_a.count > 1 && of_a.weight[k] < of_b.weight[l]);
      is_of_a ? of_a.drop(k) : of_b.drop(l);
    }
    double last2 = 0;  // the square of the step before this one, of the same pieces
    int changes = 0, turns = 0, wild = 0;
    bool has_looked = false, is_last = false;  // for pieces that reach further; d is as good as doubles can make it
    bool is_new = false;                       // a piece does not reach as far as the others yet: no weight tells
    for (int i = 0; i < most_refined; ++i) {
      const V back{-d.x, -d.y, -d.z};
      const auto& [s, t] = frame_across(d);
      const Turn turn_a = turn_of(a_, d, s, t), turn_b = turn_of(b_, back, s, t);
      turn_to(a_, of_a, turn_a.out);
      turn_to(b_, of_b, turn_b.out);
      const V way = of_a.at[0] - of_b.at[0];
      const double g_s = dot(way, s), g_t = dot(way, t), gap = -dot(way, d);
      // What has to be equal: rows.
      std::array<double, 2> row_s{}, row_t{}, off{};
      std::size_t rows = 0;
      const auto demand = [&](const V& more) {
        row_s[rows] = dot(more, s);
        row_t[rows] = dot(more, t);
        off[rows++] = dot(more, d);
      };
      for (std::size_t k = 1; k < of_a.count; ++k) demand(of_a.at[k] - of_a.at[0]);
      for (std::size_t k = 1; k < of_b.count; ++k) demand(of_b.at[0] - of_b.at[k]);
      std::array<double, 2> weight{};
      double y_s = 0, y_t = 0;
      if (rows == 2) {
        const double det = row_s[0] * row_t[1] - row_s[1] * row_t[0];
        if (det == 0) return false;
        y_s = (-off[0] * row_t[1] + off[1] * row_t[0]) / det;
        y_t = (-row_s[0] * off[1] + row_s[1] * off[0]) / det;
        weight[0] = (-g_s * row_t[1] + g_t * row_s[1]) / det;
        weight[1] = (-g_t * row_s[0] + g_s * row_t[0]) / det;
      } else if (rows == 1) {
        const double size2 = row_s[0] * row_s[0] + row_t[0] * row_t[0];
        if (!(size2 > 0)) return false;
        weight[0] = -(g_s * row_s[0] + g_t * row_t[0]) / size2;
      }
      share(of_a, weight, 0);
      share(of_b, weight, of_a.count - 1);
      if (is_last) {
        is_last = has_looked = false;
        last2 = 0;
        if (++changes <= most_changes &&
            (drop_least(of_a, -0x1p-30) || drop_least(of_b, -0x1p-30) || admit_beyond(a_, of_a, d, of_b, s, t) ||
             admit_beyond(b_, of_b, back, of_a, s, t))) {
          continue;
        }
        return concludes(of_a, of_b, d);
      }
      // A weight that is far below zero will not come back, and with it what bends is not what it would be.
      // The nearer it is the less is far.
      const double below = last2 > 0 ? -std::sqrt(std::clamp(last2, 0x1p-40, 0x1p-8)) : -0x1p-4;
      const bool may_drop = !is_new && changes < most_changes;
      is_new = false;
      if (may_drop && (drop_least(of_a, below) || drop_least(of_b, below))) {
        ++changes;
        last2 = 0;
        has_looked = false;
        continue;
      }
      if (rows < 2) {
        const double smooth_a = smooth_weight(a_, of_a), smooth_b = smooth_weight(b_, of_b);
        const bool is_flat_a = smooth_a > 0 && !turn_a.has_bend, is_flat_b = smooth_b > 0 && !turn_b.has_bend;
        if (is_flat_a || is_flat_b) {
          if (++changes > most_changes) return false;
          d = is_flat_a ? tilted(d, a_, of_b.at[0]) : V{} - tilted(back, b_, of_a.at[0]);
          last2 = 0;
          has_looked = false;
          continue;
        }
        Bend all;
        all.add(smooth_a, turn_a.bend);
        all.add(smooth_b, turn_b.bend);
        all.ss += std::max(gap, 0.0);
        all.tt += std::max(gap, 0.0);
        if (rows == 1) {
          const double size2 = row_s[0] * row_s[0] + row_t[0] * row_t[0], size = std::sqrt(size2);
          const double n_s = -row_t[0] / size, n_t = row_s[0] / size;
          y_s = -off[0] * row_s[0] / size2;
          y_t = -off[0] * row_t[0] / size2;
          const double bent = n_s * n_s * all.ss + 2 * n_s * n_t * all.st + n_t * n_t * all.tt;
          const double rest =
              g_s * n_s + g_t * n_t + n_s * (all.ss * y_s + all.st * y_t) + n_t * (all.st * y_s + all.tt * y_t);
          if (bent > 0) {
            y_s -= rest / bent * n_s;
            y_t -= rest / bent * n_t;
          } else if (rest != 0) {
            return false;
          }
        } else {
          const double det = all.ss * all.tt - all.st * all.st;
          const double size = all.ss + all.tt;
          if (!(det > 0x1p-40 * size * size)) {
            // One way bends, if rims are there: that by Newton's method. The other, `up`, lies in the plane of d and an
            // axis: there no furthest point turns, until another one reaches as far, or a base or top faces the other.
            const bool bends = size > 0, by_first = all.ss >= all.tt;
            const V2 bent = unit(bends ? (by_first ? V2{all.ss, all.st} : V2{all.st, all.tt}) : V2{g_t, -g_s});
            const double slope = g_t * bent.s - g_s * bent.t;
            if (++turns > most_turns || !(std::fabs(slope) > 0)) return false;
            const V along = sum(sum({0, 0, 0}, -bent.t, s), bent.s, t), up = slope > 0 ? V{} - along : along,
                    down = V{} - up;
            const double other = std::min(until_other(a_, d, up), until_other(b_, back, down));
            if (smooth_a > 0 && until_axis(a_, d, up) < other) return faces(a_, b_, axis_towards(a_, up));
            if (smooth_b > 0 && until_axis(b_, back, down) < other) return faces(b_, a_, axis_towards(b_, down));
            const double step = bends ? -(g_s * bent.s + g_t * bent.t) / size : 0;
            const double by = std::clamp(step, -most_turned, most_turned);
            d = sum(d, std::tan(std::min(other, most_turned) + a_little), up);
            d = sum(sum(d, by * bent.s, s), by * bent.t, t);
            const double over = 1 / length(d);
            d = {over * d.x, over * d.y, over * d.z};
            is_new = admit_beyond(a_, of_a, d, of_b, s, t) || admit_beyond(b_, of_b, {-d.x, -d.y, -d.z}, of_a, s, t);
            last2 = 0;
            has_looked = false;
            continue;
          }
          y_s = (-g_s * all.tt + g_t * all.st) / det;
          y_t = (-g_t * all.ss + g_s * all.st) / det;
        }
      }
      const double step2 = y_s * y_s + y_t * y_t;
      if (!(step2 < HUGE_VAL) || (step2 > 1 && ++wild > 2)) return false;
      const bool is_far = step2 > most_turned * most_turned;
      const double by = is_far ? most_turned / std::sqrt(step2) : 1;
      const double over = 1 / std::sqrt(1 + (is_far ? most_turned * most_turned : step2));
      d = sum(sum(d, by * y_s, s), by * y_t, t);
      d = {over * d.x, over * d.y, over * d.z};
      if (step2 < quite_near2 && gap > a_.radius() + b_.radius() && parts(d)) return true;
      // Newton's method: what is left is as the square of the step, and so were the steps.
      const auto left2 = [&] { return step2 * step2 * std::max(step2 / (last2 * last2), 1.0); };
      is_last = step2 <= 0x1p-100 || (rows == 2 && !is_far && are_vertices(a_, of_a) && are_vertices(b_, of_b)) ||
                (last2 > 0 && step2 < near_enough2 && (step2 >= last2 || left2() < 0x1p-104));
      last2 = step2;
      if (is_last || step2 > well_near2 || has_looked) continue;
      has_looked = true;
      if (changes < most_changes &&
          (admit_beyond(a_, of_a, d, of_b, s, t) || admit_beyond(b_, of_b, {-d.x, -d.y, -d.z}, of_a, s, t))) {
        ++changes;
        last2 = 0;
        has_looked = false;
        is_new = true;
      }
    }
    return false;
  }
  // Of the plane across d.
  struct V2 {
    double s, t;
  };
  static V2 unit(const V2& v) {
    const double over = 1 / std::hypot(v.s, v.t);
    return {over * v.s, over * v.t};
  }
  static void turn_to(const Side& side, Pieces& pieces, const V& out) {
    for (std::size_t k = 0; k < pieces.count; ++k) {
      if (!is_vertex(side, pieces.piece[k]))
        pieces.at[k] = sum(pieces.piece[k] == 0 ? side.image.from : side.image.to, 1, out);
    }
  }
  // How far d has to turn towards `up`, which is perpendicular to it and of length 1, until the other rim, or apex or
  // rim, reaches as far: there the cosine with the axis is that of the normal of the side.
  static double until_other(const Side& side, const V& d, const V& up) {
    const RoundImage& of = side.image;
    if (of.kind != RoundKind::cylinder && of.kind != RoundKind::cone) return HUGE_VAL;
    const double along = dot(d, of.axis), gain = dot(up, of.axis), size = std::hypot(along, gain);
    const double cosine = of.kind == RoundKind::cylinder ? 0 : of.radius / std::hypot(of.radius, of.length);
    if (!(cosine < size)) return HUGE_VAL;
    const double top = std::atan2(gain, along),
                 half = std::acos(cosine / size);  // beyond it from top - half to top + half
    return along > cosine ? top + half : top > half ? top - half : HUGE_VAL;
  }
  // And until it is along the axis; which way that is then.
  static double until_axis(const Side& side, const V& d, const V& up) {
    if (side.image.kind == RoundKind::ellipsoid) return HUGE_VAL;
    const V axis = axis_towards(side, up);
    return std::atan2(dot(up, axis), dot(d, axis));
  }
  static V axis_towards(const Side& side, const V& up) {
    const V& axis = side.image.axis;
    return dot(up, axis) > 0 ? axis : V{} - axis;
  }
  // From the direction of an axis towards a point that is beyond the rim.
  static V tilted(const V& d, const Side& own, const V& to) {
    const V& axis = own.image.axis;
    const V way = to - (dot(d, axis) > 0 ? own.image.to : own.image.from), out = sum(way, -dot(way, axis), axis);
    const V turned = sum(d, 0.25 / length(out), out);
    const double over = 1 / length(turned);
    return {over * turned.x, over * turned.y, over * turned.z};
  }
  static bool are_vertices(const Side& side, const Pieces& pieces) {
    return std::all_of(pieces.piece.data(), pieces.piece.data() + pieces.count,
                       [&](std::uint32_t piece) { return is_vertex(side, piece); });
  }
  static double smooth_weight(const Side& side, const Pieces& pieces) {
    double all = 0;
    for (std::size_t k = 0; k < pieces.count; ++k) {
      all += is_vertex(side, pieces.piece[k]) ? 0 : std::clamp(pieces.weight[k], 0.0, 1.0);
    }
    return all;
  }
  // A piece whose weight is negative does not belong there.
  static bool drop_least(Pieces& pieces, double below) {
    const std::size_t k = pieces.least();
    if (!(pieces.weight[k] < below)) return false;
    pieces.drop(k);
    return true;
  }
  // A piece that reaches further than these does.
  bool admit_beyond(const Side& side, Pieces& pieces, const V& d, Pieces& others, const V& s, const V& t) {
    const Far far = far_along(side, d);
    if (pieces.has(far.piece) || !(dot(d, far.at - pieces.at[0]) > 0x1p-44 * size_)) return false;
    if (pieces.count + others.count == 4) return exchange(pieces, far, others, s, t);
    admit(pieces, far, 0);
    return true;
  }
  // Of four pieces, whose weights their places in the plane of s and t tell: another one takes the place of that whose
  // weight is the first to vanish while its own grows. Source: the ratio test of the simplex method, Dantzig 1951.
  static bool exchange(Pieces& own, const Far& far, Pieces& others, const V& s, const V& t) {
    std::array<double, 2> row_s{}, row_t{}, rate{};
    std::size_t rows = 0;
    const auto demand = [&](const V& more) {
      row_s[rows] = dot(more, s);
      row_t[rows++] = dot(more, t);
    };
    for (std::size_t k = 1; k < own.count; ++k) demand(own.at[k] - own.at[0]);
    for (std::size_t k = 1; k < others.count; ++k) demand(others.at[0] - others.at[k]);
    const V more = far.at - own.at[0];
    const double of_s = dot(more, s), of_t = dot(more, t), det = row_s[0] * row_t[1] - row_s[1] * row_t[0];
    if (det == 0) return false;
    rate = {(of_s * row_t[1] - of_t * row_s[1]) / det, (of_t * row_s[0] - of_s * row_t[0]) / det};
    Pieces* from = nullptr;
    std::size_t leaving = 0, row = 0;
    double grown = HUGE_VAL;
    const auto look = [&](Pieces& pieces, std::size_t k, double falls) {
      const double until = std::max(pieces.weight[k], 0.0) / falls;
      if (!(falls > 0 && until < grown)) return;
      grown = until;
      from = &pieces;
      leaving = k;
    };
    double first_own = 1, first_other = 0;
    for (std::size_t k = 1; k < own.count; ++k, ++row) {
      look(own, k, rate[row]);
      first_own -= rate[row];
    }
    for (std::size_t k = 1; k < others.count; ++k, ++row) {
      look(others, k, rate[row]);
      first_other -= rate[row];
    }
    look(own, 0, first_own);
    if (others.count > 1) look(others, 0, first_other);
    if (from == nullptr) return false;
    from->drop(leaving);
    admit(own, far, grown);
    return true;
  }
  static void admit(Pieces& pieces, const Far& far, double weight) {
    std::size_t k = 0;
    while (k < pieces.count && pieces.piece[k] != far.piece) ++k;
    if (k == pieces.count) {
      pieces.piece[pieces.count++] = far.piece;
      pieces.at[k] = far.at;
      pieces.weight[k] = 0;
    }
    pieces.weight[k] += weight;
  }
  static void share(Pieces& pieces, const std::array<double, 2>& weight, std::size_t from) {
    pieces.weight[0] = 1;
    for (std::size_t k = 1; k < pieces.count; ++k) {
      pieces.weight[k] = weight[from + k - 1];
      pieces.weight[0] -= pieces.weight[k];
    }
  }
  bool concludes(const Pieces& of_a, const Pieces& of_b, const V& d) {
    const auto made = [&](const Side& side, const Pieces& of) {
      Nearest p{};
      double total = 0;  // without those that are negative
      for (std::size_t k = 0; k < of.count; ++k) total += std::max(of.weight[k], 0.0);
      for (std::size_t k = 0; k < of.count; ++k) {
        if (of.weight[k] > 0) add(side, p, {of.at[k], of.piece[k]}, of.weight[k] / total);
      }
      return p;
    };
    const Nearest p = made(a_, of_a), q = made(b_, of_b);
    const double gap = dot(q.at - p.at, d), reach = a_.radius() + b_.radius();
    if (gap > reach) return parts(d);
    is_thorough_ = reach - gap > 0x1p-44 * size_;
    const bool held = holds(p, q);
    is_thorough_ = false;
    return held;
  }

  // p of the core of `own`, a ball or a capsule, and q of the other's are nearest to each other.
  bool settles(const Side& own, const Nearest& p, const Side& other, const Nearest& q) {
    V way = q.at - p.at;
    const double far2 = dot(way, way), reach = own.radius() + other.radius();
    if (far2 > reach * reach) {
      // Within the axis of a capsule the way is perpendicular to it.
      if (own.is_capsule() && p.made.count == 2) way = perpendicular(way, own.image.axis);
      if (other.is_capsule() && q.made.count == 2) way = perpendicular(way, other.image.axis);
      return parts(&own == &a_ ? way : V{-way.x, -way.y, -way.z});
    }
    ++answer_.cost.proposals;
    if (!is_whole(p) || (!other.is_curved() && !is_whole(q))) return false;
    const RoundCombination &of_a = &own == &a_ ? p.made : q.made, &of_b = &own == &a_ ? q.made : p.made;
    if (!other.is_curved()) {
      return nearness_guess(p.at, q.at, reach, size_) == Guess::positive &&
             meets(RoundEvidence::Source::between, {}, of_a, of_b);
    }
    if (far2 == 0 && holds_core(own, p, other)) return true;
    // From the point of the other body's surface inwards, by half of what is left over.
    const V inwards = other.middle() - q.at;
    const double slack = reach - std::sqrt(far2), deep = length(inwards);
    const V x = sum(q.at, slack < deep ? 0.5 * slack / deep : 0.5, inwards);
    return side_guess(other.image, x) == Guess::positive &&
           nearness_guess(p.at, x, reach, own.image.size) == Guess::positive &&
           meets(RoundEvidence::Source::point, point(x), of_a, of_b);
  }

  static V perpendicular(const V& v, const V& axis) { return sum(v, -dot(v, axis) / dot(axis, axis), axis); }

  bool parts(const V& way) { return round_quick::parts(way, a_.image, b_.image, answer_, way_); }

  bool meets(RoundEvidence::Source source, const Point3& x, const RoundCombination& a, const RoundCombination& b) {
    RoundEvidence& evidence = answer_.evidence;
    evidence.verdict = RoundVerdict::meet;
    evidence.source = source;
    evidence.point = x;
    evidence.a = a;
    evidence.b = b;
    return true;
  }

  static constexpr int most_steps = 20, most_searched = 30, most_refined = 16, most_alternated = 16, most_changes = 3,
                       most_turns = 6;
  static constexpr double near_enough2 = 0x1p-40, quite_near2 = 0x1p-48, well_near2 = 0x1p-8, most_turned = 0.5,
                          a_little = 0x1p-30;
  static constexpr Affine3 in_place{};

  const Side& a_;
  const Side& b_;
  RoundAnswer& answer_;
  Point3& way_;
  double size_;
  StageTally tally_;
  bool is_thorough_ = false;  // more than doubles tell is asked for
};

}  // namespace

}  // namespace round_quick

bool decide_quickly(const RoundBody& a, const Pose& pose_a, const RoundBody& b, const Pose& pose_b, RoundAnswer& answer,
                    Point3& way) {
  const bool ball_a = round_quick::is_ball(a), ball_b = round_quick::is_ball(b);
  if (ball_a && ball_b) return round_quick::balls(a, pose_a, b, pose_b, answer, way);
  if ((ball_a || ball_b) && round_quick::ball_and(a, pose_a, b, pose_b, answer, way)) return true;
  const round_quick::Side of_a(a, pose_a), of_b(b, pose_b);
  return round_quick::Quick(of_a, of_b, answer, way).run();
}

}  // namespace sunder::solid
