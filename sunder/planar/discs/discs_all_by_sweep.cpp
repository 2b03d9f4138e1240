// A line sweeps from left to right over the boxes of discs. Of two boxes that meet, one enters while the line cuts the
// other: of these, those that it meets have a low ordinate not above its high one, and a high ordinate not below its
// low one. Numbered by their low ordinates, they are found from the first on by a tree of the high ones.
//
// The tree would find pairs of one group, too: where there are groups, boxes are halved instead.
//
// Boxes are rounded, which keeps their order: all pairs that meet are found; which do is decided about the discs.
#include <sunder/base/prefetch.h>
#include <sunder/near/set_methods.h>
#include <sunder/planar/discs/disc_boxes.h>
#include <sunder/planar/discs/discs_all.h>
#include <sunder/planar/sweep/keyed_order.h>
#include <sunder/planar/sweep/max_tree.h>

#include <algorithm>
#include <limits>

namespace sunder::planar {

namespace {

// The boxes in the order of a coordinate.
template <class Coordinate>
std::vector<KeyedItem> in_order(const std::vector<Box2>& boxes, const Coordinate& coordinate) {
  std::vector<KeyedItem> items;
  items.reserve(boxes.size());
  for (std::uint32_t i = 0; i < boxes.size(); ++i) items.push_back({key_of(coordinate(boxes[i])), i});
  sort_by_key(items, [](std::uint32_t i, std::uint32_t j) { return i < j; });
  return items;
}

// The boxes of discs from low to high, with the discs' numbers.
struct RankedBoxes {
  std::vector<std::uint32_t> number;
  std::vector<Box2> boxes;

  explicit RankedBoxes(const std::vector<Box2>& unordered) {
    number.reserve(unordered.size());
    boxes.reserve(unordered.size());
    for (const KeyedItem& e : in_order(unordered, [](const Box2& box) { return box.low.y; })) {
      number.push_back(e.item);
      boxes.push_back(unordered[e.item]);
    }
  }
};

}  // namespace

Cost discs_all_by_sweep(const Discs& circles, const SetOptions& options, const DiscsVisitor& visit) {
  check_groups(options.groups, circles.size());
  if (!options.groups.empty()) return visit_by_halving(circles, rounded_boxes(circles), options, visit);
  const RankedBoxes ranked(rounded_boxes(circles));
  const std::vector<Box2>& boxes = ranked.boxes;
  const std::vector<KeyedItem> begins = in_order(boxes, [](const Box2& box) { return box.low.x; });
  const std::vector<KeyedItem> ends = in_order(boxes, [](const Box2& box) { return box.high.x; });

  Cost cost;
  MaxTree line(circles.size());  // of the boxes that the line cuts, by rank: their high ordinates
  const auto test = pair_test(circles, options, cost, visit);
  std::size_t gone = 0;
  constexpr std::size_t ahead = 8;
  for (std::size_t k = 0; k < begins.size(); ++k) {
    tell_progress(options, k, k, begins.size());
    if (k + ahead < begins.size()) prefetch(boxes[begins[k + ahead].item]);
    for (; ends[gone].key < begins[k].key; ++gone) line.set(ends[gone].item, MaxTree::nothing);
    const std::uint32_t rank = begins[k].item, i = ranked.number[rank];
    const Box2& box = boxes[rank];
    const double low = std::max(box.low.y, std::numeric_limits<double>::lowest());  // no high ordinate is lower
    for (std::uint32_t r = line.next(0, low); r != MaxTree::none && boxes[r].low.y <= box.high.y;
         r = line.next(r + 1, low)) {
      const std::uint32_t j = ranked.number[r];
      if (!test(i, j)) return cost;
    }
    line.set(rank, box.high.y);
  }
  return cost;
}

}  // namespace sunder::planar
