#include <sunder/base/error.h>
#include <sunder/base/random.h>
#include <sunder/planar/object/convex_polygon.h>
#include <sunder/predicate/point/orient.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <string>

namespace sunder::planar {
namespace {

using Points = std::vector<Point2>;

std::string refusal(const auto& make) {
  try {
    make();
  } catch (const Error& error) {
    return error.what();
  }
  return "accepted";
}
std::string refusal_of(const Points& points) {
  return refusal([&] { ConvexPolygon::from_vertices(points); });
}

TEST(ConvexPolygonTest, VerticesKeepTheirNumbers) {
  const ConvexPolygon p = ConvexPolygon::from_vertices({{2, 0}, {2, 2}, {0, 2}, {0, 0}});
  EXPECT_EQ(p.size(), 4u);
  EXPECT_EQ(p[1], (Point2{2, 2}));
  EXPECT_EQ(p.leftmost(), 3u);
  EXPECT_EQ(p.rightmost(), 1u);
  EXPECT_EQ(p.sizes().greatest, 2);
  EXPECT_EQ(ConvexPolygon::from_vertices({{5, 1}}).size(), 1u);
  EXPECT_EQ(ConvexPolygon::from_vertices({{5, 1}, {3, 0}}).leftmost(), 1u);
}

TEST(ConvexPolygonTest, NamesTheVertexThatIsWrong) {
  EXPECT_EQ(refusal_of({}), "a convex polygon has no vertices; give one at least");
  EXPECT_EQ(refusal_of({{0, 0}, {1, 0}, {0, std::numeric_limits<double>::infinity()}}),
            "vertex 2: a coordinate is not finite; give finite numbers");
  EXPECT_EQ(refusal_of({{0, 0}, {4, 0}, {1, 1}, {0, 4}}),
            "vertex 2: reflex: the polygon is not convex here; give a convex one, or ask for the hull");
  EXPECT_EQ(refusal_of({{0, 0}, {4, 0}, {4, 4}, {2, 4}, {0, 4}}),
            "vertex 3: collinear with its neighbours; leave it out");
  EXPECT_EQ(refusal_of({{0, 0}, {0, 4}, {4, 4}}),
            "vertex 0: the first one of a clockwise polygon; give the vertices counter-clockwise");
  EXPECT_EQ(refusal_of({{0, 0}, {4, 0}, {4, 4}, {4, 4}}),
            "vertex 3: the same point as the one before; give each vertex once");
  EXPECT_EQ(refusal_of({{0, 0}, {4, 0}, {4, 4}, {0, 0}}),
            "vertex 0: the same point as the one before; give each vertex once");
  EXPECT_EQ(refusal_of({{1, 1}, {1, 1}}), "vertex 1: the same point as the one before; give each vertex once");
  // A pentagram: all turns are to the left, but it winds about twice.
  EXPECT_EQ(refusal_of({{0, 3}, {-2, -3}, {3, 1}, {-3, 1}, {2, -3}}),
            "vertex 0: the first one of a boundary that winds about more than once; give a simple polygon");
}

TEST(ConvexPolygonTest, Mended) {
  const auto mended = [](const Points& points) {
    const ConvexPolygon p = ConvexPolygon::mended(points);
    Points vertices(p.vertices().begin(), p.vertices().end());
    std::rotate(vertices.begin(), vertices.begin() + p.leftmost(), vertices.end());
    return vertices;
  };
  const Points square{{0, 0}, {4, 0}, {4, 4}, {0, 4}};
  EXPECT_EQ(mended({{4, 4}, {4, 0}, {0, 0}, {0, 4}, {4, 4}}), square);  // clockwise, closed
  EXPECT_EQ(mended({{2, 0}, {4, 0}, {4, 0}, {4, 1}, {4, 3}, {4, 4}, {0, 4}, {0, 2}, {0, 0}, {1, 0}}), square);
  EXPECT_EQ(mended({{1, 1}, {1, 1}}), (Points{{1, 1}}));
  EXPECT_EQ(mended({{1, 1}, {3, 3}, {2, 2}, {1, 1}}), (Points{{1, 1}, {3, 3}}));
  EXPECT_EQ(mended({{1, 1}, {2, 2}, {3, 3}}), (Points{{1, 1}, {3, 3}}));
  EXPECT_EQ(refusal([] { ConvexPolygon::mended(Points{{0, 4}, {0, 0}, {2, 0}, {4, 0}, {1, 1}}); }),
            "vertex 4: reflex: the polygon is not convex here; give a convex one, or ask for the hull");
  // Spikes are no corners in line: the way out and back is not left out.
  EXPECT_NE(refusal([] { ConvexPolygon::mended(Points{{0, 0}, {4, 3}, {0, 3}, {0, 0}, {4, 0}}); }), "");
  EXPECT_NE(refusal([] { ConvexPolygon::mended(Points{{0, 0}, {2, 2}, {1, 1}, {3, 3}}); }), "");
}

TEST(ConvexPolygonTest, HullsOfGridPoints) {
  Random random(61);
  int flat = 0;
  for (int i = 0; i < 5000; ++i) {
    Points points;
    const auto n = 1 + random.below(12);
    for (std::uint64_t k = 0; k < n; ++k) {
      points.push_back({static_cast<double>(random.below(5)), static_cast<double>(random.below(5))});
    }
    const ConvexPolygon hull = ConvexPolygon::hull_of(points);
    const Points vertices(hull.vertices().begin(), hull.vertices().end());
    ASSERT_EQ(ConvexPolygon::from_vertices(vertices).size(), hull.size());  // strictly convex, counter-clockwise
    ASSERT_EQ(hull.leftmost(), 0u);
    for (const Point2& v : vertices) ASSERT_NE(std::find(points.begin(), points.end(), v), points.end());
    for (const Point2& p : points) {
      for (std::uint32_t k = 0; hull.size() > 2 && k < hull.size(); ++k) {
        ASSERT_NE(orient_2d(hull[k], hull[(k + 1) % hull.size()], p), Sign::negative) << i;
      }
      if (hull.size() == 2) {
        ASSERT_EQ(orient_2d(hull[0], hull[1], p), Sign::zero) << i;
        ASSERT_TRUE(std::min(hull[0].x, hull[1].x) <= p.x && p.x <= std::max(hull[0].x, hull[1].x)) << i;
      }
    }
    flat += hull.size() < 3 ? 1 : 0;
  }
  EXPECT_GT(flat, 300);
}

}  // namespace
}  // namespace sunder::planar
