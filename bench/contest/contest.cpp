#include <bench/contest/contest.h>
#include <bench/contest/report.h>

#include <numeric>
#include <span>

namespace bench {
namespace {

constexpr double kTurnSeconds = 3e-3;
constexpr double kColdSeconds = 0.05;  // passes shorter than this are made once before they count
constexpr double kNear = 1.4;          // times the fastest at first sight: may be the fastest in truth

struct Contestant {
  std::string library, method;
  Run run{};  // empty: the yardstick
  Tally tally{};
  std::size_t inputs = 0;
  std::size_t wrong = 0, asked = 0;  // at the first look
  double look = 0;                   // seconds for one call, at first sight
  std::size_t next = 0;              // the input to answer, where a turn has not the time for all
  std::vector<double> times{};

  bool answers_all(const Pace& pace) const { return look * static_cast<double>(inputs) <= pace.pass; }
};

// Mean seconds for one call. A pass that does not count comes first, since the contestant before has swept the caches;
// then passes until they last long enough.
double take_turn(Contestant& c, const Pace& pace) {
  const std::size_t count = c.answers_all(pace) ? c.inputs : 1;
  const std::size_t first = count == 1 ? c.next++ % c.inputs : 0;
  const double pass = std::max(c.look, 1e-9) * static_cast<double>(count);
  const std::size_t at_once = std::max<std::size_t>(1, static_cast<std::size_t>(kTurnSeconds / 8 / pass));
  std::uint64_t sum = 0;
  if (pass < kColdSeconds) sum += c.run(first, count);
  const double start = thread_seconds();
  double elapsed = 0;
  std::size_t passes = 0;
  do {  // the clock is looked at rarely
    for (std::size_t i = 0; i < at_once; ++i) sum += c.run(first, count);
    passes += at_once;
    elapsed = thread_seconds() - start;
  } while (elapsed < kTurnSeconds);
  [[maybe_unused]] volatile const std::uint64_t used = sum;
  return elapsed / static_cast<double>(passes * count);
}

// Asks each input once, as far as time allows. What is quick is looked at again, warm.
void take_first_look(Contestant& c, const Entry& entry, const Contest& contest) {
  const std::size_t some = std::max<std::size_t>(1, c.inputs / 50);  // the clock is looked at rarely
  const double start = thread_seconds();
  double elapsed = 0;
  for (std::size_t k = 0; k < c.inputs; ++k) {
    const std::uint64_t truth = contest.truths[entry.inputs.empty() ? k : entry.inputs[k]];
    const std::uint64_t answer = c.run(k, 1);
    c.wrong += truth != kUnknown && answer != truth;
    ++c.asked;
    if (k % some != some - 1) continue;
    elapsed = thread_seconds() - start;
    if (elapsed > contest.pace.look) break;
  }
  c.look = (thread_seconds() - start) / static_cast<double>(c.asked);
  if (elapsed < kTurnSeconds) c.look = take_turn(c, contest.pace);
}

// Ready, and looked at; without a run where it does not answer the question.
Contestant contestant_of(const Entry& entry, const Contest& contest, bool tally) {
  Ready prepared = entry.prepare ? entry.prepare() : Ready();
  const std::size_t inputs = entry.inputs.empty() ? contest.truths.size() : entry.inputs.size();
  Contestant made{entry.library, entry.method, std::move(prepared.run), {}, inputs};
  if (!made.run) return made;
  if (tally && prepared.tally) made.tally = prepared.tally();
  take_first_look(made, entry, contest);
  return made;
}

// Median over the turns; where each was about one input, whose times differ as inputs do: mean.
Result result_of(const Contestant& c, const Contest& contest) {
  Result result{Result::State::measured, c.library, c.method, c.look, c.look, c.wrong, c.asked, c.tally};
  if (!c.times.empty()) {
    const double mean = std::accumulate(c.times.begin(), c.times.end(), 0.0) / static_cast<double>(c.times.size());
    result.median_s = c.answers_all(contest.pace) ? median(c.times) : mean;
    result.lowest_s = lowest(c.times);
  }
  result.median_s /= contest.batch;
  result.lowest_s /= contest.batch;
  return result;
}

struct Peers {
  std::vector<Contestant> kept{};        // of each library those that may be its fastest
  std::vector<Result> looks{};           // at all
  std::map<std::string, double> over{};  // libraries of which some way is left out as too slow: the least such time

  void leave_out(const std::string& library, double seconds) {
    const auto [at, is_new] = over.emplace(library, seconds);
    if (!is_new) at->second = std::min(at->second, seconds);
  }
};

Peers look_at_peers(const Contest& contest, History& history) {
  const double most = contest.pace.most, size = static_cast<double>(contest.n);
  Peers peers;
  std::map<std::string, std::vector<Contestant>> looked;
  const auto is_right = [&](const Contestant& c) { return contest.wrong_peers_count || c.wrong == 0; };
  const auto still_best = [&](const std::string& library) {  // the fastest right way so far, if any
    double best = most;
    for (const Contestant& c : looked[library]) best = is_right(c) ? std::min(best, c.look) : best;
    return best;
  };
  for (const Entry& entry : contest.peers) {
    const std::string key = entry.library + "/" + entry.method;
    const double predicted = history.predict(key, size);
    if (predicted > 2 * most) {  // sure enough to be more than that
      peers.leave_out(entry.library, predicted);
      continue;
    }
    if (predicted > 10 * still_best(entry.library)) continue;  // can not be the fastest way, and takes memory
    Contestant contestant = contestant_of(entry, contest, false);
    if (!contestant.run) continue;
    history.note(key, size, contestant.look);
    peers.looks.push_back(result_of(contestant, contest));
    if (contestant.look > most) {
      peers.leave_out(entry.library, contestant.look);
      continue;
    }
    auto& ways = looked[entry.library];
    ways.push_back(std::move(contestant));
    const double best = still_best(entry.library);  // slower ones need not stay in memory
    std::erase_if(ways, [&](const Contestant& c) { return c.look > kNear * best; });
  }
  for (auto& [library, ways] : looked) {
    const bool some_right = peers.over.contains(library) || std::any_of(ways.begin(), ways.end(), is_right);
    const auto out = [&](const Contestant& c) { return !is_right(c) && some_right; };
    double fastest = most;
    for (const Contestant& c : ways) fastest = out(c) ? fastest : std::min(fastest, c.look);
    for (Contestant& c : ways) {
      if (!out(c) && c.look <= kNear * fastest) peers.kept.push_back(std::move(c));
    }
  }
  return peers;
}

// The turns; the yardstick's seconds.
double take_rounds(const Contest& contest, std::size_t rounds, const std::vector<Contestant*>& contestants) {
  std::vector<double> yardstick;
  for (std::size_t round = 0; round < rounds; ++round) {
    for (std::size_t k = 0; k < contestants.size(); ++k) {
      Contestant* const c = contestants[(k + round) % contestants.size()];
      if (c == nullptr) {
        yardstick.push_back(contest.yardstick());
        continue;
      }
      const double turn = c->look * static_cast<double>(c->answers_all(contest.pace) ? c->inputs : 1);
      if (round >= 3 && static_cast<double>(round) * std::max(turn, kTurnSeconds) > contest.pace.rounds) continue;
      if (c->look <= contest.pace.once) c->times.push_back(take_turn(*c, contest.pace));
    }
  }
  return yardstick.empty() ? 0 : median(yardstick);
}

// Of each library its fastest.
std::vector<Result> results_of(const Peers& peers, const Contest& contest, const std::vector<std::string>& libraries) {
  std::vector<Result> results;
  for (const std::string& library : libraries) {
    Result& best = results.emplace_back();
    best.library = library;
    if (const auto found = peers.over.find(library); found != peers.over.end()) {
      best.state = Result::State::over;
      best.median_s = found->second / contest.batch;
    }
    for (const Contestant& contestant : peers.kept) {
      if (contestant.library != library) continue;
      const Result result = result_of(contestant, contest);
      if (best.state != Result::State::measured || result.median_s < best.median_s) best = result;
    }
  }
  return results;
}

struct Indexed {
  double value;
  std::uint32_t index;
  friend bool operator<(const Indexed& p, const Indexed& q) {
    return p.value < q.value || (p.value == q.value && p.index < q.index);
  }
};

}  // namespace

Tally& Tally::operator+=(const Tally& other) {
  asked += other.asked;
  filter += other.filter;
  evidence += other.evidence;
  finishing += other.finishing;
  probes += other.probes;
  iterations += other.iterations;
  exact += other.exact;
  wrong += other.wrong;
  return *this;
}

Entry entry_by_input(std::string library, std::string method, std::size_t count,
                     std::function<Asked(std::size_t k)> make) {
  return {std::move(library), std::move(method), [=]() -> Ready {
            std::vector<Asked> asks;
            for (std::size_t k = 0; k < count; ++k) {
              Asked ask = make(k);
              if (!ask) return {};
              asks.push_back(std::move(ask));
            }
            return {each([asks = std::move(asks)](std::size_t k) { return asks[k](); })};
          }};
}

double History::predict(const std::string& key, double n) const {
  const auto found = seen_.find(key);
  if (found == seen_.end()) return 0;
  const auto& seen = found->second;
  const auto [last_n, last] = seen.back();
  double power = 1;
  if (seen.size() > 1) {
    const auto [old_n, old] = seen[seen.size() - 2];
    power = std::clamp(std::log(last / old) / std::log(last_n / old_n), 1.0, 2.5);
  }
  return last * std::pow(n / last_n, power);
}

Row measure(const Contest& contest, const std::vector<std::string>& libraries, std::size_t rounds, bool look_only,
            History& history) {
  Peers peers = look_at_peers(contest, history);
  if (look_only) return {};
  std::vector<Contestant> subjects;
  for (const Entry& entry : contest.subjects) subjects.push_back(contestant_of(entry, contest, true));

  std::vector<Contestant*> all;
  if (contest.yardstick) all.push_back(nullptr);
  for (Contestant& c : peers.kept) all.push_back(&c);
  for (Contestant& c : subjects) {
    if (c.run) all.push_back(&c);
  }
  Row row{contest.input, contest.question, contest.n, contest.truths.size(), 0, 0, {}, {}, {}};
  row.sort_s = take_rounds(contest, rounds, all);
  for (const std::uint64_t truth : contest.truths) {
    row.answer += truth == kUnknown ? 0 : static_cast<double>(truth) / static_cast<double>(contest.truths.size());
  }
  for (const Contestant& c : subjects) {
    row.subjects.push_back(c.run ? result_of(c, contest) : Result{Result::State::none, c.library, c.method});
  }
  row.peers = results_of(peers, contest, libraries);
  row.looks = std::move(peers.looks);
  return row;
}

std::function<double()> sort_with_indices(const std::vector<std::vector<double>>& lists) {
  std::vector<std::vector<Indexed>> indexed;
  for (const std::vector<double>& list : lists) {
    auto& items = indexed.emplace_back();
    for (const double value : list) items.push_back({value, static_cast<std::uint32_t>(items.size())});
  }
  return sort_of(std::move(indexed));
}

}  // namespace bench
