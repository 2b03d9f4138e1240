// Rules of discs: docs/claims.md, "in_discs", "powers".
#include <verifier/cpp/member_rules.h>
#include <verifier/cpp/reader.h>
#include <verifier/cpp/rules.h>

namespace sunder_verifier {

void check_in_discs(const Tables& tables, const Numbers& point, bool is_region) {
  const std::size_t bits = length(point) + tables.circles.bits;
  take_steps(4 * tables.circles.size(), bits, bits);
  const Integers place = in_units(point, tables.circles.exponent);
  for (std::size_t k = 0; k < tables.circles.size(); ++k) {
    const int power = power_of(tables.circles[k], place).sign();
    require(power < 0 || (power == 0 && !is_region), "in_discs",
            "the point is not inside of circle " + std::to_string(k));
  }
}

void check_powers(const Claim& claim, const Tables& tables, bool is_point) {
  const Integers weights = positive_weights(claim.weights, [](std::size_t) { return 0; });
  Integer total = 0, x = 0, y = 0, rest = 0;
  for (std::size_t k = 0; k < weights.size(); ++k) {
    const PlanarDisc& disc = tables.circles[claim.weights.named[k]];
    total += weights[k];
    x += weights[k] * disc.x;
    y += weights[k] * disc.y;
    rest += weights[k] * (square(disc.x) + square(disc.y) - square(disc.r));
  }
  const Integer least = total * rest - square(x) - square(y);  // of the mean of the powers, times the total squared
  require(least > 0 || (is_point && least == 0), "powers", "the mean of the powers is not as it must be");
}

}  // namespace sunder_verifier
