// The contest of bench_sets and bench_regions: one question about one family of inputs at one size, all contestants in
// turns.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "contest.h"

namespace bench {

struct Entry {
  std::string library, method;
  // Prepares input k, which outlives it; empty where this does not answer the question.
  std::function<Asked(std::size_t k)> make;
};

struct Contest {
  std::string input, question;
  std::size_t n = 0;                  // objects of one input
  std::vector<std::uint64_t> truths;  // for each input, what a call has to give
  double batch = 1;                   // questions in a call: times are of one of them
  // The yardstick: std::sort of each of these, with the index of each number beside it, or without.
  std::vector<std::vector<double>> keys;
  bool with_indices = true;
  Entry subject;
  std::vector<Entry> peers;
};

struct ContestOptions {
  std::size_t rounds = 11;
  std::uint64_t seed = 1;
};

struct Row {
  std::string input, question;
  std::size_t n = 0, inputs = 0;
  double sort_s = 0;
  Result sunder;
  std::vector<Result> peers;  // one for each library
  std::vector<Look> looks;    // at all ways
  double sorts() const { return sunder.median_s / sort_s; }
};

// look_only: peers take their first look, for the history; the row is empty.
Row measure(const Contest& contest, const std::vector<std::string>& libraries, bool look_only,
            const ContestOptions& options, History& history);

}  // namespace bench
