// Why the weights are positive. Let disc a have a greater power at the deepest point of those before it. Then it is one
// of those that name the new point p, with a positive weight: were it w <= 0, the weighted sum of the powers, which is
// |q - p|^2 plus their power at p, would be at most the old power at the old point, yet least at p. The search among
// those before it, with the power of a as the common one, is of the same form, in the differences to a: so is the next.
// For the same reasons centres differ, and three are not on one line.
#include <sunder/base/contract.h>
#include <sunder/base/random.h>
#include <sunder/number/double_double.h>
#include <sunder/number/vector.h>
#include <sunder/planar/region/discs_deepest.h>
#include <sunder/predicate/disc/disc_powers.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <type_traits>
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
  InOrder(std::span<const Disc> circles, std::span<const std::uint32_t> order, DiscsDeepest& out)
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
    out_.point.power = deepest_power(basis_, &tally_);
    out_.cost.exact += tally_.exact;
  }

 private:
  void set(std::initializer_list<std::uint32_t> discs) {
    out_.point.count = static_cast<std::uint32_t>(discs.size());
    std::copy(discs.begin(), discs.end(), out_.point.discs.begin());
    basis_ = discs_of(circles_, out_.point.basis());
    bound_ = power_bound(basis_);
  }
  bool is_beyond_basis(std::size_t k) { return is_beyond(basis_, bound_, circles_[order_[k]], out_.cost, tally_); }

  std::span<const Disc> circles_;
  std::span<const std::uint32_t> order_;
  DiscsDeepest& out_;
  DiscBasis basis_;
  PowerBound bound_;
  StageTally tally_;
};

// The proposal, in floating point: Number is double, or DoubleDouble where discs are nearly tied.
template <class Number>
struct Proposal {
  std::array<std::uint32_t, 3> discs{};
  std::uint32_t count = 0;
  Vector2<Number> point{0, 0};
  Number power = 0;
};

template <class Number>
Vector2<Number> center_of(const Disc& c) {
  return {Number(c.center.x), Number(c.center.y)};
}

template <class Number>
Number power(const Disc& c, const Vector2<Number>& p) {
  const Vector2<Number> way = center_of<Number>(c) - p;
  return dot(way, way) - Number(c.radius) * Number(c.radius);
}

template <class Number>
Number half_lead(const Disc& i, const Disc& k) {
  return Number(0.5) * (power(k, center_of<Number>(i)) + Number(i.radius) * Number(i.radius));
}

// Those with weights that are not negative; else with the power -infinity.
template <class Number>
Proposal<Number> proposal_of(std::span<const Disc> circles, std::uint32_t i) {
  const Vector2<Number> center = center_of<Number>(circles[i]);
  return {{i, 0, 0}, 1, center, power(circles[i], center)};
}

template <class Number>
Proposal<Number> proposal_of(std::span<const Disc> circles, std::uint32_t i, std::uint32_t j) {
  Proposal<Number> out{{i, j, 0}, 2, center_of<Number>(circles[i]), -HUGE_VAL};
  const Vector2<Number> d = center_of<Number>(circles[j]) - out.point;
  const Number t = half_lead<Number>(circles[i], circles[j]) / dot(d, d);
  if (!(t >= 0.0 && Number(1) >= t)) return out;
  out.point = {out.point.x + t * d.x, out.point.y + t * d.y};
  out.power = power(circles[i], out.point);
  return out;
}

template <class Number>
Proposal<Number> proposal_of(std::span<const Disc> circles, std::uint32_t i, std::uint32_t j, std::uint32_t l) {
  Proposal<Number> out{{i, j, l}, 3, center_of<Number>(circles[i]), -HUGE_VAL};
  const Vector2<Number> d = center_of<Number>(circles[j]) - out.point, e = center_of<Number>(circles[l]) - out.point;
  const Number turn = cross(d, e);
  const Number of_j = half_lead<Number>(circles[i], circles[j]), of_l = half_lead<Number>(circles[i], circles[l]);
  const Vector2<Number> q{(of_j * e.y - of_l * d.y) / turn, (of_l * d.x - of_j * e.x) / turn};
  const Number w_j = cross(q, e) / turn, w_l = cross(d, q) / turn;
  if (!(w_j >= 0.0 && w_l >= 0.0 && Number(1) >= w_j + w_l)) return out;
  out.point = {out.point.x + q.x, out.point.y + q.y};
  out.power = power(circles[i], out.point);
  return out;
}

template <class Number>
Proposal<Number> proposal_of(std::span<const Disc> circles, std::span<const std::uint32_t> discs) {
  if (discs.size() == 1) return proposal_of<Number>(circles, discs[0]);
  if (discs.size() == 2) return proposal_of<Number>(circles, discs[0], discs[1]);
  return proposal_of<Number>(circles, discs[0], discs[1], discs[2]);
}

// The proposal for the discs of `basis` and disc k: of all that name k, the one of the greatest power.
template <class Number>
Proposal<Number> with(std::span<const Disc> circles, const Proposal<Number>& basis, std::uint32_t k) {
  Proposal<Number> best = proposal_of<Number>(circles, k);
  const auto consider = [&](const Proposal<Number>& other) {
    if (other.power > best.power) best = other;
  };
  for (std::uint32_t a = 0; a < basis.count; ++a) {
    consider(proposal_of<Number>(circles, k, basis.discs[a]));
    for (std::uint32_t b = a + 1; b < basis.count; ++b) {
      consider(proposal_of<Number>(circles, k, basis.discs[a], basis.discs[b]));
    }
  }
  return best;
}

// From one proposal to that with the disc of greatest power at its point, while the power grows. It may grow by no more
// than the square of what the disc is beyond, so in fine numbers a loss by rounding is no reason to stop.
template <class Number>
Proposal<Number> improved(std::span<const Disc> circles, Proposal<Number> best, Cost& cost) {
  constexpr int most_steps = 40;
  constexpr bool fine = !std::is_same_v<Number, double>;
  for (int step = 0; step < most_steps; ++step) {
    ++cost.iterations;
    cost.probes += circles.size();
    std::uint32_t furthest = best.discs[0];
    Number most = best.power;
    const Vector2<double> near{nearest(best.point.x), nearest(best.point.y)};
    for (std::uint32_t k = 0; k < circles.size(); ++k) {
      const Disc& c = circles[k];
      const Vector2<double> way = center_of<double>(c) - near;
      const double distance = dot(way, way), square = c.radius * c.radius;
      if (!(distance - square + (fine ? 0x1p-45 * (distance + square) : 0) > nearest(most))) continue;
      const Number here = power(c, best.point);
      if (here > most) {
        most = here;
        furthest = k;
      }
    }
    const double square = circles[furthest].radius * circles[furthest].radius;
    const Number noise = fine ? 0x1p-95 * (square + std::fabs(nearest(most))) : 0;
    if (!(most > best.power + noise)) break;
    const Proposal<Number> next = with(circles, best, furthest);
    if (!(next.power + noise > best.power)) break;
    best = next;
  }
  return best;
}

// First in doubles, then in numbers of 106 bits: on a ring of discs doubles do not tell which are furthest.
Proposal<DoubleDouble> propose(std::span<const Disc> circles, Cost& cost) {
  std::uint32_t start = 0;
  for (std::uint32_t k = 1; k < circles.size(); ++k) {
    if (circles[k].radius < circles[start].radius) start = k;
  }
  const Proposal<double> rough = improved(circles, proposal_of<double>(circles, start), cost);
  const std::span<const std::uint32_t> discs(rough.discs.data(), rough.count);
  return improved(circles, proposal_of<DoubleDouble>(circles, discs), cost);
}

}  // namespace

DiscBasis discs_of(std::span<const Disc> circles, std::span<const std::uint32_t> basis) {
  DiscBasis out;
  for (const std::uint32_t i : basis) out.discs[out.count++] = circles[i];
  return out;
}

DiscsDeepest discs_deepest_by_order(std::span<const Disc> circles) {
  DiscsDeepest out;
  std::vector<std::uint32_t> order(circles.size());
  std::iota(order.begin(), order.end(), 0u);
  Random random(1976);
  for (std::size_t k = order.size(); k > 1; --k) std::swap(order[k - 1], order[random.below(k)]);
  InOrder(circles, order, out).run();
  return out;
}

DiscsDeepest discs_deepest(std::span<const Disc> circles) {
  SUNDER_REQUIRE(!circles.empty());
  constexpr int most_changes = 100;
  DiscsDeepest out;
  const Proposal<DoubleDouble> proposal = propose(circles, out.cost);
  InOrder(circles, {proposal.discs.data(), proposal.count}, out).run();
  DiscBasis basis = discs_of(circles, out.point.basis());
  PowerBound bound = power_bound(basis);
  StageTally tally;
  int changes = 0;
  // Round and round, until all have been asked since the basis last changed. Its power rises with each change.
  std::size_t k = 0;
  for (std::size_t held = 0; held < circles.size() && changes <= most_changes; ++held) {
    if (is_beyond(basis, bound, circles[k], out.cost, tally)) {
      std::array<std::uint32_t, 4> few{static_cast<std::uint32_t>(k), out.point.discs[0], out.point.discs[1],
                                       out.point.discs[2]};
      InOrder(circles, {few.data(), out.point.count + 1}, out).run();
      basis = discs_of(circles, out.point.basis());
      bound = power_bound(basis);
      ++changes;
      held = 0;
    }
    if (++k == circles.size()) k = 0;
  }
  out.cost.exact += tally.exact;
  if (changes <= most_changes) return out;
  const Cost spent = out.cost;
  out = discs_deepest_by_order(circles);
  out.cost.probes += spent.probes;
  out.cost.exact += spent.exact;
  out.cost.iterations = spent.iterations;
  return out;
}

}  // namespace sunder::planar
