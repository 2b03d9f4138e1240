#include <bench/inputs/segment_count.h>
#include <bench/inputs/set_count.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <vector>

namespace bench {
namespace {

__extension__ using Wide = __int128;

Wide whole(double v) {
  const double scaled = std::ldexp(v, 40);
  if (!(std::fabs(scaled) < 0x1p53) || scaled != std::nearbyint(scaled)) {
    throw std::logic_error("a number is not a multiple of 2^-40 below 2^13");
  }
  return static_cast<std::int64_t>(scaled);
}

struct Box {
  Xy low, high;
};

bool meet(const Box& a, const Box& b) {
  return a.low.x <= b.high.x && b.low.x <= a.high.x && a.low.y <= b.high.y && b.low.y <= a.high.y;
}

// Multiples of 2^-40 below 2^13: exact.
Box box_of(const Disc& d) {
  return {{d.center.x - d.radius, d.center.y - d.radius}, {d.center.x + d.radius, d.center.y + d.radius}};
}

Box box_of(const Ring& ring) {
  Box box{ring.front(), ring.front()};
  for (const Xy& p : ring) {
    box.low = {std::min(box.low.x, p.x), std::min(box.low.y, p.y)};
    box.high = {std::max(box.high.x, p.x), std::max(box.high.y, p.y)};
  }
  return box;
}

// Requires p not on the ring.
bool is_inside(const Ring& ring, const Xy& p) {
  bool inside = false;
  for (std::size_t i = 0, before = ring.size() - 1; i < ring.size(); before = i++) {
    const Xy &q = ring[before], &r = ring[i];
    if ((q.y <= p.y) == (r.y <= p.y)) continue;
    if (exact_turn(q, r, p) == (q.y < r.y ? 1 : -1)) inside = !inside;
  }
  return inside;
}

std::vector<Line> edges_in(const Ring& ring, const Box& box) {
  std::vector<Line> edges;
  for (std::size_t i = 0, before = ring.size() - 1; i < ring.size(); before = i++) {
    const Line edge{ring[before], ring[i]};
    if (meet(box_of(Ring{edge.a, edge.b}), box)) edges.push_back(edge);
  }
  return edges;
}

// Each pair of boxes that meet is looked at in the cell of the low corner of their common part.
template <class Object>
std::uint64_t count(std::span<const Object> objects) {
  if (objects.empty()) return 0;
  std::vector<Box> boxes;
  Box all = box_of(objects.front());
  double area = 0;
  for (const Object& object : objects) {
    const Box& box = boxes.emplace_back(box_of(object));
    all = {{std::min(all.low.x, box.low.x), std::min(all.low.y, box.low.y)},
           {std::max(all.high.x, box.high.x), std::max(all.high.y, box.high.y)}};
    area += (box.high.x - box.low.x) * (box.high.y - box.low.y);
  }
  const double n = static_cast<double>(objects.size());
  const double side = std::sqrt(std::max(area, (all.high.x - all.low.x) * (all.high.y - all.low.y)) / n);
  const auto column = [&](double x) { return static_cast<std::size_t>((x - all.low.x) / side); };
  const auto row = [&](double y) { return static_cast<std::size_t>((y - all.low.y) / side); };
  const std::size_t columns = column(all.high.x) + 1;
  std::vector<std::size_t> end(columns * (row(all.high.y) + 1) + 1);
  const auto for_cells = [&](const Box& box, const auto& of_cell) {
    for (std::size_t y = row(box.low.y); y <= row(box.high.y); ++y) {
      for (std::size_t x = column(box.low.x); x <= column(box.high.x); ++x) of_cell(y * columns + x);
    }
  };
  for (const Box& box : boxes) for_cells(box, [&](std::size_t cell) { ++end[cell + 1]; });
  for (std::size_t cell = 1; cell < end.size(); ++cell) end[cell] += end[cell - 1];
  std::vector<std::uint32_t> list(end.back());
  std::vector<std::size_t> at(end.begin(), end.end() - 1);
  for (std::uint32_t i = 0; i < boxes.size(); ++i) for_cells(boxes[i], [&](std::size_t cell) { list[at[cell]++] = i; });

  std::uint64_t pairs = 0;
  for (std::size_t cell = 0; cell + 1 < end.size(); ++cell) {
    for (std::size_t k = end[cell]; k < end[cell + 1]; ++k) {
      for (std::size_t l = end[cell]; l < k; ++l) {
        const Box &a = boxes[list[k]], &b = boxes[list[l]];
        if (!meet(a, b)) continue;
        const std::size_t looking = row(std::max(a.low.y, b.low.y)) * columns + column(std::max(a.low.x, b.low.x));
        pairs += looking == cell && exact_contact(objects[list[k]], objects[list[l]]);
      }
    }
  }
  return pairs;
}

}  // namespace

bool exact_contact(const Disc& a, const Disc& b) {
  const Wide dx = whole(a.center.x) - whole(b.center.x), dy = whole(a.center.y) - whole(b.center.y);
  const Wide reach = whole(a.radius) + whole(b.radius);
  return dx * dx + dy * dy <= reach * reach;
}

bool exact_contact(const Ring& a, const Ring& b) {
  const Box box_a = box_of(a), box_b = box_of(b);
  if (!meet(box_a, box_b)) return false;
  const std::vector<Line> of_b = edges_in(b, box_a);
  for (const Line& edge : edges_in(a, box_b)) {
    if (std::any_of(of_b.begin(), of_b.end(), [&](const Line& other) { return exact_contact(edge, other, false); })) {
      return true;
    }
  }
  return is_inside(a, b.front()) || is_inside(b, a.front());
}

std::uint64_t count_pairs(std::span<const Disc> discs) { return count(discs); }
std::uint64_t count_pairs(std::span<const Ring> rings) { return count(rings); }

}  // namespace bench
