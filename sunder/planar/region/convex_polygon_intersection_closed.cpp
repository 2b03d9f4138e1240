// Upper minus lower boundary is a concave function, linear between the abscissas at which either chain has a new piece.
#include <sunder/planar/region/convex_polygon_intersection_closed.h>
#include <sunder/predicate/line/arrows.h>
#include <sunder/predicate/line/height_order.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace sunder::planar {

namespace {

constexpr std::uint32_t no_edge = 0xffffffffu;

PolygonFeature edge_of(const EdgePiece& piece) { return {piece.polygon, piece.edge}; }

// Where two edges that follow each other around the region meet.
PolygonsCorner corner_of(std::span<const ConvexPolygon> polygons, const PolygonFeature& a, const PolygonFeature& b) {
  const bool is_vertex = a.polygon == b.polygon && polygons[a.polygon].next(a.number) == b.number;
  return is_vertex ? PolygonsCorner{true, b, {}} : PolygonsCorner{false, a, b};
}

PolygonSupport support_of_edge(std::span<const ConvexPolygon> polygons, const PolygonFeature& edge) {
  const ConvexPolygon& p = polygons[edge.polygon];
  return {edge, p[edge.number], p[p.next(edge.number)]};
}
PolygonSupport right_of_first(std::span<const ConvexPolygon> polygons, std::uint32_t i) {
  return {{i, polygons[i].leftmost()}, {0, 1}, {0, 0}};
}
PolygonSupport left_of_last(std::span<const ConvexPolygon> polygons, std::uint32_t i) {
  return {{i, polygons[i].rightmost()}, {0, 0}, {0, 1}};
}

// The vertical edge on the left, or right, side of a polygon, if there is one: it ends at vertex v.
std::optional<PolygonFeature> vertical_edge(const ConvexPolygon& p, std::uint32_t i, std::uint32_t v) {
  const std::uint32_t before = p.previous(v);
  if (before == v || p[before].x != p[v].x) return std::nullopt;
  return PolygonFeature{i, before};
}
std::optional<PolygonFeature> left_edge(std::span<const ConvexPolygon> polygons, std::uint32_t i) {
  return vertical_edge(polygons[i], i, polygons[i].leftmost());
}
std::optional<PolygonFeature> right_edge(std::span<const ConvexPolygon> polygons, std::uint32_t i) {
  return vertical_edge(polygons[i], i, polygons[i].rightmost());
}

void contradict(PolygonsPart& out, std::initializer_list<PolygonSupport> supports) {
  std::copy(supports.begin(), supports.end(), out.contradiction.begin());
  out.contradiction_size = static_cast<std::uint32_t>(supports.size());
}

// The sign of the slope of a minus that of b.
Sign compare_slopes(const EdgePiece& a, const EdgePiece& b, StageTally& tally) {
  return cross_2d(b.a, b.b, a.a, a.b, &tally);
}

class Closing {
 public:
  Closing(std::span<const ConvexPolygon> polygons, const CommonAbscissas& common, std::span<const EdgePiece> upper,
          std::span<const EdgePiece> lower, StageTally& tally)
      : polygons_(polygons), common_(common), upper_(upper), lower_(lower), tally_(tally) {}

  PolygonsPart run() {
    find_stretches();
    out_.cost.probes = stretches_.size();
    const auto is_positive = [](Sign s) { return s == Sign::positive; };
    const auto is_zero = [](Sign s) { return s == Sign::zero; };
    const auto first = std::find_if(signs_.begin(), signs_.end(), is_positive);
    if (first != signs_.end()) {
      const auto last = std::find_if(signs_.rbegin(), signs_.rend(), is_positive);
      close_polygon(static_cast<std::size_t>(first - signs_.begin()),
                    signs_.size() - 1 - static_cast<std::size_t>(last - signs_.rbegin()));
    } else if (const auto zero = std::find_if(signs_.begin(), signs_.end(), is_zero); zero != signs_.end()) {
      const auto last = std::find_if(signs_.rbegin(), signs_.rend(), is_zero);
      close_thin(static_cast<std::size_t>(zero - signs_.begin()),
                 signs_.size() - 1 - static_cast<std::size_t>(last - signs_.rbegin()));
    } else {
      contradict_at_most();
    }
    return std::move(out_);
  }

 private:
  // Abscissas on which both boundaries are linear: piece `u` of the upper one and piece `l` of the lower one. Stretch m
  // begins at event m, which is where a piece begins, or the end of all abscissas.
  struct Stretch {
    std::size_t u, l;
  };

  const EdgePiece& upper(std::size_t m) const { return upper_[stretches_[m].u]; }
  const EdgePiece& lower(std::size_t m) const { return lower_[stretches_[m].l]; }
  bool upper_begins(std::size_t m) const { return stretches_[m].u != stretches_[m - 1].u; }

  void find_stretches() {
    const auto [low, high] = common_.between;
    stretches_.push_back({0, 0});
    signs_.push_back(height_order(upper_[0].a, upper_[0].b, lower_[0].a, lower_[0].b, low, &tally_));
    for (;;) {
      auto [u, l] = stretches_.back();
      const bool more_u = u + 1 < upper_.size(), more_l = l + 1 < lower_.size();
      if (!more_u && !more_l) break;
      const Sign order = !more_l   ? Sign::negative
                         : !more_u ? Sign::positive
                                   : compare_x(beginning(upper_, u + 1), beginning(lower_, l + 1), &tally_);
      signs_.push_back(order != Sign::positive
                           ? orient_2d(lower_[l].a, lower_[l].b, beginning(upper_, u + 1), &tally_)
                           : -orient_2d(upper_[u].a, upper_[u].b, beginning(lower_, l + 1), &tally_));
      if (order != Sign::positive) ++u;
      if (order != Sign::negative) ++l;
      stretches_.push_back({u, l});
    }
    const EdgePiece &u = upper_.back(), &l = lower_.back();
    signs_.push_back(height_order(u.a, u.b, l.a, l.b, high, &tally_));
  }

  // Events `first` to `last` are those at which the upper boundary is above the lower one.
  void close_polygon(std::size_t first, std::size_t last) {
    const std::size_t from = first == 0 ? 0 : first - 1, to = last == stretches_.size() ? last - 1 : last;
    std::vector<PolygonFeature> sides;
    for (std::size_t m = from; m <= to; ++m) add_side(sides, edge_of(lower(m)));
    if (last == stretches_.size()) {
      if (const auto side = right_edge(polygons_, common_.ends)) sides.push_back(*side);
    }
    for (std::size_t m = to + 1; m-- > from;) add_side(sides, edge_of(upper(m)));
    if (first == 0) {
      if (const auto side = left_edge(polygons_, common_.begins)) sides.push_back(*side);
    }
    out_.kind = PolygonsPartKind::polygon;
    out_.corners.push_back(corner_of(polygons_, sides.back(), sides.front()));
    for (std::size_t k = 1; k < sides.size(); ++k) {
      out_.corners.push_back(corner_of(polygons_, sides[k - 1], sides[k]));
    }
  }

  static void add_side(std::vector<PolygonFeature>& sides, const PolygonFeature& side) {
    if (sides.empty() || sides.back() != side) sides.push_back(side);
  }

  // Events `first` to `last` are those at which the boundaries meet, and nowhere is the upper one above.
  void close_thin(std::size_t first, std::size_t last) {
    out_.kind = first == last ? PolygonsPartKind::point : PolygonsPartKind::segment;
    out_.corners.push_back(corner_at(first, first == last, first));
    if (first != last) out_.corners.push_back(corner_at(last, false, last - 1));
  }

  // The point at event m, on both boundaries, which are `crossing` there or in one line in stretch `along`.
  PolygonsCorner corner_at(std::size_t m, bool crossing, std::size_t along) {
    if (m > 0 && m < stretches_.size()) {
      return upper_begins(m) ? corner_of(polygons_, edge_of(upper(m)), edge_of(upper(m - 1)))
                             : corner_of(polygons_, edge_of(lower(m - 1)), edge_of(lower(m)));
    }
    if (crossing) {
      const std::size_t at = m == 0 ? 0 : m - 1;
      return m == 0 ? corner_of(polygons_, edge_of(upper(at)), edge_of(lower(at)))
                    : corner_of(polygons_, edge_of(lower(at)), edge_of(upper(at)));
    }
    // All of the polygon that begins, or ends, here.
    const std::uint32_t i = m == 0 ? common_.begins : common_.ends;
    const auto side = m == 0 ? left_edge(polygons_, i) : right_edge(polygons_, i);
    if (!side) return {true, {i, m == 0 ? polygons_[i].leftmost() : polygons_[i].rightmost()}, {}};
    return corner_of(polygons_, *side, m == 0 ? edge_of(lower(along)) : edge_of(upper(along)));
  }

  // The upper boundary is below the lower one everywhere; the pieces around an abscissa at which it comes nearest say
  // so.
  void contradict_at_most() {
    out_.kind = PolygonsPartKind::empty;
    const auto is_rising = [&](const Stretch& s) {
      return compare_slopes(upper_[s.u], lower_[s.l], tally_) == Sign::positive;
    };
    const std::size_t m = static_cast<std::size_t>(
        std::partition_point(stretches_.begin(), stretches_.end(), is_rising) - stretches_.begin());
    const auto support = [&](const EdgePiece& piece) { return support_of_edge(polygons_, edge_of(piece)); };
    if (m == stretches_.size()) {
      return contradict(out_, {support(upper(m - 1)), support(lower(m - 1)), left_of_last(polygons_, common_.ends)});
    }
    if (compare_slopes(upper(m), lower(m), tally_) == Sign::zero) {
      return contradict(out_, {support(upper(m)), support(lower(m))});
    }
    if (m == 0) {
      return contradict(out_, {support(upper(m)), support(lower(m)), right_of_first(polygons_, common_.begins)});
    }
    // Of slopes: upper(m - 1) > lower(m - 1) and upper(m) < lower(m). A third one is between the two of one boundary.
    const EdgePiece &u = upper(m - 1), &next_u = upper(m), &l = lower(m - 1), &next_l = lower(m);
    switch (compare_slopes(l, next_u, tally_)) {
      case Sign::positive: return contradict(out_, {support(u), support(next_u), support(l)});
      case Sign::zero: return contradict(out_, {support(next_u), support(l)});
      case Sign::negative: return contradict(out_, {support(l), support(next_l), support(next_u)});
    }
  }

  std::span<const ConvexPolygon> polygons_;
  const CommonAbscissas& common_;
  std::span<const EdgePiece> upper_, lower_;
  StageTally& tally_;
  std::vector<Stretch> stretches_;
  std::vector<Sign> signs_;  // of upper minus lower boundary at event m; one more than stretches
  PolygonsPart out_;
};

// The highest, or lowest, point of a polygon at an abscissa that it reaches over, as the point of a line there: that of
// an edge, or, where the polygon is on one vertical line, of a horizontal one through a vertex, with no edge.
struct Level {
  EdgePiece line;
  std::uint32_t vertex = 0;  // where there is no edge
};

Level level_of(std::span<const ConvexPolygon> polygons, std::uint32_t i, double x, Boundary boundary) {
  const ConvexPolygon& p = polygons[i];
  const bool is_upper = boundary == Boundary::upper;
  if (p[p.leftmost()].x == p[p.rightmost()].x) {
    const std::uint32_t v = is_upper ? p.rightmost() : p.leftmost();
    const double before = std::nextafter(x, -HUGE_VAL), after = std::nextafter(x, HUGE_VAL);
    const Point2 a{std::isinf(before) ? x : before, p[v].y}, b{std::isinf(after) ? x : after, p[v].y};
    return {{a, b, i, no_edge, {}}, v};
  }
  for (std::uint32_t v = p.leftmost();;) {
    const std::uint32_t next = is_upper ? p.previous(v) : p.next(v);
    if (p[v].x < p[next].x && p[next].x >= x) return {{p[v], p[next], i, is_upper ? next : v, {}}, 0};
    v = next;
  }
}

class Thin {
 public:
  Thin(std::span<const ConvexPolygon> polygons, const CommonAbscissas& common) : polygons_(polygons), common_(common) {}

  // All common points have this one abscissa.
  PolygonsPart run() {
    const double x = common_.between.low;
    Level top = level_of(polygons_, 0, x, Boundary::upper), bottom = level_of(polygons_, 0, x, Boundary::lower);
    for (std::uint32_t i = 1; i < polygons_.size(); ++i) {
      const Level upper = level_of(polygons_, i, x, Boundary::upper),
                  lower = level_of(polygons_, i, x, Boundary::lower);
      if (order(upper, top) == Sign::negative) top = upper;
      if (order(lower, bottom) == Sign::positive) bottom = lower;
    }
    const Sign height = order(top, bottom);
    if (height == Sign::negative) {
      contradict_on_line(top, bottom);
    } else {
      out_.kind = height == Sign::zero ? PolygonsPartKind::point : PolygonsPartKind::segment;
      out_.corners.push_back(corner(bottom, Boundary::lower));
      if (height == Sign::positive) out_.corners.push_back(corner(top, Boundary::upper));
    }
    out_.cost.exact = tally_.exact;
    return std::move(out_);
  }

 private:
  Sign order(const Level& p, const Level& q) {
    ++out_.cost.probes;
    return height_order(p.line.a, p.line.b, q.line.a, q.line.b, common_.between.low, &tally_);
  }

  PolygonsCorner corner(const Level& level, Boundary boundary) {
    if (level.line.edge == no_edge) return {true, {level.line.polygon, level.vertex}, {}};
    const auto side = left_edge(polygons_, common_.begins);
    if (!side) return {true, {common_.begins, polygons_[common_.begins].leftmost()}, {}};
    return boundary == Boundary::upper ? corner_of(polygons_, edge_of(level.line), *side)
                                       : corner_of(polygons_, *side, edge_of(level.line));
  }

  PolygonSupport support(const Level& level, Boundary boundary) {
    const EdgePiece& line = level.line;
    if (line.edge != no_edge) return support_of_edge(polygons_, edge_of(line));
    const PolygonFeature vertex{line.polygon, level.vertex};
    return boundary == Boundary::upper ? PolygonSupport{vertex, {1, 0}, {0, 0}}
                                       : PolygonSupport{vertex, {0, 0}, {1, 0}};
  }

  void contradict_on_line(const Level& top, const Level& bottom) {
    out_.kind = PolygonsPartKind::empty;
    const PolygonSupport upper = support(top, Boundary::upper), lower = support(bottom, Boundary::lower);
    const Sign rising = compare_slopes(top.line, bottom.line, tally_);
    if (rising == Sign::zero) return contradict(out_, {upper, lower});
    contradict(out_, {upper, lower,
                      rising == Sign::positive ? left_of_last(polygons_, common_.ends)
                                               : right_of_first(polygons_, common_.begins)});
  }

  std::span<const ConvexPolygon> polygons_;
  const CommonAbscissas& common_;
  StageTally tally_;
  PolygonsPart out_;
};

}  // namespace

CommonAbscissas common_abscissas(std::span<const ConvexPolygon> polygons) {
  const auto first = [](const ConvexPolygon& p) { return p[p.leftmost()].x; };
  const auto last = [](const ConvexPolygon& p) { return p[p.rightmost()].x; };
  CommonAbscissas out{{first(polygons[0]), last(polygons[0])}, 0, 0};
  for (std::uint32_t i = 1; i < polygons.size(); ++i) {
    if (first(polygons[i]) > out.between.low) {
      out.between.low = first(polygons[i]);
      out.begins = i;
    }
    if (last(polygons[i]) < out.between.high) {
      out.between.high = last(polygons[i]);
      out.ends = i;
    }
  }
  return out;
}

PolygonsPart closed_part(std::span<const ConvexPolygon> polygons, const CommonAbscissas& common,
                         std::span<const EdgePiece> upper, std::span<const EdgePiece> lower, StageTally& tally) {
  return Closing(polygons, common, upper, lower, tally).run();
}

PolygonsPart thin_part(std::span<const ConvexPolygon> polygons, const CommonAbscissas& common) {
  if (common.between.low == common.between.high) return Thin(polygons, common).run();
  PolygonsPart out;
  out.kind = PolygonsPartKind::empty;
  contradict(out, {right_of_first(polygons, common.begins), left_of_last(polygons, common.ends)});
  return out;
}

void turn_over(std::span<EdgePiece> chain) {
  for (EdgePiece& piece : chain) {
    piece.a.y = -piece.a.y;
    piece.b.y = -piece.b.y;
    piece.begin.y = -piece.begin.y;
  }
}

}  // namespace sunder::planar
