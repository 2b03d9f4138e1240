#include <sunder/base/threads.h>
#include <sunder/solid/object/convex_polyhedron.h>
#include <sunder/solid/represent/bounded_hierarchy.h>
#include <sunder/solid/represent/drums.h>
#include <sunder/solid/represent/facet_graph.h>
#include <sunder/solid/represent/half_edges.h>
#include <sunder/solid/represent/hierarchy.h>
#include <sunder/solid/represent/of.h>
#include <sunder/solid/represent/polar.h>
#include <sunder/solid/represent/polar_hierarchy.h>
#include <tests/support/shapes.h>

#include <gtest/gtest.h>

#include <array>
#include <mutex>
#include <set>

namespace sunder::solid {
namespace {

std::array<const void*, 8> all_of(const ConvexPolyhedron& body) {
  return {&represent::of<Hierarchy>(body),        &represent::of<Polar>(body),
          &represent::of<PolarHierarchy>(body),   &represent::of<HalfEdges>(body),
          &represent::of<FacetGraph>(body),       &represent::of<Drums>(body),
          &represent::of<BoundedHierarchy>(body), &represent::of<BoundedPolarHierarchy>(body)};
}

TEST(Represent, CopiesAndThreadsShareOneOfEachKind) {
  const ConvexPolyhedron body(tests::cube_corners(0, 1));
  std::mutex mutex;
  std::set<std::array<const void*, 8>> found;
  on_threads(4, [&] {
    const ConvexPolyhedron copy = body;
    const auto mine = all_of(copy);
    const std::scoped_lock lock(mutex);
    found.insert(mine);
  });
  EXPECT_EQ(found.size(), 1u);
  EXPECT_EQ(*found.begin(), all_of(body));
  EXPECT_EQ(std::set(found.begin()->begin(), found.begin()->end()).size(), 8u);
  EXPECT_NE(&represent::of<Hierarchy>(ConvexPolyhedron(body.vertices())), (*found.begin())[0]);
}

}  // namespace
}  // namespace sunder::solid
