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
//   - A way that takes more than 1 s for a call, or by its growth would take twice that, is left out. In the check it
//     counts with the time of that one call, or the one that its growth (linear at least) predicts.
//   - Sizes to 1,000 rotate over 64 pairs (there) to 4,000, so that no branch predictor learns one by heart; from 10^4
//     vertices on there are eight. Caches are warm: what searches look at in all pairs of a size fits the second level.
//     How the time grows is told by eight pairs at every size ("few").
//   - The boxes of the polygons meet, but in one regime, "boxes apart", which is shown and not demanded: GEOS looks at
//     them first and needs nothing else then. (Where a vertex of one polygon is in the other, which is prepared, it
//     mostly finds this out in logarithmic time as well.)
//   - Peers know no poses: posed pairs are Sunder's alone.
//   - Peers are as Debian built them, header-only ones compiled here with the flags of this build.
#include <bench/contest/program.h>
#include <bench/inputs/polygon_scenarios.h>
#include <bench/peers/polygon_peer.h>
#include <bench/peers/sunder_polygons.h>

#include <cstdio>
#include <map>
#include <memory>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

namespace bench {
namespace {

constexpr double kMostGrowth = 4;  // of the time from kGrowthFrom to kGrowthTo vertices
constexpr std::size_t kGrowthFrom = 1000, kGrowthTo = 1000000;
constexpr double kMostMicroseconds = 4;  // at kGrowthTo, in general position; about 2 are meant
constexpr double kMostFinishing = 1e-3;  // in general position

constexpr std::size_t kCheckedSize = 10000;  // beyond, certificates are checked of the front door only, in place
constexpr Pace kPace{.most = 1, .look = 0.15, .pass = 0.1, .rounds = 0.3, .once = 0.15};

const std::vector<std::size_t> kSizes{4, 10, 30, 100, 1000, 10000, 100000, 1000000};

// What `--check` demands: the time of any peer over Sunder's.
const Steps kDemanded{{0, 1}, {1000, 20}, {1000000, 2000}};

bool is_demanded(PolygonRegime regime) { return regime != PolygonRegime::boxes_apart; }
bool is_general(PolygonRegime regime) { return regime != PolygonRegime::touching; }

using Shapes = std::vector<sunder::planar::ConvexPolygon>;

// Subjects: of each method the one in place, then the one that is posed; last the front door with few pairs.
Contest contest(std::shared_ptr<const PolygonScenario> scenario) {
  Contest made;
  made.pace = kPace;
  for (const PolygonPair& pair : scenario->pairs) made.truths.push_back(pair.meet ? 1 : 0);
  for (const PolygonMethod& method : polygon_methods()) {
    for (const bool posed : {false, true}) {
      const bool certificates = made.subjects.empty() || scenario->n <= kCheckedSize;
      made.subjects.push_back({"sunder", std::string(method.name) + (posed ? ", posed" : ""),
                               [=, &method] { return prepare_sunder(scenario, method, posed, certificates); }});
    }
  }
  Entry few{"sunder", "few pairs",
            [=] { return Ready{prepare_sunder(scenario, polygon_methods().front(), false, false).run}; }};
  few.inputs.resize(std::min(kFewPairs, made.truths.size()));
  std::iota(few.inputs.begin(), few.inputs.end(), 0);
  made.subjects.push_back(std::move(few));
  for (const auto& library : {boost_polygon_ways(), geos_polygon_ways(), cgal_polygon_ways()}) {
    for (const PolygonWay& way : library) {
      made.peers.push_back(
          {std::string(way.library), std::string(way.method), [=] { return Ready{way.make(*scenario)}; }});
    }
  }
  return made;
}

std::vector<Plan> plans(const Options&) {
  static Kept<int, Shapes> shapes;
  std::vector<Plan> list;
  for (const PolygonRegime regime : kPolygonRegimes) {
    const Demand demand = is_demanded(regime) ? Demand{"", kDemanded} : Demand{};
    list.push_back({std::string(name_of(regime)), "meet", demand, kSizes, [=](std::size_t n, std::uint64_t seed) {
                      const auto of_n = shapes.get(0, n, [&] { return make_shapes(n, seed); });
                      return contest(
                          std::make_shared<const PolygonScenario>(make_polygon_scenario(n, regime, *of_n, seed)));
                    }});
  }
  return list;
}

// --- Telling, and what is demanded of the growth ---------------------------------------------------------------------

double rate(std::uint64_t count, std::uint64_t of) { return static_cast<double>(count) / static_cast<double>(of); }

const Result& few(const Row& row) { return row.subjects.back(); }

void print_methods(const std::vector<Row>& rows) {
  std::printf("Sunder's methods: microseconds per call in place and posed, mean probes in place.\n\n%8s %-12s %8s", "N",
              "regime", "few");
  for (const PolygonMethod& method : polygon_methods()) std::printf(" %22s", method.name.data());
  std::printf("\n");
  for (const Row& row : rows) {
    std::printf("%8zu %-12s %8.3f", row.n, row.input.c_str(), 1e6 * few(row).median_s);
    for (std::size_t i = 0; i + 2 < row.subjects.size(); i += 2) {
      const Result &plain = row.subjects[i], &posed = row.subjects[i + 1];
      std::printf("  %7.3f %7.3f %5.0f", 1e6 * plain.median_s, 1e6 * posed.median_s,
                  rate(plain.tally.probes, plain.tally.asked));
    }
    std::printf("\n");
  }
}

// How often the exact method had to finish, over all sizes; too often is added to the failures.
void tell_finishing(const std::vector<Row>& rows, std::vector<std::string>& failures) {
  std::map<std::string, std::map<std::string, Tally>> totals;  // by method, then regime
  for (const Row& row : rows) {
    for (const Result& subject : row.subjects) {
      if (subject.tally.asked > 0) totals[subject.method][row.input] += subject.tally;
    }
  }
  std::printf("\nFinished by the exact method, over all sizes:\n\n%-20s", "");
  for (const PolygonRegime regime : kPolygonRegimes) std::printf(" %12s", name_of(regime).data());
  for (auto& [method, by_regime] : totals) {
    std::printf("\n%-20s", method.c_str());
    for (const PolygonRegime regime : kPolygonRegimes) {
      const Tally& tally = by_regime[std::string(name_of(regime))];
      const double finished = rate(tally.finishing, std::max<std::uint64_t>(1, tally.asked));
      std::printf(" %10.3f %%", 100 * finished);
      if (!is_general(regime) || finished <= kMostFinishing) continue;
      failures.push_back(std::string(name_of(regime)) + ", " + method + ": the exact method finished " +
                         std::to_string(tally.finishing) + " of " + std::to_string(tally.asked) + " (allowed: 0.1 %)");
    }
  }
  std::printf("\n\n");
}

// How the time grows, and what it is at the largest size: printed, and what is too much added to the failures.
void tell_growth(const std::vector<Row>& rows, std::vector<std::string>& failures) {
  char line[200];
  for (const PolygonRegime regime : kPolygonRegimes) {
    const std::string name(name_of(regime));
    const Row *from = find(rows, name, kGrowthFrom), *to = find(rows, name, kGrowthTo);
    if (to == nullptr) continue;
    const double us = 1e6 * few(*to).median_s;
    std::snprintf(line, sizeof line,
                  "%s: %.2f microseconds at 10^6 vertices (about 2 are meant, %.0f allowed in general position)",
                  name.c_str(), us, kMostMicroseconds);
    std::printf("%s\n", line);
    if (is_demanded(regime) && is_general(regime) && us > kMostMicroseconds) failures.emplace_back(line);
    if (from == nullptr) continue;
    const double growth = few(*to).median_s / few(*from).median_s;
    std::snprintf(line, sizeof line, "%s: from 10^3 to 10^6 vertices the time grows %.2f times (allowed: below %.0f)",
                  name.c_str(), growth, kMostGrowth);
    std::printf("%s\n", line);
    if (is_demanded(regime) && !(growth < kMostGrowth)) failures.emplace_back(line);
  }
}

void conclude(const std::vector<Row>& rows, std::vector<std::string>& failures) {
  print_methods(rows);
  tell_finishing(rows, failures);
  tell_growth(rows, failures);
}

}  // namespace
}  // namespace bench

int main(int argc, char** argv) {
  bench::Program program;
  program.name = "bench_polygons";
  program.note = "N: vertices of a polygon. \"sunder\": the front door, in place.";
  program.libraries = {"boost", "geos", "cgal"};
  program.plans = bench::plans;
  program.conclude = bench::conclude;
  return bench::run(program, argc, argv);
}
