#include <sunder/base/random.h>
#include <sunder/solid/object/convex_polyhedron.h>
#include <sunder/solid/object/search_graph_walk.h>
#include <sunder/solid/represent/facet_graph.h>
#include <sunder/solid/represent/of.h>

#include <gtest/gtest.h>
#include <tests/support/shapes.h>

#include <algorithm>
#include <cstdint>
#include <set>

namespace sunder::solid {
namespace {

// Every edge of every facet, and no other.
TEST(FacetGraph, EdgesLeadToFacets) {
  Random random(1);
  for (const ConvexPolyhedron& body :
       {ConvexPolyhedron(tests::cube_corners(0, 1)), ConvexPolyhedron(tests::points_on_sphere(200, random))}) {
    const FacetGraph& graph = represent::of<FacetGraph>(body);
    for (std::uint32_t f = 0; f < body.facet_count(); ++f) {
      const auto cycle = body.facet(f);
      for (std::uint32_t k = 0; k < cycle.size(); ++k) {
        const auto edge = graph.edge(cycle[k], cycle[(k + 1) % cycle.size()]);
        ASSERT_TRUE(edge);
        EXPECT_EQ(edge->facet, f);
        EXPECT_EQ(edge->position, k);
      }
      EXPECT_EQ(graph.facet_of(cycle[1], cycle[2], cycle[0]), f);
      if (cycle.size() > 3) {
        EXPECT_FALSE(graph.edge(cycle[0], cycle[2]));
      }
    }
    EXPECT_EQ(std::set<std::uint32_t>(graph.number.begin(), graph.number.end()).size(), body.facet_count());
  }
}

// The ray from the middle through a point of a facet goes through that facet.
TEST(FacetGraph, RaysGoThroughFacets) {
  Random random(2);
  const ConvexPolyhedron body(tests::points_on_sphere(3000, random));
  const FacetGraph& graph = represent::of<FacetGraph>(body);
  ASSERT_FALSE(graph.facets.is_slow);
  for (std::uint32_t f = 0; f < body.facet_count(); ++f) {
    Point3 y;
    for (const std::uint32_t v : body.facet(f)) {
      for (std::size_t k = 0; k < 3; ++k) {
        y[k] += (body.vertices()[v][k] - graph.center[k]) * graph.to_one[k] / static_cast<double>(body.facet(f).size());
      }
    }
    std::uint64_t probes = 0;
    const Walk end = walk(graph.facets, y, search_start(graph.facets, y), probes, 32);
    ASSERT_TRUE(end.has_ended);
    EXPECT_EQ(graph.number[graph.facets.block(end.place).vertex()], f);
  }
}

}  // namespace
}  // namespace sunder::solid
