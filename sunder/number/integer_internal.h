// The integers behind Dyadic: the only header of the library that knows Boost. For sources and tests, not installed.
#pragma once

#include <sunder/number/dyadic.h>

#include <boost/multiprecision/cpp_int.hpp>

#include <cstdint>

namespace sunder {

// Integers that need no memory of their own up to 768 bits, and may grow beyond.
using Integer =
    boost::multiprecision::number<boost::multiprecision::cpp_int_backend<
                                      768, 0, boost::multiprecision::signed_magnitude, boost::multiprecision::unchecked,
                                      std::allocator<boost::multiprecision::limb_type>>,
                                  boost::multiprecision::et_off>;

// The number is mantissa 2^exponent, with x.exponent().
const Integer& mantissa_of(const Dyadic& x) noexcept;

// mantissa 2^exponent.
Dyadic dyadic_of(Integer mantissa, std::int64_t exponent);

}  // namespace sunder
