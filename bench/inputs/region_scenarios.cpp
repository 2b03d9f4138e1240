#include <bench/inputs/region_count.h>
#include <bench/inputs/region_scenarios.h>

#include <tests/support/shapes.h>

#include <sunder/base/random.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>

namespace bench {
namespace {

using sunder::Random;
using sunder::tests::jittered_angles;
using sunder::tests::shuffle;
namespace tests = sunder::tests;

constexpr double kPi = 3.141592653589793;
constexpr std::size_t kVertices = 16;   // of a polygon
constexpr std::size_t kEnough = 20000;  // objects in all inputs of a family and size together
constexpr std::size_t kMostInputs = 64;

double snapped(double v, int bits = 40) { return tests::snapped(v, bits); }

Inequality half_plane(double angle, double distance) {
  return {snapped(std::cos(angle)), snapped(std::sin(angle)), snapped(distance)};
}

std::vector<Inequality> tangents(std::size_t n, Random& random) {
  std::vector<Inequality> list;
  for (const double angle : jittered_angles(n, 0.2, random)) list.push_back(half_plane(angle, 1));
  return list;
}

std::vector<Inequality> random_half_planes(std::size_t n, Random& random) {
  std::vector<Inequality> list;
  for (const double angle : jittered_angles(4, 0.2, random))
    list.push_back(half_plane(angle, random.uniform(1, 2)));  // bounded
  while (list.size() < n) {
    const double angle = random.uniform(0, 2 * kPi);
    list.push_back(half_plane(angle, random.uniform(1, 2)));
  }
  return list;
}

std::vector<Inequality> parallels(std::size_t n, Random& random) {
  std::vector<Inequality> list = tangents(n / 2, random);
  for (std::size_t k = 0; k < n / 2; ++k) {
    Inequality beside = list[k];
    beside.c = snapped(random.uniform(1.001, 2));
    list.push_back(beside);
  }
  return list;
}

// Rounded to a coarser grid.
Xy at_angle(double angle, double radius) {
  return {snapped(radius * std::cos(angle), 26), snapped(radius * std::sin(angle), 26)};
}

Ring ring_around(Random& random) {
  const std::vector<double> normals = jittered_angles(kVertices, 0.2, random);
  Ring ring;
  for (std::size_t k = 0; k < kVertices; ++k) {
    const double wrap = k + 1 == kVertices ? 2 * kPi : 0, next = normals[(k + 1) % kVertices] + wrap;
    ring.push_back(at_angle((normals[k] + next) / 2, 1 / std::cos((next - normals[k]) / 2)));
  }
  return ring;
}

Ring random_ring(Random& random) {
  const double radius = random.uniform(1, 1.5);
  const double direction = random.uniform(0, 2 * kPi), distance = random.uniform(0, 0.4);
  const Xy middle = at_angle(direction, distance);
  Ring ring;
  for (const double angle : jittered_angles(kVertices, 0.2, random)) {
    const Xy p = at_angle(angle, radius);
    ring.push_back({middle.x + p.x, middle.y + p.y});
  }
  return ring;
}

std::vector<Disc> discs_around(std::size_t n, Random& random) {
  std::vector<Disc> list;
  for (const double angle : jittered_angles(n, 0.2, random)) {
    list.push_back({{snapped(std::cos(angle) / 2), snapped(std::sin(angle) / 2)}, 1});
  }
  return list;
}

std::vector<Disc> random_discs(std::size_t n, Random& random) {
  std::vector<Disc> list;
  for (std::size_t i = 0; i < n; ++i) {
    const double angle = random.uniform(0, 2 * kPi), distance = std::sqrt(random.unit()) / 2;
    const double radius = random.uniform(1, 1.5);
    list.push_back({{snapped(distance * std::cos(angle)), snapped(distance * std::sin(angle))}, snapped(radius)});
  }
  return list;
}

RegionInput make_input(RegionFamily family, std::size_t n, Random& random) {
  RegionInput input;
  switch (family) {
    case RegionFamily::tangents: input.half_planes = tangents(n, random); break;
    case RegionFamily::random: input.half_planes = random_half_planes(n, random); break;
    case RegionFamily::parallels: input.half_planes = parallels(n, random); break;
    case RegionFamily::polygons_around:
      for (std::size_t i = 0; i < n; ++i) input.rings.push_back(ring_around(random));
      break;
    case RegionFamily::polygons:
      for (std::size_t i = 0; i < n; ++i) input.rings.push_back(random_ring(random));
      break;
    case RegionFamily::discs_around: input.discs = discs_around(n, random); break;
    case RegionFamily::discs: input.discs = random_discs(n, random); break;
  }
  shuffle(input.half_planes, random);
  shuffle(input.rings, random);
  shuffle(input.discs, random);
  if (!input.half_planes.empty()) input.essential = essential_sides(whole(input.half_planes));
  input.sides = input.essential.size();
  if (!input.rings.empty()) input.sides = essential_sides(whole(input.rings)).size();
  // The walk takes long where there are many arcs; of discs around, all have one: the corners of the neighbours of one
  // lie outside of it by about 1e-8 and more for 10^4 discs.
  if (!input.discs.empty()) input.sides = family == RegionFamily::discs_around ? n : count_arcs(input.discs);
  return input;
}

bool as_promised(RegionFamily family, std::uint64_t sides, std::size_t n) {
  switch (family) {
    case RegionFamily::tangents: return sides == n;
    case RegionFamily::parallels: return sides == n / 2;
    case RegionFamily::discs_around: return sides == n && n <= 10000;
    case RegionFamily::polygons_around: return sides >= n;
    default: return sides >= 3 && sides <= 1000;
  }
}

}  // namespace

std::string_view name_of(RegionFamily family) {
  constexpr std::array<std::string_view, 7> names{"tangents", "random",       "parallels", "polygons around",
                                                  "polygons", "discs around", "discs"};
  return names.at(static_cast<std::size_t>(family));
}

std::vector<RegionInput> make_region_inputs(RegionFamily family, std::size_t n, std::uint64_t seed) {
  Random random(1000 * seed + 100 + static_cast<std::uint64_t>(family));
  std::vector<RegionInput> inputs;
  const std::size_t count_of_inputs = std::clamp<std::size_t>(kEnough / n, 1, kMostInputs);
  for (std::size_t i = 0; i < count_of_inputs; ++i) {
    RegionInput& input = inputs.emplace_back(make_input(family, n, random));
    if (!as_promised(family, input.sides, n)) {
      throw std::logic_error(std::string(name_of(family)) + ", " + std::to_string(n) +
                             " objects: " + std::to_string(input.sides) + " sides, which is not what it promises");
    }
  }
  return inputs;
}

}  // namespace bench
