#include <sunder/near/cover_order.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <unordered_map>

namespace sunder {

namespace {

struct Entry {
  std::array<double, 4> at;  // low x, low y, high x, high y
  std::uint32_t member;
};

Entry entry_of(const Box2& box, std::uint32_t member) {
  return {{box.low.x, box.low.y, box.high.x, box.high.y}, member};
}

// The coordinate that differs most.
std::size_t widest(std::span<const Entry> boxes) {
  std::array<double, 4> low = boxes[0].at, high = low;
  for (const Entry& box : boxes) {
    for (std::size_t k = 0; k < 4; ++k) {
      low[k] = std::min(low[k], box.at[k]);
      high[k] = std::max(high[k], box.at[k]);
    }
  }
  std::size_t best = 0;
  double most = 0;
  for (std::size_t k = 0; k < 4; ++k) {
    const double spread = high[k] / 2 - low[k] / 2;  // not a number where all are infinite alike
    if (spread > most) {
      most = spread;
      best = k;
    }
  }
  return best;
}

void halve(std::span<Entry> boxes) {
  if (boxes.size() < 2) return;
  const std::size_t half = boxes.size() / 2, k = widest(boxes);
  const auto is_less = [k](const Entry& a, const Entry& b) {
    return a.at[k] != b.at[k] ? a.at[k] < b.at[k] : a.member < b.member;
  };
  std::nth_element(boxes.begin(), boxes.begin() + static_cast<std::ptrdiff_t>(half), boxes.end(), is_less);
  halve(boxes.first(half));
  halve(boxes.subspan(half));
}

// The same order, one group after the other, as their first members stand.
std::vector<std::uint32_t> by_group(std::span<const std::uint32_t> order, Groups groups) {
  std::unordered_map<std::uint32_t, std::vector<std::uint32_t>> members;
  std::vector<std::uint32_t> found, result;
  for (const std::uint32_t i : order) {
    std::vector<std::uint32_t>& group = members[groups[i]];
    if (group.empty()) found.push_back(groups[i]);
    group.push_back(i);
  }
  for (const std::uint32_t group : found) {
    result.insert(result.end(), members[group].begin(), members[group].end());
  }
  return result;
}

// The tree over an order. Node 0 is the root; the halves of a node stand behind it.
class CoverTree {
 public:
  CoverTree(std::span<const std::uint32_t> order, std::span<const Box2> boxes, Groups groups)
      : order_(order), boxes_(boxes), groups_(groups) {
    nodes_.reserve(2 * order.size());
    if (!order.empty()) build(0, order.size());
  }

  std::uint64_t looks(std::uint64_t most) const {
    if (nodes_.empty()) return 0;
    std::uint64_t looks = 0;
    for (std::vector<std::array<std::uint32_t, 2>> left{{0, 0}}; !left.empty() && looks < most; ++looks) {
      const auto [p, q] = left.back();
      left.pop_back();
      const Node &a = nodes_[p], &b = nodes_[q];
      if (is_done(a, b)) continue;
      if (p == q) {
        left.insert(left.end(), {{p + 1, p + 1}, {p + 1, a.upper}, {a.upper, a.upper}});
      } else if (!a.is_one() && (b.is_one() || a.length >= b.length)) {
        left.insert(left.end(), {{p + 1, q}, {a.upper, q}});
      } else if (!b.is_one()) {
        left.insert(left.end(), {{p, q + 1}, {p, b.upper}});
      }
    }
    return looks;
  }

 private:
  struct Node {
    std::array<double, 4> box;
    double length;        // of the longer side
    std::uint32_t group;  // where it is of one
    bool is_of_one_group;
    std::uint32_t upper = 0;  // its upper half; the lower one stands just behind it
    bool is_one() const { return upper == 0; }
  };

  static bool is_done(const Node& a, const Node& b) {
    return (a.is_of_one_group && b.is_of_one_group && a.group == b.group) || a.box[2] < b.box[0] ||
           b.box[2] < a.box[0] || a.box[3] < b.box[1] || b.box[3] < a.box[1];
  }

  std::uint32_t build(std::size_t begin, std::size_t end) {
    const auto number = static_cast<std::uint32_t>(nodes_.size());
    nodes_.emplace_back();
    Node node;
    if (end - begin == 1) {
      const std::uint32_t i = order_[begin];
      node.box = entry_of(boxes_[i], i).at;
      node.group = groups_.empty() ? i : groups_[i];
      node.is_of_one_group = true;
    } else {
      const std::size_t middle = begin + (end - begin) / 2;
      build(begin, middle);
      node.upper = build(middle, end);
      const Node &a = nodes_[number + 1], &b = nodes_[node.upper];
      for (const std::size_t k : {0u, 1u}) {
        node.box[k] = std::min(a.box[k], b.box[k]);
        node.box[k + 2] = std::max(a.box[k + 2], b.box[k + 2]);
      }
      node.group = a.group;
      node.is_of_one_group = a.is_of_one_group && b.is_of_one_group && a.group == b.group;
    }
    node.length = std::max(node.box[2] / 2 - node.box[0] / 2, node.box[3] / 2 - node.box[1] / 2);
    nodes_[number] = node;
    return number;
  }

  std::span<const std::uint32_t> order_;
  std::span<const Box2> boxes_;
  Groups groups_;
  std::vector<Node> nodes_;
};

}  // namespace

std::vector<std::uint32_t> cover_order(std::span<const Box2> boxes, Groups groups) {
  check_groups(groups, boxes.size());
  std::vector<Entry> sorted;
  sorted.reserve(boxes.size());
  for (std::uint32_t i = 0; i < boxes.size(); ++i) sorted.push_back(entry_of(boxes[i], i));
  halve(sorted);
  std::vector<std::uint32_t> order(sorted.size());
  std::transform(sorted.begin(), sorted.end(), order.begin(), [](const Entry& box) { return box.member; });
  if (groups.empty()) return order;
  std::vector<std::uint32_t> grouped = by_group(order, groups);
  const CoverTree one(order, boxes, groups), other(grouped, boxes, groups);
  for (std::uint64_t most = 16 * std::uint64_t{order.size()} + 1;;
       most *= 4) {  // what takes long for one may be short for the other
    const std::uint64_t a = one.looks(most), b = other.looks(most);
    if (a < most || b < most || most > 4096 * order.size()) return b < a ? grouped : order;
  }
}

std::uint64_t cover_looks(std::span<const std::uint32_t> order, std::span<const Box2> boxes, Groups groups,
                          std::uint64_t most) {
  return CoverTree(order, boxes, groups).looks(most);
}

}  // namespace sunder
