#include <sunder/base/contract.h>
#include <sunder/base/lanes.h>
#include <sunder/number/few_words_internal.h>
#include <sunder/number/integer_internal.h>
#include <sunder/number/rounded.h>
#include <sunder/predicate/along_columns.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <optional>
#include <type_traits>
#include <utility>

namespace sunder {

namespace {

constexpr std::size_t block = PointColumns::block, lanes = block / 2;

// The products of the points from `first` on.
template <std::size_t D>
std::array<Lanes, lanes> products_of_block(const PointColumns& points, const ColumnNumbers& g, std::size_t first) {
  std::array<Lanes, lanes> values;
  const double* const p = points.column + first;
  for (std::size_t k = 0; k < lanes; ++k) {
    Lanes sum = g[0] * lanes_at(p + 2 * k);
    for (std::size_t c = 1; c < D; ++c) sum += g[c] * lanes_at(p + c * points.stride + 2 * k);
    values[k] = sum;
  }
  return values;
}

// The greatest product of the points from `first` on; only sums stay in registers.
template <std::size_t D>
double greatest_of_block(const PointColumns& points, const ColumnNumbers& g, std::size_t first) {
  const double* const p = points.column + first;
  const auto product = [&](std::size_t k) {
    Lanes sum = g[0] * lanes_at(p + 2 * k);
    for (std::size_t c = 1; c < D; ++c) sum += g[c] * lanes_at(p + c * points.stride + 2 * k);
    return sum;
  };
  Lanes left = product(0), right = product(1);
  for (std::size_t k = 2; k < lanes; k += 2) {
    left = greater_of(left, product(k));
    right = greater_of(right, product(k + 1));
  }
  return greater_lane(greater_of(left, right));
}

template <std::size_t D>
FurthestPoint furthest(const PointColumns& points, const ColumnNumbers& g, std::size_t every) {
  double best = -std::numeric_limits<double>::infinity();
  std::size_t where = 0;
  for (std::size_t first = 0; first < points.stride; first += every * block) {
    const double top = greatest_of_block<D>(points, g, first);
    if (top > best) {
      best = top;
      where = first;
    }
  }
  const std::array<Lanes, lanes> values = products_of_block<D>(points, g, where);
  const auto index = static_cast<std::uint32_t>(where) + first_of_greatest(values.data(), lanes);
  return {std::min(index, points.count - 1), best};
}

constexpr std::size_t piece = block / 2;  // of points

// Of each piece the furthest point, where its place has none that is as far; which point that is in its piece stands in
// `tops` as a number of its own.
struct Tops {
  std::array<double, Shortlist::most> products;
  std::array<std::uint32_t, Shortlist::most> indices;
};

template <std::size_t D>
void find_tops(const PointColumns& points, const ColumnNumbers& g, Tops& tops) {
  std::size_t place = 0;
  for (std::size_t first = 0; first < points.stride; first += block) {
    const std::array<Lanes, lanes> values = products_of_block<D>(points, g, first);
    for (std::size_t half = 0; half < 2; ++half) {
      const Lanes* const p = values.data() + half * (lanes / 2);
      const Lanes left = greater_of(greater_of(p[0], p[2]), greater_of(p[4], p[6])),
                  right = greater_of(greater_of(p[1], p[3]), greater_of(p[5], p[7]));
      const double top = greater_lane(greater_of(left, right));
      std::uint32_t found = 1u << (piece - 1);
      for (std::uint32_t k = 0; k < lanes / 2; ++k) found |= bits_of(p[k] == top) << (2 * k);
      if (top > tops.products[place]) {
        tops.products[place] = top;
        tops.indices[place] =
            static_cast<std::uint32_t>(first + half * piece) + static_cast<std::uint32_t>(std::countr_zero(found));
      }
      place = (place + 1) % Shortlist::most;
    }
  }
}

template <class Visit>
auto with_dimension(std::size_t dimension, const Visit& visit) {
  switch (dimension) {
    case 2: return visit(std::integral_constant<std::size_t, 2>());
    case 3: return visit(std::integral_constant<std::size_t, 3>());
    case 4: return visit(std::integral_constant<std::size_t, 4>());
    case 5: return visit(std::integral_constant<std::size_t, 5>());
    case 6: return visit(std::integral_constant<std::size_t, 6>());
    default: return visit(std::integral_constant<std::size_t, 7>());
  }
}

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

// Points that are not below a limit, as they are found: their products are compared by some at once.
struct NearEnd {
  static constexpr std::size_t most = 32;
  std::array<std::uint32_t, most> some{};
  std::size_t count = 0;
};

}  // namespace

FurthestPoint furthest_along(const PointColumns& points, const ColumnNumbers& direction, std::size_t every) {
  SUNDER_REQUIRE(points.count > 0 && points.stride % block == 0 && every > 0);
  return with_dimension(points.dimension,
                        [&](auto dimension) { return furthest<dimension()>(points, direction, every); });
}

FurthestPoint furthest_along(const PointColumns& points, const ColumnNumbers& direction, Shortlist& list) {
  SUNDER_REQUIRE(points.count > 0 && points.stride % block == 0);
  Tops tops;
  tops.products.fill(-std::numeric_limits<double>::infinity());
  tops.indices.fill(0);
  with_dimension(points.dimension, [&](auto dimension) { find_tops<dimension()>(points, direction, tops); });
  list.count_ = static_cast<std::uint32_t>(std::min(points.stride / piece, Shortlist::most));
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
  const std::optional<RoundedDirection> rounded = rounded_to_doubles(points, direction);
  if (!rounded) return {0, Dyadic()};
  constexpr std::size_t most_blocks = 64;  // whose greatest products are kept
  std::array<double, most_blocks> tops;
  const bool is_kept = points.stride <= most_blocks * block;
  NearEnd near;
  ExactFurthest best;
  bool found = false;
  const auto take = [&] {
    if (near.count == 0) return;
    ExactFurthest next = exactly_furthest_of(points, direction, std::span(near.some).first(near.count));
    near.count = 0;
    if (!found || (next.product - best.product).sign() == Sign::positive) best = std::move(next);
    found = true;
  };
  with_dimension(points.dimension, [&](auto dimension) {
    double limit = -std::numeric_limits<double>::infinity();
    for (std::size_t first = 0; first < points.stride; first += block) {
      const double top = greatest_of_block<dimension()>(points, rounded->numbers, first);
      if (is_kept) tops[first / block] = top;
      limit = std::max(limit, top);
    }
    limit = std::isfinite(rounded->error) ? limit - 2 * rounded->error : -std::numeric_limits<double>::infinity();
    for (std::size_t first = 0; first < points.stride; first += block) {
      const double top =
          is_kept ? tops[first / block] : greatest_of_block<dimension()>(points, rounded->numbers, first);
      if (top < limit) continue;
      const std::array<Lanes, lanes> values = products_of_block<dimension()>(points, rounded->numbers, first);
      for (std::size_t k = 0; k < block && first + k < points.count; ++k) {
        if (values[k / 2][k % 2] < limit) continue;
        ++exact_looks;
        near.some[near.count++] = static_cast<std::uint32_t>(first + k);
        if (near.count == NearEnd::most) take();
      }
    }
  });
  take();
  return best;
}

bool is_any_positive_along(const PointColumns& points, std::span<const Dyadic> direction, std::uint32_t& exact_looks) {
  const std::optional<RoundedDirection> rounded = rounded_to_doubles(points, direction);
  if (!rounded) return false;
  const bool is_bounded = std::isfinite(rounded->error);
  const double limit = is_bounded ? -rounded->error : -std::numeric_limits<double>::infinity();
  return with_dimension(points.dimension, [&](auto dimension) {
    std::vector<std::uint32_t> unsure;
    for (std::size_t first = 0; first < points.stride; first += block) {
      const double greatest = greatest_of_block<dimension()>(points, rounded->numbers, first);
      if (greatest < limit) continue;
      if (is_bounded && greatest > rounded->error) return true;
      const std::array<Lanes, lanes> values = products_of_block<dimension()>(points, rounded->numbers, first);
      for (std::size_t k = 0; k < block && first + k < points.count; ++k) {
        if (!(values[k / 2][k % 2] < limit)) unsure.push_back(static_cast<std::uint32_t>(first + k));
      }
    }
    return std::any_of(unsure.begin(), unsure.end(), [&](std::uint32_t k) {
      ++exact_looks;
      return exact_product(points, k, direction).sign() == Sign::positive;
    });
  });
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
