// A mesh under its pose, as predicates look at it.
#pragma once

#include <sunder/number/interval.h>
#include <sunder/predicate/line/space_triangles.h>
#include <sunder/predicate/posed.h>
#include <sunder/solid/mesh/mesh.h>
#include <sunder/solid/object/pose.h>

#include <algorithm>
#include <cstdint>
#include <span>

namespace sunder::solid {

// Keeps references to both.
class PlacedMesh {
 public:
  PlacedMesh(const Mesh& mesh, const Pose& pose) : mesh_(mesh), pose_(pose) {
    const SizeRange sizes = size_range(mesh.points());
    const SizeRange &linear = pose.linear_range(), &translation = pose.translation_range();
    tame_ = images_are_tame(linear, translation, sizes);
    reach_ = std::max(linear.greatest * sizes.greatest, translation.greatest);
  }
  PlacedMesh(const Mesh&, const Pose&&) = delete;
  PlacedMesh(const Mesh&&, const Pose&) = delete;

  const Mesh& mesh() const { return mesh_; }
  Posed3 at(std::uint32_t point) const { return at(mesh_.points()[point]); }
  // Of a point whose coordinates are those of points of the mesh.
  Posed3 at(const Point3& p) const { return {p, &pose_.affine(), tame_, reach_}; }
  PosedTriangle triangle(std::uint32_t t) const {
    const Mesh::Triangle& corners = mesh_.triangles()[t];
    return {at(corners[0]), at(corners[1]), at(corners[2])};
  }

  // A box that holds the image of the triangle.
  Box3 box(std::uint32_t t) const {
    Box3 box{};
    const auto& [m, move] = pose_.affine();
    for (std::size_t k = 0; k < 3; ++k) {
      const Point3& p = mesh_.points()[mesh_.triangles()[t][k]];
      for (std::size_t r = 0; r < 3; ++r) {
        const Interval image = Interval(m[3 * r]) * Interval(p.x) + Interval(m[3 * r + 1]) * Interval(p.y) +
                               Interval(m[3 * r + 2]) * Interval(p.z) + Interval(move[r]);
        box.low[r] = k == 0 ? image.low : std::min(box.low[r], image.low);
        box.high[r] = k == 0 ? image.high : std::max(box.high[r], image.high);
      }
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
