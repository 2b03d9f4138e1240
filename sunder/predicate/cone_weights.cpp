#include <sunder/base/contract.h>
#include <sunder/predicate/cone_weights.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace sunder {

namespace {

constexpr double unit = 0x1p-53, infinite = std::numeric_limits<double>::infinity();

}  // namespace

double cone_inverse(std::span<const double> generators, std::size_t d, std::span<double> inverse) {
  SUNDER_REQUIRE(d >= 2 && d <= most_columns && generators.size() == d * d && inverse.size() == d * d);
  std::array<double, most_columns * 2 * most_columns> table{};  // C beside the identity
  const std::size_t width = 2 * d;
  for (std::size_t r = 0; r < d; ++r) {
    for (std::size_t i = 0; i < d; ++i) table[r * width + i] = generators[i * d + r];
    table[r * width + d + r] = 1;
  }
  std::array<double, most_columns> size{};  // of rows: generators may have components of very different sizes
  for (std::size_t r = 0; r < d; ++r) {
    for (std::size_t i = 0; i < d; ++i) size[r] = std::max(size[r], std::fabs(table[r * width + i]));
    if (!(size[r] > 0)) return infinite;
  }
  for (std::size_t k = 0; k < d; ++k) {
    std::size_t p = k;
    for (std::size_t r = k + 1; r < d; ++r) {
      if (std::fabs(table[r * width + k]) / size[r] > std::fabs(table[p * width + k]) / size[p]) p = r;
    }
    if (!(std::fabs(table[p * width + k]) > 0)) return infinite;
    for (std::size_t i = 0; i < width; ++i) std::swap(table[p * width + i], table[k * width + i]);
    std::swap(size[p], size[k]);
    const double by = 1 / table[k * width + k];
    for (std::size_t i = 0; i < width; ++i) table[k * width + i] *= by;
    for (std::size_t r = 0; r < d; ++r) {
      const double factor = table[r * width + k];
      if (r == k || factor == 0) continue;
      for (std::size_t i = 0; i < width; ++i) table[r * width + i] -= factor * table[k * width + i];
    }
  }
  double most = 0;
  for (std::size_t i = 0; i < d; ++i) {
    double row = 0;
    for (std::size_t j = 0; j < d; ++j) {
      double rest = i == j ? 1 : 0, sizes = rest;
      for (std::size_t r = 0; r < d; ++r) {
        const double product = table[i * width + d + r] * generators[j * d + r];
        rest -= product;
        sizes += std::fabs(product);
      }
      row += std::fabs(rest) + (static_cast<double>(d) + 3) * unit * sizes + 0x1p-1060;
    }
    most = std::max(most, row * (1 + 0x1p-40));
    for (std::size_t r = 0; r < d; ++r) inverse[i * d + r] = table[i * width + d + r];
    if (!std::isfinite(row)) return infinite;
  }
  return most < 0.25 ? most / (1 - most) * (1 + 0x1p-40) : infinite;
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
    error[i] = (static_cast<double>(d) + 4) * unit * sizes + 0x1p-1060;
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
  const double error = (static_cast<double>(generator.size()) + 6) * unit * sizes + 0x1p-1060;
  return {sum - error, sum + error};
}

}  // namespace sunder
