// bench_polytopes: do two polytopes of four dimensions meet, and are points in a hull? The times of Sunder's front
// doors, evidence in exact numbers included; bench/polytopes.py runs it, and asks HiGHS and SciPy about the same
// inputs.
//
//   bench_polytopes [--write FILE]
//
// Writes what it asks about, and its answers, to the file: doubles of this machine, in the order in which the script
// reads them. Inputs are points on spheres: pairs whose gap, or depth, is some part of their size, from seeds that are
// fixed. Times are medians over rounds of the mean of a call, of processor time.
#include <sunder/base/random.h>
#include <sunder/polytope/pair/polytope_point.h>
#include <sunder/polytope/pair/polytope_polytope.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <ctime>
#include <fstream>
#include <string>
#include <utility>
#include <vector>

namespace {

using sunder::Random;
using namespace sunder::polytope;

constexpr std::size_t kDimension = 4, kPoints = 1000, kPairs = 32, kHull = 10000, kAsked = 2000;
constexpr int kRounds = 9;

double seconds() {
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

double normal(Random& random) {
  return std::sqrt(-2 * std::log(1 - random.unit())) * std::cos(6.283185307179586 * random.unit());
}

std::vector<double> on_sphere(Random& random, std::size_t count, const std::vector<double>& centre) {
  std::vector<double> rows;
  for (std::size_t k = 0; k < count; ++k) {
    std::vector<double> p(kDimension);
    double square = 0;
    for (double& x : p) {
      x = normal(random);
      square += x * x;
    }
    for (std::size_t c = 0; c < kDimension; ++c) rows.push_back(centre[c] + p[c] / std::sqrt(square));
  }
  return rows;
}

template <class Call>
double microseconds(std::size_t calls, const Call& call) {
  std::vector<double> times;
  for (int round = 0; round < kRounds; ++round) {
    const double begin = seconds();
    call();
    times.push_back((seconds() - begin) * 1e6 / static_cast<double>(calls));
  }
  std::sort(times.begin(), times.end());
  return times[times.size() / 2];
}

void write(std::ofstream& file, const std::vector<double>& numbers) {
  const double count = static_cast<double>(numbers.size());
  file.write(reinterpret_cast<const char*>(&count), sizeof count);
  file.write(reinterpret_cast<const char*>(numbers.data()),
             static_cast<std::streamsize>(numbers.size() * sizeof(double)));
}

struct Pair {
  std::vector<double> rows_a, rows_b;
  Polytope a, b;
};

// Centres are so far apart along a random direction: 2 is about where the bodies touch.
std::vector<Pair> pairs_at(Random& random, double distance) {
  std::vector<Pair> pairs;
  for (std::size_t k = 0; k < kPairs; ++k) {
    std::vector<double> there = on_sphere(random, 1, std::vector<double>(kDimension));
    for (double& x : there) x *= distance;
    std::vector<double> a = on_sphere(random, kPoints, std::vector<double>(kDimension)),
                        b = on_sphere(random, kPoints, there);
    Polytope body_a = Polytope::from_points(kDimension, a), body_b = Polytope::from_points(kDimension, b);
    pairs.push_back({std::move(a), std::move(b), std::move(body_a), std::move(body_b)});
  }
  return pairs;
}

// B shares a point of A and lies on the other side of the plane x1 = 1.
std::vector<Pair> touching_pairs(Random& random) {
  std::vector<Pair> pairs = pairs_at(random, 0);
  for (Pair& pair : pairs) {
    for (std::size_t k = 0; k < kPoints; ++k) {
      double &x = pair.rows_a[k * kDimension], &y = pair.rows_b[k * kDimension];
      x = 1 - std::fabs(x);
      y = 1 + std::fabs(y);
    }
    pair.rows_a[0] = 1;
    std::copy_n(pair.rows_a.begin(), kDimension, pair.rows_b.begin());
    pair.a = Polytope::from_points(kDimension, pair.rows_a);
    pair.b = Polytope::from_points(kDimension, pair.rows_b);
  }
  return pairs;
}

}  // namespace

int main(int count, char** words) {
  std::ofstream file;
  if (count == 3 && std::string(words[1]) == "--write") file.open(words[2], std::ios::binary);
  Random random(20261126);
  const Pose here(kDimension);
  std::printf("pairs of %zu points, d = %zu: microseconds a call; with exact evidence\n", kPoints, kDimension);
  const std::vector<std::pair<const char*, std::vector<Pair>>> regimes{{"far apart", pairs_at(random, 4)},
                                                                       {"near", pairs_at(random, 1.95)},
                                                                       {"meet", pairs_at(random, 1.2)},
                                                                       {"touching", touching_pairs(random)}};
  for (const auto& [name, pairs] : regimes) {
    std::vector<double> answers(pairs.size());
    int finished = 0;
    const double plain = microseconds(pairs.size(), [&] {
      finished = 0;
      for (std::size_t k = 0; k < pairs.size(); ++k) {
        const PolytopeAnswer answer = polytope_polytope(pairs[k].a, here, pairs[k].b, here);
        answers[k] = answer.meet() ? 1 : 0;
        finished += answer.decided_by == sunder::DecidedBy::finishing;
      }
    });
    std::size_t proved = 0;
    const double with_evidence = microseconds(pairs.size(), [&] {
      for (const Pair& pair : pairs) {
        const PolytopeAnswer answer = polytope_polytope(pair.a, here, pair.b, here);
        proved += exact_evidence(pair.a, here, pair.b, here, answer).numbers.size();
      }
    });
    if (proved == 0) return 3;
    const double meets = static_cast<double>(std::count(answers.begin(), answers.end(), 1));
    std::printf("%-10s %10.2f %10.2f   %2.0f of %zu meet, %d finished\n", name, plain, with_evidence, meets,
                pairs.size(), finished);
    if (!file.is_open()) continue;
    write(file, {plain, with_evidence});
    write(file, answers);
    for (const Pair& pair : pairs) {
      write(file, pair.rows_a);
      write(file, pair.rows_b);
    }
  }
  const std::vector<double> rows = on_sphere(random, kHull, std::vector<double>(kDimension));
  const Polytope hull = Polytope::from_points(kDimension, rows);
  std::vector<double> points;  // from the middle to a little outside
  for (std::size_t k = 0; k < kAsked; ++k) {
    const double scale = std::sqrt(random.uniform(0, 1.2));
    for (const double x : on_sphere(random, 1, std::vector<double>(kDimension))) points.push_back(scale * x);
  }
  std::vector<double> inside(kAsked);
  const double many = microseconds(kAsked, [&] {
    const std::vector<PolytopeAnswer> answers = polytope_points(hull, points);
    for (std::size_t k = 0; k < kAsked; ++k) inside[k] = answers[k].meet() ? 1 : 0;
  });
  std::printf("points in a hull of %zu points: %.2f microseconds a point; %ld of %zu are in it\n", kHull, many,
              static_cast<long>(std::count(inside.begin(), inside.end(), 1)), kAsked);
  if (file.is_open()) {
    write(file, {many});
    write(file, inside);
    write(file, rows);
    write(file, points);
  }
  return 0;
}
