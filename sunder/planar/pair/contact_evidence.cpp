#include <sunder/planar/pair/contact_evidence.h>
#include <sunder/planar/pair/polygon_point.h>
#include <sunder/planar/pair/polygon_polygon.h>
#include <sunder/planar/pair/polygon_polygon_intersection.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>
#include <vector>

namespace sunder::planar {

namespace {

using Exact = Vector2<Dyadic>;

Dyadic whole(std::uint32_t n) { return static_cast<double>(n); }

Exact normal(const ConvexPolygon& polygon, const Pose& pose, std::uint32_t v) {
  const auto [x, y] = outward_normal(polygon, pose, v);
  return {x, y};
}

// Up to three vertices that span all that the polygon spans.
std::vector<std::uint32_t> spanning(const ConvexPolygon& polygon) {
  const std::uint32_t n = polygon.size();
  if (n < 3) return n == 1 ? std::vector<std::uint32_t>{0} : std::vector<std::uint32_t>{0, 1};
  return {0, n / 3, static_cast<std::uint32_t>(std::uint64_t{n} * 2 / 3)};
}

// ---- Touching.

// A polygon at a common point, which is a vertex, or inside an edge.
struct Corner {
  const ConvexPolygon& polygon;
  const Pose& pose;
  std::span<const std::uint32_t> at;  // the vertex, or the ends of the edge

  Exact operator[](std::uint32_t v) const { return image(polygon, pose, v); }

  // Beside the point: what tells of a direction whether the polygon ends there.
  std::vector<std::uint32_t> beside() const {
    std::vector<std::uint32_t> all;
    for (const std::uint32_t v : at) all.insert(all.end(), {polygon.previous(v), polygon.next(v)});
    return all;
  }

  // The edges of the cone of outward directions.
  std::vector<Exact> outward() const {
    std::vector<Exact> all;
    if (polygon.size() == 1) return all;
    for (const std::uint32_t v : at) {
      for (const std::uint32_t e : {polygon.previous(v), v}) all.push_back(normal(polygon, pose, e));
    }
    // Of a segment these are both normals.
    if (polygon.size() == 2 && at.size() == 1) all.push_back((*this)[at[0]] - (*this)[polygon.next(at[0])]);
    return all;
  }
};

// Ends the polygon along the direction at the point? Nothing, if it does not; else, is it not all as far?
std::optional<bool> ends_along(const Corner& corner, const Exact& direction) {
  const Exact p = corner[corner.at[0]];
  if (corner.at.size() == 2 && dot(direction, corner[corner.at[1]] - p).sign() != Sign::zero) return std::nullopt;
  bool is_flat = true;
  for (const std::uint32_t v : corner.beside()) {
    const Sign further = dot(direction, corner[v] - p).sign();
    if (further == Sign::positive) return std::nullopt;
    if (further == Sign::negative) is_flat = false;
  }
  return !is_flat;
}

// ---- Combinations.

Exact times(const Exact& v, const Dyadic& factor) { return {v.x * factor, v.y * factor}; }

// Of the closed polygon, by a segment's two ends, or three corners of the fan at vertex 0; nothing where it is outside.
// Weights of zero are among them. Requires two vertices at least; of a segment, a point of its line.
std::optional<Combination> combination(const ConvexPolygon& polygon, const Pose& pose, const ExactPoint2& point) {
  const std::uint32_t n = polygon.size();
  const Exact origin = image(polygon, pose, 0);
  const Exact d = Exact{point.x, point.y} - times(origin, point.denominator);  // times the denominator
  const auto arm = [&](std::uint32_t v) { return image(polygon, pose, v) - origin; };
  Combination found;
  if (n == 2) {
    const Exact u = arm(1);
    const Dyadic square = dot(u, u) * point.denominator, along = dot(u, d);
    found = {{{0, square - along}, {1, along}}, square};
  } else {
    const auto turn = [&](const Exact& u, const Exact& v) { return pose.reflects() ? cross(v, u) : cross(u, v); };
    // The last of the fan's triangles whose first side does not have the point to its right.
    std::uint32_t low = 1, high = n - 2;
    while (low < high) {
      const std::uint32_t middle = low + (high - low + 1) / 2;
      const bool is_right = turn(arm(middle), d).sign() == Sign::negative;
      (is_right ? high : low) = is_right ? middle - 1 : middle;
    }
    const Exact u = arm(low), v = arm(low + 1);
    const Dyadic all = turn(u, v) * point.denominator, of_u = turn(d, v), of_v = turn(u, d);
    found = {{{0, all - of_u - of_v}, {low, of_u}, {low + 1, of_v}}, all};
  }
  const auto is_negative = [](const Weights::Part& part) { return part.numerator.sign() == Sign::negative; };
  if (std::any_of(found.parts.begin(), found.parts.end(), is_negative)) return std::nullopt;
  return found;
}

PointOf vertex_point(const ConvexPolygon& polygon, const Pose& pose, std::uint32_t v) {
  const Exact p = image(polygon, pose, v);
  return {{p.x, p.y, 0.0}, {{{v, 1.0}}}};
}

// The foot of the point q on the line of edge v.
PointOf foot(const ConvexPolygon& polygon, const Pose& pose, std::uint32_t v, const Exact& q) {
  const std::uint32_t w = polygon.next(v);
  const Exact from = image(polygon, pose, v), edge = image(polygon, pose, w) - from;
  const Dyadic whole = dot(edge, edge), part = dot(edge, q - from);
  return {{from.x * whole + edge.x * part, from.y * whole + edge.y * part, 0.0, whole},
          {{{v, whole - part}, {w, part}}, whole}};
}

// The mean of a few points.
ExactPoint2 mean(std::span<const ExactPoint2> points) {
  ExactPoint2 sum{0.0, 0.0, 1.0};
  for (const ExactPoint2& p : points) {
    sum = {sum.x * p.denominator + p.x * sum.denominator, sum.y * p.denominator + p.y * sum.denominator,
           sum.denominator * p.denominator};
  }
  sum.denominator = sum.denominator * whole(static_cast<std::uint32_t>(points.size()));
  return sum;
}

}  // namespace

ExactPoint2 exact_middle(const ConvexPolygon& polygon, const Pose& pose) {
  std::vector<ExactPoint2> corners;
  for (const std::uint32_t v : spanning(polygon)) corners.push_back(exact_vertex(polygon, pose, v));
  return mean(corners);
}

std::array<Dyadic, 2> outward_normal(const ConvexPolygon& polygon, const Pose& pose, std::uint32_t v) {
  const Exact edge = image(polygon, pose, polygon.next(v)) - image(polygon, pose, v);
  if (pose.reflects()) return {-edge.y, edge.x};
  return {edge.y, -edge.x};
}

void add_claims(PairClaims& pairs, const ClaimedPair& pair, const PairCertificate& certificate, Relation contact) {
  const auto& [index_a, index_b, a, pose_a, b, pose_b] = pair;
  if (contact == Relation::none) return pairs.add_pair(index_a, index_b, certificate);
  if (contact == Relation::overlapping) {
    return pairs.add_overlapping(index_a, index_b, overlapping_point(a, pose_a, b, pose_b));
  }
  const CommonVertices& common = std::get<CommonVertices>(certificate);
  pairs.add_touching(index_a, index_b, pairs.common_point(index_a, index_b, common),
                     touching_direction(a, pose_a, b, pose_b, common));
}

void add_distance(PairClaims& pairs, const ClaimedPair& pair, const PolygonDistance& distance) {
  const ClosestFeatures* closest = closest_of(distance);
  if (closest == nullptr) return;
  const auto [of_a, of_b] = closest_points(pair.a, pair.pose_a, pair.b, pair.pose_b, *closest);
  pairs.add_distance(pair.index_a, pair.index_b, of_a, of_b);
}

void add_clearance(PairClaims& pairs, const ClaimedPair& pair, const PolygonDistance& distance, double least) {
  const auto& [index_a, index_b, a, pose_a, b, pose_b] = pair;
  if (const auto* common = std::get_if<CommonVertices>(&distance.evidence)) {
    const auto& [at, of_a, of_b] = pairs.common_point(index_a, index_b, *common);
    return pairs.add_clearance_broken(index_a, index_b, least, {at, of_a}, {at, of_b});
  }
  const auto [of_a, of_b] = closest_points(a, pose_a, b, pose_b, *closest_of(distance));
  if (compare_distance(distance, least) == Sign::negative) {
    return pairs.add_clearance_broken(index_a, index_b, least, of_a, of_b);
  }
  pairs.add_clearance(index_a, index_b, least, way_between(of_a, of_b));
}

std::array<Dyadic, 3> touching_direction(const ConvexPolygon& a, const Pose& pose_a, const ConvexPolygon& b,
                                         const Pose& pose_b, const CommonVertices& meet) {
  const std::span<const std::uint32_t> all(meet.vertices);
  const Corner of_a{a, pose_a, all.first(meet.count_a)}, of_b{b, pose_b, all.subspan(meet.count_a, meet.count_b)};
  std::vector<Exact> candidates = of_a.outward();
  for (const Exact& d : of_b.outward()) candidates.push_back(-d);
  for (const Exact& d : candidates) {
    const std::optional<bool> in_a = ends_along(of_a, d), in_b = ends_along(of_b, -d);
    if (in_a && in_b && (*in_a || *in_b)) return {d.x, d.y, 0.0};
  }
  return {0.0, 0.0, 0.0};  // not where they touch
}

ClosestPoints closest_points(const ConvexPolygon& a, const Pose& pose_a, const ConvexPolygon& b, const Pose& pose_b,
                             const ClosestFeatures& closest) {
  ClosestPoints points{vertex_point(a, pose_a, closest.a), vertex_point(b, pose_b, closest.b)};
  if (closest.edge_of_a) points.of_a = foot(a, pose_a, closest.a, image(b, pose_b, closest.b));
  if (closest.edge_of_b) points.of_b = foot(b, pose_b, closest.b, image(a, pose_a, closest.a));
  return points;
}

Combination inner_combination(const ConvexPolygon& polygon, const Pose& pose, const ExactPoint2& point) {
  if (polygon.size() == 1) return {{{0, 1.0}}};
  // The point is between the middle m and a point x of the polygon a little further on: x = p + e (p - m), so that
  // p = (x + e m) / (1 + e).
  const std::vector<std::uint32_t> corners = spanning(polygon);
  const ExactPoint2 m = exact_middle(polygon, pose);
  const Exact from_m = times({point.x, point.y}, m.denominator) - times({m.x, m.y}, point.denominator);
  const Dyadic denominator = point.denominator * m.denominator;
  constexpr std::int64_t least = -65536;  // beyond the exponents of certificate files
  for (std::int64_t k = 0; k > least; k = k == 0 ? -1 : 2 * k) {
    const Dyadic e = Dyadic::power_of_two(k);
    const ExactPoint2 x{point.x * m.denominator + e * from_m.x, point.y * m.denominator + e * from_m.y, denominator};
    std::optional<Combination> further = combination(polygon, pose, x);
    if (!further) continue;
    const Dyadic count = whole(static_cast<std::uint32_t>(corners.size()));
    Combination sum;
    sum.denominator = further->denominator * count * (Dyadic(1.0) + e);
    for (const auto& [v, numerator] : further->parts) {
      if (numerator.sign() != Sign::zero) sum.parts.push_back({v, numerator * count});
    }
    for (const std::uint32_t v : corners) sum.add(v, e * further->denominator);
    return sum;
  }
  return {};  // not of a point inside
}

CommonPoint overlapping_point(const ConvexPolygon& a, const Pose& pose_a, const ConvexPolygon& b, const Pose& pose_b) {
  const std::vector<CommonCorner> corners = polygon_polygon_intersection(a, pose_a, b, pose_b).found;
  // Of four corners and more, two that are not neighbours have the inside between them.
  const std::size_t n = corners.size(), few = n > 3 ? 2 : n;
  std::vector<ExactPoint2> chosen;
  for (std::size_t k = 0; k < few; ++k) {
    chosen.push_back(exact_corner(corners[k * n / few], a, pose_a, b, pose_b));
  }
  ExactPoint2 p = mean(chosen);
  if (a.size() > 2 && b.size() > 2) {
    const Point2 rounded = nearest(p);
    if (std::isfinite(rounded.x) && std::isfinite(rounded.y) &&
        place_of(polygon_point(a, pose_a, rounded)) == Place::inside &&
        place_of(polygon_point(b, pose_b, rounded)) == Place::inside) {
      p = exactly(rounded);
    }
  }
  return {in_space(p), inner_combination(a, pose_a, p), inner_combination(b, pose_b, p)};
}

}  // namespace sunder::planar

namespace sunder {

void prove(const TextSink& sink, const AskedPair<planar::ConvexPolygon, planar::Pose>& asked,
           const PairAnswer& answer) {
  const auto in_space = [](const planar::ConvexPolygon& polygon) {
    std::vector<Point3> vertices;
    for (const Point2& p : polygon.vertices()) vertices.push_back({p.x, p.y, 0});
    return vertices;
  };
  const std::vector<Point3> of_a = in_space(asked.a), of_b = in_space(asked.b);
  prove_pair(sink, asked, PairClaims::Space::planar, of_a, planar::in_space(asked.at_a.affine()), of_b,
             planar::in_space(asked.at_b.affine()),
             [&](PairClaims& pairs, std::uint32_t index_a, std::uint32_t index_b) {
               const Relation relation = asked.tells_relation
                                             ? planar::polygon_polygon_contact(asked.a, asked.at_a, asked.b, asked.at_b)
                                             : Relation::none;
               planar::add_claims(pairs, {index_a, index_b, asked.a, asked.at_a, asked.b, asked.at_b}, answer.evidence,
                                  relation);
             });
}

}  // namespace sunder
