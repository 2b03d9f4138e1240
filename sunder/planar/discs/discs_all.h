// Which pairs of N circles with their insides, closed discs, meet, and how many are they?
// Also called: disk intersection reporting and counting.
//
//   P1. Each pair that has a contact whose kind counts, and whose discs are not of one group, is given once.
//   P2. The pairs given and their kinds do not depend on the method; their order does.
//   P3. The answer does not depend on the compiler.
// k is the number of pairs whose boxes meet and that are not of one group: all contacts are among them.
// Throws Error bad_call where there are groups, and not one for each disc. Else none throws, but for want of
// memory, or what `progress` or a visitor throws.
// Source: Shamos & Hoey 1976, section VI (the question). That the list is complete is proved by an order
// (discs_any_claims.h).
#pragma once

#include <sunder/base/cost.h>
#include <sunder/base/error.h>
#include <sunder/near/contacts_in_order.h>
#include <sunder/planar/discs/discs_any.h>
#include <sunder/planar/object/discs.h>

#include <cstdint>
#include <functional>
#include <vector>

namespace sunder::planar {

// Probes, also of a CountAnswer: pairs that were compared, those of boxes in a cell too.
using DiscsAllAnswer = AllAnswer<DiscsContact>;

// The front doors: the fastest method measured, by grid. Cost: O((N + k) log N) at most; counting holds no contacts.
DiscsAllAnswer discs_all(const Discs& circles, const SetOptions& options = {});
CountAnswer<> discs_count(const Discs& circles, const SetOptions& options = {});

// Calls for each contact, in the order of the method, until the visitor returns false.
using DiscsVisitor = std::function<bool(const DiscsContact&)>;
using DiscsMethod = Cost(const Discs& circles, const SetOptions& options, const DiscsVisitor& visit);

DiscsMethod discs_visit;  // the front door

// Those whose i the block holds, as segments_visit_block.
Cost discs_visit_block(const Discs& circles, const SetOptions& options, const Block& block, DiscsMethod* by,
                       const DiscsVisitor& visit);

// A uniform grid over the discs' boxes; where it does not pay, or many crowd in a cell, by sweep.
DiscsMethod discs_all_by_grid;

// A line sweeps from left to right over the discs' boxes; a tree of greatest ordinates over those that it cuts finds
// the boxes that a new one meets. O((N + k) log N) time, O(N) memory; k pairs are compared. Where there are groups,
// boxes are halved (box_pairs.h): O(N log N + k).
DiscsMethod discs_all_by_sweep;

// Every pair: the oracle, by i, then j. O(N^2) time.
DiscsMethod discs_all_by_scan;

}  // namespace sunder::planar
