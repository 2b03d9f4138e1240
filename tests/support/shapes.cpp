#include <tests/support/shapes.h>

#include <numbers>

namespace sunder::tests {

using planar::ConvexPolygon;
using planar::Segment;

Point2 on_circle(double turn, double radius, const Point2& center) {
  const double angle = 2 * std::numbers::pi * turn;
  return {center.x + radius * std::cos(angle), center.y + radius * std::sin(angle)};
}

ConvexPolygon regular_polygon(std::uint32_t n, double radius, double first_angle, const Point2& center) {
  std::vector<Point2> points;
  for (std::uint32_t k = 0; k < n; ++k) {
    const double angle = first_angle + 2 * std::numbers::pi * k / n;
    points.push_back({center.x + radius * std::cos(angle), center.y + radius * std::sin(angle)});
  }
  return ConvexPolygon::hull_of(points);
}

std::vector<Segment> short_segments(std::size_t n, const Point2& low, double size, double reach, Random& random) {
  std::vector<Segment> segments;
  for (std::size_t k = 0; k < n; ++k) {
    const Point2 p{low.x + size * random.unit(), low.y + size * random.unit()};
    segments.push_back({p, {p.x + reach * random.uniform(-1, 1), p.y + reach * random.uniform(-1, 1)}});
  }
  return segments;
}

std::vector<Disc> discs_in_square(std::size_t n, const Point2& low, double size, double radius, Random& random) {
  std::vector<Disc> discs;
  for (std::size_t k = 0; k < n; ++k) {
    discs.push_back({{low.x + size * random.unit(), low.y + size * random.unit()}, radius * random.unit()});
  }
  return discs;
}

std::vector<Segment> mesh_edges(std::size_t n, Random& random) {
  const std::size_t side = static_cast<std::size_t>(std::sqrt(static_cast<double>(n) / 2)) + 1;
  std::vector<Point2> p;
  for (std::size_t k = 0; k < side * side; ++k) {
    const std::size_t column = k / side, row = k % side;
    p.push_back({static_cast<double>(column) + 0.3 * random.unit(), static_cast<double>(row) + 0.3 * random.unit()});
  }
  std::vector<Segment> segments;
  for (std::size_t k = 0; k < side * side; ++k) {
    if (k % side + 1 < side) segments.push_back({p[k], p[k + 1]});
    if (k + side < side * side) segments.push_back({p[k], p[k + side]});
  }
  return segments;
}

std::vector<Segment> hatch(std::size_t n) {
  std::vector<Segment> segments;
  const std::size_t half = n / 2;
  const double side = static_cast<double>(half);
  for (std::size_t k = 0; k < half; ++k) {
    const double at = static_cast<double>(k);
    segments.push_back({{-1, at}, {side, at}});
    segments.push_back({{at, -1}, {at, side}});
  }
  return segments;
}

std::vector<Point3> in_space(const ConvexPolygon& polygon) {
  std::vector<Point3> points;
  for (const Point2& p : polygon.vertices()) points.push_back({p.x, p.y, 0});
  return points;
}

Point3 in_cube(Random& random) { return {random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)}; }

Point3 on_grid(Random& random, std::int64_t side) {
  const auto one = [&] { return static_cast<double>(random.between(-side, side)); };
  return {one(), one(), one()};
}

Point3 on_sphere(Random& random) {
  for (;;) {
    const Point3 p = in_cube(random);
    const double r2 = p.x * p.x + p.y * p.y + p.z * p.z;
    if (r2 < 0.01 || r2 > 1) continue;
    const double s = 1 / std::sqrt(r2);
    return {p.x * s, p.y * s, p.z * s};
  }
}

std::vector<Point3> points_in_cube(std::size_t n, Random& random) {
  std::vector<Point3> points;
  while (points.size() < n) points.push_back(in_cube(random));
  return points;
}

std::vector<Point3> points_on_sphere(std::size_t n, Random& random) {
  std::vector<Point3> points;
  while (points.size() < n) points.push_back(on_sphere(random));
  return points;
}

std::vector<Point3> cube_corners(double low, double high) {
  std::vector<Point3> corners;
  for (int i = 0; i < 8; ++i) corners.push_back({i & 1 ? high : low, i & 2 ? high : low, i & 4 ? high : low});
  return corners;
}

}  // namespace sunder::tests
