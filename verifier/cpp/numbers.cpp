#include <verifier/cpp/numbers.h>

#include <algorithm>
#include <cstdlib>
#include <limits>
#include <string_view>
#include <utility>

namespace sunder_verifier {

void require(bool condition, const char* check, const std::string& reason) {
  if (!condition) throw Refused{check, reason};
}

void refuse_form(const std::string& reason) { throw Refused{"F", reason}; }

Integer shifted(const Integer& n, std::int64_t bits) { return n << static_cast<unsigned>(bits); }  // bits >= 0

namespace {

constexpr std::uint64_t no_limit = std::numeric_limits<std::uint64_t>::max();
thread_local std::uint64_t most_steps = no_limit, steps_left = no_limit, steps_put_by = no_limit;

}  // namespace

void limit_steps(std::size_t bytes) { most_steps = steps_left = 300 * std::max<std::uint64_t>(bytes, 1'000'000); }

void lift_limit() { most_steps = steps_left = no_limit; }

StepsAreTaken::StepsAreTaken() { steps_put_by = std::exchange(steps_left, no_limit); }

StepsAreTaken::~StepsAreTaken() { steps_left = steps_put_by; }

void take_steps(std::uint64_t looks, std::size_t a, std::size_t b) {
  if (steps_left == no_limit) return;
  const std::uint64_t steps = looks * (16 + std::uint64_t{a / 64 + 1} * (b / 64 + 1));
  if (steps > steps_left) throw TooLong{most_steps};
  steps_left -= steps;
}

std::size_t bits(const Integer& n) { return n == 0 ? 0 : boost::multiprecision::msb(abs(n)) + std::size_t{1}; }

std::size_t bits(std::span<const Integer> integers) {
  std::size_t most = 0;
  for (const Integer& n : integers) most = std::max(most, bits(n));
  return most;
}

std::size_t length(const Numbers& values) {
  std::size_t sum = 0;
  for (const Number& value : values) sum += bits(value.n) + bits(value.d) + static_cast<std::size_t>(std::abs(value.e));
  return sum;
}

Common common(const Numbers& values) {
  Common result;
  bool first = true;
  for (const Number& value : values) {
    if (value.n != 0 && (first || value.e < result.e)) {
      result.e = value.e;
      first = false;
    }
  }
  for (const Number& value : values) {
    if (value.d != 1) {
      for (Integer& integer : result.integers) integer *= value.d;
    }
    const Integer scaled = value.n * result.d;
    result.integers.push_back(value.n == 0 ? Integer(0) : shifted(scaled, value.e - result.e));
    result.d *= value.d;
  }
  return result;
}

}  // namespace sunder_verifier
