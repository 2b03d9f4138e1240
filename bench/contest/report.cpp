#include <bench/contest/report.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <stdexcept>
#include <utility>

namespace bench {
namespace {

std::string machine() {
  std::ifstream file("/proc/cpuinfo");
  std::string line;
  while (std::getline(file, line)) {
    if (line.rfind("model name", 0) == 0) {
      const std::size_t colon = line.find(": ");
      if (colon != std::string::npos) return line.substr(colon + 2);
    }
  }
  return "unknown";
}

std::string quoted(const std::string& text) {
  std::string out = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') out += '\\';
    out += static_cast<unsigned char>(c) < 0x20 ? ' ' : c;
  }
  return out + "\"";
}

}  // namespace

Circumstances circumstances(const std::string& commit) {
  Circumstances c;
  c.machine = machine();
#if defined(__clang__)
  c.compiler = "clang " __clang_version__;
#elif defined(__GNUC__)
  c.compiler = "gcc " __VERSION__;
#else
  c.compiler = "unknown";
#endif
#ifdef SUNDER_BENCH_FLAGS
  c.flags = SUNDER_BENCH_FLAGS;
#else
  c.flags = "unknown";
#endif
  char date[32] = "";
  const std::time_t now = std::time(nullptr);
  std::strftime(date, sizeof date, "%Y-%m-%dT%H:%M:%SZ", std::gmtime(&now));
  c.date = date;
  const char* from_environment = std::getenv("SUNDER_COMMIT");
  c.commit = !commit.empty() ? commit : from_environment != nullptr ? from_environment : "unknown";
  return c;
}

void print_json(std::FILE* out, const Circumstances& c) {
  std::fprintf(out, "  \"machine\": %s,\n  \"compiler\": %s,\n  \"flags\": %s,\n  \"date\": %s,\n  \"commit\": %s,\n",
               quoted(c.machine).c_str(), quoted(c.compiler).c_str(), quoted(c.flags).c_str(), quoted(c.date).c_str(),
               quoted(c.commit).c_str());
}

void print_text(std::FILE* out, const Circumstances& c) {
  std::fprintf(out, "%s; %s, %s; %s; commit %s\n", c.machine.c_str(), c.compiler.c_str(), c.flags.c_str(),
               c.date.c_str(), c.commit.c_str());
}

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  const std::size_t half = values.size() / 2;
  return values.size() % 2 != 0 ? values[half] : (values[half - 1] + values[half]) / 2;
}

double lowest(const std::vector<double>& values) { return *std::min_element(values.begin(), values.end()); }

double geometric_mean(const std::vector<double>& values) {
  double sum = 0;
  for (const double v : values) sum += std::log(v);
  return std::exp(sum / static_cast<double>(values.size()));
}

void print_failures(const std::vector<std::string>& failures) {
  for (const std::string& failure : failures) std::printf("FAILED: %s\n", failure.c_str());
  if (failures.empty()) std::printf("All that is demanded holds.\n");
}

bool parse_number(const std::string& text, std::uint64_t least, std::uint64_t& out) {
  char* end = nullptr;
  out = std::strtoull(text.c_str(), &end, 10);
  return !text.empty() && *end == '\0' && out >= least;
}

ReportFile::ReportFile(std::string path) : path_(std::move(path)), temporary_(path_ + ".partial") {
  file_ = std::fopen(temporary_.c_str(), "w");
  if (file_ == nullptr) throw std::runtime_error("cannot write " + temporary_);
}

ReportFile::~ReportFile() {
  if (file_ == nullptr) return;
  std::fclose(file_);
  std::remove(temporary_.c_str());
}

void ReportFile::commit() {
  const bool good = std::ferror(file_) == 0;
  const bool closed = std::fclose(file_) == 0;
  file_ = nullptr;
  if (!good || !closed || std::rename(temporary_.c_str(), path_.c_str()) != 0) {
    std::remove(temporary_.c_str());
    throw std::runtime_error("cannot write " + path_);
  }
}

}  // namespace bench
