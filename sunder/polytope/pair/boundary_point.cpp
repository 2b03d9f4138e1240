#include <sunder/base/contract.h>
#include <sunder/number/rounded_elimination_internal.h>
#include <sunder/polytope/pair/boundary_point.h>
#include <sunder/polytope/pair/null_vector_internal.h>

#include <array>
#include <cmath>
#include <utility>

namespace sunder::polytope {

namespace {

// Which rows are independent, and by which coordinates.
struct Independent {
  std::array<std::size_t, most_vectors> rows{};
  std::array<std::size_t, most_dimension> coordinates{};
  std::array<bool, most_dimension> is_chosen{};  // of coordinates
  std::size_t count = 0;
};

Independent independent(std::span<const ExactVector> rows, std::size_t d) {
  Independent result;
  RoundedElimination rounded(rows.size(), d);
  for (std::size_t k = 0; k < rows.size(); ++k) {
    result.rows[k] = k;
    for (std::size_t c = 0; c < d; ++c) rounded[k][c] = rows[k][c].nearest();
  }
  double least = 0;
  for (std::size_t& n = result.count; n < rows.size() && n < d; ++n) {
    const std::optional<std::size_t> row = rounded.step(least);
    if (!row) break;
    if (n == 0) least = std::fabs(rounded.pivot(0)) * 0x1p-40;
    std::swap(result.rows[*row], result.rows[n]);
    result.coordinates[n] = rounded.column(n);
    result.is_chosen[rounded.column(n)] = true;
  }
  return result;
}

}  // namespace

std::optional<ExactPointN> boundary_point(std::span<const ExactVector> rows, const ColumnNumbers& near, double unit) {
  SUNDER_REQUIRE(!rows.empty() && rows.size() <= most_vectors && rows[0].size() <= most_dimension + 1);
  const std::size_t d = rows[0].size() - 1;
  const Independent of = independent(rows, d);
  if (of.count == 0) return std::nullopt;
  ExactPointN result{.numbers = ExactVector(d)};
  for (std::size_t c = 0; c < d; ++c) {
    const double part = std::nearbyint(near[c] / unit * 0x1p40) * 0x1p-40 * unit;
    if (!std::isfinite(part)) return std::nullopt;
    if (!of.is_chosen[c]) result.numbers[c] = part;
  }
  std::array<ExactVector, most_vectors> vectors;  // of the coordinates chosen, and what the others leave
  for (std::size_t k = 0; k < of.count; ++k) {
    const ExactVector& row = rows[of.rows[k]];
    for (std::size_t i = 0; i < of.count; ++i) vectors[i].push_back(row[of.coordinates[i]]);
    vectors[of.count].push_back(dot(row, result.numbers) - row[d]);
  }
  auto solution = null_vector(std::span(vectors).first(of.count + 1));
  if (!solution || !((*solution)[of.count] > 0)) return std::nullopt;
  result.denominator = dyadic_of(std::move((*solution)[of.count]), 0);
  for (std::size_t c = 0; c < d; ++c) {
    if (!of.is_chosen[c]) result.numbers[c] = result.numbers[c] * result.denominator;
  }
  for (std::size_t i = 0; i < of.count; ++i) {
    result.numbers[of.coordinates[i]] = dyadic_of(std::move((*solution)[i]), 0);
  }
  return result;
}

}  // namespace sunder::polytope
