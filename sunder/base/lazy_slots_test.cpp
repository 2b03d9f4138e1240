#include <sunder/base/lazy_slots.h>
#include <sunder/base/threads.h>

#include <gtest/gtest.h>

#include <array>
#include <atomic>
#include <cstddef>
#include <memory>
#include <stdexcept>
#include <thread>

namespace sunder {
namespace {

TEST(LazySlots, MakeOnceAndKeep) {
  LazySlots slots;
  int made = 0;
  const auto make = [&] { return ++made * 10; };
  const int& first = slots.get<int>(0, make);
  EXPECT_EQ(first, 10);
  EXPECT_EQ(&slots.get<int>(0, make), &first);
  EXPECT_EQ(slots.get<double>(LazySlots::count - 1, [] { return 0.5; }), 0.5);
  EXPECT_EQ(made, 1);
}

TEST(LazySlots, MakeAgainAfterAnException) {
  LazySlots slots;
  int asked = 0;
  const auto make = [&] {
    if (++asked == 1) throw std::runtime_error("none");
    return asked;
  };
  EXPECT_THROW(slots.get<int>(3, make), std::runtime_error);
  EXPECT_EQ(slots.get<int>(3, make), 2);
}

// One is made of another, and both end with their slots.
TEST(LazySlots, AskForOthersAndEnd) {
  const auto counted = std::make_shared<int>(7);
  {
    LazySlots slots;
    slots.get<std::shared_ptr<int>>(1, [&] { return slots.get<std::shared_ptr<int>>(2, [&] { return counted; }); });
    EXPECT_EQ(counted.use_count(), 3);
  }
  EXPECT_EQ(counted.use_count(), 1);
}

// In each round all threads ask for all slots, in orders of their own.
TEST(LazySlots, MakeOnceForAllThreads) {
  constexpr std::size_t threads = 4, rounds = 50;
  for (std::size_t round = 0; round < rounds; ++round) {
    const LazySlots slots;
    std::array<std::atomic<int>, LazySlots::count> made{};
    std::array<std::array<const std::size_t*, LazySlots::count>, threads> found{};
    std::atomic<std::size_t> there{0};
    on_threads(threads, [&] {
      const std::size_t self = there++;
      while (there.load() < threads) std::this_thread::yield();
      for (std::size_t k = 0; k < LazySlots::count; ++k) {
        const std::size_t slot = (k + self / 2) % LazySlots::count;
        found[self][slot] = &slots.get<std::size_t>(slot, [&] {
          ++made[slot];
          for (int wait = 0; wait < 20; ++wait) std::this_thread::yield();  // others ask meanwhile
          return slot;
        });
      }
    });
    for (std::size_t slot = 0; slot < LazySlots::count; ++slot) {
      EXPECT_EQ(made[slot].load(), 1);
      EXPECT_EQ(*found[0][slot], slot);
      for (const auto& of_thread : found) EXPECT_EQ(of_thread[slot], found[0][slot]);
    }
  }
}

}  // namespace
}  // namespace sunder
