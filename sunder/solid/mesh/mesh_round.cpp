#include <sunder/solid/mesh/mesh_round.h>

#include <sunder/base/contract.h>
#include <sunder/solid/mesh/mesh_mesh.h>
#include <sunder/solid/mesh/mesh_point.h>
#include <sunder/solid/mesh/near_walk.h>
#include <sunder/solid/mesh/placed_mesh.h>
#include <sunder/solid/represent/of.h>
#include <sunder/solid/round/round_clearance.h>
#include <sunder/solid/round/round_distance.h>
#include <sunder/solid/round/round_round.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <vector>

namespace sunder::solid {

namespace {

// Around the ball of an ellipsoid.
const Mesh& cube_around_ball() {
  static const Mesh cube = [] {
    std::array<Point3, 8> corners;
    for (std::size_t k = 0; k < corners.size(); ++k) {
      corners[k] = {(k & 1) != 0 ? 1.0 : -1.0, (k & 2) != 0 ? 1.0 : -1.0, (k & 4) != 0 ? 1.0 : -1.0};
    }
    return mesh_of(ConvexPolyhedron(corners));
  }();
  return cube;
}

// All of the body is within a distance of this mesh, or inside of it.
const Mesh& around(const RoundBody& body) {
  if (body.kind() == RoundKind::ellipsoid) return cube_around_ball();
  return represent::of<HullMesh>(body.core()).mesh;
}

// How far the body reaches around that mesh.
double reach_around(const RoundBody& body) { return body.kind() == RoundKind::ellipsoid ? 0 : reach_beyond_core(body); }

// Not less than the sum.
double sum_above(double x, double y) { return std::nextafter(x + y, NearWalk::unbounded); }

// Which triangles have a point of the body, or are closer to it than `least`? Until one is.
class RoundSearch {
 public:
  RoundSearch(const Mesh& mesh, const Pose& pose, const PlacedRound& body, double least)
      : mesh_(mesh), pose_(pose), body_(body), least_(least) {}

  MeshRoundAnswer run() {
    const PlacedMesh placed(mesh_, pose_), core(around(body_.body), body_.pose);
    const bool is_hull = !body_.body.is_curved();
    double reach = sum_above(reach_around(body_.body), least_);
    const double surely_within = (body_.radius() + least_) * (1 - 0x1p-50);
    std::optional<std::uint32_t> asked;
    NearWalk(placed, core, answer_.cost).any(reach, [&](std::uint32_t t, std::uint32_t, const TriangleGap& gap) {
      if (is_hull && gap.distance.high < surely_within) {
        answer_.evidence = RoundOnTriangle{t};
        return true;
      }
      if (asked == t) return false;
      asked = t;
      return ask(t);
    });
    return result();
  }

  MeshRoundAnswer run_by_scan() {
    for (std::uint32_t t = 0; t < mesh_.triangles().size(); ++t) {
      may_be_interrupted(1);
      ++answer_.cost.probes;
      if (ask(t)) break;
    }
    MeshRoundAnswer answer = result();
    answer.decided_by = DecidedBy::scan;
    return answer;
  }

 private:
  bool ask(std::uint32_t t) {
    const RoundBody triangle = body_of_triangle(mesh_, t);
    const PlacedRound placed(triangle, pose_);
    ++answer_.cost.iterations;
    const Verdict found = least_ > 0 ? clearance_verdict(placed, body_, least_) : of_meeting(placed);
    if (found == Verdict::meet) answer_.evidence = RoundOnTriangle{t};
    if (found == Verdict::undecided) answer_.evidence = RoundNearTriangle{t};
    return found == Verdict::meet;
  }

  Verdict of_meeting(const PlacedRound& triangle) {
    const RoundAnswer found = round_round(triangle, body_);
    answer_.cost.exact += found.cost.exact;
    return found.verdict();
  }

  MeshRoundAnswer result() {
    if (!answer_.meet() && mesh_.has_inside()) {
      const MeshPoint first = mesh_point(mesh_, pose_, Posed3{body_.body.points()[0], &body_.pose.affine(), false});
      answer_.cost.probes += first.cost.probes;
      answer_.cost.exact += first.cost.exact;
      if (first.place == MeshPlace::inside) answer_.evidence = RoundWithinMesh{};
    }
    conclude(answer_, answer_.cost.exact);
    return answer_;
  }

  const Mesh& mesh_;
  const Pose& pose_;
  const PlacedRound& body_;
  double least_;  // 0: they are to meet
  MeshRoundAnswer answer_{MeshAndRoundApart{}};
};

// The nearest triangle, as far as enclosures tell.
class NearestTriangle {
 public:
  NearestTriangle(const Mesh& mesh, const Pose& pose, const PlacedRound& body) : mesh_(mesh), pose_(pose), body_(body) {
    answer_.distance = {NearWalk::unbounded, NearWalk::unbounded};
  }

  // Returns whether it lowered what is known.
  bool ask(std::uint32_t t) {
    const RoundBody triangle = body_of_triangle(mesh_, t);
    const RoundDistance found = round_distance(PlacedRound(triangle, pose_), body_);
    const Interval distance = distance_of(found);
    const std::optional<bool> is_nearer = best_ ? solid::is_nearer(found.evidence, *best_) : std::nullopt;
    ++answer_.cost.iterations;
    answer_.cost.exact += found.cost.exact;
    answer_.distance.low = std::min(answer_.distance.low, distance.low);
    if (!is_nearer.value_or(distance.high < answer_.distance.high)) return false;
    best_ = found.evidence;
    answer_.distance.high = distance.high;
    answer_.nearest = t;
    return true;
  }

  MeshRoundDistance by_trees() {
    const PlacedMesh placed(mesh_, pose_), core(around(body_.body), body_.pose);
    const double reach = reach_around(body_.body);
    NearWalk walk(placed, core, answer_.cost);
    double limit = NearWalk::unbounded;
    std::vector<bool> asked(mesh_.triangles().size(), false);
    const auto look = [&](std::uint32_t t, std::uint32_t, const TriangleGap& gap) {
      if (asked[t]) return false;
      asked[t] = true;
      if (ask(t)) limit = std::min(limit, sum_above(answer_.distance.high, reach));
      walk.look_along(gap.way);
      return false;
    };
    walk.dive(limit, look);
    walk.nearest_first(limit, look);
    return answer_;
  }

  MeshRoundDistance by_scan() {
    for (std::uint32_t t = 0; t < mesh_.triangles().size(); ++t) {
      may_be_interrupted(1);
      ask(t);
    }
    return answer_;
  }

 private:
  const Mesh& mesh_;
  const Pose& pose_;
  const PlacedRound& body_;
  std::optional<RoundDistanceEvidence> best_;
  MeshRoundDistance answer_;
};

// The distance 0, if the two meet. Nothing, if they are apart or undecided.
std::optional<MeshRoundDistance> known_distance(const MeshRoundAnswer& met) {
  if (!met.meet()) return std::nullopt;
  MeshRoundDistance none;
  if (const auto* meeting = std::get_if<RoundOnTriangle>(&met.evidence)) none.nearest = meeting->triangle;
  return none;
}

}  // namespace

RoundBody body_of_triangle(const Mesh& mesh, std::uint32_t triangle) {
  const auto& [i, j, k] = mesh.triangles()[triangle];
  return ConvexPolyhedron(std::array{mesh.points()[i], mesh.points()[j], mesh.points()[k]});
}

bool can_be_placed(const PlacedRound& body) { return can_be_placed(around(body.body), body.pose); }

MeshRoundAnswer mesh_round(const Mesh& mesh, const Pose& pose, const PlacedRound& body) {
  SUNDER_REQUIRE(can_be_placed(mesh, pose) && can_be_placed(body));
  return RoundSearch(mesh, pose, body, 0).run();
}

MeshRoundAnswer mesh_round_by_scan(const Mesh& mesh, const Pose& pose, const PlacedRound& body) {
  SUNDER_REQUIRE(can_be_placed(mesh, pose) && can_be_placed(body));
  return RoundSearch(mesh, pose, body, 0).run_by_scan();
}

MeshRoundAnswer mesh_round_clearance(const Mesh& mesh, const Pose& pose, const PlacedRound& body, double least) {
  SUNDER_REQUIRE(can_be_placed(mesh, pose) && can_be_placed(body) && least > 0 && std::isfinite(least));
  return RoundSearch(mesh, pose, body, least).run();
}

MeshRoundAnswer mesh_round_clearance_by_scan(const Mesh& mesh, const Pose& pose, const PlacedRound& body,
                                             double least) {
  SUNDER_REQUIRE(can_be_placed(mesh, pose) && can_be_placed(body) && least > 0 && std::isfinite(least));
  return RoundSearch(mesh, pose, body, least).run_by_scan();
}

MeshRoundDistance mesh_round_distance(const Mesh& mesh, const Pose& pose, const PlacedRound& body,
                                      const MeshRoundAnswer& met) {
  if (const auto known = known_distance(met)) return *known;
  return NearestTriangle(mesh, pose, body).by_trees();
}

MeshRoundDistance mesh_round_distance_by_scan(const Mesh& mesh, const Pose& pose, const PlacedRound& body,
                                              const MeshRoundAnswer& met) {
  if (const auto known = known_distance(met)) return *known;
  return NearestTriangle(mesh, pose, body).by_scan();
}

}  // namespace sunder::solid

namespace sunder {

solid::MeshRoundAnswer intersect(const solid::Mesh& mesh, const solid::Pose& pose, const solid::RoundBody& body,
                                 const solid::Pose& pose_body) {
  const solid::PlacedRound placed(body, pose_body);
  solid::require_can_be_placed(mesh, pose);
  solid::require_can_be_placed(solid::around(body), placed.pose);
  return solid::mesh_round(mesh, pose, placed);
}

}  // namespace sunder
