// From how two members meet to which contacts there are in a set: methods that every kind of member shares.
// Also called: all-pairs test; narrow phase over the candidate pairs of a broad phase.
//
// A set has size() and members [i], and can be made of a std::vector of some of them. Of two there is
// contact_kind(set, i, j), and counts(kind, allowed); of one, box_of() and lanes_box_of(), where boxes are asked for.
// A visitor takes a contact, and returns whether to go on.
#pragma once

#include <sunder/base/interruption.h>
#include <sunder/near/box_pairs.h>
#include <sunder/near/contacts_in_order.h>
#include <sunder/near/near_pairs.h>
#include <sunder/near/set_question.h>

#include <cstdint>
#include <optional>
#include <span>
#include <type_traits>
#include <utility>
#include <vector>

namespace sunder {

template <class Set>
using MemberOf = std::remove_cvref_t<decltype(std::declval<const Set&>()[0])>;
template <class Set>
using ContactIn = ContactOfTwo<decltype(contact_kind(std::declval<const Set&>(), 0u, 0u))>;

// Some of a set as a set of their own, with their groups.
template <class Set>
struct Subset {
  Subset(const Set& all, Groups all_groups, std::span<const std::uint32_t> numbers) : members(chosen(all, numbers)) {
    if (all_groups.empty()) return;
    for (const std::uint32_t i : numbers) groups.push_back(all_groups[i]);
  }

  Set members;
  std::vector<std::uint32_t> groups;

 private:
  static Set chosen(const Set& all, std::span<const std::uint32_t> numbers) {
    std::vector<MemberOf<Set>> some;
    some.reserve(numbers.size());
    for (const std::uint32_t i : numbers) some.push_back(all[i]);
    return Set(std::move(some));
  }
};

// Looks at pairs: hands those over that count. Each pair that is not of one group is a probe.
template <class Set, class Visit>
auto pair_test(const Set& set, const SetOptions& options, Cost& cost, const Visit& visit) {
  return [&](std::uint32_t i, std::uint32_t j) {
    may_be_interrupted(1);
    if (may_meet(options.groups, i, j)) return true;
    ++cost.probes;
    const auto kind = contact_kind(set, i, j);
    return !counts(kind, options.allowed) || visit(contact_of(i, j, kind));
  };
}

// Every pair, by i, then j: the oracle.
template <class Set, class Visit>
Cost visit_by_scan(const Set& set, const SetOptions& options, const Visit& visit) {
  check_groups(options.groups, set.size());
  Cost cost;
  const auto test = pair_test(set, options, cost, visit);
  for (std::uint32_t i = 0; i < set.size(); ++i) {
    for (std::uint32_t j = i + 1; j < set.size(); ++j) {
      if (!test(i, j)) return cost;
    }
  }
  return cost;
}

// By halving (box_pairs.h): for sets with groups. Cost: O(N log N + k) for k pairs of boxes that meet and are not of
// one group.
template <class Set, class Visit>
Cost visit_by_halving(const Set& set, std::span<const Box2> boxes, const SetOptions& options, const Visit& visit) {
  Cost cost;
  const auto test = pair_test(set, options, cost, visit);
  BoxPairsByHalving<decltype(test)> halving(boxes, test, options.groups);
  halving.run();
  cost.probes += halving.looks();
  return cost;
}

// By the grid over the members' boxes; where it does not pay, by_sweep(set, options, visitor), and where too many crowd
// in a cell, that lists the contacts of all of these, of which those are kept that a crowd is to look at.
template <class Set, class Boxed, class Visit, class BySweep>
Cost visit_by_grid(const Set& set, std::span<const Boxed> boxes, const std::optional<BoxGrid>& grid,
                   const SetOptions& options, const Visit& visit, const BySweep& by_sweep) {
  check_groups(options.groups, set.size());
  if (are_one_group(options.groups)) return Cost{set.size()};
  constexpr std::size_t crowd = crowd_for_all;
  if (!grid || is_too_much(*grid, crowd, set.size())) return by_sweep(set, options, visit);
  Cost cost;
  const auto test = pair_test(set, options, cost, visit);
  if (!for_each_near_pair<crowd>(boxes, *grid, test, options.progress, &cost)) return cost;
  const std::vector<std::uint32_t> numbers = members_of_crowds(*grid, crowd, set.size());
  if (numbers.empty()) return cost;
  const Subset<Set> part(set, options.groups, numbers);
  const auto of_crowd = [&](const ContactIn<Set>& contact) {
    const std::uint32_t i = numbers[contact.i], j = numbers[contact.j];
    const std::uint32_t c = grid->looking_cell(low_corner(boxes[i], boxes[j]));
    return grid->cell(c).size() <= crowd || visit(ContactIn<Set>{i, j, contact.kind});
  };
  cost.probes += by_sweep(part.members, SetOptions{options.allowed, part.groups}, of_crowd).probes;
  return cost;
}

// The same up to the first contact. by_sweep(set, options) gives an answer.
template <class Set, class Boxed, class BySweep>
AnyAnswer<ContactIn<Set>> any_by_grid(const Set& set, std::span<const Boxed> boxes, const std::optional<BoxGrid>& grid,
                                      const SetOptions& options, const BySweep& by_sweep) {
  check_groups(options.groups, set.size());
  if (are_one_group(options.groups)) return {{}, Cost{set.size()}};
  constexpr std::size_t crowd = crowd_for_any;
  if (!grid || is_too_much(*grid, crowd, set.size())) return by_sweep(set, options);
  AnyAnswer<ContactIn<Set>> answer = first_of<ContactIn<Set>>([&](const auto& visit) {
    Cost cost;
    for_each_near_pair<crowd>(boxes, *grid, pair_test(set, options, cost, visit), options.progress, &cost);
    return cost;
  });
  if (answer.meet()) return answer;
  const std::vector<std::uint32_t> numbers = members_of_crowds(*grid, crowd, set.size());
  if (numbers.empty()) return answer;
  const Subset<Set> part(set, options.groups, numbers);
  const AnyAnswer<ContactIn<Set>> in_crowd = by_sweep(part.members, SetOptions{options.allowed, part.groups});
  answer.cost.probes += in_crowd.cost.probes;
  if (in_crowd.meet()) {
    const auto [i, j, kind] = *in_crowd.found;
    answer.found = contact_of(numbers[i], numbers[j], kind);
  }
  return answer;
}

// The contacts whose i the block holds: of all members by_method(set, options, visitor), of a narrow block by boxes of
// its members, else those of the method that the block holds.
template <class Set, class Boxes, class Visit, class ByMethod>
Cost visit_of_block(const Set& set, const Boxes& boxes_of_set, const SetOptions& options, const Block& block,
                    const ByMethod& by_method, const Visit& visit) {
  if (block.size() == set.size()) return by_method(set, options, visit);
  if (!is_narrow(block, set.size())) {
    return by_method(set, options, [&](const ContactIn<Set>& c) { return !block.holds(c.i) || visit(c); });
  }
  Cost cost;
  const auto boxes = boxes_of_set(set);
  for_each_near_pair_of(block, std::span(boxes), pair_test(set, options, cost, visit));
  return cost;
}

}  // namespace sunder
