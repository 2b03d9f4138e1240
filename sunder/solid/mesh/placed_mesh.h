// A mesh under its pose, as predicates and searches look at it.
#pragma once

#include <sunder/number/interval.h>
#include <sunder/predicate/line/space_triangles.h>
#include <sunder/predicate/posed.h>
#include <sunder/solid/mesh/mesh.h>
#include <sunder/solid/object/pose.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>

namespace sunder::solid {

// Rounded, for searches: infinite beyond the range of doubles.
inline double longest_side(const Box3& box) {
  return std::max({box.high.x - box.low.x, box.high.y - box.low.y, box.high.z - box.low.z});
}

// A box that holds the image of the point.
inline Box3 enclosure(const Posed3& p) {
  Box3 box{};
  const auto& [m, move] = *p.pose;
  for (std::size_t r = 0; r < 3; ++r) {
    const Interval image = Interval(m[3 * r]) * Interval(p.point.x) + Interval(m[3 * r + 1]) * Interval(p.point.y) +
                           Interval(m[3 * r + 2]) * Interval(p.point.z) + Interval(move[r]);
    box.low[r] = image.low;
    box.high[r] = image.high;
  }
  return box;
}

// Keeps references to both.
class PlacedMesh {
 public:
  PlacedMesh(const Mesh& mesh, const Pose& pose)
      : mesh_(mesh),
        pose_(pose),
        tame_(images_are_tame(pose.linear_range(), pose.translation_range(), mesh.sizes())),
        reach_(std::max(pose.linear_range().greatest * mesh.sizes().greatest, pose.translation_range().greatest)) {}
  PlacedMesh(const Mesh&, const Pose&&) = delete;
  PlacedMesh(const Mesh&&, const Pose&) = delete;

  const Mesh& mesh() const { return mesh_; }
  const Pose& pose() const { return pose_; }
  Posed3 at(std::uint32_t point) const { return at(mesh_.points()[point]); }
  // Of a point whose coordinates are each one of some point of the mesh.
  Posed3 at(const Point3& p) const { return {p, &pose_.affine(), tame_, reach_}; }
  PosedTriangle triangle(std::uint32_t t) const {
    const Mesh::Triangle& corners = mesh_.triangles()[t];
    return {at(corners[0]), at(corners[1]), at(corners[2])};
  }

  // A box that holds the image of the triangle.
  Box3 box(std::uint32_t t) const {
    const PosedTriangle corners = triangle(t);
    return hull(hull(enclosure(corners[0]), enclosure(corners[1])), enclosure(corners[2]));
  }

  // A box that holds the image of all triangles below a node of the tree. Its middle and half its size are mapped; a
  // sum of four products and what went before have less than 12 roundings, each of a part in 2^53 of the sum of sizes.
  // Where that is beyond the range of doubles, the box is all of the axis.
  Box3 node_box(std::size_t node) const {
    const MeshTree& tree = mesh_.tree();
    const SmallBox& of = tree.box(node);
    std::array<double, 3> middle{}, half{};
    for (std::size_t c = 0; c < 3; ++c) {
      middle[c] = tree.middle()[c] + tree.unit() * static_cast<double>(of.middle[c]);
      half[c] = tree.unit() * static_cast<double>(of.half[c]) + std::fabs(middle[c]) * 0x1p-52;
    }
    const auto& [m, move] = pose_.affine();
    Box3 box{};
    for (std::size_t r = 0; r < 3; ++r) {
      double at = move[r], reach = 0, sizes = std::fabs(move[r]);
      for (std::size_t c = 0; c < 3; ++c) {
        const double entry = m[3 * r + c];
        at += entry * middle[c];
        reach += std::fabs(entry) * half[c] + std::fabs(entry) * 0x1p-1072;  // what halving subnormals may lose
        sizes += std::fabs(entry * middle[c]);
      }
      const double error = (sizes + reach) * 0x1p-48 + 0x1p-1020;
      const bool is_in_range = sizes + reach + error <= std::numeric_limits<double>::max();
      box.low[r] = is_in_range ? at - reach - error : -std::numeric_limits<double>::infinity();
      box.high[r] = is_in_range ? at + reach + error : std::numeric_limits<double>::infinity();
    }
    return box;
  }

 private:
  const Mesh& mesh_;
  const Pose& pose_;
  bool tame_;
  double reach_;
};

}  // namespace sunder::solid
