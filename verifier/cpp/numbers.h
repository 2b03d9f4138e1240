// What all rules have in common: refusals, numbers of any length, and the work that they take.
#pragma once

#include <boost/multiprecision/cpp_int.hpp>

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace sunder_verifier {

using Integer = boost::multiprecision::cpp_int;
using Integers = std::vector<Integer>;

// A check failed. Never leaves the verifier.
struct Refused {
  std::string check;
  std::string reason;
};

// Checking takes more steps than a file of its size may take. Never leaves the verifier.
struct TooLong {
  std::uint64_t most;
};

// How much work is left of what the file that this thread checks may take: docs/claims.md, "Limits".
void limit_steps(std::size_t bytes);
void lift_limit();
// While there is one, no steps are taken of what this thread reads: they were, when it was read before.
class StepsAreTaken {
 public:
  StepsAreTaken();
  ~StepsAreTaken();
  StepsAreTaken(const StepsAreTaken&) = delete;
  StepsAreTaken& operator=(const StepsAreTaken&) = delete;
};
// So many looks at a number of a bits and one of b bits. Throws TooLong.
void take_steps(std::uint64_t looks, std::size_t a, std::size_t b);

// Throws Refused where the condition does not hold.
void require(bool condition, const char* check, const std::string& reason);
[[noreturn]] void refuse_form(const std::string& reason);

// The number n / d * 2^e, with d > 0.
struct Number {
  Integer n;
  Integer d = 1;
  std::int64_t e = 0;
};

using Numbers = std::vector<Number>;

// Numbers brought to a common denominator: each is its integer / d * 2^e, with d > 0.
struct Common {
  Integers integers;
  Integer d = 1;
  std::int64_t e = 0;
};

Common common(const Numbers& values);

std::size_t bits(const Integer& n);
std::size_t bits(std::span<const Integer> integers);  // of the longest
std::size_t length(const Numbers& values);            // all bits together, exponents counted as they are

Integer shifted(const Integer& n, std::int64_t bits);  // n * 2^bits; requires bits >= 0

}  // namespace sunder_verifier
