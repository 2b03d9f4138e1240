#include <sunder/solid/mesh/mesh_point.h>

#include <sunder/base/interruption.h>
#include <sunder/base/names.h>
#include <sunder/base/random.h>
#include <sunder/predicate/coordinates.h>
#include <sunder/predicate/point/orient.h>
#include <sunder/solid/mesh/placed_boxes.h>
#include <sunder/solid/mesh/placed_triangles.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace sunder::solid {

namespace {

// Points beyond a placed mesh: in the frame of the mesh they are beyond its box along an axis, on the side where a point
// is nearest to its end, and about straight before or behind that point, so that few triangles are between.
class PointsBeyond {
 public:
  PointsBeyond(const PlacedMesh& placed, const Posed3& from) : pose_(*placed.at(0u).pose), box_(placed.mesh().box()) {
    from_ = about_in_frame(from);
    // Numbers of points are a quarter of their coordinates, so that there are points beyond any box.
    times_numbers_ = size_range(std::span<const double>(pose_.linear)).greatest < 0x1p1000 ? 4 : 1;
    for (double& entry : pose_.linear) entry *= times_numbers_;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t c = 0; c < 3; ++c) {
      size_ = std::max(size_, box_.high[c] / 2 - box_.low[c] / 2);
      const double before = from_[c] / 2 - box_.low[c] / 2, behind = box_.high[c] / 2 - from_[c] / 2;
      if (std::min(before, behind) >= least) continue;
      least = std::min(before, behind);
      axis_ = c;
      is_up_ = behind <= before;
    }
  }

  // Another one each time, further away, and further to the sides.
  Posed3 next() {
    while (true) {
      Point3 q;
      for (std::size_t c = 0; c < 3; ++c)
        q[c] = from_[c] / times_numbers_ + 0x1p-6 * times_ * size_ * random_.uniform(-1, 1);
      const double end = is_up_ ? std::max(box_.high[axis_], from_[axis_]) : std::min(box_.low[axis_], from_[axis_]);
      const double step = (times_ * size_ + std::fabs(end) * 0x1p-52) * random_.uniform(0.5, 1);
      q[axis_] = end / times_numbers_ + (is_up_ ? step : -step);
      if (times_ < 0x1p+60) times_ *= 2;
      for (std::size_t c = 0; c < 3; ++c) q[c] = std::clamp(q[c], -most, most);
      const double there = times_numbers_ * q[axis_];
      if (is_up_ ? there > box_.high[axis_] : there < box_.low[axis_]) return posed(q, pose_);
    }
  }

 private:
  static constexpr double most = std::numeric_limits<double>::max();

  // Floating point will do. Somewhere in the box, where it finds no number.
  Point3 about_in_frame(const Posed3& p) const {
    const std::array<double, 9>& m = pose_.linear;
    const std::array<double, 3>& t = pose_.translation;
    const auto& [n, s] = *p.pose;
    Point3 d, result;
    for (std::size_t r = 0; r < 3; ++r) {
      d[r] = n[3 * r] * p.point.x + n[3 * r + 1] * p.point.y + n[3 * r + 2] * p.point.z + s[r] - t[r];
    }
    const auto minor = [&](std::size_t r, std::size_t c) {
      const std::size_t r1 = (r + 1) % 3, r2 = (r + 2) % 3, c1 = (c + 1) % 3, c2 = (c + 2) % 3;
      return m[3 * r1 + c1] * m[3 * r2 + c2] - m[3 * r1 + c2] * m[3 * r2 + c1];
    };
    const double determinant = m[0] * minor(0, 0) + m[1] * minor(0, 1) + m[2] * minor(0, 2);
    for (std::size_t c = 0; c < 3; ++c) {
      result[c] = (minor(0, c) * d.x + minor(1, c) * d.y + minor(2, c) * d.z) / determinant;
      if (!(std::fabs(result[c]) <= most)) result[c] = box_.low[c] / 2 + box_.high[c] / 2;
    }
    return result;
  }

  Affine3 pose_;
  Box3 box_;
  Point3 from_;
  double size_ = 0x1p-1020, times_numbers_ = 1;
  std::size_t axis_ = 0;
  bool is_up_ = true;
  double times_ = 0x1p-5;
  Random random_{20261130};
};

}  // namespace

std::string_view name_of(MeshPlace place) { return name_in<MeshPlace::inside>({"outside", "on", "inside"}, place); }

std::optional<std::int64_t> crossings_along(const PlacedMesh& placed, const Posed3& from, const Posed3& to,
                                            Cost& cost) {
  constexpr std::uint32_t root = 1;
  return crossings_among(placed, from, to, {&root, 1}, {}, cost);
}

std::optional<std::int64_t> crossings_among(const PlacedMesh& placed, const Posed3& from, const Posed3& to,
                                            std::span<const std::uint32_t> nodes,
                                            std::span<const std::uint32_t> triangles, Cost& cost) {
  const Mesh& mesh = placed.mesh();
  std::int64_t sum = 0;
  StageTally tally;
  const SegmentPast goes_past(placed, from, to);
  const auto touches = [&](std::uint32_t t) {
    may_be_interrupted(1);
    if (mesh.pieces()[mesh.piece_of(t)].kind == PieceKind::open || goes_past(t)) return false;
    const TriangleCrossing crossing = crossing_of(from, to, placed.triangle(t), &tally);
    sum += crossing == TriangleCrossing::positive ? 1 : crossing == TriangleCrossing::negative ? -1 : 0;
    return crossing == TriangleCrossing::touch;
  };
  cost.probes += triangles.size();
  const bool touches_any = std::any_of(triangles.begin(), triangles.end(), touches) ||
                           std::any_of(nodes.begin(), nodes.end(), [&](std::uint32_t node) {
                             return any_triangle_near(placed, from, to, cost.probes, touches, node);
                           });
  cost.exact += tally.exact;
  return touches_any ? std::nullopt : std::optional(sum);
}

namespace {

// From a point on no triangle to one beyond the mesh: the crossings, and that point.
template <class OfEnd>
std::int64_t winding_of(const PlacedMesh& placed, const Posed3& point, Cost& cost, const OfEnd& of_end) {
  PointsBeyond beyond(placed, point);
  while (true) {
    may_be_interrupted(100);
    ++cost.proposals;
    const Posed3 end = beyond.next();
    const std::optional<std::int64_t> sum = crossings_along(placed, point, end, cost);
    if (!sum) continue;
    of_end(end);
    return placed.mesh().is_by_winding() ? *sum : std::int64_t{*sum % 2 != 0};
  }
}

}  // namespace

RayAway ray_away(const PlacedMesh& placed, const Posed3& point) {
  RayAway ray;
  Cost cost;
  ray.winding = winding_of(placed, point, cost, [&](const Posed3& end) {
    const Vector3<Dyadic> way = coordinates<Dyadic>(end) - coordinates<Dyadic>(point);
    ray.along = {way.x, way.y, way.z};
  });
  return ray;
}

bool is_on_triangle(const PlacedMesh& placed, const Posed3& point, Cost& cost) {
  StageTally tally;
  const Box3 around = enclosure(point);
  const bool is_on = any_triangle_near(placed, point, point, cost.probes, [&](std::uint32_t t) {
    const PosedTriangle corners = placed.triangle(t);
    if (orient_3d(corners[0], corners[1], corners[2], point, &tally) != Sign::zero) return false;
    return meet(placed.box(t), around) && triangles_meet({point, point, point}, corners, &tally);
  });
  cost.exact += tally.exact;
  return is_on;
}

MeshPoint mesh_point(const Mesh& mesh, const Pose& pose, const Posed3& point) {
  const PlacedMesh placed(mesh, pose);
  MeshPoint result;
  if (is_on_triangle(placed, point, result.cost)) {
    result.place = MeshPlace::on;
    return result;
  }
  result.winding = winding_of(placed, point, result.cost, [](const Posed3&) {});
  result.place = *result.winding == 0 ? MeshPlace::outside : MeshPlace::inside;
  return result;
}

MeshPoint mesh_point(const Mesh& mesh, const Pose& pose, const Point3& point) {
  const Affine3 identity;
  return mesh_point(mesh, pose, posed(point, identity));
}

}  // namespace sunder::solid
