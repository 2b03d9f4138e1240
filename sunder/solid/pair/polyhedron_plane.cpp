#include <sunder/predicate/along.h>
#include <sunder/predicate/plane_side.h>
#include <sunder/solid/pair/extreme_vertex.h>
#include <sunder/solid/pair/polyhedron_plane.h>
#include <sunder/solid/pair/polyhedron_plane_answer.h>
#include <sunder/solid/pair/support.h>

namespace sunder::solid {

namespace {

// The same ray, times a power of two, where no bit is lost, so that filters serve.
WorldDirection direction_of(const Point3& normal) {
  const double size = std::max({std::fabs(normal.x), std::fabs(normal.y), std::fabs(normal.z)});
  const int by = -std::ilogb(size) - 1;
  const Point3 scaled{std::ldexp(normal.x, by), std::ldexp(normal.y, by), std::ldexp(normal.z, by)};
  const Point3 back{std::ldexp(scaled.x, -by), std::ldexp(scaled.y, -by), std::ldexp(scaled.z, -by)};
  return WorldDirection(back == normal ? scaled : normal);
}

}  // namespace

Sign side_of(const Plane& plane, const Posed3& vertex, StageTally* tally) {
  return side_of_plane(plane.normal, plane.point, plane.offset, vertex, tally);
}

Point3 pulled_normal(const Placed& body, const Plane& plane) {
  Point3 normal = plane.normal;
  make_tame(normal);
  Point3 pulled = body.pulled(normal);
  make_tame(pulled);
  return pulled;
}

void conclude_plane(const Placed& body, const Plane& plane, const PlaneProposal& proposal, PolyhedronPlane& answer) {
  StageTally tally;
  const Sign low = side_of(plane, body[proposal.low], &tally);
  const Sign high = proposal.low == proposal.high ? low : side_of(plane, body[proposal.high], &tally);
  answer.cost.probes += 2;
  answer.below = proposal.low, answer.above = proposal.high;
  if (low * high != Sign::positive) {
    if (low == Sign::positive || high == Sign::negative) std::swap(answer.below, answer.above);
    conclude(answer, tally.exact);
    return;
  }
  // All on one side, so far: no vertex may be nearer.
  const std::uint32_t from = low == Sign::positive ? proposal.low : proposal.high;
  const WorldDirection normal = direction_of(plane.normal);
  Along along(normal, body.pose, body.tame);
  const std::uint32_t nearest = extreme_vertex_from(body, along, low == Sign::positive ? End::least : End::greatest,
                                                    from, answer.cost, tally);
  const Sign side = nearest == from ? low : side_of(plane, body[nearest], &tally);
  const bool apart = side == low;
  if (apart) {
    answer.side = side;
    answer.nearest = nearest;
  } else {
    answer.below = low == Sign::positive ? nearest : from;
    answer.above = low == Sign::positive ? from : nearest;
  }
  conclude(answer, tally.exact, nearest != from);
}

PolyhedronPlane polyhedron_plane(const ConvexPolyhedron& body, const Pose& pose, const Plane& plane) {
  return plane_answer_by(body, pose, plane, [&](const Placed& placed, Cost& cost) {
    const Point3 normal = pulled_normal(placed, plane);
    ++cost.probes;
    const bool above = side_of(plane, placed[0]) == Sign::positive;
    const std::uint32_t furthest = support(body, above ? negated(normal) : normal, cost.probes);
    return above ? PlaneProposal{furthest, furthest} : PlaneProposal{0, furthest};
  });
}

PolyhedronPlane polyhedron_plane_by_scan(const ConvexPolyhedron& body, const Pose& pose, const Plane& plane) {
  const Placed placed(body, pose);
  PolyhedronPlane answer;
  const auto n = static_cast<std::uint32_t>(body.vertices().size());
  std::uint32_t low = 0, high = 0;
  const WorldDirection normal(plane.normal);
  for (std::uint32_t v = 0; v < n; ++v) {
    ++answer.cost.probes;
    if (compare_along(normal, placed[v], placed[low]) == Sign::positive) low = v;
    if (compare_along(normal, placed[high], placed[v]) == Sign::positive) high = v;
  }
  const Sign of_low = side_of(plane, placed[low]), of_high = side_of(plane, placed[high]);
  answer.decided_by = DecidedBy::scan;
  answer.below = low, answer.above = high;
  if (of_low == Sign::positive || of_high == Sign::negative) {
    answer.side = of_low;
    answer.nearest = of_low == Sign::positive ? low : high;
  }
  return answer;
}

Contact polyhedron_plane_contact(const ConvexPolyhedron& body, const Pose& pose, const Plane& plane) {
  if (!polyhedron_plane(body, pose, plane).meet()) return Contact::none;
  const Placed placed(body, pose);
  const WorldDirection direction = direction_of(plane.normal);
  const Point3 normal = pulled_normal(placed, plane);
  const auto furthest = [&](End end) {
    Cost cost;
    StageTally tally;
    Along along(direction, placed.pose, placed.tame);
    const std::uint32_t near = support(body, end == End::least ? negated(normal) : normal, cost.probes);
    return side_of(plane, placed[extreme_vertex_from(placed, along, end, near, cost, tally)]);
  };
  const Sign low = furthest(End::least), high = furthest(End::greatest);
  return (low == Sign::zero) == (high == Sign::zero) ? Contact::overlapping : Contact::touching;
}

}  // namespace sunder::solid
