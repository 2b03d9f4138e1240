#include <sunder/solid/mesh/mesh_mesh.h>
#include <sunder/solid/mesh/mesh_mesh_internal.h>

#include <sunder/base/interruption.h>
#include <sunder/solid/mesh/mesh_point.h>
#include <sunder/solid/mesh/placed_mesh.h>

#include <algorithm>
#include <array>
#include <optional>

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
    cost.exact += found.cost.exact;
    if (found.place == MeshPlace::inside) return point;
  }
  return std::nullopt;
}

struct NodePair {
  std::size_t a = 1, b = 1;
  Box3 box_a{}, box_b{};
};

bool any_pair_of_leaves(const PlacedMesh& a, const PlacedMesh& b, const NodePair& leaves, Cost& cost, StageTally& tally,
                        FunctionRef<bool(const MeetingTriangles&)> of_pair) {
  const TriangleRange of_a = a.mesh().tree().triangles(leaves.a), of_b = b.mesh().tree().triangles(leaves.b);
  for (std::uint32_t t = of_a.first; t < of_a.end; ++t) {
    const Box3 box = a.box(t);
    ++cost.probes;
    if (!meet(box, leaves.box_b)) continue;
    for (std::uint32_t u = of_b.first; u < of_b.end; ++u) {
      ++cost.probes;
      if (!meet(box, b.box(u))) continue;
      ++cost.iterations;
      if (triangles_meet(a.triangle(t), b.triangle(u), &tally) && of_pair({t, u})) return true;
    }
  }
  return false;
}

}  // namespace

// Down both trees at once: of two nodes whose boxes meet the larger one is split.
bool any_meeting_triangles(const PlacedMesh& a, const PlacedMesh& b, Cost& cost, StageTally& tally,
                           FunctionRef<bool(const MeetingTriangles&)> of_pair) {
  const MeshTree &tree_a = a.mesh().tree(), &tree_b = b.mesh().tree();
  std::array<NodePair, 2 * MeshTree::deepest + 2> waiting;
  std::size_t count = 0;
  waiting[count++] = {1, 1, a.node_box(1), b.node_box(1)};
  while (count > 0) {
    may_be_interrupted(1);
    const NodePair here = waiting[--count];
    ++cost.probes;
    if (!meet(here.box_a, here.box_b)) continue;
    const bool leaf_a = tree_a.is_leaf(here.a), leaf_b = tree_b.is_leaf(here.b);
    if (leaf_a && leaf_b) {
      if (any_pair_of_leaves(a, b, here, cost, tally, of_pair)) return true;
      continue;
    }
    const bool of_a = !leaf_a && (leaf_b || longest_side(here.box_a) >= longest_side(here.box_b));
    for (const std::size_t k : {1u, 0u}) {
      NodePair& child = waiting[count++] = here;
      std::size_t& node = of_a ? child.a : child.b;
      node = 2 * node + k;
      (of_a ? child.box_a : child.box_b) = (of_a ? a : b).node_box(node);
    }
  }
  return false;
}

namespace {

std::optional<MeetingTriangles> first_pair_by_trees(const PlacedMesh& a, const PlacedMesh& b, Cost& cost,
                                                    StageTally& tally) {
  std::optional<MeetingTriangles> first;
  any_meeting_triangles(a, b, cost, tally, [&](const MeetingTriangles& pair) {
    first = pair;
    return true;
  });
  return first;
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
  conclude(answer, answer.cost.exact + tally.exact);
  return answer;
}

}  // namespace

bool can_be_placed(const Mesh& mesh, const Pose& pose) {
  return pose.linear_range().greatest < 0x1p1000 || mesh.sizes().greatest < 0x1p1020;
}

MeshAnswer mesh_mesh(const Mesh& a, const Pose& pose_a, const Mesh& b, const Pose& pose_b) {
  return answer_by(first_pair_by_trees, a, pose_a, b, pose_b);
}

MeshAnswer mesh_mesh_by_scan(const Mesh& a, const Pose& pose_a, const Mesh& b, const Pose& pose_b) {
  MeshAnswer answer = answer_by(first_pair_by_scan, a, pose_a, b, pose_b);
  answer.decided_by = DecidedBy::scan;
  return answer;
}

}  // namespace sunder::solid

namespace sunder {

solid::MeshAnswer intersect(const solid::Mesh& a, const solid::Pose& pose_a, const solid::Mesh& b,
                            const solid::Pose& pose_b) {
  if (!can_be_placed(a, pose_a) || !can_be_placed(b, pose_b)) {
    throw Error(ErrorCode::bad_pose,
                "entries of 2^1000 and more, of a mesh with coordinates of 2^1020; give smaller ones");
  }
  return mesh_mesh(a, pose_a, b, pose_b);
}

}  // namespace sunder
