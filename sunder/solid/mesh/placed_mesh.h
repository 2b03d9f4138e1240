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

  // A box that holds the image of all triangles below a node of the tree. Its middle and its halves are mapped; each sum
  // of products has less than 24 roundings, each of a part in 2^53 of the sum of sizes. Where that is beyond the range of
  // doubles, the box is all of the axis.
  Box3 node_box(std::size_t node) const {
    const MeshTree& tree = mesh_.tree();
    const OrientedBox& of = tree.box(node);
    const double unit = tree.unit();
    const std::array<std::array<float, 4>, 3> rows{of.x, of.y, of.z};
    const auto& [m, move] = pose_.affine();
    Box3 box{};
    for (std::size_t r = 0; r < 3; ++r) {
      double at = move[r], reach = 0, sizes = std::fabs(move[r]);
      for (std::size_t c = 0; c < 3; ++c) {
        const double entry = m[3 * r + c], place = entry * tree.middle()[c],
                     way = entry * unit * static_cast<double>(rows[c][3]);
        at += place + way;
        sizes += std::fabs(place) + std::fabs(way) + std::fabs(entry) * unit * 0x1p-18 + std::fabs(entry) * 0x1p-1072;
        reach += std::fabs(entry) * unit * 0x1p-18 + std::fabs(entry) * 0x1p-1072;  // axes are about of length 1
      }
      for (std::size_t k = 0; k < 3; ++k) {
        double along = 0;
        for (std::size_t c = 0; c < 3; ++c) along += m[3 * r + c] * unit * static_cast<double>(rows[c][k]);
        reach += std::fabs(along) * static_cast<double>(of.half[k]);
      }
      const double error = (sizes + std::fabs(reach)) * 0x1p-47 + 0x1p-1020;
      const bool is_in_range = sizes + std::fabs(reach) + error <= std::numeric_limits<double>::max();
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
