// bench_segments: do any two of N segments meet? Which do? Is a polygon simple? Against CGAL, GEOS, Boost.Geometry, and
// against sorting.
//
// The yardstick is std::sort of the 2 N endpoints by (x, y): what no sweep does without. Only ratios mean anything.
//
// Fairness:
//   - All contestants answer the same inputs in one run, in rounds, and take turns in going first. The time of a
//     contestant is the median over its rounds of its mean per call, in processor time of its thread, one thread each.
//     Whoever takes long takes part in fewer rounds, at least three.
//   - Each library may prepare objects of its own outside of the loop: segments, lines, boxes. What an algorithm builds
//     to answer (trees, sorted lists) is timed. The making of Sunder's Segments is a line of its own, "make".
//   - Peers are asked by every way that they offer (see peers/segment_peer.h). Of each library the fastest way that is
//     right on all inputs of the row counts. Where none is right the fastest wrong one is shown with "!", and does not
//     count.
//   - A way that takes more than 3 s for one call, or by its growth would take twice that, is left out: "over 3 s". In
//     the check it counts with the time of that one call, or the one that its growth (linear at least) predicts.
//     "-": the library does not answer that. No peer writes a transcript.
//   - Small sizes rotate over many inputs, so that no branch predictor learns one by heart.
//   - Peers are as Debian built them, header-only ones compiled here with the flags of this build.
#include <sunder/io/lines.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "options.h"
#include "report.h"
#include "segment_contest.h"
#include "segment_scenarios.h"
#include "segment_subject.h"

#ifndef SUNDER_BENCH_MAP
#define SUNDER_BENCH_MAP "../shared/data/planar/natural-earth/ne_50m_coastline.json"
#endif

namespace bench {
namespace {

constexpr std::size_t kDemandedFrom = 10000;  // segments, for ratios to the sort

const std::vector<Plan> kPlans{
    {SegmentFamily::mesh, {Question::make, Question::any, Question::transcript}},
    {SegmentFamily::loose_mesh, {Question::make, Question::any, Question::transcript}},
    {SegmentFamily::star, {Question::make, Question::any, Question::transcript, Question::simple}},
    {SegmentFamily::loose_star, {Question::make, Question::any, Question::transcript}},
    {SegmentFamily::map, {Question::make, Question::any, Question::transcript}},
    {SegmentFamily::wires, {Question::make, Question::any, Question::transcript}},
    {SegmentFamily::hidden_end, {Question::any}},
    {SegmentFamily::hidden_random, {Question::any}},
    {SegmentFamily::meander, {Question::simple}},
    {SegmentFamily::crossed_mesh, {Question::all, Question::count}},
    {SegmentFamily::random, {Question::all, Question::count}},
    {SegmentFamily::tangled_star, {Question::all, Question::count}},
};

// What `--check` demands of Sunder: at most so many times the sort; 0: nothing.
double allowed_sorts(SegmentFamily family, Question question, std::size_t n) {
  const bool star = family == SegmentFamily::star || family == SegmentFamily::loose_star;
  const bool local =
      family == SegmentFamily::mesh || family == SegmentFamily::loose_mesh || family == SegmentFamily::map;
  switch (question) {
    case Question::any: return family == SegmentFamily::mesh && n >= 1000000 ? 0.7 : local ? 1.5 : star ? 4 : 0;
    case Question::transcript: return local || star ? 6 : 0;
    case Question::simple: return family == SegmentFamily::star && n >= 1000000 ? 2.5 : 3;
    case Question::all:
      if (family == SegmentFamily::crossed_mesh) return 3;
      return family == SegmentFamily::random ? 6 : 0;
    default: return 0;
  }
}

struct Options : ContestOptions {
  bool check = false;
  bool ways = false;  // print the first look at every way
  std::vector<std::size_t> sizes;
  std::string json, commit, map = SUNDER_BENCH_MAP;
};

// --- Telling ---------------------------------------------------------------------------------------------------------

void print_head() {
  std::printf(
      "Times in milliseconds per call. \"sorts\": Sunder's time in sorts of the endpoints. The peers' columns: their "
      "time "
      "in\nSunder's. \"wrong\": inputs with a wrong answer, of Sunder, CGAL, GEOS, Boost; \"!\": no way was "
      "right.\n\n");
  std::printf("%8s %-13s %-10s %11s %11s %7s %9s %9s %9s  %-9s %s\n", "N", "input", "question", "sort", "sunder",
              "sorts", "cgal", "geos", "boost", "wrong", "by which way");
}

void print(const Row& row, bool ways) {
  using State = Result::State;
  const bool known = row.sunder.state == State::measured;
  char text[64];
  std::printf("%8.0f %-13s %-10s %11.4f", row.segments, name_of(row.family).data(), name_of(row.question).data(),
              1e3 * row.sort_s);
  if (known) {
    std::printf(" %11.4f %7.2f", 1e3 * row.sunder.median_s, row.sorts());
  } else {
    std::printf(" %11s %7s", "-", "-");
  }
  std::string wrong = known ? std::to_string(row.sunder.wrong) : "-", methods;
  for (const Result& peer : row.peers) {
    std::string cell = "-";
    if (peer.state == State::over) cell = "over 3 s";
    if (peer.state == State::measured) {
      if (known) {
        std::snprintf(text, sizeof text, "%.2f", peer.median_s / row.sunder.median_s);
      } else {
        std::snprintf(text, sizeof text, "%.3g ms", 1e3 * peer.median_s);
      }
      cell = std::string(peer.wrong > 0 ? "!" : "") + text;
      methods += (methods.empty() ? "" : "; ") + peer.method;
    }
    wrong += peer.state == State::measured ? "/" + std::to_string(peer.wrong) : "/-";
    std::printf(" %9s", cell.c_str());
  }
  std::printf("  %-9s %s\n", wrong.c_str(), methods.c_str());
  for (const Look& look : row.looks) {
    if (!ways) break;
    std::printf("%45s %11.4f  %s, %s; wrong: %zu of %zu\n", "at first sight", 1e3 * look.seconds, look.library.c_str(),
                look.method.c_str(), look.wrong, row.inputs);
  }
  std::fflush(stdout);
}

void print_json(std::FILE* out, const Result& r) {
  if (r.state != Result::State::measured) {
    const bool over = r.state == Result::State::over;
    if (over) {
      std::fprintf(out, "{\"library\": \"%s\", \"left_out\": \"over 3 s\", \"about_ms\": %.0f}", r.library.c_str(),
                   1e3 * r.median_s);
    } else {
      std::fprintf(out, "{\"library\": \"%s\", \"left_out\": \"does not answer\"}", r.library.c_str());
    }
    return;
  }
  std::fprintf(out,
               "{\"library\": \"%s\", \"method\": \"%s\", \"median_ms\": %.6f, \"lowest_ms\": %.6f, \"wrong\": %zu}",
               r.library.c_str(), r.method.c_str(), 1e3 * r.median_s, 1e3 * r.lowest_s, r.wrong);
}

void write_json(const Options& options, const std::vector<Row>& rows, const std::vector<std::string>& failures) {
  ReportFile file(options.json);
  std::FILE* out = file.get();
  std::fprintf(out, "{\n  \"benchmark\": \"segments\",\n");
  print_json(out, circumstances(options.commit));
  std::fprintf(out, "  \"rounds\": %zu,\n  \"seed\": %llu,\n  \"failures\": [", options.rounds,
               static_cast<unsigned long long>(options.seed));
  for (std::size_t i = 0; i < failures.size(); ++i) {
    std::fprintf(out, "%s\"%s\"", i == 0 ? "" : ", ", failures[i].c_str());
  }
  std::fprintf(out, "],\n  \"rows\": [\n");
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const Row& row = rows[i];
    std::fprintf(out,
                 "    {\"n\": %zu, \"input\": \"%s\", \"question\": \"%s\", \"inputs\": %zu, \"segments\": %.1f, "
                 "\"pairs\": %.1f, \"sort_ms\": %.6f",
                 row.n, name_of(row.family).data(), name_of(row.question).data(), row.inputs, row.segments, row.pairs,
                 1e3 * row.sort_s);
    if (row.sunder.state == Result::State::measured) {
      std::fprintf(out, ", \"sorts\": %.3f,\n     \"results\": [\n      ", row.sorts());
      print_json(out, row.sunder);
      std::fprintf(out, ",\n      ");
    } else {
      std::fprintf(out, ",\n     \"results\": [\n      ");
    }
    for (std::size_t k = 0; k < row.peers.size(); ++k) {
      print_json(out, row.peers[k]);
      std::fprintf(out, "%s", k + 1 == row.peers.size() ? "],\n     \"first_looks\": [" : ",\n      ");
    }
    for (std::size_t k = 0; k < row.looks.size(); ++k) {
      const Look& look = row.looks[k];
      std::fprintf(out, "%s\n      {\"library\": \"%s\", \"method\": \"%s\", \"ms\": %.6f, \"wrong\": %zu}",
                   k == 0 ? "" : ",", look.library.c_str(), look.method.c_str(), 1e3 * look.seconds, look.wrong);
    }
    std::fprintf(out, "]}");
    std::fprintf(out, "%s\n", i + 1 == rows.size() ? "" : ",");
  }
  std::fprintf(out, "  ]\n}\n");
  file.commit();
}

std::vector<std::string> failures_of(const std::vector<Row>& rows) {
  std::vector<std::string> failures;
  for (const Row& row : rows) {
    char line[200];
    const std::string what = std::string(name_of(row.family)) + ", " + std::string(name_of(row.question)) + ", " +
                             std::to_string(row.n) + " segments: ";
    if (row.sunder.state != Result::State::measured) {
      failures.push_back(what + "Sunder does not answer yet");
      continue;
    }
    if (row.sunder.wrong > 0)
      failures.push_back(what + std::to_string(row.sunder.wrong) + " of Sunder's answers are WRONG");
    const double allowed = allowed_sorts(row.family, row.question, row.n);
    if (allowed > 0 && row.n >= kDemandedFrom && row.sorts() > allowed) {
      std::snprintf(line, sizeof line, "%.2f sorts (allowed: %.1f)", row.sorts(), allowed);
      failures.push_back(what + line);
    }
    for (const Result& peer : row.peers) {
      const bool counts =
          peer.state == Result::State::over || (peer.state == Result::State::measured && peer.wrong == 0);
      if (!counts || peer.median_s > row.sunder.median_s) continue;
      std::snprintf(line, sizeof line, "%s takes %.2f of Sunder's time%s", peer.library.c_str(),
                    peer.median_s / row.sunder.median_s,
                    peer.state == Result::State::over ? ", by the growth of its times" : "");
      failures.push_back(what + line);
    }
  }
  return failures;
}

std::vector<Line> read_map(const std::string& path) {
  std::vector<Line> lines;
  if (!std::filesystem::exists(path)) {
    std::printf("Left out: the map. There is no %s\n", path.c_str());
    return lines;
  }
  for (const sunder::planar::Segment& s : sunder::io::read_lines(path).segments) {
    lines.push_back({{s.a.x, s.a.y}, {s.b.x, s.b.y}});
  }
  return rounded(std::move(lines));
}

int run(const Options& options) {
  print_text(stdout, circumstances(options.commit));
  const std::vector<Line> map = read_map(options.map);
  print_head();

  // Sizes between, which nobody asked for, tell how fast the time of a peer grows.
  std::vector<std::size_t> sizes = options.sizes;
  for (std::size_t n = 100; n < *std::max_element(options.sizes.begin(), options.sizes.end()); n *= 10)
    sizes.push_back(n);
  std::sort(sizes.begin(), sizes.end());
  sizes.erase(std::unique(sizes.begin(), sizes.end()), sizes.end());

  std::vector<Row> rows;
  for (const Plan& plan : kPlans) {
    if (plan.family == SegmentFamily::map && map.empty()) continue;
    if (std::none_of(plan.questions.begin(), plan.questions.end(), [&](Question q) { return options.asks(q); }))
      continue;
    History history;
    for (const std::size_t n : sizes) {
      const bool wanted = std::find(options.sizes.begin(), options.sizes.end(), n) != options.sizes.end();
      for (const Row& row : measure(plan, n, !wanted, map, options, history)) {
        print(row, options.ways);
        rows.push_back(row);
      }
    }
  }
  const std::vector<std::string> failures = failures_of(rows);
  std::printf("\n");
  print_failures(failures);
  if (!options.json.empty()) write_json(options, rows, failures);
  return options.check && !failures.empty() ? 1 : 0;
}

int usage(const std::string& problem) {
  std::fprintf(stderr,
               "bench_segments: %s\n"
               "usage: bench_segments [--check] [--quick] [--ways] [--only any|simple|all]... [--sizes N,N,...] "
               "[--rounds COUNT] "
               "[--seed SEED] [--map FILE] [--json FILE] [--commit ID]\n",
               problem.c_str());
  return 2;
}

}  // namespace
}  // namespace bench

int main(int argc, char** argv) {
  using bench::Question;
  bench::Options options;
  bool quick = false;
  const auto more = [&](const std::string& name, const std::string& value) {
    if (name == "--map") {
      options.map = value;
      return 0;
    }
    if (name != "--only") return 1;
    std::vector<Question> add;
    if (value == "any") add = {Question::make, Question::any, Question::transcript};
    if (value == "simple") add = {Question::simple};
    if (value == "all") add = {Question::all, Question::count};
    options.questions.insert(options.questions.end(), add.begin(), add.end());
    return add.empty() ? 2 : 0;
  };
  const std::string problem = bench::read_options(argc, argv, 100, options, quick, more);
  if (!problem.empty()) return bench::usage(problem);
  if (options.sizes.empty()) {
    options.sizes = {100, 1000, 10000, 100000};
    if (!quick) options.sizes.push_back(1000000);
  }
  try {
    return bench::run(options);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "bench_segments: %s\n", error.what());
    return 3;
  }
}
