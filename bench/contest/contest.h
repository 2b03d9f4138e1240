// The contest of all benchmarks: contestants answer the same inputs, in turns.
//
// In each round every contestant takes a turn, another one first each time. The time of a contestant is the median over
// its turns of its mean time for a call, in processor time of its thread. Each way of asking a peer gets a first look,
// which counts its wrong answers; of each library those ways take part that may be its fastest right one.
#pragma once

#include <bench/contest/clock.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace bench {

using Asked = std::function<std::uint64_t()>;  // asks once

// Answers some inputs, from `first` on, with all prepared that may be. Returns the sum of the answers.
using Run = std::function<std::uint64_t(std::size_t first, std::size_t count)>;

// ask(k) answers input k.
template <class Ask>
Run each(Ask ask) {
  return [held = std::make_shared<Ask>(std::move(ask))](std::size_t first, std::size_t count) {
    std::uint64_t sum = 0;
    for (std::size_t k = first; k < first + count; ++k) sum += static_cast<std::uint64_t>((*held)(k));
    return sum;
  };
}

// Sums over all inputs of what a contestant's answers say.
struct Tally {
  std::uint64_t asked = 0;
  std::uint64_t filter = 0, evidence = 0, finishing = 0;  // how many answers came about in which way
  std::uint64_t probes = 0, iterations = 0, exact = 0;
  std::uint64_t wrong = 0;  // another answer than the truth, or evidence that does not hold

  Tally& operator+=(const Tally& other);
};

struct Ready {
  Run run{};                       // empty: it does not answer the question
  std::function<Tally()> tally{};  // untimed; empty: nothing to tell
};

struct Entry {
  std::string library, method;
  std::function<Ready()> prepare;     // outside of the timed loop
  std::vector<std::size_t> inputs{};  // that it answers: positions among the contest's; empty: all
};

// An entry that prepares each of `count` inputs by itself: make(k) is empty where it does not answer the question.
Entry entry_by_input(std::string library, std::string method, std::size_t count,
                     std::function<Asked(std::size_t k)> make);

// How long a contestant may take, in seconds.
struct Pace {
  double most = 3;         // for a call of a peer; a way that takes longer, or twice that by its growth, is left out
  double look = 3;         // for the first look; what is not answered by then is not looked at
  double pass = 10;        // for all inputs; who takes longer answers one of them in each turn
  double rounds = 3;       // for all rounds; who takes longer takes part in fewer, at least three
  double once = HUGE_VAL;  // for a call; who takes longer is not asked again
};

constexpr std::uint64_t kUnknown = ~std::uint64_t{0};  // a truth that nobody knows

struct Contest {
  std::string input{}, question{};
  std::size_t n = 0;                    // objects of one input
  std::vector<std::uint64_t> truths{};  // for each input, what a call has to give
  double batch = 1;                     // questions in a call: times are of one of them
  std::function<double()> yardstick{};  // takes a turn: seconds for what Sunder's time is compared with on one input
  std::vector<Entry> subjects{};        // Sunder: the one that is compared comes first
  std::vector<Entry> peers{};
  bool wrong_peers_count = false;  // else a peer counts only where it is right on all inputs
  Pace pace{};
};

struct Result {
  enum class State : std::uint8_t { none, over, measured } state = State::none;
  std::string library, method;
  double median_s = 0, lowest_s = 0;  // over: what one call took, or would take by its growth
  std::size_t wrong = 0, asked = 0;   // at the first look
  Tally tally{};
};

struct Row {
  std::string input, question;
  std::size_t n = 0, inputs = 0;
  double answer = 0;  // the truth, mean over the inputs
  double sort_s = 0;  // by the yardstick; 0: there is none
  std::vector<Result> subjects;
  std::vector<Result> peers;  // one for each library
  std::vector<Result> looks;  // at all ways of all peers, with the time of one call at first sight

  const Result& sunder() const { return subjects.front(); }
  double sorts() const { return sunder().median_s / sort_s; }
  double ratio(const Result& peer) const { return peer.median_s / sunder().median_s; }
};

// What one call took at smaller sizes, by library and method.
class History {
 public:
  void note(const std::string& key, double n, double seconds) { seen_[key].push_back({n, seconds}); }
  // For one call of n objects: at least linear, else by the growth between the last two sizes. 0: unknown.
  double predict(const std::string& key, double n) const;

 private:
  std::map<std::string, std::vector<std::pair<double, double>>> seen_;
};

// look_only: peers take their first look, for the history; the row is empty.
Row measure(const Contest& contest, const std::vector<std::string>& libraries, std::size_t rounds, bool look_only,
            History& history);

// --- Yardsticks: std::sort of each of these lists. Copying is not timed. ---------------------------------------------

constexpr std::size_t kSortedAtOnce = 50000;  // items, at least

template <class Item, class Less = std::less<Item>>
std::function<double()> sort_of(std::vector<std::vector<Item>> lists, Less less = {}) {
  return [lists = std::make_shared<const std::vector<std::vector<Item>>>(std::move(lists)), less] {
    std::size_t size = 0;
    for (const auto& list : *lists) size += list.size();
    std::vector<std::vector<Item>> copies;
    for (std::size_t copied = 0; copied == 0 || copied < kSortedAtOnce; copied += size) {
      copies.insert(copies.end(), lists->begin(), lists->end());
    }
    const double start = thread_seconds();
    for (auto& list : copies) std::sort(list.begin(), list.end(), less);
    const double elapsed = thread_seconds() - start;
    return elapsed / static_cast<double>(copies.size());
  };
}

// With the index of each number beside it.
std::function<double()> sort_with_indices(const std::vector<std::vector<double>>& lists);

}  // namespace bench
