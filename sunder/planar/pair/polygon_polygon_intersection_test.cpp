// Against a clipping of one polygon by the other's edges, one after the other, in rational numbers (Sutherland and
// Hodgman 1974).
#include <tests/support/planar_pairs.h>
#include <tests/support/scale.h>

#include <sunder/number/integer_internal.h>
#include <sunder/planar/pair/polygon_polygon_intersection.h>

#include <gtest/gtest.h>
#include <boost/multiprecision/cpp_int.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace sunder::planar {
namespace {

using tests::PlanarFamily;
using Whole = boost::multiprecision::number<boost::multiprecision::cpp_int_backend<>, boost::multiprecision::et_off>;
using Fraction =
    boost::multiprecision::number<boost::multiprecision::cpp_rational_backend, boost::multiprecision::et_off>;

Fraction power_of_two(std::int64_t e) {
  const Whole power = Whole(1) << static_cast<unsigned>(std::abs(e));
  return e < 0 ? Fraction(Whole(1), power) : Fraction(power);
}
Fraction exact(double x) {
  int e = 0;
  const auto n = static_cast<std::int64_t>(std::ldexp(std::frexp(x, &e), 53));
  return Fraction(n) * power_of_two(e - 53);
}
Fraction exact(const Dyadic& x) { return Fraction(Whole(mantissa_of(x))) * power_of_two(x.exponent()); }

struct At {
  Fraction x, y;
  friend bool operator==(const At&, const At&) = default;
};
int orientation(const At& a, const At& b, const At& c) {
  return ((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x)).sign();
}

std::vector<At> images(const ConvexPolygon& p, const Pose& pose) {
  const auto& [m, t] = pose.affine();
  std::vector<At> out;
  for (const Point2& v : p.vertices()) {
    out.push_back({exact(m[0]) * exact(v.x) + exact(m[1]) * exact(v.y) + exact(t[0]),
                   exact(m[2]) * exact(v.x) + exact(m[3]) * exact(v.y) + exact(t[1])});
  }
  if (pose.reflects()) std::reverse(out.begin(), out.end());
  return out;
}

// The part to the left of a line, or on it.
std::vector<At> clipped(const std::vector<At>& p, const At& a, const At& b) {
  std::vector<At> out;
  for (std::size_t k = 0; k < p.size(); ++k) {
    const At &q = p[k], &r = p[(k + 1) % p.size()];
    const int of_q = orientation(a, b, q), of_r = orientation(a, b, r);
    if (of_q >= 0) out.push_back(q);
    if (of_q * of_r >= 0) continue;
    const Fraction t = ((b.x - a.x) * (q.y - a.y) - (b.y - a.y) * (q.x - a.x)) /
                       ((b.y - a.y) * (r.x - q.x) - (b.x - a.x) * (r.y - q.y));
    out.push_back({q.x + t * (r.x - q.x), q.y + t * (r.y - q.y)});
  }
  return out;
}

// Strictly convex corners of a convex sequence, from the lexicographically first one.
std::vector<At> corners_of(std::vector<At> p) {
  const auto less = [](const At& a, const At& b) { return a.x < b.x || (a.x == b.x && a.y < b.y); };
  p.erase(std::unique(p.begin(), p.end()), p.end());
  while (p.size() > 1 && p.front() == p.back()) p.pop_back();
  if (p.empty()) return p;
  std::rotate(p.begin(), std::min_element(p.begin(), p.end(), less), p.end());
  if (std::all_of(p.begin(), p.end(), [&](const At& q) {
        return orientation(p[0], *std::max_element(p.begin(), p.end(), less), q) == 0;
      })) {
    const At last = *std::max_element(p.begin(), p.end(), less);
    return last == p[0] ? std::vector<At>{p[0]} : std::vector<At>{p[0], last};
  }
  std::vector<At> out;
  for (std::size_t k = 0; k < p.size(); ++k) {
    if (orientation(p[(k + p.size() - 1) % p.size()], p[k], p[(k + 1) % p.size()]) != 0) out.push_back(p[k]);
  }
  return out;
}

std::vector<At> oracle(const tests::PlanarCase& c) {
  std::vector<At> out = images(c.a, c.pose_a);
  const std::vector<At> b = images(c.b, c.pose_b);
  for (std::size_t k = 0; k < b.size() && b.size() > 2; ++k) out = clipped(out, b[k], b[(k + 1) % b.size()]);
  return corners_of(out);
}

TEST(PolygonPolygonCommonPartTest, AgreesWithClippingInFractions) {
  const int count = tests::scaled_count(5000);
  tests::PlanarPairs pairs(tests::chosen_seed(51));
  std::map<std::size_t, int> sizes;
  std::map<CommonCorner::Kind, int> kinds;
  for (int i = 0; i < count; ++i) {
    const tests::PlanarCase c = pairs.next(i % 2 == 0 ? PlanarFamily::grid : static_cast<PlanarFamily>(i / 2 % 9));
    if (c.a.size() + c.b.size() > 40 || c.b.size() < 3) continue;
    const CommonPart part = polygon_polygon_intersection(c.a, c.pose_a, c.b, c.pose_b);
    const CommonPart other = polygon_polygon_intersection(c.b, c.pose_b, c.a, c.pose_a);
    std::vector<At> found;
    for (const CommonCorner& corner : part.found) {
      const ExactPoint2 p = exact_corner(corner, c.a, c.pose_a, c.b, c.pose_b);
      found.push_back({exact(p.x) / exact(p.denominator), exact(p.y) / exact(p.denominator)});
      ++kinds[corner.kind];
    }
    const std::vector<At> expected = oracle(c);
    ASSERT_EQ(found.size(), expected.size()) << i << " " << name_of(c.family);
    ASSERT_EQ(other.found.size(), expected.size()) << i << " " << name_of(c.family);
    ++sizes[std::min<std::size_t>(found.size(), 4)];
    if (found.empty()) continue;
    const auto start = std::find(found.begin(), found.end(), expected.front());
    ASSERT_NE(start, found.end()) << i << " " << name_of(c.family);
    std::rotate(found.begin(), start, found.end());
    ASSERT_TRUE(found == expected) << i << " " << name_of(c.family);
  }
  if (count < 2000) return;
  for (std::size_t size = 0; size <= 4; ++size) EXPECT_GT(sizes[size], count / 100) << size;
  for (const auto kind :
       {CommonCorner::Kind::vertex_of_a, CommonCorner::Kind::vertex_of_b, CommonCorner::Kind::crossing}) {
    EXPECT_GT(kinds[kind], count / 10);
  }
}

TEST(PolygonPolygonCommonPartTest, ThinOnes) {
  const auto polygon = [](std::vector<Point2> v) { return ConvexPolygon::from_vertices(std::move(v)); };
  const ConvexPolygon square = polygon({{0, 0}, {4, 0}, {4, 4}, {0, 4}});
  const auto part = [&](const ConvexPolygon& b) {
    return polygon_polygon_intersection(square, Pose(), b, Pose()).found;
  };
  using Kind = CommonCorner::Kind;
  EXPECT_EQ(part(polygon({{1, 1}})), (std::vector<CommonCorner>{{Kind::vertex_of_b, 0, 0}}));
  EXPECT_TRUE(part(polygon({{5, 1}})).empty());
  EXPECT_EQ(part(polygon({{1, 1}, {2, 2}})).size(), 2u);
  EXPECT_EQ(part(polygon({{-1, 2}, {6, 2}})),
            (std::vector<CommonCorner>{{Kind::crossing, 3, 0}, {Kind::crossing, 1, 0}}));
  EXPECT_EQ(part(polygon({{3, 5}, {5, 3}})), (std::vector<CommonCorner>{{Kind::vertex_of_a, 2, 0}}));
  EXPECT_EQ(part(square).size(), 4u);
}

// Of two regular polygons: twice their size, and no more probes than s log l.
TEST(PolygonPolygonCommonPartTest, Large) {
  for (std::uint32_t n = 1u << 6; n <= 1u << 14; n *= 16) {
    const ConvexPolygon a = tests::regular_polygon(n), b = tests::regular_polygon(n, 1, 3.14159 / n);
    const CommonPart part = polygon_polygon_intersection(a, Pose(), b, Pose());
    EXPECT_GT(part.found.size(), 3 * n / 2) << n;
    EXPECT_LE(part.found.size(), 2 * n) << n;
    EXPECT_LE(static_cast<double>(part.cost.probes), n * (3 * std::log2(n) + 8)) << n;
  }
}

}  // namespace
}  // namespace sunder::planar
