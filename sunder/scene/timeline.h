// Many placements of the same bodies, row after row: which meet in each, which are closer than they have to be, and
// which meet during the motion from each to the next?
// Also called: trajectory checking; batch collision checking; continuous monitoring.
//
// One runner, run_timeline, goes through the rows in chains of a fixed length (chains.h), with a follower that keeps
// what it knows from row to row. `Rows` is any type that has
//   std::size_t size() const
//   std::string name(std::size_t row) const     for errors, such as "FILE:7"
//   auto placer() const                         what one thread calls as placer(row, put): it calls put(part, pose) for
//                                               each part that moves, numbered through all bodies. May throw Error.
#pragma once

#include <sunder/base/error.h>
#include <sunder/base/interruption.h>
#include <sunder/scene/chains.h>
#include <sunder/scene/clearance.h>
#include <sunder/scene/clearance_follower.h>
#include <sunder/scene/follower.h>
#include <sunder/scene/scene.h>
#include <sunder/scene/sweep.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace sunder::scene {

// How near bodies are, besides whether they meet.
struct NearnessQuestion {
  std::optional<ClearanceQuestion> clearance{};
  bool nearest = false;                               // the nearest two parts
  std::vector<std::array<std::uint32_t, 2>> allowed;  // pairs of bodies that are never the nearest

  bool asks() const { return clearance || nearest; }
};

struct Nearness {
  std::optional<ClearanceAnswer> clearance;
  std::optional<PartDistance> nearest;  // nothing also where there are no two parts to be near

  // Is it known that none are closer?
  bool is_kept() const { return !clearance || (clearance->closer.empty() && clearance->undecided.empty()); }
};

// One row, and what was found; it holds until the follower is asked again.
struct Moment {
  std::span<const Body> bodies;  // where they are
  const Answer& meeting;
  Nearness near;
};

// Which meet in each row, and how near are they? As Follower and ClearanceFollower say; the nearest as nearest_parts.
class MomentFollower {
 public:
  static constexpr std::size_t rows_before = 0;

  // Requires and costs as these.
  MomentFollower(std::span<const Body> bodies, const Question& question, NearnessQuestion near = {});

  void place(std::uint32_t part, const solid::Pose& pose) { meeting_.place(part, pose); }
  Moment ask();
  void practise();  // asks what later answers are made of, and gives none

 private:
  Follower meeting_;
  NearnessQuestion near_;
  std::optional<ClearanceFollower> clearance_;
};

// Which meet during the motion from each row to the next? As meeting_on_the_way says.
class StepFollower {
 public:
  static constexpr std::size_t rows_before = 1;  // a step is between two rows

  StepFollower(std::span<const Body> bodies, const Question& question);

  void place(std::uint32_t part, const solid::Pose& pose) { members_->part(std::span(next_), part).pose = pose; }
  void begin() { last_ = next_; }  // the first row is placed
  SweptAnswer ask();               // from where the last answer left the bodies to where they are

 private:
  std::shared_ptr<const Members> members_;
  std::vector<Body> last_, next_;
  Question question_;
};

// Moves the bodies to where they are in a row. Throws Error with the row's name.
template <class Rows, class Placer, class Put>
void place_row(const Rows& rows, std::size_t row, Placer& placer, const Put& put) {
  try {
    placer(row, put);
  } catch (const Error& error) {
    throw Error(error.code(), error.what(), rows.name(row));
  }
}

// What a visitor says; one that returns nothing wants all.
template <class Visit, class... Seen>
bool goes_on(const Visit& visit, Seen&&... seen) {
  if constexpr (std::is_void_v<decltype(visit(std::forward<Seen>(seen)...))>) {
    visit(std::forward<Seen>(seen)...);
    return true;
  } else {
    return visit(std::forward<Seen>(seen)...);
  }
}

// Asks about each row (or about each step from a row to the next) on so many threads. All chains begin with a copy of
// `start`. visit(k, answer, found) sees row k, or the step from row k on, in any order but for those of a chain;
// `found`, a Found that was new at the beginning of its chain, is what it may write to. false: nothing later is wanted.
// end(found, asked) takes what a chain came to, one at a time, in order; `asked` rows or steps are done then. false:
// enough. Where one returns nothing, all are wanted. Returns how many were asked about.
//   T1. What `end` sees does not depend on the number of threads.
//   T2. Throws the Error of the first row that has one, named by rows.name; before that, all earlier chains have ended.
// Requires a thread. Memory: a follower and what was found for each place of chains.h. Allocates for a chain, not for a
// row, but for what the follower says.
template <class Found, class AnyFollower, class Rows, class Visit, class End>
std::size_t run_timeline(const AnyFollower& start, const Rows& rows, std::size_t threads, const Visit& visit,
                         const End& end) {
  struct Chain {
    AnyFollower follower;
    decltype(rows.placer()) placer;
    std::size_t begin = 0, end = 0;
    Found found{};
  };
  const std::size_t all = rows.size() - std::min(rows.size(), AnyFollower::rows_before);
  std::vector<std::unique_ptr<Chain>> chains(chain_places(threads));
  std::size_t next = 0, asked = 0;
  run_chains(threads, {[&](std::size_t place) {
                         if (next == all) return false;
                         std::unique_ptr<Chain>& chain = chains[place];
                         if (!chain) chain = std::make_unique<Chain>(Chain{start, rows.placer()});
                         chain->begin = next;
                         next = chain->end = std::min(next + chain_length, all);
                         return true;
                       },
                       [&](std::size_t place) {
                         Chain& chain = *chains[place];
                         const auto go_to = [&](std::size_t row) {
                           place_row(rows, row, chain.placer, [&](std::uint32_t part, const solid::Pose& pose) {
                             chain.follower.place(part, pose);
                           });
                         };
                         chain.follower = start;
                         chain.found = Found{};
                         if constexpr (AnyFollower::rows_before == 1) {
                           go_to(chain.begin);
                           chain.follower.begin();
                         }
                         for (std::size_t k = chain.begin; k < chain.end; ++k) {
                           may_be_interrupted(100);
                           go_to(k + AnyFollower::rows_before);
                           if (!goes_on(visit, k, chain.follower.ask(), chain.found)) chain.end = k + 1;
                         }
                       },
                       [&](std::size_t place) {
                         asked = chains[place]->end;
                         return goes_on(end, chains[place]->found, asked);
                       }});
  return asked;
}

// The follower as the first chain leaves it, where there are several: what it knows of other placements mostly serves.
// It is the same for any number of threads.
template <class Rows>
MomentFollower practised(MomentFollower follower, const Rows& rows) {
  if (rows.size() < 4 * chain_length) return follower;
  auto placer = rows.placer();
  try {
    for (std::size_t k = 0; k < chain_length; ++k) {
      placer(k, [&](std::uint32_t part, const solid::Pose& pose) { follower.place(part, pose); });
      follower.practise();
    }
  } catch (const Error&) {  // which is told in its turn
  }
  return follower;
}

}  // namespace sunder::scene
