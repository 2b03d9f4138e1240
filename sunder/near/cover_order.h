// In which order do the halves of a set, their halves, and so on, lie apart from each other, as far as may be? Evidence
// of which members meet (docs/claims.md, "Covers"): whatever the order is, it proves the contacts; a good one does so
// with few looks.
// Also called: order of the leaves of a bounding volume hierarchy (BVH), a box tree.
#pragma once

#include <sunder/near/set_question.h>
#include <sunder/predicate/point.h>

#include <cstdint>
#include <span>
#include <vector>

namespace sunder {

// Boxes may be rounded, and their ends infinite, but not NaN; fewer than 2^31. The numbers of all, each once. Halves
// are made at the median of the coordinate of the boxes, of all four, that differs most. Groups, where there are any,
// stand one after the other if a checker then looks at fewer pairs. Cost: O(N log N) time, O(N) memory; with groups
// also that of a few checks.
std::vector<std::uint32_t> cover_order(std::span<const Box2> boxes, Groups groups = {});

// How many pairs of nodes a checker looks at that is told this order, were the boxes as rounded; at most `most`.
std::uint64_t cover_looks(std::span<const std::uint32_t> order, std::span<const Box2> boxes, Groups groups,
                          std::uint64_t most);

}  // namespace sunder
