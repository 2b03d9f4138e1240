// Do two placed convex polyhedra meet that met, or were apart, a moment ago? The question of polyhedron_polyhedron.h,
// from the last answer on.
// Also called: warm start; temporal coherence; caching of separating axes.
//
// P1, P2 and P3 of polyhedron_polyhedron.h hold whatever the last answer was of: other placements, other bodies even.
// What one might assume and does not hold: the evidence, not the verdict, depends on what was asked before; so do the
// counts.
#pragma once

#include <sunder/certificate/pair_answer.h>
#include <sunder/solid/object/convex_polyhedron.h>
#include <sunder/solid/object/pose.h>

#include <array>
#include <cstddef>
#include <cstdint>

namespace sunder::solid {

// What answers leave to the next one about the same two bodies: plain data.
struct WarmStart {
  enum class Kind : std::uint8_t { none, apart, meet };

  // A direction that parted them: as the frame of A sees it (Placed::pulled), rounded; and the extreme vertices.
  struct Parting {
    Point3 direction{};
    std::uint32_t extreme_a = 0, extreme_b = 0;
  };
  static constexpr std::size_t most_partings = 2;

  Kind kind = Kind::none;                         // of the last answer
  std::uint8_t count_a = 0, count_b = 0;          // as in CommonVertices; meaningless but for `meet`
  std::uint8_t partings_count = 0;                // how many of the partings there are
  std::array<std::uint32_t, 5> vertices{};        // meet: as in CommonVertices; else meaningless
  std::array<Parting, most_partings> partings{};  // the one that held last is first
};

// From `last` on, which becomes what this answer leaves. Of bodies that were apart the direction is kept in the frame
// of A, with which it turns, so that A's extreme vertex stays, and looked at from the extreme vertices on; of bodies
// that met the vertices are kept, and their weights solved for again. Where that does not hold, by the search of
// polyhedron_polyhedron_by_gjk, from its beginning: a direction that has just failed is no better one (measured).
// Cost: where the evidence holds, a walk on each body of as many steps as its extreme vertex is away, mostly none; else
// that of polyhedron_polyhedron_by_gjk besides.
PairAnswer polyhedron_polyhedron_warm(const ConvexPolyhedron& a, const Pose& pose_a,  //
                                      const ConvexPolyhedron& b, const Pose& pose_b, WarmStart& last);

}  // namespace sunder::solid
