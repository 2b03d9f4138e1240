// Boxes of nodes of two placed meshes: are they surely apart? In single precision, along some directions at once.
// Also called: oriented bounding boxes (OBB); separating axis test.
#pragma once

#include <sunder/base/lanes.h>
#include <sunder/predicate/coordinates.h>
#include <sunder/solid/mesh/placed_mesh.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace sunder::solid {

// Where boxes in a frame are in the world: the box with this middle and half is all of middle + the sum of edge * (box
// middle + part * half), for parts from -1 to 1. In floating point.
struct BoxFrame {
  std::array<Point3, 3> edges;
  Point3 middle;
  double sum = 0;   // of the sizes of all that middle and edges are made of: they are off by some parts in 2^52 of that
  double size = 0;  // of the longest edge, about

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
        result.size = std::max(result.size, std::fabs(result.edges[c][r]));
        result.middle[r] += m[3 * r + c] * tree.middle()[c];
        result.sum += std::fabs(m[3 * r + c] * tree.middle()[c]);
      }
    }
    return result;
  }

  // In which `whole` is the segment between two points.
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
    for (std::size_t r = 0; r < 3; ++r) result.size = std::max(result.size, std::fabs(result.edges[0][r]));
    return result;
  }
  static constexpr SmallBox whole{{0, 0, 0}, {1, 0, 0}};

  BoxFrame times(double scale) const {
    BoxFrame result = *this;
    for (Point3* p : {&result.edges[0], &result.edges[1], &result.edges[2], &result.middle}) {
      *p = {p->x * scale, p->y * scale, p->z * scale};
    }
    result.sum *= scale;
    result.size *= scale;
    return result;
  }
};

// The images of two boxes are parallelepipeds. They are apart if along some direction they are: the normals of faces of
// both are tried first, then the products of an edge of one and one of the other. What directions see of each frame is
// computed once.
class PlacedBoxes {
 public:
  PlacedBoxes(const BoxFrame& a, const BoxFrame& b) {
    const double size = std::max(a.size, b.size);
    if (!(size > 0x1p-1000 && size < 0x1p1000)) return;
    const double scale = std::ldexp(1.0, -std::ilogb(size));
    const std::array<BoxFrame, 2> frames{a.times(scale), b.times(scale)};
    for (std::size_t of = 0; of < 2; ++of) sizes_[of] = static_cast<float>(frames[of].size);
    std::array<std::array<Point3, 3>, 2> ways;  // of edges, at most 1 in size
    for (std::size_t of = 0; of < 2; ++of) {
      for (std::size_t k = 0; k < 3; ++k) ways[of][k] = way(frames[of].edges[k]);
    }
    std::size_t lane = 0;
    for (const auto& [u, v, w] : ways) {
      add(cross(v, w), frames, lane++);
      add(cross(w, u), frames, lane++);
      add(cross(u, v), frames, lane++);
    }
    lane = 8;
    for (const Point3& u : ways[0]) {
      for (const Point3& v : ways[1]) add(cross(u, v), frames, lane++);
    }
  }

  // Surely apart: nothing is in both. False also means: not sure.
  bool are_apart(const SmallBox& p, const SmallBox& q) const {
    return (bits_of_four(apart(p, q, 0) | apart(p, q, 1)) != 0) ||
           (bits_of_four(apart(p, q, 2) | apart(p, q, 3) | apart(p, q, 4)) != 0);
  }

  // Is the first box the larger one, about?
  bool is_first_larger(const SmallBox& p, const SmallBox& q) const {
    const auto side = [](const SmallBox& box) { return std::max({box.half[0], box.half[1], box.half[2]}); };
    return side(p) * sizes_[0] >= side(q) * sizes_[1];
  }

 private:
  static Point3 cross(const Point3& u, const Point3& v) {
    return {u.y * v.z - u.z * v.y, u.z * v.x - u.x * v.z, u.x * v.y - u.y * v.x};
  }
  static double product(const Point3& u, const Point3& v) { return u.x * v.x + u.y * v.y + u.z * v.z; }
  static double sizes(const Point3& u, const Point3& v) {
    return std::fabs(u.x * v.x) + std::fabs(u.y * v.y) + std::fabs(u.z * v.z);
  }

  // About the same way, its greatest component 1 in size; zero stays zero.
  static Point3 way(const Point3& u) {
    const double most = std::max({std::fabs(u.x), std::fabs(u.y), std::fabs(u.z)});
    return most > 0 ? Point3{u.x / most, u.y / most, u.z / most} : u;
  }

  // Any direction will do, so its rounding is no error; one that is about zero is left out. Along it a point of A's box
  // is at offset + sum of edge * (middle + part of half). Each number of the sum is off
  // by parts in 2^22 of what it is made of, and so are the sums of apart(); the offset by parts in 2^48.
  void add(Point3 d, const std::array<BoxFrame, 2>& frames, std::size_t lane) {
    if (!(std::max({std::fabs(d.x), std::fabs(d.y), std::fabs(d.z)}) > 0x1p-40)) return;
    d = way(d);
    const std::size_t four = lane / 4, at = lane % 4;
    double all = 0;
    for (const std::size_t of : {0u, 1u}) {
      for (std::size_t c = 0; c < 3; ++c) {
        const Point3& edge = frames[of].edges[c];
        edges_[four][3 * of + c][at] = static_cast<float>(product(d, edge));
        all += sizes(d, edge);
      }
    }
    const Point3 &p = frames[0].middle, &q = frames[1].middle;
    const double offset = product(d, {p.x - q.x, p.y - q.y, p.z - q.z}),
                 off = (frames[0].sum + frames[1].sum) * 0x1p-46;
    if (!(std::fabs(offset) + off < 0x1p100)) {  // beyond what single precision holds
      for (std::size_t k = 0; k < 6; ++k) edges_[four][k][at] = 0;
      return;
    }
    offsets_[four][at] = static_cast<float>(offset);
    errors_[four][at] = static_cast<float>(all * 0x1p-17 + std::fabs(offset) * 0x1p-17 + off + 0x1p-100);
  }

  FloatLanesMask apart(const SmallBox& p, const SmallBox& q, std::size_t four) const {
    const std::array<FloatLanes, 6>& edges = edges_[four];
    FloatLanes way = offsets_[four], reach = errors_[four];
    for (std::size_t c = 0; c < 3; ++c) {
      way += edges[c] * p.middle[c] - edges[3 + c] * q.middle[c];
      reach += absolute(edges[c]) * p.half[c] + absolute(edges[3 + c]) * q.half[c];
    }
    return absolute(way) > reach;
  }

  std::array<float, 2> sizes_{};
  // Of the directions 0 to 5, and 8 to 16, in fours; of those that are left out zeros, which part nothing.
  std::array<std::array<FloatLanes, 6>, 5> edges_{};  // of A, then of B
  std::array<FloatLanes, 5> offsets_{}, errors_{};
};

// Calls of_triangle(t) with each triangle whose leaf is not surely apart from the segment between two points, until it
// returns true. Returns whether it did. Cost: looks grows by boxes and triangles.
template <class OfTriangle>
bool any_triangle_near(const PlacedMesh& placed, const Posed3& p, const Posed3& q, std::uint64_t& looks,
                       const OfTriangle& of_triangle) {
  const MeshTree& tree = placed.mesh().tree();
  const PlacedBoxes boxes(BoxFrame::of(placed), BoxFrame::of(p, q));
  std::array<std::size_t, 2 * MeshTree::deepest> waiting;
  std::size_t count = 0;
  waiting[count++] = 1;
  while (count > 0) {
    const std::size_t node = waiting[--count];
    ++looks;
    if (boxes.are_apart(tree.box(node), BoxFrame::whole)) continue;
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
