// Oriented boxes of two placed meshes, or of one and a segment: are they surely apart? In single precision, in lanes.
// Also called: oriented bounding boxes (OBB); separating axis test.
// Source: Gottschalk, Lin, Manocha 1996, section 5 (fifteen directions).
#pragma once

#include <sunder/base/lanes.h>
#include <sunder/predicate/coordinates.h>
#include <sunder/solid/mesh/placed_mesh.h>
#include <sunder/solid/search/search_vector.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstring>

namespace sunder::solid {

// Where what is given in units of its own is in the world: p is at middle + the sum of edge[c] * p[c]. In floating point.
struct BoxFrame {
  std::array<Point3, 3> edges;
  Point3 middle;
  double sum = 0;  // of the sizes of all that middle and edges are made of: they are off by some parts in 2^52 of that

  // Of the boxes of the tree of a placed mesh.
  static BoxFrame of(const PlacedMesh& placed) {
    const MeshTree& tree = placed.mesh().tree();
    const auto& [m, t] = placed.pose().affine();
    BoxFrame result;
    for (std::size_t r = 0; r < 3; ++r) {
      result.middle[r] = t[r];
      result.sum += std::fabs(t[r]);
      for (std::size_t c = 0; c < 3; ++c) {
        result.edges[c][r] = m[3 * r + c] * tree.unit();
        result.middle[r] += m[3 * r + c] * tree.middle()[c];
        result.sum += std::fabs(m[3 * r + c] * tree.middle()[c]);
      }
    }
    return result;
  }

  // In which segment_box() is the segment between two points.
  static BoxFrame of(const Posed3& p, const Posed3& q) {
    BoxFrame result;
    const Vector3<double> from = rounded_image(p), to = rounded_image(q);
    result.middle = {from.x / 2 + to.x / 2, from.y / 2 + to.y / 2, from.z / 2 + to.z / 2};
    result.edges[0] = {to.x / 2 - from.x / 2, to.y / 2 - from.y / 2, to.z / 2 - from.z / 2};
    for (const Posed3* end : {&p, &q}) {
      const auto& [m, t] = *end->pose;
      for (std::size_t r = 0; r < 3; ++r) {
        result.sum += std::fabs(m[3 * r] * end->point.x) + std::fabs(m[3 * r + 1] * end->point.y) +
                      std::fabs(m[3 * r + 2] * end->point.z) + std::fabs(t[r]);
      }
    }
    return result;
  }
  static OrientedBox segment_box() {
    OrientedBox box;
    box.half = {1, 0, 0, OrientedBox::beyond};
    return box;
  }
};

inline FloatLanes float_lanes_of(const std::array<float, 4>& numbers) {
  FloatLanes result;
  std::memcpy(&result, numbers.data(), sizeof result);
  return result;
}

// All is seen from the frame of the first one. There two boxes are apart if they are so along an axis of either, or
// along the vector product of an axis of one and one of the other. The axes of the second stay across each other only
// if its frame turns them there, and perhaps makes all larger or smaller; else the first one's axes alone are tried.
class PlacedBoxes {
 public:
  PlacedBoxes(const BoxFrame& a, const BoxFrame& b) {
    const std::array<Point3, 3> inverse = inverse_of(a.edges);  // rows
    const Point3 way{b.middle.x - a.middle.x, b.middle.y - a.middle.y, b.middle.z - a.middle.z};
    std::array<Point3, 3> linear;  // columns
    double size = 0, sum = 0, rows = 0;
    for (std::size_t r = 0; r < 3; ++r) {
      const Point3& row = inverse[r];
      double of_row = 0;
      for (std::size_t c = 0; c < 3; ++c) {
        linear[c][r] = dot(row, b.edges[c]);
        size = std::max(size, std::fabs(linear[c][r]));
        sum += std::fabs(row.x * b.edges[c].x) + std::fabs(row.y * b.edges[c].y) + std::fabs(row.z * b.edges[c].z);
        of_row += std::fabs(row[c]);
      }
      rows = std::max(rows, of_row);
    }
    const Point3 shift{dot(inverse[0], way), dot(inverse[1], way), dot(inverse[2], way)};
    const double far = std::max({std::fabs(shift.x), std::fabs(shift.y), std::fabs(shift.z)});
    // What the inverse is off by, as its product with the edges shows, and what the middles and double precision are.
    const double residue = residue_of(inverse, a.edges);
    const double off = (residue + 0x1p-46) * (2 + 2 * sum + far) + rows * (a.sum + b.sum) * 0x1p-46;
    if (!(off < 0x1p20) || !(far < 0x1p40) || !(sum < 0x1p40) || !(residue < 0x1p-20)) return;
    is_known_ = true;
    for (std::size_t c = 0; c < 3; ++c) {
      for (std::size_t r = 0; r < 3; ++r) {
        to_frame_[3 * r + c] = linear[c][r];
        linear_[3 * r + c] = static_cast<float>(linear[c][r]);
      }
      shift_[c] = shift[c];
    }
    error_ = static_cast<float>(off) + 0x1p-60F;
    double stretched = 0;  // no way is longer in the first one's units than this times itself, squared
    for (const Point3& row : inverse) {
      stretched = std::max(stretched, std::fabs(dot(row, inverse[0])) + std::fabs(dot(row, inverse[1])) +
                                          std::fabs(dot(row, inverse[2])));
    }
    if (stretched > 0x1p-1000 && stretched < 0x1p1000) shortest_ = (1 - 0x1p-15) / std::sqrt(stretched);
    const double xx = dot(linear[0], linear[0]), yy = dot(linear[1], linear[1]), zz = dot(linear[2], linear[2]);
    const double skew = std::max({std::fabs(dot(linear[0], linear[1])), std::fabs(dot(linear[0], linear[2])),
                                  std::fabs(dot(linear[1], linear[2]))});
    const bool is_segment = yy == 0 && zz == 0;
    turns_ =
        xx > 0x1p-60 &&
        (is_segment || (skew < 0x1p-20 * xx && std::fabs(xx - yy) < 0x1p-20 * xx && std::fabs(xx - zz) < 0x1p-20 * xx));
    times_ = static_cast<float>(std::sqrt(xx) * (1 + 0x1p-18));
    size_ = static_cast<float>(size);
    longest_ = 3 * size_;
  }

  // Surely apart: nothing is in both. False also means: not sure.
  bool are_apart(const OrientedBox& a, const OrientedBox& b) const {
    if (!is_known_) return false;
    const auto& [ax, ay, az, half_a, half_b, x, y, z, to_x, to_y, to_z, sizes] = seen_by_first(a, b);
    float error = error_ + sizes * 0x1p-19F;  // with that of single precision
    const FloatLanes way = ax * to_x + ay * to_y + az * to_z;
    std::array<FloatLanes, 3> seen;  // each axis of the second along those of the first
    FloatLanes reach = half_a + error;
    for (int k = 0; k < 3; ++k) {
      seen[static_cast<std::size_t>(k)] = ax * x[k] + ay * y[k] + az * z[k];
      reach += absolute(seen[static_cast<std::size_t>(k)]) * half_b[k];
    }
    if (bits_of_four(absolute(way) > reach) != 0) return true;
    if (!turns_) return false;
    error *= 2 * (1 + times_);
    const FloatLanes back = x * to_x + y * to_y + z * to_z;
    reach = half_b * (times_ * times_) + error;
    for (int k = 0; k < 3; ++k) reach += absolute(x * ax[k] + y * ay[k] + z * az[k]) * half_a[k];
    if (bits_of_four(absolute(back) > reach) != 0) return true;
    const FloatLanes way_1 = turned(way), way_2 = turned(way_1), half_1 = turned(half_a), half_2 = turned(half_1);
    FloatLanesMask apart{0, 0, 0, 0};
    for (std::size_t j = 0; j < 3; ++j) {
      const std::size_t k = (j + 1) % 3, l = (j + 2) % 3;
      const FloatLanes seen_1 = turned(seen[j]), seen_2 = turned(seen_1);
      const FloatLanes of_b = (absolute(seen[l]) * b.half[k] + absolute(seen[k]) * b.half[l]) * times_;
      const FloatLanes of_a = half_1 * absolute(seen_2) + half_2 * absolute(seen_1);
      apart |= absolute(way_2 * seen_1 - way_1 * seen_2) > of_a + of_b + error;
    }
    return (bits_of_four(apart) & 7) != 0;
  }

  // How far apart they are in the world, at least, as axes of either tell: not more than that, and 0 where they may
  // meet or nothing is known.
  double at_least(const OrientedBox& a, const OrientedBox& b) const {
    if (!is_known_) return 0;
    const auto& [ax, ay, az, half_a, half_b, x, y, z, to_x, to_y, to_z, sizes] = seen_by_first(a, b);
    const float error = error_ + sizes * 0x1p-19F;
    FloatLanes reach = half_a + error;
    for (int k = 0; k < 3; ++k) reach += absolute(ax * x[k] + ay * y[k] + az * z[k]) * half_b[k];
    double square = sum_of_squares(absolute(ax * to_x + ay * to_y + az * to_z) - reach);
    if (turns_) {
      reach = half_b * (times_ * times_) + error * 2 * (1 + times_);
      for (int k = 0; k < 3; ++k) reach += absolute(x * ax[k] + y * ay[k] + z * az[k]) * half_a[k];
      const auto length = static_cast<double>(times_);
      square = std::max(square, sum_of_squares(absolute(x * to_x + y * to_y + z * to_z) - reach) / (length * length));
    }
    return std::sqrt(square) * shortest_;
  }

  // Is the first box the larger one, about?
  bool is_first_larger(const OrientedBox& a, const OrientedBox& b) const {
    const auto side = [](const OrientedBox& box) { return std::max({box.half[0], box.half[1], box.half[2]}); };
    return side(a) >= side(b) * size_;
  }

 protected:
  // Two boxes in the frame of the first: its axes, those of the second one, the way from one middle to the other, and the sum
  // of the sizes of all these numbers.
  struct Seen {
    FloatLanes ax, ay, az, half_a, half_b, x, y, z;
    float to_x, to_y, to_z, sizes;
  };
  Seen seen_by_first(const OrientedBox& a, const OrientedBox& b) const {
    const FloatLanes bx = lanes(b.x), by = lanes(b.y), bz = lanes(b.z);
    const auto mx = static_cast<double>(b.x[3]), my = static_cast<double>(b.y[3]), mz = static_cast<double>(b.z[3]);
    const auto to = [&](std::size_t row, float from) {
      const double* const m = to_frame_.data() + 3 * row;
      return static_cast<float>(m[0] * mx + m[1] * my + m[2] * mz + shift_[row] - static_cast<double>(from));
    };
    const float to_x = to(0, a.x[3]), to_y = to(1, a.y[3]), to_z = to(2, a.z[3]);
    const float sizes = std::fabs(to_x) + std::fabs(to_y) + std::fabs(to_z) + a.half[0] + a.half[1] + a.half[2] +
                        (b.half[0] + b.half[1] + b.half[2]) * longest_;
    return {lanes(a.x),
            lanes(a.y),
            lanes(a.z),
            lanes(a.half),
            lanes(b.half),
            bx * linear_[0] + by * linear_[1] + bz * linear_[2],
            bx * linear_[3] + by * linear_[4] + bz * linear_[5],
            bx * linear_[6] + by * linear_[7] + bz * linear_[8],
            to_x,
            to_y,
            to_z,
            std::fabs(sizes)};
  }
  // The sum of the squares of those of the first three numbers that are positive.
  static double sum_of_squares(FloatLanes gaps) {
    double sum = 0;
    for (int k = 0; k < 3; ++k) {
      const auto gap = static_cast<double>(std::max(gaps[k], 0.0F));
      sum += gap * gap;
    }
    return sum;
  }

  static FloatLanes lanes(const std::array<float, 4>& numbers) { return float_lanes_of(numbers); }
  // The first three, each in the place of the one before.
  static FloatLanes turned(FloatLanes v) { return __builtin_shufflevector(v, v, 1, 2, 0, 3); }

  // Rows, about; not finite where there is none.
  static std::array<Point3, 3> inverse_of(const std::array<Point3, 3>& columns) {
    std::array<Point3, 3> rows{cross(columns[1], columns[2]), cross(columns[2], columns[0]),
                               cross(columns[0], columns[1])};
    const double determinant = dot(columns[0], rows[0]);
    for (Point3& row : rows) row = {row.x / determinant, row.y / determinant, row.z / determinant};
    return rows;
  }
  // By how much a row times a column is not 1 or 0, at most, all together.
  static double residue_of(const std::array<Point3, 3>& rows, const std::array<Point3, 3>& columns) {
    double sum = 0;
    for (std::size_t r = 0; r < 3; ++r) {
      for (std::size_t c = 0; c < 3; ++c) sum += std::fabs(dot(rows[r], columns[c]) - (r == c ? 1 : 0));
    }
    return sum;
  }

  bool is_known_ = false, turns_ = false;
  std::array<float, 9> linear_{};
  std::array<double, 9> to_frame_{};  // the same
  std::array<double, 3> shift_{};
  float error_ = 0;      // of a way along an axis of the first, but for single precision
  float times_ = 1;      // how many times as long axes of the second are, where it turns them
  float size_ = 1;       // of axes of the second, about
  float longest_ = 1;    // no axis is longer
  double shortest_ = 0;  // a length 1 in the first one's units is at least that in the world
};

// Along one direction of the world, from A to B: how far apart are two boxes, at least?
class BoxesAlong {
 public:
  // Requires a direction of length 1, about.
  BoxesAlong(const BoxFrame& a, const BoxFrame& b, const Point3& d)
      : a_(a, d),
        b_(b, d),
        between_(dot(d, {b.middle.x - a.middle.x, b.middle.y - a.middle.y, b.middle.z - a.middle.z})),
        error_((a.sum + b.sum) * 0x1p-45) {}

  double at_least(const OrientedBox& a, const OrientedBox& b) const {
    return (between_ + b_.middle_of(b) - a_.middle_of(a) - a_.reach_of(a) - b_.reach_of(b) - error_) * (1 - 0x1p-40);
  }

 private:
  // The direction as a mesh's boxes see it.
  struct Seen {
    Point3 along;
    double size;
    std::array<float, 3> rounded;  // in units of size: beyond the range of single precision are those of the world

    Seen(const BoxFrame& of, const Point3& d)
        : along{dot(of.edges[0], d), dot(of.edges[1], d), dot(of.edges[2], d)},
          size(std::fabs(along.x) + std::fabs(along.y) + std::fabs(along.z)),
          rounded{part(along.x), part(along.y), part(along.z)} {}

    double middle_of(const OrientedBox& box) const {
      return along.x * static_cast<double>(box.x[3]) + along.y * static_cast<double>(box.y[3]) +
             along.z * static_cast<double>(box.z[3]);
    }
    // Axes are of length 1 and across each other up to parts in 2^20; single precision: parts in 2^20.
    double reach_of(const OrientedBox& box) const {
      const FloatLanes half = float_lanes_of(box.half),
                       ways = float_lanes_of(box.x) * rounded[0] + float_lanes_of(box.y) * rounded[1] +
                              float_lanes_of(box.z) * rounded[2],
                       reaches = absolute(ways) * half;
      const float reach = reaches[0] + reaches[1] + reaches[2], sizes = std::fabs(half[0] + half[1] + half[2]);
      return (static_cast<double>(reach) + static_cast<double>(sizes) * 0x1p-17 + 0x1p-40) * size;
    }

   private:
    float part(double of_along) const { return size > 0 ? static_cast<float>(of_along / size) : 0.0F; }
  };

  Seen a_, b_;
  double between_, error_;
};

// Calls of_triangle(t) with each triangle below a node whose leaf is not surely apart from the segment between two points,
// until it returns true. Returns whether it did. Cost: looks grows by boxes and triangles.
template <class OfTriangle>
bool any_triangle_near(const PlacedMesh& placed, const Posed3& p, const Posed3& q, std::uint64_t& looks,
                       const OfTriangle& of_triangle, std::size_t top = 1) {
  const MeshTree& tree = placed.mesh().tree();
  const PlacedBoxes boxes(BoxFrame::of(placed), BoxFrame::of(p, q));
  const OrientedBox segment = BoxFrame::segment_box();
  std::array<std::size_t, 2 * MeshTree::deepest> waiting;
  std::size_t count = 0;
  waiting[count++] = top;
  while (count > 0) {
    const std::size_t node = waiting[--count];
    ++looks;
    if (boxes.are_apart(tree.box(node), segment)) continue;
    if (!tree.is_leaf(node)) {
      waiting[count++] = 2 * node + 1;
      waiting[count++] = 2 * node;
      continue;
    }
    const auto [first, end] = tree.triangles(node);
    for (std::uint32_t t = first; t < end; ++t) {
      ++looks;
      if (of_triangle(t)) return true;
    }
  }
  return false;
}

}  // namespace sunder::solid
