#include <sunder/planar/pair/cut_by_scan.h>
#include <sunder/planar/pair/in_world.h>

#include <vector>

namespace sunder::planar {

namespace {

// What the whole line has in common with p: from the side of every vertex.
template <class Sequence>
PolygonCut::Evidence line_by_scan(const Sequence& p, const typename Sequence::Vertex& a,
                                  const typename Sequence::Vertex& b, Cost& cost, StageTally& tally) {
  const std::uint32_t n = p.size();
  std::vector<Sign> side(n);
  bool left = false, right = false;
  for (std::uint32_t k = 0; k < n; ++k) {
    ++cost.probes;
    side[k] = cross_2d(a, b, a, p[k], &tally);
    left = left || side[k] == Sign::positive;
    right = right || side[k] == Sign::negative;
  }
  const auto next = [&](std::uint32_t k) { return k + 1 == n ? 0 : k + 1; };
  if (left && right) {
    // Counter-clockwise, the boundary goes to the left of the line at the end of the common part.
    CutAcross cut;
    for (std::uint32_t k = 0; k < n; ++k) {
      const std::uint32_t before = k == 0 ? n - 1 : k - 1;
      const Sign from = side[k], to = side[next(k)];
      if (from == Sign::zero) {
        (side[before] == Sign::negative ? cut.last : cut.first) = CutEnd{Place::vertex, p.number(k)};
      } else if (from != to && to != Sign::zero) {
        (from == Sign::negative ? cut.last : cut.first) = CutEnd{Place::edge, edge_number(p, k)};
      }
    }
    if (n == 2) return CutPoint{cut.first};
    return cut;
  }
  std::vector<std::uint32_t> on;  // in the order along the line
  for (std::uint32_t k = 0; k < n; ++k) {
    if (side[k] != Sign::zero) continue;
    const bool first = !on.empty() && dot_2d(a, b, p[k], p[on[0]], &tally) == Sign::positive;
    on.insert(first ? on.begin() : on.end(), k);
  }
  const auto vertex = [&](std::uint32_t k) { return CutEnd{Place::vertex, p.number(k)}; };
  if (on.size() == 1) return CutPoint{vertex(on[0])};
  if (on.size() > 1) {
    return CutAlong{vertex(on.front()), vertex(on.back()), edge_number(p, next(on[0]) == on[1] ? on[0] : on[1])};
  }
  // The nearest: with the polygon to the right of the line, highest over it; of two, the one further along.
  const auto &from = left ? b : a, &to = left ? a : b;
  std::uint32_t best = 0;
  for (std::uint32_t k = 1; k < n; ++k) {
    const Sign higher = cross_2d(from, to, p[best], p[k], &tally);
    const bool further = dot_2d(from, to, p[best], p[k], &tally) == Sign::positive;
    if (higher == Sign::positive || (higher == Sign::zero && further)) best = k;
  }
  return BesideLine{p.number(best)};
}

}  // namespace

PolygonCut cut_by_scan(const ConvexPolygon& polygon, const Pose& pose, const Point2& a, const Point2& b, OwnEnds ends) {
  const auto own_end = [&](OwnEnd own) {
    return end_at(polygon_point_by_scan(polygon, pose, own == OwnEnd::a ? a : b), own);
  };
  PolygonCut cut;
  if (a == b) {
    cut.evidence = BeyondEnd{OwnEnd::a};
    if (const std::optional<CutEnd> end = own_end(OwnEnd::a)) cut.evidence = CutPoint{*end};
    return cut;
  }
  StageTally tally;
  cut.evidence = with_placed(polygon, pose, [&](const auto& p) {
    using Vertex = typename std::remove_cvref_t<decltype(p)>::Vertex;
    return line_by_scan(p, in_world<Vertex>(a), in_world<Vertex>(b), cut.cost, tally);
  });
  conclude(cut, tally.exact);
  if (!cut.meet() || (!ends.a && !ends.b)) return cut;
  CutEnds<CutEnd> common = ends_of(cut.evidence).value();
  const ExactFraction first = exact_end(polygon, pose, a, b, common.first).along_line,
                      last = exact_end(polygon, pose, a, b, common.last).along_line, at_a, at_b{Dyadic(1.0)};
  if (ends.a && last < at_a) {
    cut.evidence = BeyondEnd{OwnEnd::a};
    return cut;
  }
  if (ends.b && first > at_b) {
    cut.evidence = BeyondEnd{OwnEnd::b};
    return cut;
  }
  if (ends.a && first <= at_a) common.first = own_end(OwnEnd::a).value();
  if (ends.b && last >= at_b) common.last = own_end(OwnEnd::b).value();
  // One point: one of the ends, or a and b each where the line has no more.
  if (ends.a && last == at_a) {
    cut.evidence = CutPoint{common.first};
  } else if (kind_of(cut) == CutKind::point || (ends.b && first == at_b)) {
    cut.evidence = CutPoint{common.last};
  } else if (auto* along = std::get_if<CutAlong>(&cut.evidence)) {
    along->first = common.first;
    along->last = common.last;
  } else {
    cut.evidence = CutAcross{common.first, common.last};
  }
  return cut;
}

}  // namespace sunder::planar
