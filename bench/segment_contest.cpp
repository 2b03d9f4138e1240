#include "segment_contest.h"

#include <algorithm>
#include <cmath>
#include <string_view>

#include "clock.h"
#include "peers/segment_peer.h"
#include "report.h"

namespace bench {
namespace {

constexpr double kRoundsSeconds = 3;               // who takes longer for all rounds takes part in fewer
constexpr double kSureSeconds = 2 * kMostSeconds;  // predicted, that is sure enough to be more than kMostSeconds

struct Contestant {
  std::string library, method;
  Question question = Question::any;
  std::vector<Asked> asks;  // one for each input; empty: the sort
  std::size_t wrong = 0;    // inputs with another answer than the truth, at the first look
  double look = 0;          // seconds for one call, at first sight
  std::vector<double> times{};
};

// Copying the endpoints is not timed.
double take_sort_turn(const std::vector<std::vector<Xy>>& endpoints) {
  std::size_t size = 0;
  for (const auto& points : endpoints) size += points.size();
  std::vector<std::vector<Xy>> copies;
  for (std::size_t copied = 0; copied == 0 || copied < 50000; copied += size) {
    copies.insert(copies.end(), endpoints.begin(), endpoints.end());
  }
  const double start = thread_seconds();
  for (auto& points : copies) {
    std::sort(points.begin(), points.end(),
              [](const Xy& p, const Xy& q) { return p.x < q.x || (p.x == q.x && p.y < q.y); });
  }
  const double elapsed = thread_seconds() - start;
  [[maybe_unused]] volatile const double used = copies.back().front().x;
  return elapsed / static_cast<double>(copies.size());
}

// Asks each input once.
Contestant first_look(std::string library, std::string method, Question question, std::vector<Asked> asks,
                      const std::vector<SegmentInput>& inputs) {
  Contestant contestant{std::move(library), std::move(method), question, std::move(asks)};
  const double start = thread_seconds();
  std::size_t calls = 0;
  for (; calls < inputs.size(); ++calls) {
    if (calls > 0 && thread_seconds() - start > kMostSeconds) break;
    contestant.wrong += contestant.asks[calls]() != truth(inputs[calls], question);
  }
  contestant.look = (thread_seconds() - start) / static_cast<double>(calls);
  return contestant;
}

const std::vector<std::string> kLibraries{"cgal", "geos", "boost"};

std::vector<SegmentWay> all_ways() {
  std::vector<SegmentWay> ways;
  for (const auto& some : {cgal_segment_ways(), geos_segment_ways(), boost_segment_ways()}) {
    ways.insert(ways.end(), some.begin(), some.end());
  }
  return ways;
}

// The question as peers know it; false where they do not.
bool peers_question(Question question, SegmentQuestion& out) {
  switch (question) {
    case Question::any: out = SegmentQuestion::any; return true;
    case Question::simple: out = SegmentQuestion::simple; return true;
    case Question::all: out = SegmentQuestion::all; return true;
    case Question::count: out = SegmentQuestion::count; return true;
    default: return false;
  }
}

// Looks at all ways of all peers; keeps of each library those that may be its fastest.
std::vector<Contestant> look_at_peers(const std::vector<SegmentInput>& inputs, SegmentFamily family, std::size_t n,
                                      Question question, History& history, Looks& looks) {
  std::vector<Contestant> kept;
  SegmentQuestion asked{};
  if (!peers_question(question, asked)) return kept;
  std::map<std::string, std::vector<Contestant>> looked;
  for (const SegmentWay& way : all_ways()) {
    const std::string library(way.library), method(way.method);
    const std::string key =
        std::string(name_of(family)) + "/" + std::string(name_of(question)) + "/" + library + "/" + method;
    const double size = static_cast<double>(n);
    if (const double predicted = history.predict(key, size); predicted > kSureSeconds) {
      looks.leave_out(library, predicted);
      continue;
    }
    std::vector<Asked> asks;
    for (const SegmentInput& input : inputs) {
      Asked ask = way.make(input, asked);
      if (!ask) break;
      asks.push_back(std::move(ask));
    }
    if (asks.empty()) continue;
    Contestant contestant = first_look(library, method, question, std::move(asks), inputs);
    history.note(key, size, contestant.look);
    looks.looks.push_back({library, method, contestant.look, contestant.wrong});
    if (contestant.look > kMostSeconds) {
      looks.leave_out(library, contestant.look);
    } else {
      looked[library].push_back(std::move(contestant));
    }
  }
  for (auto& [library, ways] : looked) {
    const bool some_over = looks.over.contains(library);
    const bool some_right = std::any_of(ways.begin(), ways.end(), [](const Contestant& c) { return c.wrong == 0; });
    const auto out = [&](const Contestant& c) { return c.wrong > 0 && (some_right || some_over); };
    double fastest = kMostSeconds;
    for (const Contestant& c : ways) fastest = out(c) ? fastest : std::min(fastest, c.look);
    for (Contestant& c : ways) {
      if (!out(c) && c.look <= 1.4 * fastest) kept.push_back(std::move(c));
    }
  }
  return kept;
}

Result result_of(const Contestant& contestant) {
  return {Result::State::measured,  contestant.library,       contestant.method,
          median(contestant.times), lowest(contestant.times), contestant.wrong};
}

}  // namespace

bool ContestOptions::asks(Question question) const {
  return questions.empty() || std::find(questions.begin(), questions.end(), question) != questions.end();
}

std::vector<Row> measure(const Plan& plan, std::size_t n, bool look_only, const std::vector<Line>& map,
                         const ContestOptions& options, History& history) {
  const std::vector<SegmentInput> inputs = make_segment_inputs(plan.family, n, options.seed, map);
  std::vector<std::vector<Xy>> endpoints;
  for (const SegmentInput& input : inputs) {
    auto& points = endpoints.emplace_back();
    for (const Line& l : input.lines) points.insert(points.end(), {l.a, l.b});
  }
  std::vector<Contestant> contestants{{"sort", "std::sort", Question::make, {}}};
  std::map<Question, Looks> looks;
  for (const Question question : plan.questions) {
    if (!options.asks(question)) continue;
    for (Contestant& peer : look_at_peers(inputs, plan.family, n, question, history, looks[question])) {
      contestants.push_back(std::move(peer));
    }
    if (look_only) continue;
    std::vector<Asked> asks;
    for (const SegmentInput& input : inputs) asks.push_back(ask_sunder(input, question));
    if (!asks.front()) continue;
    contestants.push_back(first_look("sunder", "front door", question, std::move(asks), inputs));
  }
  if (look_only) return {};

  for (std::size_t round = 0; round < options.rounds; ++round) {
    for (std::size_t k = 0; k < contestants.size(); ++k) {
      Contestant& contestant = contestants[(k + round) % contestants.size()];
      const double turn = contestant.look * static_cast<double>(contestant.asks.size());
      if (round >= 3 && static_cast<double>(round) * turn > kRoundsSeconds) continue;
      contestant.times.push_back(contestant.asks.empty() ? take_sort_turn(endpoints)
                                                         : take_turn(contestant.asks, contestant.look));
    }
  }

  std::vector<Row> rows;
  for (const Question question : plan.questions) {
    if (!options.asks(question)) continue;
    Row& row = rows.emplace_back();
    row.family = plan.family;
    row.question = question;
    row.n = n;
    row.inputs = inputs.size();
    for (const SegmentInput& input : inputs) {
      row.segments += static_cast<double>(input.lines.size()) / static_cast<double>(inputs.size());
      row.pairs += static_cast<double>(input.pairs) / static_cast<double>(inputs.size());
    }
    row.sort_s = median(contestants[0].times);
    row.looks = looks[question].looks;
    for (const std::string& library : kLibraries) {
      Result& best = row.peers.emplace_back();
      best.library = library;
      const auto& slow = looks[question].over;
      if (const auto found = slow.find(library); found != slow.end()) {
        best.state = Result::State::over;
        best.median_s = found->second;
      }
    }
    for (const Contestant& contestant : contestants) {
      if (contestant.asks.empty() || contestant.question != question) continue;
      const Result result = result_of(contestant);
      if (result.library == "sunder") row.sunder = result;
      for (Result& best : row.peers) {
        if (best.library != result.library) continue;
        if (best.state != Result::State::measured || result.median_s < best.median_s) best = result;
      }
    }
  }
  return rows;
}

}  // namespace bench
