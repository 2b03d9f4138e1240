#include <sunder/base/json.h>
#include <sunder/number/vector.h>
#include <sunder/predicate/point/orient.h>
#include <sunder/solid/represent/of.h>
#include <sunder/solid/represent/polar_about.h>

#include <cmath>
#include <string>

namespace sunder::solid {

namespace {

bool is_within(const ConvexPolyhedron& body, const Point3& p) {
  for (std::uint32_t f = 0; f < body.facet_count(); ++f) {
    const auto facet = body.facet(f);
    const auto at = [&](std::size_t k) -> const Point3& { return body.vertices()[facet[k]]; };
    if (orient_3d(at(0), at(1), at(2), p) != Sign::negative) return false;
  }
  return true;
}

std::string point_text(const Point3& p) { return json_number(p.x) + "," + json_number(p.y) + "," + json_number(p.z); }

Vector3<Dyadic> arrow(const Point3& from, const Point3& to) {
  return {Dyadic(to.x) - Dyadic(from.x), Dyadic(to.y) - Dyadic(from.y), Dyadic(to.z) - Dyadic(from.z)};
}

}  // namespace

PolarAbout polar_about(const ConvexPolyhedron& body, const Point3& origin) {
  if (body.dimension() != 3) {
    throw Error(ErrorCode::bad_shape,
                "has no interior, so no point is inside and each polar is unbounded; give a body of dimension 3");
  }
  if (!std::isfinite(origin.x) || !std::isfinite(origin.y) || !std::isfinite(origin.z)) {
    throw Error(ErrorCode::bad_value, "the origin of a polar has finite coordinates");
  }
  const Polar& known = represent::of<Polar>(body);
  if (!is_within(body, origin)) {
    std::string text = "the origin " + point_text(origin) + " is not inside the body, so its polar is unbounded; ";
    text += is_within(body, known.center) ? "give a point inside, as " + point_text(known.center) : "give one inside";
    throw Error(ErrorCode::bad_value, text);
  }
  PolarAbout polar{origin, {}, known.facet_begin, known.facet_vertices};
  polar.vertices.reserve(body.facet_count());
  for (std::uint32_t f = 0; f < body.facet_count(); ++f) {
    const auto facet = body.facet(f);
    const Point3 &a = body.vertices()[facet[0]], &b = body.vertices()[facet[1]], &c = body.vertices()[facet[2]];
    const Vector3<Dyadic> n = cross(arrow(a, b), arrow(a, c));
    polar.vertices.push_back({{n.x, n.y, n.z}, dot(n, arrow(origin, a))});
  }
  return polar;
}

Point3 nearest_point(const PolarVertex& vertex) {
  return {nearest_ratio(vertex.n[0], vertex.h), nearest_ratio(vertex.n[1], vertex.h),
          nearest_ratio(vertex.n[2], vertex.h)};
}

}  // namespace sunder::solid
