#include <sunder/solid/mesh/face_triangles.h>

#include <sunder/base/random.h>
#include <sunder/predicate/point/orient.h>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <numeric>
#include <utility>
#include <vector>

namespace sunder::solid {
namespace {

using Ring = std::vector<Point3>;

FaceTriangles triangles_of(const Ring& ring) {
  std::vector<std::uint32_t> corners(ring.size());
  std::iota(corners.begin(), corners.end(), 0u);
  return face_triangles(ring, corners);
}

// Twice the area along z; of whole numbers, exact.
double area(const Point3& a, const Point3& b, const Point3& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

// F1; and of a face in a plane z = const: the areas have the sign of the face's, and sum up to it (F2).
void expect_right(const Ring& ring, const FaceTriangles& found, bool is_simple = true) {
  ASSERT_EQ(found.triangles.size(), ring.size() - 2);
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
  double sum = 0, whole = 0, sizes = 0;
  for (const auto& t : found.triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t from = t[k], to = t[(k + 1) % 3];
      ASSERT_NE(from, to);
      edges[std::minmax(from, to)] += from < to ? 1 : -1;
    }
    const double part = area(ring[t[0]], ring[t[1]], ring[t[2]]);
    sum += part;
    sizes += std::fabs(part);
  }
  for (std::uint32_t k = 0; k < ring.size(); ++k) {
    const auto next = static_cast<std::uint32_t>((k + 1) % ring.size());
    edges[std::minmax(k, next)] -= k < next ? 1 : -1;
    whole += area(ring[0], ring[k], ring[next]);
  }
  for (const auto& [ends, count] : edges) EXPECT_EQ(count, 0) << ends.first << "-" << ends.second;
  EXPECT_EQ(sum, whole);
  if (is_simple) {
    EXPECT_EQ(sizes, std::fabs(whole));
  }
  EXPECT_EQ(found.crosses_itself, !is_simple);
}

TEST(FaceTriangles, OfThreeCornersIsTheFace) {
  const FaceTriangles found = triangles_of({{0, 0, 0}, {1, 0, 5}, {0, 1, 0}});
  ASSERT_EQ(found.triangles.size(), 1u);
  EXPECT_EQ(found.triangles[0], (std::array<std::uint32_t, 3>{0, 1, 2}));
}

TEST(FaceTriangles, OfFacesThatBendInwards) {
  const Ring arrow{{0, 0, 0}, {4, -4, 0}, {1, 0, 0}, {4, 4, 0}};
  expect_right(arrow, triangles_of(arrow));
  expect_right({arrow.rbegin(), arrow.rend()}, triangles_of({arrow.rbegin(), arrow.rend()}));
  // A comb, with corners between others.
  Ring comb{{0, -2, 1}, {21, -2, 1}};
  for (int k = 20; k >= 0; --k) {
    comb.push_back({static_cast<double>(k) + 0.5, k % 2 == 0 ? 8.0 : 0.0, 1});
    if (k % 5 == 0) comb.push_back({static_cast<double>(k) + 0.25, comb.back().y, 1});
  }
  expect_right(comb, triangles_of(comb));
}

// Radii at random, in the order of angles: a star. Whole numbers.
TEST(FaceTriangles, OfStars) {
  Random random(4007);
  for (int i = 0; i < 300; ++i) {
    const std::size_t n = 4 + random.below(30);
    Ring ring;
    for (std::size_t k = 0; k < n; ++k) {
      const double angle = 6.283185307179586 * static_cast<double>(k) / static_cast<double>(n);
      const double r = random.uniform(200, 2000);
      ring.push_back({std::round(r * std::cos(angle)), std::round(r * std::sin(angle)), 7});
    }
    if (random.below(2) == 0) ring = {ring.rbegin(), ring.rend()};
    expect_right(ring, triangles_of(ring));
  }
}

TEST(FaceTriangles, OfABridgeToAHole) {
  const Ring bridged{{0, 0, 0}, {9, 0, 0}, {9, 9, 0}, {0, 9, 0}, {0, 0, 0},
                     {3, 3, 0}, {3, 6, 0}, {6, 6, 0}, {6, 3, 0}, {3, 3, 0}};
  expect_right(bridged, triangles_of(bridged));
}

TEST(FaceTriangles, OfFacesThatCrossThemselves) {
  const Ring bow{{0, 0, 0}, {4, 4, 0}, {4, 0, 0}, {0, 5, 0}};
  expect_right(bow, triangles_of(bow), false);
}

// Two triangles at one corner; a bow-tie that is seen along one axis only; a spike outwards.
TEST(FaceTriangles, OfFacesThatTouchThemselves) {
  const Ring pinch{{0, 2, 0}, {0, 1, 0}, {2, 1, 0}, {2, 2, 0}, {1, 2, 0}, {2, 1, 0}};
  for (std::size_t first = 0; first < pinch.size(); ++first) {
    Ring turned(pinch.begin() + static_cast<std::ptrdiff_t>(first), pinch.end());
    turned.insert(turned.end(), pinch.begin(), pinch.begin() + static_cast<std::ptrdiff_t>(first));
    expect_right(turned, triangles_of(turned));
  }
  EXPECT_TRUE(triangles_of({{0, 0, 0}, {0, 1, 1}, {0, 1, 0}, {0, 0, 1}}).crosses_itself);
  const Ring spike{{2, 0, 0}, {1, 1, 0}, {0, 1, 0}, {1, 0, 0}, {0, 1, 0}};
  expect_right(spike, triangles_of(spike));
}

TEST(FaceTriangles, OfFacesWithoutArea) {
  for (const Ring& ring : {Ring{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}, {1.5, 0, 0}},
                           Ring{{0, 0, 0}, {1, 1, 1}, {0, 0, 0}, {1, 1, 1}}}) {
    const FaceTriangles found = triangles_of(ring);
    EXPECT_EQ(found.triangles.size(), ring.size() - 2);
  }
}

// Along each axis, and turned so that only one projection has area.
TEST(FaceTriangles, LooksAlongTheGreatestComponentOfTheNormal) {
  Ring comb{{0, -2, 0}, {21, -2, 0}};
  for (int k = 20; k >= 0; --k) comb.push_back({static_cast<double>(k) + 0.5, k % 2 == 0 ? 8.0 : 0.0, 0});
  const FaceTriangles flat = triangles_of(comb);
  for (const bool is_x : {false, true}) {
    Ring turned;
    for (const Point3& p : comb) turned.push_back(is_x ? Point3{0, p.x, p.y} : Point3{p.y, 0, p.x});
    EXPECT_EQ(triangles_of(turned).triangles, flat.triangles);
  }
}

}  // namespace
}  // namespace sunder::solid
