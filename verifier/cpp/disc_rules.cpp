// Contacts of discs: docs/claims.md, "contact" and "cover".
#include <verifier/cpp/reader.h>
#include <verifier/cpp/rules.h>

#include <algorithm>

namespace sunder_verifier {
namespace {

Integer square(const Integer& n) { return n * n; }

// How two discs meet; empty where they do not.
std::string kind_of(const PlanarDisc& c, const PlanarDisc& d) {
  const Integer distance = square(c.x - d.x) + square(c.y - d.y);
  const int against_sum = distance.compare(square(c.r + d.r));
  if (against_sum >= 0) return against_sum == 0 ? "touching" : "";
  return distance > square(c.r - d.r) ? "overlapping" : "inside";
}

bool counts(const std::string& kind, const AllowedContacts& allowed) {
  return kind != "touching" || !allowed.shared_endpoint;
}

// x, y, w, in units of the discs.
Integers in_units(Numbers point, const Tables& tables) {
  for (Number& value : point) value.e -= tables.circle_exponent;
  return projective(point);
}

// Positive: the point is outside.
Integer power_of(const PlanarDisc& disc, const Integers& place) {
  return square(place[0] - disc.x * place[2]) + square(place[1] - disc.y * place[2]) - square(disc.r * place[2]);
}

// A range of the order.
struct Node {
  Integer low_x, low_y, high_x, high_y;  // its box
  Integer length;                        // of the box's longer side
  std::int64_t group = 0;                // where it is of one group
  bool is_of_one_group = true;
  std::size_t disc = 0;                       // where it is one disc
  std::size_t lower = 0, upper = 0;           // its halves
  bool is_one() const { return lower == 0; }  // the root, node 0, is no half
};

class Cover {
 public:
  Cover(const std::vector<std::size_t>& order, const Tables& tables, const std::vector<std::int64_t>& groups)
      : order_(order), tables_(tables), groups_(groups) {
    if (!order.empty()) build(0, order.size());
  }

  // Calls take(i, j, kind), i < j, for each two discs of different groups that meet.
  template <class Take>
  void visit(const Take& take) const {
    std::vector<std::pair<std::size_t, std::size_t>> left;
    if (!nodes_.empty()) left.emplace_back(0, 0);
    while (!left.empty()) {
      const auto [p, q] = left.back();
      left.pop_back();
      take_steps(1, tables_.circle_bits, tables_.circle_bits);
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
        const auto [i, j] = std::minmax(a.disc, b.disc);
        const std::string kind = kind_of(tables_.circles[i], tables_.circles[j]);
        if (!kind.empty()) take(i, j, kind);
      }
    }
  }

 private:
  // They are of one group, or apart.
  static bool are_done(const Node& a, const Node& b) {
    return (a.is_of_one_group && b.is_of_one_group && a.group == b.group) || a.high_x < b.low_x || b.high_x < a.low_x ||
           a.high_y < b.low_y || b.high_y < a.low_y;
  }

  std::size_t build(std::size_t begin, std::size_t end) {
    const std::size_t number = nodes_.size();
    nodes_.emplace_back();
    if (end - begin == 1) {
      Node& node = nodes_[number];
      node.disc = order_[begin];
      const PlanarDisc& disc = tables_.circles[node.disc];
      node.low_x = disc.x - disc.r;
      node.low_y = disc.y - disc.r;
      node.high_x = disc.x + disc.r;
      node.high_y = disc.y + disc.r;
      node.group = groups_.empty() ? static_cast<std::int64_t>(node.disc) : groups_[node.disc];
    } else {
      const std::size_t middle = begin + (end - begin) / 2;
      const std::size_t lower = build(begin, middle), upper = build(middle, end);
      join(nodes_[number], nodes_[lower], nodes_[upper]);
      nodes_[number].lower = lower;
      nodes_[number].upper = upper;
    }
    Node& node = nodes_[number];
    node.length = std::max<Integer>(node.high_x - node.low_x, node.high_y - node.low_y);
    return number;
  }

  static void join(Node& node, const Node& a, const Node& b) {
    node.low_x = std::min(a.low_x, b.low_x);
    node.low_y = std::min(a.low_y, b.low_y);
    node.high_x = std::max(a.high_x, b.high_x);
    node.high_y = std::max(a.high_y, b.high_y);
    node.group = a.group;
    node.is_of_one_group = a.is_of_one_group && b.is_of_one_group && a.group == b.group;
  }

  const std::vector<std::size_t>& order_;
  const Tables& tables_;
  const std::vector<std::int64_t>& groups_;
  std::vector<Node> nodes_;
};

}  // namespace

void check_disc_contact(const Tables& tables, const StatedContact& contact, const Numbers& point,
                        const std::vector<std::int64_t>& groups, const AllowedContacts& allowed) {
  const auto& [i, j, kind] = contact;
  take_steps(16, length(point), tables.circle_bits);
  const Integers place = in_units(point, tables);
  require(i != j && (groups.empty() || groups[i] != groups[j]), "contact",
          std::to_string(i) + " and " + std::to_string(j) + " are of one group");
  require(counts(kind, allowed), "contact", kind + " does not count");
  for (const std::size_t k : {i, j}) {
    const PlanarDisc& disc = tables.circles[k];
    require(power_of(disc, place) <= 0, "contact", "the point is not in " + std::to_string(k));
  }
  const std::string found = kind_of(tables.circles[i], tables.circles[j]);
  require(found == kind, "contact", "the contact is " + found);
}

void check_no_entries(const Tables& tables) { require(tables.circles.empty(), "no_entries", "there are entries"); }

void check_in_discs(const Tables& tables, const Numbers& point, bool is_region) {
  const std::size_t bits = length(point) + tables.circle_bits;
  take_steps(4 * tables.circles.size(), bits, bits);
  const Integers place = in_units(point, tables);
  for (std::size_t k = 0; k < tables.circles.size(); ++k) {
    const int power = power_of(tables.circles[k], place).sign();
    require(power < 0 || (power == 0 && !is_region), "in_discs",
            "the point is not inside of circle " + std::to_string(k));
  }
}

void check_powers(const Claim& claim, const Tables& tables, bool is_point) {
  const Integers weights = positive_weights(claim.weights, [](std::size_t) { return 0; });
  Integer total = 0, x = 0, y = 0, rest = 0;
  for (std::size_t k = 0; k < weights.size(); ++k) {
    const PlanarDisc& disc = tables.circles[claim.weights.named[k]];
    total += weights[k];
    x += weights[k] * disc.x;
    y += weights[k] * disc.y;
    rest += weights[k] * (square(disc.x) + square(disc.y) - square(disc.r));
  }
  const Integer least = total * rest - square(x) - square(y);  // of the mean of the powers, times the total squared
  require(least > 0 || (is_point && least == 0), "powers", "the mean of the powers is not as it must be");
}

namespace {

ContactsOf contacts_of_discs(const Claim& claim, const Tables& tables, const std::vector<std::int64_t>& groups,
                             const AllowedContacts& allowed) {
  return [&](const VisitContact& visit) {
    Cover(claim.order, tables, groups).visit([&](std::size_t i, std::size_t j, const std::string& kind) {
      if (counts(kind, allowed)) visit(i, j, kind.c_str());
    });
  };
}

}  // namespace

void check_cover(const Claim& claim, const Tables& tables, const std::vector<std::int64_t>& groups,
                 const AllowedContacts& allowed, const std::vector<StatedContact>& listed) {
  check_listed("cover", contacts_of_discs(claim, tables, groups, allowed), listed);
}

void check_cover_number(const Claim& claim, const Tables& tables, const std::vector<std::int64_t>& groups,
                        const AllowedContacts& allowed, std::uint64_t number) {
  check_number("cover", contacts_of_discs(claim, tables, groups, allowed), number);
}

}  // namespace sunder_verifier
