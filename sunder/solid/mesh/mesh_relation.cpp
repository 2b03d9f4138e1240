#include <sunder/solid/mesh/mesh_relation.h>

#include <sunder/base/interruption.h>
#include <sunder/solid/mesh/mesh_overlap.h>
#include <sunder/solid/mesh/mesh_point.h>
#include <sunder/solid/mesh/placed_mesh.h>

#include <algorithm>
#include <utility>
#include <variant>

namespace sunder::solid {

namespace {

// Of two whose surfaces are apart: are all pieces of `of` at that place of the other one?
bool are_all_pieces(MeshPlace place, const Mesh& of, const Pose& pose, const Mesh& other, const Pose& pose_other) {
  const PlacedMesh placed(of, pose);
  return std::all_of(of.pieces().begin(), of.pieces().end(), [&](const Mesh::Piece& piece) {
    may_be_interrupted(100);
    return mesh_point(other, pose_other, placed.at(of.triangles()[piece.first][0])).place == place;
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
  InsideKinds known;
  if (const auto inside = point_inside_both(a, pose_a, b, pose_b, answer.evidence, 4)) {
    result.inside = FinePoint{*inside, {}};
    known.both = true;
  }
  if (!a.is_closed() || !b.is_closed()) {
    result.relation = known.both ? Relation::overlapping : Relation::meeting;
    result.is_known = !known.both;
    return result;
  }
  known.only_a = knows_point_of_first_only(a, pose_a, b, pose_b);
  known.only_b = knows_point_of_first_only(b, pose_b, a, pose_a);
  if (!known.are_all()) {
    Partitioned partitioned = mesh_partition(a, pose_a, b, pose_b, known);
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
  // surfaces that are apart touch nowhere: it is a sheet that is inside of the other one
  if (result.relation == Relation::touching && std::holds_alternative<PointWithin>(answer.evidence)) {
    result.relation = Relation::meeting;
  }
  if (result.relation == Relation::meeting) result.partition.reset();
  if (result.relation != Relation::overlapping) result.inside.reset();
  return result;
}

}  // namespace sunder::solid
