#include <sunder/solid/mesh/mesh_flat_claims.h>

#include <sunder/base/contract.h>
#include <sunder/predicate/coordinates.h>
#include <sunder/predicate/point/along.h>
#include <sunder/solid/mesh/mesh_round_claims.h>

#include <array>
#include <optional>
#include <utility>

namespace sunder::solid {

namespace {

constexpr Affine3 in_world{};

// For PartsParting: as polyhedron_line parts.
class LineBeside {
 public:
  explicit LineBeside(const LineLike& line) : line_(line) {
    std::visit([this](const auto& of) { ends_ = {of.a, of.b}; }, line);
  }

  Posed3 first_point() const { return {ends_[0], &in_world, false}; }

  std::optional<std::array<Dyadic, 3>> direction_from(const ConvexPolyhedron& part, const Pose& pose) const {
    const PolyhedronCut cut = polyhedron_line_like(part, pose, line_);
    if (cut.meet()) return std::nullopt;
    return parting_direction(part, pose, line_, cut);
  }

  // The direction is across a line, and a ray does not go back along it, as it parts a polyhedron from them.
  bool is_beyond(const WorldDirection& direction, const Posed3& last) const {
    const auto is_behind = [&](const Point3& end) {
      return compare_along(direction, last, Posed3{end, &in_world, false}) == Sign::positive;
    };
    return is_behind(ends_[0]) && (!std::holds_alternative<Segment>(line_) || is_behind(ends_[1]));
  }

 private:
  const LineLike& line_;
  std::array<Point3, 2> ends_{};
};

// A point of a triangle of the mesh that the plane has, with its weights of points of the mesh.
PointOf point_in_plane(const Mesh& mesh, const Pose& pose, const Plane& plane, std::uint32_t triangle) {
  const Mesh::Triangle& corners = mesh.triangles()[triangle];
  const auto image = [&](std::uint32_t v) {
    return coordinates<Dyadic>(Posed3{mesh.points()[v], &pose.affine(), false});
  };
  std::array<Dyadic, 3> heights;
  for (std::size_t k = 0; k < 3; ++k) heights[k] = height(plane, exact_point(image(corners[k])));
  Combination made;
  for (std::size_t k = 0; k < 3; ++k) {
    if (heights[k].sign() == Sign::zero) made = Combination({{corners[k], Dyadic(1.0)}});
  }
  for (std::size_t k = 0; k < 3 && made.parts.empty(); ++k) {
    const std::size_t next = (k + 1) % 3;
    if (heights[k].sign() != Sign::negative || heights[next].sign() != Sign::positive) continue;
    made = Combination({{corners[k], heights[next]}, {corners[next], -heights[k]}}, heights[next] - heights[k]);
  }
  SUNDER_REQUIRE(!made.parts.empty());
  const Vector3<Dyadic> at = numerators_of(made, image);
  return {exact_point(at, made.denominator), std::move(made)};
}

class FlatStatement {
 public:
  FlatStatement(PairClaims& pairs, const StatedMesh& mesh, std::uint32_t index_of_body)
      : pairs_(pairs), mesh_(mesh), index_of_body_(index_of_body) {}

  void apart(const PartsBeside& parts) const {
    pairs_.begin_statement("mesh_body", mesh_.index, index_of_body_, "apart");
    pairs_.file().begin_claims();
    add_parts(pairs_.file(), "beside", parts);
    pairs_.file().end_statement();
  }
  void meet(std::uint32_t triangle, const CommonPoint& point) const {
    pairs_.begin_statement("mesh_body", mesh_.index, index_of_body_, "meet");
    pairs_.file().fractions("point", point.at);
    pairs_.file().begin_claims();
    add_on_triangle(pairs_.file(), triangle, point.of_a);
    pairs_.add_combination("holds", point.of_b);
    pairs_.file().end_statement();
  }

 private:
  PairClaims& pairs_;
  const StatedMesh& mesh_;
  std::uint32_t index_of_body_;
};

}  // namespace

PartsBeside parts_beside(const Mesh& mesh, const Pose& pose, const LineLike& line) {
  const PlacedMesh placed(mesh, pose);
  const LineBeside beside(line);
  return PartsParting(placed, beside).run();
}

PartsBeside parts_beside(const Mesh& mesh, const Pose& pose, const Plane& plane) {
  const std::vector<Sign> side = sides_of_plane(mesh, pose, plane);
  const Vector3<Dyadic> n = coordinates<Dyadic>(plane.normal);
  PartsBeside parts;
  Sign last = Sign::zero;
  for (std::uint32_t t = 0; t < mesh.triangles().size(); ++t) {
    const Sign here = side[mesh.triangles()[t][0]];
    if (here != last) {
      parts.ends.push_back(t);
      parts.directions.push_back(here == Sign::positive ? std::array{-n.x, -n.y, -n.z} : std::array{n.x, n.y, n.z});
      last = here;
    }
    parts.ends.back() = t + 1;
  }
  if (mesh.has_inside() && parts.ends.size() > 1) {
    const std::optional<Point3> point = exact_point_of(plane);
    SUNDER_REQUIRE(point.has_value());  // a plane that a file has
    parts.away.push_back(ray_away(PlacedMesh(mesh, pose), Posed3{*point, &in_world, false}).along);
  }
  return parts;
}

ExactPoint3 common_point(const Mesh& mesh, const Pose& pose, const Plane& plane, std::uint32_t triangle) {
  return point_in_plane(mesh, pose, plane, triangle).at;
}

void add_claims(PairClaims& pairs, const StatedMesh& mesh, std::uint32_t index_of_body, const LineLike& line,
                const MeshLine& answer) {
  const FlatStatement statement(pairs, mesh, index_of_body);
  const auto* in_mesh = std::get_if<LineInMesh>(&answer.evidence);
  if (in_mesh == nullptr) return statement.apart(parts_beside(mesh.mesh, mesh.pose, line));
  SUNDER_REQUIRE(!in_mesh->hits.empty());
  const std::uint32_t triangle = in_mesh->hits.front().triangle;
  const auto& [i, j, k] = mesh.mesh.triangles()[triangle];
  const std::span<const Point3> points = mesh.mesh.points();
  const ConvexPolyhedron hull(std::array{points[i], points[j], points[k]});
  CommonPoint point = common_point_of(hull, mesh.pose, line, polyhedron_line_like(hull, mesh.pose, line));
  name_points_of_mesh(mesh.mesh, triangle, hull, point.of_a);
  statement.meet(triangle, point);
}

void add_claims(PairClaims& pairs, const StatedMesh& mesh, std::uint32_t index_of_body, const Plane& plane,
                const FlatBody& in_file, const MeshPlane& answer) {
  const FlatStatement statement(pairs, mesh, index_of_body);
  const auto* across = std::get_if<MeshAcrossPlane>(&answer.evidence);
  if (across == nullptr) return statement.apart(parts_beside(mesh.mesh, mesh.pose, plane));
  PointOf point = point_in_plane(mesh.mesh, mesh.pose, plane, across->triangle);
  Combination of_plane = combination_of(plane, in_file, point.at, false);
  statement.meet(across->triangle, {std::move(point.at), std::move(point.of_body), std::move(of_plane)});
}

}  // namespace sunder::solid
