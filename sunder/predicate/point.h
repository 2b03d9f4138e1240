// Points as plain numbers, and the plain numbers of a pose. No invariant: objects check their coordinates when made.
#pragma once

#include <array>

namespace sunder {

struct Point2 {
  double x = 0, y = 0;
  friend bool operator==(const Point2&, const Point2&) = default;
};

struct Point3 {
  double x = 0, y = 0, z = 0;
  friend bool operator==(const Point3&, const Point3&) = default;
};

// Affine maps of the plane and of space, x -> linear x + translation.
struct Affine2 {
  std::array<double, 4> linear{1, 0, 0, 1};  // row by row
  std::array<double, 2> translation{0, 0};
  friend bool operator==(const Affine2&, const Affine2&) = default;
};

// The linear part is row by row: row i is linear[3 i .. 3 i + 2].
// The numbers *are* the map: a predicate on posed points decides about the exact images, which need not be doubles.
struct Affine3 {
  std::array<double, 9> linear{1, 0, 0, 0, 1, 0, 0, 0, 1};
  std::array<double, 3> translation{0, 0, 0};
  friend bool operator==(const Affine3&, const Affine3&) = default;
};

}  // namespace sunder
