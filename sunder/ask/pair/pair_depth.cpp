// What sunder pair --depth tells.
#include <sunder/ask/evidence.h>
#include <sunder/ask/pair/pair_question.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace sunder::ask {

Point3 way_out(const WorldDirection& from_a_to_b) {
  const Vector3<Interval> d = from_a_to_b.enclosure();
  const Point3 middle{(d.x.low + d.x.high) / 2, (d.y.low + d.y.high) / 2, (d.z.low + d.z.high) / 2};
  const double greatest = std::max({std::fabs(middle.x), std::fabs(middle.y), std::fabs(middle.z)});
  const Point3 e{middle.x / greatest, middle.y / greatest, middle.z / greatest};
  const double length = std::sqrt(e.x * e.x + e.y * e.y + e.z * e.z);
  return {0.0 - e.x / length, 0.0 - e.y / length, 0.0 - e.z / length};
}

std::string depth_told(const Interval& depth, const std::string& way) {
  const auto [low, high] = depth;
  const std::string size = high == 0                      ? "0"
                           : high - low <= 0x1p-40 * high ? about_length(depth)
                                                          : fmt::format("between {:.12g} and {:.12g}", low, high);
  return fmt::format("{}, A to be moved along about {}", size, way);
}

Json depth_report(const Interval& depth, Json way) {
  return {{"low", depth.low}, {"high", depth.high}, {"direction_about", std::move(way)}};
}

}  // namespace sunder::ask
