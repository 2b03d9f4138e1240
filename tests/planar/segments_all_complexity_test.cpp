// How the number of comparisons of Balaban's method grows: at most 14 (N log2 N + k), from 2^6 segments on, on sets
// with few and with many contacts. (Found by trial: below 11. By the argument in segments_all_by_balaban.cpp it is
// bounded for all N.)
#include <sunder/base/random.h>
#include <sunder/planar/segments/segments_all.h>

#include <tests/support/shapes.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <functional>
#include <numbers>
#include <string_view>
#include <vector>

namespace sunder::tests::segments_all {
namespace {

using planar::Segment;
using planar::Segments;
using planar::SegmentsContact;

constexpr double most_probes = 14;  // over N log2 N + k

// Long spikes around a small circle; each tip is so far off its place that it crosses some neighbours.
std::vector<Segment> star(std::size_t n, Random& random) {
  const auto at = [&](double turn, double radius) { return on_circle(turn / static_cast<double>(n), radius); };
  std::vector<Point2> vertices;
  for (std::size_t k = 0; k < n; ++k) {
    const double turn = static_cast<double>(k);
    vertices.push_back(k % 2 == 0 ? at(turn, 10) : at(turn + random.uniform(-4.9, 4.9), 1000));
  }
  std::vector<Segment> segments;
  for (std::size_t k = 0; k < n; ++k) segments.push_back({vertices[k], vertices[(k + 1) % n]});
  return segments;
}

std::vector<Segment> random_long(std::size_t n, Random& random) {
  std::vector<Segment> segments;
  for (std::size_t k = 0; k < n; ++k) {
    segments.push_back({{random.unit(), random.unit()}, {random.unit(), random.unit()}});
  }
  return segments;
}

// Parallels, as many of each length as of any other: many strips with large staircases, in which all ends are to be
// found. A binary search in each would take log N times as long.
std::vector<Segment> brush(std::size_t n, Random& random) {
  const std::size_t lengths = static_cast<std::size_t>(std::log2(static_cast<double>(n))) / 2;
  std::vector<Segment> segments;
  for (std::size_t k = 0; k < n; ++k) {
    const double length = std::ldexp(1, -static_cast<int>(k % lengths));
    const double x = length * std::floor(random.unit() / length) + length * 0.01 * random.unit();
    const double y = random.unit();
    segments.push_back({{x, y}, {x + length * 0.98, y}});
  }
  return segments;
}

// On one line.
std::vector<Segment> overlaps(std::size_t n, Random& random) {
  std::vector<Segment> segments;
  for (std::size_t k = 0; k < n; ++k) segments.push_back({{random.unit(), 0}, {random.unit(), 0}});
  return segments;
}

// Through one point, in pairs on one line, half of them ending there.
std::vector<Segment> bundle(std::size_t n, Random&) {
  std::vector<Segment> segments;
  for (std::size_t k = 0; k < n; ++k) {
    const double x = static_cast<double>(k / 4 + 1), y = static_cast<double>(n);
    segments.push_back(k % 4 < 2 ? Segment{{-x, -y}, {x, y}} : Segment{{0, 0}, {2 * x, k % 4 == 2 ? 2 * y : -2 * y}});
  }
  return segments;
}

// The lattice with each line cut to eight that overlap in its middle; many ends besides, on lines and off.
std::vector<Segment> doubled_lattice(std::size_t n, Random& random) {
  std::vector<Segment> segments;
  const double side = static_cast<double>(n / 32);
  for (std::size_t k = 0; k < n; ++k) {
    const double at = static_cast<double>(k / 32), from = -1 - static_cast<double>(random.below(8)) / 4;
    const double end = side + static_cast<double>(random.below(8)) / 4;
    switch (k % 4) {
      case 0: segments.push_back({{from, at}, {end, at}}); break;
      case 1: segments.push_back({{at, from}, {at, end}}); break;
      case 2: segments.push_back({{random.unit() * side, at + 0.5}, {random.unit() * side, at + 0.5}}); break;
      default: segments.push_back({{random.unit() * side, at}, {random.unit() * side, at}});
    }
  }
  return segments;
}

struct Family {
  std::string_view name;
  std::function<std::vector<Segment>(std::size_t, Random&)> make;
  int last;  // the largest set is of about 2^last
};

TEST(SegmentsAllComplexity, BalabanIsOptimal) {
  std::printf("%-12s %8s %10s %12s %8s\n", "family", "N", "k", "probes", "ratio");
  for (const Family& family :
       {Family{"mesh", mesh_edges, 16}, Family{"star", star, 16}, Family{"brush", brush, 16},
        Family{"lattice", [](std::size_t n, Random&) { return hatch(n); }, 12}, Family{"random long", random_long, 11},
        Family{"overlaps", overlaps, 10}, Family{"bundle", bundle, 10}, Family{"doubled", doubled_lattice, 12}}) {
    for (int power = 6; power <= family.last; ++power) {
      Random random(20261127);
      const Segments segments(family.make(std::size_t{1} << power, random));
      double k = 0;
      const Cost cost = planar::segments_all_by_balaban(segments, {}, [&](const SegmentsContact&) {
        ++k;
        return true;
      });
      const double n = segments.size();
      const double ratio = static_cast<double>(cost.probes) / (n * std::log2(n) + k);
      std::printf("%-12s %8.0f %10.0f %12.0f %8.2f\n", std::string(family.name).c_str(), n, k,
                  static_cast<double>(cost.probes), ratio);
      EXPECT_LT(ratio, most_probes) << family.name << " " << n;
    }
  }
}

}  // namespace
}  // namespace sunder::tests::segments_all
