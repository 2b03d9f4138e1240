#include <sunder/number/exact_division_internal.h>

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace sunder {

namespace {

__extension__ using Word2 = unsigned __int128;
using Words = std::vector<std::uint64_t>;

// |x| without the `zeros` last bits, in as many words as there are, or `most`.
Words words_of(const Integer& x, std::size_t zeros, std::size_t most) {
  const auto* const limbs = x.backend().limbs();
  const std::size_t count = x.backend().size(), whole = zeros / 64, part = zeros % 64;
  Words result(std::min(count - whole, most));
  for (std::size_t k = 0; k < result.size(); ++k) {
    result[k] = limbs[k + whole] >> part;
    if (part != 0 && k + whole + 1 < count) result[k] |= limbs[k + whole + 1] << (64 - part);
  }
  return result;
}

std::size_t zeros_of(const Integer& x) {
  const auto* const limbs = x.backend().limbs();
  std::size_t whole = 0;
  while (limbs[whole] == 0) ++whole;
  return 64 * whole + static_cast<std::size_t>(std::countr_zero(limbs[whole]));
}

}  // namespace

void divide_exactly(Integer& x, const Integer& by) {
  constexpr std::size_t few_words = 8;  // for which division is as fast
  if (x.backend().size() < few_words || x.backend().size() == by.backend().size()) {
    x /= by;
    return;
  }
  const std::size_t zeros = zeros_of(by), count = x.backend().size() - by.backend().size() + 1;
  const Words odd = words_of(by, zeros, count);
  Words rest = words_of(x, zeros, count);
  rest.resize(count);
  std::uint64_t inverse = odd[0];  // of the last word: right in three bits, then in twice as many a step
  for (int step = 0; step < 5; ++step) inverse *= 2 - odd[0] * inverse;
  for (std::size_t k = 0; k < count; ++k) {
    const std::uint64_t digit = rest[k] * inverse;
    std::uint64_t carry = 0;
    for (std::size_t i = 0; i < odd.size() && k + i < count; ++i) {
      const Word2 product = Word2{digit} * odd[i] + carry;
      const auto low = static_cast<std::uint64_t>(product);
      carry = static_cast<std::uint64_t>(product >> 64) + (rest[k + i] < low ? 1 : 0);
      rest[k + i] -= low;
    }
    for (std::size_t i = k + odd.size(); carry != 0 && i < count; ++i) {
      const std::uint64_t before = rest[i];
      rest[i] -= carry;
      carry = before < carry ? 1 : 0;
    }
    rest[k] = digit;
  }
  const bool is_negative = (x < 0) != (by < 0);
  while (rest.size() > 1 && rest.back() == 0) rest.pop_back();
  auto& backend = x.backend();
  backend.resize(static_cast<unsigned>(rest.size()), static_cast<unsigned>(rest.size()));
  std::copy(rest.begin(), rest.end(), backend.limbs());
  backend.sign(is_negative && (rest.size() > 1 || rest[0] != 0));
}

}  // namespace sunder
