#include <sunder/solid/mesh/mesh_mesh.h>

#include <sunder/base/interruption.h>
#include <sunder/near/box_tree.h>
#include <sunder/solid/mesh/mesh_point.h>
#include <sunder/solid/mesh/placed_mesh.h>

#include <optional>
#include <vector>

namespace sunder::solid {

namespace {

// A piece of one that is inside of the other: a corner of it. Requires the surfaces to be apart.
std::optional<std::uint32_t> point_within(const PlacedMesh& of, const Mesh& other, const Pose& pose, Cost& cost) {
  if (!other.has_inside()) return std::nullopt;
  for (const Mesh::Piece& piece : of.mesh().pieces()) {
    const std::uint32_t point = of.mesh().triangles()[piece.first][0];
    const MeshPoint found = mesh_point(other, pose, of.at(point));
    cost.probes += found.cost.probes;
    cost.proposals += found.cost.proposals;
    if (found.place == MeshPlace::inside) return point;
  }
  return std::nullopt;
}

std::optional<MeetingTriangles> first_pair_by_tree(const PlacedMesh& a, const PlacedMesh& b, Cost& cost,
                                                   StageTally& tally) {
  std::vector<Box3> boxes;
  for (std::uint32_t u = 0; u < b.mesh().triangles().size(); ++u) boxes.push_back(b.box(u));
  const BoxTree tree(boxes);
  std::optional<MeetingTriangles> found;
  for (std::uint32_t t = 0; t < a.mesh().triangles().size() && !found; ++t) {
    may_be_interrupted(10);
    cost.probes += tree.for_each_meeting(a.box(t), BoxTree::no_group, [&](std::uint32_t u) {
      if (!found && triangles_meet(a.triangle(t), b.triangle(u), &tally)) found = MeetingTriangles{t, u};
    });
  }
  return found;
}

std::optional<MeetingTriangles> first_pair_by_scan(const PlacedMesh& a, const PlacedMesh& b, Cost& cost,
                                                   StageTally& tally) {
  for (std::uint32_t t = 0; t < a.mesh().triangles().size(); ++t) {
    for (std::uint32_t u = 0; u < b.mesh().triangles().size(); ++u) {
      may_be_interrupted(1);
      ++cost.probes;
      if (triangles_meet(a.triangle(t), b.triangle(u), &tally)) return MeetingTriangles{t, u};
    }
  }
  return std::nullopt;
}

MeshAnswer answer_by(decltype(first_pair_by_scan)* first_pair, const Mesh& a, const Pose& pose_a, const Mesh& b,
                     const Pose& pose_b) {
  const PlacedMesh placed_a(a, pose_a), placed_b(b, pose_b);
  MeshAnswer answer;
  StageTally tally;
  if (const auto found = first_pair(placed_a, placed_b, answer.cost, tally)) {
    answer.evidence = *found;
  } else if (const auto of_a = point_within(placed_a, b, pose_b, answer.cost)) {
    answer.evidence = PointWithin{true, *of_a};
  } else if (const auto of_b = point_within(placed_b, a, pose_a, answer.cost)) {
    answer.evidence = PointWithin{false, *of_b};
  }
  conclude(answer, tally.exact);
  return answer;
}

}  // namespace

MeshAnswer mesh_mesh(const Mesh& a, const Pose& pose_a, const Mesh& b, const Pose& pose_b) {
  return answer_by(first_pair_by_tree, a, pose_a, b, pose_b);
}

MeshAnswer mesh_mesh_by_scan(const Mesh& a, const Pose& pose_a, const Mesh& b, const Pose& pose_b) {
  MeshAnswer answer = answer_by(first_pair_by_scan, a, pose_a, b, pose_b);
  answer.decided_by = DecidedBy::scan;
  return answer;
}

}  // namespace sunder::solid
