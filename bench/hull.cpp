// bench_hull: how long does the exact hull take? Against Qhull, 100,000 random points on the sphere (all are vertices).
//
// Fairness: the same points, in one run, alternating; from points in memory to facets in memory, in process. Qhull gets
// its default options: `Q0` (no merging) and `Qt` (triangulated output) were measured to make no difference here.
// The time is the median over the rounds, in processor time of the thread (neither library starts others). Sunder's
// hull is exact; Qhull's is not.
#include <sunder/solid/hull/convex_hull.h>

#include <cstdio>
#include <cstdlib>
#include <exception>
#include <string>
#include <vector>

#include "clock.h"
#include "peers/peer_qhull.h"
#include "report.h"
#include "scenarios.h"

namespace bench {
namespace {

constexpr double kAllowed = 2;  // times Qhull's time, at kSize points
constexpr std::size_t kSize = 100000;

struct Row {
  std::size_t n = 0, facets = 0, vertices = 0, qhull_facets = 0, qhull_vertices = 0;
  double sunder_ms = 0, qhull_ms = 0;
  double ratio() const { return sunder_ms / qhull_ms; }
};

Row measure(std::size_t n, std::size_t rounds) {
  const std::vector<Vec> points = sphere_points(n, 7);
  std::vector<sunder::Point3> same;
  for (const Vec& p : points) same.push_back({p[0], p[1], p[2]});
  Row row;
  row.n = n;
  std::vector<double> sunder_ms, qhull_ms;
  const auto ours = [&] {
    const double start = thread_seconds();
    const sunder::solid::ConvexHull hull = sunder::solid::convex_hull(same);
    sunder_ms.push_back(1e3 * (thread_seconds() - start));
    row.facets = hull.facet_begin.size() - 1;
    row.vertices = hull.vertices.size();
  };
  const auto theirs = [&] {
    const QhullTiming timing = time_qhull(points, "qhull");
    qhull_ms.push_back(timing.seconds * 1e3);
    row.qhull_facets = timing.facets;
    row.qhull_vertices = timing.vertices;
  };
  for (std::size_t round = 0; round < rounds; ++round) {
    if (round % 2 == 0) {
      ours(), theirs();
    } else {
      theirs(), ours();
    }
  }
  row.sunder_ms = median(sunder_ms);
  row.qhull_ms = median(qhull_ms);
  return row;
}

int usage(const char* problem) {
  std::fprintf(stderr, "bench_hull: %s\nusage: bench_hull [--check] [--quick] [--json FILE] [--commit ID]\n", problem);
  return 2;
}

int run(bool check, bool quick, const std::string& json, const std::string& commit) {
  print_text(stdout, circumstances(commit));
  std::printf("%8s %12s %12s %8s %20s %20s\n", "points", "sunder ms", "qhull ms", "times", "facets, vertices",
              "qhull's");
  std::vector<Row> rows;
  bool good = true;
  for (const std::size_t n : {std::size_t{1000}, std::size_t{10000}, kSize}) {
    rows.push_back(measure(n, quick ? 3 : n == kSize ? 7 : 21));
    const Row& row = rows.back();
    std::printf("%8zu %12.2f %12.2f %8.2f %11zu %8zu %11zu %8zu\n", row.n, row.sunder_ms, row.qhull_ms, row.ratio(),
                row.facets, row.vertices, row.qhull_facets, row.qhull_vertices);
    std::fflush(stdout);
    if (n == kSize) good = row.ratio() <= kAllowed;
  }
  std::printf("\n%zu points: %.2f times Qhull's time (allowed: %.0f)%s\n", rows.back().n, rows.back().ratio(), kAllowed,
              good ? "" : "  FAILED");
  if (!json.empty()) {
    ReportFile file(json);
    std::fprintf(file.get(), "{\n  \"benchmark\": \"hull\",\n");
    print_json(file.get(), circumstances(commit));
    std::fprintf(file.get(), "  \"rows\": [\n");
    for (std::size_t i = 0; i < rows.size(); ++i) {
      std::fprintf(file.get(), "    {\"n\": %zu, \"sunder_ms\": %.3f, \"qhull_ms\": %.3f, \"ratio\": %.3f}%s\n",
                   rows[i].n, rows[i].sunder_ms, rows[i].qhull_ms, rows[i].ratio(), i + 1 == rows.size() ? "" : ",");
    }
    std::fprintf(file.get(), "  ]\n}\n");
    file.commit();
  }
  return check && !good ? 1 : 0;
}

}  // namespace
}  // namespace bench

int main(int argc, char** argv) {
  bool check = false, quick = false;
  std::string json, commit;
  for (int i = 1; i < argc; ++i) {
    const std::string argument = argv[i];
    if (argument == "--check") {
      check = true;
    } else if (argument == "--quick") {
      quick = true;
    } else if ((argument == "--json" || argument == "--commit") && i + 1 < argc) {
      (argument == "--json" ? json : commit) = argv[++i];
    } else {
      return bench::usage(("unknown option, or value missing: " + argument).c_str());
    }
  }
  try {
    return bench::run(check, quick, json, commit);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "bench_hull: %s\n", error.what());
    return 3;
  }
}
