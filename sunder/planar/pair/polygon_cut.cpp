#include <sunder/planar/pair/polygon_cut.h>

#include <utility>

namespace sunder::planar {

namespace {

struct Exact {
  Dyadic x, y;
};

Exact operator-(const Exact& p, const Exact& q) { return {p.x - q.x, p.y - q.y}; }
Dyadic cross(const Exact& u, const Exact& v) { return u.x * v.y - u.y * v.x; }
Dyadic dot(const Exact& u, const Exact& v) { return u.x * v.x + u.y * v.y; }

Exact exact(const Point2& p) { return {p.x, p.y}; }

Exact image(const Pose& pose, const Point2& p) {
  const auto& [m, t] = pose.affine();
  const Dyadic x = p.x, y = p.y;
  return {Dyadic(m[0]) * x + Dyadic(m[1]) * y + Dyadic(t[0]), Dyadic(m[2]) * x + Dyadic(m[3]) * y + Dyadic(t[1])};
}

ExactFraction fraction(Dyadic numerator, Dyadic denominator) {
  if (denominator.sign() == Sign::negative) return {-numerator, -denominator};
  return {std::move(numerator), std::move(denominator)};
}

// t with p = from + t (to - from), for a point of that line; zero where it has one point only.
ExactFraction along(const Exact& from, const Exact& to, const Exact& p) {
  const Exact u = to - from;
  const Dyadic length = dot(u, u);
  if (length.sign() == Sign::zero) return {};
  return {dot(u, p - from), length};
}

}  // namespace

std::string_view name_of(CutKind kind) {
  switch (kind) {
    case CutKind::nothing: return "nothing";
    case CutKind::point: return "point";
    case CutKind::along: return "along";
    case CutKind::across: return "across";
  }
  return "";
}

ExactEnd exact_end(const ConvexPolygon& polygon, const Pose& pose, const Point2& a, const Point2& b,
                   const CutEnd& end) {
  const Exact from = exact(a), to = exact(b);
  const std::uint32_t v = end.place == Place::inside ? 0 : end.feature, w = v + 1 == polygon.size() ? 0 : v + 1;
  const Exact start = image(pose, polygon[v]), stop = image(pose, polygon[w]);
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
  const ExactFraction of_line = fraction(cross(start - from, e), cross(u, e));
  const auto& [n, m] = of_line;
  return {{from.x * m + n * u.x, from.y * m + n * u.y, m}, of_line, fraction(cross(from - start, u), cross(e, u))};
}

}  // namespace sunder::planar
