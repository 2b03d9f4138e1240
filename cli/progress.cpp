#include <cli/progress.h>

#include <unistd.h>

#include <chrono>
#include <cstdio>
#include <memory>
#include <string>

namespace sunder::cli {

namespace {

class ProgressLine {
 public:
  explicit ProgressLine(std::string_view what) : what_(what), start_(std::chrono::steady_clock::now()) {}
  ~ProgressLine() {
    if (shown_ >= 0) std::fputs("\r\033[K", stderr);
  }
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;

  void show(double part) {
    const int percent = static_cast<int>(100 * part);
    if (percent == shown_ || std::chrono::steady_clock::now() - start_ < std::chrono::seconds(1)) return;
    shown_ = percent;
    std::fprintf(stderr, "\r%s: %d %%", what_.c_str(), percent);
  }

 private:
  std::string what_;
  std::chrono::steady_clock::time_point start_;
  int shown_ = -1;  // percent
};

}  // namespace

std::function<void(double)> progress_on_terminal(std::string_view what) {
  if (isatty(STDERR_FILENO) == 0) return nullptr;
  return [line = std::make_shared<ProgressLine>(what)](double part) { line->show(part); };
}

}  // namespace sunder::cli
