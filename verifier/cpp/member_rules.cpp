// The contacts of discs and of boxes, by a tree of boxes: docs/claims.md, "Covers".
#include <verifier/cpp/contacts.h>

#include <algorithm>

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

// A range of the order.
struct Node {
  PlanarBox box;
  Integer length;          // of the box's longer side
  std::int64_t group = 0;  // where it is of one group
  bool is_of_one_group = true;
  std::size_t member = 0;                     // where it is one
  std::size_t lower = 0, upper = 0;           // its halves
  bool is_one() const { return lower == 0; }  // the root, node 0, is no half
};

template <class Member>
class Cover {
 public:
  Cover(const Indices& order, const MemberTable<Member>& members, const Groups& groups)
      : order_(order), members_(members), groups_(groups) {
    if (!order.empty()) build(0, order.size());
  }

  // Calls take(i, j, kind), i < j, for each two members of different groups that meet.
  template <class Take>
  void visit(const Take& take) const {
    std::vector<std::pair<std::size_t, std::size_t>> left;
    if (!nodes_.empty()) left.emplace_back(0, 0);
    while (!left.empty()) {
      const auto [p, q] = left.back();
      left.pop_back();
      take_steps(1, members_.bits, members_.bits);
      const Node &a = nodes_[p], &b = nodes_[q];
      if (are_done(a, b)) continue;
      if (p == q) {
        left.emplace_back(a.lower, a.lower);
        left.emplace_back(a.lower, a.upper);
        left.emplace_back(a.upper, a.upper);
      } else if (!a.is_one() && (b.is_one() || a.length >= b.length)) {
        left.emplace_back(a.lower, q);
        left.emplace_back(a.upper, q);
      } else if (!b.is_one()) {
        left.emplace_back(p, b.lower);
        left.emplace_back(p, b.upper);
      } else {
        const auto [i, j] = std::minmax(a.member, b.member);
        const std::string kind = kind_of(members_[i], members_[j]);
        if (!kind.empty()) take(i, j, kind);
      }
    }
  }

 private:
  // They are of one group, or apart.
  static bool are_done(const Node& a, const Node& b) {
    return (a.is_of_one_group && b.is_of_one_group && a.group == b.group) || !meet(a.box, b.box);
  }

  std::size_t build(std::size_t begin, std::size_t end) {
    const std::size_t number = nodes_.size();
    nodes_.emplace_back();
    if (end - begin == 1) {
      Node& node = nodes_[number];
      node.member = order_[begin];
      node.box = box_of(members_[node.member]);
      node.group = groups_.empty() ? static_cast<std::int64_t>(node.member) : groups_[node.member];
    } else {
      const std::size_t middle = begin + (end - begin) / 2;
      const std::size_t lower = build(begin, middle), upper = build(middle, end);
      join(nodes_[number], nodes_[lower], nodes_[upper]);
      nodes_[number].lower = lower;
      nodes_[number].upper = upper;
    }
    Node& node = nodes_[number];
    const PlanarBox& box = node.box;
    node.length = std::max<Integer>(box.high_x - box.low_x, box.high_y - box.low_y);
    return number;
  }

  static void join(Node& node, const Node& a, const Node& b) {
    node.box = hull(a.box, b.box);
    node.group = a.group;
    node.is_of_one_group = a.is_of_one_group && b.is_of_one_group && a.group == b.group;
  }

  const Indices& order_;
  const MemberTable<Member>& members_;
  const Groups& groups_;
  std::vector<Node> nodes_;
};

template <class Member>
Contacts covered(const Indices& order, const MemberTable<Member>& members, const Groups& groups,
                 const AllowedContacts& allowed) {
  return counted_one_by_one([&](const VisitContact& visit) {
    Cover(order, members, groups).visit([&](std::size_t i, std::size_t j, const std::string& kind) {
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
