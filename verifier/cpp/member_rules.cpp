// Contacts of the members of a set: docs/claims.md, "contact" and "cover".
#include <verifier/cpp/member_rules.h>
#include <verifier/cpp/reader.h>

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

bool counts(const std::string& kind, const AllowedContacts& allowed) {
  return kind != "touching" || !allowed.shared_endpoint;
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
  Cover(const std::vector<std::size_t>& order, const MemberTable<Member>& members,
        const std::vector<std::int64_t>& groups)
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

  const std::vector<std::size_t>& order_;
  const MemberTable<Member>& members_;
  const std::vector<std::int64_t>& groups_;
  std::vector<Node> nodes_;
};

template <class Member>
ContactsOf contacts_of(const Claim& claim, const MemberTable<Member>& members, const std::vector<std::int64_t>& groups,
                       const AllowedContacts& allowed) {
  return [&](const VisitContact& visit) {
    Cover(claim.order, members, groups).visit([&](std::size_t i, std::size_t j, const std::string& kind) {
      if (counts(kind, allowed)) visit(i, j, kind.c_str());
    });
  };
}

}  // namespace

Integers in_units(Numbers point, std::int64_t exponent) {
  for (Number& value : point) value.e -= exponent;
  return projective(point);
}

Integer power_of(const PlanarDisc& disc, const Integers& place) {
  return square(place[0] - disc.x * place[2]) + square(place[1] - disc.y * place[2]) - square(disc.r * place[2]);
}

PlanarBox box_of(const PlanarDisc& disc) {
  return {disc.x - disc.r, disc.y - disc.r, disc.x + disc.r, disc.y + disc.r};
}

bool holds(const PlanarDisc& disc, const Integers& place) { return power_of(disc, place) <= 0; }

std::string kind_of(const PlanarDisc& c, const PlanarDisc& d) {
  const Integer distance = square(c.x - d.x) + square(c.y - d.y);
  const int against_sum = distance.compare(square(c.r + d.r));
  if (against_sum >= 0) return against_sum == 0 ? "touching" : "";
  return distance > square(c.r - d.r) ? "overlapping" : "inside";
}

bool holds(const PlanarBox& box, const Integers& place) {
  const Integer &x = place[0], &y = place[1], &w = place[2];
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

bool is_kind_of_full(const std::string& kind) {
  return kind == "touching" || kind == "overlapping" || kind == "inside";
}

template <class Member>
void check_member_contact(const MemberTable<Member>& members, const StatedContact& contact, const Numbers& point,
                          const std::vector<std::int64_t>& groups, const AllowedContacts& allowed) {
  const auto& [i, j, kind] = contact;
  take_steps(16, length(point), members.bits);
  const Integers place = in_units(point, members.exponent);
  require(i != j && (groups.empty() || groups[i] != groups[j]), "contact",
          std::to_string(i) + " and " + std::to_string(j) + " are of one group");
  require(counts(kind, allowed), "contact", kind + " does not count");
  for (const std::size_t k : {i, j})
    require(holds(members[k], place), "contact", "the point is not in " + std::to_string(k));
  const std::string found = kind_of(members[i], members[j]);
  require(found == kind, "contact", "the contact is " + found);
}

template <class Member>
void check_cover(const Claim& claim, const MemberTable<Member>& members, const std::vector<std::int64_t>& groups,
                 const AllowedContacts& allowed, const std::vector<StatedContact>& listed) {
  check_listed("cover", contacts_of(claim, members, groups, allowed), listed);
}

template <class Member>
void check_cover_number(const Claim& claim, const MemberTable<Member>& members, const std::vector<std::int64_t>& groups,
                        const AllowedContacts& allowed, std::uint64_t number) {
  check_number("cover", number_of(contacts_of(claim, members, groups, allowed)), number);
}

#define SUNDER_RULES_OF(Member)                                                                                \
  template void check_member_contact(const MemberTable<Member>&, const StatedContact&, const Numbers&,         \
                                     const std::vector<std::int64_t>&, const AllowedContacts&);                \
  template void check_cover(const Claim&, const MemberTable<Member>&, const std::vector<std::int64_t>&,        \
                            const AllowedContacts&, const std::vector<StatedContact>&);                        \
  template void check_cover_number(const Claim&, const MemberTable<Member>&, const std::vector<std::int64_t>&, \
                                   const AllowedContacts&, std::uint64_t);
SUNDER_RULES_OF(PlanarDisc)
SUNDER_RULES_OF(PlanarBox)
#undef SUNDER_RULES_OF

}  // namespace sunder_verifier
