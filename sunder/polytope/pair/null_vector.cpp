#include <sunder/base/contract.h>
#include <sunder/polytope/pair/null_vector_internal.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>

namespace sunder::polytope {

namespace {

// Of each equation n + 1 integers, and about what they are.
struct System {
  std::size_t equations = 0, unknowns = 0;
  std::array<std::array<Integer, most_vectors>, most_dimension> numbers{};
  std::array<std::array<double, most_vectors>, most_dimension> rounded{};
};

// Each equation times a power of two.
void fill(System& system, std::span<const ExactVector> vectors) {
  system.equations = vectors[0].size();
  system.unknowns = vectors.size() - 1;
  for (std::size_t r = 0; r < system.equations; ++r) {
    std::int64_t unit = std::numeric_limits<std::int64_t>::max(), top = std::numeric_limits<std::int64_t>::min();
    for (const ExactVector& v : vectors) {
      if (v[r].sign() == Sign::zero) continue;
      unit = std::min(unit, v[r].exponent());
      top = std::max(top, v[r].top());
    }
    for (std::size_t j = 0; j < vectors.size(); ++j) {
      const Dyadic& x = vectors[j][r];
      if (x.sign() == Sign::zero) continue;
      system.numbers[r][j] = mantissa_of(x) << static_cast<unsigned>(x.exponent() - unit);
      system.rounded[r][j] = x.scaled(-top).nearest();
    }
  }
}

// Puts equations first that floating point has as independent, by elimination; false where it finds fewer than there
// are unknowns.
bool put_independent_first(System& system) {
  auto& m = system.rounded;
  const std::size_t n = system.unknowns;
  std::array<bool, most_vectors> is_done{};
  for (std::size_t k = 0; k < n; ++k) {
    std::size_t row = k, column = 0;
    double greatest = 0;
    for (std::size_t i = k; i < system.equations; ++i) {
      for (std::size_t j = 0; j <= n; ++j) {
        if (!is_done[j] && std::fabs(m[i][j]) > greatest) {
          greatest = std::fabs(m[i][j]);
          row = i;
          column = j;
        }
      }
    }
    if (!(greatest > 0)) return false;
    if (row != k) {
      std::swap(m[row], m[k]);
      std::swap(system.numbers[row], system.numbers[k]);
    }
    is_done[column] = true;
    for (std::size_t i = k + 1; i < system.equations; ++i) {
      const double factor = m[i][column] / m[k][column];
      for (std::size_t j = 0; j <= n; ++j) m[i][j] -= factor * m[k][j];
    }
  }
  return true;
}

// By expansion along rows, each set of columns once.
std::array<Integer, most_vectors> by_determinants(const System& system) {
  const std::size_t n = system.unknowns;
  std::array<Integer, std::size_t{1} << most_vectors> minor;
  minor[0] = 1;
  const std::size_t all = (std::size_t{1} << (n + 1)) - 1;
  for (std::size_t set = 1; set < all; ++set) {  // of columns; their number is that of rows
    const auto row = static_cast<std::size_t>(std::popcount(set)) - 1;
    bool is_negative = row % 2 != 0;
    for (std::size_t rest = set; rest != 0; rest &= rest - 1, is_negative = !is_negative) {
      const auto column = static_cast<std::size_t>(std::countr_zero(rest));
      const Integer &entry = system.numbers[row][column], &other = minor[set ^ (std::size_t{1} << column)];
      if (entry.is_zero() || other.is_zero()) continue;
      if (is_negative) {
        minor[set] -= entry * other;
      } else {
        minor[set] += entry * other;
      }
    }
  }
  std::array<Integer, most_vectors> v;
  bool is_negative = n % 2 != 0;
  for (std::size_t j = 0; j <= n; ++j, is_negative = !is_negative) {
    v[j] = std::move(minor[all ^ (std::size_t{1} << j)]);
    if (is_negative) v[j].backend().negate();
  }
  return v;
}

}  // namespace

std::optional<std::array<Integer, most_vectors>> null_vector(std::span<const ExactVector> vectors) {
  SUNDER_REQUIRE(!vectors.empty() && vectors.size() <= most_vectors && vectors[0].size() <= most_dimension);
  SUNDER_REQUIRE(vectors.size() <= vectors[0].size() + 1);
  System system;
  fill(system, vectors);
  if (!put_independent_first(system)) return std::nullopt;
  const std::size_t n = system.unknowns;
  std::array<Integer, most_vectors> v = by_determinants(system);
  if (std::all_of(v.begin(), v.begin() + static_cast<std::ptrdiff_t>(n) + 1, [](const Integer& x) { return x.is_zero(); })) {
    return std::nullopt;
  }
  for (std::size_t i = n; i < system.equations; ++i) {
    Integer sum = 0;
    for (std::size_t j = 0; j <= n; ++j) sum += v[j] * system.numbers[i][j];
    if (!sum.is_zero()) return std::nullopt;
  }
  if (v[n] < 0) {
    for (std::size_t j = 0; j <= n; ++j) v[j].backend().negate();
  }
  return v;
}

}  // namespace sunder::polytope
