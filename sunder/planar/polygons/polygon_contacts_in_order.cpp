#include <sunder/base/contract.h>
#include <sunder/planar/polygons/polygon_contacts_in_order.h>

#include <algorithm>
#include <tuple>
#include <utility>

namespace sunder::planar {

bool LowestContacts::add(const PolygonsContact& c) {
  if (c.i >= end_ || !counts(c, allowed_)) return true;
  // Contacts along a border follow each other.
  const bool again = !held_.empty() && held_.back().i == c.i && held_.back().j == c.j &&
                     held_.back().contact == c.contact && held_.back().kind == c.kind;
  if (again) return true;
  held_.push_back(c);
  if (held_.size() >= full_) make_room();
  return true;
}

void LowestContacts::make_room() {
  const auto pair = [](const PolygonsContact& c) { return std::uint64_t{c.i} << 32 | c.j; };
  const auto tells_less = [](const PolygonsContact& c) {
    return c.contact == Relation::overlapping ? 0 : 8 - static_cast<int>(c.kind);
  };
  const auto before = [&](const PolygonsContact& a, const PolygonsContact& b) {
    if (pair(a) != pair(b)) return pair(a) < pair(b);  // mostly
    return std::tuple(tells_less(a), a.of_i, a.of_j) < std::tuple(tells_less(b), b.of_i, b.of_j);
  };
  const auto is_same = [&](const PolygonsContact& a, const PolygonsContact& b) { return pair(a) == pair(b); };
  std::sort(held_.begin(), held_.end(), before);
  held_.erase(std::unique(held_.begin(), held_.end(), is_same), held_.end());
  if (held_.size() > most_) {
    end_ = held_[most_].i;
    std::erase_if(held_, [&](const PolygonsContact& c) { return c.i >= end_; });
  }
  full_ = std::max(full_, std::min(2 * held_.size(), 2 * most_));
  held_.reserve(full_);
}

std::vector<PolygonsContact> LowestContacts::take_in_order() {
  make_room();
  return std::exchange(held_, {});
}

PolygonContactsInOrder::PolygonContactsInOrder(std::span<const Polygon> polygons, const SetOptions& options,
                                               PolygonsFinder* find, std::size_t most)
    : polygons_(polygons), options_(options), find_(find), most_(most) {
  SUNDER_REQUIRE(most_ > 0);
  check_groups(options.groups, polygons.size());
  const std::uint64_t size = polygons.size();
  for (std::uint64_t first = 0, width = size; first < size;) {
    Block block{static_cast<std::uint32_t>(first), static_cast<std::uint32_t>(std::min(size, first + width))};
    cost_.probes += ask(block).probes;
    for (const PolygonsContact& c : held_) ++(c.contact == Relation::touching ? touching_ : overlapping_);
    blocks_.push_back(block);
    width = std::uint64_t{4} * block.size();  // what is far beyond the next one's end need not be compared
    first = block.last;
  }
}

// What the block holds, in order. Of a block with too many it loses the end.
Cost PolygonContactsInOrder::ask(Block& block) {
  held_ = {};  // before as many are gathered
  SetOptions options = options_;
  if (!options.groups.empty()) options.groups = options.groups.subspan(block.first);
  LowestContacts found(block.size(), most_, options.allowed);
  const Cost cost = find_(polygons_.subspan(block.first), options, found);
  held_ = found.take_in_order();
  block.last = block.first + found.end();
  for (PolygonsContact& c : held_) {
    c.i += block.first;
    c.j += block.first;
  }
  return cost;
}

void PolygonContactsInOrder::visit(const Visitor& visitor) {
  const bool are_held = blocks_.size() <= 1;
  for (Block block : blocks_) {
    if (!are_held) ask(block);
    if (!std::all_of(held_.begin(), held_.end(), visitor)) return;
  }
}

}  // namespace sunder::planar
