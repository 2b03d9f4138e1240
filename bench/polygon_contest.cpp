#include "polygon_contest.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numeric>

#include "clock.h"
#include "peers/polygon_peer.h"
#include "report.h"

namespace bench {
namespace {

constexpr double kTurnSeconds = 3e-3;
constexpr double kPassSeconds = 0.1;         // who takes longer for all pairs answers a part of them in each turn
constexpr double kLookSeconds = 0.15;        // for the first look at a way, or one call
constexpr double kRoundsSeconds = 0.3;       // who takes longer for all rounds takes part in fewer
constexpr double kOnceSeconds = 0.15;        // for one call: who takes longer is not asked again
constexpr double kColdSeconds = 1e-3;        // a call that takes longer sweeps the caches itself
constexpr std::size_t kCheckedSize = 10000;  // beyond, certificates are checked of the front door only, in place

struct Contestant {
  std::string library, method;
  std::unique_ptr<PolygonPeer> peer;
  std::size_t pairs = 0;
  double look = 0;  // seconds for one call, at first sight
  std::size_t wrong = 0, asked = 0;
  std::size_t next = 0;  // the pair to begin with, where a turn has not the time for all
  std::vector<double> times{};
};

bool answers_all(const Contestant& c) { return c.look * static_cast<double>(c.pairs) <= kPassSeconds; }

// Mean time per call, in microseconds. A pass that does not count comes first, since the contestant before has swept
// the caches; then passes until they last long enough.
double take_turn(Contestant& contestant, std::vector<std::uint8_t>& answers) {
  const std::size_t count = answers_all(contestant) ? contestant.pairs : 1;
  const std::size_t first = contestant.next + count <= contestant.pairs ? contestant.next : 0;
  contestant.next = first + count;
  const std::span<std::uint8_t> part(answers.data(), count);
  if (contestant.look < kColdSeconds) contestant.peer->run(first, part);
  // The clock is looked at rarely.
  const double pass = std::max(contestant.look, 1e-9) * static_cast<double>(count);
  const std::size_t at_once = std::max<std::size_t>(1, static_cast<std::size_t>(kTurnSeconds / 8 / pass));
  const double start = thread_seconds();
  double elapsed = 0;
  std::size_t passes = 0;
  do {
    for (std::size_t i = 0; i < at_once; ++i) contestant.peer->run(first, part);
    passes += at_once;
    elapsed = thread_seconds() - start;
  } while (elapsed < kTurnSeconds);
  return 1e6 * elapsed / static_cast<double>(passes * count);
}

// Asks each pair once, as far as time allows.
void take_first_look(Contestant& contestant, const PolygonScenario& scenario) {
  std::vector<std::uint8_t> answers(contestant.pairs);
  const double start = thread_seconds();
  double elapsed = 0;
  for (std::size_t done = 0; done < contestant.pairs; done = contestant.asked) {
    if (elapsed > kLookSeconds) break;
    const std::size_t count = std::min(contestant.pairs - done, std::max<std::size_t>(1, contestant.pairs / 50));
    contestant.peer->run(done, {answers.data() + done, count});
    contestant.asked += count;
    elapsed = thread_seconds() - start;
  }
  for (std::size_t i = 0; i < contestant.asked; ++i) {
    contestant.wrong += answers[i] != static_cast<std::uint8_t>(scenario.pairs[i].meet);
  }
  contestant.look = elapsed / static_cast<double>(contestant.asked);
}

const std::vector<std::string> kLibraries{"boost", "geos", "cgal"};

std::vector<PolygonWay> all_ways() {
  std::vector<PolygonWay> ways;
  for (const auto& some : {boost_polygon_ways(), geos_polygon_ways(), cgal_polygon_ways()}) {
    ways.insert(ways.end(), some.begin(), some.end());
  }
  return ways;
}

// Median over the turns; where each was about one pair, whose times differ as pairs do: mean.
double time_of(const Contestant& c) {
  if (c.times.empty()) return 1e6 * c.look;
  if (answers_all(c)) return median(c.times);
  return std::accumulate(c.times.begin(), c.times.end(), 0.0) / static_cast<double>(c.times.size());
}

PolygonResult result_of(const Contestant& c) {
  const double least = c.times.empty() ? 1e6 * c.look : lowest(c.times);
  return {PolygonResult::State::measured, c.library, c.method, time_of(c), least, c.wrong, c.asked};
}

// Looks at all ways; keeps of each library those that may be its fastest.
std::vector<Contestant> look_at_peers(const PolygonScenario& scenario, PolygonHistory& history,
                                      std::map<std::string, double>& over, std::vector<PolygonResult>& looks) {
  std::map<std::string, std::vector<Contestant>> looked;
  for (const PolygonWay& way : all_ways()) {
    Contestant contestant{std::string(way.library), std::string(way.method), {}, scenario.pairs.size()};
    const std::string key = std::string(name_of(scenario.regime)) + "/" + contestant.library + "/" + contestant.method;
    const double size = static_cast<double>(scenario.n);
    const double predicted = history.predict(key, size);
    if (predicted > kMostPolygonSeconds) {
      const auto [at, is_new] = over.emplace(contestant.library, predicted);
      if (!is_new) at->second = std::min(at->second, predicted);
      continue;
    }
    contestant.peer = way.make(scenario);
    take_first_look(contestant, scenario);
    history.note(key, size, contestant.look);
    looks.push_back(result_of(contestant));
    looked[contestant.library].push_back(std::move(contestant));
  }
  std::vector<Contestant> kept;
  for (auto& [library, ways] : looked) {
    const bool some_right = std::any_of(ways.begin(), ways.end(), [](const Contestant& c) { return c.wrong == 0; });
    const auto out = [&](const Contestant& c) { return c.wrong > 0 && (some_right || over.contains(library)); };
    double fastest = HUGE_VAL;
    for (const Contestant& c : ways) fastest = out(c) ? fastest : std::min(fastest, c.look);
    for (Contestant& c : ways) {
      if (!out(c) && c.look <= 1.4 * fastest) kept.push_back(std::move(c));
    }
  }
  return kept;
}

}  // namespace

double PolygonHistory::predict(const std::string& key, double n) const {
  const auto found = seen_.find(key);
  return found == seen_.end() ? 0 : found->second.second * n / found->second.first;
}

PolygonCell measure(const PolygonScenario& scenario, std::size_t rounds, PolygonHistory& history) {
  PolygonCell cell;
  cell.n = scenario.n;
  cell.regime = scenario.regime;
  cell.pairs = scenario.pairs.size();

  std::vector<Contestant> contestants;
  for (const PolygonMethod& method : polygon_methods()) {
    for (const bool posed : {false, true}) {
      std::unique_ptr<PolygonSubject> subject = make_polygon_subject(scenario, method, posed);
      const bool certificates = contestants.empty() || scenario.n <= kCheckedSize;
      cell.methods.push_back({std::string(method.name), posed, 0, subject->tally(certificates)});
      contestants.push_back({"sunder", std::string(method.name), std::move(subject), cell.pairs});
    }
  }
  const std::size_t few = contestants.size();
  contestants.push_back({"sunder", "few pairs", make_polygon_subject(scenario, polygon_methods().front(), false),
                         std::min(kFewPairs, cell.pairs)});
  for (Contestant& contestant : contestants) take_first_look(contestant, scenario);
  std::map<std::string, double> over;
  for (Contestant& peer : look_at_peers(scenario, history, over, cell.looks)) contestants.push_back(std::move(peer));

  std::vector<std::uint8_t> answers(cell.pairs);
  for (std::size_t round = 0; round < rounds; ++round) {
    for (std::size_t k = 0; k < contestants.size(); ++k) {
      Contestant& contestant = contestants[(k + round) % contestants.size()];
      if (contestant.look > kOnceSeconds) continue;
      const double pass = contestant.look * static_cast<double>(answers_all(contestant) ? contestant.pairs : 1);
      if (round >= 3 && static_cast<double>(round) * std::max(pass, kTurnSeconds) > kRoundsSeconds) continue;
      contestant.times.push_back(take_turn(contestant, answers));
    }
  }

  for (std::size_t i = 0; i < few; ++i) cell.methods[i].us = time_of(contestants[i]);
  cell.few_us = time_of(contestants[few]);
  for (const std::string& library : kLibraries) {
    PolygonResult& best = cell.peers.emplace_back();
    best.library = library;
    if (const auto found = over.find(library); found != over.end()) {
      best.state = PolygonResult::State::over;
      best.us = 1e6 * found->second;
    }
    for (const Contestant& contestant : contestants) {
      if (contestant.library != library) continue;
      const PolygonResult result = result_of(contestant);
      if (best.state != PolygonResult::State::measured || result.us < best.us) best = result;
    }
  }
  return cell;
}

}  // namespace bench
