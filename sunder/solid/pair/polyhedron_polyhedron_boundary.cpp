#include <sunder/predicate/coordinates.h>
#include <sunder/solid/pair/polyhedron_polyhedron.h>
#include <sunder/solid/pair/polyhedron_polyhedron_boundary.h>
#include <sunder/solid/search/extreme_vertex.h>

#include <cstdint>

namespace sunder::solid {

namespace {

WorldDirection normal_of(const Placed& body, std::uint32_t f) {
  const auto facet = body.body.facet(f);
  return cross_direction(body[facet[0]], body[facet[1]], body[facet[0]], body[facet[2]]);
}

// On which side of its facets' normals, as the images turn, is the body? Positive where its pose mirrors it.
Sign side_of(const Placed& body) {
  const WorldDirection normal = normal_of(body, 0);
  const Posed3 on_facet = body[body.body.facet(0)[0]];
  Sign side = Sign::zero;
  for (std::uint32_t v = 0; side == Sign::zero; ++v) side = compare_along(normal, on_facet, body[v]);
  return side;
}

// Is each vertex of p strictly on the inner side of every facet of q?
bool is_inside(const Placed& p, const Placed& q, Cost& cost, StageTally& tally) {
  if (q.body.dimension() != 3) return false;
  const Sign inner = side_of(q);
  const End outer = inner == Sign::negative ? End::greatest : End::least;
  std::uint32_t v = 0;
  for (std::uint32_t f = 0; f < q.body.facet_count(); ++f) {
    const WorldDirection normal = normal_of(q, f);
    ++tally.exact;
    ++cost.probes;
    Along along(normal, p.pose, p.tame);
    v = extreme_vertex_from(p, along, outer, v, cost, tally);
    if (compare_along(normal, q[q.body.facet(f)[0]], p[v], &tally) != inner) return false;
  }
  return true;
}

}  // namespace

RelationAnswer polyhedron_polyhedron_boundary(const ConvexPolyhedron& body_a, const Pose& pose_a,  //
                                              const ConvexPolyhedron& body_b, const Pose& pose_b) {
  const PairAnswer answer = polyhedron_polyhedron(body_a, pose_a, body_b, pose_b);
  Cost cost = answer.cost;
  if (!answer.meet()) return {Relation::none, cost};
  const Placed a(body_a, pose_a), b(body_b, pose_b);
  StageTally tally;
  const bool a_inside = is_inside(a, b, cost, tally);
  const bool b_inside = !a_inside && is_inside(b, a, cost, tally);
  cost.exact += tally.exact;
  return {relation_of_boundaries(true, a_inside, b_inside), cost};
}

RelationAnswer polyhedron_polyhedron_boundary_by_scan(const ConvexPolyhedron& body_a, const Pose& pose_a,  //
                                                      const ConvexPolyhedron& body_b, const Pose& pose_b) {
  Cost cost;
  const auto inside = [&](const ConvexPolyhedron& p, const Pose& pose_p, const ConvexPolyhedron& q,
                          const Pose& pose_q) {
    if (q.dimension() != 3) return false;
    const auto image = [](const ConvexPolyhedron& body, const Pose& pose, std::uint32_t v) {
      return coordinates<Dyadic>(Posed3{body.vertices()[v], &pose.affine(), false});
    };
    for (std::uint32_t f = 0; f < q.facet_count(); ++f) {
      const auto u = image(q, pose_q, q.facet(f)[0]);
      const auto normal = cross(image(q, pose_q, q.facet(f)[1]) - u, image(q, pose_q, q.facet(f)[2]) - u);
      Sign inner = Sign::zero;
      for (std::uint32_t v = 0; inner == Sign::zero; ++v) inner = dot(normal, image(q, pose_q, v) - u).sign();
      for (std::uint32_t v = 0; v < p.vertices().size(); ++v) {
        ++cost.probes;
        if (dot(normal, image(p, pose_p, v) - u).sign() != inner) return false;
      }
    }
    return true;
  };
  const bool meet = polyhedron_polyhedron_by_scan(body_a, pose_a, body_b, pose_b).meet();
  const bool a_inside = inside(body_a, pose_a, body_b, pose_b), b_inside = inside(body_b, pose_b, body_a, pose_a);
  return {relation_of_boundaries(meet, a_inside, b_inside), cost};
}

}  // namespace sunder::solid
