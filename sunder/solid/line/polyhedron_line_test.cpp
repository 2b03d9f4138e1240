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

CutFeature facet_feature(std::size_t axis, double x) { return {CutPlace::facet, facet_at(cube_to_cut(), axis, x), 0}; }
CutFeature vertex_feature(const Point3& p) { return {CutPlace::vertex, vertex_at(cube_to_cut(), p), 0}; }
CutFeature edge_feature(const Point3& p, const Point3& q) {
  const std::uint32_t v = vertex_at(cube_to_cut(), p), w = vertex_at(cube_to_cut(), q);
  return {CutPlace::edge, std::min(v, w), std::max(v, w)};
}

TEST(PolyhedronLine, ThroughFacets) {
  const Line line = Line::through({1, 0.5, 5}, {1, 0.5, 3});
  const PolyhedronCut cut = polyhedron_line(cube_to_cut(), line);
  EXPECT_EQ(cut.kind, CutKind::across);
  EXPECT_EQ(cut.first, (CutEnd{facet_feature(2, 2)}));
  EXPECT_EQ(cut.last, (CutEnd{facet_feature(2, 0)}));
  EXPECT_EQ(cut.decided_by, DecidedBy::filter);
  const ExactEnd first = exact_end(cube_to_cut(), Pose(), line.a, line.b, cut.first);
  EXPECT_EQ(first.rounded(), (Point3{1, 0.5, 2}));
  EXPECT_EQ(first.along_line.nearest(), 1.5);
  EXPECT_EQ(exact_end(cube_to_cut(), Pose(), line.a, line.b, cut.last).along_line.nearest(), 2.5);
}

TEST(PolyhedronLine, ThroughVerticesAndEdges) {
  const PolyhedronCut diagonal = polyhedron_line(cube_to_cut(), Line::through({-1, -1, -1}, {5, 5, 5}));
  EXPECT_EQ(diagonal.kind, CutKind::across);
  EXPECT_EQ(diagonal.first.at, vertex_feature({0, 0, 0}));
  EXPECT_EQ(diagonal.last.at, vertex_feature({2, 2, 2}));
  const Line between_edges = Line::through({0, 1, 0}, {2, 1, 2});
  const PolyhedronCut edges = polyhedron_line(cube_to_cut(), between_edges);
  EXPECT_EQ(edges.kind, CutKind::across);
  EXPECT_EQ(edges.first.at, edge_feature({0, 0, 0}, {0, 2, 0}));
  EXPECT_EQ(edges.last.at, edge_feature({2, 0, 2}, {2, 2, 2}));
  EXPECT_EQ(exact_end(cube_to_cut(), Pose(), between_edges.a, between_edges.b, edges.last).rounded(),
            (Point3{2, 1, 2}));
}

TEST(PolyhedronLine, AlongTheSurface) {
  const PolyhedronCut edge = polyhedron_line(cube_to_cut(), Line::through({2, 2, 7}, {2, 2, 9}));
  EXPECT_EQ(edge.kind, CutKind::along);
  EXPECT_EQ(edge.surface, edge_feature({2, 2, 0}, {2, 2, 2}));
  EXPECT_EQ(edge.first.at, vertex_feature({2, 2, 0}));
  EXPECT_EQ(edge.last.at, vertex_feature({2, 2, 2}));
  // The diagonal of a facet is no edge, and may be one of the triangles that a hierarchy makes of it.
  for (const auto& [from, to] : {std::array<Point3, 2>{{{0, 0, 2}, {2, 2, 2}}}, {{{2, 0, 2}, {0, 2, 2}}}}) {
    const PolyhedronCut facet = polyhedron_line(cube_to_cut(), Line::through(from, to));
    EXPECT_EQ(facet.kind, CutKind::along);
    EXPECT_EQ(facet.surface, facet_feature(2, 2));
    EXPECT_EQ(facet.first.at, vertex_feature(from));
    EXPECT_EQ(facet.last.at, vertex_feature(to));
  }
}

TEST(PolyhedronLine, TouchesOrMissesByOneBit) {
  const double above = std::nextafter(2.0, 3.0), below = std::nextafter(2.0, 1.0);
  const auto at_height = [](double z) { return polyhedron_line(cube_to_cut(), Line::through({-1, 1, z}, {5, 1, z})); };
  EXPECT_EQ(at_height(2).kind, CutKind::along);
  EXPECT_EQ(at_height(above).kind, CutKind::nothing);
  EXPECT_EQ(at_height(below).kind, CutKind::across);
  const PolyhedronCut at_vertex = polyhedron_line(cube_to_cut(), Line::through({3, 1, 2}, {1, 3, 2}));
  EXPECT_EQ(at_vertex.kind, CutKind::point);
  EXPECT_EQ(at_vertex.first, at_vertex.last);
  EXPECT_EQ(at_vertex.first.at, vertex_feature({2, 2, 2}));
}

TEST(PolyhedronLine, ExtremeDoubles) {
  const double huge = std::numeric_limits<double>::max(), tiny = std::numeric_limits<double>::denorm_min();
  const ConvexPolyhedron large(tests::cube_corners(-huge, huge)), small(tests::cube_corners(-tiny, tiny));
  for (const ConvexPolyhedron* body : {&large, &small}) {
    const PolyhedronCut through = polyhedron_line(*body, Line::through({-huge, 0, 0}, {huge, 0, 0}));
    EXPECT_EQ(through.kind, CutKind::across);
    EXPECT_EQ(through.first.at, (CutFeature{CutPlace::facet, facet_at(*body, 0, body->box()[0].x), 0}));
    EXPECT_EQ(polyhedron_line(*body, Line::through({0, 0, 0}, {tiny, 0, 0})).kind, CutKind::across);
  }
  EXPECT_EQ(polyhedron_line(small, Line::through({-huge, 0, 2 * tiny}, {huge, 0, 2 * tiny})).kind, CutKind::nothing);
  EXPECT_EQ(polyhedron_line(small, Line::through({-huge, 0, tiny}, {huge, 0, tiny})).kind, CutKind::along);
}

TEST(PolyhedronLine, OfAPoseThatReflects) {
  const Pose mirror = Pose::from_matrix({-1, 0, 0, 0, 1, 0, 0, 0, 1}, {0, 0, 0});  // x from -2 to 0
  const PolyhedronCut cut = polyhedron_line(cube_to_cut(), mirror, Line::through({-5, 1, 0.5}, {5, 1, 0.5}));
  EXPECT_EQ(cut.kind, CutKind::across);
  EXPECT_EQ(cut.first.at, facet_feature(0, 2));
  EXPECT_EQ(cut.last.at, facet_feature(0, 0));
}

TEST(PolyhedronRay, EndsInsideOnTheSurfaceAndBehind) {
  const auto from = [](double x) { return polyhedron_ray(cube_to_cut(), Ray::from({x, 1, 0.5}, {x + 1, 1, 0.5})); };
  EXPECT_EQ(from(-1).first, (CutEnd{facet_feature(0, 0), OwnEnd::none}));
  EXPECT_EQ(from(0).first, (CutEnd{facet_feature(0, 0), OwnEnd::a}));
  EXPECT_EQ(from(0).kind, CutKind::across);
  EXPECT_EQ(from(1).first, (CutEnd{{CutPlace::inside, 0, 0}, OwnEnd::a}));
  EXPECT_EQ(from(1).last, (CutEnd{facet_feature(0, 2), OwnEnd::none}));
  EXPECT_EQ(from(2).kind, CutKind::point);
  EXPECT_EQ(from(2).last, (CutEnd{facet_feature(0, 2), OwnEnd::a}));
  EXPECT_EQ(from(std::nextafter(2.0, 3.0)).kind, CutKind::nothing);
  EXPECT_EQ(from(std::nextafter(2.0, 3.0)).parting.kind, CutParting::Kind::facet);
}

TEST(PolyhedronSegment, OnePointAndTwo) {
  const auto at = [](const Point3& p) { return polyhedron_segment(cube_to_cut(), Segment::between(p, p)); };
  EXPECT_EQ(at({1, 1, 1}).kind, CutKind::point);
  EXPECT_EQ(at({1, 1, 1}).first, (CutEnd{{CutPlace::inside, 0, 0}, OwnEnd::a}));
  EXPECT_EQ(at({1, 1, 2}).last, (CutEnd{facet_feature(2, 2), OwnEnd::a}));
  EXPECT_EQ(at({0, 1, 2}).last, (CutEnd{edge_feature({0, 0, 2}, {0, 2, 2}), OwnEnd::a}));
  EXPECT_EQ(at({0, 0, 2}).last, (CutEnd{vertex_feature({0, 0, 2}), OwnEnd::a}));
  EXPECT_EQ(at({1, 1, std::nextafter(2.0, 3.0)}).kind, CutKind::nothing);
  const PolyhedronCut inside = polyhedron_segment(cube_to_cut(), Segment::between({0.5, 1, 1}, {1.5, 1, 1}));
  EXPECT_EQ(inside.kind, CutKind::across);
  EXPECT_EQ(inside.first.own, OwnEnd::a);
  EXPECT_EQ(inside.last.own, OwnEnd::b);
  const PolyhedronCut to_facet = polyhedron_segment(cube_to_cut(), Segment::between({1, 1, 5}, {1, 1, 2}));
  EXPECT_EQ(to_facet.kind, CutKind::point);
  EXPECT_EQ(to_facet.first, (CutEnd{facet_feature(2, 2), OwnEnd::b}));
}

TEST(PolyhedronLine, BodiesWithoutAnInside) {
  const ConvexPolyhedron point(std::vector<Point3>{{1, 2, 3}});
  EXPECT_EQ(polyhedron_line(point, Line::through({0, 0, 0}, {2, 4, 6})).kind, CutKind::point);
  EXPECT_EQ(polyhedron_line(point, Line::through({0, 0, 0}, {2, 4, 7})).kind, CutKind::nothing);
  const ConvexPolyhedron segment(std::vector<Point3>{{0, 0, 0}, {4, 0, 0}});
  EXPECT_EQ(polyhedron_line(segment, Line::through({1, -1, 0}, {1, 1, 0})).first.at,
            (CutFeature{CutPlace::edge, 0, 1}));
  EXPECT_EQ(polyhedron_line(segment, Line::through({9, 0, 0}, {7, 0, 0})).kind, CutKind::along);
  EXPECT_EQ(polyhedron_line(segment, Line::through({5, -1, 0}, {5, 1, 0})).kind, CutKind::nothing);
  EXPECT_EQ(polyhedron_ray(segment, Ray::from({5, 0, 0}, {6, 0, 0})).kind, CutKind::nothing);
  const ConvexPolyhedron square(std::vector<Point3>{{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}});
  EXPECT_EQ(polyhedron_line(square, Line::through({1, 1, -1}, {1, 1, 1})).first.at,
            (CutFeature{CutPlace::facet, 0, 0}));
  EXPECT_EQ(polyhedron_line(square, Line::through({3, 1, -1}, {3, 1, 1})).kind, CutKind::nothing);
  const PolyhedronCut in_plane = polyhedron_line(square, Line::through({-1, 1, 0}, {5, 1, 0}));
  EXPECT_EQ(in_plane.kind, CutKind::along);
  EXPECT_EQ(in_plane.surface, (CutFeature{CutPlace::facet, 0, 0}));
  EXPECT_EQ(in_plane.first.at.place, CutPlace::edge);
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
