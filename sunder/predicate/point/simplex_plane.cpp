#include <sunder/base/contract.h>
#include <sunder/predicate/point/simplex_plane.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <type_traits>
#include <utility>

namespace sunder {

namespace {

constexpr std::size_t most_masks = std::size_t{1} << (most_of_simplex + 1);

// What floating point made of an expression, and the same of the sizes of its leaves (number/rounded.h). As those
// there, but that roundings are counted for all at once.
struct SizedNumber {
  double value = 0, size = 0;
};

// Monomials of a minor of k rows have as many factors (1 + e) as one of k - 1 rows and, for the leaf, which is a
// difference, one, for the product one, for the sum k - 1. Then once more for the product with q - p0; or with q, and
// the difference of two such sums.
constexpr int roundings(std::size_t d) {
  int result = 1;
  for (std::size_t k = 2; k <= d; ++k) result += 2 + static_cast<int>(k - 1);
  return result + 1;
}

// The bound is R3 of number/rounded.h with a rounding more, for the sum of sizes. What underflows loses at most
// 2^-1074, times factors of at most 2^6 720 in all: with some hundred operations far below 2^-1000.
constexpr double part_off_plane = (roundings(most_of_simplex) + 2) * 0x1p-53, least_off_plane = 0x1p-1000;

// Of the rows entry(r, .), all minors: minor[mask] is that of as many rows as the mask has columns.
template <class Number, class Entry>
void all_minors(std::size_t rows, std::size_t columns, const Entry& entry, Number* minor, const Number& one) {
  minor[0] = one;
  for (unsigned mask = 1; mask < 1u << columns; ++mask) {
    const auto r = static_cast<std::size_t>(std::popcount(mask));
    if (r > rows) continue;
    Number sum{};
    bool is_minus = (r & 1) == 0, is_first = true;
    for (std::size_t c = 0; c < columns; ++c) {
      if ((mask >> c & 1) == 0) continue;
      const Number product = entry(r - 1, c) * minor[mask & ~(1u << c)];
      if (is_first) {
        sum = is_minus ? Number{} - product : product;
      } else {
        sum = is_minus ? sum - product : sum + product;
      }
      is_first = false;
      is_minus = !is_minus;
    }
    minor[mask] = std::move(sum);
  }
}

// The same without loops.
template <std::size_t Rows, std::size_t Columns>
class SizedMinors {
 public:
  template <class Entry>
  explicit SizedMinors(const Entry& entry) {
    for (std::size_t r = 0; r < Rows; ++r) {
      for (std::size_t c = 0; c < Columns; ++c) entry_[r][c] = entry(r, c);
    }
    [&]<unsigned... masks>(std::integer_sequence<unsigned, masks...>) {
      (take<masks + 1>(std::make_index_sequence<Columns>{}), ...);
    }(std::make_integer_sequence<unsigned, (1u << Columns) - 1>{});
  }

  const SizedNumber& operator[](unsigned mask) const { return minor_[mask]; }

 private:
  template <unsigned mask, std::size_t... columns>
  void take(std::index_sequence<columns...>) {
    if constexpr (static_cast<std::size_t>(std::popcount(mask)) <= Rows) {
      SizedNumber sum{};
      (add<mask, columns>(sum), ...);
      minor_[mask] = sum;
    }
  }

  template <unsigned mask, std::size_t c>
  void add(SizedNumber& sum) const {
    if constexpr ((mask >> c & 1) != 0) {
      constexpr auto r = static_cast<std::size_t>(std::popcount(mask)) - 1;
      constexpr auto before = static_cast<std::size_t>(std::popcount(mask & ((1u << c) - 1)));
      const SizedNumber& entry = entry_[r][c];
      if constexpr (r == 0) {
        sum = entry;
      } else {
        const SizedNumber& rest = minor_[mask & ~(1u << c)];
        const SizedNumber product{entry.value * rest.value, entry.size * rest.size};
        sum.value = ((r + before) & 1) == 0 ? sum.value + product.value : sum.value - product.value;
        sum.size += product.size;
      }
    }
  }

  std::array<std::array<SizedNumber, Columns>, Rows> entry_;
  std::array<SizedNumber, 1u << Columns> minor_;
};

// Calls with a constant 2 to 6 that is d.
template <class Call>
auto with_dimension(std::size_t d, const Call& call) {
  switch (d) {
    case 2: return call(std::integral_constant<std::size_t, 2>{});
    case 3: return call(std::integral_constant<std::size_t, 3>{});
    case 4: return call(std::integral_constant<std::size_t, 4>{});
    case 5: return call(std::integral_constant<std::size_t, 5>{});
    default: return call(std::integral_constant<std::size_t, 6>{});
  }
}

Guess to_guess(Sign s) { return static_cast<Guess>(static_cast<std::int8_t>(s)); }

// The greatest exponent of a bit of the number less the least one, and one; 0 of zero.
struct Bits {
  int top = -5000, low = 5000;
  void add(double x) {
    if (x == 0) return;
    int exponent = 0;
    const double fraction = std::frexp(std::fabs(x), &exponent);  // x = fraction 2^exponent, in [1/2, 1)
    const auto mantissa = static_cast<std::uint64_t>(std::ldexp(fraction, 53));
    top = std::max(top, exponent);
    low = std::min(low, exponent - 53 + std::countr_zero(mantissa));
  }
  int count() const { return std::max(top - low, 0); }
};

// Of the vectors q, c0, .., c(d-1), in columns, is the first one a combination of the others without a negative number?
// These are the determinants with q in the place of each, over that without q (Cramer).
template <class Number, class Entry>
Guess is_combination(std::size_t d, const Entry& entry, std::vector<Number>& minor) {
  minor.resize(most_masks);
  all_minors(d, d + 1, entry, minor.data(), Number(1.0));
  const unsigned all = (1u << (d + 1)) - 1;
  const Guess whole = sign(minor[all & ~1u]);
  if (!is_sure(whole)) return Guess::unsure;
  Guess result = Guess::positive;
  for (std::size_t i = 0; i < d; ++i) {
    Guess part = sign(minor[all & ~(2u << i)]);
    if (!is_sure(part)) {
      result = Guess::unsure;
      continue;
    }
    if ((i & 1) != 0) part = to_guess(-to_sign(part));
    if (part != Guess::zero && part != whole) return Guess::negative;
  }
  return result;
}

}  // namespace

PlanePoints::PlanePoints(std::size_t d, std::vector<double> rows) : d_(d), rows_(std::move(rows)) {
  SUNDER_REQUIRE(d >= 2 && d <= most_of_simplex && rows_.size() % d == 0);
  count_ = static_cast<std::uint32_t>(rows_.size() / d);
  rounded_.resize(rows_.size());
  // A determinant is a sum of d! products, of which each has a factor of each column, which is a difference: so all
  // sums on the way are whole multiples of one unit, and in these units below 2^53.
  constexpr std::array<int, most_of_simplex + 1> bits_of_factorial{0, 0, 1, 3, 5, 7, 10};
  int bits = bits_of_factorial[d];
  for (std::size_t c = 0; c < d; ++c) {
    Bits column;
    for (std::size_t k = c; k < rows_.size(); k += d) column.add(rows_[k]);
    bits += column.count() + 1;
    for (std::size_t k = c; k < rows_.size(); k += d) {
      rounded_[k] = rows_[k] == 0 ? 0 : std::ldexp(rows_[k], -column.top);
    }
  }
  is_exact_ = bits <= 53;
}

PlanePoints::PlanePoints(std::size_t d, std::vector<Dyadic> rows) : d_(d), ratios_(std::move(rows)) {
  SUNDER_REQUIRE(d >= 2 && d <= most_of_simplex && ratios_.size() % (d + 1) == 0);
  count_ = static_cast<std::uint32_t>(ratios_.size() / (d + 1));
  uncertainty_ = 4;  // each is within 2^-53 of what it stands for
  rounded_.resize(count_ * d);
  for (std::size_t c = 0; c < d; ++c) {
    std::int64_t top = 0;
    bool found = false;
    for (std::size_t k = 0; k < count_; ++k) {
      const Dyadic& x = ratios_[k * (d + 1) + c];
      SUNDER_REQUIRE(ratios_[k * (d + 1) + d].sign() == Sign::positive);
      if (x.sign() == Sign::zero) continue;
      const std::int64_t bound = x.top() - ratios_[k * (d + 1) + d].top() + 1;
      top = found ? std::max(top, bound) : bound;
      found = true;
    }
    for (std::size_t k = 0; k < count_; ++k) {
      rounded_[k * d + c] = nearest_ratio(ratios_[k * (d + 1) + c].scaled(-top), ratios_[k * (d + 1) + d]);
    }
  }
}

std::vector<Dyadic> PlanePoints::row(std::uint32_t k) const {
  std::vector<Dyadic> result;
  for (std::size_t c = 0; c < d_; ++c) {
    result.push_back(ratios_.empty() ? Dyadic(rows_[k * d_ + c]) : ratios_[k * (d_ + 1) + c]);
  }
  result.push_back(ratios_.empty() ? Dyadic(1.0) : ratios_[k * (d_ + 1) + d_]);
  return result;
}

RoundedPlane PlanePoints::rounded_plane(const SimplexCorners& corners) const {
  const double* const origin = rounded(corners[0]);
  const auto entry = [&](std::size_t r, std::size_t c) {
    const double x = rounded(corners[r + 1])[c] - origin[c];
    return SizedNumber{x, std::fabs(x) + uncertainty_};
  };
  return with_dimension(d_, [&](auto dimension) {
    constexpr std::size_t d = dimension;
    const SizedMinors<d - 1, d> minor(entry);
    constexpr unsigned all = (1u << d) - 1;
    RoundedPlane plane;
    double sizes = 0;
    for (std::size_t c = 0; c < d; ++c) {
      const SizedNumber& without = minor[all & ~(1u << c)];
      plane.normal[c] = (c & 1) == 0 ? without.value : -without.value;
      plane.offset += plane.normal[c] * origin[c];
      sizes += without.size;
    }
    // Of q and p0 together 2, and what is uncertain about them.
    plane.error = is_exact_ ? 0 : part_off_plane * (sizes * (2 + 2 * uncertainty_)) + least_off_plane;
    return plane;
  });
}

Guess PlanePoints::closer_side(const SimplexCorners& corners, std::uint32_t k) const {
  const double* const origin = rounded(corners[0]);
  const auto entry = [&](std::size_t r, std::size_t c) {
    const double x = (r + 1 < d_ ? rounded(corners[r + 1]) : rounded(k))[c] - origin[c];
    return SizedNumber{x, std::fabs(x) + uncertainty_};
  };
  SizedNumber sum = with_dimension(d_, [&](auto dimension) {
    constexpr std::size_t d = dimension;
    return SizedMinors<d, d>(entry)[(1u << d) - 1];
  });  // its row is the last, not the first
  if ((d_ & 1) == 0) sum.value = -sum.value;
  const double error = is_exact_ ? 0 : part_off_plane * sum.size + least_off_plane;
  if (sum.value > error) return Guess::positive;
  if (sum.value < -error) return Guess::negative;
  return error == 0 ? Guess::zero : Guess::unsure;
}

std::vector<Dyadic> PlanePoints::exact_plane(const SimplexCorners& corners) const {
  std::vector<Dyadic> minor(most_masks), plane(d_ + 1);
  if (ratios_.empty()) {
    std::vector<Dyadic> entries;
    for (std::size_t r = 1; r < d_; ++r) {
      for (std::size_t c = 0; c < d_; ++c)
        entries.push_back(Dyadic(rows_[corners[r] * d_ + c]) - rows_[corners[0] * d_ + c]);
    }
    all_minors(
        d_ - 1, d_, [&](std::size_t r, std::size_t c) -> const Dyadic& { return entries[r * d_ + c]; }, minor.data(),
        Dyadic(1.0));
    const unsigned all = (1u << d_) - 1;
    for (std::size_t c = 0; c < d_; ++c) {
      const Dyadic& without = minor[all & ~(1u << c)];
      plane[c] = (c & 1) == 0 ? without : -without;
      plane[d_] = plane[d_] - plane[c] * rows_[corners[0] * d_ + c];
    }
    return plane;
  }
  const std::size_t width = d_ + 1;
  all_minors(
      d_, width, [&](std::size_t r, std::size_t c) -> const Dyadic& { return ratios_[corners[r] * width + c]; },
      minor.data(), Dyadic(1.0));
  // The determinant of the rows q, p0, .., with weights 1: less row p0, it is that of the differences times the one
  // left in column d of the second row.
  const unsigned all = (1u << width) - 1;
  for (std::size_t c = 0; c < width; ++c) {
    const Dyadic& without = minor[all & ~(1u << c)];
    plane[c] = ((c + d_ + 1) & 1) == 0 ? without : -without;
  }
  return plane;
}

Sign PlanePoints::exact_side(std::span<const Dyadic> plane, std::uint32_t k) const {
  if (ratios_.empty()) {
    Dyadic sum = plane[d_];
    for (std::size_t c = 0; c < d_; ++c) sum = sum + plane[c] * rows_[k * d_ + c];
    return sum.sign();
  }
  Dyadic sum;
  for (std::size_t c = 0; c <= d_; ++c) sum = sum + plane[c] * ratios_[k * (d_ + 1) + c];
  return sum.sign();
}

bool PlanePoints::in_cone(std::span<const Dyadic> center, const SimplexCorners& corners, std::uint32_t k) const {
  const auto point = [&](std::size_t c) { return c == 0 ? k : corners[c - 1]; };
  {
    std::array<Interval, most_of_simplex> m;
    for (std::size_t r = 0; r < d_; ++r) m[r] = center[r].enclosure();
    const Interval n = center[d_].enclosure();
    std::vector<Interval> minor;
    const Guess guess = is_combination(
        d_, [&](std::size_t r, std::size_t c) { return n * Interval(rows_[point(c) * d_ + r]) - m[r]; }, minor);
    if (is_sure(guess)) return guess == Guess::positive;
  }
  std::vector<Dyadic> entries, minor;
  for (std::size_t r = 0; r < d_; ++r) {
    for (std::size_t c = 0; c <= d_; ++c) entries.push_back(center[d_] * rows_[point(c) * d_ + r] - center[r]);
  }
  const Guess guess = is_combination(
      d_, [&](std::size_t r, std::size_t c) -> const Dyadic& { return entries[r * (d_ + 1) + c]; }, minor);
  return guess == Guess::positive;
}

}  // namespace sunder
