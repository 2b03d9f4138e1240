// Two triangles of the plane: which vertices of one are to the left of which edges of the other? By the first stage
// alone and without branches: all or nothing. What it leaves open, predicate/line/arrows.h decides.
//
// Points are plain (Point2) or under poses (Posed2, whose exact images are meant); all six of one kind.
#pragma once

#include <sunder/predicate/line/arrows.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <type_traits>

namespace sunder {

// Edge e of a triangle leads from its vertex e to the next one. In both masks, bit 3 e + f speaks of number e of the
// first triangle and number f of the second one.
struct TriangleSides {
  std::uint32_t left_of_first = 0;   // vertex f of the second is to the left of edge e of the first
  std::uint32_t left_of_second = 0;  // vertex e of the first is to the left of edge f of the second
  bool sure = false;                 // no sign is open or zero: all bits not set are surely to the right

  static constexpr std::uint32_t all = 0777;

  // Of the bits of each edge of the first triangle, the one of the next vertex (edge) of the second, in its place.
  static constexpr std::uint32_t next_of_second(std::uint32_t bits) { return (bits >> 1 & 0333) | (bits << 2 & 0444); }
  static constexpr std::uint32_t next_of_first(std::uint32_t bits) { return (bits >> 3 | bits << 6) & all; }

  // For triangles in counter-clockwise order. Bit f: vertex f of the second triangle is inside the first one.
  std::uint32_t inside_first() const { return left_of_first & left_of_first >> 3 & left_of_first >> 6 & 07; }
  // Bit 3 e: vertex e of the first triangle is inside the second one.
  std::uint32_t inside_second() const { return left_of_second & left_of_second >> 1 & left_of_second >> 2 & 0111; }
  // Edge e of the first crosses edge f of the second.
  std::uint32_t crossings() const {
    return (left_of_first ^ next_of_second(left_of_first)) & (left_of_second ^ next_of_first(left_of_second));
  }
};

namespace triangles {

// As the first stages of cross_2d (arrows.h): a sign is sure where the value is beyond the error.
struct Corners {
  explicit Corners(const std::array<Point2, 3>& vertices) : at(vertices) {}
  explicit Corners(const std::array<Posed2, 3>& vertices)
      : at{vertices[0].rounded_image(), vertices[1].rounded_image(), vertices[2].rounded_image()},
        error(std::max({vertices[0].error, vertices[1].error, vertices[2].error})) {}

  std::array<Point2, 3> at;
  double error = 0;
};

template <bool exact_images>
bool is_left(const Point2& p, const Point2& q, const Point2& r, double image_error, bool& sure) {
  const double a = q.x - p.x, b = r.y - p.y, c = p.y - q.y, d = r.x - p.x;
  const double left = a * b, right = c * d, value = left + right;
  double error = Rounded<4>::bound * (std::fabs(left) + std::fabs(right)) + 0x1p-1060;
  if constexpr (!exact_images) {
    const double e = 2 * image_error, sizes = (std::fabs(a) + std::fabs(b)) + (std::fabs(c) + std::fabs(d));
    error += (1 + 0x1p-48) * (e * (sizes + 2 * e));
  }
  sure &= std::fabs(value) > error;
  return value > 0;
}

}  // namespace triangles

// Each triangle by its vertices, in any order.
template <class Vertex>
TriangleSides sides_of_triangles(const std::array<Vertex, 3>& first, const std::array<Vertex, 3>& second) {
  constexpr bool exact_images = std::is_same_v<Vertex, Point2>;
  const triangles::Corners p(first), q(second);
  const double image_error = exact_images ? 0 : std::max(p.error, q.error);
  TriangleSides sides;
  sides.sure = true;
  for (std::uint32_t e = 0; e < 3; ++e) {
    for (std::uint32_t f = 0; f < 3; ++f) {
      const std::uint32_t after_e = e == 2 ? 0 : e + 1, after_f = f == 2 ? 0 : f + 1;
      const bool in_first = triangles::is_left<exact_images>(p.at[e], p.at[after_e], q.at[f], image_error, sides.sure);
      const bool in_second = triangles::is_left<exact_images>(q.at[f], q.at[after_f], p.at[e], image_error, sides.sure);
      sides.left_of_first |= std::uint32_t{in_first} << (3 * e + f);
      sides.left_of_second |= std::uint32_t{in_second} << (3 * e + f);
    }
  }
  return sides;
}

}  // namespace sunder
