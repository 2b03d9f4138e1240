#include <sunder/base/contract.h>
#include <sunder/predicate/point/orient.h>
#include <sunder/solid/object/convex_polyhedron.h>
#include <sunder/solid/object/search_graph.h>
#include <sunder/solid/represent/bounded_builder.h>
#include <sunder/solid/represent/bounded_hierarchy.h>

#include <algorithm>
#include <array>
#include <utility>

namespace sunder::solid {

namespace {

using hierarchy_detail::none;

// The vertices of a polyhedron.
struct Corners {
  std::span<const Point3> points;

  std::uint32_t size() const { return static_cast<std::uint32_t>(points.size()); }
  const Point3& rounded(std::uint32_t v) const { return points[v]; }
  const Point3& at(std::uint32_t v) const { return points[v]; }
  ExactPoint3 exact(std::uint32_t v) const { return exactly(points[v]); }
  EstimatedPoint3 estimated(std::uint32_t v) const { return sunder::estimated(points[v]); }
  Sign orient(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) const {
    return orient_3d(points[a], points[b], points[c], points[d]);
  }
  std::array<Point3, 2> at(const ExactPoint3& p, const EstimatedPoint3& estimate) const {
    return hierarchy_detail::rounded_and_rest(p, estimate);
  }
};

BoundedHierarchy flat_bounded_hierarchy(const ConvexPolyhedron& body) {
  struct Taken {
    std::uint32_t vertex;
    std::array<std::uint32_t, 2> beside;
  };
  const auto cycle = body.facet(0);
  std::vector<std::uint32_t> here(cycle.begin(), cycle.end());
  std::vector<Taken> taken;
  BoundedHierarchy made;
  const auto size_of = [](const auto& some) { return static_cast<std::uint32_t>(some.size()); };
  const std::uint32_t size = size_of(here);
  made.levels.push_back({size, size, 2});
  while (here.size() > 3) {
    const std::size_t going = std::min(here.size() / 2, here.size() - 3);
    std::vector<std::uint32_t> stay;
    for (std::size_t k = 0; k < here.size(); ++k) {
      if (k % 2 == 0 || k / 2 >= going) {
        stay.push_back(here[k]);
      } else {
        taken.push_back({here[k], {here[k - 1], here[k + 1 < here.size() ? k + 1 : 0]}});
      }
    }
    here = std::move(stay);
    made.levels.push_back({size_of(here), size_of(here), 2});
  }
  std::reverse(made.levels.begin(), made.levels.end());
  std::vector<std::uint32_t> rank(body.vertices().size());
  std::vector<std::vector<std::uint32_t>> comers(size);
  for (std::uint32_t k = 0; k < 3; ++k) rank[here[k]] = k;
  for (std::size_t k = taken.size(); k-- > 0;) {
    const std::uint32_t w = size_of(here);
    here.push_back(taken[k].vertex);
    rank[taken[k].vertex] = w;
    for (const std::uint32_t v : taken[k].beside) comers[rank[v]].push_back(w);
  }
  for (std::uint32_t k = 0; k < size; ++k) {
    const std::uint32_t begin = size_of(made.comers);
    made.comers.insert(made.comers.end(), comers[k].begin(), comers[k].end());
    const std::uint32_t rim_begin = size_of(made.rims);
    if (k >= 3) {
      for (const std::uint32_t v : taken[size - 1 - k].beside) made.rims.push_back(rank[v]);
    }
    made.nodes.push_back(
        {body.vertices()[here[k]], here[k], none, begin, size_of(made.comers), rim_begin, size_of(made.rims)});
  }
  made.error = 0;
  return made;
}

}  // namespace

BoundedHierarchy BoundedHierarchy::make(const ConvexPolyhedron& body, const Limits& limits,
                                        std::vector<Surface>* surfaces) {
  SUNDER_REQUIRE(body.vertices().size() >= 3);
  if (body.dimension() == 2) return flat_bounded_hierarchy(body);
  BoundedHierarchy made = hierarchy_detail::BoundedBuilder(Corners{body.vertices()}, body.facet_begin(),
                                                           body.facet_vertices(), limits, surfaces)
                              .run();
  made.error = body.search_graph().sizes.greatest * 0x1p-52;
  return made;
}

ExactPoint3 BoundedHierarchy::exact(std::uint32_t rank) const {
  const Node& node = nodes[rank];
  if (node.copy == none) return exactly(node.at);
  const Copy& copy = copies[node.copy];
  return hierarchy_detail::cut_point(cuts[copy.cut], exact(copy.parent), exact(copy.toward));
}

std::size_t BoundedHierarchy::memory() const {
  return nodes.capacity() * sizeof(Node) + rims.capacity() * sizeof(rims[0]) + comers.capacity() * sizeof(comers[0]) +
         copies.capacity() * sizeof(Copy) + cuts.capacity() * sizeof(Cut) + levels.capacity() * sizeof(Level);
}

}  // namespace sunder::solid
