#include "contest.h"

#include <cmath>

#include "clock.h"

namespace bench {
namespace {

constexpr double kTurnSeconds = 3e-3;
constexpr double kColdSeconds = 0.05;  // calls shorter than this are made once before they count

}  // namespace

double History::predict(const std::string& key, double n) const {
  const auto found = seen_.find(key);
  if (found == seen_.end()) return 0;
  const auto& seen = found->second;
  const auto [last_n, last] = seen.back();
  double power = 1;
  if (seen.size() > 1) {
    const auto [old_n, old] = seen[seen.size() - 2];
    power = std::clamp(std::log(last / old) / std::log(last_n / old_n), 1.0, 2.5);
  }
  return last * std::pow(n / last_n, power);
}

double take_turn(const std::vector<Asked>& asks, double look) {
  std::uint64_t sum = 0;
  const auto pass = [&] {
    for (const Asked& ask : asks) sum += ask();
  };
  if (look * static_cast<double>(asks.size()) < kColdSeconds) pass();
  const double start = thread_seconds();
  double elapsed = 0;
  std::size_t passes = 0;
  do {
    pass();
    ++passes;
    elapsed = thread_seconds() - start;
  } while (elapsed < kTurnSeconds);
  [[maybe_unused]] volatile const std::uint64_t used = sum;
  return elapsed / static_cast<double>(passes * asks.size());
}

}  // namespace bench
