// What sunder pair --depth tells.
#include <sunder/ask/evidence.h>
#include <sunder/ask/pair/pair_space.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace sunder::ask {

namespace {

// The way that A is moved, back along the direction; of length 1, about.
Point3 way_out(const WorldDirection& from_a_to_b) {
  const Vector3<Interval> d = from_a_to_b.enclosure();
  const Point3 middle{(d.x.low + d.x.high) / 2, (d.y.low + d.y.high) / 2, (d.z.low + d.z.high) / 2};
  const double greatest = std::max({std::fabs(middle.x), std::fabs(middle.y), std::fabs(middle.z)});
  const Point3 e{middle.x / greatest, middle.y / greatest, middle.z / greatest};
  const double length = std::sqrt(e.x * e.x + e.y * e.y + e.z * e.z);
  return {0.0 - e.x / length, 0.0 - e.y / length, 0.0 - e.z / length};
}

}  // namespace

std::string depth_told(const Interval& depth, const WorldDirection& from_a_to_b) {
  const auto [low, high] = depth;
  const std::string size = high == 0                      ? "0"
                           : high - low <= 0x1p-40 * high ? about_length(depth)
                                                          : fmt::format("between {:.12g} and {:.12g}", low, high);
  return fmt::format("{}, A to be moved along about {}", size, about(way_out(from_a_to_b)));
}

Json depth_report(const Interval& depth, const WorldDirection& from_a_to_b) {
  return {{"low", depth.low}, {"high", depth.high}, {"direction_about", to_json(way_out(from_a_to_b))}};
}

}  // namespace sunder::ask
