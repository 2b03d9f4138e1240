#include <sunder/io/mesh/frame_internal.h>
#include <sunder/io/text/text.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace sunder::io {

namespace {

// Of an axis of any finite length but 0, without overflow.
std::array<double, 3> unit(std::array<double, 3> axis) {
  const double largest = std::max({std::abs(axis[0]), std::abs(axis[1]), std::abs(axis[2])});
  for (double& entry : axis) entry /= largest;
  const double length = std::hypot(axis[0], axis[1], axis[2]);
  for (double& entry : axis) entry /= length;
  return axis;
}

// Rodrigues' formula.
NodeFrame turn_of(const std::array<double, 3>& axis, double cosine, double sine) {
  const auto [x, y, z] = unit(axis);
  const double rest = 1 - cosine;
  NodeFrame frame;
  frame.turn = {cosine + x * x * rest,   x * y * rest - z * sine, x * z * rest + y * sine,
                y * x * rest + z * sine, cosine + y * y * rest,   y * z * rest - x * sine,
                z * x * rest - y * sine, z * y * rest + x * sine, cosine + z * z * rest};
  return frame;
}

}  // namespace

Point3 NodeFrame::operator()(const Point3& p) const {
  return {turn[0] * p.x + turn[1] * p.y + turn[2] * p.z + move[0],
          turn[3] * p.x + turn[4] * p.y + turn[5] * p.z + move[1],
          turn[6] * p.x + turn[7] * p.y + turn[8] * p.z + move[2]};
}

NodeFrame compose(const NodeFrame& outer, const NodeFrame& inner) {
  NodeFrame both;
  for (std::size_t row = 0; row < 3; ++row) {
    for (std::size_t column = 0; column < 3; ++column) {
      both.turn[3 * row + column] = outer.turn[3 * row] * inner.turn[column] +
                                    outer.turn[3 * row + 1] * inner.turn[3 + column] +
                                    outer.turn[3 * row + 2] * inner.turn[6 + column];
    }
    both.move[row] = outer.turn[3 * row] * inner.move[0] + outer.turn[3 * row + 1] * inner.move[1] +
                     outer.turn[3 * row + 2] * inner.move[2] + outer.move[row];
  }
  return both;
}

NodeFrame moved_by(const std::array<double, 3>& by) {
  NodeFrame frame;
  frame.move = by;
  return frame;
}

NodeFrame scaled_by(const std::array<double, 3>& factors) {
  NodeFrame frame;
  frame.turn = {factors[0], 0, 0, 0, factors[1], 0, 0, 0, factors[2]};
  return frame;
}

NodeFrame turned_by_degrees(const std::array<double, 3>& axis, double degrees) {
  constexpr std::array<double, 4> sines{0, 1, 0, -1};
  const double rest = std::fmod(degrees, 360);  // exact
  if (std::fmod(rest, 90) == 0) {
    const auto quarter = static_cast<std::size_t>(static_cast<int>(rest) / 90 + 4) % 4;
    return turn_of(axis, sines[(quarter + 1) % 4], sines[quarter]);
  }
  return turned_by_radians(axis, rest * (3.14159265358979323846 / 180));
}

NodeFrame turned_by_radians(const std::array<double, 3>& axis, double radians) {
  return turn_of(axis, std::cos(radians), std::sin(radians));
}

NodeFrame turned_by_quaternion(const std::array<double, 4>& xyzw) {
  std::array<double, 4> q = xyzw;
  double largest = 0;
  for (const double entry : q) largest = std::max(largest, std::abs(entry));
  for (double& entry : q) entry /= largest;
  const auto [x, y, z, w] = q;
  const double s = 2 / (x * x + y * y + z * z + w * w);
  NodeFrame frame;
  frame.turn = {1 - s * (y * y + z * z), s * (x * y - z * w),     s * (x * z + y * w),
                s * (x * y + z * w),     1 - s * (x * x + z * z), s * (y * z - x * w),
                s * (x * z - y * w),     s * (y * z + x * w),     1 - s * (x * x + y * y)};
  return frame;
}

void InstanceBudget::spend(std::size_t count) {
  if (count > left_) {
    fail_file(file_, fmt::format("its instances make more than {} vertices, corners and nodes a byte of the file; "
                                 "export the mesh without instances",
                                 per_byte));
  }
  left_ -= count;
}

}  // namespace sunder::io
