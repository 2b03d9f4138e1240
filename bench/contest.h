// What the contests share: asking in turns, what came of it, and how long larger ones will take.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace bench {

using Asked = std::function<std::uint64_t()>;  // asks once

constexpr double kMostSeconds = 3;  // for one call of a peer

struct Result {
  enum class State : std::uint8_t { none, over, measured } state = State::none;
  std::string library, method;
  double median_s = 0, lowest_s = 0;  // over: what it took, or would take by its growth
  std::size_t wrong = 0;
};

// The first look at a way: it counts the wrong answers, but its time is that of one call in the cold.
struct Look {
  std::string library, method;
  double seconds = 0;
  std::size_t wrong = 0;
};

// What one call took at smaller sizes, by input, question, library and method.
class History {
 public:
  void note(const std::string& key, double n, double seconds) { seen_[key].push_back({n, seconds}); }
  // For one call of n objects: at least linear, else by the growth between the last two sizes.
  double predict(const std::string& key, double n) const;

 private:
  std::map<std::string, std::vector<std::pair<double, double>>> seen_;
};

struct Looks {
  std::vector<Look> looks{};
  std::map<std::string, double> over{};  // libraries of which some way is left out as too slow: the least such time

  void leave_out(const std::string& library, double seconds) {
    const auto [at, is_new] = over.emplace(library, seconds);
    if (!is_new) at->second = std::min(at->second, seconds);
  }
};

// Asks all, again and again for some milliseconds. Seconds for one call. look: what it took at first sight.
double take_turn(const std::vector<Asked>& asks, double look);

}  // namespace bench
