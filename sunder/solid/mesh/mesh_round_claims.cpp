#include <sunder/solid/mesh/mesh_round_claims.h>

#include <sunder/base/contract.h>
#include <sunder/predicate/coordinates.h>
#include <sunder/predicate/point/along.h>
#include <sunder/solid/mesh/mesh_point.h>
#include <sunder/solid/mesh/placed_mesh.h>
#include <sunder/solid/round/round_clearance.h>
#include <sunder/solid/round/round_placed.h>
#include <sunder/solid/round/round_round.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>
#include <utility>
#include <variant>

namespace sunder::solid {

void name_points_of_mesh(const Mesh& mesh, std::uint32_t triangle, const ConvexPolyhedron& of, Combination& made) {
  for (Weights::Part& part : made.parts) {
    const Point3& at = of.vertices()[part.index];
    const Mesh::Triangle& corners = mesh.triangles()[triangle];
    part.index = *std::find_if(corners.begin(), corners.end(), [&](std::uint32_t k) { return mesh.points()[k] == at; });
  }
}

void add_parts(ClaimsWriter& file, const char* rule, const PartsBeside& parts) {
  file.begin_claim(rule);
  file.indices("until", parts.ends);
  for (const bool is_away : {false, true}) {
    file.begin_list(is_away ? "away" : "directions");
    for (const auto& direction : is_away ? parts.away : parts.directions) file.add_numbers(direction);
    file.end_list();
  }
  file.end_claim();
}

namespace {

Posed3 first_point_of(const PlacedRound& body) { return {body.body.points()[0], &body.pose.affine(), false}; }

// For PartsParting: as round_round and round_clearance part.
class RoundBeside {
 public:
  RoundBeside(const PlacedRound& body, double least) : body_(body), least_(least) {}

  Posed3 first_point() const { return first_point_of(body_); }

  std::optional<std::array<Dyadic, 3>> direction_from(const ConvexPolyhedron& polyhedron, const Pose& pose) const {
    const RoundBody of_part(polyhedron);
    const PlacedRound part(of_part, pose);
    if (least_ == 0) {
      const RoundAnswer answer = round_round(part, body_);
      if (answer.verdict() != Verdict::apart) return std::nullopt;
      return direction_of(part, body_, answer.evidence);
    }
    const RoundClearance answer = round_clearance(part, body_, least_);
    if (!is_kept(answer)) return std::nullopt;
    const Vector3<Dyadic> along = std::get<ClearanceKept>(answer.evidence).direction.exact();
    return std::array{along.x, along.y, along.z};
  }

  bool is_beyond(const WorldDirection& direction, const Posed3& last) const {
    const RoundShape of_mesh{RoundKind::hull, {last.point, {}}, last.pose, 0};
    Cost cost;
    StageTally tally;
    const RoundShape of_body = shape_along(body_, direction, End::least, 0, cost, tally);
    if (least_ == 0) return gap_sign(direction, of_mesh, of_body) == Sign::positive;
    return clear_sign(direction, of_mesh, of_body, least_) != Sign::negative;
  }

 private:
  const PlacedRound& body_;
  double least_;  // 0: the planes part strictly
};

class RoundStatement {
 public:
  RoundStatement(PairClaims& pairs, const StatedMesh& mesh, std::uint32_t index_of_body, const PlacedRound& body,
                 double least)
      : pairs_(pairs), file_(pairs.file()), mesh_(mesh), index_of_body_(index_of_body), body_(body), least_(least) {}

  void operator()(const MeshAndRoundApart&) const {
    const PartsBeside parts = parts_beside(mesh_.mesh, mesh_.pose, body_, least_);
    begin("apart", "kept");
    file_.begin_claims();
    add_parts(file_, least_ > 0 ? "clear_beside" : "beside", parts);
    file_.end_statement();
  }

  void operator()(const RoundOnTriangle& meeting) const {
    begin("meet", "broken");
    if (least_ > 0) {
      const std::array<PointOf, 2> points = two_points(meeting.triangle);
      file_.fractions("from_a", points[0].at);
      file_.fractions("to_b", points[1].at);
      hold(meeting.triangle, points[0].of_body, points[1].of_body);
      file_.begin_claim("nearer");
      file_.end_claim();
    } else {
      const CommonPoint point = common_point(mesh_.mesh, mesh_.pose, body_, meeting);
      file_.fractions("point", point.at);
      hold(meeting.triangle, point.of_a, point.of_b);
    }
    file_.end_statement();
  }

  void operator()(const RoundWithinMesh&) const {
    const Vector3<Dyadic> at = coordinates<Dyadic>(first_point_of(body_));
    begin("b_within", "b_within");
    file_.numbers("point", std::array{at.x, at.y, at.z});
    file_.begin_claims();
    file_.begin_claim("encloses");
    file_.numbers("direction", ray_away(PlacedMesh(mesh_.mesh, mesh_.pose), first_point_of(body_)).along);
    file_.end_claim();
    Combination first({{0, Dyadic(1.0)}});
    if (body_.kind() == RoundKind::ellipsoid) first.from = ExactPoint3{};
    pairs_.add_combination("holds", first);
    file_.end_statement();
  }

  void operator()(const RoundNearTriangle&) const { SUNDER_REQUIRE(false); }

 private:
  void begin(const char* verdict, const char* verdict_of_clearance) const {
    if (least_ == 0) return pairs_.begin_statement("mesh_body", mesh_.index, index_of_body_, verdict);
    pairs_.begin_statement("mesh_body_clearance", mesh_.index, index_of_body_, verdict_of_clearance);
    file_.real("least", least_);
  }

  void hold(std::uint32_t triangle, const Combination& of_mesh, const Combination& of_body) const {
    file_.begin_claims();
    add_on_triangle(file_, triangle, of_mesh);
    pairs_.add_combination("holds", of_body);
  }

  std::array<PointOf, 2> two_points(std::uint32_t t) const {
    const RoundBody triangle = body_of_triangle(mesh_.mesh, t);
    const RoundClearance found = round_clearance(PlacedRound(triangle, mesh_.pose), body_, least_);
    SUNDER_REQUIRE(is_broken(found));
    std::array<PointOf, 2> points = *std::get<ClearanceBroken>(found.evidence).points;
    name_points_of_mesh(mesh_.mesh, t, triangle.core(), points[0].of_body);
    return points;
  }

  PairClaims& pairs_;
  ClaimsWriter& file_;
  const StatedMesh& mesh_;
  std::uint32_t index_of_body_;
  const PlacedRound& body_;
  double least_;  // 0: whether they meet
};

}  // namespace

PartsBeside parts_beside(const Mesh& mesh, const Pose& pose, const PlacedRound& body, double least) {
  return PartsParting(PlacedMesh(mesh, pose), RoundBeside(body, least)).run();
}

CommonPoint common_point(const Mesh& mesh, const Pose& pose, const PlacedRound& body, const RoundOnTriangle& evidence) {
  const RoundBody triangle = body_of_triangle(mesh, evidence.triangle);
  const PlacedRound placed(triangle, pose);
  const RoundAnswer met = round_round(placed, body);
  SUNDER_REQUIRE(met.meet());
  CommonPoint point = common_point_of(placed, body, met.evidence);
  name_points_of_mesh(mesh, evidence.triangle, triangle.core(), point.of_a);
  return point;
}

Point3 rounded_point_of(const Mesh& mesh, const Pose& pose, const PlacedRound& body,
                        const MeshRoundEvidence& evidence) {
  if (const auto* meeting = std::get_if<RoundOnTriangle>(&evidence)) {
    return nearest(common_point(mesh, pose, body, *meeting).at);
  }
  const Vector3<Dyadic> at = coordinates<Dyadic>(first_point_of(body));
  return {at.x.nearest(), at.y.nearest(), at.z.nearest()};
}

void add_claims(PairClaims& pairs, const StatedMesh& mesh, std::uint32_t index_of_body, const PlacedRound& body,
                const MeshRoundEvidence& evidence) {
  std::visit(RoundStatement(pairs, mesh, index_of_body, body, 0), evidence);
}

void add_clearance(PairClaims& pairs, const StatedMesh& mesh, std::uint32_t index_of_body, const PlacedRound& body,
                   const MeshRoundEvidence& evidence, double least) {
  SUNDER_REQUIRE(least > 0);
  std::visit(RoundStatement(pairs, mesh, index_of_body, body, least), evidence);
}

}  // namespace sunder::solid
