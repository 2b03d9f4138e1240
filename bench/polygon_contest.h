// The contest of bench_polygons: one regime at one size, all contestants in turns.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "polygon_scenarios.h"
#include "polygon_subject.h"

namespace bench {

constexpr double kMostPolygonSeconds = 1;  // for one call of a peer

struct PolygonResult {
  enum class State : std::uint8_t { none, over, measured } state = State::none;
  std::string library, method;
  double us = 0, lowest_us = 0;
  std::size_t wrong = 0, asked = 0;  // of `asked` pairs
};

// One of Sunder's methods.
struct MethodResult {
  std::string name;
  bool posed = false;
  double us = 0;
  PolygonTally tally;
};

struct PolygonCell {
  std::size_t n = 0;
  PolygonRegime regime = PolygonRegime::apart;
  std::size_t pairs = 0;
  double few_us = 0;                  // the front door with the first kFewPairs alone
  std::vector<MethodResult> methods;  // the front door first, in place; then posed; and so on
  std::vector<PolygonResult> peers;   // one for each library
  std::vector<PolygonResult> looks;   // at all ways: the time of one call or few
  double sunder_us() const { return methods.front().us; }
  double ratio(const PolygonResult& peer) const { return peer.us / sunder_us(); }
};

// What a call took at the greatest size so far, by regime, library and method.
class PolygonHistory {
 public:
  void note(const std::string& key, double n, double seconds) { seen_[key] = {n, seconds}; }
  double predict(const std::string& key, double n) const;  // by linear growth; 0: unknown

 private:
  std::map<std::string, std::pair<double, double>> seen_;
};

PolygonCell measure(const PolygonScenario& scenario, std::size_t rounds, PolygonHistory& history);

}  // namespace bench
