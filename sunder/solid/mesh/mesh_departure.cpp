#include <sunder/number/double_double.h>
#include <sunder/number/dyadic.h>
#include <sunder/predicate/coordinates.h>
#include <sunder/predicate/point/orient.h>
#include <sunder/solid/mesh/mesh_departure.h>
#include <sunder/solid/mesh/mesh_sides.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <tuple>
#include <utility>
#include <vector>

namespace sunder::solid {

namespace {

constexpr double slack = 1 + 0x1p-20;      // what is deeper by less is not looked for
constexpr double noise = 0x1p-46;          // of a height in doubles, in proportion to the differences it is made of
constexpr double accurate = 0x1p16;        // a height this many times its noise is right to five digits
constexpr std::size_t most_recent = 8;     // planes that are tried first
constexpr std::size_t sampled_edges = 32;  // are looked at before the others
constexpr std::uint64_t most_work = 1u << 28;

// The plane of a facet. `unit` is the outer normal up to rounding; det and longest are exact.
struct Plane {
  std::array<Point3, 3> corners;
  Point3 unit;
  Dyadic longest;     // the entry of the exact normal of the largest magnitude, its magnitude
  double scaled = 1;  // the length of the exact normal, divided by longest
};

Vector3<Dyadic> exact_difference(const Point3& p, const Point3& q) {
  return coordinates<Dyadic>(p) - coordinates<Dyadic>(q);
}

Vector3<Dyadic> exact_normal(const std::array<Point3, 3>& c) {
  return cross(exact_difference(c[1], c[0]), exact_difference(c[2], c[0]));
}

Plane plane_of(const ConvexPolyhedron& hull, std::uint32_t facet) {
  const auto cycle = hull.facet(facet);
  Plane plane;
  for (std::size_t i = 0; i < 3; ++i) plane.corners[i] = hull.vertices()[cycle[i]];
  const Vector3<Dyadic> normal = exact_normal(plane.corners);
  for (const Dyadic* entry : {&normal.x, &normal.y, &normal.z}) {
    const Dyadic size = entry->sign() == Sign::negative ? -*entry : *entry;
    if ((size - plane.longest).sign() == Sign::positive) plane.longest = size;
  }
  const auto scaled = [&](const Dyadic& entry) { return nearest_ratio(entry, plane.longest); };
  plane.unit = {scaled(normal.x), scaled(normal.y), scaled(normal.z)};
  plane.scaled = std::sqrt(plane.unit.x * plane.unit.x + plane.unit.y * plane.unit.y + plane.unit.z * plane.unit.z);
  for (double Point3::* axis : {&Point3::x, &Point3::y, &Point3::z}) plane.unit.*axis /= plane.scaled;
  return plane;
}

struct Height {
  double value, noise;

  bool is_accurate() const { return value >= accurate * noise; }
};

// How far the point is below the plane, in doubles.
Height rough_height(const Plane& plane, const Point3& p) {
  const Point3& a = plane.corners[0];
  const double x = a.x - p.x, y = a.y - p.y, z = a.z - p.z;
  return {plane.unit.x * x + plane.unit.y * y + plane.unit.z * z, noise * (std::fabs(x) + std::fabs(y) + std::fabs(z))};
}

// The same, right to five digits, and 0 only where it is.
double height(const Plane& plane, const Point3& p) {
  const Height rough = rough_height(plane, p);
  if (rough.is_accurate()) return rough.value;
  const Dyadic product = dot(exact_normal(plane.corners), exact_difference(plane.corners[0], p));
  return nearest_ratio(product, plane.longest) / plane.scaled;
}

// The height below one plane along an edge: at its ends.
struct Line {
  double from, to;

  double at(double t) const { return (1 - t) * from + t * to; }
};

// Where the least of the lines is greatest, for t from 0 to 1.
std::pair<double, double> highest(const std::vector<Line>& lines) {
  const auto least = [&](double t) {
    double value = std::numeric_limits<double>::infinity();
    for (const Line& line : lines) value = std::min(value, line.at(t));
    return value;
  };
  std::pair<double, double> best{0.0, least(0)};
  const auto look = [&](double t) {
    if (const double value = least(t); value > best.second) best = {t, value};
  };
  look(1);
  for (std::size_t i = 0; i < lines.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {  // where the two cross
      const double before = lines[i].from - lines[j].from, after = lines[j].to - lines[i].to;
      if (const double t = before / (before + after); t > 0 && t < 1) look(t);
    }
  }
  return best;
}

using Edge = std::array<std::uint32_t, 2>;  // numbers of vertices

class Depth {
 public:
  // lowest: as in MeshSides.
  Depth(const MeshView& mesh, const ConvexPolyhedron& hull, const std::vector<std::uint32_t>& lowest)
      : mesh_(mesh), at_vertex_(hull.vertices().size()) {
    for (std::uint32_t f = 0; f < hull.facet_count(); ++f) {
      planes_.push_back(plane_of(hull, f));
      for (const std::uint32_t v : hull.facet(f)) at_vertex_[v].push_back(f);
    }
    extreme_.assign(mesh.vertices.size(), no_vertex);
    for (std::uint32_t v = 0; v < hull.vertices().size(); ++v) extreme_[lowest[hull.source()[v]]] = v;
  }

  void find(const std::vector<Edge>& edges, MeshDeparture& departure) {
    const std::size_t stride = std::max<std::size_t>(1, edges.size() / sampled_edges);
    for (std::size_t e = 0; e < edges.size() && work_ < most_work; e += stride) look_at(edges[e]);
    for (std::size_t e = 0; e < edges.size() && work_ < most_work; ++e) look_at(edges[e]);
    departure.depth = deepest_;
    departure.at_least = work_ >= most_work;
  }

 private:
  static constexpr std::uint32_t no_vertex = std::numeric_limits<std::uint32_t>::max();

  const Point3& at(std::uint32_t v) const { return mesh_.vertices[v]; }

  // Is the point at most as far below the plane as the deepest one so far?
  bool is_shallow(std::uint32_t plane, std::uint32_t v) {
    ++work_;
    const Plane& p = planes_[plane];
    const double most = deepest_ * slack;
    const Height rough = rough_height(p, at(v));
    if (rough.value + rough.noise <= most) return true;
    if (rough.value - rough.noise > most) return false;
    if (deepest_ == 0) return orient_3d(p.corners[0], p.corners[1], p.corners[2], at(v)) == Sign::zero;
    return height(p, at(v)) <= most;
  }

  bool is_shallow(std::uint32_t plane, const Edge& edge) {
    return is_shallow(plane, edge[0]) && is_shallow(plane, edge[1]);
  }

  // By the planes at an end that is extreme, and by those that were near before.
  bool is_shallow(const Edge& edge) {
    for (std::size_t i = 0; i < recent_.size(); ++i) {
      if (!is_shallow(recent_[i], edge)) continue;
      std::rotate(recent_.begin(), recent_.begin() + static_cast<std::ptrdiff_t>(i),
                  recent_.begin() + static_cast<std::ptrdiff_t>(i) + 1);
      return true;
    }
    for (const std::uint32_t v : edge) {
      if (extreme_[v] == no_vertex) continue;
      for (const std::uint32_t f : at_vertex_[extreme_[v]]) {
        if (is_shallow(f, edge)) return true;
      }
    }
    return false;
  }

  void remember(std::uint32_t plane) {
    std::erase(recent_, plane);
    recent_.insert(recent_.begin(), plane);
    if (recent_.size() > most_recent) recent_.pop_back();
  }

  // The plane that is nearest to the place t of the edge.
  std::uint32_t nearest_plane(const Edge& edge, double t) {
    work_ += 2 * planes_.size();
    rough_.clear();
    double least = std::numeric_limits<double>::infinity();  // of what the heights are at most
    for (const Plane& plane : planes_) {
      const Height from = rough_height(plane, at(edge[0])), to = rough_height(plane, at(edge[1]));
      rough_.push_back({(1 - t) * from.value + t * to.value, from.noise + to.noise});
      least = std::min(least, rough_.back().value + rough_.back().noise);
    }
    std::uint32_t nearest = 0;
    double value = std::numeric_limits<double>::infinity();
    for (std::uint32_t f = 0; f < planes_.size(); ++f) {
      if (!(rough_[f].value - rough_[f].noise <= least)) continue;
      const double height = rough_[f].is_accurate() ? rough_[f].value : line_of(f, edge).at(t);
      if (height < value) std::tie(nearest, value) = std::pair(f, height);
    }
    return nearest;
  }

  Line line_of(std::uint32_t plane, const Edge& edge) const {
    return {height(planes_[plane], at(edge[0])), height(planes_[plane], at(edge[1]))};
  }

  void look_at(const Edge& edge) {
    if (is_shallow(edge)) return;
    std::vector<Line> lines;
    std::vector<std::uint32_t> planes;
    for (double t = 0.5;;) {
      const std::uint32_t plane = nearest_plane(edge, t);
      const Line line = line_of(plane, edge);
      const bool is_known = std::find(planes.begin(), planes.end(), plane) != planes.end();
      deepest_ = std::max(deepest_, line.at(t));
      if (is_known) break;
      planes.push_back(plane);
      lines.push_back(line);
      const auto [place, most] = highest(lines);
      if (most <= deepest_ * slack) break;
      t = place;
    }
    for (const std::uint32_t plane : planes) remember(plane);
  }

  const MeshView& mesh_;
  std::vector<Plane> planes_;
  std::vector<std::vector<std::uint32_t>> at_vertex_;  // the facets at each vertex of the hull
  std::vector<std::uint32_t> extreme_;                 // the vertex of the hull that a vertex of the mesh is
  std::vector<std::uint32_t> recent_;                  // planes that were nearest, the last one first
  std::vector<Height> rough_;
  double deepest_ = 0;
  std::uint64_t work_ = 0;
};

// ---- Volumes, six times, in units of scale^3, relative to a point.

using Vector = Vector3<DoubleDouble>;

class Volumes {
 public:
  explicit Volumes(const ConvexPolyhedron& hull) : origin_(hull.vertices()[0]) {
    const auto [low, high] = hull.box();
    int exponent = 0;
    std::frexp(std::max({high.x / 4 - low.x / 4, high.y / 4 - low.y / 4, high.z / 4 - low.z / 4}), &exponent);
    exponent_ = exponent;
  }

  // A cycle of points on a plane.
  template <class At>
  DoubleDouble under(std::size_t count, const At& at) const {
    DoubleDouble sum;
    const Vector first = vector(at(0));
    for (std::size_t i = 1; i + 1 < count; ++i) sum += dot(first, cross(vector(at(i)), vector(at(i + 1))));
    return sum;
  }

  double unscaled(const DoubleDouble& six_times) const { return std::ldexp(nearest(six_times / 6.0), 3 * exponent_); }

 private:
  Vector vector(const Point3& p) const {
    const auto entry = [&](double x, double from) {
      return DoubleDouble(std::ldexp(x, -exponent_)) - DoubleDouble(std::ldexp(from, -exponent_));
    };
    return {entry(p.x, origin_.x), entry(p.y, origin_.y), entry(p.z, origin_.z)};
  }

  Point3 origin_;
  int exponent_ = 0;
};

bool is_flat(const MeshView& mesh, std::uint32_t face) {
  const auto corners = mesh.polygon(face);
  const auto at = [&](std::size_t i) -> const Point3& { return mesh.vertices[corners[i]]; };
  for (std::size_t i = 3; i < corners.size(); ++i) {
    // Each four in a row in one plane is not enough where three are on a line; then the volume is not told.
    if (orient_3d(at(i - 3), at(i - 2), at(i - 1), at(i)) != Sign::zero) return false;
    if (orient_3d(at(0), at(1), at(i - 1), at(i)) != Sign::zero) return false;
  }
  return true;
}

std::optional<MeshDeparture::Volume> volume_of(const MeshView& mesh, const ConvexPolyhedron& hull) {
  for (std::uint32_t f = 0; f < mesh.polygon_count(); ++f) {
    if (!is_flat(mesh, f)) return std::nullopt;
  }
  const Volumes volumes(hull);
  DoubleDouble of_mesh, of_hull;
  for (std::uint32_t f = 0; f < mesh.polygon_count(); ++f) {
    const auto corners = mesh.polygon(f);
    of_mesh += volumes.under(corners.size(), [&](std::size_t i) { return mesh.vertices[corners[i]]; });
  }
  for (std::uint32_t f = 0; f < hull.facet_count(); ++f) {
    const auto corners = hull.facet(f);
    of_hull += volumes.under(corners.size(), [&](std::size_t i) { return hull.vertices()[corners[i]]; });
  }
  const DoubleDouble missing = of_hull - magnitude(of_mesh);
  if (missing < DoubleDouble(-0x1p-80) * of_hull) return std::nullopt;  // it goes around something twice
  return MeshDeparture::Volume{volumes.unscaled(of_hull), std::max(volumes.unscaled(missing), 0.0)};
}

}  // namespace

MeshDeparture mesh_departure(const MeshView& mesh, const ConvexPolyhedron& hull) {
  const MeshSides topology(mesh);
  std::vector<Edge> edges;
  int balance = 0;  // of sides one way and sides the other way
  bool closed = true;
  for (const MeshSides::Side& side : topology.sides) {
    const auto [from, to] = side.ends();
    if (edges.empty() || edges.back() != Edge{from, to}) {
      closed = closed && balance == 0;
      balance = 0;
      edges.push_back({from, to});
    }
    balance += side.from == from ? 1 : -1;
  }
  MeshDeparture departure;
  Depth(mesh, hull, topology.lowest).find(edges, departure);
  if (closed && balance == 0) departure.volume = volume_of(mesh, hull);
  return departure;
}

}  // namespace sunder::solid
