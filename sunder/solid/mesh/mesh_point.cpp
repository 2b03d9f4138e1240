#include <sunder/solid/mesh/mesh_point.h>

#include <sunder/base/interruption.h>
#include <sunder/base/names.h>
#include <sunder/base/random.h>
#include <sunder/predicate/point/orient.h>

#include <array>
#include <cmath>

namespace sunder::solid {

namespace {

// Points of the world beyond a placed mesh: surely, as all corners of its box are before them along an axis.
class PointsBeyond {
 public:
  explicit PointsBeyond(const PlacedMesh& placed) {
    const auto [low, high] = placed.mesh().box();
    for (std::size_t k = 0; k < 8; ++k) {
      corners_[k] = placed.at({(k & 1 ? low : high).x, (k & 2 ? low : high).y, (k & 4 ? low : high).z});
    }
    for (std::size_t k = 0; k < 8; ++k) {
      for (std::size_t r = 0; r < 3; ++r) {
        const auto& [m, move] = *corners_[k].pose;
        const Point3& p = corners_[k].point;
        const double image = m[3 * r] * p.x + m[3 * r + 1] * p.y + m[3 * r + 2] * p.z + move[r];
        most_ = std::max(most_, std::fabs(image));
      }
    }
  }

  // From a seed on, another one each time. Its coordinates are some two to four times as large as those of the mesh.
  Point3 next() {
    for (double times = 2;; times *= 2) {
      Point3 q;
      for (std::size_t r = 0; r < 3; ++r) q[r] = most_ * random_.uniform(-1, 1);
      const std::size_t axis = random_.below(3);
      q[axis] = std::min(times * std::max(most_, 0x1p-1000) * random_.uniform(1, 2), 0x1.fffffp+1023);
      if (is_beyond(static_cast<int>(axis), q)) return q;
    }
  }

 private:
  bool is_beyond(int axis, const Point3& q) const {
    const Affine3 identity;
    const Posed3 end = posed(q, identity);
    for (const Posed3& corner : corners_) {
      if (compare_coordinate(axis, corner, end) != Sign::positive) return false;
    }
    return true;
  }

  std::array<Posed3, 8> corners_{};
  double most_ = 0;
  Random random_{20261130};
};

}  // namespace

std::string_view name_of(MeshPlace place) { return name_in<MeshPlace::inside>({"outside", "on", "inside"}, place); }

std::optional<std::int64_t> crossings_along(const PlacedMesh& placed, const Posed3& from, const Posed3& to,
                                            Cost& cost) {
  const Mesh& mesh = placed.mesh();
  std::int64_t sum = 0;
  for (std::uint32_t t = 0; t < mesh.triangles().size(); ++t) {
    may_be_interrupted(1);
    if (mesh.pieces()[mesh.piece_of(t)].kind == PieceKind::open) continue;
    ++cost.probes;
    switch (crossing_of(from, to, placed.triangle(t))) {
      case TriangleCrossing::none: break;
      case TriangleCrossing::positive: ++sum; break;
      case TriangleCrossing::negative: --sum; break;
      case TriangleCrossing::touch: return std::nullopt;
    }
  }
  return sum;
}

MeshPoint mesh_point(const Mesh& mesh, const Pose& pose, const Posed3& point) {
  const PlacedMesh placed(mesh, pose);
  MeshPoint result;
  for (std::uint32_t t = 0; t < mesh.triangles().size(); ++t) {
    may_be_interrupted(1);
    ++result.cost.probes;
    if (!triangles_meet({point, point, point}, placed.triangle(t))) continue;
    result.place = MeshPlace::on;
    return result;
  }
  const Affine3 identity;
  PointsBeyond beyond(placed);
  while (!result.winding) {
    ++result.cost.proposals;
    result.winding = crossings_along(placed, point, posed(beyond.next(), identity), result.cost);
  }
  if (!mesh.is_by_winding()) result.winding = *result.winding % 2 == 0 ? 0 : 1;
  result.place = *result.winding == 0 ? MeshPlace::outside : MeshPlace::inside;
  return result;
}

MeshPoint mesh_point(const Mesh& mesh, const Pose& pose, const Point3& point) {
  const Affine3 identity;
  return mesh_point(mesh, pose, posed(point, identity));
}

}  // namespace sunder::solid
