#include <sunder/base/contract.h>
#include <sunder/number/integer_internal.h>
#include <sunder/polytope/pair/common_weights.h>
#include <sunder/polytope/pair/placed.h>
#include <sunder/polytope/pair/support.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <utility>

namespace sunder::polytope {

namespace {

constexpr std::size_t most_points = most_dimension + 2, most_named = 2 * (most_dimension + 1);

// A point of A or of B.
struct Named {
  bool is_of_a = false;
  std::uint32_t row = 0;
};

// Up to so many of them, those of A first.
template <std::size_t Most>
struct NamedList {
  std::array<Named, Most> item{};
  std::size_t count = 0, count_a = 0;

  void add(const Named& named) {
    item[count++] = named;
    count_a += named.is_of_a ? 1 : 0;
  }
};

// Those that are in the basis where floating point ends phase one of the simplex method, for weights of a common point.
// Columns are images less that of the first, and a 1 for the body that they are of.
NamedList<most_points> likely(const Polytope& a, const Pose& pose_a, const Polytope& b, const Pose& pose_b,
                              const NamedList<most_named>& named) {
  const std::size_t d = a.dimension(), rows = d + 2, count = named.count;
  std::array<std::array<double, most_named + 1>, most_points + 1> table{};  // last column: sides; last row: prices
  std::array<std::size_t, most_points> basis{};
  basis.fill(count);
  const Vector origin = rounded_image(a, pose_a, named.item[0].row);
  for (std::size_t k = 0; k < count; ++k) {
    const bool is_of_a = named.item[k].is_of_a;
    const Vector image = is_of_a ? rounded_image(a, pose_a, named.item[k].row) : rounded_image(b, pose_b, named.item[k].row);
    for (std::size_t i = 0; i < d; ++i) table[i][k] = is_of_a ? image[i] - origin[i] : origin[i] - image[i];
    table[is_of_a ? d : d + 1][k] = 1;
  }
  for (std::size_t i = 0; i < rows; ++i) {
    double greatest = 0;
    for (std::size_t k = 0; k < count; ++k) greatest = std::max(greatest, std::fabs(table[i][k]));
    if (!std::isfinite(greatest)) return {};
    for (std::size_t k = 0; k < count && greatest > 0; ++k) table[i][k] /= greatest;
    table[i][count] = i < d ? 0 : 1;
    for (std::size_t k = 0; k <= count; ++k) table[rows][k] += table[i][k];
  }
  constexpr double small = 0x1p-40;
  for (std::size_t step = 0; step < 4 * rows; ++step) {
    const auto prices = table[rows].begin();
    const auto entering = static_cast<std::size_t>(
        std::max_element(prices, prices + static_cast<std::ptrdiff_t>(count)) - prices);
    if (!(table[rows][entering] > small)) break;
    std::size_t leaving = rows;
    for (std::size_t i = 0; i < rows; ++i) {
      if (table[i][entering] > small && (leaving == rows || table[i][count] * table[leaving][entering] <
                                                                table[leaving][count] * table[i][entering])) {
        leaving = i;
      }
    }
    if (leaving == rows) break;
    const double by = 1 / table[leaving][entering];
    for (std::size_t k = 0; k <= count; ++k) table[leaving][k] *= by;
    for (std::size_t i = 0; i <= rows; ++i) {
      if (i == leaving) continue;
      const double factor = table[i][entering];
      for (std::size_t k = 0; k <= count; ++k) table[i][k] -= factor * table[leaving][k];
    }
    basis[leaving] = entering;
  }
  NamedList<most_points> result;
  for (std::size_t k = 0; k < count; ++k) {
    if (std::find(basis.begin(), basis.end(), k) != basis.end()) result.add(named.item[k]);
  }
  return result;
}

// The system of common_weights.h: of each equation n + 1 integers; the last column is the right-hand side, negated.
struct System {
  std::size_t equations = 0, unknowns = 0;
  std::array<std::array<Integer, most_dimension + 1>, most_dimension> numbers{};
  std::array<std::array<double, most_dimension + 1>, most_dimension> rounded{};
};

// Puts equations first that floating point has as independent, by elimination; false where it finds fewer than there
// are unknowns.
bool put_independent_first(System& system) {
  auto& m = system.rounded;
  const std::size_t n = system.unknowns;
  std::array<bool, most_dimension + 1> is_done{};
  for (std::size_t k = 0; k < n; ++k) {
    std::size_t row = k, column = 0;
    double greatest = 0;
    for (std::size_t i = k; i < system.equations; ++i) {
      for (std::size_t j = 0; j < n; ++j) {
        if (!is_done[j] && std::fabs(m[i][j]) > greatest) {
          greatest = std::fabs(m[i][j]);
          row = i;
          column = j;
        }
      }
    }
    if (!(greatest > 0)) return false;
    std::swap(m[row], m[k]);
    std::swap(system.numbers[row], system.numbers[k]);
    is_done[column] = true;
    for (std::size_t i = k + 1; i < system.equations; ++i) {
      const double factor = m[i][column] / m[k][column];
      for (std::size_t j = 0; j < n; ++j) m[i][j] -= factor * m[k][j];
    }
  }
  return true;
}

// A vector v, v_n >= 0, with sum_j v_j m_ij = 0 for the first n equations i: determinants of their columns but j. By
// expansion along rows, each set of columns once.
std::array<Integer, most_dimension + 1> null_vector(const System& system) {
  const std::size_t n = system.unknowns;
  std::array<Integer, std::size_t{1} << (most_dimension + 1)> minor;
  minor[0] = 1;
  const std::size_t all = (std::size_t{1} << (n + 1)) - 1;
  for (std::size_t set = 1; set < all; ++set) {  // of columns; their number is that of rows
    const auto row = static_cast<std::size_t>(std::popcount(set)) - 1;
    if (row >= n) continue;
    bool is_negative = row % 2 != 0;
    for (std::size_t rest = set; rest != 0; rest &= rest - 1, is_negative = !is_negative) {
      const Integer& entry = system.numbers[row][static_cast<std::size_t>(std::countr_zero(rest))];
      const Integer& other = minor[set ^ (rest & (~rest + 1))];
      if (entry.is_zero() || other.is_zero()) continue;
      if (is_negative) {
        minor[set] -= entry * other;
      } else {
        minor[set] += entry * other;
      }
    }
  }
  std::array<Integer, most_dimension + 1> v;
  bool is_negative = false;
  for (std::size_t j = 0; j <= n; ++j, is_negative = !is_negative) {
    v[j] = std::move(minor[all ^ (std::size_t{1} << j)]);
    if (is_negative) v[j] = -v[j];
  }
  if (v[n] < 0) {
    for (std::size_t j = 0; j <= n; ++j) v[j] = -v[j];
  }
  return v;
}

class CommonPoint {
 public:
  CommonPoint(const Polytope& a, const Pose& pose_a, const Polytope& b, const Pose& pose_b,
              const NamedList<most_points>& named)
      : a_(a, pose_a), b_(b, pose_b), d_(a.dimension()), named_(named) {}

  std::optional<ExactEvidence> find() {
    if (named_.count_a == 0 || named_.count_a == named_.count || named_.count > d_ + 2) return std::nullopt;
    for (std::size_t k = 0; k < named_.count; ++k) {
      images_[k] = (named_.item[k].is_of_a ? a_ : b_).image(named_.item[k].row);
    }
    System system;
    fill(system);
    if (!put_independent_first(system)) return std::nullopt;
    const std::array<Integer, most_dimension + 1> v = null_vector(system);
    const Integer& denominator = v[system.unknowns];
    if (denominator.is_zero()) return std::nullopt;
    for (std::size_t i = system.unknowns; i < d_; ++i) {
      Integer sum = 0;
      for (std::size_t j = 0; j <= system.unknowns; ++j) sum += v[j] * system.numbers[i][j];
      if (!sum.is_zero()) return std::nullopt;
    }
    std::array<Integer, most_points> weights;
    Integer rest_a = denominator, rest_b = denominator;
    for (std::size_t k = 1, j = 0; k < named_.count; ++k) {
      if (k == named_.count_a) continue;  // the first of B
      if (v[j] < 0) return std::nullopt;
      (named_.item[k].is_of_a ? rest_a : rest_b) -= v[j];
      weights[k] = v[j++];
    }
    if (rest_a < 0 || rest_b < 0) return std::nullopt;
    weights[0] = rest_a;
    weights[named_.count_a] = rest_b;
    return evidence(weights, denominator);
  }

 private:
  // Each equation times a power of two.
  void fill(System& system) const {
    system.equations = d_;
    system.unknowns = named_.count - 2;
    for (std::size_t r = 0; r < d_; ++r) {
      std::int64_t unit = std::numeric_limits<std::int64_t>::max();
      for (std::size_t k = 0; k < named_.count; ++k) {
        const Dyadic& x = images_[k][r];
        if (x.sign() != Sign::zero) unit = std::min(unit, x.exponent());
      }
      std::array<Integer, most_points> x;
      for (std::size_t k = 0; k < named_.count; ++k) {
        const Dyadic& from = images_[k][r];
        if (from.sign() != Sign::zero) x[k] = mantissa_of(from) << static_cast<unsigned>(from.exponent() - unit);
      }
      const Integer &first_a = x[0], &first_b = x[named_.count_a];
      auto& row = system.numbers[r];
      std::size_t j = 0;
      for (std::size_t k = 1; k < named_.count; ++k) {
        if (k < named_.count_a) row[j++] = x[k] - first_a;
        if (k > named_.count_a) row[j++] = first_b - x[k];
      }
      row[j] = first_a - first_b;
      double greatest = 0;
      for (std::size_t i = 0; i <= j; ++i) {
        system.rounded[r][i] = dyadic_of(row[i], 0).nearest();
        greatest = std::max(greatest, std::fabs(system.rounded[r][i]));
      }
      for (std::size_t i = 0; i <= j && greatest > 0; ++i) system.rounded[r][i] /= greatest;
    }
  }

  ExactEvidence evidence(const std::array<Integer, most_points>& weights, const Integer& denominator) const {
    ExactEvidence result;
    result.numbers.resize(d_);
    result.denominator = result.of_a.denominator = result.of_b.denominator = dyadic_of(denominator, 0);
    for (std::size_t k = 0; k < named_.count; ++k) {
      if (weights[k].is_zero()) continue;
      const Dyadic weight = dyadic_of(weights[k], 0);
      const bool is_of_a = named_.item[k].is_of_a;
      (is_of_a ? result.of_a : result.of_b).parts.push_back({named_.item[k].row, weight});
      if (!is_of_a) continue;
      for (std::size_t c = 0; c < d_; ++c) result.numbers[c] = result.numbers[c] + weight * images_[k][c];
    }
    return result;
  }

  Placed a_, b_;
  std::size_t d_;
  const NamedList<most_points>& named_;
  std::array<ExactVector, most_points> images_;
};

}  // namespace

std::optional<ExactEvidence> common_point_by_determinants(const Polytope& a, const Pose& pose_a, const Polytope& b,
                                                          const Pose& pose_b, NamedPoints named) {
  SUNDER_REQUIRE(named.of_a.size() <= most_dimension + 1 && named.of_b.size() <= most_dimension + 1);
  if (named.of_a.empty() || named.of_b.empty()) return std::nullopt;
  NamedList<most_named> all;
  for (const std::uint32_t k : named.of_a) all.add({true, k});
  for (const std::uint32_t k : named.of_b) all.add({false, k});
  NamedList<most_points> few;
  if (all.count <= a.dimension() + 2) {
    for (std::size_t k = 0; k < all.count; ++k) few.add(all.item[k]);
  } else {
    few = likely(a, pose_a, b, pose_b, all);
  }
  return CommonPoint(a, pose_a, b, pose_b, few).find();
}

}  // namespace sunder::polytope
