#include <sunder/number/estimate_ratio.h>
#include <sunder/predicate/coordinates.h>
#include <sunder/solid/section/polyhedron_plane_section.h>

#include <array>
#include <cmath>
#include <limits>
#include <optional>

namespace sunder::solid {

namespace {

// A vertex in the world, and how far above the plane it is, times the length of the normal.
struct Seen {
  Vector3<Dyadic> at;
  Dyadic height;
};

Seen exactly(const Point3& vertex, const Affine3& pose, const Plane& plane) {
  const Vector3<Dyadic> at = coordinates<Dyadic>(Posed3{vertex, &pose, false});
  return {at, dot(coordinates<Dyadic>(plane.normal), at - coordinates<Dyadic>(plane.point)) - Dyadic(plane.offset)};
}

// Between a, above, and b, below: (h_a b - h_b a) / (h_a - h_b).
Dyadic between(const Seen& a, const Seen& b, const Dyadic& of_a, const Dyadic& of_b) {
  return a.height * of_b - b.height * of_a;
}

// The same with bounds, without terms that are zero.
struct Estimated {
  std::array<Estimate, 3> at;
  Estimate height;
};
Estimated estimate(const Point3& vertex, const Affine3& pose, bool is_at_home, const Plane& plane) {
  Estimated seen{{vertex.x, vertex.y, vertex.z}, -plane.offset};
  if (!is_at_home) {
    const Vector3<Estimate> at = coordinates<Estimate>(Posed3{vertex, &pose, false});
    seen.at = {at.x, at.y, at.z};
  }
  for (std::size_t k = 0; k < 3; ++k) {
    if (plane.normal[k] == 0) continue;
    const Estimate above = plane.point[k] == 0 ? seen.at[k] : seen.at[k] - Estimate(plane.point[k]);
    seen.height = seen.height + Estimate(plane.normal[k]) * above;
  }
  return seen;
}

// Most of what a section's corners cost: all that it calls is inlined.
[[gnu::flatten]] std::array<Estimate, 3> estimated(const ConvexPolyhedron& body, const SectionCorner& corner,
                                                   const Affine3& pose, bool is_at_home, const Plane& plane) {
  const Estimated a = estimate(body.vertices()[corner.above], pose, is_at_home, plane);
  std::array<Estimate, 3> at = a.at;
  if (corner.is_vertex()) return at;
  const Estimated b = estimate(body.vertices()[corner.below], pose, is_at_home, plane);
  const Estimate part = ratio(a.height, a.height - b.height);
  for (std::size_t k = 0; k < 3; ++k) at[k] = a.at[k] + part * (b.at[k] - a.at[k]);
  return at;
}

Point3 nearest_doubles(const ExactPoint3& p) {
  return {nearest_ratio(p.x, p.denominator), nearest_ratio(p.y, p.denominator), nearest_ratio(p.z, p.denominator)};
}

}  // namespace

SectionPoints::SectionPoints(const ConvexPolyhedron& body, const Pose& pose, const Plane& plane)
    : body_(body), pose_(pose.affine()), is_at_home_(pose_ == Affine3()), plane_(plane) {
  int zeros = 0;
  for (int k = 0; k < 3; ++k) {
    const bool is_zero = plane.normal[static_cast<std::size_t>(k)] == 0;
    zeros += is_zero;
    if (!is_zero) axis_ = k;
  }
  if (zeros != 2) axis_ = -1;
  set_offset(plane.offset);
}

void SectionPoints::set_offset(double offset) {
  plane_.offset = offset;
  if (axis_ < 0) return;
  const Dyadic normal = plane_.normal[static_cast<std::size_t>(axis_)];
  level_ = nearest_ratio(normal * plane_.point[static_cast<std::size_t>(axis_)] + Dyadic(offset), normal);
}

ExactPoint3 SectionPoints::exact(const SectionCorner& corner) const {
  const Seen a = exactly(body_.vertices()[corner.above], pose_, plane_);
  if (corner.is_vertex()) return {a.at.x, a.at.y, a.at.z, 1.0};
  const Seen b = exactly(body_.vertices()[corner.below], pose_, plane_);
  return {between(a, b, a.at.x, b.at.x), between(a, b, a.at.y, b.at.y), between(a, b, a.at.z, b.at.z),
          a.height - b.height};
}

Point3 SectionPoints::nearest(const SectionCorner& corner) const {
  if (corner.is_vertex() && is_at_home_) return body_.vertices()[corner.above];
  const std::array<Estimate, 3> at = estimated(body_, corner, pose_, is_at_home_, plane_);
  Point3 p;
  for (std::size_t k = 0; k < 3; ++k) {
    const std::optional<double> known =
        static_cast<int>(k) == axis_ ? level_ : surely_nearest(at[k].value, at[k].error);
    if (!known) return nearest_doubles(exact(corner));
    p[k] = *known;
  }
  return p;
}

}  // namespace sunder::solid
