#include <bench/peers/line_peer.h>
#include <bench/peers/sunder_lines.h>

#include <sunder/solid/line/polyhedron_line.h>
#include <sunder/solid/pair/polyhedron_polygon.h>
#include <sunder/solid/pair/polyhedron_polyhedron.h>
#include <sunder/solid/section/polyhedron_plane.h>
#include <sunder/solid/section/polyhedron_plane_section.h>

#include <algorithm>
#include <span>
#include <vector>

namespace bench {
namespace {

using sunder::Point3;
using sunder::solid::ConvexPolyhedron;
using sunder::solid::PlaneSection;
using sunder::solid::PolyhedronCut;
using sunder::solid::PolyhedronPlane;
using sunder::solid::Pose;
using sunder::solid::SectionPoints;

constexpr std::size_t kScanned = 300000;  // vertices, in all scans of a row

// The compiler has to suppose that all of the answer is read here.
template <class Answer>
void consume(const Answer& answer) {
  asm volatile("" : : "g"(&answer) : "memory");
}

template <class Answer>
Tally tally_of(const Answer& answer, bool right) {
  const auto by = [&](sunder::DecidedBy how) -> std::uint64_t { return answer.decided_by == how ? 1 : 0; };
  return {1,
          by(sunder::DecidedBy::filter),
          by(sunder::DecidedBy::evidence),
          by(sunder::DecidedBy::finishing),
          answer.cost.probes,
          answer.cost.iterations,
          answer.cost.exact,
          right ? 0U : 1U};
}

// The sum over all queries; ask(query) is the tally of one.
template <class Scenario, class Ask>
std::function<Tally()> tally_over(const Scenario& scenario, Ask ask) {
  return [&queries = scenario.queries, ask] {
    Tally sum;
    for (const auto& query : queries) sum += ask(query);
    return sum;
  };
}

// --- Lines -----------------------------------------------------------------------------------------------------------

PolyhedronCut cut_by(const ConvexPolyhedron& body, const LineQuery& query, LineBy by) {
  if (by == LineBy::drums) return polyhedron_line_by_drums(body, Pose(), query.line);
  return polyhedron_line(body, query.line);
}

// With the ends as nearest doubles.
std::uint64_t answer_with_ends(const ConvexPolyhedron& body, const LineQuery& query, const PolyhedronCut& cut) {
  const auto ends = ends_of(cut.evidence);
  if (!ends) return 0;
  const auto at = [&](const sunder::solid::CutEnd& end) {
    const Point3 p = exact_end(body, Pose(), query.line.a, query.line.b, end).rounded();
    return query.along(p.x, p.y, p.z);
  };
  return query.answer(at(ends->first), at(ends->last));
}

bool is_as_by_scan(const ConvexPolyhedron& body, const LineQuery& query, const PolyhedronCut& cut) {
  const PolyhedronCut scan = polyhedron_line_by_scan(body, Pose(), query.line);
  return kind_of(cut) == kind_of(scan) && ends_of(cut.evidence) == ends_of(scan.evidence);
}

// scan: by that too, which is linear, and slow.
bool is_right(const ConvexPolyhedron& body, const LineQuery& query, const PolyhedronCut& cut, bool scan) {
  return kind_of(cut) == query.kind && answer_with_ends(body, query, cut) == (query.meet() ? 1U : 0U) &&
         (!scan || is_as_by_scan(body, query, cut));
}

// --- Sections --------------------------------------------------------------------------------------------------------

// Does each corner name two vertices that are on both sides of the plane? No coordinate is rounded: line_scenarios.cpp.
bool are_across(const ConvexPolyhedron& body, const sunder::solid::Plane& plane, const PlaneSection& section) {
  const auto height = [&](std::uint32_t v) {
    const Point3 &n = plane.normal, &p = body.vertices()[v];
    return n.x * p.x + n.y * p.y + n.z * p.z - plane.offset;
  };
  return std::all_of(section.corners.begin(), section.corners.end(),
                     [&](const auto& corner) { return height(corner.above) > 0 && height(corner.below) < 0; });
}

void find_corners(const SectionPoints& points, const PlaneSection& section, std::vector<Point3>& corners) {
  corners.clear();
  for (const auto& corner : section.corners) corners.push_back(points.nearest(corner));
  consume(corners);
}

Run by_stack(const SectionScenario& scenario) {
  std::vector<double> offsets;
  for (const SectionQuery& q : scenario.queries) offsets.push_back(q.plane.offset);
  return [&scenario, offsets = std::move(offsets)](std::size_t first, std::size_t count) {
    const ConvexPolyhedron& body = scenario.body->hull;
    const Pose pose;
    const sunder::solid::Plane& plane = scenario.queries.front().plane;
    const std::span<const double> asked = std::span(offsets).subspan(first, count);
    SectionPoints points(body, pose, plane);
    std::vector<Point3> corners;
    std::uint64_t sum = 0;
    polyhedron_plane_sections(body, pose, plane, asked, [&](std::size_t k, const PlaneSection& section) {
      points.set_offset(asked[k]);
      find_corners(points, section, corners);
      sum += corners.size();
    });
    return sum;
  };
}

// --- Sides -----------------------------------------------------------------------------------------------------------

PolyhedronPlane side_by(const ConvexPolyhedron& body, const SideQuery& query, SideBy by) {
  switch (by) {
    case SideBy::drums: return polyhedron_plane_by_drums(body, Pose(), query.plane);
    case SideBy::scan: return polyhedron_plane_by_scan(body, Pose(), query.plane);
    default: return polyhedron_plane(body, Pose(), query.plane);
  }
}

}  // namespace

Ready prepare_sunder(const LineScenario& scenario, LineBy by) {
  const ConvexPolyhedron& body = scenario.body->hull;
  const auto ask = [&body, by](const LineQuery& query) -> std::uint64_t {
    const PolyhedronCut cut = cut_by(body, query, by);
    consume(cut);
    return by == LineBy::ends ? answer_with_ends(body, query, cut) : cut.meet() ? 1 : 0;
  };
  const std::size_t scans = by == LineBy::front_door ? kScanned / body.vertices().size() : 0;
  const auto tally = [&scenario, &body, by, scans](const LineQuery& query) {
    const PolyhedronCut cut = cut_by(body, query, by);
    const bool scan = static_cast<std::size_t>(&query - scenario.queries.data()) < scans;
    return tally_of(cut, is_right(body, query, cut, scan));
  };
  return {each([&scenario, ask](std::size_t k) { return ask(scenario.queries[k]); }), tally_over(scenario, tally)};
}  // NOLINT(clang-analyzer-cplusplus.NewDeleteLeaks): a std::function frees what it holds

Ready prepare_sunder(const SectionScenario& scenario, SectionBy by) {
  const ConvexPolyhedron& body = scenario.body->hull;
  const auto tally = [&body](const SectionQuery& query) {
    const PlaneSection section = polyhedron_plane_section(body, Pose(), query.plane);
    return tally_of(section, section.corners.size() == query.corners && are_across(body, query.plane, section));
  };
  if (by == SectionBy::stack) return {by_stack(scenario)};
  const auto ask = [&scenario, &body, by, corners = std::vector<Point3>()](std::size_t k) mutable -> std::uint64_t {
    const sunder::solid::Plane& plane = scenario.queries[k].plane;
    const Pose pose;
    const PlaneSection section = polyhedron_plane_section(body, pose, plane);
    consume(section);
    if (by == SectionBy::corners) find_corners(SectionPoints(body, pose, plane), section, corners);
    return section.corners.size();
  };
  return {each(ask), tally_over(scenario, tally)};
}  // NOLINT(clang-analyzer-cplusplus.NewDeleteLeaks): likewise

Ready prepare_sunder(const SideScenario& scenario, SideBy by) {
  const ConvexPolyhedron& body = scenario.body->hull;
  const auto ask = [&scenario, &body, by](std::size_t k) -> std::uint64_t {
    const PolyhedronPlane answer = side_by(body, scenario.queries[k], by);
    consume(answer);
    return answer.meet() ? 1 : 0;
  };
  const auto tally = [&body, by](const SideQuery& query) {
    const PolyhedronPlane answer = side_by(body, query, by);
    return tally_of(answer, answer.meet() == query.meet);
  };
  return {each(ask), tally_over(scenario, tally)};
}  // NOLINT(clang-analyzer-cplusplus.NewDeleteLeaks): likewise

Ready prepare_sunder(const PolygonScenario& scenario, PolygonBy by) {
  const ConvexPolyhedron& body = scenario.body->hull;
  const auto answer_of = [&body, by](const PolygonQuery& query) {
    switch (by) {
      case PolygonBy::drums: return polyhedron_polygon_by_drums(body, Pose(), query.polygon, Pose());
      case PolygonBy::scan: return polyhedron_polygon_by_scan(body, Pose(), query.polygon, Pose());
      default: return polyhedron_polyhedron(body, Pose(), query.polygon, Pose());
    }
  };
  const auto ask = [&scenario, answer_of](std::size_t k) -> std::uint64_t {
    const sunder::solid::PairAnswer answer = answer_of(scenario.queries[k]);
    consume(answer);
    return answer.meet() ? 1 : 0;
  };
  const auto tally = [answer_of](const PolygonQuery& query) {
    const sunder::solid::PairAnswer answer = answer_of(query);
    return tally_of(answer, answer.meet() == query.meet);
  };
  return {each(ask), tally_over(scenario, tally)};
}  // NOLINT(clang-analyzer-cplusplus.NewDeleteLeaks): likewise

Run scan_in_doubles(const SideScenario& scenario) {
  return each([&scenario](std::size_t k) -> std::uint64_t {
    const sunder::solid::Plane& plane = scenario.queries[k].plane;
    const Point3 &n = plane.normal, &p = plane.point;
    const double level = n.x * p.x + n.y * p.y + n.z * p.z + plane.offset;
    double low = HUGE_VAL, high = -HUGE_VAL;
    for (const Point3& v : scenario.body->hull.vertices()) {
      const double height = n.x * v.x + n.y * v.y + n.z * v.z;
      low = std::min(low, height);
      high = std::max(high, height);
    }
    return low <= level && level <= high ? 1 : 0;
  });
}

}  // namespace bench
