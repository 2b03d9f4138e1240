// bench_polytopes: do two polytopes of four dimensions meet, and are points in a hull? The times of Sunder's front
// doors, evidence in exact numbers included; bench/polytopes.py runs it, and asks HiGHS and SciPy about the same
// inputs.
//
//   bench_polytopes [--write FILE | --trees]
//
// With --trees: what hierarchical trees take and cost, in counts, for docs/design/polytope.md.
//
// Writes what it asks about, and its answers, to the file: doubles of this machine, in the order in which the script
// reads them. Inputs are points on spheres: pairs whose gap, or depth, is some part of their size, from seeds that are
// fixed. Times are medians over rounds of the mean of a call, of processor time.
#include <sunder/base/random.h>
#include <sunder/polytope/pair/polytope_point.h>
#include <sunder/polytope/pair/polytope_polytope.h>
#include <sunder/polytope/represent/normal_fan.h>

#include <algorithm>
#include <array>
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

std::vector<double> sphere_of(Random& random, std::size_t d, std::size_t count, double shift) {
  std::vector<double> rows;
  for (std::size_t k = 0; k < count; ++k) {
    std::vector<double> p(d);
    double square = 0;
    for (double& x : p) {
      x = normal(random);
      square += x * x;
    }
    for (std::size_t c = 0; c < d; ++c) rows.push_back(p[c] / std::sqrt(square) + (c == 0 ? shift : 0));
  }
  return rows;
}

// The least r with floor(d/2) log(r log r) / log r <= exponent: the paper's recurrence with C = 1.
double logarithm_of_r(double half, double exponent) {
  double low = 1, high = 1e6;  // of log r: log log r / log r falls from e on
  for (int k = 0; k < 100; ++k) {
    const double mid = (low + high) / 2;
    (half * (1 + std::log(mid) / mid) > exponent && mid < 1e6 ? low : high) = mid;
  }
  return high;
}

// What the paper's own lists would take at one level: simplices of the body from its first vertex to each facet, those
// with a vertex out of a cone's shell-simplex, for all cones. Over the number of facets.
double faces_listed(Random& random, std::size_t d, std::size_t count, std::size_t net) {
  const std::vector<double> rows = sphere_of(random, d, count, 0);
  const auto body = normal_fan(d, rows);
  const auto fan =
      normal_fan(d, std::vector<double>(rows.begin(), rows.begin() + static_cast<std::ptrdiff_t>(net * d)));
  if (!body || !fan) return 0;
  std::size_t listed = 0;
  std::vector<bool> is_out(count);
  for (const NormalFan::Cone& cone : fan->cones) {
    for (std::size_t k = 0; k < count; ++k) {
      is_out[k] = false;
      for (std::size_t i = 0; i < d && !is_out[k]; ++i) {
        double sum = 0;
        for (std::size_t c = 0; c < d; ++c) {
          sum += fan->ray(cone.rays[i])[c] * (rows[k * d + c] - rows[cone.apex * d + c]);
        }
        is_out[k] = sum > 1e-12;
      }
    }
    for (const NormalFan::Numbers& facet : body->facets) {
      listed += is_out[0] || std::any_of(facet.begin(), facet.begin() + static_cast<std::ptrdiff_t>(d),
                                         [&](std::uint32_t k) { return is_out[k] ? true : false; });
    }
  }
  return static_cast<double>(listed) / static_cast<double>(body->facets.size());
}

void print_trees() {
  std::printf("| d | n | depth | nodes | cones | rows of nodes | memory | looks a pair | scan's | front door's |\n");
  std::printf("|---|---|---|---|---|---|---|---|---|---|\n");
  const std::vector<std::pair<std::size_t, std::vector<std::size_t>>> plan{
      {2, {100, 1000, 10000}}, {3, {100, 1000, 10000}}, {4, {100, 300, 1000}}, {5, {60}}, {6, {60}}};
  for (const auto& [d, counts] : plan) {
    std::vector<double> x, y;
    for (const std::size_t n : counts) {
      Random random(d * 1000 + n);
      const Pose here(d);
      double looks = 0, scan = 0, front = 0;
      const int pairs = n > 300 ? 3 : 8;
      for (int k = 0; k < pairs; ++k) {
        const HierarchicalTree a(Polytope::from_points(d, sphere_of(random, d, n, 0)));
        const HierarchicalTree b(Polytope::from_points(d, sphere_of(random, d, n, 0.7 + 1.8 * k / (pairs - 1))));
        looks += static_cast<double>(polytope_polytope_by_tree(a, here, b, here).cost.probes) / pairs;
        front += static_cast<double>(polytope_polytope(a.body(), here, b.body(), here).cost.probes) / pairs;
        if (n <= 300) {
          scan += static_cast<double>(polytope_polytope_by_scan(a.body(), here, b.body(), here).cost.probes) / pairs;
        }
        if (k > 0) continue;
        std::printf("| %zu | %zu | %u | %zu | %zu | %zu | %zu KiB |", d, n, a.depth(), a.node_count(), a.cone_count(),
                    a.row_count(), (a.memory() + 1023) >> 10);
        x.push_back(std::log(static_cast<double>(n)));
        y.push_back(std::log(static_cast<double>(a.memory())));
        if (a.unverified() > 0) std::fprintf(stderr, "%zu cones are not verified\n", a.unverified());
      }
      std::printf(" %.0f | %s | %.0f |\n", looks, n <= 300 ? std::to_string(std::lround(scan)).c_str() : "-", front);
      std::fflush(stdout);
    }
    if (x.size() < 2) continue;
    const double exponent = (y.back() - y.front()) / (x.back() - x.front()), half = static_cast<double>(d / 2);
    std::printf("d = %zu: memory grows as n^%.2f; the paper: n^(%.0f + delta), delta = %.2f", d, exponent, half,
                exponent - half);
    if (exponent <= half) {
      std::printf(", less than any r gives\n");
    } else if (exponent >= half * (1 + std::exp(-1.0))) {
      std::printf(", what r of any size gives\n");
    } else {
      std::printf(", which takes r = e^%.0f\n", logarithm_of_r(half, exponent));
    }
  }
  Random random(20150618);
  for (const auto& [d, n, net] : {std::array<std::size_t, 3>{3, 100, 16}, {4, 100, 32}, {4, 100, 16}, {5, 60, 16}}) {
    std::printf("the paper's lists of faces, one level: d = %zu, n = %zu, a net of %zu: %.0f times the facets\n", d, n,
                net, faces_listed(random, d, n, net));
  }
}

}  // namespace

int main(int count, char** words) {
  if (count == 2 && std::string(words[1]) == "--trees") {
    print_trees();
    return 0;
  }
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
