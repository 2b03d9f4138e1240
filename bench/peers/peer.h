// What is compared: one interface, so that every library answers the same queries in the same kind of loop.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string_view>

#include "../scenarios.h"

namespace bench {

// One way of asking one library whether the pairs of one scenario meet. Everything that a library can prepare - shapes,
// transforms, first guesses - is prepared by the maker, outside of the timed loop; run() is the loop.
class Peer {
 public:
  virtual ~Peer() = default;

  // Peers of one library compete: the fastest counts.
  virtual std::string_view library() const = 0;
  virtual std::string_view method() const = 0;

  // Answers all queries in order: meets[i] = 1 or 0. Requires meets.size() == the number of queries.
  virtual void run(std::span<std::uint8_t> meets) = 0;
};

// Counter-clockwise triangles of the hull of points of which all are extreme, by Qhull: peers that want faces get them
// from here, so that they do not depend on the library that they are compared with.
std::vector<std::array<std::uint32_t, 3>> triangles_by_qhull(const std::vector<Vec>& points);

// FCL with libccd: through the public front door fcl::collide, asking for no contacts.
std::unique_ptr<Peer> make_fcl_collide(const Scenario&);
// FCL with libccd: its solver called directly, without the dispatch and bookkeeping of fcl::collide.
std::unique_ptr<Peer> make_fcl_solver(const Scenario&);

// Bullet in double precision: btGjkEpaSolver2::Distance, which is its GJK plus the closest points where apart.
std::unique_ptr<Peer> make_bullet_distance(const Scenario&);
// btGjkEpaSolver2::Penetration without margins: the same GJK plus its EPA where they meet.
std::unique_ptr<Peer> make_bullet_penetration(const Scenario&);
// btGjkPairDetector with btVoronoiSimplexSolver: the path of Bullet's own convex-convex collision algorithm.
std::unique_ptr<Peer> make_bullet_detector(const Scenario&);

}  // namespace bench
