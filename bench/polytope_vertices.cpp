// bench_polytope_vertices: how long does it take to list the vertices of half-spaces in three to six dimensions?
// Against the Parma Polyhedra Library (the double description method in integers of any size): the same rows, in one
// run, in turns, from numbers in memory to vertices in memory. Times are medians over rounds, of processor time. Both
// are exact; Sunder's answer has the normal fan beside the vertices, which proves it.
//
//   bench_polytope_vertices [--quick] [--check]   (other options are those of other benchmarks, and change nothing)
//
// --check exits 1 where a set of degenerate vertices takes more than twice PPL's time, or the numbers of vertices
// differ.
#include <sunder/base/random.h>
#include <sunder/polytope/hull/vertices.h>

#ifdef SUNDER_BENCH_PPL
#include <ppl.hh>
#endif

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <string_view>
#include <vector>

namespace {

using sunder::Random;
using sunder::polytope::Polytope;

double seconds() {
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

struct Input {
  const char* name;
  std::size_t d;
  bool is_degenerate;
  std::vector<double> rows;  // integers
};

std::vector<double> cube(std::size_t d) {
  std::vector<double> rows;
  for (std::size_t k = 0; k < 2 * d; ++k) {
    for (std::size_t c = 0; c < d; ++c) rows.push_back(c == k / 2 ? (k % 2 == 0 ? 1 : -1) : 0);
    rows.push_back(1);
  }
  return rows;
}

std::vector<double> cross_polytope(std::size_t d) {
  std::vector<double> rows;
  for (std::size_t k = 0; k < std::size_t{1} << d; ++k) {
    for (std::size_t c = 0; c < d; ++c) rows.push_back((k >> c & 1) == 0 ? 1 : -1);
    rows.push_back(1);
  }
  return rows;
}

// The facets of the hull of points of {-size, .., size}^d.
std::vector<double> facets_of_lattice_points(std::size_t d, std::size_t count, int size, std::uint64_t seed) {
  Random random(seed);
  std::vector<double> numbers, rows;
  for (std::size_t k = 0; k < count * d; ++k) numbers.push_back(static_cast<double>(random.between(-size, size)));
  const Polytope points = Polytope::from_points(d, numbers);
  const sunder::polytope::ConvexHull hull = convex_hull(points);
  for (std::size_t f = 0; f < hull.facet_count(); ++f) {
    for (const sunder::Dyadic& x : facet_half_space(hull, points, f)) rows.push_back(x.nearest());
  }
  return rows;
}

// That touch a ball, up to rounding to integers of 20 bits.
std::vector<double> tangents(std::size_t d, std::size_t count) {
  Random random(20261128);
  std::vector<double> rows;
  for (std::size_t k = 0; k < count; ++k) {
    double square = 0;
    for (std::size_t c = 0; c < d; ++c) {
      rows.push_back(std::sqrt(-2 * std::log(1 - random.unit())) * std::cos(6.283185307179586 * random.unit()));
      square += rows.back() * rows.back();
    }
    for (std::size_t c = 0; c < d; ++c) rows[rows.size() - 1 - c] *= 0x1p20 / std::sqrt(square);
    rows.push_back(0x1p20);
  }
  for (double& x : rows) x = std::nearbyint(x);
  return rows;
}

#ifdef SUNDER_BENCH_PPL
std::size_t vertices_by_ppl(std::size_t d, const std::vector<double>& rows) {
  using namespace Parma_Polyhedra_Library;
  Constraint_System constraints;
  for (std::size_t k = 0; k < rows.size(); k += d + 1) {
    Linear_Expression left;
    for (std::size_t c = 0; c < d; ++c) left += static_cast<long>(rows[k + c]) * Variable(c);
    constraints.insert(left <= static_cast<long>(rows[k + d]));
  }
  const C_Polyhedron body(constraints);
  std::size_t count = 0;
  for (const Generator& generator : body.minimized_generators()) count += generator.is_point() ? 1 : 0;
  return count;
}
#endif

double median(std::vector<double> times) {
  std::sort(times.begin(), times.end());
  return times[times.size() / 2];
}

}  // namespace

int main(int count, char** words) {
  const auto has = [&](std::string_view word) { return std::find(words, words + count, word) != words + count; };
  const int rounds = has("--quick") ? 3 : 7;
#ifdef SUNDER_BENCH_PPL
  Parma_Polyhedra_Library::restore_pre_PPL_rounding();  // its start-up rounds upwards
#else
  std::puts("PPL (libppl-dev) is not there: Sunder's times alone, and nothing is demanded");
#endif
  const std::vector<Input> inputs{{"cross-polytope", 4, true, cross_polytope(4)},
                                  {"cross-polytope", 5, true, cross_polytope(5)},
                                  {"cross-polytope", 6, true, cross_polytope(6)},
                                  {"facets of 30 lattice points", 4, true, facets_of_lattice_points(4, 30, 3, 1)},
                                  {"facets of 20 lattice points", 5, true, facets_of_lattice_points(5, 20, 3, 1)},
                                  {"facets of 14 lattice points", 6, true, facets_of_lattice_points(6, 14, 3, 1)},
                                  {"facets of 14 lattice points", 6, true, facets_of_lattice_points(6, 14, 3, 2)},
                                  {"facets of 16 lattice points", 6, true, facets_of_lattice_points(6, 16, 3, 3)},
                                  {"cube", 6, false, cube(6)},
                                  {"tangents of a ball", 3, false, tangents(3, 1000)},
                                  {"tangents of a ball", 4, false, tangents(4, 200)},
                                  {"tangents of a ball", 5, false, tangents(5, 60)},
                                  {"tangents of a ball", 6, false, tangents(6, 30)}};
  std::puts("| d | half-spaces | vertices | sunder, ms | ppl, ms | sunder / ppl |\n|---|---|---|---|---|---|");
  bool is_met = true;
  for (const Input& input : inputs) {
    const auto half_spaces = Polytope::from_half_spaces(input.d, input.rows);
    std::vector<double> ours, theirs;
    std::size_t vertices = 0;
    for (int round = 0; round < rounds; ++round) {
      const double begin = seconds();
      vertices = vertices_of(half_spaces).vertices.size();
      const double middle = seconds();
      ours.push_back(middle - begin);
#ifdef SUNDER_BENCH_PPL
      is_met = vertices_by_ppl(input.d, input.rows) == vertices && is_met;
      theirs.push_back(seconds() - middle);
#endif
    }
    std::printf("| %zu | %u, %s | %zu | %.2f |", input.d, half_spaces.size(), input.name, vertices, 1e3 * median(ours));
    if (!theirs.empty()) {
      const double ratio = median(ours) / median(theirs);
      if (input.is_degenerate && !(ratio <= 2)) is_met = false;
      std::printf(" %.2f | %.2f |", 1e3 * median(theirs), ratio);
    }
    std::puts("");
    (void)std::fflush(stdout);
  }
  return has("--check") && !is_met ? 1 : 0;
}
