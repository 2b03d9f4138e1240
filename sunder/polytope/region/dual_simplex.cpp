#include <sunder/base/contract.h>
#include <sunder/base/interruption.h>
#include <sunder/polytope/region/dual_simplex_internal.h>

#include <algorithm>
#include <utility>

namespace sunder::polytope {

namespace {

// Changes the signs of these coordinates.
void flip(std::vector<Integer>& numbers, const std::array<bool, most_dimension>& is_flipped) {
  for (std::size_t k = 0; k < numbers.size(); ++k) {
    if (is_flipped[k]) numbers[k].backend().negate();
  }
}

}  // namespace

DualSimplex::DualSimplex(const Polytope& half_spaces, std::span<const Dyadic> objective)
    : body_(half_spaces), d_(half_spaces.dimension()), objective_(scaled_integers(objective)) {
  SUNDER_REQUIRE(!half_spaces.is_of_points() && objective.size() == d_);
  for (std::size_t j = 0; j < d_; ++j) is_flipped_[j] = objective_.integers[j] < 0;
  flip(objective_.integers, is_flipped_);
  basis_ = of_box();
}

ScaledIntegers DualSimplex::integers_of(std::uint32_t row) const {
  const std::span<const double> normal = body_.row(row).first(d_);
  ScaledIntegers result = scaled_integers(ExactVector(normal.begin(), normal.end()));
  flip(result.integers, is_flipped_);
  return result;
}

std::uint32_t DualSimplex::row_of(std::size_t i) const {
  return basis_.variable(i).index + (basis_.is_artificial(i) ? first_box_side : 0);
}

void DualSimplex::begin_at(const RowBasis& basis) {
  basis_ = of_box();
  pivots_ = 0;
  const std::span<const std::uint32_t> wanted = std::span(basis.rows).first(d_);
  const auto stays = [&](std::size_t i) {
    return !basis_.is_artificial(i) || std::find(wanted.begin(), wanted.end(), row_of(i)) != wanted.end();
  };
  bool is_one = true;
  for (const std::uint32_t row : wanted) {
    if (row >= first_box_side) continue;
    const ScaledIntegers by = integers_of(row);
    const std::vector<Integer>& t = basis_.in_terms(by.integers);
    std::size_t r = 0;
    while (r < d_ && (stays(r) || t[r].is_zero())) ++r;
    is_one = is_one && r < d_;
    if (is_one) basis_.pivot(r, {0, row, by.unit}, t);
  }
  for (std::size_t i = 0; i < d_; ++i) is_one = is_one && basis_.is_positive(i);
  if (!is_one) basis_ = of_box();
}

// False where the row contradicts the basis.
bool DualSimplex::enter(std::uint32_t row) {
  const ScaledIntegers by = integers_of(row);
  const std::vector<Integer>& t = basis_.in_terms(by.integers);
  const std::size_t r = basis_.leaving_row(t);
  if (r < d_) {
    basis_.pivot(r, {0, row, by.unit}, t);
    ++pivots_;
    return true;
  }
  contradiction_ = {};
  contradiction_.parts.push_back({row, dyadic_of(basis_.denominator(), -by.unit)});
  for (std::size_t i = 0; i < d_; ++i) {
    if (!t[i].is_zero()) contradiction_.parts.push_back({row_of(i), dyadic_of(-t[i], -basis_.variable(i).unit)});
  }
  return false;
}

void DualSimplex::find_vertex() {
  vertex_.assign(d_, Dyadic());
  way_.assign(d_, Dyadic());
  for (std::size_t i = 0; i < d_; ++i) {
    const bool is_side = basis_.is_artificial(i);
    const Dyadic b = is_side ? Dyadic(1.0) : Dyadic(body_.row(row_of(i))[d_]).scaled(-basis_.variable(i).unit);
    if (b.sign() == Sign::zero) continue;
    for (std::size_t j = 0; j < d_; ++j) {
      const Integer& x = basis_.inverse(i)[j];
      if (x.is_zero()) continue;
      Dyadic& sum = (is_side ? way_ : vertex_)[j];
      sum = sum + dyadic_of(is_flipped_[j] ? -x : x, 0) * b;
    }
  }
}

ExactFurthest DualSimplex::most_broken(const ExactVector& p, const Dyadic& w, Cost& cost) const {
  ExactVector direction = p;
  direction.push_back(-w);
  cost.probes += body_.size();
  return exactly_furthest_along(body_.columns(), direction, cost.exact);
}

// Of p + M q, for M great enough: a row that it breaks, or nothing, and then a common point.
bool DualSimplex::go_on(Cost& cost, std::uint32_t& entering) {
  const Dyadic one = denominator();
  if (is_at_box()) {
    const ExactFurthest far = most_broken(way_, Dyadic(), cost);
    entering = far.index;
    if (far.product.sign() == Sign::positive) return true;
  }
  ExactVector p = vertex_;
  for (std::int64_t power = -1;;) {
    const ExactFurthest far = most_broken(p, one, cost);
    entering = far.index;
    if (far.product.sign() != Sign::positive) break;
    const std::span<const double> row = body_.row(far.index);
    if (!is_at_box() || dot(way_, row.first(d_)).sign() == Sign::zero) return true;
    power = power < 0 ? 0 : 2 * power + 1;  // M was not great enough
    for (std::size_t j = 0; j < d_; ++j) p[j] = vertex_[j] + way_[j].scaled(power);
  }
  point_ = {std::move(p), one};
  return false;
}

bool DualSimplex::solve(Cost& cost) {
  for (;;) {
    may_be_interrupted(1000);
    find_vertex();
    if (body_.size() == 0) {
      point_ = {vertex_, denominator()};
      return true;
    }
    std::uint32_t entering = 0;
    if (!go_on(cost, entering)) return true;
    ++cost.iterations;
    if (!enter(entering)) return false;
  }
}

bool DualSimplex::is_at_box() const {
  for (std::size_t i = 0; i < d_; ++i) {
    if (basis_.is_artificial(i)) return true;
  }
  return false;
}

std::vector<DualSimplex::BasisRow> DualSimplex::basis() const {
  std::vector<BasisRow> result;
  for (std::size_t i = 0; i < d_; ++i) {
    result.push_back({row_of(i), dyadic_of(basis_.value(i), objective_.unit - basis_.variable(i).unit)});
  }
  return result;
}

}  // namespace sunder::polytope
