// What is known of lines, rays and segments at a cube and at bodies without an inside.
#include <sunder/solid/line/polyhedron_line.h>
#include <sunder/solid/line/polyhedron_line_answer.h>
#include <sunder/solid/line/polyhedron_line_claims.h>
#include <sunder/solid/line/polyhedron_ray.h>
#include <sunder/solid/line/polyhedron_segment.h>
#include <sunder/solid/object/bodies_test.h>

#include <gtest/gtest.h>
#include <tests/support/shapes.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace sunder::solid {
namespace {

const ConvexPolyhedron& cube_to_cut() {
  static const ConvexPolyhedron body(tests::cube_corners(0, 2));
  return body;
}

// The facet whose corners all have this coordinate.
std::uint32_t facet_at(const ConvexPolyhedron& body, std::size_t axis, double x) {
  for (std::uint32_t f = 0; f < body.facet_count(); ++f) {
    const auto cycle = body.facet(f);
    if (std::all_of(cycle.begin(), cycle.end(), [&](std::uint32_t v) { return body.vertices()[v][axis] == x; })) {
      return f;
    }
  }
  ADD_FAILURE();
  return 0;
}

// Default ones of nothing.
CutEnd first_of(const PolyhedronCut& cut) { return ends_of(cut.evidence).value_or(CutEnds<CutEnd>{}).first; }
CutEnd last_of(const PolyhedronCut& cut) { return ends_of(cut.evidence).value_or(CutEnds<CutEnd>{}).last; }
CutFeature surface_of(const PolyhedronCut& cut) { return std::get<CutAlong>(cut.evidence).surface; }

CutFeature facet_feature(std::size_t axis, double x) { return {CutPlace::facet, facet_at(cube_to_cut(), axis, x), 0}; }
CutFeature vertex_feature(const Point3& p) { return {CutPlace::vertex, vertex_at(cube_to_cut(), p), 0}; }
CutFeature edge_feature(const Point3& p, const Point3& q) {
  const std::uint32_t v = vertex_at(cube_to_cut(), p), w = vertex_at(cube_to_cut(), q);
  return {CutPlace::edge, std::min(v, w), std::max(v, w)};
}

TEST(PolyhedronLine, ThroughFacets) {
  const Line line = Line::through({1, 0.5, 5}, {1, 0.5, 3});
  const PolyhedronCut cut = polyhedron_line(cube_to_cut(), line);
  EXPECT_EQ(kind_of(cut), CutKind::across);
  EXPECT_EQ(first_of(cut), (CutEnd{facet_feature(2, 2)}));
  EXPECT_EQ(last_of(cut), (CutEnd{facet_feature(2, 0)}));
  EXPECT_EQ(cut.decided_by, DecidedBy::filter);
  const ExactEnd first = exact_end(cube_to_cut(), Pose(), line.a, line.b, first_of(cut));
  EXPECT_EQ(first.rounded(), (Point3{1, 0.5, 2}));
  EXPECT_EQ(first.along_line.nearest(), 1.5);
  EXPECT_EQ(exact_end(cube_to_cut(), Pose(), line.a, line.b, last_of(cut)).along_line.nearest(), 2.5);
}

// Of each kind, of all methods; bodies without an inside have none.
TEST(PolyhedronLine, FacetsOfEntryAndExit) {
  const std::uint32_t low = facet_at(cube_to_cut(), 0, 0), high = facet_at(cube_to_cut(), 0, 2);
  for (const double z : {1.0, 2.0}) {  // across, and along a facet
    const Line line = Line::through({-1, 1, z}, {5, 1, z});
    for (const PolyhedronCut& cut :
         {polyhedron_line(cube_to_cut(), line), polyhedron_line_by_drums(cube_to_cut(), Pose(), line),
          polyhedron_line_by_scan(cube_to_cut(), Pose(), line)}) {
      const LineFacets facets = facets_of(cut.evidence).value();
      EXPECT_EQ(facets.enters, low);
      EXPECT_EQ(facets.leaves, high);
    }
  }
  const PolyhedronCut point = polyhedron_ray(cube_to_cut(), Ray::from({2, 1, 1}, {3, 1, 1}));
  EXPECT_EQ(facets_of(point.evidence).value().leaves, high);
  EXPECT_FALSE(facets_of(polyhedron_line(cube_to_cut(), Line::through({3, 0, 0}, {3, 1, 0})).evidence));
  const ConvexPolyhedron square(std::vector<Point3>{{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}});
  for (const Line& line : {Line::through({1, 1, -1}, {1, 1, 1}), Line::through({-1, 1, 0}, {5, 1, 0})}) {
    EXPECT_TRUE(polyhedron_line(square, line).meet());
    EXPECT_FALSE(facets_of(polyhedron_line(square, line).evidence));
    EXPECT_FALSE(facets_of(polyhedron_line_by_scan(square, Pose(), line).evidence));
  }
}

TEST(PolyhedronLine, ThroughVerticesAndEdges) {
  const PolyhedronCut diagonal = polyhedron_line(cube_to_cut(), Line::through({-1, -1, -1}, {5, 5, 5}));
  EXPECT_EQ(kind_of(diagonal), CutKind::across);
  EXPECT_EQ(first_of(diagonal).at, vertex_feature({0, 0, 0}));
  EXPECT_EQ(last_of(diagonal).at, vertex_feature({2, 2, 2}));
  const Line between_edges = Line::through({0, 1, 0}, {2, 1, 2});
  const PolyhedronCut edges = polyhedron_line(cube_to_cut(), between_edges);
  EXPECT_EQ(kind_of(edges), CutKind::across);
  EXPECT_EQ(first_of(edges).at, edge_feature({0, 0, 0}, {0, 2, 0}));
  EXPECT_EQ(last_of(edges).at, edge_feature({2, 0, 2}, {2, 2, 2}));
  EXPECT_EQ(exact_end(cube_to_cut(), Pose(), between_edges.a, between_edges.b, last_of(edges)).rounded(),
            (Point3{2, 1, 2}));
}

TEST(PolyhedronLine, AlongTheSurface) {
  const PolyhedronCut edge = polyhedron_line(cube_to_cut(), Line::through({2, 2, 7}, {2, 2, 9}));
  EXPECT_EQ(kind_of(edge), CutKind::along);
  EXPECT_EQ(surface_of(edge), edge_feature({2, 2, 0}, {2, 2, 2}));
  EXPECT_EQ(first_of(edge).at, vertex_feature({2, 2, 0}));
  EXPECT_EQ(last_of(edge).at, vertex_feature({2, 2, 2}));
  // The diagonal of a facet is no edge, and may be one of the triangles that a hierarchy makes of it.
  for (const auto& [from, to] : {std::array<Point3, 2>{{{0, 0, 2}, {2, 2, 2}}}, {{{2, 0, 2}, {0, 2, 2}}}}) {
    const PolyhedronCut facet = polyhedron_line(cube_to_cut(), Line::through(from, to));
    EXPECT_EQ(kind_of(facet), CutKind::along);
    EXPECT_EQ(surface_of(facet), facet_feature(2, 2));
    EXPECT_EQ(first_of(facet).at, vertex_feature(from));
    EXPECT_EQ(last_of(facet).at, vertex_feature(to));
  }
}

TEST(PolyhedronLine, TouchesOrMissesByOneBit) {
  const double above = std::nextafter(2.0, 3.0), below = std::nextafter(2.0, 1.0);
  const auto at_height = [](double z) { return polyhedron_line(cube_to_cut(), Line::through({-1, 1, z}, {5, 1, z})); };
  EXPECT_EQ(kind_of(at_height(2)), CutKind::along);
  EXPECT_EQ(kind_of(at_height(above)), CutKind::nothing);
  EXPECT_EQ(kind_of(at_height(below)), CutKind::across);
  const PolyhedronCut at_vertex = polyhedron_line(cube_to_cut(), Line::through({3, 1, 2}, {1, 3, 2}));
  EXPECT_EQ(kind_of(at_vertex), CutKind::point);
  EXPECT_EQ(first_of(at_vertex).at, vertex_feature({2, 2, 2}));
}

TEST(PolyhedronLine, ExtremeDoubles) {
  const double huge = std::numeric_limits<double>::max(), tiny = std::numeric_limits<double>::denorm_min();
  const ConvexPolyhedron large(tests::cube_corners(-huge, huge)), small(tests::cube_corners(-tiny, tiny));
  for (const ConvexPolyhedron* body : {&large, &small}) {
    const PolyhedronCut through = polyhedron_line(*body, Line::through({-huge, 0, 0}, {huge, 0, 0}));
    EXPECT_EQ(kind_of(through), CutKind::across);
    EXPECT_EQ(first_of(through).at, (CutFeature{CutPlace::facet, facet_at(*body, 0, body->box()[0].x), 0}));
    EXPECT_EQ(kind_of(polyhedron_line(*body, Line::through({0, 0, 0}, {tiny, 0, 0}))), CutKind::across);
  }
  EXPECT_EQ(kind_of(polyhedron_line(small, Line::through({-huge, 0, 2 * tiny}, {huge, 0, 2 * tiny}))),
            CutKind::nothing);
  EXPECT_EQ(kind_of(polyhedron_line(small, Line::through({-huge, 0, tiny}, {huge, 0, tiny}))), CutKind::along);
}

TEST(PolyhedronLine, OfAPoseThatReflects) {
  const Pose mirror = Pose::from_matrix({-1, 0, 0, 0, 1, 0, 0, 0, 1}, {0, 0, 0});  // x from -2 to 0
  const PolyhedronCut cut = polyhedron_line(cube_to_cut(), mirror, Line::through({-5, 1, 0.5}, {5, 1, 0.5}));
  EXPECT_EQ(kind_of(cut), CutKind::across);
  EXPECT_EQ(first_of(cut).at, facet_feature(0, 2));
  EXPECT_EQ(last_of(cut).at, facet_feature(0, 0));
}

TEST(PolyhedronRay, EndsInsideOnTheSurfaceAndBehind) {
  const auto from = [](double x) { return polyhedron_ray(cube_to_cut(), Ray::from({x, 1, 0.5}, {x + 1, 1, 0.5})); };
  EXPECT_EQ(first_of(from(-1)), (CutEnd{facet_feature(0, 0), OwnEnd::none}));
  EXPECT_EQ(first_of(from(0)), (CutEnd{facet_feature(0, 0), OwnEnd::a}));
  EXPECT_EQ(kind_of(from(0)), CutKind::across);
  EXPECT_EQ(first_of(from(1)), (CutEnd{{CutPlace::inside, 0, 0}, OwnEnd::a}));
  EXPECT_EQ(last_of(from(1)), (CutEnd{facet_feature(0, 2), OwnEnd::none}));
  EXPECT_EQ(kind_of(from(2)), CutKind::point);
  EXPECT_EQ(last_of(from(2)), (CutEnd{facet_feature(0, 2), OwnEnd::a}));
  EXPECT_EQ(kind_of(from(std::nextafter(2.0, 3.0))), CutKind::nothing);
  EXPECT_EQ(std::get<CutParting>(from(std::nextafter(2.0, 3.0)).evidence).by, CutParting::By::facet);
}

TEST(PolyhedronSegment, OnePointAndTwo) {
  const auto at = [](const Point3& p) { return polyhedron_segment(cube_to_cut(), Segment::between(p, p)); };
  EXPECT_EQ(kind_of(at({1, 1, 1})), CutKind::point);
  EXPECT_EQ(first_of(at({1, 1, 1})), (CutEnd{{CutPlace::inside, 0, 0}, OwnEnd::a}));
  EXPECT_EQ(last_of(at({1, 1, 2})), (CutEnd{facet_feature(2, 2), OwnEnd::a}));
  EXPECT_EQ(last_of(at({0, 1, 2})), (CutEnd{edge_feature({0, 0, 2}, {0, 2, 2}), OwnEnd::a}));
  EXPECT_EQ(last_of(at({0, 0, 2})), (CutEnd{vertex_feature({0, 0, 2}), OwnEnd::a}));
  EXPECT_EQ(kind_of(at({1, 1, std::nextafter(2.0, 3.0)})), CutKind::nothing);
  const PolyhedronCut inside = polyhedron_segment(cube_to_cut(), Segment::between({0.5, 1, 1}, {1.5, 1, 1}));
  EXPECT_EQ(kind_of(inside), CutKind::across);
  EXPECT_EQ(first_of(inside).own, OwnEnd::a);
  EXPECT_EQ(last_of(inside).own, OwnEnd::b);
  const PolyhedronCut to_facet = polyhedron_segment(cube_to_cut(), Segment::between({1, 1, 5}, {1, 1, 2}));
  EXPECT_EQ(kind_of(to_facet), CutKind::point);
  EXPECT_EQ(first_of(to_facet), (CutEnd{facet_feature(2, 2), OwnEnd::b}));
}

TEST(PolyhedronLine, BodiesWithoutAnInside) {
  const ConvexPolyhedron point(std::vector<Point3>{{1, 2, 3}});
  EXPECT_EQ(kind_of(polyhedron_line(point, Line::through({0, 0, 0}, {2, 4, 6}))), CutKind::point);
  EXPECT_EQ(kind_of(polyhedron_line(point, Line::through({0, 0, 0}, {2, 4, 7}))), CutKind::nothing);
  const ConvexPolyhedron segment(std::vector<Point3>{{0, 0, 0}, {4, 0, 0}});
  EXPECT_EQ(first_of(polyhedron_line(segment, Line::through({1, -1, 0}, {1, 1, 0}))).at,
            (CutFeature{CutPlace::edge, 0, 1}));
  EXPECT_EQ(kind_of(polyhedron_line(segment, Line::through({9, 0, 0}, {7, 0, 0}))), CutKind::along);
  EXPECT_EQ(kind_of(polyhedron_line(segment, Line::through({5, -1, 0}, {5, 1, 0}))), CutKind::nothing);
  EXPECT_EQ(kind_of(polyhedron_ray(segment, Ray::from({5, 0, 0}, {6, 0, 0}))), CutKind::nothing);
  const ConvexPolyhedron square(std::vector<Point3>{{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}});
  EXPECT_EQ(first_of(polyhedron_line(square, Line::through({1, 1, -1}, {1, 1, 1}))).at,
            (CutFeature{CutPlace::facet, 0, 0}));
  EXPECT_EQ(kind_of(polyhedron_line(square, Line::through({3, 1, -1}, {3, 1, 1}))), CutKind::nothing);
  const PolyhedronCut in_plane = polyhedron_line(square, Line::through({-1, 1, 0}, {5, 1, 0}));
  EXPECT_EQ(kind_of(in_plane), CutKind::along);
  EXPECT_EQ(surface_of(in_plane), (CutFeature{CutPlace::facet, 0, 0}));
  EXPECT_EQ(first_of(in_plane).at.place, CutPlace::edge);
}

// A proposal may come from anywhere.
TEST(LineAnswer, WrongProposalsDoNotHold) {
  const Pose pose;
  const Placed placed(cube_to_cut(), pose);
  const Line through = Line::through({1, 0.5, 5}, {1, 0.5, 3}), beside = Line::through({5, 0.5, 5}, {5, 0.5, 3});
  const std::uint32_t top = facet_at(cube_to_cut(), 2, 2), bottom = facet_at(cube_to_cut(), 2, 0),
                      side = facet_at(cube_to_cut(), 0, 2);
  const auto holds = [&](const Line& line, const LineProposal& proposal) {
    return LineAnswer(placed, line).dispose(proposal);
  };
  EXPECT_TRUE(holds(through, {LineProposal::Claim::through, top, bottom}));
  EXPECT_FALSE(holds(through, {LineProposal::Claim::through, top, 6}));
  EXPECT_FALSE(holds(through, {LineProposal::Claim::apart, top, side}));
  EXPECT_FALSE(holds(through, {LineProposal::Claim::apart, top, bottom}));
  EXPECT_TRUE(holds(beside, {LineProposal::Claim::apart, top, side}));
  EXPECT_FALSE(holds(beside, {LineProposal::Claim::apart, bottom, side}));
  EXPECT_FALSE(holds(beside, {LineProposal::Claim::apart, top, facet_at(cube_to_cut(), 0, 0)}));
  EXPECT_FALSE(holds(beside, {LineProposal::Claim::through, top, bottom}));
}

TEST(PolyhedronLineClaims, BodiesOfCertificates) {
  const Point3 a{1, 2, 3}, b{4, 5, 6};
  EXPECT_EQ(body_of(LineLike(Line{a, b})).ways.size(), 2u);
  EXPECT_EQ(body_of(LineLike(Ray{a, b})).ways.size(), 1u);
  EXPECT_EQ(body_of(LineLike(Segment{a, b})).points.size(), 2u);
  EXPECT_EQ(body_of(LineLike(Segment{a, a})).points.size(), 1u);
}

}  // namespace
}  // namespace sunder::solid
