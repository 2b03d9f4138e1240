// bench_pair: how long does it take to tell whether two convex bodies meet? Against FCL (libccd) and Bullet (double).
//
// Fairness:
//   - All contestants answer the same queries in one run, in rounds, and take turns in going first, so that a change
//     of the machine's mood hits all. The time of a contestant is the median over the rounds of its mean per query, in
//     processor time of its thread.
//   - Each library may prepare all that it can outside of the loop: shapes, transforms, first guesses; margins are 0.
//   - Peers are asked for a boolean only, by every way that they offer (see peers/peer.h); in each cell of the table
//     the fastest way of the fastest library counts. Sunder's answer holds its certificate.
//   - Queries rotate over many pairs of a pool of bodies, which no contestant holds in its second-level cache at 1,000
//     vertices and more; there is no coherence between one query and the next, and none is told of any.
//   - Peers are as Debian built them (FCL's template headers: compiled here with the flags of this build).
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "clock.h"
#include "peers/peer.h"
#include "report.h"
#include "scenarios.h"
#include "subject.h"

namespace bench {
namespace {

constexpr double kCliff = 25;  // exact touching against a generic query, at kCliffSize vertices
constexpr std::size_t kCliffSize = 1000;

constexpr double kTurnSeconds = 3e-3;

// What `--check` demands: Sunder's rate over that of the fastest peer, geometric mean over far, near and deep.
double demanded_ratio(std::size_t n) { return n >= 10000 ? 6 : n >= 1000 ? 4 : n >= 100 ? 2 : 1; }

struct Options {
  bool check = false;
  bool quick = false;
  std::size_t rounds = 11;
  std::uint64_t seed = 1;
  std::vector<std::size_t> sizes;
  std::string json, commit;
};

struct Result {
  std::string library, method;
  double median_us = 0, lowest_us = 0;
  std::size_t wrong = 0;    // verdicts that differ from those known by construction
  std::size_t differs = 0;  // verdicts that differ from Sunder's
};

struct Cell {
  std::size_t n = 0, queries = 0;
  Regime regime = Regime::far;
  Result sunder;
  std::vector<Result> peers;
  Tally tally;
  std::map<std::string, double> families_us;  // of Sunder

  const Result* best(std::string_view library) const {
    const Result* found = nullptr;
    for (const Result& r : peers) {
      if ((library.empty() || r.library == library) && (found == nullptr || r.median_us < found->median_us)) found = &r;
    }
    return found;
  }
  double ratio() const { return best("")->median_us / sunder.median_us; }
};

// One turn of a contestant: the mean time per query, in microseconds. A pass over the queries that does not count,
// since the contestant before has swept the caches, which would weigh the more the faster a contestant is; then passes
// until they last long enough.
double take_turn(Peer& peer, std::span<std::uint8_t> meets) {
  peer.run(meets);
  const double start = thread_seconds();
  double elapsed = 0;
  std::size_t passes = 0;
  do {
    peer.run(meets);
    ++passes;
    elapsed = thread_seconds() - start;
  } while (elapsed < kTurnSeconds);
  return 1e6 * elapsed / static_cast<double>(passes * meets.size());
}

// Sunder's time per family of contact.
std::map<std::string, double> time_families(const Scenario& scenario, std::size_t rounds) {
  std::map<std::string, double> times;
  for (std::size_t family = 0; family < kFamilies.size(); ++family) {
    Scenario part{scenario.n, scenario.regime, scenario.pool, {}};
    for (const Query& query : scenario.queries) {
      if (query.family == family) part.queries.push_back(query);
    }
    if (part.queries.empty()) continue;
    const std::unique_ptr<Subject> subject = make_sunder(part);
    std::vector<std::uint8_t> meets(part.queries.size());
    std::vector<double> means;
    for (std::size_t round = 0; round < rounds; ++round) means.push_back(take_turn(*subject, meets));
    times[std::string(kFamilies[family])] = median(means);
  }
  return times;
}

Cell measure(std::size_t n, Regime regime, const Options& options) {
  const std::size_t bodies = n >= 10000 ? 16 : 32;
  const std::size_t queries = n >= 10000 ? 256 : n >= 100 ? 1024 : 2048;
  const Scenario scenario = make_scenario(n, regime, bodies, queries, options.seed);

  const std::unique_ptr<Subject> subject = make_sunder(scenario);
  // Every way of every peer gets a first look; those that have a chance to be the fastest way of their library stay.
  std::vector<std::uint8_t> meets(queries);
  std::vector<std::unique_ptr<Peer>> peers;
  using Maker = std::unique_ptr<Peer> (*)(const Scenario&);
  for (const std::vector<Maker>& library : {std::vector<Maker>{make_fcl_collide, make_fcl_solver},
                                            {make_bullet_distance, make_bullet_penetration, make_bullet_detector}}) {
    std::vector<std::unique_ptr<Peer>> ways;
    std::vector<double> looks;
    for (const Maker make : library) {
      ways.push_back(make(scenario));
      looks.push_back(take_turn(*ways.back(), meets));
    }
    for (std::size_t i = 0; i < ways.size(); ++i) {
      if (looks[i] <= 1.4 * lowest(looks)) peers.push_back(std::move(ways[i]));
    }
  }

  std::vector<Peer*> all{subject.get()};
  for (const auto& peer : peers) all.push_back(peer.get());
  std::vector<std::vector<std::uint8_t>> verdicts(all.size(), std::vector<std::uint8_t>(queries));
  std::vector<std::vector<double>> times(all.size());
  for (std::size_t round = 0; round < options.rounds; ++round) {
    for (std::size_t k = 0; k < all.size(); ++k) {
      const std::size_t i = (k + round) % all.size();
      times[i].push_back(take_turn(*all[i], verdicts[i]));
    }
  }

  Cell cell;
  cell.n = n;
  cell.regime = regime;
  cell.queries = queries;
  for (std::size_t i = 0; i < all.size(); ++i) {
    Result r{std::string(all[i]->library()), std::string(all[i]->method()), median(times[i]), lowest(times[i]), 0, 0};
    for (std::size_t q = 0; q < queries; ++q) {
      const Expected expected = scenario.queries[q].expected;
      r.wrong += expected != Expected::unknown && (verdicts[i][q] != 0) != (expected == Expected::meet);
      r.differs += verdicts[i][q] != verdicts[0][q];
    }
    (i == 0 ? cell.sunder : cell.peers.emplace_back()) = r;
  }
  cell.tally = subject->tally();
  if (regime == Regime::touching || regime == Regime::last_bit) {
    cell.families_us = time_families(scenario, options.rounds);
  }
  return cell;
}

void print_head() {
  std::printf("Times in microseconds per query. \"wrong\": verdicts against those known by construction.\n");
  std::printf("\"filter/evidence/finishing\": how Sunder's answers came about.\n\n");
  std::printf("%6s %-9s %9s %9s %9s %7s  %-18s %-22s %-24s %7s %6s\n", "n", "regime", "sunder", "fcl", "bullet",
              "ratio", "fastest peer", "wrong sunder/fcl/bullet", "filter/evidence/finishing", "probes", "steps");
}

void print(const Cell& cell) {
  const Result &fcl = *cell.best("fcl"), &bullet = *cell.best("bullet"), &best = *cell.best("");
  const double count = static_cast<double>(cell.queries);
  char wrong[64], decided[64];
  std::snprintf(wrong, sizeof wrong, "%zu/%zu/%zu of %zu", cell.sunder.wrong, fcl.wrong, bullet.wrong, cell.queries);
  std::snprintf(decided, sizeof decided, "%llu/%llu/%llu", static_cast<unsigned long long>(cell.tally.filter),
                static_cast<unsigned long long>(cell.tally.evidence),
                static_cast<unsigned long long>(cell.tally.finishing));
  std::printf("%6zu %-9s %9.3f %9.3f %9.3f %7.2f  %-18s %-23s %-25s %7.1f %6.1f\n", cell.n, name_of(cell.regime).data(),
              cell.sunder.median_us, fcl.median_us, bullet.median_us, cell.ratio(),
              (best.library + " " + best.method).c_str(), wrong, decided,
              static_cast<double>(cell.tally.probes) / count, static_cast<double>(cell.tally.iterations) / count);
  for (const auto& [family, us] : cell.families_us) std::printf("%16s %9.3f  %s\n", "", us, family.c_str());
  std::fflush(stdout);
}

void print_json(std::FILE* out, const Result& r, const char* end) {
  std::fprintf(out,
               "{\"library\": \"%s\", \"method\": \"%s\", \"median_us\": %.4f, \"lowest_us\": %.4f, \"wrong\": %zu, "
               "\"differs\": %zu}%s",
               r.library.c_str(), r.method.c_str(), r.median_us, r.lowest_us, r.wrong, r.differs, end);
}

void write_json(const Options& options, const std::vector<Cell>& cells,
                const std::vector<std::pair<std::size_t, double>>& ratios, const std::vector<std::string>& failures) {
  ReportFile file(options.json);
  std::FILE* out = file.get();
  std::fprintf(out, "{\n  \"benchmark\": \"pair\",\n");
  print_json(out, circumstances(options.commit));
  std::fprintf(out, "  \"rounds\": %zu,\n  \"seed\": %llu,\n  \"ratios\": {", options.rounds,
               static_cast<unsigned long long>(options.seed));
  for (std::size_t i = 0; i < ratios.size(); ++i) {
    std::fprintf(out, "%s\"%zu\": %.3f", i == 0 ? "" : ", ", ratios[i].first, ratios[i].second);
  }
  std::fprintf(out, "},\n  \"failures\": [");
  for (std::size_t i = 0; i < failures.size(); ++i) {
    std::fprintf(out, "%s\"%s\"", i == 0 ? "" : ", ", failures[i].c_str());
  }
  std::fprintf(out, "],\n  \"cells\": [\n");
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const Cell& cell = cells[i];
    std::fprintf(out,
                 "    {\"n\": %zu, \"regime\": \"%s\", \"queries\": %zu, \"ratio\": %.3f,\n     \"results\": [\n      ",
                 cell.n, name_of(cell.regime).data(), cell.queries, cell.ratio());
    print_json(out, cell.sunder, "");
    for (const Result& r : cell.peers) {
      std::fprintf(out, ",\n      ");
      print_json(out, r, "");
    }
    std::fprintf(out, "],\n     \"decided_by\": {\"filter\": %llu, \"evidence\": %llu, \"finishing\": %llu}, ",
                 static_cast<unsigned long long>(cell.tally.filter),
                 static_cast<unsigned long long>(cell.tally.evidence),
                 static_cast<unsigned long long>(cell.tally.finishing));
    std::fprintf(out, "\"probes\": %llu, \"iterations\": %llu, \"exact\": %llu",
                 static_cast<unsigned long long>(cell.tally.probes),
                 static_cast<unsigned long long>(cell.tally.iterations),
                 static_cast<unsigned long long>(cell.tally.exact));
    if (!cell.families_us.empty()) {
      std::fprintf(out, ",\n     \"families_us\": {");
      const char* comma = "";
      for (const auto& [family, us] : cell.families_us) {
        std::fprintf(out, "%s\"%s\": %.4f", comma, family.c_str(), us);
        comma = ", ";
      }
      std::fprintf(out, "}");
    }
    std::fprintf(out, "}%s\n", i + 1 == cells.size() ? "" : ",");
  }
  std::fprintf(out, "  ]\n}\n");
  file.commit();
}

int usage(const char* problem) {
  std::fprintf(stderr,
               "bench_pair: %s\n"
               "usage: bench_pair [--check] [--quick] [--n SIZE]... [--rounds COUNT] [--seed SEED] [--json FILE] "
               "[--commit ID]\n",
               problem);
  return 2;
}

int run(const Options& options) {
  print_text(stdout, circumstances(options.commit));
  print_head();
  std::vector<Cell> cells;
  std::vector<std::pair<std::size_t, double>> ratios;
  std::vector<std::string> failures;
  std::string demands;
  char line[200];
  for (const std::size_t n : options.sizes) {
    std::vector<double> of_n, times;
    for (const Regime regime : {Regime::far, Regime::near, Regime::deep}) {
      cells.push_back(measure(n, regime, options));
      print(cells.back());
      of_n.push_back(cells.back().ratio());
      times.push_back(cells.back().sunder.median_us);
    }
    const double ratio = geometric_mean(of_n);
    ratios.emplace_back(n, ratio);
    std::snprintf(line, sizeof line, "n = %zu: %.2f times the rate of the fastest peer (demanded: %.0f)", n, ratio,
                  demanded_ratio(n));
    demands += std::string(line) + "\n";
    if (ratio < demanded_ratio(n)) failures.emplace_back(line);
    if (n != kCliffSize) continue;
    const double generic = (times[0] + times[1] + times[2]) / 3;
    for (const Regime regime : {Regime::touching, Regime::last_bit}) {
      cells.push_back(measure(n, regime, options));
      print(cells.back());
      std::map<std::string, double> costs = cells.back().families_us;
      costs["all"] = cells.back().sunder.median_us;
      for (const auto& [family, us] : costs) {
        std::snprintf(line, sizeof line, "n = %zu, %s, %s: %.1f times a generic query (allowed: %.0f)", n,
                      name_of(regime).data(), family.c_str(), us / generic, kCliff);
        if (family == "all") demands += std::string(line) + "\n";
        if (us > kCliff * generic) failures.emplace_back(line);
      }
    }
  }
  for (const Cell& cell : cells) {
    if (cell.sunder.wrong == 0) continue;
    std::snprintf(line, sizeof line, "n = %zu, %s: %zu of Sunder's verdicts are WRONG", cell.n,
                  name_of(cell.regime).data(), cell.sunder.wrong);
    failures.emplace_back(line);
  }
  std::printf("\n%s", demands.c_str());
  for (const std::string& failure : failures) std::printf("FAILED: %s\n", failure.c_str());
  if (!options.json.empty()) write_json(options, cells, ratios, failures);
  return options.check && !failures.empty() ? 1 : 0;
}

}  // namespace
}  // namespace bench

int main(int argc, char** argv) {
  bench::Options options;
  for (int i = 1; i < argc; ++i) {
    const std::string argument = argv[i];
    if (argument == "--check") {
      options.check = true;
      continue;
    }
    if (argument == "--quick") {
      options.rounds = 5;
      continue;
    }
    if (i + 1 == argc) return bench::usage(("unknown option, or value missing: " + argument).c_str());
    const std::string value = argv[++i];
    if (argument == "--json") {
      options.json = value;
    } else if (argument == "--commit") {
      options.commit = value;
    } else if (argument == "--n" || argument == "--rounds" || argument == "--seed") {
      char* end = nullptr;
      const unsigned long long number = std::strtoull(value.c_str(), &end, 10);
      if (end == value.c_str() || *end != '\0' || (argument == "--n" && number < 4) ||
          (argument == "--rounds" && number < 1)) {
        return bench::usage((argument + ": bad number: " + value).c_str());
      }
      if (argument == "--n") options.sizes.push_back(number);
      if (argument == "--rounds") options.rounds = number;
      if (argument == "--seed") options.seed = number;
    } else {
      return bench::usage(("unknown option: " + argument).c_str());
    }
  }
  if (options.sizes.empty()) options.sizes = {8, 12, 20, 30, 100, 1000, 10000};
  try {
    return bench::run(options);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "bench_pair: %s\n", error.what());
    return 3;
  }
}
