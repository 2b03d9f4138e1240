// A tree of boxes over the triangles of a mesh, in the mesh's frame, which is made once and asked under any pose.
// Also called: bounding volume hierarchy (BVH), AABB tree.
//
// Boxes are oriented, each as its triangles lie: what is near over an area is parted by flat boxes along it, a fraction
// of their number that boxes across fixed axes take. They are kept in single precision, about the middle of all and in
// units of a power of two, rounded outwards: so they are as tight where a mesh is far from the origin as near it.
// Source: Gottschalk, Lin, Manocha 1996 (OBBTree).
//
// A complete binary tree: node k has the children 2 k and 2 k + 1, the root is 1, and leaf l is node leaves() + l. It
// is halved across the axis along which the middles of the triangles' boxes are spread most. A node's box holds the
// triangles of all leaves below it, which follow each other in the order that the tree asks for.
#pragma once

#include <sunder/predicate/point.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace sunder::solid {

// Triangles that follow each other.
struct TriangleRange {
  std::uint32_t first = 0, end = 0;

  std::uint32_t size() const { return end - first; }
  friend bool operator==(const TriangleRange&, const TriangleRange&) = default;
};

// In the units of the tree: all points p with |axis k . (p - middle)| <= half[k]. Axis k is (x[k], y[k], z[k]), of length
// 1 and across the others, up to parts in 2^20; the middle is (x[3], y[3], z[3]). half[3] is more than all there is, and
// the halves of an empty box are below zero.
struct alignas(16) OrientedBox {
  std::array<float, 4> x{1, 0, 0, 0}, y{0, 1, 0, 0}, z{0, 0, 1, 0}, half{-1, -1, -1, beyond};
  static constexpr float beyond = 0x1p60F;
};

class MeshTree {
 public:
  static constexpr std::size_t leaf_size = 4;  // triangles, at most
  static constexpr std::size_t deepest = 32;   // levels, at most

  MeshTree() = default;
  // Fills `order`: the triangle that stands at place k, in the order of the leaves, is order[k]. It depends on the
  // coordinates alone, and is the same everywhere. Requires fewer than 2^31 triangles, and that each point is a corner of
  // one. Cost: n log n.
  MeshTree(std::span<const Point3> points, std::span<const std::array<std::uint32_t, 3>> triangles,
           std::vector<std::uint32_t>& order);

  std::size_t leaves() const { return nodes_.size() / 2; }
  bool is_leaf(std::size_t node) const { return node >= leaves(); }
  const Box3& box() const { return box_; }  // of all, exactly
  // The box of a node holds (x - middle()) / unit(), for the points x of its triangles.
  const OrientedBox& box(std::size_t node) const { return nodes_[node]; }
  // The box of one triangle, which is flat, in the same units.
  OrientedBox box_around_triangle(const std::array<Point3, 3>& corners) const;
  const Point3& middle() const { return middle_; }
  double radius() const { return radius_; }  // nothing is further from middle(), about
  double unit() const { return unit_; }      // a power of two; at least half the size of all
  // The places of the triangles below a node; of a leaf from 0 to leaf_size of them.
  TriangleRange triangles(std::size_t node) const {
    std::size_t first = node, end = node + 1;
    while (!is_leaf(first)) first *= 2, end *= 2;
    return {begin_of(first - leaves()), begin_of(end - leaves())};
  }
  // The node of the leaf that has it.
  std::size_t leaf_of(std::uint32_t triangle) const {
    std::size_t leaf = triangle * leaves() / size_;
    while (begin_of(leaf + 1) <= triangle) ++leaf;
    return leaves() + leaf;
  }
  std::size_t memory() const { return nodes_.size() * sizeof(nodes_[0]); }

 private:
  std::uint32_t begin_of(std::size_t leaf) const { return static_cast<std::uint32_t>(leaf * size_ / leaves()); }

  std::size_t size_ = 0;  // of triangles
  Box3 box_{};
  Point3 middle_;
  double unit_ = 1, radius_ = 0;
  std::vector<OrientedBox> nodes_;
};

}  // namespace sunder::solid
