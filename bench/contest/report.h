// What every benchmark says about the run: machine, compiler, date, commit; and small statistics.
#pragma once

#include <cstdint>
#include <cstdio>
#include <string>
#include <vector>

namespace bench {

struct Circumstances {
  std::string machine, compiler, flags, date, commit;
};

// The commit: of the command line if not empty, else of the environment's SUNDER_COMMIT, else "unknown".
Circumstances circumstances(const std::string& commit);

// The members of a JSON object that tell the circumstances, with a comma after each.
void print_json(std::FILE*, const Circumstances&);
void print_text(std::FILE*, const Circumstances&);

// Requires a value at least.
double median(std::vector<double> values);
double lowest(const std::vector<double>& values);
double geometric_mean(const std::vector<double>& values);

// What is demanded and does not hold; or that all does.
void print_failures(const std::vector<std::string>& failures);

// Is the text a whole number, not less than that? Then it is in `out`.
bool parse_number(const std::string& text, std::uint64_t least, std::uint64_t& out);

// A file that appears under its name only once it is whole: written under another name, then renamed.
class ReportFile {
 public:
  explicit ReportFile(std::string path);  // throws std::runtime_error where it cannot be opened
  ReportFile(const ReportFile&) = delete;
  ReportFile& operator=(const ReportFile&) = delete;
  ~ReportFile();
  std::FILE* get() { return file_; }
  void commit();  // throws std::runtime_error where it cannot be written

 private:
  std::string path_, temporary_;
  std::FILE* file_ = nullptr;
};

}  // namespace bench
