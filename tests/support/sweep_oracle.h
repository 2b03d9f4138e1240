// When do two hulls of points first meet, of which each point goes straight from one place to another? By a dense
// simplex method on fractions, with Bland's rule, over all points: an oracle that shares no code with what it checks.
#pragma once

#include <sunder/number/integer_internal.h>
#include <sunder/predicate/point.h>

#include <boost/multiprecision/cpp_int.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace sunder::tests {

using Fraction =
    boost::multiprecision::number<boost::multiprecision::cpp_rational::backend_type, boost::multiprecision::et_off>;
using FractionPoint = std::array<Fraction, 3>;

// Times 2^exponent.
inline Fraction scaled(Fraction x, std::int64_t exponent) {
  for (; exponent > 0; exponent -= std::min<std::int64_t>(exponent, 60)) {
    x *= std::int64_t{1} << std::min<std::int64_t>(exponent, 60);
  }
  for (; exponent < 0; exponent += std::min<std::int64_t>(-exponent, 60)) {
    x /= std::int64_t{1} << std::min<std::int64_t>(-exponent, 60);
  }
  return x;
}

inline Fraction fraction_of(double x) {
  int e = 0;
  const double m = std::frexp(x, &e);
  return scaled(Fraction(static_cast<std::int64_t>(std::ldexp(m, 53))), e - 53);
}

inline Fraction fraction_of(const Dyadic& x) { return scaled(Fraction(mantissa_of(x).str()), x.exponent()); }

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

// The tableau: rows of equations with sides that are not negative, a basic variable each, and a row of costs.
class DenseSimplex {
 public:
  // Minimises costs . x over x >= 0 with the equations; nothing where there are none.
  static std::optional<Fraction> least(std::vector<std::vector<Fraction>> rows, std::vector<Fraction> sides,
                                       const std::vector<Fraction>& costs) {
    DenseSimplex simplex;
    const std::size_t n = costs.size(), m = rows.size();
    for (std::size_t i = 0; i < m; ++i) {
      if (sides[i] < 0) {
        sides[i] = -sides[i];
        for (Fraction& x : rows[i]) x = -x;
      }
      rows[i].resize(n + m, 0);
      rows[i][n + i] = 1;
      rows[i].push_back(sides[i]);
      simplex.basis_.push_back(n + i);
    }
    simplex.rows_ = std::move(rows);
    std::vector<Fraction> artificial(n + m, 0);
    for (std::size_t i = 0; i < m; ++i) artificial[n + i] = 1;
    if (simplex.minimize(artificial, n + m) > 0) return std::nullopt;
    // What is artificial, and still in the basis at zero, goes out where something else of the row can come in.
    for (std::size_t i = 0; i < m; ++i) {
      for (std::size_t j = 0; simplex.basis_[i] >= n && j < n; ++j) {
        if (simplex.rows_[i][j] != 0) simplex.pivot(i, j);
      }
    }
    std::vector<Fraction> all = costs;
    all.resize(n + m, 0);
    return simplex.minimize(all, n);
  }

 private:
  Fraction minimize(const std::vector<Fraction>& costs, std::size_t columns) {
    for (;;) {
      std::size_t entering = columns;
      for (std::size_t j = 0; j < columns && entering == columns; ++j) {
        Fraction reduced = costs[j];
        for (std::size_t i = 0; i < rows_.size(); ++i) reduced -= costs[basis_[i]] * rows_[i][j];
        if (reduced < 0) entering = j;
      }
      if (entering == columns) break;
      std::size_t leaving = rows_.size();
      for (std::size_t i = 0; i < rows_.size(); ++i) {
        if (rows_[i][entering] <= 0) continue;
        if (leaving == rows_.size()) {
          leaving = i;
          continue;
        }
        const Fraction x = rows_[i].back() * rows_[leaving][entering], y = rows_[leaving].back() * rows_[i][entering];
        if (x < y || (x == y && basis_[i] < basis_[leaving])) leaving = i;
      }
      pivot(leaving, entering);
    }
    Fraction value = 0;
    for (std::size_t i = 0; i < rows_.size(); ++i) value += costs[basis_[i]] * rows_[i].back();
    return value;
  }

  void pivot(std::size_t r, std::size_t c) {
    const Fraction by = rows_[r][c];
    for (Fraction& x : rows_[r]) x /= by;
    for (std::size_t i = 0; i < rows_.size(); ++i) {
      if (i == r || rows_[i][c] == 0) continue;
      const Fraction factor = rows_[i][c];
      for (std::size_t j = 0; j < rows_[i].size(); ++j) rows_[i][j] -= factor * rows_[r][j];
    }
    basis_[r] = c;
  }

  std::vector<std::vector<Fraction>> rows_;  // the last column: the sides
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
  std::vector<Fraction> costs(n + 2, 0);
  costs.back() = 1;
  return DenseSimplex::least(std::move(rows), {0, 0, 0, 1, 1, 1}, costs);
}

}  // namespace sunder::tests
