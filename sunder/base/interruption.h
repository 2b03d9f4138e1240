// How a question that takes long is ended from outside, as by Ctrl-C in Python.
#pragma once

#include <cstdint>
#include <functional>

namespace sunder {

// While it lives, `check` is called on this thread, while a question works, about every 10 milliseconds (never, where
// all that is done takes less). What it throws comes out of the question, whose objects stay as they were. Of those
// that live at once on a thread, the last one counts. Other threads that work for the question do not call it.
class Interruptible {
 public:
  explicit Interruptible(std::function<void()> check);
  ~Interruptible();
  Interruptible(const Interruptible&) = delete;
  Interruptible& operator=(const Interruptible&) = delete;

 private:
  friend void may_be_interrupted(std::uint32_t work);

  std::function<void()> check_;
  std::int64_t left_;  // the work until the next check
  Interruptible* before_;
};

// Called by loops that may run long: in units of about a tenth of a microsecond, the work since the last call. Where no
// Interruptible lives it costs a load and a branch.
void may_be_interrupted(std::uint32_t work);

namespace interruption_detail {
inline constinit thread_local Interruptible* current = nullptr;
}

inline void may_be_interrupted(std::uint32_t work) {
  Interruptible* const current = interruption_detail::current;
  if (current == nullptr || (current->left_ -= work) > 0) return;
  constexpr std::int64_t between = 100'000;
  current->left_ = between;
  current->check_();
}

}  // namespace sunder
