// Parts of a mesh, each parted by a plane from something convex beside it: the proof that they are apart. For the sources of
// solid/mesh.
#pragma once

#include <sunder/base/contract.h>
#include <sunder/base/interruption.h>
#include <sunder/predicate/point/along.h>
#include <sunder/solid/mesh/mesh_point.h>
#include <sunder/solid/mesh/placed_mesh.h>
#include <sunder/solid/object/convex_polyhedron.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace sunder::solid {

// Part k is of the triangles from ends[k - 1] (of the first part: from 0) to before ends[k], in the mesh's order; along
// directions[k] it ends before what is beside it begins. away: a direction from the first point of that out of the mesh,
// along which it crosses that as often outwards as inwards; there is none where there is one part, or the mesh has no
// inside.
struct PartsBeside {
  std::vector<std::uint32_t> ends;
  std::vector<std::array<Dyadic, 3>> directions;
  std::vector<std::array<Dyadic, 3>> away;  // one, or none
};

// Beside: direction_from(part, pose), a direction along which the placed polyhedron ends before it begins, if one is
// found, which it is of single triangles; is_beyond(direction, last), does it begin behind that point, exactly?
// first_point(), in the world.
template <class Beside>
class PartsParting {
 public:
  PartsParting(const PlacedMesh& placed, const Beside& beside) : placed_(placed), beside_(beside) {}

  PartsBeside run() {
    part(1);
    if (placed_.mesh().has_inside() && parts_.ends.size() > 1) {
      parts_.away.push_back(ray_away(placed_, beside_.first_point()).along);
    }
    return std::move(parts_);
  }

 private:
  static constexpr std::uint32_t few = 64;  // triangles: of so many the hull is asked about, of more their box

  void part(std::size_t node) {
    may_be_interrupted(1);
    const MeshTree& tree = placed_.mesh().tree();
    const TriangleRange range = tree.triangles(node);
    if (range.size() == 0 || take(range, node)) return;
    if (!tree.is_leaf(node)) {
      part(2 * node);
      part(2 * node + 1);
      return;
    }
    for (std::uint32_t t = range.first; t < range.end; ++t) {
      [[maybe_unused]] const bool is_parted = take({t, t + 1}, node);
      SUNDER_REQUIRE(is_parted);
    }
  }

  // Are these triangles parted from the body by one plane that is found?
  bool take(const TriangleRange& range, std::size_t node) {
    const bool is_hull = range.size() <= few;
    const std::optional<ConvexPolyhedron> around = is_hull ? hull_of(range) : box_of(node);
    if (!around) return false;
    std::optional<std::array<Dyadic, 3>> direction = beside_.direction_from(*around, placed_.pose());
    if (!direction || (!is_hull && !parts(*direction, range))) return false;
    parts_.ends.push_back(range.end);
    parts_.directions.push_back(*std::move(direction));
    return true;
  }

  std::optional<ConvexPolyhedron> hull_of(const TriangleRange& range) const {
    std::vector<Point3> corners;
    for (std::uint32_t t = range.first; t < range.end; ++t) {
      for (const std::uint32_t corner : placed_.mesh().triangles()[t])
        corners.push_back(placed_.mesh().points()[corner]);
    }
    return ConvexPolyhedron(corners);
  }

  // About the box of a node, in the frame of the mesh. Nothing beyond the range of doubles.
  std::optional<ConvexPolyhedron> box_of(std::size_t node) const {
    const MeshTree& tree = placed_.mesh().tree();
    const OrientedBox& box = tree.box(node);
    const std::array<std::array<float, 4>, 3> rows{box.x, box.y, box.z};
    std::array<Point3, 8> corners;
    for (std::size_t k = 0; k < corners.size(); ++k) {
      for (std::size_t c = 0; c < 3; ++c) {
        double at = static_cast<double>(rows[c][3]);
        for (std::size_t axis = 0; axis < 3; ++axis) {
          const auto reach = static_cast<double>(rows[c][axis]) * static_cast<double>(box.half[axis]);
          at += (k >> axis & 1) != 0 ? reach : -reach;
        }
        corners[k][c] = tree.middle()[c] + tree.unit() * at;
        if (!std::isfinite(corners[k][c])) return std::nullopt;
      }
    }
    return ConvexPolyhedron(corners);
  }

  // Exact.
  bool parts(const std::array<Dyadic, 3>& along, const TriangleRange& range) const {
    const WorldDirection direction(Vector3<Dyadic>{along[0], along[1], along[2]});
    const Posed3 any = placed_.at(0u);
    Along compared(direction, *any.pose, any.tame);
    const std::span<const Point3> points = placed_.mesh().points();
    std::uint32_t last = placed_.mesh().triangles()[range.first][0];
    for (std::uint32_t t = range.first; t < range.end; ++t) {
      for (const std::uint32_t corner : placed_.mesh().triangles()[t]) {
        if (compared.compare(points[last], points[corner]) == Sign::positive) last = corner;
      }
    }
    return beside_.is_beyond(direction, placed_.at(last));
  }

  const PlacedMesh& placed_;
  const Beside& beside_;
  PartsBeside parts_;
};

}  // namespace sunder::solid
