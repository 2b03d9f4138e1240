#include <sunder/scene/chains.h>

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

namespace sunder::scene {
namespace {

// Chains that square their numbers, some slowly, so that they end out of order.
class Squares {
 public:
  explicit Squares(std::uint64_t chains) : chains_(chains) {}

  std::uint64_t fails_to_begin = none, fails_to_run = none, fails_to_end = none, last_wanted = none;

  // The results, and then what was thrown.
  std::vector<std::string> run(std::size_t threads) {
    std::vector<std::uint64_t> at(chain_places(threads)), square(chain_places(threads));
    std::vector<std::string> told;
    std::atomic<int> in_end = 0;
    std::uint64_t next = 0;
    const auto fail_at = [](std::uint64_t number, std::uint64_t which, const char* what) {
      if (number == which) throw std::runtime_error(what + std::to_string(number));
    };
    try {
      run_chains(threads, {[&](std::size_t place) {
                             if (next == chains_) return false;
                             at[place] = next;
                             fail_at(next, fails_to_begin, "begin ");
                             ++next;
                             return true;
                           },
                           [&](std::size_t place) {
                             const std::uint64_t number = at[place];
                             const int now = ++running_;
                             for (int most = most_running;
                                  now > most && !most_running.compare_exchange_weak(most, now););
                             for (int wait = 0; wait < waits_for_two && most_running < 2; ++wait) {
                               std::this_thread::sleep_for(std::chrono::milliseconds(1));
                             }
                             if (number % 5 == 0) std::this_thread::sleep_for(std::chrono::microseconds(200));
                             square[place] = number * number;
                             --running_;
                             fail_at(number, fails_to_run, "run ");
                             if (number > fails_to_run) throw std::runtime_error("a later one");
                           },
                           [&](std::size_t place) {
                             EXPECT_EQ(++in_end, 1);
                             told.push_back(std::to_string(square[place]));
                             const std::uint64_t number = at[place];
                             --in_end;
                             fail_at(number, fails_to_end, "end ");
                             return number != last_wanted;
                           }});
    } catch (const std::runtime_error& error) {
      told.emplace_back(error.what());
    }
    return told;
  }

  std::atomic<int> most_running = 0;
  int waits_for_two = 0;  // milliseconds that a chain waits for another one to run beside it, at most
  static constexpr std::uint64_t none = ~std::uint64_t{0};

 private:
  std::uint64_t chains_;
  std::atomic<int> running_ = 0;
};

TEST(Chains, ComeInOrderOnAnyNumberOfThreads) {
  for (const std::uint64_t chains : {0u, 1u, 2u, 7u, 300u}) {
    Squares one(chains);
    const auto expected = one.run(1);
    ASSERT_EQ(expected.size(), chains);
    for (const std::size_t threads : {2u, 3u, 8u}) {
      Squares some(chains);
      some.waits_for_two = chains == 300 ? 10'000 : 0;
      ASSERT_EQ(some.run(threads), expected);
      EXPECT_LE(some.most_running, static_cast<int>(threads));
      if (chains == 300) {
        EXPECT_GE(some.most_running, 2);
      }
    }
  }
}

TEST(Chains, EndWhereNothingMoreIsWanted) {
  for (const std::size_t threads : {1u, 2u, 8u}) {
    Squares some(1000);
    some.last_wanted = 40;
    EXPECT_EQ(some.run(threads).size(), 41u) << threads;
  }
}

// C2: the first that fails, whatever fails after it.
TEST(Chains, CarryWhatIsThrown) {
  for (const std::size_t threads : {1u, 2u, 8u}) {
    Squares run(1000), begin(1000), end(1000), both(1000);
    run.fails_to_run = both.fails_to_run = 40;
    begin.fails_to_begin = 41;
    end.fails_to_end = 39;
    both.fails_to_begin = 42;
    const auto of_run = run.run(threads), of_begin = begin.run(threads), of_end = end.run(threads),
               of_both = both.run(threads);
    ASSERT_EQ(of_run.size(), 41u) << threads;
    EXPECT_EQ(of_run.back(), "run 40");
    ASSERT_EQ(of_begin.size(), 42u) << threads;
    EXPECT_EQ(of_begin.back(), "begin 41");
    ASSERT_EQ(of_end.size(), 41u) << threads;
    EXPECT_EQ(of_end.back(), "end 39");
    EXPECT_EQ(of_both, of_run);
  }
}

TEST(Chains, CountThreads) {
  EXPECT_GE(thread_count(0), 1u);
  EXPECT_EQ(thread_count(3), 3u);
  EXPECT_EQ(thread_count(~std::uint64_t{0}), 1024u);
}

}  // namespace
}  // namespace sunder::scene
