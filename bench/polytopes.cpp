// bench_polytopes: do two polytopes of four dimensions meet, and are points in a hull? The times of Sunder's front
// doors, evidence in exact numbers included; bench/polytopes.py runs it, and asks HiGHS, GLPK, Clp and SciPy about the
// same inputs.
//
//   bench_polytopes [--write FILE | --trees | --columns | --descents]
//
// With --trees: what hierarchical trees take and cost, in counts, for docs/design/polytope.md; with --columns: the times
// of the method that walks down them, and of the front door; with --descents: what trees of faces take and cost.
//
// Writes what it asks about, and its answers, to the file: doubles of this machine, in the order in which the script
// reads them. Inputs are points on spheres, and half-spaces that touch spheres: pairs whose gap, or depth, is some part
// of their size, from seeds that are fixed; and pairs that touch, or miss one another by a last bit, by construction.
// Exits 3 where an answer is not the one that is known. Times are medians over rounds of the mean of a call, of
// processor time.
#include <sunder/base/random.h>
#include <sunder/polytope/hull/convex_hull.h>
#include <sunder/polytope/pair/polytope_point.h>
#include <sunder/polytope/pair/polytope_polytope.h>
#include <sunder/polytope/tree/polytope_polytope_by_tree.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <fstream>
#include <span>
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

enum class Known { no, meet, apart };

struct Pair {
  std::vector<double> rows_a, rows_b;
  Polytope a, b;
};

struct Regime {
  const char* name;
  bool a_of_points, b_of_points;
  Known known;
  std::vector<Pair> pairs;
};

Polytope body_of(const std::vector<double>& rows, bool is_of_points) {
  return is_of_points ? Polytope::from_points(kDimension, rows) : Polytope::from_half_spaces(kDimension, rows);
}

// Points on the unit sphere about a centre, or half-spaces that touch it.
std::vector<double> round_body(Random& random, const std::vector<double>& centre, bool is_of_points) {
  if (is_of_points) return on_sphere(random, kPoints, centre);
  std::vector<double> rows;
  for (std::size_t k = 0; k < kPoints; ++k) {
    const std::vector<double> normal = on_sphere(random, 1, std::vector<double>(kDimension));
    double side = 1;
    for (std::size_t c = 0; c < kDimension; ++c) side += normal[c] * centre[c];
    rows.insert(rows.end(), normal.begin(), normal.end());
    rows.push_back(side);
  }
  return rows;
}

// Centres are so far apart along a random direction: 2 is about where the bodies touch.
Regime at_distance(Random& random, const char* name, bool a_of_points, bool b_of_points, double distance) {
  Regime regime{name, a_of_points, b_of_points, Known::no, {}};
  for (std::size_t k = 0; k < kPairs; ++k) {
    std::vector<double> there = on_sphere(random, 1, std::vector<double>(kDimension));
    for (double& x : there) x *= distance;
    std::vector<double> a = round_body(random, std::vector<double>(kDimension), a_of_points),
                        b = round_body(random, there, b_of_points);
    Polytope body_a = body_of(a, a_of_points), body_b = body_of(b, b_of_points);
    regime.pairs.push_back({std::move(a), std::move(b), std::move(body_a), std::move(body_b)});
  }
  return regime;
}

// B shares a point of A and lies on the other side of the plane x1 = 1; or so, but a last bit further.
Regime sharing_a_point(Random& random, const char* name, bool is_apart) {
  Regime regime = at_distance(random, name, true, true, 0);
  regime.known = is_apart ? Known::apart : Known::meet;
  const double first = is_apart ? std::nextafter(1.0, 2.0) : 1.0;
  for (Pair& pair : regime.pairs) {
    for (std::size_t k = 0; k < kPoints; ++k) {
      double &x = pair.rows_a[k * kDimension], &y = pair.rows_b[k * kDimension];
      x = 1 - std::fabs(x);
      y = std::max(first, 1 + std::fabs(y));
    }
    pair.rows_a[0] = 1;
    std::copy_n(pair.rows_a.begin(), kDimension, pair.rows_b.begin());
    pair.rows_b[0] = first;
    pair.a = body_of(pair.rows_a, true);
    pair.b = body_of(pair.rows_b, true);
  }
  return regime;
}

// Integers. A is where x1 <= 0, B where x1 >= gap, and both have points there, or half-spaces that end there, around
// the origin; x1 stands for another integer combination of what is written. Sizes are at most 2^48, so a gap of 1 is
// about the last bit.
Regime of_integers(Random& random, const char* name, bool a_of_points, bool b_of_points, double gap) {
  Regime regime = at_distance(random, name, a_of_points, b_of_points, 0);
  regime.known = gap > 0 ? Known::apart : Known::meet;
  const std::array<double, kDimension> slant{1, 3, -2,
                                             5};  // x1 of a body is x1 - 3 x2 + 2 x3 - 5 x4 of what is written
  for (Pair& pair : regime.pairs) {
    for (const bool is_of_a : {true, false}) {
      std::vector<double>& rows = is_of_a ? pair.rows_a : pair.rows_b;
      const double side = is_of_a ? -1 : 1;
      rows.clear();
      for (std::size_t k = 0; k < kPoints; ++k) {
        std::array<double, kDimension> x{};
        for (double& number : x)
          number = static_cast<double>(random.between(-(std::int64_t{1} << 45), std::int64_t{1} << 45));
        x[0] = side * std::fabs(x[0]);
        if (is_of_a ? a_of_points : b_of_points) {
          if (k < 8) x[0] = 0;
          if (k < 8 && k % 2 == 1) {  // the opposite of the one before
            for (std::size_t c = 1; c < kDimension; ++c) x[c] = -rows[(k - 1) * kDimension + c];
          }
          if (!is_of_a) x[0] += gap;
          for (std::size_t c = 1; c < kDimension; ++c) x[0] += slant[c] * x[c];
          rows.insert(rows.end(), x.begin(), x.end());
        } else {  // small normals; the origin is deep inside of all but the first
          for (double& number : x) number = std::floor(number * 0x1p-40);
          if (k == 0) x = {1, -slant[1], -slant[2], -slant[3]};
          for (double& number : x) number *= k == 0 && !is_of_a ? -1 : 1;
          rows.insert(rows.end(), x.begin(), x.end());
          rows.push_back(k > 0 ? 0x1p40 : is_of_a ? 0.0 : -gap);
        }
      }
    }
    pair.a = body_of(pair.rows_a, a_of_points);
    pair.b = body_of(pair.rows_b, b_of_points);
  }
  return regime;
}

// Points about on the boundary of the hull: vertices, the means of the vertices of a simplex of a facet, which rounding
// puts in or out by a last bit, and both with each coordinate a last bit further from zero.
std::vector<double> about_on_boundary(const Polytope& body) {
  const ConvexHull hull = convex_hull(body);
  std::vector<double> result;
  const auto add = [&](const std::array<double, kDimension>& p) {
    result.insert(result.end(), p.begin(), p.end());
    for (const double x : p) result.push_back(std::nextafter(x, 2 * x));
  };
  const std::size_t vertex_step = hull.vertices.size() / (kAsked / 4), facet_step = hull.facet_count() / (kAsked / 4);
  for (std::size_t k = 0; k < kAsked / 4; ++k) {
    std::array<double, kDimension> vertex{}, mean{};
    const std::span<const double> row = body.row(hull.vertices[k * vertex_step]);
    std::copy(row.begin(), row.end(), vertex.begin());
    const std::span<const std::uint32_t> corners = hull.simplices(k * facet_step);
    for (std::size_t i = 0; i < kDimension; ++i) {
      for (std::size_t c = 0; c < kDimension; ++c) mean[c] += body.row(corners[i])[c] / kDimension;
    }
    add(vertex);
    add(mean);
  }
  return result;
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
        looks += static_cast<double>(polytope_polytope_by_columns(a, here, b, here).cost.probes) / pairs;
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
}

// The times of columns and of the front door, of the same bodies at poses that turn in a plane and move away, from deep
// in each other to apart.
void print_columns() {
  std::printf("| d | n | columns, us | front door, us |\n|---|---|---|---|\n");
  for (const auto& [d, n] :
       {std::pair<std::size_t, std::size_t>{2, 10000}, {3, 1000}, {3, 10000}, {4, 300}, {4, 1000}}) {
    Random random(d * 1000 + n);
    const HierarchicalTree a(Polytope::from_points(d, sphere_of(random, d, n, 0))),
        b(Polytope::from_points(d, sphere_of(random, d, n, 0)));
    const Pose here(d);
    const std::size_t count = 256;
    std::vector<Pose> poses;
    for (std::size_t k = 0; k < count; ++k) {
      std::vector<double> linear(d * d), translation = sphere_of(random, d, 1, 0);
      for (std::size_t c = 0; c < d; ++c) linear[c * d + c] = 1;
      const double angle = random.uniform(0, 6.28);
      linear[0] = linear[d + 1] = std::cos(angle);
      linear[d] = std::sin(angle);
      linear[1] = -linear[d];
      for (double& x : translation) x *= 0.7 + 1.8 * static_cast<double>(k) / (count - 1);
      poses.push_back(Pose::from_matrix(d, linear, translation));
    }
    int meets = 0;
    const double by_columns = microseconds(count, [&] {
      for (const Pose& there : poses) meets += polytope_polytope_by_columns(a, here, b, there).meet();
    });
    const double front = microseconds(count, [&] {
      for (const Pose& there : poses) meets -= polytope_polytope(a.body(), here, b.body(), there).meet();
    });
    if (meets != 0) std::exit(3);
    std::printf("| %zu | %zu | %.1f | %.1f |\n", d, n, by_columns, front);
    std::fflush(stdout);
  }
}

// One descent down the tree of the faces of a body and that of the faces of another's polar.
void print_descents() {
  std::printf(
      "| d | n | of | seconds to make | depth | cones | faces | lists of the root, over the faces | memory |\n");
  std::printf("|---|---|---|---|---|---|---|---|---|\n");
  std::vector<std::string> pairs;
  for (const auto& [d, n] : {std::pair<std::size_t, std::size_t>{2, 100},
                             {2, 1000},
                             {2, 10000},
                             {3, 100},
                             {3, 1000},
                             {3, 10000},
                             {4, 100},
                             {4, 300},
                             {5, 60}}) {
    Random random(d * 1000 + n);
    const Polytope body = Polytope::from_points(d, sphere_of(random, d, n, 0)),
                   other = Polytope::from_points(d, sphere_of(random, d, n, 0));
    double begin = seconds();
    const FaceTrees a(body, FaceTreesOf::faces);
    const double of_faces = seconds() - begin;
    begin = seconds();
    const FaceTrees b(other, FaceTreesOf::polar);
    const double of_polar = seconds() - begin;
    for (const bool is_polar : {false, true}) {
      const FaceTree& tree = is_polar ? *b.polar() : *a.faces();
      std::printf("| %zu | %zu | %s | %.2f | %u | %zu | %zu | %.1f | %zu KiB |\n", d, n,
                  is_polar ? "the polar" : "the body", is_polar ? of_polar : of_faces, tree.depth(), tree.cone_count(),
                  tree.face_count(), static_cast<double>(tree.root_list()) / static_cast<double>(tree.face_count()),
                  (tree.memory() + 1023) >> 10);
      std::fflush(stdout);
    }
    const Pose here(d);
    const std::size_t count = 64;
    std::vector<Pose> poses;
    for (std::size_t k = 0; k < count; ++k) {
      std::vector<double> linear(d * d), translation(d);
      for (std::size_t c = 0; c < d; ++c) linear[c * d + c] = 1;
      translation[0] = 0.7 + 1.8 * static_cast<double>(k) / (count - 1);
      poses.push_back(Pose::from_matrix(d, linear, translation));
    }
    double looks = 0, rounds = 0, front_looks = 0;
    for (const Pose& there : poses) {
      const PolytopeAnswer answer = polytope_polytope_by_tree(a, here, b, there);
      looks += static_cast<double>(answer.cost.probes) / count;
      rounds += static_cast<double>(answer.cost.iterations) / count;
      front_looks += static_cast<double>(polytope_polytope(body, here, other, there).cost.probes) / count;
    }
    int meets = 0;
    const double by_tree = microseconds(count, [&] {
      for (const Pose& there : poses) meets += polytope_polytope_by_tree(a, here, b, there).meet();
    });
    const double by_columns = microseconds(count, [&] {
      for (const Pose& there : poses) meets += polytope_polytope_by_columns(a.walks(), here, b.walks(), there).meet();
    });
    const double front = microseconds(count, [&] {
      for (const Pose& there : poses) meets += polytope_polytope(body, here, other, there).meet();
    });
    char line[200];
    std::snprintf(line, sizeof line, "| %zu | %zu | %.1f | %.0f | %.0f | %.0f | %.1f | %.1f |", d, n, rounds, looks,
                  front_looks, by_tree, by_columns, front);
    pairs.emplace_back(line);
  }
  std::printf(
      "\n| d | n | rounds | looks | the front door's | us | columns, us | front door, us "
      "|\n|---|---|---|---|---|---|---|---|\n");
  for (const std::string& line : pairs) std::printf("%s\n", line.c_str());
}

}  // namespace

int main(int count, char** words) {
  if (count == 2 && std::string(words[1]) == "--trees") {
    print_trees();
    return 0;
  }
  if (count == 2 && std::string(words[1]) == "--columns") {
    print_columns();
    return 0;
  }
  if (count == 2 && std::string(words[1]) == "--descents") {
    print_descents();
    return 0;
  }
  std::ofstream file;
  if (count == 3 && std::string(words[1]) == "--write") file.open(words[2], std::ios::binary);
  Random random(20261126);
  const Pose here(kDimension);
  std::printf("pairs of %zu points, d = %zu: microseconds a call; with exact evidence\n", kPoints, kDimension);
  const std::vector<Regime> regimes{
      at_distance(random, "far apart", true, true, 4),
      at_distance(random, "near", true, true, 1.95),
      at_distance(random, "meet", true, true, 1.2),
      sharing_a_point(random, "touch in a point", false),
      sharing_a_point(random, "a last bit apart", true),
      of_integers(random, "facets touch", true, true, 0),
      of_integers(random, "facets, a last bit apart", true, true, 1),
      at_distance(random, "apart", false, false, 2.1),
      at_distance(random, "near", false, false, 2.0),
      at_distance(random, "meet", false, false, 1.2),
      of_integers(random, "touch", false, false, 0),
      of_integers(random, "a last bit apart", false, false, 1),
      at_distance(random, "apart", false, true, 2.1),
      at_distance(random, "near", false, true, 2.0),
      at_distance(random, "meet", false, true, 1.2),
      of_integers(random, "touch", false, true, 0),
      of_integers(random, "a last bit apart", false, true, 1),
  };
  if (file.is_open()) write(file, {static_cast<double>(regimes.size())});
  for (const Regime& regime : regimes) {
    const std::vector<Pair>& pairs = regime.pairs;
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
    const double meets = static_cast<double>(std::count(answers.begin(), answers.end(), 1));
    const std::string bodies = regime.a_of_points   ? "points"
                               : regime.b_of_points ? "half-spaces and points"
                                                    : "half-spaces";
    std::printf("%-23s %-25s %9.2f %10.2f   %2.0f of %zu meet, %d finished\n", bodies.c_str(), regime.name, plain,
                with_evidence, meets, pairs.size(), finished);
    const double expected = regime.known == Known::meet ? static_cast<double>(pairs.size()) : 0;
    if (proved == 0 || (regime.known != Known::no && meets != expected)) return 3;
    if (!file.is_open()) continue;
    write(file, {regime.a_of_points ? 1.0 : 0.0, regime.b_of_points ? 1.0 : 0.0, plain, with_evidence});
    const std::string name = regime.name;
    write(file, std::vector<double>(name.begin(), name.end()));
    write(file, answers);
    for (const Pair& pair : pairs) {
      write(file, pair.rows_a);
      write(file, pair.rows_b);
    }
  }
  std::vector<double> rows = on_sphere(random, kHull, std::vector<double>(kDimension));  // then in the ball
  for (std::size_t k = 0; k < kHull; ++k) {
    const double scale = std::pow(random.unit(), 0.25);
    for (std::size_t c = 0; c < kDimension; ++c) rows[k * kDimension + c] *= scale;
  }
  const Polytope hull = Polytope::from_points(kDimension, rows);
  std::vector<double> points;  // from the middle to a little outside
  for (std::size_t k = 0; k < kAsked; ++k) {
    const double scale = std::sqrt(random.uniform(0, 1.2));
    for (const double x : on_sphere(random, 1, std::vector<double>(kDimension))) points.push_back(scale * x);
  }
  if (file.is_open()) write(file, rows);
  for (const bool is_boundary : {false, true}) {
    if (is_boundary) points = about_on_boundary(hull);
    std::vector<double> inside(kAsked);
    const double many = microseconds(kAsked, [&] {
      const std::vector<PolytopeAnswer> answers = polytope_points(hull, points);
      for (std::size_t k = 0; k < kAsked; ++k) inside[k] = answers[k].meet() ? 1 : 0;
    });
    std::size_t proved = 0;
    const double with_evidence = microseconds(kAsked, [&] {
      const std::vector<PolytopeAnswer> answers = polytope_points(hull, points);
      for (std::size_t k = 0; k < kAsked; ++k) {
        const auto p = points.begin() + static_cast<std::ptrdiff_t>(k * kDimension);
        const Polytope one = Polytope::from_points(kDimension, {p, p + kDimension});
        proved += exact_evidence(hull, here, one, here, answers[k]).numbers.size();
      }
    });
    if (proved == 0) return 3;
    for (std::size_t k = 0; is_boundary && k < kAsked; k += 4) {
      if (inside[k] < 1) return 3;  // vertices
    }
    std::printf(
        "points %s a hull of %zu points: %.2f microseconds a point, %.2f with exact evidence; %td of %zu are in it\n",
        is_boundary ? "about on" : "in", kHull, many, with_evidence, std::count(inside.begin(), inside.end(), 1),
        kAsked);
    if (file.is_open()) {
      write(file, {many, with_evidence});
      write(file, inside);
      write(file, points);
    }
  }
  return 0;
}
