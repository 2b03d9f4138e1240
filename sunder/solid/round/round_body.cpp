#include <sunder/solid/round/round_body.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>

namespace sunder::solid {

namespace {

void require_radius(double radius) {
  if (std::isfinite(radius) && radius >= 0) return;
  throw Error(ErrorCode::bad_value, "a radius is a finite number that is not negative", "radius");
}

ConvexPolyhedron hull_of(std::initializer_list<Point3> points) {
  return ConvexPolyhedron(std::span<const Point3>(points.begin(), points.size()));
}

// Two different points.
ConvexPolyhedron axis_of(const Point3& from, const Point3& to, const char* what) {
  ConvexPolyhedron axis = hull_of({from, to});
  if (axis.dimension() == 0) {
    throw Error(ErrorCode::bad_shape, "the two points are equal; give two different ones, or a ball", what);
  }
  return axis;
}

// Eight corners at half the sides from the middle, which are perpendicular, as far as doubles tell.
std::shared_ptr<const RoundBox> box_of(const ConvexPolyhedron& core) {
  const std::span<const Point3> vertices = core.vertices();
  if (vertices.size() != 8 || core.neighbours(0).size() != 3) return nullptr;
  constexpr double off = 0x1p-44;
  const auto size2 = [](const Point3& p) { return dot(p, p); };
  RoundBox box;
  box.middle = vertices[0];
  double all2 = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const Point3 side = minus(vertices[core.neighbours(0)[k]], vertices[0]);
    box.half[k] = {side.x / 2, side.y / 2, side.z / 2};
    box.middle = {box.middle.x + box.half[k].x, box.middle.y + box.half[k].y, box.middle.z + box.half[k].z};
    box.over_half2[k] = 1 / size2(box.half[k]);
    all2 += size2(box.half[k]);
  }
  for (std::size_t k = 0; k < 3; ++k) {
    const Point3 &p = box.half[k], &q = box.half[(k + 1) % 3];
    if (!(std::fabs(dot(p, q)) <= off * std::sqrt(size2(p) * size2(q)))) return nullptr;
  }
  for (std::size_t place = 0; place < 8; ++place) {
    Point3 at = box.middle;
    for (std::size_t k = 0; k < 3; ++k) {
      const double by = (place >> k & 1) != 0 ? 1 : -1;
      at = {at.x + by * box.half[k].x, at.y + by * box.half[k].y, at.z + by * box.half[k].z};
    }
    const auto is_here = [&](const Point3& v) { return size2(minus(v, at)) <= off * off * all2; };
    const auto corner = std::find_if(vertices.begin(), vertices.end(), is_here);
    if (corner == vertices.end()) return nullptr;
    const auto vertex = static_cast<std::uint32_t>(corner - vertices.begin());
    const auto end = box.corners.begin() + static_cast<std::ptrdiff_t>(place);
    if (std::find(box.corners.begin(), end, vertex) != end) return nullptr;  // as good as flat
    box.corners[place] = vertex;
  }
  return std::make_shared<const RoundBox>(box);
}

// Of a box, as above. False: some coordinate is another one.
bool is_along_axes(const ConvexPolyhedron& core, AxisBox& box) {
  const std::span<const Point3> vertices = core.vertices();
  box.range = core.box();
  const auto& [low, high] = box.range;
  box.over_side = {1 / (high.x - low.x), 1 / (high.y - low.y), 1 / (high.z - low.z)};
  for (std::size_t v = 0; v < vertices.size(); ++v) {
    const Point3& p = vertices[v];
    const auto is_end = [](double x, double least, double most) { return x == least || x == most; };
    if (!(is_end(p.x, low.x, high.x) && is_end(p.y, low.y, high.y) && is_end(p.z, low.z, high.z))) return false;
    const std::size_t place = (p.x == high.x ? 1u : 0u) | (p.y == high.y ? 2u : 0u) | (p.z == high.z ? 4u : 0u);
    box.corners[place] = static_cast<std::uint8_t>(v);
  }
  return true;
}

Pose pose_of(const RoundBody& body, const Pose& pose) {
  require_rigid(body, pose);
  return body.kind() == RoundKind::ellipsoid ? compose(pose, body.frame_pose()) : pose;
}

// ---- What is drawn.

constexpr std::size_t of_circle = 24;  // points
constexpr std::size_t rings = 8;       // from pole to pole

Point3 added(const Point3& p, const Point3& q) { return {p.x + q.x, p.y + q.y, p.z + q.z}; }
Point3 scaled(double k, const Point3& p) { return {k * p.x, k * p.y, k * p.z}; }
Point3 unit(const Point3& p) { return scaled(1 / std::hypot(p.x, p.y, p.z), p); }

double angle(std::size_t k, std::size_t of) {
  return 2 * std::numbers::pi * static_cast<double>(k) / static_cast<double>(of);
}

// On the ball of radius 1: poles, and rings between them.
std::vector<Point3> ball_points() {
  std::vector<Point3> points{{0, 0, 1}, {0, 0, -1}};
  for (std::size_t i = 1; i < rings; ++i) {
    const double from_pole = angle(i, 2 * rings), radius = std::sin(from_pole);
    for (std::size_t k = 0; k < of_circle; ++k) {
      points.push_back(
          {radius * std::cos(angle(k, of_circle)), radius * std::sin(angle(k, of_circle)), std::cos(from_pole)});
    }
  }
  return points;
}

// The circle around `middle` across the axis.
void add_circle(const Point3& middle, const Point3& axis, double radius, std::vector<Point3>& points) {
  const Point3 along = unit(axis);
  const bool is_upright = std::fabs(along.z) > 0.5;
  const Point3 u = unit(cross(along, is_upright ? Point3{1, 0, 0} : Point3{0, 0, 1})), v = cross(along, u);
  for (std::size_t k = 0; k < of_circle; ++k) {
    const double turn = angle(k, of_circle);
    points.push_back(added(middle, added(scaled(radius * std::cos(turn), u), scaled(radius * std::sin(turn), v))));
  }
}

}  // namespace

RoundBody::RoundBody(RoundKind kind, const ConvexPolyhedron& core, double radius)
    : kind_(kind), radius_(radius), core_(core) {
  require_radius(radius);
  box_ = box_of(core);
  is_along_axes_ = box_ && is_along_axes(core, axis_box_);
  greatest_ = core.search_graph().sizes.greatest;
  const std::span<const Point3> vertices = core.vertices();
  if (vertices.size() > 2) return;
  count_ = static_cast<std::uint32_t>(vertices.size());
  std::copy(vertices.begin(), vertices.end(), axis_box_.range.begin());
}

RoundBody::RoundBody(const ConvexPolyhedron& polyhedron) : RoundBody(RoundKind::hull, polyhedron, 0) {}

RoundBody RoundBody::ball(const Point3& centre, double radius) { return {RoundKind::hull, hull_of({centre}), radius}; }

RoundBody RoundBody::capsule(const Point3& from, const Point3& to, double radius) {
  return {RoundKind::hull, hull_of({from, to}), radius};
}

RoundBody RoundBody::rounded(const ConvexPolyhedron& core, double radius) { return {RoundKind::hull, core, radius}; }

RoundBody RoundBody::cylinder(const Point3& base, const Point3& top, double radius) {
  const ConvexPolyhedron axis = axis_of(base, top, "its ends");
  if (radius == 0) return {RoundKind::hull, axis, 0};
  RoundBody body(RoundKind::cylinder, axis, radius);
  body.axis_box_.range = {base, top};
  return body;
}

RoundBody RoundBody::cone(const Point3& base, const Point3& apex, double radius) {
  const ConvexPolyhedron axis = axis_of(base, apex, "its base and apex");
  if (radius == 0) return {RoundKind::hull, axis, 0};
  RoundBody body(RoundKind::cone, axis, radius);
  body.axis_box_.range = {base, apex};
  return body;
}

RoundBody RoundBody::ellipsoid(const Point3& centre, const std::array<double, 3>& semi_axes) {
  for (const double x : semi_axes) {
    if (std::isfinite(x) && x > 0) continue;
    throw Error(ErrorCode::bad_value, "a semi-axis is a finite number above zero", "its semi-axes");
  }
  hull_of({centre});  // finite
  RoundBody body(RoundKind::ellipsoid, hull_of({Point3{}}), 1);
  body.frame_ =
      Pose::from_matrix({semi_axes[0], 0, 0, 0, semi_axes[1], 0, 0, 0, semi_axes[2]}, {centre.x, centre.y, centre.z});
  return body;
}

std::span<const Point3> RoundBody::points() const { return kind_ == RoundKind::hull ? core_.vertices() : ends(); }

double reach_beyond_core(const RoundBody& body) {
  return body.kind() == RoundKind::ellipsoid ? std::numeric_limits<double>::infinity() : body.radius();
}

RoundBody smaller(const RoundBody& body) {
  constexpr double part = 1 - 0x1p-43;
  const std::span<const Point3> p = body.points();
  const double r = body.radius() * part;
  if (!body.is_curved()) return RoundBody::rounded(body.core(), r);
  if (body.kind() == RoundKind::ellipsoid) {
    const auto& [m, t] = body.frame();
    return RoundBody::ellipsoid({t[0], t[1], t[2]}, {m[0] * part, m[4] * part, m[8] * part});
  }
  const bool is_cone = body.kind() == RoundKind::cone;
  const auto inwards = [&](const Point3& from, const Point3& to, double by) {
    return Point3{from.x + by * (to.x - from.x), from.y + by * (to.y - from.y), from.z + by * (to.z - from.z)};
  };
  const Point3 from = inwards(p[0], p[1], 0x1p-44), to = inwards(p[1], p[0], is_cone ? 0x1p-42 : 0x1p-44);
  if (from.x == to.x && from.y == to.y && from.z == to.z) return body;
  return is_cone ? RoundBody::cone(from, to, r) : RoundBody::cylinder(from, to, r);
}

RoundWords words_of(const RoundBody& body) {
  const std::span<const Point3> p = body.points();
  if (body.kind() == RoundKind::ellipsoid) {
    const auto& [m, t] = body.frame();
    return {
        "ellipsoid", ", center {points}, semi-axes ({sizes})", {{t[0], t[1], t[2]}}, "semi_axes", {m[0], m[4], m[8]}};
  }
  const char* const shape = body.is_curved() ? row_of(body.kind()).key
                            : p.size() == 1  ? "ball"
                            : p.size() == 2  ? "capsule"
                                             : "rounded hull";
  return {shape,
          p.size() == 1 ? " of radius {sizes}, center {points}" : " of radius {sizes}, from {points}",
          {p.begin(), p.end()},
          "radius",
          {body.radius()}};
}

DrawnBody drawn_as(const RoundBody& body) {
  if (body.is_polyhedron()) return {body.core()};
  const std::span<const Point3> core = body.points();
  std::vector<Point3> points;
  if (body.kind() == RoundKind::hull) {
    for (const Point3& p : ball_points()) {
      for (const Point3& q : core) points.push_back(added(q, scaled(body.radius(), p)));
    }
  } else if (body.kind() == RoundKind::ellipsoid) {
    const auto& [m, t] = body.frame();  // a diagonal
    for (const Point3& p : ball_points()) points.push_back({m[0] * p.x + t[0], m[4] * p.y + t[1], m[8] * p.z + t[2]});
  } else {
    const Point3 axis = added(core[1], scaled(-1, core[0]));
    add_circle(core[0], axis, body.radius(), points);
    if (body.kind() == RoundKind::cylinder) {
      add_circle(core[1], axis, body.radius(), points);
    } else {
      points.push_back(core[1]);
    }
  }
  return {ConvexPolyhedron(points), false};
}

void require_rigid(const RoundBody& body, const Pose& pose) {
  if (body.is_polyhedron() || body.kind() == RoundKind::ellipsoid || pose.is_rigid()) return;
  throw Error(ErrorCode::bad_pose,
              "the pose scales or shears, and what that does to a radius is not defined here; give a rotation and a "
              "translation, and scale the body's points and its radius in its file",
              "pose");
}

RoundShape shape_of(const RoundBody& body, const Affine3& pose) {
  RoundShape shape{body.kind(), {}, &pose, body.radius()};
  if (body.is_curved()) std::copy(body.ends().begin(), body.ends().end(), shape.points.begin());
  return shape;
}

PlacedRound::PlacedRound(const RoundBody& of, const Pose& at)
    : body(of), pose(pose_of(of, at)), core(of.core(), pose), shape(shape_of(of, pose.affine())) {}

}  // namespace sunder::solid
