#include <sunder/base/contract.h>
#include <sunder/predicate/point/cone_weights.h>
#include <sunder/predicate/point/verified_inverse.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace sunder {

namespace {

constexpr double unit_roundoff = 0x1p-53, infinite = std::numeric_limits<double>::infinity();

}  // namespace

double cone_inverse(std::span<const double> generators, std::size_t d, std::span<double> inverse) {
  SUNDER_REQUIRE(d >= 2 && d <= most_columns && generators.size() == d * d && inverse.size() == d * d);
  std::array<double, most_columns * most_columns> matrix{};
  const std::array<double, most_columns> no_width{};
  for (std::size_t r = 0; r < d; ++r) {
    for (std::size_t i = 0; i < d; ++i) matrix[r * d + i] = generators[i * d + r];
  }
  const double q = verified_inverse(std::span(matrix).first(d * d), std::span(no_width).first(d), inverse);
  return q < 0.25 ? q / (1 - q) * (1 + 0x1p-40) : infinite;
}

ConeWeights cone_weights(std::span<const double> inverse, double slack, std::span<const double> direction,
                         std::size_t d) {
  ConeWeights result;
  std::array<double, most_columns> error{};
  double most = 0;
  for (std::size_t i = 0; i < d; ++i) {
    double sum = 0, sizes = 0;
    for (std::size_t r = 0; r < d; ++r) {
      const double product = inverse[i * d + r] * direction[r];
      sum += product;
      sizes += std::fabs(product);
    }
    result.weight[i] = sum;
    error[i] = (static_cast<double>(d) + 4) * unit_roundoff * sizes + 0x1p-1060;
    if (!std::isfinite(sizes)) {
      result.sign.fill(Guess::unsure);
      return result;
    }
    most = std::max(most, std::fabs(sum) + error[i]);
  }
  for (std::size_t i = 0; i < d; ++i) {
    const double bound = (error[i] + slack * most) * (1 + 0x1p-40);
    const double weight = result.weight[i];
    result.sign[i] = weight > bound ? Guess::positive : weight < -bound ? Guess::negative : Guess::unsure;
  }
  return result;
}

ProductRange difference_along(std::span<const double> generator, std::span<const double> v, std::span<const double> w) {
  double sum = 0, sizes = 0;
  for (std::size_t c = 0; c < generator.size(); ++c) {
    const double product = generator[c] * (v[c] - w[c]);
    sum += product;
    sizes += std::fabs(product);
  }
  if (!(sizes <= std::numeric_limits<double>::max())) return {-infinite, infinite};
  if (sizes == 0 && std::equal(v.begin(), v.end(), w.begin(), w.end())) return {};
  const double error = (static_cast<double>(generator.size()) + 6) * unit_roundoff * sizes + 0x1p-1060;
  return {sum - error, sum + error};
}

}  // namespace sunder
