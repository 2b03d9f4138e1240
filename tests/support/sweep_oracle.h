// When do two hulls of points first meet, of which each point goes straight from one place to another? By a dense
// simplex method in integers, with Bland's rule, over all points: an oracle that shares no code with what it checks.
#pragma once

#include <sunder/number/integer_internal.h>
#include <sunder/predicate/point.h>
#include <tests/support/fraction.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace sunder::tests {

using FractionPoint = std::array<Fraction, 3>;

inline Fraction fraction_of(double x) { return Fraction(x); }
inline Fraction fraction_of(const Dyadic& x) { return Fraction(Integer(mantissa_of(x).str())).scaled(x.exponent()); }

// A moving hull: the points under the linear map, and the translations at times 0 and 1.
struct MovingHull {
  std::vector<FractionPoint> turned;
  std::array<FractionPoint, 2> at;

  MovingHull(std::span<const Point3> points, const Affine3& begin, const Affine3& end) {
    for (const Point3& p : points) {
      FractionPoint image;
      for (std::size_t r = 0; r < 3; ++r) {
        image[r] = 0;
        for (std::size_t c = 0; c < 3; ++c) image[r] += fraction_of(begin.linear[3 * r + c]) * fraction_of(p[c]);
      }
      turned.push_back(image);
    }
    for (std::size_t k = 0; k < 3; ++k) {
      at[0][k] = fraction_of(begin.translation[k]);
      at[1][k] = fraction_of(end.translation[k]);
    }
  }

  FractionPoint point(std::size_t i, const Fraction& time) const {
    FractionPoint p = turned[i];
    for (std::size_t k = 0; k < 3; ++k) p[k] += (1 - time) * at[0][k] + time * at[1][k];
    return p;
  }
};

// The tableau: rows of equations with sides that are not negative, a basic variable each. In integers over their common
// denominator, the determinant of the basis (Bareiss 1968).
class DenseSimplex {
 public:
  // Minimises costs . x over x >= 0 with the equations; nothing where there are none. Requires rows of n 2^e.
  static std::optional<Fraction> least(const std::vector<std::vector<Fraction>>& rows,
                                       const std::vector<Fraction>& sides, const std::vector<int>& costs) {
    DenseSimplex simplex;
    const std::size_t n = costs.size(), m = rows.size();
    for (std::size_t i = 0; i < m; ++i) {
      std::int64_t unit = sides[i].exponent();
      for (const Fraction& x : rows[i]) unit = std::min(unit, x.exponent());
      std::vector<Integer> row;
      for (const Fraction& x : rows[i]) row.push_back(x.in_units(unit));
      row.resize(n + m);
      row.push_back(sides[i].in_units(unit));
      if (sides[i] < 0) {
        for (Integer& x : row) x = -x;
      }
      row[n + i] = 1;
      simplex.rows_.push_back(std::move(row));
      simplex.basis_.push_back(n + i);
    }
    std::vector<int> artificial(n + m, 0);
    for (std::size_t i = 0; i < m; ++i) artificial[n + i] = 1;
    if (simplex.minimize(artificial, n + m) > 0) return std::nullopt;
    // What is artificial, and still in the basis at zero, goes out where something else of the row can come in.
    for (std::size_t i = 0; i < m; ++i) {
      for (std::size_t j = 0; simplex.basis_[i] >= n && j < n; ++j) {
        if (simplex.rows_[i][j] != 0) simplex.pivot(i, j);
      }
    }
    std::vector<int> all = costs;
    all.resize(n + m, 0);
    return simplex.minimize(all, n);
  }

 private:
  Fraction minimize(const std::vector<int>& costs, std::size_t columns) {
    for (;;) {
      std::size_t entering = columns;
      for (std::size_t j = 0; j < columns && entering == columns; ++j) {
        if (costs[j] * denominator_ - cost_of(costs, j) < 0) entering = j;
      }
      if (entering == columns) return {cost_of(costs, rows_[0].size() - 1), denominator_};
      std::size_t leaving = rows_.size();
      for (std::size_t i = 0; i < rows_.size(); ++i) {
        if (rows_[i][entering] <= 0) continue;
        if (leaving == rows_.size()) {
          leaving = i;
          continue;
        }
        const Integer x = rows_[i].back() * rows_[leaving][entering], y = rows_[leaving].back() * rows_[i][entering];
        if (x < y || (x == y && basis_[i] < basis_[leaving])) leaving = i;
      }
      pivot(leaving, entering);
    }
  }

  // Of a column, by the costs of the basic variables, times the denominator.
  Integer cost_of(const std::vector<int>& costs, std::size_t column) const {
    Integer sum = 0;
    for (std::size_t i = 0; i < rows_.size(); ++i) {
      if (costs[basis_[i]] != 0) sum += costs[basis_[i]] * rows_[i][column];
    }
    return sum;
  }

  void pivot(std::size_t r, std::size_t c) {
    if (rows_[r][c] < 0) {
      for (Integer& x : rows_[r]) x = -x;
    }
    const Integer by = rows_[r][c];
    for (std::size_t i = 0; i < rows_.size(); ++i) {
      if (i == r) continue;
      const Integer factor = rows_[i][c];
      for (std::size_t j = 0; j < rows_[i].size(); ++j) {
        Integer& x = rows_[i][j];
        x *= by;
        if (factor != 0 && rows_[r][j] != 0) x -= factor * rows_[r][j];
        x /= denominator_;  // leaves no rest
      }
    }
    denominator_ = by;
    basis_[r] = c;
  }

  std::vector<std::vector<Integer>> rows_;  // the last column: the sides
  Integer denominator_ = 1;
  std::vector<std::size_t> basis_;
};

// The first time at which they meet.
inline std::optional<Fraction> first_time(const MovingHull& a, const MovingHull& b) {
  const std::size_t n = a.turned.size() + b.turned.size();
  std::vector<std::vector<Fraction>> rows(6, std::vector<Fraction>(n + 2, 0));
  for (std::size_t j = 0; j < n; ++j) {
    const bool is_a = j < a.turned.size();
    const FractionPoint& p = is_a ? a.turned[j] : b.turned[j - a.turned.size()];
    for (std::size_t k = 0; k < 3; ++k) rows[k][j] = is_a ? p[k] : -p[k];
    rows[is_a ? 3 : 4][j] = 1;
  }
  for (std::size_t end = 0; end < 2; ++end) {
    for (std::size_t k = 0; k < 3; ++k) rows[k][n + end] = a.at[end][k] - b.at[end][k];
    rows[5][n + end] = 1;
  }
  std::vector<int> costs(n + 2, 0);
  costs.back() = 1;
  return DenseSimplex::least(rows, {0, 0, 0, 1, 1, 1}, costs);
}

}  // namespace sunder::tests
