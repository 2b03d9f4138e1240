#include <sunder/picture/scene_view.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace sunder::picture {

namespace {

Point3 operator-(const Point3& a, const Point3& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
double dot(const Point3& a, const Point3& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
Point3 cross(const Point3& a, const Point3& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
Point3 unit(const Point3& a) {
  const double length = std::sqrt(dot(a, a));
  return length > 0 ? Point3{a.x / length, a.y / length, a.z / length} : a;
}

Point3 middle_of(std::span<const Point3> points) {
  Point3 sum;
  for (const Point3& p : points) sum = {sum.x + p.x, sum.y + p.y, sum.z + p.z};
  const double n = static_cast<double>(points.size());
  return {sum.x / n, sum.y / n, sum.z / n};
}

// Twice the area of the polygon, along its normal (Newell).
Point3 area_vector(std::span<const Point3> corners) {
  Point3 sum;
  for (std::size_t i = 1; i + 1 < corners.size(); ++i) {
    const Point3 n = cross(corners[i] - corners[0], corners[i + 1] - corners[0]);
    sum = {sum.x + n.x, sum.y + n.y, sum.z + n.z};
  }
  return sum;
}

struct Facet {
  std::vector<std::uint32_t> vertices;
  std::vector<Point3> corners;
  Point3 normal;  // outwards
};

// Outwards also where the pose reflects.
std::vector<Facet> facets_of(const scene::Part& part, std::span<const Point3> points) {
  std::vector<Facet> facets;
  const Point3 inside = middle_of(points);
  for (std::uint32_t f = 0; f < part.shape.facet_count(); ++f) {
    Facet facet;
    facet.vertices.assign(part.shape.facet(f).begin(), part.shape.facet(f).end());
    for (const std::uint32_t v : facet.vertices) facet.corners.push_back(points[v]);
    facet.normal = unit(area_vector(facet.corners));
    if (dot(facet.normal, facet.corners[0] - inside) < 0) {
      facet.normal = {-facet.normal.x, -facet.normal.y, -facet.normal.z};
    }
    facets.push_back(std::move(facet));
  }
  return facets;
}

void add_pieces(std::uint32_t body, std::uint32_t number, const scene::Part& part, const View& view,
                std::vector<Piece>& out) {
  const std::vector<Point3> points = world_vertices(part);
  if (part.shape.dimension() < 2) {
    Piece line{body, number, 1, {}, {}};
    for (const Point3& p : points) line.corners.push_back(view(p));
    line.edges.assign(line.corners.size(), Edge::outline);
    out.push_back(std::move(line));
    return;
  }
  const std::vector<Facet> facets = facets_of(part, points);
  std::map<std::pair<std::uint32_t, std::uint32_t>, bool> seen_from;  // edge, as its facet runs: is the facet in front?
  const auto in_front = [&](const Facet& facet) { return view.towards_viewer(facet.normal) > 0; };
  const auto each_edge = [](const Facet& facet, const auto& visit) {
    for (std::size_t i = 0; i < facet.vertices.size(); ++i) {
      visit(facet.vertices[i], facet.vertices[(i + 1) % facet.vertices.size()]);
    }
  };
  for (const Facet& facet : facets) {
    each_edge(facet, [&](std::uint32_t v, std::uint32_t w) { seen_from[{v, w}] = in_front(facet); });
  }
  for (const Facet& facet : facets) {
    if (!in_front(facet)) continue;
    Piece piece{body, number, view.light_on(facet.normal), {}, {}};
    for (const Point3& p : facet.corners) piece.corners.push_back(view(p));
    each_edge(facet, [&](std::uint32_t v, std::uint32_t w) {
      piece.edges.push_back(seen_from[{w, v}] ? Edge::inner : Edge::outline);
    });
    out.push_back(std::move(piece));
  }
}

}  // namespace

View::View(double azimuth, double elevation)
    : right_{-std::sin(azimuth), std::cos(azimuth), 0},
      up_{-std::sin(elevation) * std::cos(azimuth), -std::sin(elevation) * std::sin(azimuth), std::cos(elevation)},
      to_viewer_{std::cos(elevation) * std::cos(azimuth), std::cos(elevation) * std::sin(azimuth),
                 std::sin(elevation)} {
  // From above the viewer's left shoulder.
  const auto along = [&](double Point3::* c) { return 0.55 * to_viewer_.*c + 0.75 * up_.*c - 0.5 * right_.*c; };
  to_light_ = unit({along(&Point3::x), along(&Point3::y), along(&Point3::z)});
}

Seen View::operator()(const Point3& p) const { return {dot(right_, p), -dot(up_, p), dot(to_viewer_, p)}; }

double View::towards_viewer(const Point3& direction) const { return dot(to_viewer_, direction); }

double View::light_on(const Point3& normal) const { return std::max(0.0, dot(to_light_, normal)); }

std::vector<Point3> world_vertices(const scene::Part& part) {
  const Affine3& pose = part.pose.affine();
  const auto& m = pose.linear;
  const auto& t = pose.translation;
  std::vector<Point3> points;
  for (const Point3& p : part.shape.vertices()) {
    points.push_back({m[0] * p.x + m[1] * p.y + m[2] * p.z + t[0], m[3] * p.x + m[4] * p.y + m[5] * p.z + t[1],
                      m[6] * p.x + m[7] * p.y + m[8] * p.z + t[2]});
  }
  return points;
}

std::vector<Piece> seen_pieces(std::span<const scene::Body> bodies, const View& view) {
  std::vector<Piece> pieces;
  std::uint32_t number = 0;
  for (std::uint32_t b = 0; b < bodies.size(); ++b) {
    for (const scene::Part& part : bodies[b].parts) add_pieces(b, number++, part, view, pieces);
  }
  return in_painters_order(std::move(pieces));
}

std::vector<std::vector<Seen>> shadows(std::span<const scene::Body> bodies, const View& view, double floor) {
  std::vector<std::vector<Seen>> all;
  for (const scene::Body& body : bodies) {
    for (const scene::Part& part : body.parts) {
      std::vector<Point3> points = world_vertices(part);
      for (Point3& p : points) p.z = floor;
      const solid::ConvexPolyhedron shadow(points);
      if (shadow.dimension() < 2) continue;
      all.emplace_back();
      for (const std::uint32_t v : shadow.facet(0)) all.back().push_back(view(shadow.vertices()[v]));
    }
  }
  return all;
}

}  // namespace sunder::picture
