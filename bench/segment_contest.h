// The contest of bench_segments: one family of inputs at one size, all contestants in turns.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "segment_scenarios.h"
#include "segment_subject.h"

namespace bench {

constexpr double kMostSeconds = 3;  // for one call of a peer

struct Plan {
  SegmentFamily family;
  std::vector<Question> questions;
};

struct ContestOptions {
  std::size_t rounds = 11;
  std::uint64_t seed = 1;
  std::vector<Question> questions{};  // empty: all

  bool asks(Question question) const;
};

struct Result {
  enum class State : std::uint8_t { none, over, measured } state = State::none;
  std::string library, method;
  double median_s = 0, lowest_s = 0;
  std::size_t wrong = 0;
};

// The first look at a way: it counts the wrong answers, but its time is that of one call in the cold.
struct Look {
  std::string library, method;
  double seconds = 0;
  std::size_t wrong = 0;
};

struct Row {
  SegmentFamily family{};
  Question question{};
  std::size_t n = 0, inputs = 0;
  double segments = 0, pairs = 0;  // mean
  double sort_s = 0;
  Result sunder;
  std::vector<Result> peers;  // one for each library
  std::vector<Look> looks;    // at all ways
  double sorts() const { return sunder.median_s / sort_s; }
};

// What one call took at smaller sizes, by family, question, library and method.
class History {
 public:
  void note(const std::string& key, double n, double seconds) { seen_[key].push_back({n, seconds}); }
  // For one call with n segments: at least linear, else by the growth between the last two sizes.
  double predict(const std::string& key, double n) const;

 private:
  std::map<std::string, std::vector<std::pair<double, double>>> seen_;
};

// The rows of the plan's questions that the options ask.
// look_only: peers take their first look, for the history; no rows.
std::vector<Row> measure(const Plan& plan, std::size_t n, bool look_only, const std::vector<Line>& map,
                         const ContestOptions& options, History& history);

}  // namespace bench
