// bench_polygons: do two convex polygons meet? Against Boost.Geometry, GEOS and CGAL.
//
// Fairness:
//   - All contestants answer the same pairs in one run, in rounds, and take turns in going first. The time of a
//     contestant is the median over its rounds of its mean per call, in processor time of its thread. Whoever takes
//     long takes part in fewer rounds and answers fewer pairs in each; a call of over 0.15 s is made once or twice in
//     all.
//   - Each library may prepare objects of its own outside of the loop: rings, polygons, prepared geometries.
//   - Peers are asked for a boolean only, by every way that they offer (see peers/polygon_peer.h). Of each library the
//     fastest way that is right on all pairs asked counts. Where none is right the fastest wrong one is shown with "!",
//     and does not count. Sunder's answer holds its certificate.
//   - A way that by its time at the size before would take more than 1 s for a call is left out: "over". In the check
//   it
//     counts with the time that linear growth predicts.
//   - Sizes to 1,000 rotate over 64 pairs (there) to 4,000, so that no branch predictor learns one by heart; from 10^4
//     vertices on there are eight. Caches are warm: what searches look at in all pairs of a size fits the second level.
//     How the time grows is told by eight pairs at every size ("few").
//   - The boxes of the polygons meet, but in one regime, "boxes apart", which is shown and not demanded: GEOS looks at
//     them first and needs nothing else then. (Where a vertex of one polygon is in the other, which is prepared, it
//     mostly finds this out in logarithmic time as well.)
//   - Peers know no poses: posed pairs are Sunder's alone.
//   - Peers are as Debian built them, header-only ones compiled here with the flags of this build.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <map>
#include <string>
#include <tuple>
#include <vector>

#include "options.h"
#include "polygon_contest.h"
#include "polygon_scenarios.h"
#include "report.h"

namespace bench {
namespace {

constexpr double kMostGrowth = 4;  // of the time from kGrowthFrom to kGrowthTo vertices
constexpr std::size_t kGrowthFrom = 1000, kGrowthTo = 1000000;
constexpr double kMostMicroseconds = 4;  // at kGrowthTo, in general position; about 2 are meant
constexpr double kMostFinishing = 1e-3;  // in general position

// What `--check` demands: the time of any peer over Sunder's.
double demanded_ratio(std::size_t n) { return n >= 1000000 ? 2000 : n >= 1000 ? 20 : 1; }

bool is_demanded(PolygonRegime regime) { return regime != PolygonRegime::boxes_apart; }
bool is_general(PolygonRegime regime) { return regime != PolygonRegime::touching; }

struct Options {
  bool check = false;
  bool ways = false;  // print the first look at every way
  std::size_t rounds = 11;
  std::uint64_t seed = 1;
  std::vector<std::size_t> sizes;
  std::string json, commit;
};

// The tallies of a method in a regime, over all sizes.
using Totals = std::map<std::tuple<std::string, bool, PolygonRegime>, PolygonTally>;

Totals totals_of(const std::vector<PolygonCell>& cells) {
  Totals totals;
  for (const PolygonCell& cell : cells) {
    for (const MethodResult& m : cell.methods) totals[{m.name, m.posed, cell.regime}] += m.tally;
  }
  return totals;
}

double rate(std::uint64_t count, std::uint64_t of) { return static_cast<double>(count) / static_cast<double>(of); }

const PolygonCell* find(const std::vector<PolygonCell>& cells, std::size_t n, PolygonRegime regime) {
  for (const PolygonCell& cell : cells) {
    if (cell.n == n && cell.regime == regime) return &cell;
  }
  return nullptr;
}

// --- Telling ---------------------------------------------------------------------------------------------------------

void print_head() {
  std::printf(
      "Times in microseconds per call. \"sunder\": the front door; \"few\": with %zu pairs alone; \"posed\": under "
      "poses. "
      "The\npeers' columns: their time in Sunder's. \"wrong\": answers of Sunder, Boost, GEOS, CGAL; \"!\": no way was "
      "right.\n\n",
      kFewPairs);
  std::printf("%8s %-12s %6s %9s %9s %9s %10s %10s %10s  %-15s %s\n", "n", "regime", "pairs", "sunder", "few", "posed",
              "boost", "geos", "cgal", "wrong", "by which way");
}

void print(const PolygonCell& cell, bool ways) {
  std::printf("%8zu %-12s %6zu %9.3f %9.3f %9.3f", cell.n, name_of(cell.regime).data(), cell.pairs, cell.sunder_us(),
              cell.few_us, cell.methods[1].us);
  std::string wrong = std::to_string(cell.methods[0].tally.wrong), methods;
  for (const PolygonResult& peer : cell.peers) {
    char text[64] = "-";
    if (peer.state == PolygonResult::State::over) std::snprintf(text, sizeof text, "over");
    if (peer.state == PolygonResult::State::measured) {
      const char* mark = peer.wrong > 0 ? "!" : "";
      std::snprintf(text, sizeof text, cell.ratio(peer) < 100 ? "%s%.2f" : "%s%.0f", mark, cell.ratio(peer));
      methods += (methods.empty() ? "" : "; ") + peer.method;
    }
    wrong += peer.state == PolygonResult::State::measured ? "/" + std::to_string(peer.wrong) : "/-";
    std::printf(" %10s", text);
  }
  std::printf("  %-15s %s\n", wrong.c_str(), methods.c_str());
  for (const PolygonResult& look : cell.looks) {
    if (!ways) break;
    std::printf("%39s %14.3f  %s, %s; wrong: %zu of %zu\n", "at first sight", look.us, look.library.c_str(),
                look.method.c_str(), look.wrong, look.asked);
  }
  std::fflush(stdout);
}

void print_methods(const std::vector<PolygonCell>& cells) {
  std::printf("\nSunder's methods: microseconds per call in place and posed, mean probes in place.\n\n%8s %-12s", "n",
              "regime");
  for (const PolygonMethod& method : polygon_methods()) std::printf(" %22s", method.name.data());
  std::printf("\n");
  for (const PolygonCell& cell : cells) {
    std::printf("%8zu %-12s", cell.n, name_of(cell.regime).data());
    for (std::size_t i = 0; i < cell.methods.size(); i += 2) {
      const MethodResult &plain = cell.methods[i], &posed = cell.methods[i + 1];
      std::printf("  %7.3f %7.3f %5.0f", plain.us, posed.us, rate(plain.tally.probes, plain.tally.pairs));
    }
    std::printf("\n");
  }
  std::printf("\nFinished by the exact method, over all sizes, in place and posed:\n\n%-12s", "");
  for (const PolygonRegime regime : kPolygonRegimes) std::printf(" %18s", name_of(regime).data());
  std::printf("\n");
  const Totals totals = totals_of(cells);
  for (const PolygonMethod& method : polygon_methods()) {
    std::printf("%-12s", method.name.data());
    for (const PolygonRegime regime : kPolygonRegimes) {
      char text[64];
      const PolygonTally plain = totals.at({std::string(method.name), false, regime}),
                         posed = totals.at({std::string(method.name), true, regime});
      std::snprintf(text, sizeof text, "%.3f %% %.3f %%", 100 * rate(plain.finishing, plain.pairs),
                    100 * rate(posed.finishing, posed.pairs));
      std::printf(" %18s", text);
    }
    std::printf("\n");
  }
}

void print_json(std::FILE* out, const PolygonResult& r) {
  if (r.state != PolygonResult::State::measured) {
    std::fprintf(out, "{\"library\": \"%s\", \"left_out\": \"over %.0f s\", \"about_us\": %.0f}", r.library.c_str(),
                 kMostPolygonSeconds, r.us);
    return;
  }
  std::fprintf(out,
               "{\"library\": \"%s\", \"method\": \"%s\", \"us\": %.4f, \"lowest_us\": %.4f, \"wrong\": %zu, "
               "\"asked\": %zu}",
               r.library.c_str(), r.method.c_str(), r.us, r.lowest_us, r.wrong, r.asked);
}

void print_json(std::FILE* out, const MethodResult& m) {
  std::fprintf(out,
               "{\"method\": \"%s\", \"posed\": %s, \"us\": %.4f, \"pairs\": %llu, \"finishing\": %llu, "
               "\"probes\": %llu, \"exact\": %llu, \"wrong\": %llu}",
               m.name.c_str(), m.posed ? "true" : "false", m.us, static_cast<unsigned long long>(m.tally.pairs),
               static_cast<unsigned long long>(m.tally.finishing), static_cast<unsigned long long>(m.tally.probes),
               static_cast<unsigned long long>(m.tally.exact), static_cast<unsigned long long>(m.tally.wrong));
}

template <class Item>
void print_list(std::FILE* out, const char* name, const std::vector<Item>& items) {
  std::fprintf(out, ",\n     \"%s\": [", name);
  for (std::size_t i = 0; i < items.size(); ++i) {
    std::fprintf(out, "%s\n      ", i == 0 ? "" : ",");
    print_json(out, items[i]);
  }
  std::fprintf(out, "]");
}

void write_json(const Options& options, const std::vector<PolygonCell>& cells,
                const std::vector<std::string>& failures) {
  ReportFile file(options.json);
  std::FILE* out = file.get();
  std::fprintf(out, "{\n  \"benchmark\": \"polygons\",\n");
  print_json(out, circumstances(options.commit));
  std::fprintf(out, "  \"rounds\": %zu,\n  \"seed\": %llu,\n  \"failures\": [", options.rounds,
               static_cast<unsigned long long>(options.seed));
  for (std::size_t i = 0; i < failures.size(); ++i) {
    std::fprintf(out, "%s\"%s\"", i == 0 ? "" : ", ", failures[i].c_str());
  }
  std::fprintf(out, "],\n  \"cells\": [\n");
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const PolygonCell& cell = cells[i];
    std::fprintf(out, "    {\"n\": %zu, \"regime\": \"%s\", \"pairs\": %zu, \"few_us\": %.4f", cell.n,
                 name_of(cell.regime).data(), cell.pairs, cell.few_us);
    print_list(out, "sunder", cell.methods);
    print_list(out, "peers", cell.peers);
    print_list(out, "first_looks", cell.looks);
    std::fprintf(out, "}%s\n", i + 1 == cells.size() ? "" : ",");
  }
  std::fprintf(out, "  ]\n}\n");
  file.commit();
}

// --- What is demanded ------------------------------------------------------------------------------------------------

std::vector<std::string> failures_of(const std::vector<PolygonCell>& cells) {
  std::vector<std::string> failures;
  char line[200];
  for (const PolygonCell& cell : cells) {
    const std::string what = "n = " + std::to_string(cell.n) + ", " + std::string(name_of(cell.regime)) + ": ";
    for (const MethodResult& m : cell.methods) {
      if (m.tally.wrong == 0) continue;
      failures.push_back(what + std::to_string(m.tally.wrong) + " of Sunder's answers are WRONG, by " + m.name +
                         (m.posed ? ", posed" : ""));
    }
    if (!is_demanded(cell.regime)) continue;
    for (const PolygonResult& peer : cell.peers) {
      const bool counts =
          peer.state == PolygonResult::State::over || (peer.state == PolygonResult::State::measured && peer.wrong == 0);
      const double demanded = demanded_ratio(cell.n);
      if (!counts || cell.ratio(peer) > demanded) continue;
      std::snprintf(line, sizeof line, "%s takes %.2f times Sunder's time (demanded: %.0f)", peer.library.c_str(),
                    cell.ratio(peer), demanded);
      failures.push_back(what + line);
    }
  }
  for (const auto& [key, tally] : totals_of(cells)) {
    const auto& [method, posed, regime] = key;
    if (!is_general(regime) || rate(tally.finishing, tally.pairs) <= kMostFinishing) continue;
    std::snprintf(line, sizeof line, "%s, %s%s: the exact method finished %llu of %llu (allowed: 0.1 %%)",
                  name_of(regime).data(), method.c_str(), posed ? ", posed" : "",
                  static_cast<unsigned long long>(tally.finishing), static_cast<unsigned long long>(tally.pairs));
    failures.emplace_back(line);
  }
  return failures;
}

// How the time grows, and what it is at the largest size: printed, and what is too much added to the failures.
void tell_growth(const std::vector<PolygonCell>& cells, std::vector<std::string>& failures) {
  char line[200];
  for (const PolygonRegime regime : kPolygonRegimes) {
    const PolygonCell *from = find(cells, kGrowthFrom, regime), *to = find(cells, kGrowthTo, regime);
    if (to == nullptr) continue;
    std::snprintf(line, sizeof line,
                  "%s: %.2f microseconds at 10^6 vertices (about 2 are meant, %.0f allowed in general position)",
                  name_of(regime).data(), to->few_us, kMostMicroseconds);
    std::printf("%s\n", line);
    if (is_demanded(regime) && is_general(regime) && to->few_us > kMostMicroseconds) failures.emplace_back(line);
    if (from == nullptr) continue;
    std::snprintf(line, sizeof line, "%s: from 10^3 to 10^6 vertices the time grows %.2f times (allowed: below %.0f)",
                  name_of(regime).data(), to->few_us / from->few_us, kMostGrowth);
    std::printf("%s\n", line);
    if (is_demanded(regime) && !(to->few_us < kMostGrowth * from->few_us)) failures.emplace_back(line);
  }
}

int run(const Options& options) {
  print_text(stdout, circumstances(options.commit));
  print_head();
  std::vector<PolygonCell> cells;
  PolygonHistory history;
  for (const std::size_t n : options.sizes) {
    const auto shapes = make_shapes(n, options.seed);
    for (const PolygonRegime regime : kPolygonRegimes) {
      cells.push_back(measure(make_polygon_scenario(n, regime, shapes, options.seed), options.rounds, history));
      print(cells.back(), options.ways);
    }
  }
  print_methods(cells);
  std::printf("\n");
  std::vector<std::string> failures = failures_of(cells);
  tell_growth(cells, failures);
  print_failures(failures);
  if (!options.json.empty()) write_json(options, cells, failures);
  return options.check && !failures.empty() ? 1 : 0;
}

int usage(const std::string& problem) {
  std::fprintf(stderr,
               "bench_polygons: %s\n"
               "usage: bench_polygons [--check] [--quick] [--ways] [--sizes N,N,...] [--rounds COUNT] [--seed SEED] "
               "[--json FILE] [--commit ID]\n",
               problem.c_str());
  return 2;
}

}  // namespace
}  // namespace bench

int main(int argc, char** argv) {
  bench::Options options;
  bool quick = false;
  const std::string problem =
      bench::read_options(argc, argv, 4, options, quick, [](const std::string&, const std::string&) { return 1; });
  if (!problem.empty()) return bench::usage(problem);
  if (options.sizes.empty()) {
    options.sizes = {4, 10, 30, 100, 1000, 10000, 100000};
    if (!quick) options.sizes.push_back(1000000);
  }
  std::sort(options.sizes.begin(), options.sizes.end());
  try {
    return bench::run(options);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "bench_polygons: %s\n", error.what());
    return 3;
  }
}
