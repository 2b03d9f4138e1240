#include <sunder/ask/progress.h>
#include <sunder/ask/report.h>

#include <unistd.h>

#include <cstdio>

namespace sunder::ask {

Progress::Progress(std::string_view what) : what_(what), start_(std::chrono::steady_clock::now()) {}

Progress::~Progress() {
  if (shown_ >= 0) std::fputs("\r\033[K", stderr);
}

std::function<void(double)> Progress::reporter() {
  if (isatty(STDERR_FILENO) == 0 || is_quiet()) return nullptr;
  return [this](double part) { report(part); };
}

void Progress::report(double part) {
  const int percent = static_cast<int>(100 * part);
  if (percent == shown_ || std::chrono::steady_clock::now() - start_ < std::chrono::seconds(1)) return;
  shown_ = percent;
  std::fprintf(stderr, "\r%s: %d %%", what_.c_str(), percent);
}

}  // namespace sunder::ask
