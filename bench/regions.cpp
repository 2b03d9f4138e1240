// bench_regions: what is the common part of N half-planes, of N convex polygons, of N discs? What is its best point?
// Against CGAL, and against sorting.
//
// The yardstick is std::sort: for common parts, of the angles of all half-planes, edges or centres, as doubles with
// their indices; for linear programs, of 2 N doubles. Only ratios mean anything.
//
// Fairness:
//   - All contestants answer the same inputs in one run, in rounds, and take turns in going first. The time of a
//     contestant is the median over its rounds of its mean per call, in processor time of its thread, one thread each.
//     Whoever takes long takes part in fewer rounds, at least three, and answers fewer of the inputs.
//   - Each library may prepare objects of its own outside of the loop. For "next objective" Sunder prepares the region.
//   - CGAL is asked by every way that it offers (see peers/region_peer.h); the fastest that is right on all inputs of
//     the row counts. Where none is right the fastest wrong one is shown with "!", and does not count. CGAL cannot
//     intersect half-planes in the plane. Its convex hulls of polar points, which have to be told a point inside, are
//     shown as "hull", and nothing is demanded of that.
//   - A way that takes more than 3 s for one call, or by its growth would take twice that, is left out. In the check it
//     counts with the time of that one call, or the one that its growth (linear at least) predicts.
//   - Small sizes rotate over many inputs, and new objectives over 1,000, so that no branch predictor learns one by
//     heart.
//   - What is true of each input is counted apart, in integers, or known by construction (region_count.h).
#include <bench/contest/program.h>
#include <bench/inputs/region_scenarios.h>
#include <bench/peers/sunder_regions.h>

#include <sunder/base/random.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace bench {
namespace {

constexpr std::size_t kObjectives = 1000;

using Inputs = std::shared_ptr<const std::vector<RegionInput>>;

Inputs inputs_of(RegionFamily family, std::size_t n, std::uint64_t seed) {
  return std::make_shared<const std::vector<RegionInput>>(make_region_inputs(family, n, seed));
}

std::vector<double> angles_of(const RegionInput& input) {
  std::vector<double> angles;
  for (const Inequality& h : input.half_planes) angles.push_back(std::atan2(h.b, h.a));
  for (const Disc& d : input.discs) angles.push_back(std::atan2(d.center.y, d.center.x));
  for (const Ring& ring : input.rings) {
    for (std::size_t v = 0; v < ring.size(); ++v) {
      const Xy &p = ring[v], &q = ring[v + 1 == ring.size() ? 0 : v + 1];
      angles.push_back(std::atan2(q.y - p.y, q.x - p.x));
    }
  }
  return angles;
}

Contest common_part(const Inputs& inputs, bool evidence) {
  Contest made;
  std::vector<std::vector<double>> angles;
  for (const RegionInput& input : *inputs) {
    made.truths.push_back(input.sides);
    angles.push_back(angles_of(input));
  }
  made.yardstick = sort_with_indices(angles);
  made.subjects = {entry_by_input("sunder", "front door", inputs->size(), [=](std::size_t k) {
    return evidence ? ask_sunder_for_evidence((*inputs)[k]) : ask_sunder((*inputs)[k]);
  })};
  if (evidence) return made;
  for (const RegionWay& way : cgal_region_ways()) {
    made.peers.push_back(entry_by_input(std::string(way.library), std::string(way.method), inputs->size(),
                                        [=](std::size_t k) { return way.make((*inputs)[k]); }));
  }
  return made;
}

// The two essential half-planes around the direction: their corner is furthest in it. Directions are not normals, and
// further from one than their angles are rounded.
std::uint64_t optimum(const RegionInput& input, const std::vector<double>& angles, const Objective& objective) {
  const double angle = std::atan2(objective.y, objective.x);
  const std::size_t size = angles.size();
  // `angles` ascend, but for one step where they wrap.
  const auto from = static_cast<std::size_t>(std::min_element(angles.begin(), angles.end()) - angles.begin());
  std::size_t low = 0, high = size;  // of the first angle that is greater, counted from `from`
  while (low < high) {
    const std::size_t middle = (low + high) / 2;
    if (angles[(from + middle) % size] > angle) {
      high = middle;
    } else {
      low = middle + 1;
    }
  }
  return pair_of(input.essential[(from + low) % size], input.essential[(from + low + size - 1) % size]);
}

std::vector<double> angles_of_sides(const RegionInput& input) {
  std::vector<double> angles;
  for (const std::uint32_t i : input.essential) {
    angles.push_back(std::atan2(input.half_planes[i].b, input.half_planes[i].a));
  }
  return angles;
}

std::vector<Objective> objectives(std::size_t count, std::uint64_t seed) {
  sunder::Random random(seed);
  std::vector<Objective> list;
  while (list.size() < count) {
    const double angle = random.uniform(-3.14159, 3.14159);
    list.push_back({std::cos(angle), std::sin(angle)});
  }
  return list;
}

std::function<double()> sort_of_numbers(const std::vector<RegionInput>& inputs) {
  std::vector<std::vector<double>> numbers;
  for (const RegionInput& input : inputs) {
    auto& of_input = numbers.emplace_back();
    for (const Inequality& h : input.half_planes) of_input.insert(of_input.end(), {h.a, h.b});
  }
  return sort_of(std::move(numbers));
}

Contest linear_program(const Inputs& inputs, std::uint64_t seed) {
  Contest made;
  made.yardstick = sort_of_numbers(*inputs);
  const std::vector<Objective> asked = objectives(inputs->size(), seed);
  for (std::size_t k = 0; k < inputs->size(); ++k) {
    const RegionInput& input = (*inputs)[k];
    made.truths.push_back(optimum(input, angles_of_sides(input), asked[k]));
  }
  made.subjects = {entry_by_input("sunder", "front door", inputs->size(),
                                  [=](std::size_t k) { return ask_sunder((*inputs)[k], asked[k]); })};
  made.peers = {entry_by_input("cgal", "solve_linear_program", inputs->size(),
                               [=](std::size_t k) { return cgal_linear_program((*inputs)[k], asked[k]); })};
  return made;
}

Contest next_objective(const Inputs& inputs, std::uint64_t seed) {
  Contest made;
  made.yardstick = sort_of_numbers(*inputs);
  made.batch = kObjectives;
  const std::vector<Objective> asked = objectives(kObjectives, seed);
  for (const RegionInput& input : *inputs) {
    const std::vector<double> angles = angles_of_sides(input);
    std::uint64_t& sum = made.truths.emplace_back(0);
    for (const Objective& objective : asked) sum += optimum(input, angles, objective);
  }
  made.subjects = {entry_by_input("sunder", "by region", inputs->size(),
                                  [=](std::size_t k) { return ask_sunder_by_region((*inputs)[k], asked); })};
  return made;
}

std::vector<Plan> plans(const Options&) {
  const std::vector<std::size_t> to_million{100, 1000, 10000, 100000, 1000000};
  const std::vector<std::size_t> to_hundred_thousand{100, 1000, 10000, 100000}, to_ten_thousand{100, 1000, 10000};
  const Demand sorting{"", {}, {{1000000, 4}}}, half_sorting{"", {}, {{1000000, 0.5}}};
  const Demand ten_times{"cgal", {{10000, 10}}}, fast{"", {}, {}, 200};
  using Family = RegionFamily;
  std::vector<Plan> list;
  const auto add_common_part = [&](const std::string& question, Family family, const std::vector<std::size_t>& sizes,
                                   const Demand& demand, bool evidence) {
    list.push_back({std::string(name_of(family)), question, demand, sizes, [=](std::size_t n, std::uint64_t seed) {
                      return common_part(inputs_of(family, n, seed), evidence);
                    }});
  };
  for (const Family family : {Family::tangents, Family::random, Family::parallels}) {
    add_common_part("half-planes", family, to_million, sorting, false);
  }
  add_common_part("half-planes, proved", Family::tangents, to_million, {}, true);
  for (const Family family : {Family::polygons_around, Family::polygons}) {
    add_common_part("convex polygons", family, to_ten_thousand, ten_times, false);
  }
  for (const Family family : {Family::discs_around, Family::discs}) {
    add_common_part("circles", family, to_ten_thousand, ten_times, false);
  }
  for (const Family family : {Family::tangents, Family::random, Family::parallels}) {
    list.push_back(
        {std::string(name_of(family)), "linear program", half_sorting, to_million,
         [=](std::size_t n, std::uint64_t seed) { return linear_program(inputs_of(family, n, seed), seed); }});
  }
  list.push_back(
      {std::string(name_of(Family::tangents)), "next objective", fast, to_hundred_thousand,
       [](std::size_t n, std::uint64_t seed) { return next_objective(inputs_of(Family::tangents, n, seed), seed); }});
  return list;
}

}  // namespace
}  // namespace bench

int main(int argc, char** argv) {
  bench::Program program;
  program.name = "bench_regions";
  program.note =
      "The sort: of the angles of half-planes, edges or centres, with indices; for linear programs of 2 N doubles.";
  program.libraries = {"cgal", "hull"};
  program.questions = {"half-planes", "convex polygons", "circles", "linear program", "next objective"};
  program.plans = bench::plans;
  return bench::run(program, argc, argv);
}
