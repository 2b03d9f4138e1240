// What all benchmarks are: contests planned as data, in one program with the same options, table, JSON file and check.
#pragma once

#include <bench/contest/contest.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <vector>

namespace bench {

// Bounds that hold from so many objects on. Of several the last one counts whose `from` is reached.
struct Step {
  std::size_t from = 0;
  double bound = 0;
};
using Steps = std::vector<Step>;
double bound_at(const Steps& steps, std::size_t n);  // 0: none

// What `--check` demands of Sunder's time in a plan, beside right answers.
struct Demand {
  std::string library{};  // the peer that `peers` is about; empty: every one
  Steps peers{};          // times as fast as the peer, at least; from 1 on, faster
  Steps most_sorts{};     // at most so many times the yardstick
  double most_ns = 0;     // at most, at every size; 0: nothing
};

struct Plan {
  std::string input, question;
  Demand demand;
  std::vector<std::size_t> sizes;                                  // in ascending order
  std::function<Contest(std::size_t n, std::uint64_t seed)> make;  // but for input, question and n, which are filled in
};

struct Options {
  bool check = false, quick = false;
  bool ways = false;  // print the first look at every way
  std::size_t rounds = 11;
  std::uint64_t seed = 1;
  std::vector<std::size_t> sizes{};
  std::vector<std::string> only{};
  std::string json{}, commit{};
  std::map<std::string, std::string> own{};  // the program's own, by name
};

struct Program {
  std::string name;  // bench_sets
  std::string note;  // printed before the table: what the columns mean here
  std::vector<std::string> libraries;
  std::vector<std::string> questions;  // that --only knows: beginnings of a plan's question
  std::function<std::vector<Plan>(const Options&)> plans;
  bool tells_subjects = false;  // the table has lines for all of Sunder's ways, not for the first only
  // Demands beyond those of a plan: prints what there is to tell, and adds what does not hold.
  std::function<void(const std::vector<Row>& rows, std::vector<std::string>& failures)> conclude{};
  std::map<std::string, std::string> own{};  // options of the program's own ("--map"), with what they are by default
};

// Exit code: 0; 1: --check, and something demanded does not hold; 2: bad call; 3: an error.
int run(const Program& program, int argc, char** argv);

// The row of an input at a size; nullptr: there is none.
const Row* find(const std::vector<Row>& rows, const std::string& input, std::size_t n);

// The inputs that several plans share: those of one family, made once for each size.
template <class Family, class Inputs>
class Kept {
 public:
  // make(): the inputs, where they are not there.
  template <class Make>
  std::shared_ptr<const Inputs> get(Family family, std::size_t n, const Make& make) {
    if (family != family_) made_.clear();
    family_ = family;
    auto& found = made_[n];
    if (!found) found = std::make_shared<const Inputs>(make());
    return found;
  }

 private:
  Family family_{};
  std::map<std::size_t, std::shared_ptr<const Inputs>> made_;
};

}  // namespace bench
