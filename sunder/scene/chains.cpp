#include <sunder/base/contract.h>
#include <sunder/base/threads.h>
#include <sunder/scene/chains.h>

#include <algorithm>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <thread>
#include <utility>
#include <vector>

namespace sunder::scene {

namespace {

// Each thread takes what there is to do: first an end, so that places become free, then a chain, which it begins and
// runs.
class Chains {
 public:
  Chains(std::size_t places, const ChainWork& work) : work_(work), places_(places) {}

  void work() {
    std::unique_lock lock(mutex_);
    while (true) {
      if (can_end()) {
        end(lock);
      } else if (can_begin()) {
        begin_and_run(lock);
      } else if (is_over_ && first_ == next_) {
        return;
      } else {
        changed_.wait(lock);
      }
      changed_.notify_all();
    }
  }

  void rethrow() const {
    if (failure_) std::rethrow_exception(failure_);
  }

 private:
  struct Place {
    bool is_done = false;
    std::exception_ptr thrown{};
  };

  std::size_t place(std::uint64_t chain) const { return chain % places_.size(); }
  bool can_end() const { return !is_ending_ && first_ < next_ && places_[place(first_)].is_done; }
  bool can_begin() const { return !is_over_ && !is_beginning_ && next_ - first_ < places_.size(); }

  // Calls without the lock; returns what was thrown.
  template <class Call>
  static std::exception_ptr unlocked(std::unique_lock<std::mutex>& lock, const Call& call) {
    lock.unlock();
    std::exception_ptr thrown;
    try {
      call();
    } catch (...) {
      thrown = std::current_exception();
    }
    lock.lock();
    return thrown;
  }

  void end(std::unique_lock<std::mutex>& lock) {
    is_ending_ = true;
    const std::size_t at = place(first_);
    std::exception_ptr thrown = std::exchange(places_[at].thrown, nullptr);
    if (!is_enough_) {
      bool goes_on = false;
      if (!thrown) thrown = unlocked(lock, [&] { goes_on = work_.end(at); });
      failure_ = thrown;
      if (!goes_on) is_enough_ = is_over_ = true;
    }
    places_[at].is_done = false;
    ++first_;
    is_ending_ = false;
  }

  void begin_and_run(std::unique_lock<std::mutex>& lock) {
    is_beginning_ = true;
    const std::size_t at = place(next_);
    bool is_there = false;
    places_[at].thrown = unlocked(lock, [&] { is_there = work_.begin(at); });
    is_beginning_ = false;
    if (places_[at].thrown) {  // which is told in its turn
      is_over_ = places_[at].is_done = true;
      ++next_;
      return;
    }
    if (!is_there) {
      is_over_ = true;
      return;
    }
    ++next_;
    changed_.notify_all();
    if (!is_enough_) places_[at].thrown = unlocked(lock, [&] { work_.run(at); });
    places_[at].is_done = true;
  }

  const ChainWork& work_;
  std::mutex mutex_;  // of all below; begin, run and end are called without it
  std::condition_variable changed_;
  std::vector<Place> places_;
  std::uint64_t first_ = 0, next_ = 0;  // chains that have begun and not ended
  bool is_beginning_ = false, is_ending_ = false;
  bool is_over_ = false;    // there is no other chain to begin
  bool is_enough_ = false;  // nothing more is to be ended
  std::exception_ptr failure_;
};

void run_on_this_thread(const ChainWork& work) {
  while (work.begin(0)) {
    work.run(0);
    if (!work.end(0)) return;
  }
}

}  // namespace

std::size_t thread_count(std::uint64_t wish) {
  constexpr std::uint64_t most = 1024;
  const std::uint64_t cores = std::max(1u, std::thread::hardware_concurrency());
  return static_cast<std::size_t>(std::min(most, wish == 0 ? cores : wish));
}

std::size_t chain_places(std::size_t threads) { return threads < 2 ? 1 : 2 * threads + 1; }

void run_chains(std::size_t threads, const ChainWork& work) {
  SUNDER_REQUIRE(threads >= 1);
  if (threads == 1) return run_on_this_thread(work);
  Chains chains(chain_places(threads), work);
  on_threads(threads, [&] { chains.work(); });
  chains.rethrow();
}

}  // namespace sunder::scene
