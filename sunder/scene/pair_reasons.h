// Why pairs of parts are not asked about, and how many for each reason.
#pragma once

#include <algorithm>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace sunder::scene {

class PairReasons {
 public:
  void add(std::string_view reason, std::uint64_t pairs) {
    if (pairs == 0) return;
    const auto known =
        std::find_if(counts_.begin(), counts_.end(), [&](const auto& one) { return one.first == reason; });
    if (known == counts_.end()) {
      counts_.emplace_back(reason, pairs);
    } else {
      known->second += pairs;
    }
  }

  // In the order in which they came, none of zero pairs.
  const std::vector<std::pair<std::string, std::uint64_t>>& counts() const { return counts_; }

 private:
  std::vector<std::pair<std::string, std::uint64_t>> counts_;
};

}  // namespace sunder::scene
