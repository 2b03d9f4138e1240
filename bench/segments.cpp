// bench_segments: do any two of N segments meet? Which do? Is a polygon simple, or a drawing plane? Against CGAL, GEOS, Boost.Geometry, and
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
#include <bench/contest/program.h>
#include <bench/inputs/segment_scenarios.h>
#include <bench/peers/segment_peer.h>
#include <bench/peers/sunder_segments.h>

#include <sunder/io/plane/lines.h>

#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#ifndef SUNDER_BENCH_MAP
#define SUNDER_BENCH_MAP "../shared/data/planar/natural-earth/ne_50m_coastline.json"
#endif

namespace bench {
namespace {

const std::vector<std::size_t> kSizes{100, 1000, 10000, 100000, 1000000};
constexpr std::size_t kDemandedFrom = 10000, kMost = 1000000;  // segments, for ratios to the sort

using Family = SegmentFamily;
using Inputs = std::vector<SegmentInput>;

struct Asking {
  std::vector<Family> families;
  std::vector<Question> questions;
};
const std::vector<Asking> kAsked{
    {{Family::mesh}, {Question::make, Question::any, Question::transcript, Question::drawing}},
    {{Family::loose_mesh}, {Question::make, Question::any, Question::transcript}},
    {{Family::star}, {Question::make, Question::any, Question::transcript, Question::drawing, Question::simple}},
    {{Family::loose_star, Family::map, Family::wires}, {Question::make, Question::any, Question::transcript}},
    {{Family::hidden_end, Family::hidden_random}, {Question::any, Question::drawing}},
    {{Family::meander}, {Question::simple}},
    {{Family::crossed_mesh, Family::random, Family::tangled_star}, {Question::all, Question::count}},
};

// What `--check` demands of Sunder in sorts.
Steps most_sorts(Family family, Question question) {
  const bool star = family == Family::star || family == Family::loose_star;
  const bool local = family == Family::mesh || family == Family::loose_mesh || family == Family::map;
  switch (question) {
    case Question::any:
      if (family == Family::mesh) return {{kDemandedFrom, 1.5}, {kMost, 0.7}};
      return local ? Steps{{kDemandedFrom, 1.5}} : star ? Steps{{kDemandedFrom, 4}} : Steps{};
    case Question::transcript: return local || star ? Steps{{kDemandedFrom, 6}} : Steps{};
    case Question::simple:
      if (family == Family::star) return {{kDemandedFrom, 3}, {kMost, 2.5}};
      return {{kDemandedFrom, 3}};
    case Question::all:
      if (family == Family::crossed_mesh) return {{kDemandedFrom, 3}};
      return family == Family::random ? Steps{{kDemandedFrom, 6}} : Steps{};
    default: return {};
  }
}

// The question as peers know it.
std::optional<SegmentQuestion> peers_question(Question question) {
  switch (question) {
    case Question::any: return SegmentQuestion::any;
    case Question::simple: return SegmentQuestion::simple;
    case Question::all: return SegmentQuestion::all;
    case Question::count: return SegmentQuestion::count;
    default: return {};
  }
}

Contest contest(const std::shared_ptr<const Inputs>& inputs, Question question) {
  Contest made;
  std::vector<std::vector<Xy>> ends;
  for (const SegmentInput& input : *inputs) {
    made.truths.push_back(truth(input, question));
    auto& of_input = ends.emplace_back();
    for (const Line& l : input.lines) of_input.insert(of_input.end(), {l.a, l.b});
  }
  made.yardstick =
      sort_of(std::move(ends), [](const Xy& p, const Xy& q) { return p.x < q.x || (p.x == q.x && p.y < q.y); });
  made.subjects = {entry_by_input("sunder", "front door", inputs->size(),
                                  [=](std::size_t k) { return ask_sunder((*inputs)[k], question); })};
  const std::optional<SegmentQuestion> asked = peers_question(question);
  if (!asked) return made;
  for (const auto& library : {cgal_segment_ways(), geos_segment_ways(), boost_segment_ways()}) {
    for (const SegmentWay& way : library) {
      made.peers.push_back(entry_by_input(std::string(way.library), std::string(way.method), inputs->size(),
                                          [=](std::size_t k) { return way.make((*inputs)[k], *asked); }));
    }
  }
  return made;
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

std::vector<Plan> plans(const Options& options) {
  static Kept<Family, Inputs> kept;
  const auto map = std::make_shared<const std::vector<Line>>(read_map(options.own.at("--map")));
  std::vector<Plan> list;
  for (const auto& [families, questions] : kAsked) {
    for (const Family family : families) {
      if (family == Family::map && map->empty()) continue;
      for (const Question question : questions) {
        const Demand demand{"", {{0, 1}}, most_sorts(family, question)};
        const auto make = [=](std::size_t n, std::uint64_t seed) {
          return contest(kept.get(family, n, [&] { return make_segment_inputs(family, n, seed, *map); }), question);
        };
        list.push_back({std::string(name_of(family)), std::string(name_of(question)), demand, kSizes, make});
      }
    }
  }
  return list;
}

}  // namespace
}  // namespace bench

int main(int argc, char** argv) {
  bench::Program program;
  program.name = "bench_segments";
  program.note = "The sort: of the 2 N endpoints.";
  program.libraries = {"cgal", "geos", "boost"};
  program.questions = {"any", "simple", "all"};
  program.plans = bench::plans;
  program.own = {{"--map", SUNDER_BENCH_MAP}};
  return bench::run(program, argc, argv);
}
