// Seidel's method for all, or for samples (linear_program_search.h).
#include <sunder/planar/region/linear_program_search.h>

#include <cmath>

namespace sunder::planar {

namespace {

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
