// bench_drums: what Theorem 13 of Chazelle and Dobkin 1987 costs, two polyhedra by their drums, against the scan of all
// vertices: the same pairs in one run, asked in turns, one by one. Told are the median and the 99th percentile of the
// questions' times (processor time, the least of three), and how many the exact method finished. Random pairs are far
// apart, or deep in each other; near ones apart or in each other by 1e-6 to 1e-3; last-bit ones touch exactly, and one
// is moved by one unit in the last place. What drums are made of is made before.
//
//   bench_drums [--quick] [--check]   (other options are those of other benchmarks, and change nothing)
// --check: exit code 1 where what is demanded does not hold.
#include <bench/contest/clock.h>
#include <bench/contest/contest.h>
#include <bench/inputs/body_scenarios.h>

#include <sunder/solid/pair/polyhedron_polyhedron.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <string_view>
#include <vector>

namespace bench {
namespace {

using sunder::DecidedBy;
using sunder::PairAnswer;
using sunder::solid::ConvexPolyhedron;
using sunder::solid::Pose;

// The median of random and near pairs: faster than the scan from here on, and so many times at the greatest size.
constexpr std::size_t kFasterFrom = 4000, kGreatest = 100000;
constexpr double kFaster = 1, kFasterAtGreatest = 10;
// The 99th percentile of last-bit pairs, as a multiple of the scan's: at most so much at 10,000, and at 100,000.
constexpr std::size_t kTailFrom = 10000;
constexpr double kTail = 3, kTailAtGreatest = 1;

struct Times {
  std::vector<double> seconds;
  std::size_t finished = 0;
  double probes = 0;

  double at(double part) {
    std::sort(seconds.begin(), seconds.end());
    const auto k = static_cast<std::size_t>(std::ceil(part * static_cast<double>(seconds.size())));
    return seconds[std::max<std::size_t>(k, 1) - 1];
  }
};

struct Measured {
  Times drums, scan;
  std::size_t wrong = 0;

  void add(const Scenario& scenario, std::size_t repeats) {
    std::vector<ConvexPolyhedron> bodies;
    for (const Body& body : scenario.pool) {
      std::vector<sunder::Point3> points;
      for (const Vec& p : body.points) points.push_back({p[0], p[1], p[2]});
      bodies.emplace_back(points);
    }
    for (const Query& query : scenario.queries) {
      const ConvexPolyhedron &a = bodies[query.a], &b = bodies[query.b];
      const Pose pose_a = Pose::from_matrix(query.pose_a.linear, query.pose_a.translation);
      const Pose pose_b = Pose::from_matrix(query.pose_b.linear, query.pose_b.translation);
      (void)polyhedron_polyhedron_by_drums(a, Pose(), b, Pose());  // makes what drums are made of
      const auto time = [&](Times& times, const auto& method, std::size_t rounds) {
        double least = HUGE_VAL;
        PairAnswer answer;
        for (std::size_t k = 0; k < rounds; ++k) {
          const double begin = thread_seconds();
          answer = method(a, pose_a, b, pose_b);
          least = std::min(least, thread_seconds() - begin);
        }
        times.seconds.push_back(least);
        times.finished += answer.decided_by == DecidedBy::finishing ? 1 : 0;
        times.probes += static_cast<double>(answer.cost.probes);
        return answer.meet();
      };
      const bool by_drums = time(drums, sunder::solid::polyhedron_polyhedron_by_drums, repeats);
      const bool by_scan = time(scan, sunder::solid::polyhedron_polyhedron_by_scan, repeats);
      if (by_drums != by_scan) ++wrong;
    }
  }
};

struct Kind {
  std::string_view name;
  std::vector<Regime> regimes;
};

int run(bool quick, bool check) {
  const std::vector<Kind> kinds{
      {"random", {Regime::far, Regime::deep}}, {"near", {Regime::near}}, {"last bit", {Regime::last_bit}}};
  std::vector<std::size_t> sizes{100, 1000, 4000, 10000};
  if (!quick) sizes.push_back(kGreatest);
  bool holds = true;
  std::printf("%-9s %7s %6s | %12s %12s %7s | %12s %12s %7s | %9s %9s | %7s %9s\n", "pairs", "N", "asked", "drums us",
              "scan us", "times", "99 % drums", "99 % scan", "times", "finished", "probes", "wrong", "demanded");
  for (const Kind& kind : kinds) {
    for (const std::size_t n : sizes) {
      Measured measured;
      const std::size_t asked = (n >= kGreatest ? 100 : 400) / kind.regimes.size();
      for (const Regime regime : kind.regimes) {
        measured.add(make_scenario(n, regime, n >= kGreatest ? 2 : 4, asked, n), n >= kGreatest ? 1 : 3);
      }
      Times &drums = measured.drums, &scan = measured.scan;
      const double median = scan.at(0.5) / drums.at(0.5), tail = drums.at(0.99) / scan.at(0.99);
      const bool is_tail = kind.name == "last bit";
      bool row_holds = measured.wrong == 0;
      if (is_tail) {
        if (n >= kTailFrom) row_holds = row_holds && tail <= (n >= kGreatest ? kTailAtGreatest : kTail);
      } else if (n >= kFasterFrom) {
        row_holds = row_holds && median >= (n >= kGreatest ? kFasterAtGreatest : kFaster);
      }
      holds = holds && row_holds;
      std::printf("%-9s %7zu %6zu | %12.1f %12.1f %7.2f | %12.1f %12.1f %7.2f | %7.2f %% %9.0f | %7zu %9s\n",
                  kind.name.data(), n, drums.seconds.size(), 1e6 * drums.at(0.5), 1e6 * scan.at(0.5), median,
                  1e6 * drums.at(0.99), 1e6 * scan.at(0.99), tail,
                  100 * static_cast<double>(drums.finished) / static_cast<double>(drums.seconds.size()),
                  drums.probes / static_cast<double>(drums.seconds.size()), measured.wrong, row_holds ? "yes" : "NO");
      std::fflush(stdout);
    }
  }
  std::printf("times: of medians, the scan's over drums'; of 99th percentiles, drums' over the scan's\n");
  return check && !holds ? 1 : 0;
}

}  // namespace
}  // namespace bench

int main(int argc, char** argv) {
  const std::vector<std::string_view> options(argv + 1, argv + argc);
  const auto has = [&](std::string_view option) {
    return std::find(options.begin(), options.end(), option) != options.end();
  };
  return bench::run(has("--quick"), has("--check"));
}
