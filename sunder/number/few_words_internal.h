// Integers of at most 511 bits in words that stand in the number itself, for determinants of few rows: several times as
// fast as integers of any size.
#pragma once

#include <sunder/number/integer_internal.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace sunder {

struct FewWords {
  __extension__ using Word2 = unsigned __int128;
  static constexpr std::size_t words = 8, most_bits = 126;

  // At most 126 bits.
  struct Entry {
    Word2 size = 0;
    bool is_negative = false;
  };
  // Modulo 2^512, as two's complement; the lowest word first.
  using Number = std::array<std::uint64_t, words>;

  static bool is_negative(const Number& x) { return (x[words - 1] >> 63) != 0; }
  static bool is_zero(const Number& x) {
    return std::all_of(x.begin(), x.end(), [](std::uint64_t word) { return word == 0; });
  }

  // sum += e x, or -= e x, of so many words, in which the result fits; those above are left as they are.
  static void add_product(Number& sum, const Entry& e, const Number& x, bool is_negative, std::size_t count = words) {
    add_times_word(sum, static_cast<std::uint64_t>(e.size), x, 0, is_negative != e.is_negative, count);
    add_times_word(sum, static_cast<std::uint64_t>(e.size >> 64), x, 1, is_negative != e.is_negative, count);
  }
  // Makes the words from `count` on those of the same number.
  static void extend(Number& x, std::size_t count) {
    std::fill(x.begin() + static_cast<std::ptrdiff_t>(count), x.end(), std::uint64_t{0} - (x[count - 1] >> 63));
  }

  // x < y.
  static bool is_less(const Number& x, const Number& y) {
    if (is_negative(x) != is_negative(y)) return is_negative(x);
    return std::lexicographical_compare(x.rbegin(), x.rend(), y.rbegin(), y.rend());
  }

  // x 2^shift. Requires that this fits.
  static Number number(const Integer& x, unsigned shift) {
    const auto& backend = x.backend();
    Number result{};
    const std::size_t whole = shift / 64, part = shift % 64;
    for (std::size_t k = 0; k < backend.size() && k + whole < words; ++k) {
      const std::uint64_t limb = backend.limbs()[k];
      result[k + whole] |= limb << part;
      if (part != 0 && k + whole + 1 < words) result[k + whole + 1] = limb >> (64 - part);
    }
    if (!backend.sign()) return result;
    Number negated{};
    add_product(negated, {1, false}, result, true);
    return negated;
  }

  static Integer integer(const Number& x) {
    const std::uint64_t mask = std::uint64_t{0} - (x[words - 1] >> 63);
    Number size{};
    std::uint64_t carry = mask & 1;  // -x = ~x + 1
    std::size_t count = 0;
    for (std::size_t k = 0; k < words; ++k) {
      size[k] = (x[k] ^ mask) + carry;
      carry = carry != 0 && size[k] == 0 ? 1 : 0;
      if (size[k] != 0) count = k + 1;
    }
    Integer result;
    if (count == 0) return result;
    auto& backend = result.backend();
    backend.resize(static_cast<unsigned>(count), static_cast<unsigned>(count));
    std::copy_n(size.begin(), count, backend.limbs());
    if (mask != 0) backend.negate();
    return result;
  }

 private:
  // sum - p = ~(~sum + p).
  static void add_times_word(Number& sum, std::uint64_t by, const Number& x, std::size_t at, bool is_negative,
                             std::size_t count) {
    if (by == 0) return;
    const std::uint64_t mask = is_negative ? ~std::uint64_t{0} : 0;
    std::uint64_t carry = 0;
    for (std::size_t k = at; k < count; ++k) {
      const Word2 total = Word2{by} * x[k - at] + (sum[k] ^ mask) + carry;
      sum[k] = static_cast<std::uint64_t>(total) ^ mask;
      carry = static_cast<std::uint64_t>(total >> 64);
    }
  }
};

// A double is mantissa 2^exponent, the mantissa odd or zero.
struct OddMantissa {
  std::uint64_t size = 0;
  std::int64_t exponent = 0;
  bool is_negative = false;

  OddMantissa() = default;
  explicit OddMantissa(double x) : is_negative(std::signbit(x)) {
    const auto bits = std::bit_cast<std::uint64_t>(x);
    const auto field = static_cast<std::int64_t>(bits >> 52 & 0x7ff);
    size = bits & ((std::uint64_t{1} << 52) - 1);
    if (field != 0) size |= std::uint64_t{1} << 52;
    if (size == 0) return;
    const int zeros = std::countr_zero(size);
    size >>= zeros;
    exponent = std::max<std::int64_t>(field, 1) - 1075 + zeros;
  }
  std::int64_t top() const { return exponent + static_cast<std::int64_t>(std::bit_width(size)); }
};

}  // namespace sunder
