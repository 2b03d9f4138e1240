// Frames of nodes within nodes, as the files of scenes have them (COLLADA, glTF, VRML), and a bound for what instances
// make of a small file (of 3MF, too). For readers.
#pragma once

#include <sunder/base/error.h>
#include <sunder/predicate/point.h>

#include <array>
#include <cstddef>
#include <string_view>

namespace sunder::io {

// p goes to turn * p + move. Computed in doubles from left to right; where the frame is the identity, or only exchanges
// and reflects axes, points stay exact.
struct NodeFrame {
  std::array<double, 9> turn{1, 0, 0, 0, 1, 0, 0, 0, 1};  // row by row
  std::array<double, 3> move{0, 0, 0};

  Point3 operator()(const Point3& p) const;
};

// First `inner`, then `outer`.
NodeFrame compose(const NodeFrame& outer, const NodeFrame& inner);

NodeFrame moved_by(const std::array<double, 3>& by);
NodeFrame scaled_by(const std::array<double, 3>& factors);

// A turn about the axis, of any length but 0, by the angle: in degrees (multiples of 90 about an axis of coordinates
// are exact) or radians.
NodeFrame turned_by_degrees(const std::array<double, 3>& axis, double degrees);
NodeFrame turned_by_radians(const std::array<double, 3>& axis, double radians);

// The turn of the quaternion x, y, z, w, of any length but 0.
NodeFrame turned_by_quaternion(const std::array<double, 4>& xyzw);

// A file of n bytes may make this many vertices, corners and nodes in all; what is beyond it is refused, since
// instances of instances grow exponentially.
class InstanceBudget {
 public:
  static constexpr std::size_t per_byte = 32;

  // file: its name, for messages; must outlive the budget.
  InstanceBudget(std::size_t bytes, std::string_view file) : left_(bytes * per_byte), file_(file) {}

  // More bytes were read. Throws nothing.
  void add_bytes(std::size_t bytes) { left_ += bytes * per_byte; }

  // Throws Error bad_file where it is spent.
  void spend(std::size_t count);

 private:
  std::size_t left_;
  std::string_view file_;
};

}  // namespace sunder::io
