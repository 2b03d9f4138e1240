#include <verifier/cpp/products.h>

#include <array>
#include <compare>
#include <cstddef>
#include <cstdint>

namespace sunder_verifier {
namespace {

__extension__ using TwoLimbs = unsigned __int128;

using Limb = boost::multiprecision::limb_type;
static_assert(sizeof(Limb) == 8, "an Integer has limbs of 64 bits");

// |n|, the upper 64 bits first. Requires: it has no more than 128.
struct Magnitude {
  std::uint64_t high, low;
};

bool is_short(const Integer& n) { return n.backend().size() <= 2; }

Magnitude magnitude(const Integer& n) {
  const Limb* limbs = n.backend().limbs();
  return {n.backend().size() == 2 ? limbs[1] : 0, limbs[0]};
}

// The upper 128 bits first. (2^64 - 1)^2 + 2 (2^64 - 1) < 2^128: no sum of a product and two halves is too long.
std::array<TwoLimbs, 2> product(const Magnitude& m, const Magnitude& n) {
  const TwoLimbs low = TwoLimbs{m.low} * n.low;
  const TwoLimbs cross = TwoLimbs{m.high} * n.low + (low >> 64);
  const TwoLimbs other = TwoLimbs{m.low} * n.high + static_cast<std::uint64_t>(cross);
  const TwoLimbs high = TwoLimbs{m.high} * n.high + (cross >> 64) + (other >> 64);
  return {high, (other << 64) | static_cast<std::uint64_t>(low)};
}

}  // namespace

int compare_products(const Integer& a, const Integer& b, const Integer& c, const Integer& d) {
  const int left = a.sign() * b.sign(), right = c.sign() * d.sign();
  if (left != right) return left < right ? -1 : 1;
  if (left == 0) return 0;
  if (!is_short(a) || !is_short(b) || !is_short(c) || !is_short(d)) return Integer(a * b).compare(Integer(c * d));
  const auto ab = product(magnitude(a), magnitude(b)), cd = product(magnitude(c), magnitude(d));
  return ab == cd ? 0 : (ab > cd) == (left > 0) ? 1 : -1;
}

}  // namespace sunder_verifier
