// bench_batch: pairs of convex bodies in one call against a loop over single calls, on one thread: of other bodies each
// time, and of one pair in many placements, as it jumps and as it moves slowly. Sunder against itself: there are no
// peers. Bodies and poses are prepared; both tell which pairs meet, and the loop makes evidence, which a batch makes
// for pairs that meet.
#include <bench/contest/clock.h>
#include <bench/inputs/body_scenarios.h>

#include <sunder/base/random.h>
#include <sunder/solid/pair/polyhedron_polyhedron.h>
#include <sunder/solid/pair/polyhedron_polyhedron_batch.h>

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <string>
#include <vector>

namespace bench {
namespace {

using sunder::solid::ConvexPolyhedron;
using sunder::solid::PlacedPair;
using sunder::solid::Pose;

struct Asked {
  std::vector<ConvexPolyhedron> bodies;
  std::vector<Pose> poses_a, poses_b;
  std::vector<std::uint32_t> a, b;  // numbers of bodies

  std::vector<PlacedPair> pairs() const {
    std::vector<PlacedPair> made;
    for (std::size_t k = 0; k < a.size(); ++k) made.push_back({&bodies[a[k]], &poses_a[k], &bodies[b[k]], &poses_b[k]});
    return made;
  }
};

Pose pose_of(const Placement& placement) { return Pose::from_matrix(placement.linear, placement.translation); }

Asked of_scenario(std::size_t n, Regime regime) {
  const Scenario scenario = make_scenario(n, regime, 16, 1024, 7);
  Asked asked;
  for (const Body& body : scenario.pool) {
    std::vector<sunder::Point3> points;
    for (const Vec& p : body.points) points.push_back({p[0], p[1], p[2]});
    asked.bodies.emplace_back(points);
  }
  for (const Query& query : scenario.queries) {
    asked.a.push_back(query.a), asked.b.push_back(query.b);
    asked.poses_a.push_back(pose_of(query.pose_a)), asked.poses_b.push_back(pose_of(query.pose_b));
  }
  return asked;
}

// The same placements, all of two bodies.
Asked of_one_pair(Asked asked) {
  std::fill(asked.a.begin(), asked.a.end(), 0);
  std::fill(asked.b.begin(), asked.b.end(), 1);
  return asked;
}

// Two bodies that pass each other, and turn slowly.
Asked of_slow_pair(std::size_t n) {
  Asked asked = of_one_pair(of_scenario(n, Regime::near));
  for (std::size_t k = 0; k < asked.a.size(); ++k) {
    const double t = static_cast<double>(k) / 1024;
    asked.poses_a[k] = Pose();
    asked.poses_b[k] = Pose::from_quaternion(1, t, 0.3 * t, 0, {1.98 - 0.1 * t, t - 0.5, 0.2 * t});
  }
  return asked;
}

// The median of so many rounds, in nanoseconds a pair.
template <class Ask>
double nanoseconds(std::size_t pairs, const Ask& ask) {
  std::vector<double> times;
  for (int round = 0; round < 15; ++round) {
    const double start = thread_seconds();
    for (int again = 0; again < 5; ++again) ask();
    times.push_back((thread_seconds() - start) / 5);
  }
  std::nth_element(times.begin(), times.begin() + 7, times.end());
  return 1e9 * times[7] / static_cast<double>(pairs);
}

bool compare(const std::string& name, const Asked& asked) {
  const std::vector<PlacedPair> pairs = asked.pairs();
  std::vector<std::uint8_t> by_loop(pairs.size()), by_batch(pairs.size());
  const double loop = nanoseconds(pairs.size(), [&] {
    for (std::size_t k = 0; k < pairs.size(); ++k) {
      const PlacedPair& pair = pairs[k];
      by_loop[k] = polyhedron_polyhedron(*pair.a, *pair.pose_a, *pair.b, *pair.pose_b).meet();
    }
  });
  const double batch = nanoseconds(pairs.size(), [&] { polyhedron_polyhedron_batch(pairs, by_batch); });
  const auto meeting = std::count(by_loop.begin(), by_loop.end(), 1);
  std::printf("%-34s %5.1f %% meet: loop %7.1f ns, batch %7.1f ns: %.2f times as fast%s\n", name.c_str(),
              100 * static_cast<double>(meeting) / static_cast<double>(pairs.size()), loop, batch, loop / batch,
              by_loop == by_batch ? "" : "; the verdicts DIFFER");
  return by_loop == by_batch;
}

int run() {
  bool agree = true;
  for (const std::size_t n : {8, 30, 100, 1000}) {
    for (const Regime regime : {Regime::far, Regime::near, Regime::deep}) {
      const std::string name = std::to_string(n) + " vertices, " + std::string(name_of(regime));
      const Asked asked = of_scenario(n, regime);
      agree &= compare(name + ", other bodies", asked);
      agree &= compare(name + ", one pair", of_one_pair(asked));
    }
    agree &= compare(std::to_string(n) + " vertices, one slow pair", of_slow_pair(n));
  }
  return agree ? 0 : 1;
}

}  // namespace
}  // namespace bench

int main() { return bench::run(); }
