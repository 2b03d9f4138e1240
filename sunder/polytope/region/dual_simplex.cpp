#include <sunder/base/contract.h>
#include <sunder/base/interruption.h>
#include <sunder/polytope/region/dual_simplex_internal.h>

#include <algorithm>
#include <limits>
#include <utility>

namespace sunder::polytope {

namespace {

struct Scaled {
  std::vector<Integer> integers;
  std::int64_t unit = 0;
};

Scaled scaled(std::span<const Dyadic> numbers) {
  constexpr std::int64_t none = std::numeric_limits<std::int64_t>::max();
  std::int64_t unit = none;
  for (const Dyadic& x : numbers) {
    if (x.sign() != Sign::zero) unit = std::min(unit, x.exponent());
  }
  Scaled result{std::vector<Integer>(numbers.size()), unit == none ? 0 : unit};
  for (std::size_t k = 0; k < numbers.size(); ++k) {
    if (numbers[k].sign() == Sign::zero) continue;
    result.integers[k] = mantissa_of(numbers[k]) << static_cast<unsigned>(numbers[k].exponent() - unit);
  }
  return result;
}

}  // namespace

DualSimplex::DualSimplex(const Polytope& half_spaces, std::span<const Dyadic> objective)
    : body_(half_spaces), d_(half_spaces.dimension()) {
  SUNDER_REQUIRE(!half_spaces.is_of_points() && objective.size() == d_);
  auto [integers, unit] = scaled(objective);
  objective_ = std::move(integers);
  objective_unit_ = unit;
  for (std::size_t j = 0; j < d_; ++j) signs_[j] = objective_[j] < 0 ? -1 : 1;
  begin_at_box();
}

void DualSimplex::begin_at_box() {
  determinant_ = 1;
  inverse_.assign(d_ * d_, Integer(0));
  for (std::size_t j = 0; j < d_; ++j) {
    basis_[j] = first_box_side + static_cast<std::uint32_t>(j);
    units_[j] = 0;
    inverse_[j * d_ + j] = signs_[j];
  }
  pivots_ = 0;
}

DualSimplex::RowIntegers DualSimplex::integers_of(std::uint32_t row) const {
  const std::span<const double> normal = body_.row(row).first(d_);
  auto [integers, unit] = scaled(ExactVector(normal.begin(), normal.end()));
  return {std::move(integers), unit};
}

DualSimplex::Column DualSimplex::in_terms_of_basis(const Column& normal) const {
  Column t(d_);
  for (std::size_t j = 0; j < d_; ++j) {
    if (normal[j].is_zero()) continue;
    for (std::size_t i = 0; i < d_; ++i) {
      if (!inverse_[j * d_ + i].is_zero()) t[i] += normal[j] * inverse_[j * d_ + i];
    }
  }
  return t;
}

Integer DualSimplex::weight(std::size_t i) const {
  Integer sum = 0;
  for (std::size_t j = 0; j < d_; ++j) {
    if (!objective_[j].is_zero()) sum += objective_[j] * inverse_[j * d_ + i];
  }
  return sum;
}

bool DualSimplex::is_positive(std::size_t i) const {
  const Integer first = weight(i);
  if (!first.is_zero()) return first > 0;
  for (std::size_t j = 0; j < d_; ++j) {
    const Integer& x = inverse_[j * d_ + i];
    if (!x.is_zero()) return (x > 0) == (signs_[j] > 0);
  }
  return false;
}

// Is the perturbed weight of i over t_i less than that of j?
bool DualSimplex::leaves_before(std::size_t i, std::size_t j, const Column& t) const {
  int order = (weight(i) * t[j]).compare(weight(j) * t[i]);
  for (std::size_t k = 0; order == 0 && k < d_; ++k) {
    order = signs_[k] * (inverse_[k * d_ + i] * t[j]).compare(inverse_[k * d_ + j] * t[i]);
  }
  return order < 0;
}

void DualSimplex::replace(std::size_t r, std::uint32_t row, const RowIntegers& by, const Column& t) {
  const bool is_negative = t[r] < 0;
  for (std::size_t j = 0; j < d_; ++j) {
    Integer* const line = &inverse_[j * d_];
    for (std::size_t i = 0; i < d_; ++i) {
      if (i == r) continue;
      const bool is_changed = !line[r].is_zero() && !t[i].is_zero();
      if (!line[i].is_zero()) line[i] *= t[r];
      if (is_changed) line[i] -= line[r] * t[i];
      if (!line[i].is_zero()) line[i] /= determinant_;  // exact
      if (is_negative) line[i] = -line[i];
    }
    if (is_negative) line[r] = -line[r];
  }
  determinant_ = is_negative ? -t[r] : t[r];
  basis_[r] = row;
  units_[r] = by.unit;
}

void DualSimplex::begin_at(const RowBasis& basis) {
  begin_at_box();
  const std::span<const std::uint32_t> wanted = std::span(basis.rows).first(d_);
  const auto stays = [&](std::size_t i) {
    return !is_side(i) || std::find(wanted.begin(), wanted.end(), basis_[i]) != wanted.end();
  };
  for (const std::uint32_t row : wanted) {
    if (row >= first_box_side) continue;
    const RowIntegers by = integers_of(row);
    const Column t = in_terms_of_basis(by.normal);
    std::size_t r = 0;
    while (r < d_ && (stays(r) || t[r].is_zero())) ++r;
    if (r == d_) return begin_at_box();
    replace(r, row, by, t);
  }
  for (std::size_t i = 0; i < d_; ++i) {
    if (!is_positive(i)) return begin_at_box();
  }
}

// False where the row contradicts the basis.
bool DualSimplex::enter(std::uint32_t row) {
  const RowIntegers by = integers_of(row);
  const Column t = in_terms_of_basis(by.normal);
  std::size_t r = d_;
  for (std::size_t i = 0; i < d_; ++i) {
    if (t[i] > 0 && (r == d_ || leaves_before(i, r, t))) r = i;
  }
  if (r < d_) {
    replace(r, row, by, t);
    ++pivots_;
    return true;
  }
  contradiction_ = {};
  contradiction_.parts.push_back({row, dyadic_of(determinant_, -by.unit)});
  for (std::size_t i = 0; i < d_; ++i) {
    if (!t[i].is_zero()) contradiction_.parts.push_back({basis_[i], dyadic_of(-t[i], -units_[i])});
  }
  return false;
}

void DualSimplex::find_vertex() {
  vertex_.assign(d_, Dyadic());
  way_.assign(d_, Dyadic());
  for (std::size_t i = 0; i < d_; ++i) {
    const Dyadic b = is_side(i) ? Dyadic() : Dyadic(body_.row(basis_[i])[d_]).scaled(-units_[i]);
    for (std::size_t j = 0; j < d_; ++j) {
      const Integer& x = inverse_[j * d_ + i];
      if (x.is_zero()) continue;
      if (is_side(i)) {
        way_[j] = way_[j] + dyadic_of(x, 0);
      } else if (b.sign() != Sign::zero) {
        vertex_[j] = vertex_[j] + dyadic_of(x, 0) * b;
      }
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
  const Dyadic one = dyadic_of(determinant_, 0);
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
      point_ = {vertex_, dyadic_of(determinant_, 0)};
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
    if (is_side(i)) return true;
  }
  return false;
}

bool DualSimplex::is_unbounded() const {
  for (std::size_t i = 0; i < d_; ++i) {
    if (is_side(i) && !weight(i).is_zero()) return true;
  }
  return false;
}

std::vector<DualSimplex::BasisRow> DualSimplex::basis() const {
  std::vector<BasisRow> result;
  for (std::size_t i = 0; i < d_; ++i) result.push_back({basis_[i], dyadic_of(weight(i), objective_unit_ - units_[i])});
  return result;
}

}  // namespace sunder::polytope
