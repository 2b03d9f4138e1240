#include <sunder/base/interruption.h>
#include <sunder/predicate/coordinates.h>
#include <sunder/solid/mesh/mesh_mesh_claims.h>
#include <sunder/solid/mesh/mesh_mesh_internal.h>
#include <sunder/solid/mesh/mesh_overlap.h>
#include <sunder/solid/mesh/mesh_point.h>
#include <sunder/solid/mesh/placed_mesh.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <variant>

namespace sunder::solid {

namespace {

Point3 minus(const Point3& p, const Point3& q) { return {p.x - q.x, p.y - q.y, p.z - q.z}; }

Point3 image_about(const PlacedMesh& placed, std::uint32_t point) {
  const Vector3<double> at = rounded_image(placed.at(point));
  return {at.x, at.y, at.z};
}

// Across a triangle, of length 1; zero, where floating point finds no length.
Point3 normal_about(const PlacedMesh& placed, std::uint32_t triangle) {
  const Mesh::Triangle& corners = placed.mesh().triangles()[triangle];
  const Point3 p = image_about(placed, corners[0]), u = minus(image_about(placed, corners[1]), p),
               v = minus(image_about(placed, corners[2]), p);
  const Point3 n{u.y * v.z - u.z * v.y, u.z * v.x - u.x * v.z, u.x * v.y - u.y * v.x};
  const double length = std::hypot(n.x, n.y, n.z);
  if (!(length > 0) || !std::isfinite(length)) return {};
  return {n.x / length, n.y / length, n.z / length};
}

Point3 middle_about(const PlacedMesh& placed, std::uint32_t triangle) {
  Point3 middle;
  for (const std::uint32_t corner : placed.mesh().triangles()[triangle]) {
    const Point3 p = image_about(placed, corner);
    for (std::size_t c = 0; c < 3; ++c) middle[c] += p[c] / 3;
  }
  return middle;
}

bool is_finite(const Point3& p) { return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z); }

// About the way from one to the other, of length 1 at most.
Point3 way_to(const Point3& from, const Point3& to) {
  const Point3 way = minus(to, from);
  const double length = std::hypot(way.x, way.y, way.z);
  if (!(length > 0) || !std::isfinite(length)) return {};
  return {way.x / length, way.y / length, way.z / length};
}

class InnerPoint {
 public:
  InnerPoint(const Mesh& a, const Pose& pose_a, const Mesh& b, const Pose& pose_b)
      : a_(a), b_(b), pose_a_(pose_a), pose_b_(pose_b), placed_a_(a, pose_a), placed_b_(b, pose_b) {
    size_ = std::min(longest_side(placed_a_.node_box(1)), longest_side(placed_b_.node_box(1)));
  }

  // Near what two triangles have in common: into either mesh, as far as their triangles tell, and to the middles of both.
  std::optional<Point3> near(const MeetingTriangles& meeting) {
    const Point3 at = rounded_middle_of(a_, pose_a_, b_, pose_b_, meeting);
    const Point3 u = normal_about(placed_a_, meeting.of_a), v = normal_about(placed_b_, meeting.of_b),
                 to_a = way_to(at, middle_about(placed_a_, meeting.of_a)),
                 to_b = way_to(at, middle_about(placed_b_, meeting.of_b));
    return beside(at, u, v, {(to_a.x + to_b.x) / 8, (to_a.y + to_b.y) / 8, (to_a.z + to_b.z) / 8});
  }

  // Near a corner of one that is inside of the other: to the middle of a triangle that has it, and to either side.
  std::optional<Point3> near(const PointWithin& within) {
    const PlacedMesh& of = within.is_of_a ? placed_a_ : placed_b_;
    const auto triangles = of.mesh().triangles();
    const auto has_corner = [&](const Mesh::Triangle& t) {
      return std::find(t.begin(), t.end(), within.point) != t.end();
    };
    const auto found = std::find_if(triangles.begin(), triangles.end(), has_corner) - triangles.begin();
    const auto triangle = static_cast<std::uint32_t>(found);
    const Point3 at = image_about(of, within.point), n = normal_about(of, triangle);
    return beside(at, {n.x / 8, n.y / 8, n.z / 8}, {}, way_to(at, middle_about(of, triangle)));
  }

 private:
  std::optional<Point3> beside(const Point3& at, const Point3& u, const Point3& v, const Point3& w) {
    for (int k = 2; k <= 42; k += 8) {
      const double step = std::ldexp(size_, -k);
      for (const unsigned signs : {0u, 1u, 2u, 3u}) {
        const double i = signs & 1 ? -step : step, j = signs & 2 ? -step : step;
        Point3 p;
        for (std::size_t c = 0; c < 3; ++c) p[c] = at[c] + i * u[c] + j * v[c] + step * w[c];
        if (is_inside_both(p)) return p;
      }
    }
    return std::nullopt;
  }

  bool is_inside_both(const Point3& p) const {
    may_be_interrupted(10);
    if (!is_finite(p)) return false;
    return mesh_point(a_, pose_a_, p).place == MeshPlace::inside &&
           mesh_point(b_, pose_b_, p).place == MeshPlace::inside;
  }

  const Mesh &a_, &b_;
  const Pose &pose_a_, &pose_b_;
  PlacedMesh placed_a_, placed_b_;
  double size_;  // of the smaller one
};

}  // namespace

std::optional<Point3> point_inside_both(const Mesh& a, const Pose& pose_a, const Mesh& b, const Pose& pose_b,
                                        const MeshEvidence& evidence) {
  if (!a.has_inside() || !b.has_inside()) return std::nullopt;
  InnerPoint search(a, pose_a, b, pose_b);
  if (const auto* within = std::get_if<PointWithin>(&evidence)) return search.near(*within);
  std::optional<Point3> found;
  int pairs = 4;
  Cost cost;
  StageTally tally;
  any_meeting_triangles(PlacedMesh(a, pose_a), PlacedMesh(b, pose_b), cost, tally,
                        [&](const MeetingTriangles& meeting) {
                          found = search.near(meeting);
                          return found || --pairs == 0;
                        });
  return found;
}

bool knows_point_of_first_only(const Mesh& first, const Pose& pose_first, const Mesh& other, const Pose& pose_other) {
  const PlacedMesh placed(first, pose_first);
  const double size = longest_side(placed.node_box(1));
  const auto all = static_cast<std::uint32_t>(first.triangles().size());
  const std::uint32_t triangles = std::min(16u, all);
  for (std::uint32_t k = 0; k < triangles; ++k) {
    may_be_interrupted(100);
    const auto t = static_cast<std::uint32_t>(std::uint64_t{k} * all / triangles);
    const Point3 at = middle_about(placed, t), n = normal_about(placed, t);
    if (!is_finite(at) || mesh_point(other, pose_other, at).place != MeshPlace::outside) continue;
    for (int digits = 4; digits <= 40; digits += 12) {
      for (const double step : {std::ldexp(-size, -digits), std::ldexp(size, -digits)}) {
        const Point3 p{at.x + step * n.x, at.y + step * n.y, at.z + step * n.z};
        if (is_finite(p) && mesh_point(first, pose_first, p).place == MeshPlace::inside &&
            mesh_point(other, pose_other, p).place == MeshPlace::outside) {
          return true;
        }
      }
    }
  }
  return false;
}

bool has_inside_beside(const Mesh& mesh, const Pose& pose, std::uint32_t triangle) {
  const PlacedMesh placed(mesh, pose);
  const Point3 at = middle_about(placed, triangle), n = normal_about(placed, triangle);
  const double step = std::ldexp(longest_side(placed.node_box(1)), -30);
  for (const double way : {-step, step}) {
    const Point3 p{at.x + way * n.x, at.y + way * n.y, at.z + way * n.z};
    if (is_finite(p) && mesh_point(mesh, pose, p).place == MeshPlace::inside) return true;
  }
  return false;
}

}  // namespace sunder::solid
