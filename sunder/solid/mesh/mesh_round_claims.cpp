#include <sunder/solid/mesh/mesh_round_claims.h>

#include <sunder/base/contract.h>
#include <sunder/base/interruption.h>
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

namespace {

constexpr std::uint32_t few = 64;  // triangles: of so many the hull is asked about, of more their box

Posed3 first_point(const PlacedRound& body) { return {body.body.points()[0], &body.pose.affine(), false}; }

class PartsParting {
 public:
  PartsParting(const Mesh& mesh, const Pose& pose, const PlacedRound& body, double least)
      : placed_(mesh, pose), body_(body), least_(least) {}

  PartsBeside run() {
    part(1);
    const Mesh& mesh = placed_.mesh();
    if (mesh.has_inside() && parts_.ends.size() > 1) parts_.away.push_back(ray_away(placed_, first_point(body_)).along);
    return std::move(parts_);
  }

 private:
  void part(std::size_t node) {
    may_be_interrupted(1);
    const MeshTree& tree = placed_.mesh().tree();
    const TriangleRange range = tree.triangles(node);
    if (range.size() == 0 || take(range, node)) return;
    if (!tree.is_leaf(node)) {
      part(2 * node);
      part(2 * node + 1);
      return;
    }
    for (std::uint32_t t = range.first; t < range.end; ++t) {
      [[maybe_unused]] const bool is_parted = take({t, t + 1}, node);
      SUNDER_REQUIRE(is_parted);
    }
  }

  // Are these triangles parted from the body by one plane that is found?
  bool take(const TriangleRange& range, std::size_t node) {
    const bool is_hull = range.size() <= few;
    const std::optional<RoundBody> around = is_hull ? hull_of(range) : box_of(node);
    if (!around) return false;
    std::optional<std::array<Dyadic, 3>> direction = direction_from(PlacedRound(*around, placed_.pose()));
    if (!direction || (!is_hull && !parts(*direction, range))) return false;
    parts_.ends.push_back(range.end);
    parts_.directions.push_back(*std::move(direction));
    return true;
  }

  std::optional<std::array<Dyadic, 3>> direction_from(const PlacedRound& part) const {
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

  RoundBody hull_of(const TriangleRange& range) const {
    std::vector<Point3> corners;
    for (std::uint32_t t = range.first; t < range.end; ++t) {
      for (const std::uint32_t corner : placed_.mesh().triangles()[t]) corners.push_back(placed_.mesh().points()[corner]);
    }
    return ConvexPolyhedron(corners);
  }

  // About the box of a node, in the frame of the mesh. Nothing beyond the range of doubles.
  std::optional<RoundBody> box_of(std::size_t node) const {
    const MeshTree& tree = placed_.mesh().tree();
    const OrientedBox& box = tree.box(node);
    const std::array<std::array<float, 4>, 3> rows{box.x, box.y, box.z};
    std::array<Point3, 8> corners;
    for (std::size_t k = 0; k < corners.size(); ++k) {
      for (std::size_t c = 0; c < 3; ++c) {
        double at = static_cast<double>(rows[c][3]);
        for (std::size_t axis = 0; axis < 3; ++axis) {
          const auto reach = static_cast<double>(rows[c][axis]) * static_cast<double>(box.half[axis]);
          at += (k >> axis & 1) != 0 ? reach : -reach;
        }
        corners[k][c] = tree.middle()[c] + tree.unit() * at;
        if (!std::isfinite(corners[k][c])) return std::nullopt;
      }
    }
    return ConvexPolyhedron(corners);
  }

  // Exact.
  bool parts(const std::array<Dyadic, 3>& along, const TriangleRange& range) const {
    const WorldDirection direction(Vector3<Dyadic>{along[0], along[1], along[2]});
    const Posed3 any = placed_.at(0u);
    Along compared(direction, *any.pose, any.tame);
    const std::span<const Point3> points = placed_.mesh().points();
    std::uint32_t last = placed_.mesh().triangles()[range.first][0];
    for (std::uint32_t t = range.first; t < range.end; ++t) {
      for (const std::uint32_t corner : placed_.mesh().triangles()[t]) {
        if (compared.compare(points[last], points[corner]) == Sign::positive) last = corner;
      }
    }
    const RoundShape of_mesh{RoundKind::hull, {points[last], {}}, any.pose, 0};
    Cost cost;
    StageTally tally;
    const RoundShape of_body = shape_along(body_, direction, End::least, 0, cost, tally);
    if (least_ == 0) return gap_sign(direction, of_mesh, of_body) == Sign::positive;
    return clear_sign(direction, of_mesh, of_body, least_) != Sign::negative;
  }

  PlacedMesh placed_;
  const PlacedRound& body_;
  double least_;  // 0: the planes part strictly
  PartsBeside parts_;
};

// By the numbers of the points of the mesh: its corners, which are as they are numbered by the triangle's hull.
void name_points(const Mesh& mesh, std::uint32_t triangle, const ConvexPolyhedron& of, Combination& made) {
  for (Weights::Part& part : made.parts) {
    const Point3& at = of.vertices()[part.index];
    const Mesh::Triangle& corners = mesh.triangles()[triangle];
    part.index = *std::find_if(corners.begin(), corners.end(), [&](std::uint32_t k) {
      const Point3& p = mesh.points()[k];
      return p.x == at.x && p.y == at.y && p.z == at.z;
    });
  }
}

class RoundStatement {
 public:
  RoundStatement(PairClaims& pairs, const StatedMesh& mesh, std::uint32_t index_of_body, const PlacedRound& body,
            double least)
      : pairs_(pairs), file_(pairs.file()), mesh_(mesh), index_of_body_(index_of_body), body_(body), least_(least) {}

  void operator()(const MeshAndRoundApart&) const {
    const PartsBeside parts = parts_beside(mesh_.mesh, mesh_.pose, body_, least_);
    begin("apart", "kept");
    file_.begin_claims();
    file_.begin_claim(least_ > 0 ? "clear_beside" : "beside");
    file_.indices("until", parts.ends);
    for (const bool is_away : {false, true}) {
      file_.begin_list(is_away ? "away" : "directions");
      for (const auto& direction : is_away ? parts.away : parts.directions) file_.add_numbers(direction);
      file_.end_list();
    }
    file_.end_claim();
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
    const Vector3<Dyadic> at = coordinates<Dyadic>(first_point(body_));
    begin("b_within", "b_within");
    file_.numbers("point", std::array{at.x, at.y, at.z});
    file_.begin_claims();
    file_.begin_claim("encloses");
    file_.numbers("direction", ray_away(PlacedMesh(mesh_.mesh, mesh_.pose), first_point(body_)).along);
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
    name_points(mesh_.mesh, t, triangle.core(), points[0].of_body);
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
  return PartsParting(mesh, pose, body, least).run();
}

CommonPoint common_point(const Mesh& mesh, const Pose& pose, const PlacedRound& body, const RoundOnTriangle& evidence) {
  const RoundBody triangle = body_of_triangle(mesh, evidence.triangle);
  const PlacedRound placed(triangle, pose);
  const RoundAnswer met = round_round(placed, body);
  SUNDER_REQUIRE(met.meet());
  CommonPoint point = common_point_of(placed, body, met.evidence);
  name_points(mesh, evidence.triangle, triangle.core(), point.of_a);
  return point;
}

Point3 rounded_point_of(const Mesh& mesh, const Pose& pose, const PlacedRound& body, const MeshRoundEvidence& evidence) {
  if (const auto* meeting = std::get_if<RoundOnTriangle>(&evidence)) {
    return nearest(common_point(mesh, pose, body, *meeting).at);
  }
  const Vector3<Dyadic> at = coordinates<Dyadic>(first_point(body));
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
