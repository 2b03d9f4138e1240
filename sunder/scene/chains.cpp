#include <sunder/base/contract.h>
#include <sunder/scene/chains.h>

#include <oneapi/tbb/global_control.h>
#include <oneapi/tbb/parallel_pipeline.h>
#include <oneapi/tbb/task_arena.h>

#include <algorithm>
#include <exception>
#include <limits>
#include <thread>
#include <utility>
#include <vector>

namespace sunder::scene {

namespace {

// A place, and what was thrown there.
struct Places {
  explicit Places(std::size_t count) : thrown(count) {}

  template <class Call>
  void keep(std::size_t place, const Call& call) {
    try {
      call();
    } catch (...) {
      thrown[place] = std::current_exception();
    }
  }

  std::vector<std::exception_ptr> thrown;
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
  namespace tbb = oneapi::tbb;
  const std::size_t count = chain_places(threads);
  Places places(count);
  // At most `count` chains are between the first filter and the last, both of which take them in order: so the place of
  // a chain is its number modulo that.
  std::size_t next = 0;
  bool is_over = false;
  const auto first = [&](tbb::flow_control& control) -> std::size_t {
    const std::size_t place = next;
    next = (next + 1) % count;
    bool is_there = false;
    if (!is_over) {
      places.keep(place, [&] { is_there = work.begin(place); });
      if (places.thrown[place]) is_over = is_there = true;  // to be thrown in its turn
    }
    if (!is_there) control.stop();
    return place;
  };
  const auto middle = [&](std::size_t place) {
    if (!places.thrown[place]) places.keep(place, [&] { work.run(place); });
    return place;
  };
  tbb::task_group_context context;
  bool is_enough = false;
  std::exception_ptr failure;
  const auto last = [&](std::size_t place) {
    const std::exception_ptr thrown = std::exchange(places.thrown[place], nullptr);
    if (is_enough) return;
    if (thrown) {
      failure = thrown;
      is_enough = true;
    } else {
      try {
        is_enough = !work.end(place);
      } catch (...) {
        failure = std::current_exception();
        is_enough = true;
      }
    }
    if (is_enough) context.cancel_group_execution();
  };
  const tbb::global_control control(tbb::global_control::max_allowed_parallelism, threads);
  tbb::task_arena arena(static_cast<int>(threads));
  arena.execute([&] {
    tbb::parallel_pipeline(count,
                           tbb::make_filter<void, std::size_t>(tbb::filter_mode::serial_in_order, first) &
                               tbb::make_filter<std::size_t, std::size_t>(tbb::filter_mode::parallel, middle) &
                               tbb::make_filter<std::size_t, void>(tbb::filter_mode::serial_in_order, last),
                           context);
  });
  if (failure) std::rethrow_exception(failure);
}

}  // namespace sunder::scene
