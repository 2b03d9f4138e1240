#include <bench/contest/program.h>
#include <bench/contest/report.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <utility>

namespace bench {
namespace {

constexpr std::size_t kQuickSize = 100000, kQuickRounds = 5;

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

bool is_measured(const Result& result) { return result.state == Result::State::measured; }
std::uint64_t wrong_of(const Result& result) { return std::max<std::uint64_t>(result.wrong, result.tally.wrong); }

// How the answers came about.
std::string tally_text(const Tally& tally) {
  if (tally.asked == 0) return "";
  char text[120];
  const double asked = static_cast<double>(tally.asked);
  std::snprintf(text, sizeof text, "; finished %.3f %%, %.1f probes, %.1f steps",
                100 * static_cast<double>(tally.finishing) / asked, static_cast<double>(tally.probes) / asked,
                static_cast<double>(tally.iterations) / asked);
  return text;
}

void print(const Program& program, const Row& row, bool ways) {
  const bool known = is_measured(row.sunder()), sorted = row.sort_s > 0;
  std::printf("%53zu %10s %10s %7s", row.n, sorted ? time_text(row.sort_s).c_str() : "-",
              known ? time_text(row.sunder().median_s).c_str() : "-",
              known && sorted ? ratio_text(row.sorts()).c_str() : "-");
  std::string wrong = known ? std::to_string(wrong_of(row.sunder())) : "-", methods;
  for (const Result& peer : row.peers) {
    std::string cell = "-";
    if (peer.state != Result::State::none) {
      cell = known ? ratio_text(row.ratio(peer)) : time_text(peer.median_s);
      cell = (peer.state == Result::State::over ? "> " : peer.wrong > 0 ? "!" : "") + cell;
    }
    if (is_measured(peer)) methods += (methods.empty() ? "" : "; ") + peer.method;
    wrong += is_measured(peer) ? "/" + std::to_string(peer.wrong) : "/-";
    std::printf(" %9s", cell.c_str());
  }
  std::printf("  %-9s %s%s\n", wrong.c_str(), methods.c_str(), tally_text(row.sunder().tally).c_str());
  for (std::size_t k = 1; k < row.subjects.size() && program.tells_subjects; ++k) {
    const Result& subject = row.subjects[k];
    std::printf("%75s %7s  %s%s\n", time_text(subject.median_s).c_str(), "", subject.method.c_str(),
                tally_text(subject.tally).c_str());
  }
  for (const Result& look : row.looks) {
    if (!ways) break;
    std::printf("%64s %10s  %s, %s; wrong: %zu of %zu\n", "at first sight", time_text(look.median_s).c_str(),
                look.library.c_str(), look.method.c_str(), look.wrong, look.asked);
  }
  std::fflush(stdout);
}

// --- The file --------------------------------------------------------------------------------------------------------

void print_json(std::FILE* out, const Result& r) {
  std::fprintf(out, "{\"library\": \"%s\", ", r.library.c_str());
  if (r.state == Result::State::none) {
    std::fprintf(out, "\"left_out\": \"does not answer\"}");
    return;
  }
  if (r.state == Result::State::over) {
    std::fprintf(out, "\"left_out\": \"too slow\", \"about_ms\": %.6f}", 1e3 * r.median_s);
    return;
  }
  std::fprintf(out, "\"method\": \"%s\", \"median_ms\": %.9f, \"lowest_ms\": %.9f, \"wrong\": %llu, \"asked\": %zu",
               r.method.c_str(), 1e3 * r.median_s, 1e3 * r.lowest_s, static_cast<unsigned long long>(wrong_of(r)),
               r.asked);  // NOLINT(google-runtime-int): for printf
  const Tally& t = r.tally;
  const std::pair<const char*, std::uint64_t> sums[] = {{"filter", t.filter},         {"evidence", t.evidence},
                                                        {"finishing", t.finishing},   {"probes", t.probes},
                                                        {"iterations", t.iterations}, {"exact", t.exact}};
  for (const auto& [name, sum] : sums) {
    if (t.asked > 0) std::fprintf(out, ", \"%s\": %s", name, std::to_string(sum).c_str());
  }
  std::fprintf(out, "}");
}

void print_json(std::FILE* out, const std::string& text) { std::fprintf(out, "\"%s\"", text.c_str()); }

void print_json(std::FILE* out, const Row& row);

template <class Item>
void print_list(std::FILE* out, const char* name, const std::vector<Item>& items) {
  std::fprintf(out, "\"%s\": [", name);
  for (std::size_t i = 0; i < items.size(); ++i) {
    std::fprintf(out, "%s\n      ", i == 0 ? "" : ",");
    print_json(out, items[i]);
  }
  std::fprintf(out, "]");
}

void print_json(std::FILE* out, const Row& row) {
  std::fprintf(out, "{\"n\": %zu, \"input\": \"%s\", \"question\": \"%s\", \"inputs\": %zu, \"answer\": %.1f", row.n,
               row.input.c_str(), row.question.c_str(), row.inputs, row.answer);
  if (row.sort_s > 0) std::fprintf(out, ", \"sort_ms\": %.9f", 1e3 * row.sort_s);
  if (row.sort_s > 0 && is_measured(row.sunder())) std::fprintf(out, ", \"sorts\": %.3f", row.sorts());
  const std::pair<const char*, const std::vector<Result>*> lists[] = {
      {"sunder", &row.subjects}, {"peers", &row.peers}, {"first_looks", &row.looks}};
  for (const auto& [name, list] : lists) {
    std::fprintf(out, ",\n     ");
    print_list(out, name, *list);
  }
  std::fprintf(out, "}");
}

void write_json(const Program& program, const Options& options, const std::vector<Row>& rows,
                const std::vector<std::string>& failures) {
  ReportFile file(options.json);
  std::FILE* out = file.get();
  std::fprintf(out, "{\n  \"benchmark\": \"%s\",\n", program.name.c_str() + std::string("bench_").size());
  print_json(out, circumstances(options.commit));
  std::fprintf(out, "  \"rounds\": %zu,\n  \"seed\": %s,\n  ", options.rounds, std::to_string(options.seed).c_str());
  print_list(out, "failures", failures);
  std::fprintf(out, ",\n  ");
  print_list(out, "rows", rows);
  std::fprintf(out, "\n}\n");
  file.commit();
}

// --- What is demanded ------------------------------------------------------------------------------------------------

void add_failures(const Row& row, const Demand& demand, std::vector<std::string>& failures) {
  const std::string what = row.question + ", " + row.input + ", " + std::to_string(row.n) + ": ";
  const Result& sunder = row.sunder();
  if (!is_measured(sunder)) {
    failures.push_back(what + "Sunder does not answer yet");
    return;
  }
  for (const Result& subject : row.subjects) {
    if (wrong_of(subject) == 0) continue;
    failures.push_back(what + std::to_string(wrong_of(subject)) + " of Sunder's answers are WRONG" +
                       (&subject == &sunder ? "" : ", by " + subject.method));
  }
  const double most_sorts = bound_at(demand.most_sorts, row.n), peers = bound_at(demand.peers, row.n);
  if (most_sorts > 0 && row.sorts() > most_sorts) {
    failures.push_back(what + ratio_text(row.sorts()) + " sorts (allowed: " + ratio_text(most_sorts) + ")");
  }
  if (demand.most_ns > 0 && 1e9 * sunder.median_s > demand.most_ns) {
    failures.push_back(what + time_text(sunder.median_s) + " (allowed: " + time_text(1e-9 * demand.most_ns) + ")");
  }
  for (const Result& peer : row.peers) {
    const bool over = peer.state == Result::State::over;
    const bool right = over || (is_measured(peer) && peer.wrong == 0);
    if (!right || peers <= 0) continue;
    if (!demand.library.empty() && demand.library != peer.library) continue;
    const double ratio = row.ratio(peer);
    if (ratio >= peers && (ratio > 1 || peers < 1)) continue;
    failures.push_back(what + peer.library + " takes " + ratio_text(ratio) + " of Sunder's time (demanded: " +
                       ratio_text(peers) + ")" + (over ? ", by the growth of its times" : ""));
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
  for (const Plan& plan : program.plans(options)) {
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
      const Row row = measure(contest, program.libraries, options.rounds, !wanted, history);
      if (!wanted) continue;
      print(program, row, options.ways);
      add_failures(row, plan.demand, failures);
      rows.push_back(row);
    }
  }
  std::printf("\n");
  if (program.conclude) program.conclude(rows, failures);
  print_failures(failures);
  if (!options.json.empty()) write_json(program, options, rows, failures);
  return options.check && !failures.empty() ? 1 : 0;
}

int usage(const Program& program, const std::string& problem) {
  std::string more;
  for (const std::string& question : program.questions) more += (more.empty() ? "[--only " : "|") + question;
  if (!more.empty()) more += "]... ";
  for (const auto& [name, value] : program.own) more += "[" + name + " FILE] ";
  std::fprintf(stderr,
               "%s: %s\nusage: %s [--check] [--quick] [--ways] %s[--sizes N,N,...] [--rounds COUNT] [--seed SEED] "
               "[--json FILE] [--commit ID]\n",
               program.name.c_str(), problem.c_str(), program.name.c_str(), more.c_str());
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
  if (options.own.contains(name)) return !(options.own[name] = value).empty();
  if (name != "--only") return false;
  options.only.push_back(value);
  return std::find(program.questions.begin(), program.questions.end(), value) != program.questions.end();
}

}  // namespace

double bound_at(const Steps& steps, std::size_t n) {
  double bound = 0;
  for (const Step& step : steps) bound = n >= step.from ? step.bound : bound;
  return bound;
}

const Row* find(const std::vector<Row>& rows, const std::string& input, std::size_t n) {
  for (const Row& row : rows) {
    if (row.n == n && row.input == input) return &row;
  }
  return nullptr;
}

int run(const Program& program, int argc, char** argv) {
  Options options;
  options.own = program.own;
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
  if (options.quick) options.rounds = std::min(options.rounds, kQuickRounds);
  try {
    return run(program, options);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s: %s\n", program.name.c_str(), error.what());
    return 3;
  }
}

}  // namespace bench
