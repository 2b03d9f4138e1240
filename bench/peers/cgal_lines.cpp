// CGAL: its AABB tree, and its slicer.
#include <bench/peers/line_peer.h>

#include <CGAL/AABB_halfedge_graph_segment_primitive.h>
#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/AABB_triangle_primitive.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_slicer.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <boost/variant.hpp>

#include <algorithm>
#include <iterator>
#include <memory>
#include <variant>
#include <vector>

namespace bench {
namespace {

using Plain = CGAL::Simple_cartesian<double>;
using Deciding = CGAL::Exact_predicates_inexact_constructions_kernel;

constexpr double kOutside = 4;  // from the foot of a line on

// CGAL 6 has std::variant.
template <class Wanted, class... Some>
const Wanted* held(const boost::variant<Some...>& value) {
  return boost::get<Wanted>(&value);
}
template <class Wanted, class... Some>
const Wanted* held(const std::variant<Some...>& value) {
  return std::get_if<Wanted>(&value);
}

struct Ends {
  double first = HUGE_VAL, last = -HUGE_VAL;
  void add(double at) {
    first = std::min(first, at);
    last = std::max(last, at);
  }
};

template <class Kernel>
typename Kernel::Point_3 point_of(const sunder::Point3& p) {
  return {p.x, p.y, p.z};
}

// The intersection with a triangle, a point or a segment of it.
template <class Kernel, class Found>
void add(const Found& found, const LineQuery& query, Ends& ends) {
  const auto add_point = [&](const typename Kernel::Point_3& p) { ends.add(query.along(p.x(), p.y(), p.z())); };
  if (const auto* point = held<typename Kernel::Point_3>(found)) add_point(*point);
  if (const auto* segment = held<typename Kernel::Segment_3>(found)) {
    add_point(segment->source());
    add_point(segment->target());
  }
}

template <class Kernel>
struct Triangles {
  using Items = std::vector<typename Kernel::Triangle_3>;
  using Primitive = CGAL::AABB_triangle_primitive<Kernel, typename Items::const_iterator>;
  using Tree = CGAL::AABB_tree<CGAL::AABB_traits<Kernel, Primitive>>;

  explicit Triangles(const SphereBody& body) {
    const auto vertices = body.hull.vertices();
    const auto at = [&](std::uint32_t v) { return point_of<Kernel>(vertices[v]); };
    for (const auto& [i, j, k] : body.triangles) items.emplace_back(at(i), at(j), at(k));
    tree.insert(items.cbegin(), items.cend());
    tree.build();
  }

  Items items;
  Tree tree;
};

template <class Kernel>
Run by_all_intersections(const LineScenario& scenario) {
  using Line = typename Kernel::Line_3;
  using Found = typename Triangles<Kernel>::Tree::template Intersection_and_primitive_id<Line>::Type;
  std::vector<Line> lines;
  for (const LineQuery& q : scenario.queries) {
    lines.emplace_back(point_of<Kernel>(q.line.a), point_of<Kernel>(q.line.b));
  }
  return each([&queries = scenario.queries, lines = std::move(lines), found = std::vector<Found>(),
               triangles = std::make_shared<const Triangles<Kernel>>(*scenario.body)](std::size_t k) mutable {
    found.clear();
    triangles->tree.all_intersections(lines[k], std::back_inserter(found));
    Ends ends;
    for (const Found& f : found) add<Kernel>(f.first, queries[k], ends);
    return queries[k].answer(ends.first, ends.last);
  });
}

template <class Kernel>
Run by_two_rays(const LineScenario& scenario) {
  using Ray = typename Kernel::Ray_3;
  std::vector<Ray> rays;
  for (const LineQuery& q : scenario.queries) {
    const typename Kernel::Vector_3 way(q.way.x, q.way.y, q.way.z);
    const auto foot = point_of<Kernel>(q.foot);
    rays.emplace_back(foot - kOutside * way, way);
    rays.emplace_back(foot + kOutside * way, -way);
  }
  return each([&queries = scenario.queries, rays = std::move(rays),
               triangles = std::make_shared<const Triangles<Kernel>>(*scenario.body)](std::size_t k) {
    Ends in, out;
    if (const auto found = triangles->tree.first_intersection(rays[2 * k])) add<Kernel>(found->first, queries[k], in);
    if (const auto found = triangles->tree.first_intersection(rays[2 * k + 1])) {
      add<Kernel>(found->first, queries[k], out);
    }
    return queries[k].answer(in.first, out.last);
  });
}

template <class Kernel>
struct Slicing {
  using Mesh = CGAL::Surface_mesh<typename Kernel::Point_3>;
  using Primitive = CGAL::AABB_halfedge_graph_segment_primitive<Mesh>;
  using Tree = CGAL::AABB_tree<CGAL::AABB_traits<Kernel, Primitive>>;
  using Slicer = CGAL::Polygon_mesh_slicer<Mesh, Kernel>;

  explicit Slicing(const SphereBody& body) {
    std::vector<typename Mesh::Vertex_index> at;
    for (const sunder::Point3& p : body.hull.vertices()) at.push_back(mesh.add_vertex(point_of<Kernel>(p)));
    for (const auto& [i, j, k] : body.triangles) mesh.add_face(at[i], at[j], at[k]);
    tree.insert(edges(mesh).first, edges(mesh).second, mesh);
    tree.build();
    slicer = std::make_unique<const Slicer>(mesh, tree);
  }

  Mesh mesh;
  Tree tree;
  std::unique_ptr<const Slicer> slicer;
};

template <class Kernel>
Run by_slicer(const SectionScenario& scenario) {
  std::vector<typename Kernel::Plane_3> planes;
  for (const SectionQuery& q : scenario.queries) {
    const sunder::Point3& n = q.plane.normal;
    planes.emplace_back(n.x, n.y, n.z, -q.plane.offset);
  }
  return each([planes = std::move(planes),
               slicing = std::make_shared<const Slicing<Kernel>>(*scenario.body)](std::size_t k) -> std::uint64_t {
    std::vector<std::vector<typename Kernel::Point_3>> lines;
    (*slicing->slicer)(planes[k], std::back_inserter(lines));
    std::uint64_t corners = 0;  // of a closed line the last one is the first
    for (const auto& line : lines) corners += line.size() - (line.size() > 1 && line.front() == line.back() ? 1 : 0);
    return corners;
  });
}

}  // namespace

std::vector<LineWay> cgal_line_ways() {
  return {{"cgal", "all, doubles", by_all_intersections<Plain>},
          {"cgal", "all, exact signs", by_all_intersections<Deciding>},
          {"cgal", "two rays, doubles", by_two_rays<Plain>},
          {"cgal", "two rays, exact signs", by_two_rays<Deciding>}};
}

std::vector<SectionWay> cgal_section_ways() {
  return {{"cgal", "slicer, doubles", by_slicer<Plain>}, {"cgal", "slicer, exact signs", by_slicer<Deciding>}};
}

}  // namespace bench
