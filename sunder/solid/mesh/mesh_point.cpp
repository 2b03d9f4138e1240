#include <sunder/solid/mesh/mesh_point.h>

#include <sunder/base/interruption.h>
#include <sunder/base/names.h>
#include <sunder/base/random.h>
#include <sunder/predicate/point/orient.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace sunder::solid {

namespace {

// Points of the world beyond a placed mesh: surely, as all corners of its box are before them along an axis. They are
// about straight before or behind a point, on the side where the mesh ends first, so that few boxes are between.
class PointsBeyond {
 public:
  PointsBeyond(const PlacedMesh& placed, const Posed3& from) : from_(enclosure(from)), mesh_(placed.node_box(1)) {
    const auto [low, high] = placed.mesh().box();
    for (std::size_t k = 0; k < 8; ++k) {
      corners_[k] = placed.at({(k & 1 ? low : high).x, (k & 2 ? low : high).y, (k & 4 ? low : high).z});
    }
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t c = 0; c < 3; ++c) {
      const double before = from_.high[c] - mesh_.low[c], behind = mesh_.high[c] - from_.low[c];
      if (std::min(before, behind) >= least) continue;
      least = std::min(before, behind);
      axis_ = c;
      is_up_ = behind <= before;
    }
  }

  // Another one each time, further and further away.
  Point3 next() {
    while (true) {
      Point3 q;
      double size = 0x1p-1000;
      for (std::size_t c = 0; c < 3; ++c) size = std::max(size, mesh_.high[c] / 2 - mesh_.low[c] / 2);
      for (std::size_t c = 0; c < 3; ++c) q[c] = from_.low[c] + 0x1p-8 * size * random_.uniform(-1, 1);
      const double end = is_up_ ? mesh_.high[axis_] : mesh_.low[axis_];
      const double step = times_ * std::max(size, std::fabs(end) * 0x1p-40) * random_.uniform(0.5, 1);
      q[axis_] = is_up_ ? std::max(end, from_.high[axis_]) + step : std::min(end, from_.low[axis_]) - step;
      for (std::size_t c = 0; c < 3; ++c) q[c] = std::clamp(q[c], -0x1.fffffp+1023, 0x1.fffffp+1023);
      times_ *= 2;
      if (is_beyond(q)) return q;
    }
  }

 private:
  bool is_beyond(const Point3& q) const {
    const Affine3 identity;
    const Posed3 end = posed(q, identity);
    const Sign wanted = is_up_ ? Sign::positive : Sign::negative;
    return std::all_of(corners_.begin(), corners_.end(), [&](const Posed3& corner) {
      return compare_coordinate(static_cast<int>(axis_), corner, end) == wanted;
    });
  }

  Box3 from_, mesh_;
  std::array<Posed3, 8> corners_{};
  std::size_t axis_ = 0;
  bool is_up_ = true;
  double times_ = 0x1p-4;
  Random random_{20261130};
};

}  // namespace

std::string_view name_of(MeshPlace place) { return name_in<MeshPlace::inside>({"outside", "on", "inside"}, place); }

std::optional<std::int64_t> crossings_along(const PlacedMesh& placed, const Posed3& from, const Posed3& to,
                                            Cost& cost) {
  const Mesh& mesh = placed.mesh();
  std::int64_t sum = 0;
  const bool touches =
      any_triangle_near(placed, joined(enclosure(from), enclosure(to)), cost.probes, [&](std::uint32_t t) {
        may_be_interrupted(1);
        if (mesh.pieces()[mesh.piece_of(t)].kind == PieceKind::open) return false;
        const TriangleCrossing crossing = crossing_of(from, to, placed.triangle(t));
        sum += crossing == TriangleCrossing::positive ? 1 : crossing == TriangleCrossing::negative ? -1 : 0;
        return crossing == TriangleCrossing::touch;
      });
  return touches ? std::nullopt : std::optional(sum);
}

MeshPoint mesh_point(const Mesh& mesh, const Pose& pose, const Posed3& point) {
  const PlacedMesh placed(mesh, pose);
  MeshPoint result;
  if (any_triangle_near(placed, enclosure(point), result.cost.probes,
                        [&](std::uint32_t t) { return triangles_meet({point, point, point}, placed.triangle(t)); })) {
    result.place = MeshPlace::on;
    return result;
  }
  const Affine3 identity;
  PointsBeyond beyond(placed, point);
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
