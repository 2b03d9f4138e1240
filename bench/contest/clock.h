// The benchmarks' clock.
#pragma once

#include <ctime>

namespace bench {

// Seconds of processor time that this thread has used, in the kernel too: on a shared machine, being put aside for
// another process does not count. All contestants run in the thread that asks.
inline double thread_seconds() {
  std::timespec t{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

}  // namespace bench
