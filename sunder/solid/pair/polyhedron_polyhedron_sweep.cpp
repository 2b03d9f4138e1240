#include <sunder/certificate/direction.h>
#include <sunder/solid/pair/gjk_search.h>
#include <sunder/solid/pair/placed.h>
#include <sunder/solid/pair/polyhedron_polyhedron.h>
#include <sunder/solid/pair/polyhedron_polyhedron_answer.h>
#include <sunder/solid/pair/polyhedron_polyhedron_sweep.h>
#include <sunder/solid/pair/settle.h>
#include <sunder/solid/pair/sweep_simplex.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>

namespace sunder::solid {

namespace {

PlacedVertices vertices_of(const Placed& body) { return {body.graph.vertices, body.pose, body.tame}; }

const Pose& pose_at(const Translation& of, SweepAnswer::Found found) {
  return found == SweepAnswer::Found::at_end ? of.end() : of.begin();
}

// Is w further along the search's direction than the face, by more than the noise of floating point?
bool gains_by(const GjkSearch<double>& search, const DifferenceVertex& w) {
  const DifferenceSimplex& simplex = search.simplex;
  if (simplex.count == 0) return true;
  for (std::size_t i = 0; i < static_cast<std::size_t>(simplex.count); ++i) {
    if (simplex.vertex[i].at == w.at) return false;
  }
  const Point3& d = search.direction;
  const double size = std::fabs(d.x * w.at.x) + std::fabs(d.y * w.at.y) + std::fabs(d.z * w.at.z);
  return dot(d, minus(w.at, simplex.vertex[0].at)) > 4 * search.noise * size;
}

// Gilbert, Johnson and Keerthi's search in doubles for a direction that parts A and B, both of time 0, and A moved by
// `path` and B: over the difference of the two, and what that is moved by. holds(direction, near_a, near_b): does it?
template <class Holds>
bool propose_direction(const Placed& a, const Placed& b, const Point3& path, const Holds& holds, Cost& cost) {
  GjkSearch<double> search(a, b);
  const double scale = search.simplex.scale;
  const Point3 moved{path.x * scale, path.y * scale, path.z * scale};
  Point3& d = search.direction;
  d = search.first_direction();
  d = {d.x - moved.x / 2, d.y - moved.y / 2, d.z - moved.z / 2};
  if (!(dot(d, d) > 0)) d = {1, 0, 0};
  Nearing<double> nearing;
  for (int i = 0; i < search.most_iterations; ++i) {
    ++cost.iterations;
    DifferenceVertex w = search.probe(cost);
    if (dot(d, moved) > 0) w.at = {w.at.x + moved.x, w.at.y + moved.y, w.at.z + moved.z};
    if (dot(d, w.at) < 0) {
      DifferenceVertex furthest = w;
      Point3 direction = d;
      if (settle(search.simplex, direction, furthest) && holds(direction, furthest.a, furthest.b)) return true;
    }
    if (!gains_by(search, w) || !search.step_to(w) || !nearing.goes_on(search.distance2)) return false;
  }
  return false;
}

// How A moves as seen from B, rounded.
Point3 relative_path(const Translation& of_a, const Translation& of_b) {
  const auto& [a0, a1] = std::pair(of_a.begin().affine().translation, of_a.end().affine().translation);
  const auto& [b0, b1] = std::pair(of_b.begin().affine().translation, of_b.end().affine().translation);
  return {(a1[0] - a0[0]) - (b1[0] - b0[0]), (a1[1] - a0[1]) - (b1[1] - b0[1]), (a1[2] - a0[2]) - (b1[2] - b0[2])};
}

}  // namespace

bool is_translation(const Pose& begin, const Pose& end) { return begin.affine().linear == end.affine().linear; }

Translation::Translation(const Pose& begin, const Pose& end) : begin_(begin), end_(end) {
  if (!is_translation(begin, end)) {
    throw Error(
        ErrorCode::bad_pose,
        "the two poses have different linear parts, so the body turns on its way; give the second the rotation of "
        "the first, number by number",
        "pose at the end");
  }
}

Interval SweepContact::about() const {
  const double nearest = nearest_ratio(time, denominator);
  const Sign rest = (Dyadic(nearest) * denominator - time).sign();
  if (rest == Sign::zero) return {nearest, nearest};
  constexpr double infinity = std::numeric_limits<double>::infinity();
  return rest == Sign::positive ? Interval{std::nextafter(nearest, -infinity), nearest}
                                : Interval{nearest, std::nextafter(nearest, infinity)};
}

SweepAnswer polyhedron_polyhedron_sweep(const ConvexPolyhedron& a, const Translation& of_a,  //
                                        const ConvexPolyhedron& b, const Translation& of_b) {
  SweepAnswer answer;
  StageTally tally;
  const Placed first_a(a, of_a.begin()), first_b(b, of_b.begin()), last_a(a, of_a.end()), last_b(b, of_b.end());
  for (const bool is_end : {false, true}) {
    if (is_end && of_a.rests() && of_b.rests()) break;
    const PairAnswer here = is_end ? polyhedron_polyhedron(a, of_a.end(), b, of_b.end())
                                   : polyhedron_polyhedron(a, of_a.begin(), b, of_b.begin());
    answer.cost.probes += here.cost.probes;
    answer.cost.iterations += here.cost.iterations;
    answer.cost.proposals += here.cost.proposals;
    tally.exact += static_cast<std::uint32_t>(here.cost.exact);
    answer.evidence = here.evidence;
    answer.found = is_end ? SweepAnswer::Found::at_end : SweepAnswer::Found::at_begin;
    const bool finished = here.decided_by == DecidedBy::finishing;
    if (here.meet() || (of_a.rests() && of_b.rests())) {
      conclude(answer, tally.exact, finished);
      return answer;
    }
    // Does the direction hold at the other end? The vertices that are extreme along it are so at all times.
    const Placed &here_a = is_end ? last_a : first_a, &here_b = is_end ? last_b : first_b;
    const Placed &there_a = is_end ? first_a : last_a, &there_b = is_end ? first_b : last_b;
    const WorldDirection d = world_direction(here.evidence.direction, vertices_of(here_a), vertices_of(here_b));
    if (compare_along(d, there_a[here.evidence.extreme_a], there_b[here.evidence.extreme_b], &tally) ==
        Sign::positive) {
      conclude(answer, tally.exact, finished);
      return answer;
    }
  }
  const auto parts = [&](const Point3& direction, std::uint32_t near_a, std::uint32_t near_b) {
    ++answer.cost.proposals;
    PairCertificate found;
    if (!dispose(first_a, first_b, apart_along(direction, near_a, near_b), found, answer.cost, tally)) return false;
    if (compare_along(WorldDirection(direction), last_a[found.extreme_a], last_b[found.extreme_b], &tally) !=
        Sign::positive) {
      return false;
    }
    answer.evidence = found;
    answer.found = SweepAnswer::Found::at_begin;
    return true;
  };
  if (propose_direction(first_a, first_b, relative_path(of_a, of_b), parts, answer.cost)) {
    conclude(answer, tally.exact);
    return answer;
  }
  SweepOutcome found = decide_by_sweep_simplex(a, of_a, b, of_b, SweepTime::any, answer.evidence.extreme_a,
                                               answer.evidence.extreme_b, answer.cost, tally);
  answer.evidence = {};
  if (found.contact) {
    answer.found = SweepAnswer::Found::between;
    answer.evidence.verdict = Verdict::meet;
    answer.contact = std::make_shared<const SweepContact>(*std::move(found.contact));
  } else {
    answer.found = SweepAnswer::Found::at_begin;
    answer.evidence.direction.kind = Direction::Kind::exact;
    answer.evidence.direction.numbers = std::make_shared<const std::array<Dyadic, 3>>(std::move(found.direction));
    answer.evidence.extreme_a = found.extreme_a;
    answer.evidence.extreme_b = found.extreme_b;
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
  const Placed at_a(a, pose_at(of_a, answer.found)), at_b(b, pose_at(of_b, answer.found));
  const Vector3<Dyadic> d = world_direction(answer.evidence.direction, vertices_of(at_a), vertices_of(at_b)).exact();
  return {d.x, d.y, d.z};
}

}  // namespace sunder::solid
