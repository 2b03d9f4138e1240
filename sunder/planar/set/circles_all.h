// Which pairs of N circles with their insides, closed discs, meet, and how many are they?
//
//   P1. Each pair that has a contact whose kind counts, and whose discs are not of one group, is given once.
//   P2. The pairs given and their kinds do not depend on the method; their order does.
//   P3. The answer does not depend on the compiler.
// k is the number of pairs whose boxes meet, also of those that do not count: all contacts are among them.
// Source: Shamos & Hoey 1976, section VI (the question). That the list is complete is proved by an order
// (circles_any_json.h).
#pragma once

#include <sunder/base/cost.h>
#include <sunder/near/contacts_in_order.h>
#include <sunder/planar/object/circle.h>
#include <sunder/planar/set/circles_any.h>

#include <cstdint>
#include <functional>
#include <vector>

namespace sunder::planar {

using CirclesAllAnswer = AllAnswer<CirclesContact>;  // probes: pairs that were compared, also those of boxes in a cell
using CountAnswer = CountAnswer;                     // probes: the same

// The front doors: the fastest method measured.
CirclesAllAnswer circles_all(const Circles& circles, const SetOptions& options = {});
CountAnswer circles_count(const Circles& circles, const SetOptions& options = {});

// Calls for each contact, in the order of the method, until the visitor returns false.
using CirclesContactVisitor = std::function<bool(const CirclesContact&)>;
using CirclesContactMethod = Cost(const Circles& circles, const SetOptions& options,
                                  const CirclesContactVisitor& visit);

CirclesContactMethod visit_circle_contacts;  // the front door

// Those whose i the block holds, as visit_contacts_of_block.
Cost visit_circle_contacts_of_block(const Circles& circles, const SetOptions& options, const Block& block,
                                    CirclesContactMethod* by, const CirclesContactVisitor& visit);

// A uniform grid over the discs' boxes; where it does not pay, or many crowd in a cell, by sweep.
CirclesContactMethod visit_circle_contacts_by_grid;

// A line sweeps from left to right over the discs' boxes; a tree of greatest ordinates over those that it cuts finds
// the boxes that a new one meets. O((N + k) log N) time, O(N) memory; k pairs are compared.
CirclesContactMethod visit_circle_contacts_by_sweep;

// Every pair: the oracle, by i, then j. O(N^2) time.
CirclesContactMethod visit_circle_contacts_by_scan;

}  // namespace sunder::planar
