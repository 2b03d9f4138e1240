// The rules that what is said of many bodies has been proved pair by pair: docs/claims.md, "each_pair" and
// "each_clearance".
#include <verifier/cpp/rules.h>

#include <algorithm>
#include <iterator>
#include <set>
#include <string>
#include <utility>

namespace sunder_verifier {
namespace {

IndexPair in_order(std::size_t i, std::size_t j) { return {std::min(i, j), std::max(i, j)}; }

// Looks at each two members of different groups, but for some: holds(a, b, is_listed).
template <class Holds>
void look_at_each(const char* rule, const Indices& members, const Groups& groups, const StatedContacts& except,
                  const StatedContacts& listed, const Holds& holds) {
  std::map<std::int64_t, std::vector<std::size_t>> of_group;
  for (std::size_t i = 0; i < members.size(); ++i) {
    of_group[groups.empty() ? static_cast<std::int64_t>(i) : groups[i]].push_back(i);
  }
  std::set<IndexPair> besides, left;
  for (const StatedContact& pair : except) besides.emplace(pair.i, pair.j);
  for (const StatedContact& contact : listed) left.emplace(contact.i, contact.j);
  const auto look_at = [&](std::size_t i, std::size_t j) {
    take_steps(4, 1, 1);
    const IndexPair pair = in_order(i, j);
    if (besides.contains(pair)) return;
    require(holds(members[i], members[j], left.erase(pair) > 0), rule,
            "of " + std::to_string(pair.first) + " and " + std::to_string(pair.second) + " this is not proved before");
  };
  for (auto first = of_group.begin(); first != of_group.end(); ++first) {
    for (auto second = std::next(first); second != of_group.end(); ++second) {
      for (const std::size_t i : first->second) {
        for (const std::size_t j : second->second) look_at(i, j);
      }
    }
  }
  require(left.empty(), rule, "a pair is listed that is not asked about");
}

void check_each_pair(const Indices& members, const Groups& groups, const StatedContacts& except,
                     const AllowedContacts& allowed, const Proved& proved, const StatedContacts& contacts) {
  look_at_each("each_pair", members, groups, except, contacts, [&](std::size_t a, std::size_t b, bool is_listed) {
    const auto is = [&](const char* verdict) { return proved.holds(a, b, verdict); };
    const bool may_touch = allowed.shared_endpoint;
    return is_listed ? is("overlapping") || (!may_touch && (is("touching") || is("meet")))
                     : is("apart") || (may_touch && is("touching"));
  });
}

void check_each_clearance(const Indices& members, const Groups& groups, const StatedContacts& except,
                          const Number& least, const Proved& proved, const StatedContacts& nearer) {
  look_at_each("each_clearance", members, groups, except, nearer, [&](std::size_t a, std::size_t b, bool is_listed) {
    return proved.holds(a, b, is_listed ? "broken" : "kept", least);
  });
}

}  // namespace

const ClaimRows claims_of_all_pairs{
    {"each_pair", "", rule<check_each_pair>},
    {"each_clearance", "", rule<check_each_clearance>},
};

}  // namespace sunder_verifier
