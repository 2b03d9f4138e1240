#include <sunder/planar/pair/cut_by_scan.h>
#include <sunder/planar/pair/in_world.h>

#include <vector>

namespace sunder::planar {

namespace {

// What the whole line has in common with p: from the side of every vertex.
template <class Sequence>
PolygonCut line_by_scan(const Sequence& p, const typename Sequence::Vertex& a, const typename Sequence::Vertex& b,
                        StageTally& tally) {
  const std::uint32_t n = p.size();
  PolygonCut cut;
  std::vector<Sign> side(n);
  bool left = false, right = false;
  for (std::uint32_t k = 0; k < n; ++k) {
    ++cut.cost.probes;
    side[k] = cross_2d(a, b, a, p[k], &tally);
    left = left || side[k] == Sign::positive;
    right = right || side[k] == Sign::negative;
  }
  const auto next = [&](std::uint32_t k) { return k + 1 == n ? 0 : k + 1; };
  if (left && right) {
    // Counter-clockwise, the boundary goes to the left of the line at the end of the common part.
    cut.kind = n == 2 ? CutKind::point : CutKind::across;
    for (std::uint32_t k = 0; k < n; ++k) {
      const std::uint32_t before = k == 0 ? n - 1 : k - 1;
      const Sign from = side[k], to = side[next(k)];
      if (from == Sign::zero) {
        (side[before] == Sign::negative ? cut.last : cut.first) = CutEnd{Place::vertex, p.number(k)};
      } else if (from != to && to != Sign::zero) {
        (from == Sign::negative ? cut.last : cut.first) = CutEnd{Place::edge, edge_number(p, k)};
      }
    }
    return cut;
  }
  std::vector<std::uint32_t> on;  // in the order along the line
  for (std::uint32_t k = 0; k < n; ++k) {
    if (side[k] != Sign::zero) continue;
    const bool first = !on.empty() && dot_2d(a, b, p[k], p[on[0]], &tally) == Sign::positive;
    on.insert(first ? on.begin() : on.end(), k);
  }
  if (!on.empty()) {
    cut.kind = on.size() == 1 ? CutKind::point : CutKind::along;
    cut.first.feature = p.number(on.front());
    cut.last.feature = p.number(on.back());
    if (on.size() > 1) cut.edge = edge_number(p, next(on[0]) == on[1] ? on[0] : on[1]);
    return cut;
  }
  // The nearest: with the polygon to the right of the line, highest over it; of two, the one further along.
  const auto &from = left ? b : a, &to = left ? a : b;
  std::uint32_t best = 0;
  for (std::uint32_t k = 1; k < n; ++k) {
    const Sign higher = cross_2d(from, to, p[best], p[k], &tally);
    const bool further = dot_2d(from, to, p[best], p[k], &tally) == Sign::positive;
    if (higher == Sign::positive || (higher == Sign::zero && further)) best = k;
  }
  cut.nearest = p.number(best);
  return cut;
}

// The sign of t - whole.
Sign order(const ExactFraction& t, double whole) { return (t.numerator - Dyadic(whole) * t.denominator).sign(); }

}  // namespace

PolygonCut cut_by_scan(const ConvexPolygon& polygon, const Pose& pose, const Point2& a, const Point2& b, OwnEnds ends) {
  StageTally tally;
  const auto own_end = [&](OwnEnd own) {
    const PolygonPoint at = polygon_point_by_scan(polygon, pose, own == OwnEnd::a ? a : b);
    return CutEnd{at.place, at.feature, own};
  };
  if (a == b) {
    PolygonCut cut;
    cut.first = cut.last = own_end(OwnEnd::a);
    cut.kind = cut.first.place == Place::outside ? CutKind::nothing : CutKind::point;
    return cut;
  }
  PolygonCut cut = with_placed(polygon, pose, [&](const auto& p) {
    using Vertex = typename std::remove_cvref_t<decltype(p)>::Vertex;
    return line_by_scan(p, in_world<Vertex>(a), in_world<Vertex>(b), tally);
  });
  conclude(cut, tally.exact);
  if (cut.kind == CutKind::nothing || (!ends.a && !ends.b)) return cut;
  const ExactFraction first = exact_end(polygon, pose, a, b, cut.first).along_line,
                      last = exact_end(polygon, pose, a, b, cut.last).along_line;
  if ((ends.a && order(last, 0) == Sign::negative) || (ends.b && order(first, 1) == Sign::positive)) {
    cut.kind = CutKind::nothing;
    return cut;
  }
  if (ends.a && order(first, 0) != Sign::positive) cut.first = own_end(OwnEnd::a);
  if (ends.b && order(last, 1) != Sign::negative) cut.last = own_end(OwnEnd::b);
  // One point: one of the ends, or a and b each where the line has no more.
  if (ends.a && order(last, 0) == Sign::zero) {
    cut.kind = CutKind::point;
    cut.last = cut.first;
  } else if (ends.b && order(first, 1) == Sign::zero) {
    cut.kind = CutKind::point;
    cut.first = cut.last;
  }
  if (cut.kind != CutKind::along) cut.edge = 0;
  return cut;
}

}  // namespace sunder::planar
