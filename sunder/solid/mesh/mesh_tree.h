// A tree of boxes over the triangles of a mesh, in the mesh's frame, which is made once and asked under any pose.
// Also called: bounding volume hierarchy (BVH), AABB tree.
//
// A complete binary tree: node k has the children 2 k and 2 k + 1, the root is 1, and leaf l is node leaves() + l. It
// is halved along the axis on which the middles of the triangles' boxes are spread most. A node's box holds the
// triangles of all leaves below it.
#pragma once

#include <sunder/predicate/point.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace sunder::solid {

class MeshTree {
 public:
  static constexpr std::size_t leaf_size = 4;  // triangles, at most
  static constexpr std::size_t deepest = 32;   // levels, at most

  MeshTree() = default;
  // Requires fewer than 2^31 triangles. Cost: n log n.
  MeshTree(std::span<const Point3> points, std::span<const std::array<std::uint32_t, 3>> triangles);

  std::size_t leaves() const { return nodes_.size() / 2; }
  bool is_leaf(std::size_t node) const { return node >= leaves(); }
  const Box3& box(std::size_t node) const { return nodes_[node]; }
  // The triangles of a leaf, from 0 to leaf_size.
  std::span<const std::uint32_t> triangles(std::size_t node) const {
    const std::size_t leaf = node - leaves();
    return std::span(order_).subspan(begin_of(leaf), begin_of(leaf + 1) - begin_of(leaf));
  }
  std::size_t memory() const { return order_.size() * sizeof(order_[0]) + nodes_.size() * sizeof(nodes_[0]); }

 private:
  std::size_t begin_of(std::size_t leaf) const { return leaf * order_.size() / leaves(); }
  void split(std::span<const Point3> middles, std::size_t first_leaf, std::size_t leaves);

  std::vector<std::uint32_t> order_;  // triangles in the order of the leaves
  std::vector<Box3> nodes_;
};

}  // namespace sunder::solid
