#include <sunder/base/contract.h>
#include <sunder/number/few_words_internal.h>
#include <sunder/number/integer_internal.h>
#include <sunder/number/rounded.h>
#include <sunder/predicate/filter/along_columns.h>
#include <sunder/predicate/filter/column_kernels_internal.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

namespace sunder {

namespace {

constexpr std::size_t block = PointColumns::block;

using BlockProducts = std::array<double, block>;

// A direction times a power of two, rounded, and a bound on the errors of products with it.
struct RoundedDirection {
  ColumnNumbers numbers{};
  double error = 0;
};

// Nothing where the direction is zero. One rounding each, or less than 2^-1074 where it underflows.
std::optional<RoundedDirection> rounded_to_doubles(const PointColumns& points, std::span<const Dyadic> direction) {
  std::int64_t top = std::numeric_limits<std::int64_t>::min();
  for (std::size_t c = 0; c < points.dimension; ++c) {
    if (direction[c].sign() != Sign::zero) top = std::max(top, direction[c].top());
  }
  if (top == std::numeric_limits<std::int64_t>::min()) return std::nullopt;
  RoundedDirection result;
  ColumnNumbers sizes{};
  for (std::size_t c = 0; c < points.dimension; ++c) {
    result.numbers[c] = direction[c].scaled(-top).nearest();
    sizes[c] = std::fabs(result.numbers[c]);
  }
  result.error = product_error(points, sizes, 1);
  return result;
}

Dyadic exact_product(const PointColumns& points, std::uint32_t k, std::span<const Dyadic> direction) {
  Dyadic sum;
  for (std::size_t c = 0; c < points.dimension; ++c) sum = sum + direction[c] * Dyadic(points.at(k, c));
  return sum;
}

// Exact products of few points with a direction, in integers of few words: all are multiples of 2^unit().
class WordProducts {
 public:
  // False where numbers are of sizes that are too different.
  bool read(const PointColumns& points, std::span<const Dyadic> direction, std::span<const std::uint32_t> some) {
    constexpr auto most = std::numeric_limits<std::int64_t>::max();
    unit_ = most;
    std::int64_t top = -most;
    for (std::size_t c = 0; c < points.dimension; ++c) {
      column_unit_[c] = most;
      std::int64_t column_top = -most;
      for (const std::uint32_t k : some) {
        const OddMantissa x(points.at(k, c));
        if (x.size == 0) continue;
        column_unit_[c] = std::min(column_unit_[c], x.exponent);
        column_top = std::max(column_top, x.top());
      }
      if (direction[c].sign() == Sign::zero || column_unit_[c] == most) {
        column_unit_[c] = most;
        continue;
      }
      if (column_top - column_unit_[c] > static_cast<std::int64_t>(FewWords::most_bits)) return false;
      unit_ = std::min(unit_, direction[c].exponent() + column_unit_[c]);
      top = std::max(top, direction[c].top() + 1 + column_top);
    }
    if (unit_ == most) return false;
    if (top - unit_ + 3 >= static_cast<std::int64_t>(64 * FewWords::words)) return false;  // sums of seven, and a sign
    for (std::size_t c = 0; c < points.dimension; ++c) {
      if (column_unit_[c] == most) continue;
      const std::int64_t shift = direction[c].exponent() + column_unit_[c] - unit_;
      direction_[c] = FewWords::number(mantissa_of(direction[c]), static_cast<unsigned>(shift));
    }
    return true;
  }

  FewWords::Number product(const PointColumns& points, std::uint32_t k) const {
    FewWords::Number sum{};
    for (std::size_t c = 0; c < points.dimension; ++c) {
      if (column_unit_[c] == std::numeric_limits<std::int64_t>::max()) continue;
      const OddMantissa x(points.at(k, c));
      if (x.size == 0) continue;
      const FewWords::Entry entry{FewWords::Word2{x.size} << (x.exponent - column_unit_[c]), x.is_negative};
      FewWords::add_product(sum, entry, direction_[c], false);
    }
    return sum;
  }

  std::int64_t unit() const { return unit_; }

 private:
  std::int64_t unit_ = 0;
  std::array<std::int64_t, most_columns> column_unit_{};  // the greatest number: all products are zero
  std::array<FewWords::Number, most_columns> direction_{};
};

// Of these points the first of those that are furthest, exactly.
ExactFurthest exactly_furthest_of(const PointColumns& points, std::span<const Dyadic> direction,
                                  std::span<const std::uint32_t> some) {
  WordProducts words;
  if (some.size() > 1 && words.read(points, direction, some)) {
    std::uint32_t best = some[0];
    FewWords::Number product = words.product(points, best);
    for (const std::uint32_t k : some.subspan(1)) {
      const FewWords::Number next = words.product(points, k);
      if (!FewWords::is_less(product, next)) continue;
      best = k;
      product = next;
    }
    return {best, dyadic_of(FewWords::integer(product), words.unit())};
  }
  ExactFurthest best;
  for (const std::uint32_t k : some) {
    Dyadic product = exact_product(points, k, direction);
    if (k != some[0] && (product - best.product).sign() != Sign::positive) continue;
    best = {k, std::move(product)};
  }
  return best;
}

// Visits, in their order, the points whose product of floating point is not below the limit.
template <class Visit>
void for_not_below(double limit, const PointColumns& points, const ColumnNumbers& direction, const Visit& visit) {
  const ColumnKernels& kernels = column_kernels(points.dimension);
  BlockProducts products;
  for (std::size_t first = 0;; first += block) {
    first = kernels.next_block(points, direction, first, limit);
    if (first >= points.stride) return;
    kernels.products_of_block(points, direction, first, products.data());
    for (std::size_t k = 0; k < block && first + k < points.count; ++k) {
      if (!(products[k] < limit)) visit(static_cast<std::uint32_t>(first + k));
    }
  }
}

// Those that floating point does not rule out as the furthest; along zero, all.
template <class Visit>
void for_likely_furthest(const PointColumns& points, std::span<const Dyadic> direction, const Visit& visit) {
  const RoundedDirection rounded = rounded_to_doubles(points, direction).value_or(RoundedDirection{});
  const double limit = std::isfinite(rounded.error)
                           ? furthest_along(points, rounded.numbers).product - 2 * rounded.error
                           : -std::numeric_limits<double>::infinity();
  for_not_below(limit, points, rounded.numbers, visit);
}

}  // namespace

FurthestPoint furthest_along(const PointColumns& points, const ColumnNumbers& direction, std::size_t every) {
  SUNDER_REQUIRE(points.count > 0 && points.stride % block == 0 && every > 0);
  const ColumnKernels& kernels = column_kernels(points.dimension);
  const FurthestBlock best = kernels.furthest_block(points, direction, every);
  BlockProducts products;
  kernels.products_of_block(points, direction, best.first, products.data());
  std::uint32_t index = 0;
  while (index + 1 < block && !(products[index] == best.product)) ++index;
  return {std::min(static_cast<std::uint32_t>(best.first) + index, points.count - 1), best.product};
}

FurthestPoint furthest_along(const PointColumns& points, const ColumnNumbers& direction, Shortlist& list) {
  SUNDER_REQUIRE(points.count > 0 && points.stride % block == 0);
  ColumnTops tops;
  tops.products.fill(-std::numeric_limits<double>::infinity());
  tops.indices.fill(0);
  column_kernels(points.dimension).find_tops(points, direction, tops);
  list.count_ = static_cast<std::uint32_t>(std::min(points.stride / ColumnTops::piece, Shortlist::most));
  list.stride_ = (list.count_ + block - 1) / block * block;
  list.dimension_ = points.dimension;
  std::size_t best = 0;
  for (std::size_t k = 0; k < list.stride_; ++k) {
    const std::size_t from = std::min(k, std::size_t{list.count_} - 1);
    const std::uint32_t index = std::min(tops.indices[from], points.count - 1);
    list.indices_[k] = index;
    for (std::size_t c = 0; c < points.dimension; ++c) list.numbers_[c * list.stride_ + k] = points.at(index, c);
    if (tops.products[from] > tops.products[best]) best = from;
  }
  return {list.indices_[best], tops.products[best]};
}

double product_error(const PointColumns& points, const ColumnNumbers& sizes, int roundings) {
  SUNDER_REQUIRE(roundings >= 0 && roundings <= 16);
  constexpr double lost = 0x1p-1068;  // 2^-1074 for each of up to 7 components and products, and what rounds up
  double magnitude = 0, small = 1;
  for (std::size_t c = 0; c < points.dimension; ++c) {
    magnitude += sizes[c] * points.reach[c];
    small += points.reach[c];
  }
  const double error = (roundings + 10) * 0x1p-53 * magnitude + lost * small;
  return magnitude < 0x1p1000 && small < 0x1p1000 ? error : std::numeric_limits<double>::infinity();
}

ExactFurthest exactly_furthest_along(const PointColumns& points, std::span<const Dyadic> direction,
                                     std::uint32_t& exact_looks) {
  ExactFurthest best;
  const auto is_zero = [](const Dyadic& x) { return x.sign() == Sign::zero; };
  if (std::all_of(direction.begin(), direction.end(), is_zero)) return best;
  std::array<std::uint32_t, 32> some;  // not compared yet
  std::size_t count = 0;
  bool found = false;
  const auto take = [&] {
    if (count == 0) return;
    ExactFurthest next = exactly_furthest_of(points, direction, std::span(some).first(count));
    count = 0;
    if (!found || (next.product - best.product).sign() == Sign::positive) best = std::move(next);
    found = true;
  };
  for_likely_furthest(points, direction, [&](std::uint32_t index) {
    ++exact_looks;
    some[count++] = index;
    if (count == some.size()) take();
  });
  take();
  return best;
}

ExactFace exact_face_along(const PointColumns& points, std::span<const Dyadic> direction, std::uint32_t& exact_looks) {
  ExactFace best;
  for_likely_furthest(points, direction, [&](std::uint32_t index) {
    ++exact_looks;
    Dyadic product = exact_product(points, index, direction);
    const Sign sign = best.indices.empty() ? Sign::positive : (product - best.product).sign();
    if (sign == Sign::negative) return;
    if (sign == Sign::positive) best = {{}, std::move(product)};
    best.indices.push_back(index);
  });
  return best;
}

bool is_any_positive_along(const PointColumns& points, std::span<const Dyadic> direction, std::uint32_t& exact_looks) {
  const std::optional<RoundedDirection> rounded = rounded_to_doubles(points, direction);
  if (!rounded) return false;
  double limit = -std::numeric_limits<double>::infinity();
  if (std::isfinite(rounded->error)) {
    const double greatest = furthest_along(points, rounded->numbers).product;
    if (greatest > rounded->error) return true;
    if (greatest < -rounded->error) return false;
    limit = -rounded->error;
  }
  bool found = false;
  for_not_below(limit, points, rounded->numbers, [&](std::uint32_t index) {
    if (found) return;
    ++exact_looks;
    found = exact_product(points, index, direction).sign() == Sign::positive;
  });
  return found;
}

std::vector<std::uint32_t> at_zero_along(const PointColumns& points, std::span<const Dyadic> direction,
                                         std::uint32_t& exact_looks) {
  // Along zero all products are.
  const RoundedDirection rounded = rounded_to_doubles(points, direction).value_or(RoundedDirection{});
  std::vector<std::uint32_t> result;
  for (std::uint32_t k = 0; k < points.count; ++k) {
    double product = 0;
    for (std::size_t c = 0; c < points.dimension; ++c) product += rounded.numbers[c] * points.at(k, c);
    if (std::fabs(product) > rounded.error) continue;
    ++exact_looks;
    if (exact_product(points, k, direction).sign() == Sign::zero) result.push_back(k);
  }
  return result;
}

}  // namespace sunder
