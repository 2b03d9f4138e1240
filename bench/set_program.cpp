#include "set_program.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <exception>

#include "report.h"

namespace bench {
namespace {

struct Options : ContestOptions {
  bool check = false;
  bool quick = false;
  bool ways = false;  // print the first look at every way
  std::vector<std::size_t> sizes{};
  std::vector<std::string> only{};
  std::string json{}, commit{};
};

constexpr std::size_t kQuickSize = 100000;

// --- The table -------------------------------------------------------------------------------------------------------

// Three digits and a unit.
std::string time_text(double seconds) {
  char text[32];
  const double size = std::fabs(seconds);
  const double scale = size >= 1 ? 1 : size >= 1e-3 ? 1e3 : size >= 1e-6 ? 1e6 : 1e9;
  const char* unit = size >= 1 ? "s " : size >= 1e-3 ? "ms" : size >= 1e-6 ? "us" : "ns";
  const double value = seconds * scale;
  std::snprintf(text, sizeof text, "%.*f %s", value < 9.995 ? 2 : value < 99.95 ? 1 : 0, value, unit);
  return text;
}

std::string ratio_text(double ratio) {
  char text[32];
  std::snprintf(text, sizeof text, "%.*f", ratio < 9.995 ? 2 : ratio < 99.95 ? 1 : 0, ratio);
  return text;
}

void print_head(const Program& program) {
  std::printf(
      "Times of a call. \"sorts\": Sunder's time in sorts. The peers' columns: their time in Sunder's. \"wrong\": "
      "inputs "
      "with a\nwrong answer, of Sunder and of each peer; \"!\": no way was right. \"> \": left out as too slow, by one "
      "call or by growth.\n%s\n",
      program.note.c_str());
}

void print_titles(const Program& program, const Plan& plan) {
  std::printf("\n%-20s %-22s %9s %10s %10s %7s", plan.question.c_str(), plan.input.c_str(), "N", "sort", "sunder",
              "sorts");
  for (const std::string& library : program.libraries) std::printf(" %9s", library.c_str());
  std::printf("  %-9s by which way\n", "wrong");
}

void print(const Row& row, bool ways) {
  using State = Result::State;
  const bool known = row.sunder.state == State::measured;
  std::printf("%53zu %10s %10s %7s", row.n, time_text(row.sort_s).c_str(),
              known ? time_text(row.sunder.median_s).c_str() : "-", known ? ratio_text(row.sorts()).c_str() : "-");
  std::string wrong = known ? std::to_string(row.sunder.wrong) : "-", methods;
  for (const Result& peer : row.peers) {
    std::string cell = "-";
    if (peer.state != State::none) {
      cell = known ? ratio_text(peer.median_s / row.sunder.median_s) : time_text(peer.median_s);
      cell = (peer.state == State::over ? "> " : peer.wrong > 0 ? "!" : "") + cell;
    }
    if (peer.state == State::measured) methods += (methods.empty() ? "" : "; ") + peer.method;
    wrong += peer.state == State::measured ? "/" + std::to_string(peer.wrong) : "/-";
    std::printf(" %9s", cell.c_str());
  }
  std::printf("  %-9s %s\n", wrong.c_str(), methods.c_str());
  for (const Look& look : row.looks) {
    if (!ways) break;
    std::printf("%64s %10s  %s, %s; wrong: %zu of %zu\n", "at first sight", time_text(look.seconds).c_str(),
                look.library.c_str(), look.method.c_str(), look.wrong, row.inputs);
  }
  std::fflush(stdout);
}

// --- The file --------------------------------------------------------------------------------------------------------

void print_json(std::FILE* out, const Result& r) {
  if (r.state == Result::State::none) {
    std::fprintf(out, "{\"library\": \"%s\", \"left_out\": \"does not answer\"}", r.library.c_str());
  } else if (r.state == Result::State::over) {
    std::fprintf(out, "{\"library\": \"%s\", \"left_out\": \"over %.0f s\", \"about_ms\": %.0f}", r.library.c_str(),
                 kMostSeconds, 1e3 * r.median_s);
  } else {
    std::fprintf(out,
                 "{\"library\": \"%s\", \"method\": \"%s\", \"median_ms\": %.9f, \"lowest_ms\": %.9f, \"wrong\": %zu}",
                 r.library.c_str(), r.method.c_str(), 1e3 * r.median_s, 1e3 * r.lowest_s, r.wrong);
  }
}

void write_json(const Program& program, const Options& options, const std::vector<Row>& rows,
                const std::vector<std::string>& failures) {
  ReportFile file(options.json);
  std::FILE* out = file.get();
  std::fprintf(out, "{\n  \"benchmark\": \"%s\",\n", program.name.c_str() + std::string("bench_").size());
  print_json(out, circumstances(options.commit));
  std::fprintf(out, "  \"rounds\": %zu,\n  \"seed\": %llu,\n  \"failures\": [", options.rounds,
               static_cast<unsigned long long>(options.seed));
  for (std::size_t i = 0; i < failures.size(); ++i) {
    std::fprintf(out, "%s\"%s\"", i == 0 ? "" : ", ", failures[i].c_str());
  }
  std::fprintf(out, "],\n  \"rows\": [\n");
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const Row& row = rows[i];
    std::fprintf(out, "    {\"n\": %zu, \"input\": \"%s\", \"question\": \"%s\", \"inputs\": %zu, \"sort_ms\": %.9f",
                 row.n, row.input.c_str(), row.question.c_str(), row.inputs, 1e3 * row.sort_s);
    if (row.sunder.state == Result::State::measured) std::fprintf(out, ", \"sorts\": %.3f", row.sorts());
    std::fprintf(out, ",\n     \"results\": [\n      ");
    print_json(out, row.sunder);
    for (const Result& peer : row.peers) {
      std::fprintf(out, ",\n      ");
      print_json(out, peer);
    }
    std::fprintf(out, "],\n     \"first_looks\": [");
    for (std::size_t k = 0; k < row.looks.size(); ++k) {
      const Look& look = row.looks[k];
      std::fprintf(out, "%s\n      {\"library\": \"%s\", \"method\": \"%s\", \"ms\": %.6f, \"wrong\": %zu}",
                   k == 0 ? "" : ",", look.library.c_str(), look.method.c_str(), 1e3 * look.seconds, look.wrong);
    }
    std::fprintf(out, "]}%s\n", i + 1 == rows.size() ? "" : ",");
  }
  std::fprintf(out, "  ]\n}\n");
  file.commit();
}

// --- What is demanded ------------------------------------------------------------------------------------------------

void add_failures(const Row& row, const Demand& demand, std::vector<std::string>& failures) {
  const std::string what = row.question + ", " + row.input + ", " + std::to_string(row.n) + ": ";
  if (row.sunder.state != Result::State::measured) {
    failures.push_back(what + "Sunder does not answer yet");
    return;
  }
  if (row.sunder.wrong > 0) {
    failures.push_back(what + std::to_string(row.sunder.wrong) + " of Sunder's answers are WRONG");
  }
  if (demand.most_sorts > 0 && row.n >= demand.sorts_from && row.sorts() > demand.most_sorts) {
    failures.push_back(what + ratio_text(row.sorts()) + " sorts (allowed: " + ratio_text(demand.most_sorts) + ")");
  }
  if (demand.most_ns > 0 && 1e9 * row.sunder.median_s > demand.most_ns) {
    failures.push_back(what + time_text(row.sunder.median_s) + " (allowed: " + time_text(1e-9 * demand.most_ns) + ")");
  }
  for (const Result& peer : row.peers) {
    const bool over = peer.state == Result::State::over;
    const bool right = over || (peer.state == Result::State::measured && peer.wrong == 0);
    if (!right || demand.peers <= 0 || row.n < demand.peers_from) continue;
    if (!demand.library.empty() && demand.library != peer.library) continue;
    const double ratio = peer.median_s / row.sunder.median_s;
    if (ratio >= demand.peers && (ratio > 1 || demand.peers < 1)) continue;
    failures.push_back(what + peer.library + " takes " + ratio_text(ratio) + " of Sunder's time (demanded: " +
                       ratio_text(demand.peers) + ")" + (over ? ", by the growth of its times" : ""));
  }
}

// --- The program -----------------------------------------------------------------------------------------------------

bool is_asked(const Options& options, const Plan& plan) {
  return options.only.empty() || std::any_of(options.only.begin(), options.only.end(), [&](const std::string& name) {
           return plan.question.rfind(name, 0) == 0;
         });
}

bool is_wanted(const Options& options, std::size_t n) {
  if (!options.sizes.empty()) return std::find(options.sizes.begin(), options.sizes.end(), n) != options.sizes.end();
  return !options.quick || n <= kQuickSize;
}

// A plan's sizes; where others are asked for, those that the plan reaches, and its own below, which tell how fast the
// time of a peer grows.
std::vector<std::size_t> sizes_of(const Options& options, const Plan& plan) {
  std::vector<std::size_t> sizes = plan.sizes;
  for (const std::size_t n : options.sizes) {
    if (n >= plan.sizes.front() && n <= plan.sizes.back()) sizes.push_back(n);
  }
  std::sort(sizes.begin(), sizes.end());
  sizes.erase(std::unique(sizes.begin(), sizes.end()), sizes.end());
  while (!sizes.empty() && !is_wanted(options, sizes.back())) sizes.pop_back();
  return sizes;
}

int run(const Program& program, const Options& options) {
  print_text(stdout, circumstances(options.commit));
  print_head(program);
  std::vector<Row> rows;
  std::vector<std::string> failures;
  for (const Plan& plan : program.plans) {
    if (!is_asked(options, plan)) continue;
    const std::vector<std::size_t> sizes = sizes_of(options, plan);
    if (!sizes.empty()) print_titles(program, plan);
    History history;
    for (const std::size_t n : sizes) {
      Contest contest = plan.make(n, options.seed);
      contest.input = plan.input;
      contest.question = plan.question;
      contest.n = n;
      const bool wanted = is_wanted(options, n);
      const Row row = measure(contest, program.libraries, !wanted, options, history);
      if (!wanted) continue;
      print(row, options.ways);
      add_failures(row, plan.demand, failures);
      rows.push_back(row);
    }
  }
  std::printf("\n");
  print_failures(failures);
  if (!options.json.empty()) write_json(program, options, rows, failures);
  return options.check && !failures.empty() ? 1 : 0;
}

int usage(const Program& program, const std::string& problem) {
  std::string only;
  for (const std::string& question : program.questions) only += (only.empty() ? "" : "|") + question;
  std::fprintf(stderr,
               "%s: %s\nusage: %s [--check] [--quick] [--ways] [--only %s]... [--sizes N,N,...] [--rounds COUNT] "
               "[--seed SEED] [--json FILE] [--commit ID]\n",
               program.name.c_str(), problem.c_str(), program.name.c_str(), only.c_str());
  return 2;
}

bool parse_sizes(const std::string& text, std::vector<std::size_t>& sizes) {
  std::uint64_t number = 0;
  for (std::size_t from = 0; from <= text.size();) {
    const std::size_t comma = std::min(text.find(',', from), text.size());
    if (!parse_number(text.substr(from, comma - from), 1, number)) return false;
    sizes.push_back(number);
    from = comma + 1;
  }
  return true;
}

// False: not understood.
bool parse(const Program& program, const std::string& name, const std::string& value, Options& options) {
  if (name == "--json") return !(options.json = value).empty();
  if (name == "--commit") return !(options.commit = value).empty();
  if (name == "--rounds") return parse_number(value, 1, options.rounds);
  if (name == "--seed") return parse_number(value, 0, options.seed);
  if (name == "--sizes") return parse_sizes(value, options.sizes);
  if (name != "--only") return false;
  options.only.push_back(value);
  return std::find(program.questions.begin(), program.questions.end(), value) != program.questions.end();
}

}  // namespace

int run(const Program& program, int argc, char** argv) {
  Options options;
  for (int i = 1; i < argc; ++i) {
    const std::string argument = argv[i];
    if (argument == "--check" || argument == "--quick" || argument == "--ways") {
      (argument == "--check" ? options.check : argument == "--quick" ? options.quick : options.ways) = true;
    } else if (i + 1 == argc || !parse(program, argument, argv[i + 1], options)) {
      return usage(program, "unknown option, or value missing or bad: " + argument);
    } else {
      ++i;
    }
  }
  try {
    return run(program, options);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s: %s\n", program.name.c_str(), error.what());
    return 3;
  }
}

}  // namespace bench
