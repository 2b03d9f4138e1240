// FCL 0.7 with libccd's GJK. Booleans only, shapes and transforms prepared.
#include <bench/peers/body_peer.h>

#include <fcl/geometry/shape/convex.h>
#include <fcl/narrowphase/collision.h>
#include <fcl/narrowphase/detail/gjk_solver_libccd.h>

#include <memory>
#include <utility>
#include <vector>

namespace bench {
namespace {

using Shape = fcl::Convex<double>;
using Transform = fcl::Transform3<double>;

struct Pair {
  const Shape* a;
  const Shape* b;
  Transform pose_a, pose_b;
};

struct Prepared {
  std::vector<std::unique_ptr<Shape>> shapes;
  std::vector<Pair> pairs;
};

Transform transform(const Placement& placement) {
  Transform t = Transform::Identity();
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) t.linear()(i, j) = placement.linear[3 * i + j];
    t.translation()(i) = placement.translation[i];
  }
  return t;
}

Prepared prepared(const Scenario& scenario) {
  Prepared made;
  for (const Body& body : scenario.pool) {
    auto vertices = std::make_shared<std::vector<fcl::Vector3<double>>>();
    for (const Vec& p : body.points) vertices->emplace_back(p[0], p[1], p[2]);
    auto faces = std::make_shared<std::vector<int>>();
    int count = 0;
    const bool is_large = body.points.size() > 20000;
    for (const auto& t : is_large ? triangles_by_sunder(body.points) : triangles_by_qhull(body.points)) {
      faces->insert(faces->end(), {3, static_cast<int>(t[0]), static_cast<int>(t[1]), static_cast<int>(t[2])});
      ++count;
    }
    // A mesh that is not watertight would silently fall back to a linear search: make it an error instead.
    auto shape = std::make_unique<Shape>(vertices, count, faces, true);
    shape->computeLocalAABB();
    made.shapes.push_back(std::move(shape));
  }
  for (const Query& query : scenario.queries) {
    made.pairs.push_back(
        {made.shapes[query.a].get(), made.shapes[query.b].get(), transform(query.pose_a), transform(query.pose_b)});
  }
  return made;
}

Run by_collide(const Scenario& scenario) {
  fcl::CollisionRequest<double> request;  // one contact at most, none computed, libccd, tolerance 1e-6
  request.gjk_solver_type = fcl::GST_LIBCCD;
  request.enable_contact = false;
  return each([given = prepared(scenario), request, result = fcl::CollisionResult<double>()](std::size_t k) mutable {
    const Pair& q = given.pairs[k];
    result.clear();
    return fcl::collide(q.a, q.pose_a, q.b, q.pose_b, request, result) != 0;
  });
}

Run by_solver(const Scenario& scenario) {
  return each([given = prepared(scenario), solver = fcl::detail::GJKSolver_libccd<double>()](std::size_t k) {
    const Pair& q = given.pairs[k];
    return solver.shapeIntersect(*q.a, q.pose_a, *q.b, q.pose_b, nullptr);
  });
}

}  // namespace

std::vector<BodyWay> fcl_body_ways() { return {{"fcl", "collide", by_collide}, {"fcl", "solver", by_solver}}; }

}  // namespace bench
