// The oracle: the corners of the common part are vertices, or crossings of two edges, that are in all polygons.
#include <sunder/planar/region/convex_polygon_intersection.h>
#include <sunder/predicate/line/arrows.h>

#include <algorithm>

namespace sunder::planar {

namespace {

class PolygonScan {
 public:
  explicit PolygonScan(std::span<const ConvexPolygon> polygons) : polygons_(polygons) {}

  PolygonsPart run() {
    find_points();
    keep_one_of_each();
    const std::vector<Found> hull = hull_of_points();
    out_.kind = hull.empty()       ? PolygonsPartKind::empty
                : hull.size() == 1 ? PolygonsPartKind::point
                : hull.size() == 2 ? PolygonsPartKind::segment
                                   : PolygonsPartKind::polygon;
    for (const Found& f : hull) out_.corners.push_back(f.name);
    if (hull.empty()) contradict();
    out_.cost.exact = tally_.exact;
    return std::move(out_);
  }

 private:
  struct Found {
    PolygonsCorner name;
    LinePoint point;
    std::size_t rank;  // of those found, for ties
  };

  Point2 end(const ConvexPolygon& p, std::uint32_t k) const { return p[p.next(k)]; }

  bool is_in(const LinePoint& q, const ConvexPolygon& p) {
    for (std::uint32_t k = 0; k < p.size() && p.size() > 1; ++k) {
      ++out_.cost.probes;
      if (orient_2d(p[k], end(p, k), q, &tally_) == Sign::negative) return false;
    }
    return p.size() > 2 || is_in_box(q, p);
  }
  // Requires that it is on the line of the segment.
  bool is_in_box(const LinePoint& q, const ConvexPolygon& p) {
    return compare(q, line_point(p[p.leftmost()])) != Sign::negative &&
           compare(q, line_point(p[p.rightmost()])) != Sign::positive;
  }

  // Lexicographically.
  Sign compare(const LinePoint& p, const LinePoint& q) {
    const Sign by_x = compare_x(p, q, &tally_);
    return by_x != Sign::zero ? by_x : compare_x(turned(p), turned(q), &tally_);
  }
  static LinePoint turned(const LinePoint& p) {
    const auto turn = [](const Point2& v) { return Point2{v.y, v.x}; };
    const Crossing& c = p.lines;
    return {{turn(c.a), turn(c.b), turn(c.c), turn(c.d)}, {p.in.y, p.in.x}};
  }

  void add_if_common(const PolygonsCorner& corner) {
    const Found found{corner, corner_point(polygons_, corner), points_.size()};
    for (const ConvexPolygon& p : polygons_) {
      if (!is_in(found.point, p)) return;
    }
    points_.push_back(found);
  }

  void find_points() {
    const auto n = static_cast<std::uint32_t>(polygons_.size());
    for (std::uint32_t i = 0; i < n; ++i) {
      for (std::uint32_t v = 0; v < polygons_[i].size(); ++v) add_if_common({true, {i, v}, {}});
    }
    for (std::uint32_t i = 0; i < n; ++i) {
      for (std::uint32_t j = 0; j < i; ++j) {
        const ConvexPolygon &p = polygons_[i], &q = polygons_[j];
        for (std::uint32_t e = 0; e < p.size() && p.size() > 1; ++e) {
          for (std::uint32_t f = 0; f < q.size() && q.size() > 1; ++f) {
            const Sign turn = cross_2d(p[e], end(p, e), q[f], end(q, f), &tally_);
            if (turn != Sign::zero) add_if_common({false, {i, e}, {j, f}});
          }
        }
      }
    }
  }

  void keep_one_of_each() {
    std::sort(points_.begin(), points_.end(), [&](const Found& p, const Found& q) {
      const Sign order = compare(p.point, q.point);
      return order == Sign::negative || (order == Sign::zero && p.rank < q.rank);
    });
    const auto is_same = [&](const Found& p, const Found& q) { return compare(p.point, q.point) == Sign::zero; };
    points_.erase(std::unique(points_.begin(), points_.end(), is_same), points_.end());
  }

  // Of sorted points, as Andrew 1979.
  std::vector<Found> hull_of_points() {
    std::vector<Found> hull;
    const auto walk = [&](std::size_t from, const Found& p) {
      while (hull.size() >= from + 2 &&
             orient_2d(hull[hull.size() - 2].point, hull.back().point, p.point, &tally_) != Sign::positive) {
        hull.pop_back();
      }
      hull.push_back(p);
    };
    for (const Found& p : points_) walk(0, p);
    if (points_.size() < 3) return hull;
    const std::size_t lower = hull.size() - 1;
    for (std::size_t k = points_.size() - 1; k-- > 0;) walk(lower, points_[k]);
    hull.pop_back();
    return hull;
  }

  // Any two or three of all supports by edges, verticals and horizontals.
  void contradict() {
    std::vector<PolygonSupport> all;
    for (std::uint32_t i = 0; i < polygons_.size(); ++i) {
      const ConvexPolygon& p = polygons_[i];
      for (std::uint32_t k = 0; k < p.size() && p.size() > 1; ++k) all.push_back({{i, k}, p[k], end(p, k)});
      const auto highest = [&](const auto& less) {
        std::uint32_t best = 0;
        for (std::uint32_t k = 1; k < p.size(); ++k) best = less(p[best], p[k]) ? k : best;
        return best;
      };
      const auto lower = [](const Point2& a, const Point2& b) { return a.y < b.y; };
      const auto higher = [](const Point2& a, const Point2& b) { return a.y > b.y; };
      all.push_back({{i, p.leftmost()}, {0, 1}, {0, 0}});
      all.push_back({{i, p.rightmost()}, {0, 0}, {0, 1}});
      all.push_back({{i, highest(lower)}, {1, 0}, {0, 0}});
      all.push_back({{i, highest(higher)}, {0, 0}, {1, 0}});
    }
    const auto moved = [&](const PolygonSupport& s) {
      return LeftOfMoved{polygons_[s.vertex.polygon][s.vertex.number], s.from, s.to};
    };
    for (std::size_t i = 0; i < all.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        const std::array two{moved(all[i]), moved(all[j])};
        if (have_no_common_point(two)) return name({all[i], all[j]});
      }
    }
    for (std::size_t i = 0; i < all.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        for (std::size_t k = 0; k < j; ++k) {
          const std::array three{moved(all[i]), moved(all[j]), moved(all[k])};
          if (have_no_common_point(three)) return name({all[i], all[j], all[k]});
        }
      }
    }
  }
  void name(std::initializer_list<PolygonSupport> supports) {
    std::copy(supports.begin(), supports.end(), out_.contradiction.begin());
    out_.contradiction_size = static_cast<std::uint32_t>(supports.size());
  }

  std::span<const ConvexPolygon> polygons_;
  PolygonsPart out_;
  StageTally tally_;
  std::vector<Found> points_;
};

}  // namespace

PolygonsPart convex_polygon_intersection_by_scan(std::span<const ConvexPolygon> polygons) {
  if (polygons.empty()) return {};
  return PolygonScan(polygons).run();
}

}  // namespace sunder::planar
