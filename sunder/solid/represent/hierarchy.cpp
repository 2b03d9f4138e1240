#include <sunder/base/contract.h>
#include <sunder/number/vector.h>
#include <sunder/predicate/point/along.h>
#include <sunder/predicate/point/orient.h>
#include <sunder/predicate/posed.h>
#include <sunder/solid/object/convex_polyhedron.h>
#include <sunder/solid/represent/hierarchy.h>
#include <sunder/solid/represent/hierarchy_builder.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace sunder::solid {

namespace {

using hierarchy_detail::after, hierarchy_detail::before, hierarchy_detail::Face, hierarchy_detail::History,
    hierarchy_detail::none;

struct Points {
  std::span<const Point3> points;

  const Point3& at(std::uint32_t v) const { return points[v]; }
  Sign orient(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) const {
    return orient_3d(points[a], points[b], points[c], points[d]);
  }
};

// The middles of the vertices of a polyhedron.
class Middles {
 public:
  using Builder = hierarchy_detail::HierarchyBuilder<Points>;
  using Surface = hierarchy_detail::HierarchySurface<Points>;

  Middles(std::span<const Point3> points, const Surface& surface) : points_(points), surface_(surface) {
    const SizeRange of_identity{1, 1};
    images_are_tame_ = images_are_tame(of_identity, {}, size_range(points));
    stretch_ = {stretch_along(&Point3::x), stretch_along(&Point3::y), stretch_along(&Point3::z)};
  }

  // The mean of the normals about v, if all of its neighbours are less far along it.
  Builder::Middle of(std::uint32_t v) const {
    Vector3<double> sum{0, 0, 0};
    surface_.for_each_around(v, [&](std::uint32_t t, std::uint32_t) {
      const Vector3<double> n = normal_of(t);
      const double scale = 1 / std::sqrt(dot(n, n));
      sum = {sum.x + n.x * scale, sum.y + n.y * scale, sum.z + n.z * scale};
    });
    Builder::Middle middle{of_polyhedron(sum)};
    if (make_tame(middle.direction)) {
      const WorldDirection along_sum(middle.direction);
      const Affine3 identity;
      Along along(along_sum, identity, images_are_tame_);
      bool is_furthest = true;
      surface_.for_each_around(v, [&](std::uint32_t t, std::uint32_t place) {
        const Point3& neighbour = points_[surface_.face(t).corner[after(place)]];
        is_furthest = is_furthest && along.compare(points_[v], neighbour) == Sign::negative;
      });
      if (is_furthest) return middle;
    }
    const std::uint32_t t = surface_.face_at(v);
    const Face& face = surface_.face(t);
    const std::uint32_t place = face.place_of(v);
    const Vector3<double> n = normal_of(t);
    return {of_polyhedron(n), t, {face.corner[after(place)], face.corner[before(place)]}};
  }

 private:
  // A power of two.
  double stretch_along(double Point3::* axis) const {
    const auto [low, high] = std::minmax_element(points_.begin(), points_.end(),
                                                 [&](const Point3& p, const Point3& q) { return p.*axis < q.*axis; });
    const double size = (*high).*axis - (*low).*axis;
    return size > 0 && std::isfinite(size) ? std::ldexp(1.0, std::clamp(-std::ilogb(size), -1022, 1022)) : 1;
  }

  // Of the polyhedron with its axes stretched, so that it is about 1 long along each.
  Vector3<double> normal_of(std::uint32_t t) const {
    const auto& [i, j, k] = surface_.face(t).corner;
    return cross(edge(i, j), edge(i, k));
  }
  Vector3<double> edge(std::uint32_t from, std::uint32_t to) const {
    const Point3 &p = points_[from], &q = points_[to];
    return {(q.x - p.x) * stretch_.x, (q.y - p.y) * stretch_.y, (q.z - p.z) * stretch_.z};
  }
  Point3 of_polyhedron(const Vector3<double>& normal) const {
    return {normal.x * stretch_.x, normal.y * stretch_.y, normal.z * stretch_.z};
  }

  std::span<const Point3> points_;
  const Surface& surface_;
  bool images_are_tame_;
  Point3 stretch_;
};

// Of a polygon: every second vertex goes. The star of a vertex: the edges from the vertex before and to the one after.
Hierarchy flat_history(std::span<const Point3> points, std::span<const std::uint32_t> cycle) {
  struct Corner {
    std::uint32_t vertex, beyond;  // of the edge to the next
  };
  std::vector<Corner> here;
  for (const std::uint32_t v : cycle) here.push_back({v, none});
  std::vector<std::uint32_t> taken, level_end;
  std::vector<Hierarchy::Triangle> edges;
  while (here.size() > 3) {
    level_end.push_back(static_cast<std::uint32_t>(here.size()));
    std::vector<Corner> stay;
    const std::size_t going = std::min(here.size() / 2, here.size() - 3);
    for (std::size_t k = 0; k < here.size(); ++k) {
      if (k % 2 == 0 || k / 2 >= going) {
        stay.push_back(here[k]);
        continue;
      }
      edges.push_back({here[k - 1].vertex, none, here[k - 1].beyond});
      edges.push_back({here[k + 1 < here.size() ? k + 1 : 0].vertex, none, here[k].beyond});
      taken.push_back(here[k].vertex);
      stay.back().beyond = here[k].vertex;
    }
    here = std::move(stay);
  }
  level_end.push_back(3);
  std::reverse(level_end.begin(), level_end.end());
  std::vector<std::uint32_t> last;
  for (const Corner& corner : here) last.push_back(corner.vertex);
  History made(static_cast<std::uint32_t>(points.size()), last, taken, std::move(level_end));
  for (Hierarchy::Node& node : made.hierarchy.nodes) node.at = points[node.vertex];
  for (const std::size_t k : {0u, 1u, 2u}) {  // each vertex of the triangle has both of its edges
    const Corner &previous = here[(k + 2) % 3], &next = here[(k + 1) % 3];
    made.add(here[k].vertex, {previous.vertex, none, previous.beyond});
    made.add(here[k].vertex, {next.vertex, none, here[k].beyond});
  }
  for (std::size_t k = 0; k < edges.size(); ++k) made.add(taken[k / 2], edges[k]);
  return std::move(made.hierarchy);
}

}  // namespace

std::size_t Hierarchy::memory() const {
  return nodes.capacity() * sizeof(Node) + level_end.capacity() * sizeof(level_end[0]);
}

Hierarchy Hierarchy::make(const ConvexPolyhedron& body) {
  const std::span<const Point3> vertices = body.vertices();
  SUNDER_REQUIRE(vertices.size() >= 3);
  if (body.dimension() == 2) return flat_history(vertices, body.facet(0));
  const Points points{vertices};
  Middles::Builder builder(points, static_cast<std::uint32_t>(vertices.size()), body.facet_begin(),
                           body.facet_vertices());
  const Middles middles(vertices, builder.surface());
  return builder.run([&](std::uint32_t v) { return middles.of(v); });
}

}  // namespace sunder::solid
