// Work in chains, on several threads: what is long is cut into pieces of a fixed length, which begin anew, so that
// nothing in a piece depends on how many threads there are.
// Also called: parallel pipeline; ordered reduction.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>

namespace sunder::scene {

// How many placements are in a chain: the first of them starts cold.
inline constexpr std::size_t chain_length = 64;

// How many threads are meant: 0 is all cores, as far as the system tells, and at least one.
std::size_t thread_count(std::uint64_t wish);

struct ChainWork {
  // A place for the next chain, in order; false: there is no other. One at a time.
  std::function<bool(std::size_t place)> begin;
  // The chain in this place. Several at once, in any order.
  std::function<void(std::size_t place)> run;
  // What it came to, in order; false: nothing more is wanted. One at a time.
  std::function<bool(std::size_t place)> end;
};

// How many chains there are at once, at most: places are less than that. What is kept by places has to have room for
// all of them before: to make more while chains run would move what others look at.
std::size_t chain_places(std::size_t threads);

// Runs the chains on so many threads. Between begin and end a place belongs to one chain alone; so memory is bounded
// by the places, whatever the number of chains. On one thread: begin, run, end, one chain after another.
//   C1. The calls of `end`, and what they see, do not depend on the number of threads; after it has said false, it is
//       not called again.
//   C2. What `run` of a chain throws is thrown in the stead of its `end`: so it is the first chain's that throws. What
//       begin and end throw is thrown, too; of begin after the ends of all chains before.
// Requires a thread.
void run_chains(std::size_t threads, const ChainWork& work);

}  // namespace sunder::scene
