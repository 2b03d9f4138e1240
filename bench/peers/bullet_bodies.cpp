// Bullet 3.24 in double precision. Booleans only, margins 0, shapes, transforms and first guesses prepared.
//
// A btConvexHullShape holds the points and scans them all for every extreme vertex. It has no better search: the
// polyhedral features (initializePolyhedralFeatures) serve contact clipping and separating axes only.
#include <bench/peers/body_peer.h>

#include <BulletCollision/CollisionShapes/btConvexHullShape.h>
#include <BulletCollision/NarrowPhaseCollision/btGjkEpa2.h>
#include <BulletCollision/NarrowPhaseCollision/btGjkPairDetector.h>
#include <BulletCollision/NarrowPhaseCollision/btVoronoiSimplexSolver.h>

#include <memory>
#include <utility>
#include <vector>

#ifndef BT_USE_DOUBLE_PRECISION
#error "Bullet is to be used in double precision"
#endif

namespace bench {
namespace {

struct Pair {
  const btConvexHullShape* a;
  const btConvexHullShape* b;
  btTransform pose_a, pose_b;
  btVector3 guess;  // between the centres, in the frame of A, where btGjkEpaSolver2 works
};

struct Prepared {
  std::vector<std::unique_ptr<btConvexHullShape>> shapes;
  std::vector<Pair> pairs;
};

btTransform transform(const Placement& p) {
  const auto& m = p.linear;
  return btTransform(btMatrix3x3(m[0], m[1], m[2], m[3], m[4], m[5], m[6], m[7], m[8]),
                     btVector3(p.translation[0], p.translation[1], p.translation[2]));
}

Prepared prepared(const Scenario& scenario) {
  Prepared made;
  for (const Body& body : scenario.pool) {
    auto shape = std::make_unique<btConvexHullShape>(body.points.front().data(), static_cast<int>(body.points.size()),
                                                     sizeof(Vec));
    shape->setMargin(0);
    made.shapes.push_back(std::move(shape));
  }
  for (const Query& query : scenario.queries) {
    Pair q{
        made.shapes[query.a].get(), made.shapes[query.b].get(), transform(query.pose_a), transform(query.pose_b), {}};
    q.guess = q.pose_a.getBasis().transpose() * (q.pose_a.getOrigin() - q.pose_b.getOrigin());
    made.pairs.push_back(q);
  }
  return made;
}

Run by_distance(const Scenario& scenario) {
  return each([given = prepared(scenario), results = btGjkEpaSolver2::sResults()](std::size_t k) mutable {
    const Pair& q = given.pairs[k];
    return !btGjkEpaSolver2::Distance(q.a, q.pose_a, q.b, q.pose_b, q.guess, results);
  });
}

Run by_penetration(const Scenario& scenario) {
  return each([given = prepared(scenario), results = btGjkEpaSolver2::sResults()](std::size_t k) mutable {
    const Pair& q = given.pairs[k];
    btGjkEpaSolver2::Penetration(q.a, q.pose_a, q.b, q.pose_b, -q.guess, results, false);
    return results.status != btGjkEpaSolver2::sResults::Separated;
  });
}

struct Contact : btDiscreteCollisionDetectorInterface::Result {
  bool called = false;
  void setShapeIdentifiersA(int, int) override {}
  void setShapeIdentifiersB(int, int) override {}
  void addContactPoint(const btVector3&, const btVector3&, btScalar) override { called = true; }
};

Run by_detector(const Scenario& scenario) {
  return each([given = prepared(scenario), contact = Contact(), simplex = btVoronoiSimplexSolver(),
               input = btDiscreteCollisionDetectorInterface::ClosestPointInput()](std::size_t k) mutable {
    const Pair& q = given.pairs[k];
    input.m_transformA = q.pose_a;
    input.m_transformB = q.pose_b;
    btGjkPairDetector detector(q.a, q.b, CONVEX_HULL_SHAPE_PROXYTYPE, CONVEX_HULL_SHAPE_PROXYTYPE, 0, 0, &simplex,
                               nullptr);
    contact.called = false;
    detector.getClosestPoints(input, contact, nullptr);
    return !contact.called;  // without a solver for depths, points are reported where apart only
  });
}

}  // namespace

std::vector<BodyWay> bullet_body_ways() {
  return {{"bullet", "Distance", by_distance},
          {"bullet", "Penetration", by_penetration},
          {"bullet", "detector", by_detector}};
}

}  // namespace bench
