#include <sunder/planar/pair/exact_image.h>
#include <sunder/planar/pair/polygon_cut.h>

#include <type_traits>
#include <utility>

namespace sunder::planar {

namespace {

using Exact = Vector2<Dyadic>;

// t with p = from + t (to - from), for a point of that line; zero where it has one point only.
ExactFraction along(const Exact& from, const Exact& to, const Exact& p) {
  const Exact u = to - from;
  const Dyadic length = dot(u, u);
  if (length.sign() == Sign::zero) return {};
  return {dot(u, p - from), length};
}

}  // namespace

static_assert(std::is_trivially_copyable_v<PolygonCut::Evidence>);  // searches hand it on by value

std::optional<CutEnd> end_at(const PolygonPoint& place, OwnEnd own) {
  if (const auto* at = std::get_if<AtVertex>(&place.evidence)) return CutEnd{Place::vertex, at->vertex, own};
  if (const auto* in = std::get_if<InEdge>(&place.evidence)) return CutEnd{Place::edge, in->edge, own};
  if (!place.meet()) return std::nullopt;
  return CutEnd{Place::inside, 0, own};
}

ExactEnd exact_end(const ConvexPolygon& polygon, const Pose& pose, const Point2& a, const Point2& b,
                   const CutEnd& end) {
  const Exact from = coordinates<Dyadic>(a), to = coordinates<Dyadic>(b);
  const std::uint32_t v = end.place == Place::inside ? 0 : end.feature, w = polygon.next(v);
  const Exact start = image(polygon, pose, v), stop = image(polygon, pose, w);
  const auto at = [](const Exact& p) { return ExactPoint2{p.x, p.y, Dyadic(1.0)}; };
  if (end.own != OwnEnd::none) {
    const Exact& p = end.own == OwnEnd::a ? from : to;
    const double whole = end.own == OwnEnd::a ? 0 : 1;
    const ExactFraction of_edge = end.place == Place::edge ? along(start, stop, p) : ExactFraction{};
    return {at(p), {Dyadic(whole)}, of_edge};
  }
  if (end.place != Place::edge) return {at(start), along(from, to, start), {}};
  // The line crosses the edge.
  const Exact u = to - from, e = stop - start;
  const ExactFraction of_line = ExactFraction::quotient(cross(start - from, e), cross(u, e)),
                      of_edge = ExactFraction::quotient(cross(from - start, u), cross(e, u));
  const auto& [n, m] = of_line;
  return {{from.x * m + n * u.x, from.y * m + n * u.y, m}, of_line, of_edge};
}

}  // namespace sunder::planar
