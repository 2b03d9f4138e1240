// The contacts of discs and of boxes, by a tree of boxes: docs/claims.md, "Covers".
#include <verifier/cpp/contacts.h>

#include <algorithm>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace sunder_verifier {
namespace {

bool meet(const PlanarBox& a, const PlanarBox& b) {
  return a.low_x <= b.high_x && b.low_x <= a.high_x && a.low_y <= b.high_y && b.low_y <= a.high_y;
}

// The least box that holds both.
PlanarBox hull(const PlanarBox& a, const PlanarBox& b) {
  return {std::min(a.low_x, b.low_x), std::min(a.low_y, b.low_y), std::max(a.high_x, b.high_x),
          std::max(a.high_y, b.high_y)};
}

PlanarBox box_of(const PlanarBox& box) { return box; }

PlanarBox box_of(const PlanarDisc& disc) {
  return {disc.x - disc.r, disc.y - disc.r, disc.x + disc.r, disc.y + disc.r};
}

// A range of the order, and its halves.
struct Node {
  PlanarBox box;
  Integer length;                     // of the box's longer side
  std::optional<std::int64_t> group;  // where it is of one group
  std::size_t member = 0;             // where it is one
  std::unique_ptr<const Node> lower, upper;
};

template <class Member>
std::unique_ptr<const Node> tree_of(std::span<const std::size_t> order, const MemberTable<Member>& members,
                                    const Groups& groups) {
  auto node = std::make_unique<Node>();
  if (order.size() == 1) {
    node->member = order[0];
    node->box = box_of(members[order[0]]);
    node->group = groups.empty() ? static_cast<std::int64_t>(order[0]) : groups[order[0]];
  } else {
    const std::size_t half = order.size() / 2;
    node->lower = tree_of(order.first(half), members, groups);
    node->upper = tree_of(order.subspan(half), members, groups);
    node->box = hull(node->lower->box, node->upper->box);
    if (node->lower->group == node->upper->group) node->group = node->lower->group;
  }
  node->length = std::max<Integer>(node->box.high_x - node->box.low_x, node->box.high_y - node->box.low_y);
  return node;
}

// Calls take(i, j, kind), i < j, for each two members of different groups that meet.
template <class Member, class Take>
void visit_meetings(const Indices& order, const MemberTable<Member>& members, const Groups& groups, const Take& take) {
  if (order.empty()) return;
  const auto root = tree_of<Member>(order, members, groups);
  std::vector<std::pair<const Node*, const Node*>> left{{root.get(), root.get()}};
  while (!left.empty()) {
    const Node &a = *left.back().first, &b = *left.back().second;
    left.pop_back();
    take_steps(1, members.bits, members.bits);
    if ((a.group && a.group == b.group) || !meet(a.box, b.box)) continue;
    if (&a == &b) {
      left.insert(left.end(),
                  {{a.lower.get(), a.lower.get()}, {a.lower.get(), a.upper.get()}, {a.upper.get(), a.upper.get()}});
    } else if (a.lower && (!b.lower || a.length >= b.length)) {
      left.insert(left.end(), {{a.lower.get(), &b}, {a.upper.get(), &b}});
    } else if (b.lower) {
      left.insert(left.end(), {{&a, b.lower.get()}, {&a, b.upper.get()}});
    } else {
      const auto [i, j] = std::minmax(a.member, b.member);
      const std::string kind = kind_of(members[i], members[j]);
      if (!kind.empty()) take(i, j, kind);
    }
  }
}

template <class Member>
Contacts covered(const Indices& order, const MemberTable<Member>& members, const Groups& groups,
                 const AllowedContacts& allowed) {
  return counted_one_by_one([&](const VisitContact& visit) {
    visit_meetings(order, members, groups, [&](std::size_t i, std::size_t j, const std::string& kind) {
      if (counts(kind, allowed)) visit(i, j, kind.c_str());
    });
  });
}

}  // namespace

Integer power_of(const PlanarDisc& disc, const SweepPoint& place) {
  return square(place.x - disc.x * place.w) + square(place.y - disc.y * place.w) - square(disc.r * place.w);
}

bool holds(const PlanarDisc& disc, const SweepPoint& place) { return power_of(disc, place) <= 0; }

std::string kind_of(const PlanarDisc& c, const PlanarDisc& d) {
  const Integer distance = square(c.x - d.x) + square(c.y - d.y);
  const int against_sum = distance.compare(square(c.r + d.r));
  if (against_sum >= 0) return against_sum == 0 ? "touching" : "";
  return distance > square(c.r - d.r) ? "overlapping" : "inside";
}

bool holds(const PlanarBox& box, const SweepPoint& place) {
  const auto& [x, y, w] = place;
  return box.low_x * w <= x && x <= box.high_x * w && box.low_y * w <= y && y <= box.high_y * w;
}

std::string kind_of(const PlanarBox& a, const PlanarBox& b) {
  if (!meet(a, b)) return "";
  const bool touch_in_x = (a.low_x == b.high_x) != (b.low_x == a.high_x);  // both, where they are one number
  const bool touch_in_y = (a.low_y == b.high_y) != (b.low_y == a.high_y);
  if (touch_in_x || touch_in_y) return "touching";
  const PlanarBox all = hull(a, b);
  return all == a || all == b ? "inside" : "overlapping";
}

Contacts contacts_of(const Indices& order, const Circles& circles, const Groups& groups,
                     const AllowedContacts& allowed) {
  return covered(order, circles, groups, allowed);
}

Contacts contacts_of(const Indices& order, const Boxes& boxes, const Groups& groups, const AllowedContacts& allowed) {
  return covered(order, boxes, groups, allowed);
}

}  // namespace sunder_verifier
