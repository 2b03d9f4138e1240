#include "set_contest.h"

#include <algorithm>
#include <cmath>

#include "clock.h"
#include "report.h"

namespace bench {
namespace {

constexpr double kRoundsSeconds = 3;               // who takes longer for all rounds takes part in fewer
constexpr double kSureSeconds = 2 * kMostSeconds;  // predicted, that is sure enough to be more than kMostSeconds
constexpr double kMostTurnSeconds = 10;            // who takes longer for all inputs is timed on the first ones only
constexpr double kNear = 1.4;                      // times the fastest at first sight: may be the fastest in truth
constexpr std::size_t kSortedAtOnce = 50000;       // numbers, at least

struct Contestant {
  std::string library, method;
  std::vector<Asked> asks{};  // one for each input; empty: the sort
  std::size_t wrong = 0;      // inputs with another answer than the truth, at the first look
  double look = 0;            // seconds for one call, at first sight
  std::vector<double> times{};
};

struct Indexed {
  double value;
  std::uint32_t index;
  friend bool operator<(const Indexed& p, const Indexed& q) {
    return p.value < q.value || (p.value == q.value && p.index < q.index);
  }
};

// Copying is not timed. Returns seconds for one of the lists.
template <class Item>
double sort_copies(const std::vector<std::vector<Item>>& lists) {
  std::size_t size = 0;
  for (const auto& list : lists) size += list.size();
  std::vector<std::vector<Item>> copies;
  for (std::size_t copied = 0; copied == 0 || copied < kSortedAtOnce; copied += size) {
    copies.insert(copies.end(), lists.begin(), lists.end());
  }
  const double start = thread_seconds();
  for (auto& list : copies) std::sort(list.begin(), list.end());
  const double elapsed = thread_seconds() - start;
  return elapsed / static_cast<double>(copies.size());
}

double take_sort_turn(const Contest& contest) {
  if (!contest.with_indices) return sort_copies(contest.keys);
  std::vector<std::vector<Indexed>> lists;
  for (const std::vector<double>& keys : contest.keys) {
    auto& list = lists.emplace_back();
    for (const double key : keys) list.push_back({key, static_cast<std::uint32_t>(list.size())});
  }
  return sort_copies(lists);
}

// Asks each input once.
Contestant first_look(const Entry& entry, std::vector<Asked> asks, const std::vector<std::uint64_t>& truths) {
  Contestant contestant{entry.library, entry.method, std::move(asks)};
  const double start = thread_seconds();
  std::size_t calls = 0;
  for (; calls < truths.size(); ++calls) {
    if (calls > 0 && thread_seconds() - start > kMostSeconds) break;
    contestant.wrong += contestant.asks[calls]() != truths[calls];
  }
  contestant.look = (thread_seconds() - start) / static_cast<double>(calls);
  const double most = std::max(kMostTurnSeconds / contestant.look, 1.0);
  if (static_cast<double>(contestant.asks.size()) > most) contestant.asks.resize(static_cast<std::size_t>(most));
  return contestant;
}

std::vector<Asked> prepared(const Entry& entry, std::size_t inputs) {
  std::vector<Asked> asks;
  for (std::size_t k = 0; k < inputs; ++k) {
    Asked ask = entry.make ? entry.make(k) : Asked();
    if (!ask) return {};
    asks.push_back(std::move(ask));
  }
  return asks;
}

// Looks at all ways of all peers; keeps of each library those that may be its fastest.
std::vector<Contestant> look_at_peers(const Contest& contest, History& history, Looks& looks) {
  std::map<std::string, std::vector<Contestant>> looked;
  const auto still_best = [&](const std::string& library) {  // the fastest right way so far, if any
    double best = kMostSeconds;
    for (const Contestant& c : looked[library]) best = c.wrong == 0 ? std::min(best, c.look) : best;
    return best;
  };
  for (const Entry& entry : contest.peers) {
    const std::string key = contest.input + "/" + contest.question + "/" + entry.library + "/" + entry.method;
    const double size = static_cast<double>(contest.n), predicted = history.predict(key, size);
    if (predicted > kSureSeconds) {
      looks.leave_out(entry.library, predicted);
      continue;
    }
    if (predicted > 10 * still_best(entry.library)) continue;  // can not be the fastest way, and takes memory
    std::vector<Asked> asks = prepared(entry, contest.truths.size());
    if (asks.empty()) continue;
    Contestant contestant = first_look(entry, std::move(asks), contest.truths);
    history.note(key, size, contestant.look);
    looks.looks.push_back({entry.library, entry.method, contestant.look, contestant.wrong});
    if (contestant.look > kMostSeconds) {
      looks.leave_out(entry.library, contestant.look);
    } else {
      auto& ways = looked[entry.library];
      ways.push_back(std::move(contestant));
      const double best = still_best(entry.library);  // slower ones need not stay in memory
      std::erase_if(ways, [&](const Contestant& c) { return c.look > kNear * best; });
    }
  }
  std::vector<Contestant> kept;
  for (auto& [library, ways] : looked) {
    const bool some_over = looks.over.contains(library);
    const bool some_right = std::any_of(ways.begin(), ways.end(), [](const Contestant& c) { return c.wrong == 0; });
    const auto out = [&](const Contestant& c) { return c.wrong > 0 && (some_right || some_over); };
    double fastest = kMostSeconds;
    for (const Contestant& c : ways) fastest = out(c) ? fastest : std::min(fastest, c.look);
    for (Contestant& c : ways) {
      if (!out(c) && c.look <= kNear * fastest) kept.push_back(std::move(c));
    }
  }
  return kept;
}

Result result_of(const Contestant& contestant, double batch) {
  return {Result::State::measured,          contestant.library, contestant.method, median(contestant.times) / batch,
          lowest(contestant.times) / batch, contestant.wrong};
}

}  // namespace

Row measure(const Contest& contest, const std::vector<std::string>& libraries, bool look_only,
            const ContestOptions& options, History& history) {
  Looks looks;
  std::vector<Contestant> contestants{{"sort", "std::sort"}};
  for (Contestant& peer : look_at_peers(contest, history, looks)) contestants.push_back(std::move(peer));
  if (look_only) return {};
  std::vector<Asked> asks = prepared(contest.subject, contest.truths.size());
  if (!asks.empty()) contestants.push_back(first_look(contest.subject, std::move(asks), contest.truths));

  for (std::size_t round = 0; round < options.rounds; ++round) {
    for (std::size_t k = 0; k < contestants.size(); ++k) {
      Contestant& contestant = contestants[(k + round) % contestants.size()];
      const double turn = contestant.look * static_cast<double>(contestant.asks.size());
      if (round >= 3 && static_cast<double>(round) * turn > kRoundsSeconds) continue;
      contestant.times.push_back(contestant.asks.empty() ? take_sort_turn(contest)
                                                         : take_turn(contestant.asks, contestant.look));
    }
  }

  Row row{contest.input, contest.question, contest.n, contest.truths.size(), median(contestants[0].times), {}, {}, {}};
  row.looks = looks.looks;
  for (const std::string& library : libraries) {
    Result& best = row.peers.emplace_back();
    best.library = library;
    if (const auto found = looks.over.find(library); found != looks.over.end()) {
      best.state = Result::State::over;
      best.median_s = found->second / contest.batch;
    }
  }
  for (const Contestant& contestant : contestants) {
    if (contestant.asks.empty()) continue;
    const Result result = result_of(contestant, contest.batch);
    if (result.library == "sunder") row.sunder = result;
    for (Result& best : row.peers) {
      if (best.library != result.library) continue;
      if (best.state != Result::State::measured || result.median_s < best.median_s) best = result;
    }
  }
  return row;
}

}  // namespace bench
