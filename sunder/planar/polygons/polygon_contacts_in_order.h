// The contacts of a set of polygons in the order of i, then j, without holding more of them than a stated number.
//
// As contacts_in_order.h, but a pair may be found any number of times, and that which tells most last. So contacts
// cannot be counted as they come: those of the lowest polygons are kept, each pair once, and the rest is asked for
// again.
#pragma once

#include <sunder/near/contacts_in_order.h>
#include <sunder/planar/polygons/polygons_any.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

namespace sunder::planar {

// Takes contacts that count, and keeps those of the lowest i, of each pair what tells most: overlapping before
// touching, of the latter the greatest kind. Of more that tell as much, some one.
class LowestContacts {
 public:
  // Of pairs whose i is below `end`. Holds 2 * most at any time. Requires that no polygon meets more than `most`.
  LowestContacts(std::uint32_t end, std::size_t most, Allowed allowed) : end_(end), most_(most), allowed_(allowed) {}

  // True, for finders that go on as long as it is.
  bool add(const PolygonsContact& c);
  void forget() { held_.clear(); }

  // Pairs whose i is below this are complete when all have been added. It falls where more are added than may be held,
  // also when they are taken.
  const std::uint32_t& end() const { return end_; }
  std::vector<PolygonsContact> take_in_order();  // at most `most`

 private:
  void make_room();

  std::uint32_t end_;
  std::size_t most_;
  Allowed allowed_;
  std::vector<PolygonsContact> held_;
  std::size_t full_ = 1 << 8;
};

// Adds the contacts of all pairs whose i is below found.end().
using PolygonsFinder = Cost(std::span<const Polygon> polygons, const SetOptions& options, LowestContacts& found);
PolygonsFinder find_contacts_by_boxes, find_contacts_by_grid, find_contacts_by_sweep, find_contacts_by_scan;

constexpr std::size_t most_polygon_contacts_held(std::size_t size) {
  return std::max(std::size_t{1} << 18, 8 * size);  // memory stays O(N)
}

// In a set of N, let k be the number of pairs that count.
//   P1. At most 2 * most contacts are held at any time, of 20 bytes each, besides what the finder takes.
//   P2. Each pair is handed over once, in order; whether it touches or overlaps, and the kind of a touching one, are
//       those of polygons_all. Which edges show it may differ.
// Where all may be held they are asked for once; else twice for each block of i: in all at most some 3 k / most + log N
// times, of which those by boxes compare the pairs of the block only, and others look at all that stand behind it too.
class PolygonContactsInOrder {
 public:
  using Visitor = std::function<bool(const PolygonsContact&)>;

  // Asks for all, and counts them. Keeps the polygons, and the groups of the options. Requires that `most` is at least
  // twice N.
  PolygonContactsInOrder(std::span<const Polygon> polygons, const SetOptions& options, PolygonsFinder* find,
                         std::size_t most);
  PolygonContactsInOrder(std::span<const Polygon> polygons, const SetOptions& options, PolygonsFinder* find)
      : PolygonContactsInOrder(polygons, options, find, most_polygon_contacts_held(polygons.size())) {}

  std::uint64_t touching() const { return touching_; }
  std::uint64_t overlapping() const { return overlapping_; }
  const Cost& cost() const { return cost_; }  // of asking once for each block

  // Calls until the visitor returns false.
  void visit(const Visitor& visitor);

 private:
  Cost ask(Block& block);

  std::span<const Polygon> polygons_;
  SetOptions options_;
  PolygonsFinder* find_;
  std::size_t most_;
  std::uint64_t touching_ = 0, overlapping_ = 0;
  Cost cost_;
  std::vector<Block> blocks_;
  std::vector<PolygonsContact> held_;  // of one block
};

}  // namespace sunder::planar
