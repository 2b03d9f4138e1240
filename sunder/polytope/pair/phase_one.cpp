#include <sunder/number/exact/scaled_integers_internal.h>
#include <sunder/polytope/pair/phase_one_internal.h>

#include <algorithm>

namespace sunder::polytope {

namespace {

std::vector<Integer> last_ones(std::size_t rows, std::size_t ones) {
  std::vector<Integer> result(rows);
  std::fill_n(result.rbegin(), ones, 1);
  return result;
}

}  // namespace

PhaseOne::PhaseOne(std::size_t rows, std::size_t ones) : basis_(last_ones(rows, ones)) {}

bool PhaseOne::enter_if_it_pays(BasicVariable variable, std::span<const Dyadic> column) {
  const ScaledIntegers scaled = scaled_integers(column);
  variable.unit = scaled.unit;
  return basis_.enter_if_it_pays(variable, scaled.integers);
}

std::vector<Dyadic> PhaseOne::multipliers() const {
  std::vector<Dyadic> result;
  for (const Integer& n : basis_.multipliers()) result.push_back(dyadic_of(n, 0));
  return result;
}

std::vector<PhaseOne::Weight> PhaseOne::weights() const {
  std::vector<Weight> result;
  for (std::size_t i = 0; i < basis_.rows(); ++i) {
    const BasicVariable& variable = basis_.variable(i);
    if (basis_.is_artificial(i) || basis_.value(i).is_zero()) continue;
    result.push_back({variable, dyadic_of(basis_.value(i), -variable.unit)});
  }
  return result;
}

}  // namespace sunder::polytope
