// bench_polytope_hulls: how long does the exact hull in two to six dimensions take? Against Qhull with its options for
// triangulated output: the same points, in one run, in turns, from points in memory to facets in memory. Times are
// medians over rounds, of processor time. Sunder's hull is exact, and Qhull's is not: beside the times stand the facets
// that each has.
//
//   bench_polytope_hulls [--quick]   (other options are those of other benchmarks, and change nothing)
#include <sunder/base/random.h>
#include <sunder/polytope/hull/convex_hull.h>

#include <libqhull_r/libqhull_r.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <string>
#include <string_view>
#include <vector>

namespace {

using sunder::Random;

double seconds() {
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

std::vector<double> some_points(std::string_view kind, std::size_t d, std::size_t count, Random& random) {
  std::vector<double> rows;
  for (std::size_t k = 0; k < count; ++k) {
    std::vector<double> p(d);
    double square = 0;
    for (double& x : p) {
      x = std::sqrt(-2 * std::log(1 - random.unit())) * std::cos(6.283185307179586 * random.unit());
      square += x * x;
    }
    for (std::size_t c = 0; c < d; ++c) {
      if (kind == "sphere") p[c] /= std::sqrt(square);
      if (kind == "cube") p[c] = random.uniform(-1, 1);
      if (kind == "grid") p[c] = static_cast<double>(random.between(0, 9));
    }
    rows.insert(rows.end(), p.begin(), p.end());
  }
  return rows;
}

std::size_t facets_by_qhull(std::size_t d, std::vector<double>& rows, const char* options) {
  qhT qh;
  qh_zero(&qh, stderr);
  std::string command = options;
  const int failed = qh_new_qhull(&qh, static_cast<int>(d), static_cast<int>(rows.size() / d), rows.data(), False,
                                  command.data(), nullptr, nullptr);
  const auto facets = failed != 0 ? 0 : static_cast<std::size_t>(qh.num_facets);
  qh_freeqhull(&qh, !qh_ALL);
  int current = 0, total = 0;
  qh_memfreeshort(&qh, &current, &total);
  return facets;
}

double median(std::vector<double> times) {
  std::sort(times.begin(), times.end());
  return times[times.size() / 2];
}

struct Input {
  std::size_t d, count;
  const char* kind;
};

}  // namespace

int main(int count, char** words) {
  const bool is_quick = std::find(words, words + count, std::string_view("--quick")) != words + count;
  const int rounds = is_quick ? 3 : 7;
  constexpr Input inputs[]{{2, 100000, "sphere"}, {2, 100000, "cube"},  {3, 10000, "sphere"}, {3, 100000, "cube"},
                           {4, 1000, "sphere"},   {4, 10000, "sphere"}, {4, 100000, "cube"},  {4, 10000, "grid"},
                           {5, 300, "sphere"},    {5, 1000, "sphere"},  {5, 10000, "cube"},   {5, 10000, "grid"},
                           {6, 100, "sphere"},    {6, 200, "sphere"},   {6, 1000, "cube"},    {6, 5000, "grid"}};
  std::printf(
      "| d | points | sunder, ms | qhull, ms | qhull / sunder | facets | qhull's |\n|---|---|---|---|---|---|---|\n");
  for (const Input& input : inputs) {
    if (is_quick && input.count > 10000) continue;
    Random random(20261127);
    std::vector<double> rows = some_points(input.kind, input.d, input.count, random);
    std::vector<double> ours, theirs;
    std::size_t facets = 0, facets_of_qhull = 0;
    const auto points = sunder::polytope::Polytope::from_points(input.d, rows);
    for (int round = 0; round < rounds; ++round) {
      const double begin = seconds();
      facets = sunder::polytope::convex_hull(points).facet_count();
      const double middle = seconds();
      facets_of_qhull = facets_by_qhull(input.d, rows, "qhull");
      ours.push_back(middle - begin);
      theirs.push_back(seconds() - middle);
    }
    std::printf("| %zu | %zu, %s | %.1f | %.1f | %.2f | %zu | %zu |\n", input.d, input.count, input.kind,
                1e3 * median(ours), 1e3 * median(theirs), median(theirs) / median(ours), facets, facets_of_qhull);
    (void)std::fflush(stdout);
  }
  return 0;
}
