#include <sunder/base/lanes.h>
#include <sunder/number/interval.h>
#include <sunder/number/rounded.h>
#include <sunder/predicate/point/along.h>
#include <sunder/solid/round/world_box.h>
#include <sunder/solid/search/support.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <utility>

namespace sunder::solid {

Interval coordinate(std::size_t k, const Posed3& point) {
  const auto& m = point.pose->linear;
  const Point3& p = point.point;
  if (point.tame) {
    const auto at = (leaf(m[3 * k]) * leaf(p.x) + leaf(m[3 * k + 1]) * leaf(p.y)) +
                    (leaf(m[3 * k + 2]) * leaf(p.z) + leaf(point.pose->translation[k]));
    // The value is not greater than the magnitude; so two units more pay for the rounding of its sum with the error.
    const double error = (decltype(at)::bound + 0x1p-52) * at.magnitude;
    return {at.value - error, at.value + error};
  }
  return (Interval(m[3 * k]) * p.x + Interval(m[3 * k + 1]) * p.y) +
         (Interval(m[3 * k + 2]) * p.z + Interval(point.pose->translation[k]));
}

namespace {

Point3 axis(std::size_t k) { return {k == 0 ? 1.0 : 0.0, k == 1 ? 1.0 : 0.0, k == 2 ? 1.0 : 0.0}; }

}  // namespace

WorldBox world_box(const Placed& body) { return world_box(body, {}); }

WorldBox world_box(const Placed& body, const WorldBox& near) {
  WorldBox box;
  Cost cost;
  StageTally tally;
  for (std::size_t k = 0; k < 3; ++k) {
    const WorldDirection direction(axis(k));
    Along along(direction, body.pose, body.tame);
    const double* const row = &body.pose.linear[3 * k];
    const std::uint32_t low = support_near(body.graph, {-row[0], -row[1], -row[2]}, near.lowest[k], cost.probes);
    const std::uint32_t high = support_near(body.graph, {row[0], row[1], row[2]}, near.highest[k], cost.probes);
    box.lowest[k] = extreme_vertex_from(body, along, End::least, low, cost, tally);
    box.highest[k] = extreme_vertex_from(body, along, End::greatest, high, cost, tally);
    box.low[k] = coordinate(k, body[box.lowest[k]]).low;
    box.high[k] = coordinate(k, body[box.highest[k]]).high;
  }
  return box;
}

namespace {

// The image of the body's own box, taken as a middle m and halves h: along each axis of the world that of m, and as
// much to both sides as |linear| h. No entry times a coordinate is more than `size`, nor is a number of the
// translation, and a half is at most twice the greatest coordinate. The rest is for the rounding of `size` and of the
// last two sums. A sum of two coordinates is zero, or hardly smaller than the least of them: so nothing underflows
// where images are tame.
Box3 rough_box_in_doubles(const Placed& body) {
  const Point3 &low = body.graph.low, &high = body.graph.high;
  Point3 m, h;
  for (std::size_t j = 0; j < 3; ++j) {
    m[j] = 0.5 * (low[j] + high[j]);
    h[j] = std::max(high[j] - m[j], m[j] - low[j]) * (1 + 0x1p-51);
  }
  std::array<double, 3> low_ends, high_ends;
  for (std::size_t k = 0; k < 3; ++k) {
    const double* const row = &body.pose.linear[3 * k];
    const auto size = [&](std::size_t j) { return leaf(std::fabs(row[j])); };
    const auto middle = (leaf(row[0]) * leaf(m.x) + leaf(row[1]) * leaf(m.y)) +
                        (leaf(row[2]) * leaf(m.z) + leaf(body.pose.translation[k]));
    const auto half = (size(0) * leaf(h.x) + size(1) * leaf(h.y)) + size(2) * leaf(h.z);
    constexpr double error = (4 * decltype(middle)::bound + 6 * decltype(half)::bound + 24 * 0x1p-53) * (1 + 0x1p-40);
    const double reach = half.value + error * body.size;
    low_ends[k] = middle.value - reach;
    high_ends[k] = middle.value + reach;
  }
  static_assert(sizeof(Box3) == 3 * sizeof(Lanes));  // stored as it will be copied
  return std::bit_cast<Box3>(std::array<Lanes, 3>{Lanes{low_ends[0], low_ends[1]}, Lanes{low_ends[2], high_ends[0]},
                                                  Lanes{high_ends[1], high_ends[2]}});
}

}  // namespace

Box3 rough_world_box(const Placed& body) {
  if (body.tame && body.graph.sizes.greatest <= 0x1p1021) return rough_box_in_doubles(body);  // sums do not overflow
  Box3 box;
  for (std::size_t k = 0; k < 3; ++k) {
    // Along an axis of the world a corner is furthest that each axis of the body alone takes furthest.
    const Point3 &low = body.graph.low, &high = body.graph.high;
    Point3 least = low, greatest = high;
    for (std::size_t j = 0; j < 3; ++j) {
      if (body.pose.linear[3 * k + j] < 0) std::swap(least[j], greatest[j]);
    }
    box.low[k] = coordinate(k, {least, &body.pose, false}).low;
    box.high[k] = coordinate(k, {greatest, &body.pose, false}).high;
  }
  return box;
}

std::optional<Separation> apart_by_boxes(const WorldBox& a, const WorldBox& b) {
  for (std::size_t k = 0; k < 3; ++k) {
    const bool up = a.high[k] < b.low[k];
    if (!up && !(b.high[k] < a.low[k])) continue;
    const Point3 d = axis(k);
    return Separation{{.given = up ? d : Point3{0 - d.x, 0 - d.y, 0 - d.z}},
                      up ? a.highest[k] : a.lowest[k],
                      up ? b.lowest[k] : b.highest[k]};
  }
  return std::nullopt;
}

}  // namespace sunder::solid
