#include <sunder/solid/mesh/mesh_relation.h>

#include <sunder/base/interruption.h>
#include <sunder/solid/mesh/mesh_overlap.h>
#include <sunder/solid/mesh/mesh_point.h>
#include <sunder/solid/mesh/placed_mesh.h>

#include <algorithm>
#include <cstdint>
#include <optional>
#include <utility>
#include <variant>

namespace sunder::solid {

namespace {

// Are all pieces of the first mesh at that place of the other one? Requires that the surfaces are apart.
bool are_all_pieces(MeshPlace place, const Mesh& of, const Pose& pose, const Mesh& other, const Pose& pose_other) {
  const PlacedMesh placed(of, pose);
  return std::all_of(of.pieces().begin(), of.pieces().end(), [&](const Mesh::Piece& piece) {
    may_be_interrupted(100);
    return mesh_point(other, pose_other, placed.at(of.triangles()[piece.first][0])).place == place;
  });
}

// Has it two triangles back to back, with nothing inside beside them? (Not seen where the two sides of such a sheet are
// cut into other triangles.) Beside a triangle is what is next to its middle, as floating point finds it.
bool may_have_sheets(const Mesh& mesh, const Pose& pose) {
  const auto repeated = mesh.repeated_triangles();
  return std::any_of(repeated.begin(), repeated.end(), [&](std::uint32_t triangle) {
    may_be_interrupted(1);
    return !has_inside_beside(mesh, pose, triangle);
  });
}

Relation relation_of(const InsideKinds& found) {
  if (found.both) {
    return found.only_a ? (found.only_b ? Relation::overlapping : Relation::b_part_of_a)
                        : (found.only_b ? Relation::a_part_of_b : Relation::equal);
  }
  return found.only_a && found.only_b ? Relation::touching : Relation::meeting;
}

}  // namespace

MeshRelation mesh_relation(const Mesh& a, const Pose& pose_a, const Mesh& b, const Pose& pose_b,
                           const MeshAnswer& answer) {
  MeshRelation result;
  if (!answer.meet()) return result;
  if (std::holds_alternative<PointWithin>(answer.evidence)) {
    const auto is_inside = [&](const Mesh& inner, const Pose& at, const Mesh& outer, const Pose& at_outer) {
      return inner.is_closed() && are_all_pieces(MeshPlace::inside, inner, at, outer, at_outer) &&
             are_all_pieces(MeshPlace::outside, outer, at_outer, inner, at);
    };
    if (is_inside(a, pose_a, b, pose_b)) return {Relation::a_inside_b, true, {}, {}};
    if (is_inside(b, pose_b, a, pose_a)) return {Relation::b_inside_a, true, {}, {}};
  }
  const PointsInside points = points_inside(a, pose_a, b, pose_b, answer.evidence);
  InsideKinds known = points.found;
  if (points.in_both) result.inside = FinePoint{{*points.in_both}};
  if (!a.is_closed() || !b.is_closed()) {
    result.relation = known.both ? Relation::overlapping : Relation::meeting;
    result.is_known = !known.both;
    return result;
  }
  if (!known.are_all()) {
    const auto* meeting = std::get_if<MeetingTriangles>(&answer.evidence);
    Partitioned partitioned =
        mesh_partition(a, pose_a, b, pose_b, known, meeting != nullptr ? std::optional(*meeting) : std::nullopt);
    known = partitioned.found;
    if (partitioned.in_both) result.inside = partitioned.in_both;
    result.is_known = partitioned.is_decided;
    if (!result.is_known) {
      result.relation = known.both ? Relation::overlapping : Relation::none;
      return result;
    }
    if (!known.are_all()) result.partition = std::move(partitioned.partition);
  }
  result.relation = relation_of(known);
  // If the surfaces are apart and no point is inside of both, a sheet of one mesh is inside of the other. The cells do not
  // see sheets, so the relation is not told then, nor where a mesh may have sheets.
  if (result.relation != Relation::overlapping && (std::holds_alternative<PointWithin>(answer.evidence) ||
                                                   may_have_sheets(a, pose_a) || may_have_sheets(b, pose_b))) {
    result.relation = Relation::meeting;
  }
  if (result.relation == Relation::meeting) result.partition.reset();
  if (result.relation != Relation::overlapping) result.inside.reset();
  return result;
}

}  // namespace sunder::solid
