// bench_sets: do any two of N discs, of N convex polygons, of N polygons meet? Which do? Is a polygon valid? Against
// CGAL, GEOS, Boost.Geometry, and against sorting.
//
// The yardstick is std::sort of the 2 N ends of the objects in x, as doubles with their indices. Only ratios mean
// anything.
//
// Fairness:
//   - All contestants answer the same inputs in one run, in rounds, and take turns in going first. The time of a
//     contestant is the median over its rounds of its mean per call, in processor time of its thread, one thread each.
//     Whoever takes long takes part in fewer rounds, at least three, and answers fewer of the inputs.
//   - Each library may prepare objects of its own outside of the loop: discs, polygons, edges, boxes. What is built
//     over the set to answer (trees, sorted boxes) is timed.
//   - Peers are asked by every way that they offer (see peers/set_peer.h). Of each library the fastest way that is
//     right on all inputs of the row counts. Where none is right the fastest wrong one is shown with "!", and does
//     not count.
//   - A way that takes more than 3 s for one call, or by its growth would take twice that, is left out. In the check it
//     counts with the time of that one call, or the one that its growth (linear at least) predicts. So is a way that by
//     its growth would take ten times as long as the fastest one of its library.
//   - Small sizes rotate over many inputs, so that no branch predictor learns one by heart. A single contact is hidden
//     at nine places at least, at two in 10^6 objects: how soon it is found is luck.
//   - What is true of each input is counted apart, in integers (set_count.h).
//   - Peers are as Debian built them, header-only ones compiled here with the flags of this build.
#include <bench/contest/program.h>
#include <bench/inputs/set_scenarios.h>
#include <bench/peers/sunder_sets.h>
#include <bench/set_cliffs.h>

#include <memory>
#include <string>
#include <vector>

namespace bench {
namespace {

const std::vector<std::size_t> kSizes{100, 1000, 10000, 100000, 1000000};
constexpr std::size_t kMost = 1000000;

using Inputs = std::shared_ptr<const std::vector<SetInput>>;

Inputs inputs_of(SetFamily family, std::size_t n, std::uint64_t seed) {
  return std::make_shared<const std::vector<SetInput>>(make_set_inputs(family, n, seed));
}

std::vector<double> ends_of(const SetInput& input) {
  std::vector<double> ends;
  for (const Frame& frame : frames_of(input)) ends.insert(ends.end(), {frame.low.x, frame.high.x});
  return ends;
}

Contest contest(const Inputs& inputs, SetKind kind, SetQuestion question, bool transcript) {
  Contest made;
  std::vector<std::vector<double>> ends;
  for (const SetInput& input : *inputs) {
    made.truths.push_back(question == SetQuestion::any ? std::uint64_t{input.pairs > 0} : input.pairs);
    ends.push_back(ends_of(input));
  }
  made.yardstick = sort_with_indices(ends);
  made.subjects = {entry_by_input("sunder", "front door", inputs->size(), [=](std::size_t k) {
    const SetInput& input = (*inputs)[k];
    return transcript ? ask_sunder_for_transcript(input, kind) : ask_sunder(input, kind, question);
  })};
  if (transcript) return made;
  for (const auto& library : {cgal_set_ways(), geos_set_ways(), boost_set_ways()}) {
    for (const SetWay& way : library) {
      made.peers.push_back(entry_by_input(std::string(way.library), std::string(way.method), inputs->size(),
                                          [=](std::size_t k) { return way.make((*inputs)[k], question); }));
    }
  }
  return made;
}

Plan plan(const std::string& question, SetFamily family, SetKind kind, SetQuestion asked, const Demand& demand,
          bool transcript = false) {
  return {std::string(name_of(family)), question, demand, kSizes, [=](std::size_t n, std::uint64_t seed) {
            return contest(inputs_of(family, n, seed), kind, asked, transcript);
          }};
}

std::vector<Plan> plans(const Options&) {
  const Demand faster{"", {{0, 1}}};
  Demand sorting = faster, twice = faster;
  sorting.most_sorts = {{kMost, 3}};
  twice.peers = {{0, 2}};
  std::vector<Plan> list;
  const auto any = SetQuestion::any, all = SetQuestion::all;
  for (const SetFamily family :
       {SetFamily::spread_discs, SetFamily::packed_discs, SetFamily::sized_discs, SetFamily::one_disc}) {
    list.push_back(plan("circles any", family, SetKind::discs, any, sorting));
  }
  list.push_back(plan("circles proof", SetFamily::packed_discs, SetKind::discs, any, {}, true));
  list.push_back(plan("circles all", SetFamily::crowded_discs, SetKind::discs, all, faster));
  for (const SetFamily family :
       {SetFamily::coins, SetFamily::needles, SetFamily::one_in_coins, SetFamily::one_in_needles}) {
    list.push_back(plan("convex polygons any", family, SetKind::convex_polygons, any, twice));
  }
  for (const SetFamily family : {SetFamily::stars, SetFamily::tracts, SetFamily::one_in_stars, SetFamily::one_in_tracts,
                                 SetFamily::inside_star}) {
    list.push_back(plan("polygons any", family, SetKind::polygons, any, twice));
  }
  list.push_back(plan("polygons all", SetFamily::crowded_coins, SetKind::polygons, all, twice));
  const Demand a_third{"itself", {{0, 1.0 / 3}}}, a_half{"itself", {{0, 1.0 / 2}}}, a_quarter{"itself", {{0, 1.0 / 4}}};
  const Demand star{"", {}, {{0, 20}}}, petals{"", {}, {{0, 6}}};
  list.push_back({"frames", "polygons any", a_third, {1000, 10000, 100000}, [](std::size_t n, std::uint64_t) {
                    return frames_contest(n);
                  }});
  list.push_back({"many inside a star", "polygons all", star, {1000, 40000}, [](std::size_t n, std::uint64_t) {
                    return star_contest(n);
                  }});
  list.push_back(
      {"petals in one point", "polygons valid", petals, {1000, 100000, 1000000}, [](std::size_t n, std::uint64_t) {
         return petals_contest(n);
       }});
  list.push_back({"cross-hatch", "segments count", a_half, {1000, 4000}, [](std::size_t n, std::uint64_t) {
                    return net_contest(n);
                  }});
  list.push_back({"overlaps", "segments count", a_quarter, {1000, 4000}, [](std::size_t n, std::uint64_t) {
                    return overlaps_contest(n);
                  }});
  return list;
}

}  // namespace
}  // namespace bench

int main(int argc, char** argv) {
  bench::Program program;
  program.name = "bench_sets";
  program.note =
      "The sort: of the 2 N ends of the objects in x, with indices; for many inside a star, of its 4 N vertices; for "
      "petals, of the 6 N ends of their edges. \"itself\": Sunder with nothing allowed, where touching is; without "
      "nets; of as many crossings, where these are overlaps.";
  program.libraries = {"cgal", "geos", "boost", "itself"};
  program.questions = {"circles", "circles any", "circles all", "convex", "polygons", "segments"};
  program.plans = bench::plans;
  return bench::run(program, argc, argv);
}
