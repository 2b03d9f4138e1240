#include <sunder/predicate/point/along.h>
#include <sunder/predicate/point/plane_side.h>
#include <sunder/solid/search/extreme_vertex.h>
#include <sunder/solid/search/support.h>
#include <sunder/solid/section/polyhedron_plane.h>
#include <sunder/solid/section/polyhedron_plane_answer.h>

namespace sunder::solid {

WorldDirection direction_of(const Point3& normal) {
  const double size = std::max({std::fabs(normal.x), std::fabs(normal.y), std::fabs(normal.z)});
  const int by = -std::ilogb(size) - 1;
  const Point3 scaled{std::ldexp(normal.x, by), std::ldexp(normal.y, by), std::ldexp(normal.z, by)};
  const Point3 back{std::ldexp(scaled.x, -by), std::ldexp(scaled.y, -by), std::ldexp(scaled.z, -by)};
  return WorldDirection(back == normal ? scaled : normal);
}

Sign side_of(const Plane& plane, const Posed3& vertex, StageTally* tally) {
  return side_of_plane(plane.normal, plane.point, plane.offset, vertex, tally);
}

bool conclude_plane(const Placed& body, const Plane& plane, const PlaneProposal& proposal, PolyhedronPlane& answer,
                    StageTally& tally) {
  const auto meet_at = [&](std::uint32_t v, Sign of_v, std::uint32_t w) {
    answer.evidence = of_v == Sign::positive ? AcrossPlane{w, v} : AcrossPlane{v, w};
  };
  const std::uint32_t first = proposal.first, furthest = proposal.furthest;
  answer.cost.probes += 2;
  const Sign of_first = side_of(plane, body[first], &tally);
  if (of_first == Sign::zero || side_of(plane, body[furthest], &tally) != of_first) {
    meet_at(first, of_first, of_first == Sign::zero ? first : furthest);
    return true;
  }
  // All on one side, so far: no vertex may be nearer.
  const WorldDirection normal = direction_of(plane.normal);
  Along along(normal, body.pose, body.tame);
  const std::uint32_t nearest = extreme_vertex_from(
      body, along, of_first == Sign::positive ? End::least : End::greatest, furthest, answer.cost, tally);
  if (nearest != furthest && side_of(plane, body[nearest], &tally) != of_first) {
    meet_at(first, of_first, nearest);
    return false;
  }
  answer.evidence = BesidePlane{of_first, nearest};
  return nearest == furthest;
}

PolyhedronPlane polyhedron_plane(const ConvexPolyhedron& body, const Pose& pose, const Plane& plane) {
  std::uint32_t found = 0;
  return plane_answer_by(body, pose, plane, [&]<class Real>(const Placed& placed, Real, Cost& cost) {
    ++cost.probes;
    const bool is_above = side_of(plane, placed[0]) == Sign::positive;
    VectorOf<Real> towards = pulled_normal<Real>(placed, plane);
    if (is_above) towards = negated(towards);
    if constexpr (std::is_same_v<Real, double>) {
      found = support(body, towards, cost.probes);
    } else {
      found = support_in_double_doubles(body, towards, found, cost.probes);
    }
    return PlaneProposal{0, found};
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
  if (of_low == Sign::positive || of_high == Sign::negative) {
    answer.evidence = BesidePlane{of_low, of_low == Sign::positive ? low : high};
  } else {
    answer.evidence = AcrossPlane{low, high};
  }
  return answer;
}

Relation polyhedron_plane_contact(const ConvexPolyhedron& body, const Pose& pose, const Plane& plane) {
  if (!polyhedron_plane(body, pose, plane).meet()) return Relation::none;
  const Placed placed(body, pose);
  const WorldDirection direction = direction_of(plane.normal);
  const Point3 normal = pulled_normal<double>(placed, plane);
  const auto furthest = [&](End end) {
    Cost cost;
    StageTally tally;
    Along along(direction, placed.pose, placed.tame);
    const std::uint32_t near = support(body, end == End::least ? negated(normal) : normal, cost.probes);
    return side_of(plane, placed[extreme_vertex_from(placed, along, end, near, cost, tally)]);
  };
  const Sign low = furthest(End::least), high = furthest(End::greatest);
  return (low == Sign::zero) == (high == Sign::zero) ? Relation::overlapping : Relation::touching;
}

}  // namespace sunder::solid
