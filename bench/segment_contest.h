// The contest of bench_segments: one family of inputs at one size, all contestants in turns.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "contest.h"
#include "segment_scenarios.h"
#include "segment_subject.h"

namespace bench {

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

std::vector<Row> measure(const Plan& plan, std::size_t n, bool look_only, const std::vector<Line>& map,
                         const ContestOptions& options, History& history);

}  // namespace bench
