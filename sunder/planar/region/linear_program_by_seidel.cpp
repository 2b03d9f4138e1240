// Seidel's method for all, or for samples.
//
// Ties are broken by turning the objective a little counter-clockwise: less than any two directions given differ. Then
// an optimum that exists is one corner, of two half-planes, `before` and `after`, whose normals have the turned
// objective strictly between them. It exists, unless there are contradictions, iff the last normal clockwise of the
// objective (or in its direction) and the first one counter-clockwise are less than a half turn apart. Where they are
// not, all normals lie within a half turn; then one line, of an outermost normal, tells whether there is a common
// point.
#include <sunder/base/contract.h>
#include <sunder/base/interruption.h>
#include <sunder/base/random.h>
#include <sunder/planar/region/linear_program.h>

#include <cmath>
#include <cstdint>
#include <ranges>
#include <span>
#include <utility>
#include <vector>

namespace sunder::planar {

namespace {

template <class Given>
class ProgramSearch {
 public:
  using Half = typename Given::Half;

  // Requires that p and q are not both zero.
  ProgramSearch(const Given& given, const Objective& objective)
      : given_(given), up_(through_origin<Half>(objective.p, objective.q)), size_(given.size()) {
    SUNDER_REQUIRE(objective.p != 0 || objective.q != 0);
  }

  // The nearest normals: of `before` clockwise of the objective or in its direction, of `after` counter-clockwise or
  // opposite; of equal ones the tightest.
  struct Nearest {
    std::uint32_t before = no_half_plane, after = no_half_plane;
  };
  Nearest nearest() {
    Nearest found;
    for (std::uint32_t k = 0; k < size_; ++k) {
      const Half half = given_[k];
      if (is_after(half)) {
        if (found.after == no_half_plane || is_nearer(half, given_[found.after], Sign::positive)) found.after = k;
      } else {
        if (found.before == no_half_plane || is_nearer(half, given_[found.before], Sign::negative)) found.before = k;
      }
    }
    return found;
  }

  bool has_corner(const Nearest& nearest) {
    return nearest.before != no_half_plane && nearest.after != no_half_plane &&
           turn_of(given_[nearest.before], given_[nearest.after]) == Sign::positive;
  }

  // The optimum of two half-planes, or a contradiction.
  struct Basis {
    std::uint32_t before, after;
    std::uint32_t third = no_half_plane;  // set: the three contradict each other, third coming between
    bool contradicts = false;             // so do they, or the two, where it is not set
  };

  static Basis basis_of(std::uint32_t before, std::uint32_t after) { return {before, after, no_half_plane, false}; }

  // Of the half-planes in `order`, that of the first two being the one of `basis`. Cost: O(n) signs, expected over the
  // orders of the others.
  Basis optimum(Basis basis, std::span<const std::uint32_t> order) {
    for (std::size_t n = 2; n < order.size();) {
      may_be_interrupted(10);
      const FixedCorner<Half> corner{given_[basis.before], given_[basis.after]};
      while (n < order.size() && corner_side(corner, given_[order[n]], &tally_) != Sign::positive) ++n, ++probes_;
      if (n == order.size()) break;
      ++probes_;
      basis = optimum_on_line(order[n], order.first(n));
      if (basis.contradicts) break;
      ++n;
    }
    return basis;
  }

  // Appends those that do not hold the corner of the basis.
  void append_outside(const Basis& basis, std::vector<std::uint32_t>& numbers) {
    const FixedCorner<Half> corner{given_[basis.before], given_[basis.after]};
    for (std::uint32_t k = 0; k < size_; ++k) {
      if (corner_side(corner, given_[k], &tally_) == Sign::positive) numbers.push_back(k);
    }
    probes_ += size_;
  }

  // What others leave of a line: between its corners with from and to, where these are set.
  struct Left {
    std::uint32_t from = no_half_plane, to = no_half_plane;
    std::uint32_t opposite = no_half_plane;  // set: one that is a half turn from the line's and has no point with it
  };

  // Requires that none is a tighter one in the same direction. Of several through one point the one that turns most.
  template <class Numbers>
  Left left_of_line(std::uint32_t line, const Numbers& others) {
    const Half on = given_[line];
    Left left;
    for (const std::uint32_t k : others) {
      const Half half = given_[k];
      const Sign turn = turn_of(on, half);
      if (turn == Sign::positive) {
        if (left.to == no_half_plane || cuts_before(on, given_[left.to], half)) left.to = k;
      } else if (turn == Sign::negative) {
        if (left.from == no_half_plane || cuts_after(on, given_[left.from], half)) left.from = k;
      } else if (facing(on, half, &tally_) == Sign::negative && gap(on, half, &tally_) == Sign::negative) {
        left.opposite = k;
        return left;
      }
    }
    return left;
  }

  Left left_of_line(std::uint32_t line) { return left_of_line(line, std::views::iota(std::uint32_t{0}, size_)); }

  // The answer from the optimum of all. Cost: constant; O(N) signs where a normal is in the objective's direction.
  LinearProgramAnswer answer_of(const Basis& basis) {
    if (basis.contradicts) return with_cost(NoPoint{basis.before, basis.after, basis.third});
    if (turn_of(given_[basis.before], up_) != Sign::zero) return with_cost(OneOptimum{basis.before, basis.after});
    return with_cost(edge_of(basis.before));
  }

  // The answer where has_corner(nearest) is false.
  LinearProgramAnswer answer_without_corner(const Nearest& nearest) {
    const auto [before, after] = nearest;
    if (before == no_half_plane && after == no_half_plane) return with_cost(NoBound{});
    if (before == no_half_plane) {
      const Left left = left_of_line(after);
      const bool is_opposite = turn_of(given_[after], up_) == Sign::zero;
      return with_cost(NoBound{{after, left.to}, is_opposite ? no_half_plane : after, !is_opposite});
    }
    const Left left = left_of_line(before);
    if (left.opposite != no_half_plane) return with_cost(NoPoint{before, left.opposite});
    if (turn_of(given_[before], up_) == Sign::zero) return with_cost(edge_of(before));
    return with_cost(NoBound{{before, left.from}, before});
  }

 private:
  Sign turn_of(const Half& i, const Half& j) { return ++probes_, turn(i, j, &tally_); }
  Sign corner_of(const Half& i, const Half& j, const Half& k) { return ++probes_, corner_side(i, j, k, &tally_); }

  // Is the normal counter-clockwise of the objective by a half turn or less?
  bool is_after(const Half& half) {
    const Sign turn = turn_of(up_, half);
    return turn == Sign::positive || (turn == Sign::zero && facing(up_, half, &tally_) == Sign::negative);
  }

  bool is_nearer(const Half& half, const Half& than, Sign turn_to_nearest) {
    const Sign turn = turn_of(half, than);
    return turn == turn_to_nearest || (turn == Sign::zero && tighter(half, than, &tally_) == Sign::positive);
  }

  bool cuts_before(const Half& line, const Half& to, const Half& half) {
    const Sign side = corner_of(line, to, half);
    return side == Sign::positive || (side == Sign::zero && turn_of(to, half) == Sign::positive);
  }
  bool cuts_after(const Half& line, const Half& from, const Half& half) {
    const Sign side = corner_of(from, line, half);
    return side == Sign::positive || (side == Sign::zero && turn_of(half, from) == Sign::positive);
  }

  // Of `line` and others that have an optimum outside of it.
  Basis optimum_on_line(std::uint32_t line, std::span<const std::uint32_t> others) {
    const Left left = left_of_line(line, others);
    if (left.opposite != no_half_plane) return {line, left.opposite, no_half_plane, true};
    const bool has_both = left.from != no_half_plane && left.to != no_half_plane;
    if (has_both && corner_of(given_[left.from], given_[line], given_[left.to]) == Sign::positive) {
      return {left.from, left.to, line, true};
    }
    // The objective, turned a little: does it lead forward on the line?
    const Half half = given_[line];
    const Sign turn = turn_of(half, up_);
    const bool forward = turn == Sign::positive || (turn == Sign::zero && facing(half, up_, &tally_) == Sign::positive);
    return forward ? basis_of(line, left.to) : basis_of(left.from, line);
  }

  // The optimal points, on a line with common points whose normal is in the direction of the objective.
  ProgramEvidence edge_of(std::uint32_t line) {
    const Left left = left_of_line(line);
    const bool has_both = left.from != no_half_plane && left.to != no_half_plane;
    if (has_both && corner_of(given_[left.from], given_[line], given_[left.to]) == Sign::zero) {
      return OneOptimum{left.from, left.to, line};
    }
    return ManyOptima{line, left.from, left.to};
  }

  LinearProgramAnswer with_cost(const ProgramEvidence& evidence) const {
    LinearProgramAnswer answer{evidence};
    answer.cost.probes = probes_;
    conclude(answer, tally_.exact);
    return answer;
  }

  const Given& given_;
  Half up_;
  std::uint32_t size_;
  StageTally tally_;
  std::uint64_t probes_ = 0;
};

// All but the first `fixed`, in random order.
void shuffle(std::vector<std::uint32_t>& order, std::size_t fixed, Random& random) {
  for (std::size_t n = order.size(); n > fixed + 1; --n)
    std::swap(order[n - 1], order[fixed + random.below(n - fixed)]);
}

// For the objective zero: the answer for any other one, as a common point.
LinearProgramAnswer any_common_point(LinearProgramAnswer answer) {
  if (is_feasible(answer)) answer.evidence = named_point(answer.evidence);
  return answer;
}

constexpr std::uint64_t seed = 20261201;

// Sampling needs a pass over all for each round: less than this many are solved at once.
constexpr std::uint32_t small = 256;

template <class Given>
LinearProgramAnswer solve(const Given& given, const Objective& objective, std::uint32_t sample_size) {
  if (objective.p == 0 && objective.q == 0) return any_common_point(solve(given, Objective{1, 0}, sample_size));
  using Search = ProgramSearch<Given>;
  Search search(given, objective);
  const auto nearest = search.nearest();
  if (!search.has_corner(nearest)) return search.answer_without_corner(nearest);
  Random random(seed);
  std::vector<std::uint32_t> order{nearest.before, nearest.after};
  if (sample_size >= given.size()) {
    for (std::uint32_t k = 0; k < given.size(); ++k) order.push_back(k);
  } else {
    for (std::uint32_t k = 0; k < sample_size; ++k) {
      order.push_back(static_cast<std::uint32_t>(random.below(given.size())));
    }
  }
  const typename Search::Basis first = Search::basis_of(nearest.before, nearest.after);
  for (;;) {
    shuffle(order, 2, random);
    const typename Search::Basis basis = search.optimum(first, order);
    if (basis.contradicts || sample_size >= given.size()) return search.answer_of(basis);
    const std::size_t count = order.size();
    search.append_outside(basis, order);
    if (order.size() == count) return search.answer_of(basis);
  }
}

}  // namespace

template <class Given>
LinearProgramAnswer linear_program_by_seidel(const Given& given, const Objective& objective) {
  return solve(given, objective, given.size());
}

// The expected number of those that do not hold the optimum of a sample of r is at most 2 N / r: about as many again
// for r the square root of 2 N. Each round finds another half-plane of the final two or three.
template <class Given>
LinearProgramAnswer linear_program_by_sampling(const Given& given, const Objective& objective) {
  const double root = std::sqrt(2.0 * given.size());
  return solve(given, objective, given.size() <= small ? given.size() : static_cast<std::uint32_t>(root));
}

template LinearProgramAnswer linear_program_by_seidel(const Constraints&, const Objective&);
template LinearProgramAnswer linear_program_by_seidel(const HalfPlanes&, const Objective&);
template LinearProgramAnswer linear_program_by_sampling(const Constraints&, const Objective&);
template LinearProgramAnswer linear_program_by_sampling(const HalfPlanes&, const Objective&);

}  // namespace sunder::planar
