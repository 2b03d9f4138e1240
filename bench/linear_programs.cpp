// bench_linear_programs: the best of many half-spaces of three and four dimensions. The times of Sunder's front door
// and of Seidel's method, evidence in exact numbers included; bench/linear_programs.py runs it, and asks HiGHS about
// the same inputs.
//
//   bench_linear_programs [--write FILE]
//
// Writes what it asks about, and its answers, to the file: doubles of this machine, in the order in which the script
// reads them. Inputs, from seeds that are fixed:
//   sphere     tangents of a sphere
//   vertex     all through one point, which is the best one
//   infeasible tangents of a sphere, one of which is opposite, and a last bit beyond another
// Times are medians over rounds of the mean of a call, of processor time.
#include <sunder/base/random.h>
#include <sunder/polytope/region/half_space_region.h>
#include <sunder/polytope/region/linear_program.h>

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

double seconds() {
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

double normal(Random& random) {
  return std::sqrt(-2 * std::log(1 - random.unit())) * std::cos(6.283185307179586 * random.unit());
}

enum class Family : unsigned char { sphere, vertex, infeasible };

struct Program {
  Polytope half_spaces;
  std::vector<double> objective;
};

Program make(Random& random, Family family, std::size_t d, std::size_t n) {
  std::vector<double> rows;
  for (std::size_t k = 0; k < n; ++k) {
    std::vector<double> row(d + 1);
    double square = 0;
    for (std::size_t c = 0; c < d; ++c) {
      row[c] = normal(random);
      square += row[c] * row[c];
    }
    for (std::size_t c = 0; c < d; ++c) row[c] /= std::sqrt(square);
    row[d] = family == Family::vertex ? 0 : 1;
    if (family == Family::vertex && row[0] < 0.25) {  // a cone about -x1; so 0 is the best point along x1
      --k;
      continue;
    }
    rows.insert(rows.end(), row.begin(), row.end());
  }
  if (family == Family::infeasible) {
    for (std::size_t c = 0; c < d; ++c) rows[rows.size() - d - 1 + c] = -rows[c];
    rows.back() = -std::nextafter(1.0, 2.0);
  }
  std::vector<double> objective(d);
  if (family == Family::vertex) {
    objective[0] = 1;
  } else {
    for (double& x : objective) x = normal(random);
  }
  return {Polytope::from_half_spaces(d, std::move(rows)), std::move(objective)};
}

void write(std::ofstream& file, const std::vector<double>& numbers) {
  const double count = static_cast<double>(numbers.size());
  file.write(reinterpret_cast<const char*>(&count), sizeof count);
  file.write(reinterpret_cast<const char*>(numbers.data()),
             static_cast<std::streamsize>(numbers.size() * sizeof(double)));
}

template <class Call>
double microseconds(const std::vector<Program>& programs, const Call& call) {
  std::vector<double> times;
  for (int round = 0; round < 5; ++round) {
    const double begin = seconds();
    for (const Program& program : programs) call(program);
    times.push_back((seconds() - begin) * 1e6 / static_cast<double>(programs.size()));
  }
  std::sort(times.begin(), times.end());
  return times[times.size() / 2];
}

}  // namespace

int main(int argc, char** argv) {
  std::ofstream file;
  if (argc == 3 && std::strcmp(argv[1], "--write") == 0) file.open(argv[2], std::ios::binary);
  std::printf("%-11s %2s %7s %12s %12s %12s %9s %9s\n", "programs", "d", "n", "front, us", "seidel, us", "region, us",
              "scans", "finished");
  Random random(2026);
  for (const Family family : {Family::sphere, Family::vertex, Family::infeasible}) {
    for (const std::size_t d : {std::size_t{3}, std::size_t{4}}) {
      for (const std::size_t n : {std::size_t{1000}, std::size_t{100000}}) {
        std::vector<Program> programs;
        for (std::size_t k = 0; k < (n > 1000 ? 4u : 32u); ++k) programs.push_back(make(random, family, d, n));
        std::vector<LinearProgramAnswer> answers;
        for (const Program& p : programs) answers.push_back(linear_program(p.half_spaces, p.objective));
        std::size_t sink = 0, finished = 0;
        double probes = 0;
        const double front = microseconds(programs, [&](const Program& p) {
          sink += named_point(linear_program(p.half_spaces, p.objective).evidence) != nullptr ? 1 : 0;
        });
        const double seidel = microseconds(programs, [&](const Program& p) {
          sink += named_point(linear_program_by_seidel(p.half_spaces, p.objective).evidence) != nullptr ? 1 : 0;
        });
        const double region = microseconds(programs, [&](const Program& p) {
          sink += extent_of(half_space_region(p.half_spaces)) != nullptr ? 1 : 0;
        });
        for (const LinearProgramAnswer& answer : answers) {
          finished += answer.decided_by == sunder::DecidedBy::finishing ? 1 : 0;
          probes += static_cast<double>(answer.cost.probes);
        }
        const char* const name = family == Family::sphere   ? "sphere"
                                 : family == Family::vertex ? "vertex"
                                                            : "infeasible";
        std::printf("%-11s %2zu %7zu %12.1f %12.1f %12.1f %9.1f %4zu of %zu\n", name, d, n, front, seidel, region,
                    probes / static_cast<double>(n * programs.size()), finished, programs.size());
        if (sink == 1) std::puts("");
        if (!file.is_open()) continue;
        write(file, {static_cast<double>(family), static_cast<double>(d), static_cast<double>(n),
                     static_cast<double>(programs.size()), front});
        for (std::size_t k = 0; k < programs.size(); ++k) {
          std::vector<double> rows;
          for (std::uint32_t i = 0; i < programs[k].half_spaces.size(); ++i) {
            const std::span<const double> row = programs[k].half_spaces.row(i);
            rows.insert(rows.end(), row.begin(), row.end());
          }
          write(file, rows);
          write(file, programs[k].objective);
          std::vector<double> answer{static_cast<double>(answers[k].verdict())};
          if (const sunder::ExactPointN* point = named_point(answers[k].evidence)) {
            for (const sunder::Dyadic& x : point->numbers) {
              answer.push_back(sunder::nearest_ratio(x, point->denominator));
            }
          }
          write(file, answer);
        }
      }
    }
  }
}
