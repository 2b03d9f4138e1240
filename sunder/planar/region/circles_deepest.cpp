// Why the weights are positive. Let disc a have a greater power at the deepest point of those before it. Then it is one
// of those that name the new point p, with a positive weight: were it w <= 0, the weighted sum of the powers, which is
// |q - p|^2 plus their power at p, would be at most the old power at the old point, yet least at p. The search among
// those before it, with the power of a as the common one, is of the same form, in the differences to a: so is the next.
// For the same reasons centres differ, and three are not on one line.
#include <sunder/base/random.h>
#include <sunder/planar/region/circles_deepest.h>
#include <sunder/predicate/disc_powers.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

namespace sunder::planar {

namespace {

// Has k a greater power at the deepest point of the basis? `bound` is that of the basis.
bool is_beyond(const DiscBasis& basis, const PowerBound& bound, const Disc& k, Cost& cost, StageTally& tally) {
  ++cost.probes;
  if (is_surely_less(k, bound)) return false;
  return power_against(basis, k, &tally) == Sign::positive;
}

// The discs in this order; the first one starts.
class InOrder {
 public:
  InOrder(std::span<const Circle> circles, std::span<const std::uint32_t> order, CirclesDeepest& out)
      : circles_(circles), order_(order), out_(out) {}

  void run() {
    set({order_[0]});
    for (std::size_t a = 1; a < order_.size(); ++a) {
      if (!is_beyond_basis(a)) continue;
      set({order_[a]});
      for (std::size_t b = 0; b < a; ++b) {
        if (!is_beyond_basis(b)) continue;
        set({order_[a], order_[b]});
        for (std::size_t c = 0; c < b; ++c) {
          if (is_beyond_basis(c)) set({order_[a], order_[b], order_[c]});
        }
      }
    }
    out_.power = deepest_power(basis_, &tally_);
    out_.cost.exact += tally_.exact;
  }

 private:
  void set(std::initializer_list<std::uint32_t> discs) {
    out_.count = static_cast<std::uint32_t>(discs.size());
    std::copy(discs.begin(), discs.end(), out_.discs.begin());
    basis_ = discs_of(circles_, out_.basis());
    bound_ = power_bound(basis_);
  }
  bool is_beyond_basis(std::size_t k) {
    return is_beyond(basis_, bound_, disc_of(circles_[order_[k]]), out_.cost, tally_);
  }

  std::span<const Circle> circles_;
  std::span<const std::uint32_t> order_;
  CirclesDeepest& out_;
  DiscBasis basis_;
  PowerBound bound_;
  StageTally tally_;
};

// The proposal: everything in doubles.
struct Proposal {
  std::array<std::uint32_t, 3> discs{};
  std::uint32_t count = 0;
  Point2 point;
  double power = 0;
};

double power(const Circle& c, const Point2& p) {
  const double x = c.center.x - p.x, y = c.center.y - p.y;
  return (x * x + y * y) - c.radius * c.radius;
}

double lead_of(const Circle& i, const Circle& k) { return power(k, i.center) + i.radius * i.radius; }

Proposal of_one(std::span<const Circle> circles, std::uint32_t i) {
  return {{i, 0, 0}, 1, circles[i].center, -circles[i].radius * circles[i].radius};
}

// Those with weights that are not negative; else with the power -infinity.
Proposal of_two(std::span<const Circle> circles, std::uint32_t i, std::uint32_t j) {
  Proposal out{{i, j, 0}, 2, circles[i].center, -HUGE_VAL};
  const double x = circles[j].center.x - out.point.x, y = circles[j].center.y - out.point.y;
  const double t = 0.5 * lead_of(circles[i], circles[j]) / (x * x + y * y);
  if (!(t >= 0 && t <= 1)) return out;
  out.point = {out.point.x + t * x, out.point.y + t * y};
  out.power = power(circles[i], out.point);
  return out;
}

Proposal of_three(std::span<const Circle> circles, std::uint32_t i, std::uint32_t j, std::uint32_t l) {
  Proposal out{{i, j, l}, 3, circles[i].center, -HUGE_VAL};
  const Point2 d{circles[j].center.x - out.point.x, circles[j].center.y - out.point.y};
  const Point2 e{circles[l].center.x - out.point.x, circles[l].center.y - out.point.y};
  const double turn = d.x * e.y - d.y * e.x;
  const double of_j = 0.5 * lead_of(circles[i], circles[j]), of_l = 0.5 * lead_of(circles[i], circles[l]);
  const Point2 q{(of_j * e.y - of_l * d.y) / turn, (of_l * d.x - of_j * e.x) / turn};
  const double w_j = (q.x * e.y - q.y * e.x) / turn, w_l = (d.x * q.y - d.y * q.x) / turn;
  if (!(w_j >= 0 && w_l >= 0 && w_j + w_l <= 1)) return out;
  out.point = {out.point.x + q.x, out.point.y + q.y};
  out.power = power(circles[i], out.point);
  return out;
}

// The proposal for the discs of `basis` and disc k: of all that name k, the one of the greatest power.
Proposal with(std::span<const Circle> circles, const Proposal& basis, std::uint32_t k) {
  Proposal best = of_one(circles, k);
  const auto consider = [&](const Proposal& other) {
    if (other.power > best.power) best = other;
  };
  for (std::uint32_t a = 0; a < basis.count; ++a) {
    consider(of_two(circles, k, basis.discs[a]));
    for (std::uint32_t b = a + 1; b < basis.count; ++b) {
      consider(of_three(circles, k, basis.discs[a], basis.discs[b]));
    }
  }
  return best;
}

Proposal propose(std::span<const Circle> circles, Cost& cost) {
  constexpr int most_steps = 40;
  std::uint32_t start = 0;
  for (std::uint32_t k = 1; k < circles.size(); ++k) {
    if (circles[k].radius < circles[start].radius) start = k;
  }
  Proposal best = of_one(circles, start);
  for (int step = 0; step < most_steps; ++step) {
    ++cost.iterations;
    cost.probes += circles.size();
    std::uint32_t furthest = best.discs[0];
    double most = best.power;
    for (std::uint32_t k = 0; k < circles.size(); ++k) {
      const double here = power(circles[k], best.point);
      if (here > most) {
        most = here;
        furthest = k;
      }
    }
    const Proposal next = with(circles, best, furthest);
    if (!(next.power > best.power)) break;
    best = next;
  }
  return best;
}

}  // namespace

DiscBasis discs_of(std::span<const Circle> circles, std::span<const std::uint32_t> basis) {
  DiscBasis out;
  for (const std::uint32_t i : basis) out.discs[out.count++] = disc_of(circles[i]);
  return out;
}

CirclesDeepest circles_deepest_by_order(std::span<const Circle> circles) {
  CirclesDeepest out;
  std::vector<std::uint32_t> order(circles.size());
  std::iota(order.begin(), order.end(), 0u);
  Random random(1976);
  for (std::size_t k = order.size(); k > 1; --k) std::swap(order[k - 1], order[random.below(k)]);
  InOrder(circles, order, out).run();
  return out;
}

CirclesDeepest circles_deepest(std::span<const Circle> circles) {
  constexpr int most_changes = 100;
  CirclesDeepest out;
  const Proposal proposal = propose(circles, out.cost);
  InOrder(circles, {proposal.discs.data(), proposal.count}, out).run();
  DiscBasis basis = discs_of(circles, out.basis());
  PowerBound bound = power_bound(basis);
  StageTally tally;
  int changes = 0;
  // Round and round, until all have been asked since the basis last changed. Its power rises with each change.
  std::size_t k = 0;
  for (std::size_t held = 0; held < circles.size() && changes <= most_changes; ++held) {
    if (is_beyond(basis, bound, disc_of(circles[k]), out.cost, tally)) {
      std::array<std::uint32_t, 4> few{static_cast<std::uint32_t>(k), out.discs[0], out.discs[1], out.discs[2]};
      InOrder(circles, {few.data(), out.count + 1}, out).run();
      basis = discs_of(circles, out.basis());
      bound = power_bound(basis);
      ++changes;
      held = 0;
    }
    if (++k == circles.size()) k = 0;
  }
  out.cost.exact += tally.exact;
  if (changes <= most_changes) return out;
  const Cost spent = out.cost;
  out = circles_deepest_by_order(circles);
  out.cost.probes += spent.probes;
  out.cost.exact += spent.exact;
  out.cost.iterations = spent.iterations;
  return out;
}

}  // namespace sunder::planar
