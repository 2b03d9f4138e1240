// A bare loop over many posed pairs, for python/tests/test_speed.py to compare with: reads numbers, prints what a pair
// takes.
//
//   posed_pairs FILE REPEATS
// FILE: raw doubles: the number of bodies; of each the number of points and their coordinates; then for each pair the
// numbers of two bodies and two poses of 3 rows of 4 numbers.
// Prints: how many meet, and the nanoseconds a pair of the fastest repeat, poses made in the loop, and made before.
#include <sunder/solid/pair/polyhedron_polyhedron.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <vector>

namespace {

using sunder::solid::ConvexPolyhedron;
using sunder::solid::Pose;
using Clock = std::chrono::steady_clock;

struct Pair {
  std::size_t a, b;
  const double *pose_a, *pose_b;
};

Pose pose_of(const double* m) {
  return Pose::from_matrix({m[0], m[1], m[2], m[4], m[5], m[6], m[8], m[9], m[10]}, {m[3], m[7], m[11]});
}

template <class Work>
double nanoseconds(int repeats, std::size_t pairs, const Work& work) {
  double best = 1e300;
  for (int k = 0; k < repeats; ++k) {
    const auto start = Clock::now();
    work();
    best = std::min(best, std::chrono::duration<double, std::nano>(Clock::now() - start).count());
  }
  return best / static_cast<double>(pairs);
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3) return 2;
  std::ifstream file(argv[1], std::ios::binary);
  std::vector<double> numbers;
  for (double x = 0; file.read(reinterpret_cast<char*>(&x), sizeof x);) numbers.push_back(x);
  std::size_t at = 0;
  const auto count = [&] { return static_cast<std::size_t>(numbers.at(at++)); };
  std::vector<ConvexPolyhedron> bodies;
  for (std::size_t n = count(); bodies.size() < n;) {
    std::vector<sunder::Point3> points(count());
    for (sunder::Point3& p : points) {
      p = {numbers.at(at), numbers.at(at + 1), numbers.at(at + 2)};
      at += 3;
    }
    bodies.emplace_back(points);
  }
  std::vector<Pair> pairs;
  while (at < numbers.size()) {
    const std::size_t a = count(), b = count();
    pairs.push_back({a, b, &numbers[at], &numbers[at + 12]});
    at += 24;
  }
  std::vector<std::array<Pose, 2>> poses;
  for (const Pair& pair : pairs) poses.push_back({pose_of(pair.pose_a), pose_of(pair.pose_b)});

  const int repeats = std::atoi(argv[2]);
  std::vector<char> meet(pairs.size());
  const double made_in_loop = nanoseconds(repeats, pairs.size(), [&] {
    for (std::size_t k = 0; k < pairs.size(); ++k) {
      const Pair& p = pairs[k];
      meet[k] = sunder::intersect(bodies[p.a], pose_of(p.pose_a), bodies[p.b], pose_of(p.pose_b)).meet();
    }
  });
  const double made_before = nanoseconds(repeats, pairs.size(), [&] {
    for (std::size_t k = 0; k < pairs.size(); ++k) {
      meet[k] = sunder::intersect(bodies[pairs[k].a], poses[k][0], bodies[pairs[k].b], poses[k][1]).meet();
    }
  });
  std::cout << std::count(meet.begin(), meet.end(), 1) << ' ' << made_in_loop << ' ' << made_before << '\n';
}
