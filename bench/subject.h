// The library under test, in the same kind of loop as its peers.
#pragma once

#include <cstdint>
#include <memory>

#include "peers/peer.h"

namespace bench {

// Sums over all queries of a scenario.
struct Tally {
  std::uint64_t filter = 0, evidence = 0, finishing = 0;  // how many answers came about in which way
  std::uint64_t probes = 0, iterations = 0, exact = 0;
};

class Subject : public Peer {
 public:
  // Untimed: answers all queries once more and adds up what they say.
  virtual Tally tally() const = 0;
};

// The front door, certificate included. Bodies and poses are prepared, answers are not kept.
std::unique_ptr<Subject> make_sunder(const Scenario&);

}  // namespace bench
