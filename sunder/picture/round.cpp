#include <sunder/picture/round.h>

#include <cmath>
#include <cstddef>
#include <numbers>
#include <span>
#include <vector>

namespace sunder::picture {

namespace {

constexpr std::size_t around = 24;  // points of a circle
constexpr std::size_t rings = 8;    // from pole to pole

Point3 sum(const Point3& p, const Point3& q) { return {p.x + q.x, p.y + q.y, p.z + q.z}; }
Point3 times(double k, const Point3& p) { return {k * p.x, k * p.y, k * p.z}; }
Point3 cross_of(const Point3& p, const Point3& q) {
  return {p.y * q.z - p.z * q.y, p.z * q.x - p.x * q.z, p.x * q.y - p.y * q.x};
}
Point3 unit(const Point3& p) { return times(1 / std::hypot(p.x, p.y, p.z), p); }

double angle(std::size_t k, std::size_t of) {
  return 2 * std::numbers::pi * static_cast<double>(k) / static_cast<double>(of);
}

// On the ball of radius 1: poles, and rings between them.
std::vector<Point3> ball_points() {
  std::vector<Point3> points{{0, 0, 1}, {0, 0, -1}};
  for (std::size_t i = 1; i < rings; ++i) {
    const double from_pole = angle(i, 2 * rings), radius = std::sin(from_pole);
    for (std::size_t k = 0; k < around; ++k) {
      points.push_back({radius * std::cos(angle(k, around)), radius * std::sin(angle(k, around)), std::cos(from_pole)});
    }
  }
  return points;
}

// The circle around `middle` across the axis.
void add_circle(const Point3& middle, const Point3& axis, double radius, std::vector<Point3>& points) {
  const Point3 along = unit(axis);
  const bool is_upright = std::fabs(along.z) > 0.5;
  const Point3 u = unit(cross_of(along, is_upright ? Point3{1, 0, 0} : Point3{0, 0, 1})), v = cross_of(along, u);
  for (std::size_t k = 0; k < around; ++k) {
    const double turn = angle(k, around);
    points.push_back(sum(middle, sum(times(radius * std::cos(turn), u), times(radius * std::sin(turn), v))));
  }
}

}  // namespace

solid::ConvexPolyhedron drawn_as(const solid::RoundBody& body) {
  if (body.is_polyhedron()) return body.core();
  const std::span<const Point3> core = body.points();
  std::vector<Point3> points;
  switch (body.kind()) {
    case RoundKind::cylinder:
    case RoundKind::cone: {
      const Point3 axis = sum(core[1], times(-1, core[0]));
      add_circle(core[0], axis, body.radius(), points);
      if (body.kind() == RoundKind::cylinder) {
        add_circle(core[1], axis, body.radius(), points);
      } else {
        points.push_back(core[1]);
      }
      break;
    }
    case RoundKind::ellipsoid: {
      const auto& [m, t] = body.frame();  // a diagonal
      for (const Point3& p : ball_points()) points.push_back({m[0] * p.x + t[0], m[4] * p.y + t[1], m[8] * p.z + t[2]});
      break;
    }
    case RoundKind::hull:
      for (const Point3& p : ball_points()) {
        for (const Point3& q : core) points.push_back(sum(q, times(body.radius(), p)));
      }
      break;
  }
  return solid::ConvexPolyhedron(points);
}

}  // namespace sunder::picture
