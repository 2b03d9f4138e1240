// FCL 0.7: its own primitives. Booleans only, shapes and transforms prepared. Where FCL has a test of its own for a
// pair (ball and ball, ball and capsule, ball and box, ball and cylinder, box and box) its solver takes that; else
// libccd.
#include <bench/peers/round_peer.h>

#include <fcl/geometry/shape/box.h>
#include <fcl/geometry/shape/capsule.h>
#include <fcl/geometry/shape/cone.h>
#include <fcl/geometry/shape/cylinder.h>
#include <fcl/geometry/shape/ellipsoid.h>
#include <fcl/geometry/shape/sphere.h>
#include <fcl/narrowphase/collision.h>

#include <memory>
#include <vector>

namespace bench {
namespace {

using Geometry = fcl::CollisionGeometry<double>;
using Transform = fcl::Transform3<double>;

std::shared_ptr<Geometry> geometry(const RoundPrimitive& p) {
  const auto& [x, y, z] = p.half;
  std::shared_ptr<Geometry> made;
  switch (p.kind) {
    case RoundShapeKind::ball: made = std::make_shared<fcl::Sphere<double>>(x); break;
    case RoundShapeKind::capsule: made = std::make_shared<fcl::Capsule<double>>(x, 2 * y); break;
    case RoundShapeKind::box: made = std::make_shared<fcl::Box<double>>(2 * x, 2 * y, 2 * z); break;
    case RoundShapeKind::cylinder: made = std::make_shared<fcl::Cylinder<double>>(x, 2 * y); break;
    case RoundShapeKind::cone: made = std::make_shared<fcl::Cone<double>>(x, 2 * y); break;
    case RoundShapeKind::ellipsoid: made = std::make_shared<fcl::Ellipsoid<double>>(x, y, z); break;
  }
  made->computeLocalAABB();
  return made;
}

Transform transform(const RoundPrimitive& p) {
  Transform t = Transform::Identity();
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) t.linear()(i, j) = p.linear[static_cast<std::size_t>(3 * i + j)];
    t.translation()(i) = p.translation[static_cast<std::size_t>(i)];
  }
  return t;
}

struct Pair {
  std::shared_ptr<Geometry> a, b;
  Transform pose_a, pose_b;
};

template <fcl::GJKSolverType solver>
Run by_collide(const std::vector<RoundQuestion>& questions) {
  std::vector<Pair> pairs;
  for (const RoundQuestion& q : questions) {
    pairs.push_back({geometry(q.a), geometry(q.b), transform(q.a), transform(q.b)});
  }
  fcl::CollisionRequest<double> request;  // one contact at most, none computed
  request.gjk_solver_type = solver;
  request.enable_contact = false;
  return each([pairs, request, result = fcl::CollisionResult<double>()](std::size_t k) mutable {
    const Pair& q = pairs[k];
    result.clear();
    return fcl::collide(q.a.get(), q.pose_a, q.b.get(), q.pose_b, request, result) != 0;
  });
}

}  // namespace

std::vector<RoundWay> fcl_round_ways() {
  return {{"fcl", "collide, libccd", by_collide<fcl::GST_LIBCCD>},
          {"fcl", "collide, its own GJK", by_collide<fcl::GST_INDEP>}};
}

}  // namespace bench
