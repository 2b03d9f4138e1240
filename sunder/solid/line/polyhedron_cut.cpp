#include <sunder/base/names.h>
#include <sunder/predicate/coordinates.h>
#include <sunder/solid/line/polyhedron_cut.h>
#include <sunder/solid/line/polyhedron_line_answer.h>
#include <sunder/solid/search/placed.h>

#include <type_traits>
#include <utility>

namespace sunder::solid {

namespace {

using Exact = Vector3<Dyadic>;

// Of the plane through p with this normal, which is not perpendicular to the line.
ExactFraction where_line_meets(const Exact& a, const Exact& way, const Exact& p, const Exact& normal) {
  return ExactFraction::quotient(dot(normal, p - a), dot(normal, way));
}

}  // namespace

static_assert(std::is_trivially_copyable_v<PolyhedronCut::Evidence>);

std::string_view name_of(CutPlace place) {
  return name_in<CutPlace::inside>({"vertex", "edge", "facet", "inside"}, place);
}

std::optional<LineFacets> facets_of(const PolyhedronCut::Evidence& cut) {
  if (const auto* across = std::get_if<CutAcross>(&cut)) return across->facets;
  if (const auto* along = std::get_if<CutAlong>(&cut)) return along->facets;
  if (const auto* point = std::get_if<CutPoint>(&cut)) return point->facets;
  return std::nullopt;
}

ExactEnd exact_end(const ConvexPolyhedron& body, const Pose& pose, const Point3& a, const Point3& b,
                   const CutEnd& end) {
  return exact_end(Placed(body, pose), Line{a, b}, end);
}

ExactEnd exact_end(const Placed& body, const Line& line, const CutEnd& end) {
  const Exact from = coordinates<Dyadic>(line.a), to = coordinates<Dyadic>(line.b);
  if (end.own != OwnEnd::none) {
    const bool is_a = end.own == OwnEnd::a;
    const Exact& p = is_a ? from : to;
    return {{p.x, p.y, p.z, 1.0}, {Dyadic(is_a ? 0.0 : 1.0)}};
  }
  const auto vertex = [&](std::uint32_t v) { return coordinates<Dyadic>(body[v]); };
  const Exact way = to - from;
  const auto at = [&](ExactFraction t) -> ExactEnd {
    const auto& [n, m] = t;
    return {{from.x * m + way.x * n, from.y * m + way.y * n, from.z * m + way.z * n, m}, std::move(t)};
  };
  switch (end.at.place) {
    case CutPlace::vertex: {
      const Exact v = vertex(end.at.feature);
      return {{v.x, v.y, v.z, 1.0}, where_line_meets(from, way, v, way)};
    }
    case CutPlace::edge: {
      const Exact v = vertex(end.at.feature), e = vertex(end.at.other) - v;
      return at(where_line_meets(from, way, v, cross(e, cross(way, e))));
    }
    case CutPlace::facet: {
      const std::span<const std::uint32_t> corners = body.body.facet(end.at.feature);
      const Exact v = vertex(corners[0]);
      return at(where_line_meets(from, way, v, cross(vertex(corners[1]) - v, vertex(corners[2]) - v)));
    }
    case CutPlace::inside: break;  // own ends only
  }
  return {};
}

}  // namespace sunder::solid
