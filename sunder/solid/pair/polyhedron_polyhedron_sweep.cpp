#include <sunder/certificate/direction.h>
#include <sunder/solid/exact/sweep_simplex.h>
#include <sunder/solid/pair/polyhedron_polyhedron.h>
#include <sunder/solid/pair/polyhedron_polyhedron_answer.h>
#include <sunder/solid/pair/polyhedron_polyhedron_sweep.h>
#include <sunder/solid/search/gjk_proposals.h>
#include <sunder/solid/search/placed.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>

namespace sunder::solid {

namespace {

PlacedVertices vertices_of(const Placed& body) { return {body.graph.vertices, body.pose, body.tame}; }

const Pose& pose_at(const Translation& of, bool is_end) { return is_end ? of.end() : of.begin(); }

// The difference of A and B, and what that is moved by on the way.
class SweptSupport : public GraphSupport<double> {
 public:
  SweptSupport(const Placed& a, const Placed& b, const Point3& path)
      : GraphSupport(a, b), moved_{path.x * scale, path.y * scale, path.z * scale} {}

  Point3 first_direction() const {
    const Point3 d = GraphSupport::first_direction();
    const Point3 half_way{d.x - moved_.x / 2, d.y - moved_.y / 2, d.z - moved_.z / 2};
    return dot(half_way, half_way) > 0 ? half_way : Point3{1, 0, 0};
  }
  DifferenceVertex furthest(const Point3& d, const DifferenceSimplex& simplex, Cost& cost) const {
    DifferenceVertex w = GraphSupport::furthest(d, simplex, cost);
    if (dot(d, moved_) > 0) w.at = {w.at.x + moved_.x, w.at.y + moved_.y, w.at.z + moved_.z};
    return w;
  }
  static bool are_same(const DifferenceVertex& v, const DifferenceVertex& w) { return v.at == w.at; }

 private:
  Point3 moved_;
};

// How A moves as seen from B, rounded.
Point3 relative_path(const Translation& of_a, const Translation& of_b) {
  const auto& [a0, a1] = std::pair(of_a.begin().affine().translation, of_a.end().affine().translation);
  const auto& [b0, b1] = std::pair(of_b.begin().affine().translation, of_b.end().affine().translation);
  return {(a1[0] - a0[0]) - (b1[0] - b0[0]), (a1[1] - a0[1]) - (b1[1] - b0[1]), (a1[2] - a0[2]) - (b1[2] - b0[2])};
}

}  // namespace

SweepAnswer polyhedron_polyhedron_sweep(const ConvexPolyhedron& a, const Translation& of_a,  //
                                        const ConvexPolyhedron& b, const Translation& of_b) {
  SweepAnswer answer;
  StageTally tally;
  const Placed first_a(a, of_a.begin()), first_b(b, of_b.begin()), last_a(a, of_a.end()), last_b(b, of_b.end());
  std::uint32_t near_a = 0, near_b = 0;  // extreme along the last direction that was tried
  for (const bool is_end : {false, true}) {
    if (is_end && of_a.rests() && of_b.rests()) break;
    const PairAnswer here = polyhedron_polyhedron(a, pose_at(of_a, is_end), b, pose_at(of_b, is_end));
    answer.cost.probes += here.cost.probes;
    answer.cost.iterations += here.cost.iterations;
    answer.cost.proposals += here.cost.proposals;
    tally.exact += static_cast<std::uint32_t>(here.cost.exact);
    const bool finished = here.decided_by == DecidedBy::finishing;
    if (const auto* common = std::get_if<CommonVertices>(&here.evidence)) {
      answer.evidence = CommonVerticesAtAnEnd{*common, is_end};
      conclude(answer, tally.exact, finished);
      return answer;
    }
    const Separation& apart = std::get<Separation>(here.evidence);
    near_a = apart.extreme_a, near_b = apart.extreme_b;
    // Does the direction hold at the other end? The vertices that are extreme along it are so at all times.
    const Placed &here_a = is_end ? last_a : first_a, &here_b = is_end ? last_b : first_b;
    const Placed &there_a = is_end ? first_a : last_a, &there_b = is_end ? first_b : last_b;
    const WorldDirection d = world_direction(apart.direction, vertices_of(here_a), vertices_of(here_b));
    if ((of_a.rests() && of_b.rests()) ||
        compare_along(d, there_a[near_a], there_b[near_b], &tally) == Sign::positive) {
      answer.evidence = SeparationOnTheWay{apart, is_end};
      conclude(answer, tally.exact, finished);
      return answer;
    }
  }
  // A direction that parts A and B, both of time 0, and A and B at the end.
  const auto holds = [&](const Proposal& proposal) {
    ++answer.cost.proposals;
    PairCertificate found;
    if (!dispose(first_a, first_b, proposal, found, answer.cost, tally)) return false;
    Separation& apart = std::get<Separation>(found);
    if (compare_along(WorldDirection(proposal.direction), last_a[apart.extreme_a], last_b[apart.extreme_b], &tally) !=
        Sign::positive) {
      return false;
    }
    answer.evidence = SeparationOnTheWay{std::move(apart)};
    return true;
  };
  const Point3 path = relative_path(of_a, of_b);
  Gjk<double, SweptSupport> search(first_a, first_b, path);
  search.begin({});
  const auto parts = [&](const DifferenceVertex& w) { return propose_apart(search, w, holds); };
  if (search.run({}, answer.cost, parts) == GjkEnd::stopped) {
    conclude(answer, tally.exact);
    return answer;
  }
  SweepOutcome found = decide_by_sweep_simplex(a, of_a, b, of_b, SweepTime::any, near_a, near_b, answer.cost, tally);
  if (found.contact) {
    answer.evidence = ContactOnTheWay{std::make_shared<const SweepContact>(*std::move(found.contact))};
  } else {
    answer.evidence =
        SeparationOnTheWay{{exact_direction(std::move(found.direction)), found.extreme_a, found.extreme_b}};
  }
  conclude(answer, tally.exact, true);
  return answer;
}

std::optional<SweepContact> polyhedron_polyhedron_first_contact(const ConvexPolyhedron& a, const Translation& of_a,  //
                                                                const ConvexPolyhedron& b, const Translation& of_b) {
  Cost cost;
  StageTally tally;
  return decide_by_sweep_simplex(a, of_a, b, of_b, SweepTime::first, 0, 0, cost, tally).contact;
}

std::array<Dyadic, 3> parting_direction(const SweepAnswer& answer,                           //
                                        const ConvexPolyhedron& a, const Translation& of_a,  //
                                        const ConvexPolyhedron& b, const Translation& of_b) {
  const auto& [separation, is_at_end] = std::get<SeparationOnTheWay>(answer.evidence);
  const Placed at_a(a, pose_at(of_a, is_at_end)), at_b(b, pose_at(of_b, is_at_end));
  const Vector3<Dyadic> d = world_direction(separation.direction, vertices_of(at_a), vertices_of(at_b)).exact();
  return {d.x, d.y, d.z};
}

}  // namespace sunder::solid
