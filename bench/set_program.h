// What bench_sets and bench_regions have in common: options, the table, the JSON file, what is demanded.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "set_contest.h"

namespace bench {

// What `--check` demands of Sunder's time in a plan, beside right answers; 0: nothing.
struct Demand {
  std::string library{};  // the peer that `peers` is about; empty: every one
  double peers = 0;       // times as fast as the peer, at least, from peers_from objects on; from 1 on, faster
  double most_sorts = 0;  // at most so many times the sort, from sorts_from objects on
  double most_ns = 0;     // at most, at every size
  std::size_t peers_from = 0, sorts_from = 0;
};

struct Plan {
  std::string input, question;
  Demand demand;
  std::vector<std::size_t> sizes;                                  // in ascending order
  std::function<Contest(std::size_t n, std::uint64_t seed)> make;  // but for input, question and n, which are filled in
};

struct Program {
  std::string name;  // bench_sets
  std::string note;  // printed before the table: what the columns mean here
  std::vector<std::string> libraries;
  std::vector<std::string> questions;  // that --only knows: beginnings of a plan's question
  std::vector<Plan> plans;
};

// Exit code: 0; 1: --check, and something demanded does not hold; 2: bad call; 3: an error.
int run(const Program& program, int argc, char** argv);

}  // namespace bench
