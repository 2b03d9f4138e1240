#include <sunder/solid/mesh/mesh_plane.h>

#include <sunder/predicate/point/plane_sides.h>
#include <sunder/solid/mesh/placed_mesh.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

namespace sunder::solid {

namespace {

PlaneSides sides(const PlacedMesh& placed, const Plane& plane) {
  const Posed3 any = placed.at(0u);
  PlaneSides result(plane.normal, plane.point, *any.pose, any.tame, placed.mesh().sizes().greatest);
  result.set_offset(plane.offset);
  return result;
}

}  // namespace

std::vector<Sign> sides_of_plane(const Mesh& mesh, const Pose& pose, const Plane& plane, std::uint32_t* exact) {
  const PlacedMesh placed(mesh, pose);
  PlaneSides side_of = sides(placed, plane);
  StageTally tally;
  std::vector<Sign> result;
  for (const Point3& p : mesh.points()) result.push_back(side_of(p, &tally));
  if (exact != nullptr) *exact = tally.exact;
  return result;
}

MeshPlane mesh_plane(const Mesh& mesh, const Pose& pose, const Plane& plane) {
  MeshPlane answer;
  std::uint32_t exact = 0;
  const std::vector<Sign> side = sides_of_plane(mesh, pose, plane, &exact);
  answer.cost.probes = side.size();
  const auto is_some = [&](Sign sign) { return std::find(side.begin(), side.end(), sign) != side.end(); };
  const bool below = is_some(Sign::negative), above = is_some(Sign::positive);
  const std::span<const Mesh::Triangle> all = mesh.triangles();
  const auto meets = [&](const Mesh::Triangle& t) {
    return side[t[0]] == Sign::zero || side[t[0]] != side[t[1]] || side[t[0]] != side[t[2]];
  };
  const auto found = std::find_if(all.begin(), all.end(), meets);
  if (found != all.end()) {
    answer.evidence = MeshAcrossPlane{static_cast<std::uint32_t>(found - all.begin()), below, above};
  } else {
    // About the nearest; which of points that are as near is not said.
    const PlacedMesh placed(mesh, pose);
    PlaneSides side_of = sides(placed, plane);
    std::uint32_t nearest = 0;
    double least = std::numeric_limits<double>::infinity();
    for (std::uint32_t k = 0; k < side.size(); ++k) {
      const double height = std::fabs(side_of.height(mesh.points()[k]));
      if (height < least) least = height, nearest = k;
    }
    answer.evidence = MeshBesidePlane{below && above ? Sign::zero : above ? Sign::positive : Sign::negative, nearest};
  }
  conclude(answer, exact);
  return answer;
}

}  // namespace sunder::solid
