// How the work of a front door grows over families of inputs: counted probes against N log2 N + k.
//
// k is what an answer has to pay for besides: contacts, also those that do not count, of a point where many meet as
// many as meet there.
#pragma once

#include <tests/support/scale.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <string>

namespace sunder::tests {

// Sizes are the powers of two from 2^8; up to 2^16, or 2^12 where SUNDER_TEST_SCALE asks for less.
inline constexpr int least_growth_power = 8;
inline int greatest_growth_power() { return std::min(16, scaled_count(16, 12)); }

inline double number(std::size_t k) { return static_cast<double>(k); }

class Growth {
 public:
  // At most `stated` probes over N log2 N + k.
  explicit Growth(double stated) : stated_(stated) {}

  void add(const std::string& what, double n, double k, std::uint64_t probes) {
    const double ratio = static_cast<double>(probes) / (n * std::log2(n) + k);
    EXPECT_LE(ratio, stated_) << what << ", N = " << n << ", k = " << k;
    if (n <= 1100) at_a_thousand_ = std::max(at_a_thousand_, ratio);
    if (ratio <= greatest_) return;
    greatest_ = ratio;
    std::printf("%-44s N %6.0f  k %9.0f  probes %10llu  ratio %.2f\n", what.c_str(), n, k,
                static_cast<unsigned long long>(probes), ratio);  // NOLINT(google-runtime-int): for printf
  }

  // That the constant is no excuse for growth: it is hardly larger than what sets of about a thousand take.
  void expect_no_growth() const { EXPECT_LE(stated_, 1.5 * at_a_thousand_) << "greatest " << greatest_; }

 private:
  double stated_, at_a_thousand_ = 0, greatest_ = 0;
};

}  // namespace sunder::tests
