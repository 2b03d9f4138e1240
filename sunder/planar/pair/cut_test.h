// For the tests of lines, rays and segments that cut a polygon: what any answer must satisfy, in exact numbers.
#pragma once

#include <sunder/planar/pair/one_polygon_test.h>
#include <sunder/planar/pair/polygon_cut.h>

#include <gtest/gtest.h>

#include <array>
#include <optional>
#include <vector>

namespace sunder::planar {

inline void expect_same(const PolygonCut& found, const PolygonCut& other) {
  EXPECT_TRUE(found.evidence == other.evidence) << name_of(kind_of(found)) << ' ' << name_of(kind_of(other));
}

// Default ones of nothing.
inline CutEnd first_of(const PolygonCut& cut) { return ends_of(cut.evidence).value_or(CutEnds<CutEnd>{}).first; }
inline CutEnd last_of(const PolygonCut& cut) { return ends_of(cut.evidence).value_or(CutEnds<CutEnd>{}).last; }

namespace cut_test {

struct Exact {
  Dyadic x, y;
};
inline Exact image(const Pose& pose, const Point2& p) {
  const auto& [m, t] = pose.affine();
  const Dyadic x = p.x, y = p.y;
  return {Dyadic(m[0]) * x + Dyadic(m[1]) * y + Dyadic(t[0]), Dyadic(m[2]) * x + Dyadic(m[3]) * y + Dyadic(t[1])};
}

// The orientation of v, w and the point x / denominator.
inline Sign turn(const Exact& v, const Exact& w, const ExactPoint2& p) {
  return ((w.x - v.x) * (p.y - v.y * p.denominator) - (w.y - v.y) * (p.x - v.x * p.denominator)).sign();
}
// Is it v + t (w - v)?
inline bool is_at(const ExactPoint2& p, const Exact& v, const Exact& w, const ExactFraction& t) {
  const auto same = [&](const Dyadic& coordinate, const Dyadic& from, const Dyadic& to) {
    return coordinate * t.denominator == (from * t.denominator + t.numerator * (to - from)) * p.denominator;
  };
  return same(p.x, v.x, w.x) && same(p.y, v.y, w.y);
}
inline bool is_in_unit(const ExactFraction& t) { return t >= ExactFraction() && t <= ExactFraction{Dyadic(1.0)}; }

}  // namespace cut_test

// The ends are where they are said to be, and what is between them is as the kind says. Not that it is all.
inline void expect_true(const ConvexPolygon& polygon, const Pose& pose, const Point2& a, const Point2& b,
                        const PolygonCut& cut) {
  using namespace cut_test;
  const std::optional<CutEnds<CutEnd>> common = ends_of(cut.evidence);
  EXPECT_EQ(common.has_value(), cut.meet());
  EXPECT_EQ(cut.meet(), kind_of(cut) != CutKind::nothing);
  if (!common) return;
  const std::uint32_t n = polygon.size();
  const Exact from = image(Pose(), a), to = image(Pose(), b);
  const auto corner = [&](std::uint32_t v) { return image(pose, polygon[v % n]); };
  const auto side_of = [&](std::uint32_t edge, const ExactPoint2& p) {
    const Sign s = turn(corner(edge), corner(edge + 1), p);
    return pose.reflects() ? -s : s;
  };
  std::vector<ExactEnd> ends;
  for (const CutEnd& end : {common->first, common->last}) {
    const ExactEnd e = exact_end(polygon, pose, a, b, end);
    EXPECT_EQ(e.point.denominator.sign(), Sign::positive);
    EXPECT_EQ(e.along_line.denominator.sign(), Sign::positive);
    EXPECT_TRUE(is_at(e.point, from, to, e.along_line));
    if (end.own == OwnEnd::a) {
      EXPECT_EQ(e.along_line.numerator.sign(), Sign::zero);
    }
    if (end.own == OwnEnd::b) {
      EXPECT_TRUE(e.along_line.numerator == e.along_line.denominator);
    }
    if (end.place == Place::inside) {
      EXPECT_NE(end.own, OwnEnd::none);
      for (std::uint32_t k = 0; k < n; ++k) EXPECT_EQ(side_of(k, e.point), Sign::positive);
    } else {
      EXPECT_LT(end.feature, n);
      EXPECT_TRUE(is_in_unit(e.along_edge));
      EXPECT_TRUE(is_at(e.point, corner(end.feature), corner(end.feature + 1), e.along_edge));
      const bool inner =
          e.along_edge.numerator.sign() != Sign::zero && !(e.along_edge.numerator == e.along_edge.denominator);
      EXPECT_EQ(inner, end.place == Place::edge);
    }
    ends.push_back(e);
  }
  const Sign order = compare(ends[1].along_line, ends[0].along_line);
  EXPECT_EQ(order, kind_of(cut) == CutKind::point ? Sign::zero : Sign::positive);
  if (kind_of(cut) == CutKind::point) return;
  const ExactPoint2 &p = ends[0].point, &q = ends[1].point;
  const ExactPoint2 middle{p.x * q.denominator + q.x * p.denominator, p.y * q.denominator + q.y * p.denominator,
                           Dyadic(2.0) * p.denominator * q.denominator};
  const auto* along = std::get_if<CutAlong>(&cut.evidence);
  for (std::uint32_t k = 0; k < n; ++k) {
    const bool on = along != nullptr && (k == along->edge || n == 2);
    EXPECT_EQ(side_of(k, middle), on ? Sign::zero : Sign::positive);
  }
}

// What was seen, over many answers.
struct CutCounts {
  std::array<int, 4> kinds{};
  int own = 0, vertices = 0, edges = 0, inside = 0, segments = 0, points = 0, reflected = 0;

  void add(const NastyCase& c, const PolygonCut& cut) {
    ++kinds[static_cast<std::size_t>(kind_of(cut))];
    segments += c.polygon.size() == 2 && cut.meet() ? 1 : 0;
    points += c.polygon.size() == 1 && cut.meet() ? 1 : 0;
    const std::optional<CutEnds<CutEnd>> ends = ends_of(cut.evidence);
    if (!ends) return;
    reflected += c.pose.reflects() ? 1 : 0;
    for (const CutEnd& end : {ends->first, ends->last}) {
      own += end.own != OwnEnd::none ? 1 : 0;
      vertices += end.place == Place::vertex ? 1 : 0;
      edges += end.place == Place::edge ? 1 : 0;
      inside += end.place == Place::inside ? 1 : 0;
    }
  }
  void expect_all(int count, bool with_own_ends) const {
    for (const int k : kinds) EXPECT_GT(k, count / 30);
    for (const int k : {segments, points, reflected, vertices, edges}) EXPECT_GT(k, count / 50);
    if (with_own_ends) {
      EXPECT_GT(own, count / 30);
      EXPECT_GT(inside, count / 50);
    }
  }
};

// Two different points for a nasty case.
inline std::array<Point2, 2> nasty_points(const NastyCase& c, Random& random) {
  std::array<Point2, 2> p{};
  while (p[0] == p[1]) p = {nasty_point(c, random), nasty_point(c, random)};
  return p;
}

}  // namespace sunder::planar
