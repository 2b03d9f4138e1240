// Boxes around placed bodies: the cheap test before the question whether they meet, and its evidence.
// Also called: axis-aligned bounding box (AABB); bounding volume.
#pragma once

#include <sunder/base/error.h>
#include <sunder/certificate/pair.h>
#include <sunder/predicate/point.h>
#include <sunder/solid/round/round_body.h>
#include <sunder/solid/round/round_round.h>
#include <sunder/solid/search/extreme_vertex.h>

#include <array>
#include <cstdint>
#include <optional>

namespace sunder::solid {

// W1. low[k] <= coordinate k of every point of the placed body, exactly, <= high[k]; a bound that overflows is
//     infinite.
// W2. lowest[k] and highest[k] are vertices where the coordinate is exactly the least and the greatest.
// The bounds are within a few units in the last place of the numbers that are added up.
struct WorldBox : Box3 {
  std::array<std::uint32_t, 3> lowest{}, highest{};
};

// Cost: six walks over the vertex graph.
WorldBox world_box(const Placed& body);

// The same, where the body was in another place before, from the vertices of its box there on: where it has hardly
// moved, a look at each of them and at its neighbours. Requires that there are these vertices.
WorldBox world_box(const Placed& body, const WorldBox& near);

// A box that costs no walk, and is larger: that of the images of the corners of the body's own box. W1 holds.
Box3 rough_world_box(const Placed& body);

// Of bodies with a radius: those of their cores, and beyond them what the body reaches, rounded outwards; of a cylinder
// or a cone whose radius is k times its axis, k times as coarse. W1 holds; of
// W2, the vertices are of the core, and say nothing of the body.
WorldBox world_box(const PlacedRound& body);
Box3 rough_world_box(const PlacedRound& body);

// The same of any body; of a polyhedron without what only others need. Throw Error: bad_pose (round_body.h).
WorldBox world_box(const RoundBody& body, const Pose& pose);
Box3 rough_world_box(const RoundBody& body, const Pose& pose);

// Encloses coordinate k of the image.
Interval coordinate(std::size_t k, const Posed3& point);

// Where the boxes are apart, so are the bodies, as along one of +-x, +-y, +-z. Nothing where the
// boxes meet. Cost: at most six comparisons.
std::optional<Separation> apart_by_boxes(const WorldBox& a, const WorldBox& b);         // of polyhedra
std::optional<RoundEvidence> apart_by_boxes(const RoundBody& a, const WorldBox& box_a,  //
                                            const RoundBody& b, const WorldBox& box_b);

}  // namespace sunder::solid
