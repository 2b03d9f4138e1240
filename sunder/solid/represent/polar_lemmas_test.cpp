// The polar about any point inside, and the lemmas shown on it: they hold on random bodies, and each fails on a
// polar of which a vertex, a facet or the origin is another one.
#include <sunder/base/error.h>
#include <sunder/base/random.h>
#include <sunder/solid/object/convex_polyhedron.h>
#include <sunder/solid/represent/polar_lemmas.h>

#include <tests/support/shapes.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace sunder::solid {
namespace {

ConvexPolyhedron cube() {
  std::vector<Point3> points;
  for (const double x : {-1., 1.}) {
    for (const double y : {-1., 1.}) {
      for (const double z : {-1., 1.}) points.push_back({x, y, z});
    }
  }
  return ConvexPolyhedron(points);
}

TEST(PolarAbout, OfACubeIsAnOctahedron) {
  const ConvexPolyhedron body = cube();
  const PolarAbout polar = polar_about(body, {0.5, 0, 0});
  std::vector<double> at;
  for (const PolarVertex& vertex : polar.vertices) {
    const Point3 p = nearest_point(vertex);
    EXPECT_EQ((p.x != 0) + (p.y != 0) + (p.z != 0), 1);
    at.push_back(p.x + p.y + p.z);
  }
  std::sort(at.begin(), at.end());
  EXPECT_EQ(at, (std::vector<double>{-1, -1, -2 / 3., 1, 1, 2}));
  ASSERT_EQ(polar.facet_begin.size(), 9u);
  for (std::size_t v = 0; v < 8; ++v) EXPECT_EQ(polar.facet_begin[v + 1] - polar.facet_begin[v], 3u);
}

TEST(PolarAbout, RefusesOriginsThatAreNotInside) {
  const auto refused = [](const ConvexPolyhedron& body, const Point3& origin) -> std::string {
    try {
      static_cast<void>(polar_about(body, origin));
    } catch (const Error& error) {
      return error.what();
    }
    return "";
  };
  for (const Point3& origin : {Point3{2, 0, 0}, Point3{1, 0, 0}, Point3{1, 1, 1}}) {
    EXPECT_NE(refused(cube(), origin).find("is not inside the body"), std::string::npos);
    EXPECT_NE(refused(cube(), origin).find("give a point inside, as "), std::string::npos);
  }
  EXPECT_NE(refused(cube(), {std::numeric_limits<double>::infinity(), 0, 0}).find("finite"), std::string::npos);
  const std::vector<Point3> flat{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  EXPECT_NE(refused(ConvexPolyhedron(flat), {0, 0, 0}).find("has no interior"), std::string::npos);
}

TEST(PolarLemmas, HoldOnRandomBodies) {
  Random random(58);
  int shown = 0;
  for (int run = 0; run < 60; ++run) {
    std::vector<Point3> points(4 + random.below(30));
    for (Point3& p : points) p = run % 2 == 0 ? tests::on_grid(random, 3) : tests::on_sphere(random);
    const ConvexPolyhedron body(points);
    if (body.dimension() != 3) continue;
    Point3 origin;
    for (const Point3& v : body.vertices()) {
      for (std::size_t k = 0; k < 3; ++k) origin[k] += v[k] / static_cast<double>(body.vertices().size());
    }
    const PolarAbout polar = polar_about(body, origin);
    for (const std::uint64_t most : {std::uint64_t{100}, std::uint64_t{20'000}}) {
      const std::vector<PolarLemma> lemmas = polar_lemmas(body, polar, most);
      ASSERT_EQ(lemmas.size(), 7u);
      for (const PolarLemma& lemma : lemmas) {
        EXPECT_TRUE(lemma.holds) << lemma.name << ", run " << run;
        EXPECT_GE(lemma.checked, lemma.of);
        EXPECT_GT(lemma.of, 0u);
        EXPECT_LE(lemma.of, lemma.there_are);
      }
    }
    ++shown;
  }
  EXPECT_GT(shown, 50);
}

TEST(PolarLemmas, FailOnAnotherPolar) {
  const ConvexPolyhedron body = cube();
  const PolarAbout polar = polar_about(body, {0, 0, 0.25});
  const auto failing = [&](const PolarAbout& other) {
    std::string names;
    for (const PolarLemma& lemma : polar_lemmas(body, other)) {
      if (!lemma.holds) names += std::string(lemma.name) + " ";
    }
    return names;
  };
  EXPECT_EQ(failing(polar), "");
  PolarAbout far = polar;  // a vertex that is too far out
  far.vertices[0].h = far.vertices[0].h * Dyadic(0.75);
  EXPECT_EQ(failing(far), "Lemma 3.1 Lemma 3.2 Lemma 3.3 Lemma 3.4 Lemma 3.5 Lemma 3.6 Theorem 3.7 ");
  PolarAbout crossed = polar;  // a facet has another one's vertex
  for (std::uint32_t f = 0; f < 6; ++f) {
    if (std::find(polar.facet_vertices.begin(), polar.facet_vertices.begin() + 3, f) !=
        polar.facet_vertices.begin() + 3)
      continue;
    crossed.facet_vertices[0] = f;
    break;
  }
  EXPECT_EQ(failing(crossed), "Lemma 3.2 ");
  PolarAbout moved = polar;  // about another origin
  moved.origin.x = 0.5;
  EXPECT_EQ(failing(moved), "Lemma 3.1 Lemma 3.2 Lemma 3.3 Lemma 3.4 Lemma 3.5 Lemma 3.6 Theorem 3.7 ");
}

}  // namespace
}  // namespace sunder::solid
