// The basis of a simplex method in integers: its inverse times its determinant, one pivot after another, without a
// fraction (Edmonds 1967, Bareiss 1968).
#pragma once

#include <sunder/number/integer_internal.h>
#include <sunder/predicate/posed.h>

#include <array>
#include <cstddef>
#include <optional>

namespace sunder::solid {

template <std::size_t Most>
struct IntegerBasis {
  using Column = std::array<Integer, Most>;

  std::size_t rows = 0;
  Integer determinant = 1;             // of the basis, as its absolute value
  std::array<Column, Most> inverse{};  // of the basis, times the determinant
  Column solution{};                   // the values of the basic variables, times the determinant

  // The basis of artificial variables, with the signs that make the solution not negative.
  void start(const Column& right_hand_side) {
    for (std::size_t i = 0; i < rows; ++i) {
      inverse[i] = {};
      inverse[i][i] = right_hand_side[i] < 0 ? -1 : 1;
      solution[i] = boost::multiprecision::abs(right_hand_side[i]);
    }
  }

  // A column in terms of the basis, times the determinant.
  Column in_terms(const Column& c) const {
    Column t{};
    for (std::size_t i = 0; i < rows; ++i) {
      for (std::size_t k = 0; k < rows; ++k) t[i] += inverse[i][k] * c[k];
    }
    return t;
  }

  // Among rows with t > 0, of which there must be one, the lexicographically least (solution, inverse) / t (Dantzig,
  // Orden, Wolfe 1955): so a method ends whatever the degeneracy.
  std::size_t leaving_row(const Column& t, StageTally& tally) const {
    std::optional<std::size_t> best;
    for (std::size_t i = 0; i < rows; ++i) {
      if (t[i] <= 0) continue;
      if (!best || lexicographically_less(i, *best, t, tally)) best = i;
    }
    return *best;
  }

  // The column of these terms comes in, in row r.
  void pivot(std::size_t r, const Column& t) {
    for (std::size_t i = 0; i < rows; ++i) {
      if (i == r) continue;
      for (std::size_t k = 0; k < rows; ++k) {
        inverse[i][k] = (inverse[i][k] * t[r] - inverse[r][k] * t[i]) / determinant;  // exact
      }
      solution[i] = (solution[i] * t[r] - solution[r] * t[i]) / determinant;
    }
    determinant = t[r];
  }

 private:
  bool lexicographically_less(std::size_t i, std::size_t j, const Column& t, StageTally& tally) const {
    const auto less = [&](const Integer& at_i, const Integer& at_j) {
      ++tally.exact;
      return (at_i * t[j]).compare(at_j * t[i]);
    };
    int order = less(solution[i], solution[j]);
    for (std::size_t k = 0; order == 0 && k < rows; ++k) order = less(inverse[i][k], inverse[j][k]);
    return order < 0;
  }
};

}  // namespace sunder::solid
