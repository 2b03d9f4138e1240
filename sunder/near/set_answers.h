// From how two members meet to any, all, count and visit: what a new kind of set gets for nothing.
//
// Of a set, besides what set_methods.h asks for, there is boxes_of(set): the boxes of its members, each of which holds
// its member, or rounded so that boxes of members that meet, meet.
//   P1. Each pair whose contact counts, and that is not of one group, is given once; in any order.
// Cost: O(N log N + k) for k pairs of boxes that meet and are not of one group (box_pairs.h). Probes: boxes looked at,
// and pairs.
#pragma once

#include <sunder/near/box_pairs.h>
#include <sunder/near/set_methods.h>

#include <cstdint>
#include <functional>
#include <span>

namespace sunder {

template <class Set>
using ContactVisitor = std::function<bool(const ContactIn<Set>&)>;

template <class Set>
Cost contacts_visit(const Set& set, const SetOptions& options, const ContactVisitor<Set>& visit) {
  check_groups(options.groups, set.size());
  Cost cost;
  std::uint64_t looks = 0;
  const auto& boxes = boxes_of(set);
  for_each_box_pair(std::span(boxes), pair_test(set, options, cost, visit), options.progress, &looks, options.groups);
  cost.probes += looks;
  return cost;
}

// Every pair: the oracle.
template <class Set>
Cost contacts_visit_by_scan(const Set& set, const SetOptions& options, const ContactVisitor<Set>& visit) {
  return visit_by_scan(set, options, visit);
}

template <class Set>
AnyAnswer<ContactIn<Set>> contacts_any(const Set& set, const SetOptions& options = {}) {
  return first_of<ContactIn<Set>>([&](const auto& visit) { return contacts_visit<Set>(set, options, visit); });
}

template <class Set>
AllAnswer<ContactIn<Set>> contacts_all(const Set& set, const SetOptions& options = {}) {
  return all_of<ContactIn<Set>>([&](const auto& visit) { return contacts_visit<Set>(set, options, visit); });
}

template <class Set>
CountAnswer<> contacts_count(const Set& set, const SetOptions& options = {}) {
  return count_of<ContactIn<Set>>([&](const auto& visit) { return contacts_visit<Set>(set, options, visit); });
}

}  // namespace sunder
