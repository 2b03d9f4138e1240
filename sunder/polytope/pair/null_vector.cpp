#include <sunder/base/contract.h>
#include <sunder/number/exact/elimination_internal.h>
#include <sunder/number/rounded_elimination_internal.h>
#include <sunder/polytope/pair/null_vector_internal.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace sunder::polytope {

namespace {

using Entry = FewWords::Entry;
using Number = FewWords::Number;
using Numbers = std::array<Number, most_vectors>;

// x 2^shift. Requires that this fits.
Entry entry_of(const Dyadic& x, std::int64_t shift) {
  const auto& mantissa = mantissa_of(x).backend();
  FewWords::Word2 size = mantissa.limbs()[0];
  if (mantissa.size() > 1) size |= FewWords::Word2{mantissa.limbs()[1]} << 64;
  return {size << shift, mantissa.sign()};
}

// About what it is over 2^bits.
double rounded_entry(const Entry& e, std::int64_t bits) {
  const double size = static_cast<double>(e.size) * std::ldexp(1.0, -static_cast<int>(bits));
  return e.is_negative ? -size : size;
}

// A determinant of k <= 6 rows is at most k! < 2^10 times the product of their greatest numbers; so is the sum that an
// equation is checked by.
constexpr std::int64_t bits_of_factorial = 10;

// Nothing where they do not fit.
std::optional<FewWordVectors> few_words_of(std::span<const ExactVector> vectors) {
  FewWordVectors result{.equations = vectors[0].size(), .count = vectors.size()};
  std::array<std::int64_t, most_dimension> unit{};
  for (std::size_t r = 0; r < result.equations; ++r) {
    unit[r] = std::numeric_limits<std::int64_t>::max();
    std::int64_t top = std::numeric_limits<std::int64_t>::min();
    for (const ExactVector& v : vectors) {
      if (v[r].sign() == Sign::zero) continue;
      unit[r] = std::min(unit[r], v[r].exponent());
      top = std::max(top, v[r].top());
    }
    if (top >= unit[r]) result.bits[r] = top - unit[r] + 1;
  }
  if (!result.fit()) return std::nullopt;
  for (std::size_t r = 0; r < result.equations; ++r) {
    for (std::size_t j = 0; j < result.count; ++j) {
      const Dyadic& x = vectors[j][r];
      if (x.sign() != Sign::zero) result.numbers[r][j] = entry_of(x, x.exponent() - unit[r]);
    }
  }
  return result;
}

// Of each equation n + 1 integers.
struct System {
  std::size_t equations = 0, unknowns = 0;
  std::array<std::array<Entry, most_vectors>, most_dimension> numbers{};
  std::array<std::int64_t, most_dimension> bits{};  // of the integers of each equation, at most

  explicit System(const FewWordVectors& vectors)
      : equations(vectors.equations), unknowns(vectors.count - 1), numbers(vectors.numbers), bits(vectors.bits) {}

  // Puts equations first that floating point has as independent; false where it finds fewer than there are unknowns. Of
  // as many equations as unknowns it is the determinants that tell.
  bool put_independent_first() {
    if (equations == unknowns) return true;
    RoundedElimination rounded(equations, unknowns + 1);
    for (std::size_t r = 0; r < equations; ++r) {
      for (std::size_t j = 0; j <= unknowns; ++j) rounded[r][j] = rounded_entry(numbers[r][j], bits[r]);
    }
    for (std::size_t k = 0; k < unknowns; ++k) {
      const std::optional<std::size_t> row = rounded.step(0);
      if (!row) return false;
      if (*row == k) continue;
      std::swap(numbers[*row], numbers[k]);
      std::swap(bits[*row], bits[k]);
    }
    return true;
  }

  // By expansion along rows, each set of columns once: v_j is the determinant without column j, but for its sign.
  Numbers by_determinants() const {
    const std::size_t n = unknowns, all = (std::size_t{1} << (n + 1)) - 1;
    std::array<Number, std::size_t{1} << most_vectors> minor;
    minor[0] = {1};
    std::array<std::size_t, most_dimension> words{};  // of a minor whose last row is this
    std::int64_t sum = bits_of_factorial;
    for (std::size_t r = 0; r < n; ++r) {
      sum += bits[r];
      words[r] = static_cast<std::size_t>(sum) / 64 + 1;
    }
    for (std::size_t set = 1; set < all; ++set) {  // of columns; their number is that of rows
      const auto row = static_cast<std::size_t>(std::popcount(set)) - 1;
      minor[set] = Number{};
      bool is_negative = row % 2 != 0;
      for (std::size_t rest = set; rest != 0; rest &= rest - 1, is_negative = !is_negative) {
        const auto column = static_cast<std::size_t>(std::countr_zero(rest));
        FewWords::add_product(minor[set], numbers[row][column], minor[set ^ (std::size_t{1} << column)], is_negative,
                              words[row]);
      }
      FewWords::extend(minor[set], words[row]);
    }
    std::array<Number, most_vectors> v{};
    bool is_negative = n % 2 != 0;
    for (std::size_t j = 0; j <= n; ++j, is_negative = !is_negative) {
      Number& determinant = minor[all ^ (std::size_t{1} << j)];
      v[j] = is_negative ? opposite(determinant) : determinant;
    }
    return v;
  }

  // The last number is not negative.
  std::optional<Numbers> solve() {
    if (!put_independent_first()) return std::nullopt;
    Numbers v = by_determinants();
    bool is_zero = true;
    for (std::size_t j = 0; j <= unknowns; ++j) is_zero = is_zero && FewWords::is_zero(v[j]);
    if (is_zero) return std::nullopt;
    for (std::size_t i = unknowns; i < equations; ++i) {
      Number sum{};
      for (std::size_t j = 0; j <= unknowns; ++j) FewWords::add_product(sum, numbers[i][j], v[j], false);
      if (!FewWords::is_zero(sum)) return std::nullopt;
    }
    if (!FewWords::is_negative(v[unknowns])) return v;
    for (std::size_t j = 0; j <= unknowns; ++j) v[j] = opposite(v[j]);
    return v;
  }

 private:
  static Number opposite(const Number& x) {
    Number result{};
    FewWords::add_product(result, {1, false}, x, true);
    return result;
  }
};

// By elimination, of integers of any size.
std::optional<std::array<Integer, most_vectors>> null_vector_by_elimination(std::span<const ExactVector> vectors) {
  Elimination equations(vectors.size());
  for (std::size_t r = 0; r < vectors[0].size(); ++r) {
    ExactVector equation;
    for (const ExactVector& v : vectors) equation.push_back(v[r]);
    equations.add(equation);
  }
  if (equations.rank() + 1 != vectors.size()) return std::nullopt;
  const std::vector<Integer> v = *equations.across();
  std::array<Integer, most_vectors> result;
  for (std::size_t j = 0; j < v.size(); ++j) result[j] = v.back() < 0 ? -v[j] : v[j];
  return result;
}

}  // namespace

std::optional<std::array<Integer, most_vectors>> null_vector(std::span<const ExactVector> vectors) {
  SUNDER_REQUIRE(!vectors.empty() && vectors.size() <= most_vectors && vectors[0].size() <= most_dimension);
  SUNDER_REQUIRE(vectors.size() <= vectors[0].size() + 1);
  const std::optional<FewWordVectors> few = few_words_of(vectors);
  if (!few) return null_vector_by_elimination(vectors);
  const std::optional<Numbers> v = null_vector(*few);
  if (!v) return std::nullopt;
  std::array<Integer, most_vectors> result;
  for (std::size_t j = 0; j < vectors.size(); ++j) result[j] = FewWords::integer((*v)[j]);
  return result;
}

bool FewWordVectors::fit(std::int64_t more) const {
  std::int64_t sum = bits_of_factorial + more;
  for (std::size_t r = 0; r < equations; ++r) {
    if (bits[r] > static_cast<std::int64_t>(FewWords::most_bits)) return false;
    sum += bits[r];
  }
  return sum < static_cast<std::int64_t>(64 * FewWords::words - 1);
}

std::optional<std::array<FewWords::Number, most_vectors>> null_vector(const FewWordVectors& vectors) {
  SUNDER_REQUIRE(vectors.count > 0 && vectors.count <= vectors.equations + 1 && vectors.equations <= most_dimension);
  SUNDER_REQUIRE(vectors.fit());
  return System(vectors).solve();
}

}  // namespace sunder::polytope
