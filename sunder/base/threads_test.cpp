#include <sunder/base/threads.h>

#include <gtest/gtest.h>

#include <condition_variable>
#include <cstddef>
#include <mutex>
#include <set>
#include <thread>

namespace sunder {
namespace {

// Each waits for the others, so they are there at once.
TEST(OnThreads, DoesTheWorkOnEachOnce) {
  for (const std::size_t count : {1u, 2u, 5u}) {
    std::mutex mutex;
    std::condition_variable all_there;
    std::set<std::thread::id> threads;
    on_threads(count, [&] {
      std::unique_lock lock(mutex);
      EXPECT_TRUE(threads.insert(std::this_thread::get_id()).second);
      all_there.notify_all();
      all_there.wait(lock, [&] { return threads.size() == count; });
    });
    EXPECT_EQ(threads.size(), count);
    EXPECT_TRUE(threads.contains(std::this_thread::get_id()));
  }
}

}  // namespace
}  // namespace sunder
