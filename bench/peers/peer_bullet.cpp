// Bullet 3.24 in double precision. Booleans only, margins 0, shapes, transforms and first guesses prepared.
//
// A btConvexHullShape holds the points and scans them all for every extreme vertex. It has no better search: the
// polyhedral features (initializePolyhedralFeatures) serve contact clipping and separating axes only.
#include <BulletCollision/CollisionShapes/btConvexHullShape.h>
#include <BulletCollision/NarrowPhaseCollision/btGjkEpa2.h>
#include <BulletCollision/NarrowPhaseCollision/btGjkPairDetector.h>
#include <BulletCollision/NarrowPhaseCollision/btVoronoiSimplexSolver.h>

#include <vector>

#include "peer.h"

#ifndef BT_USE_DOUBLE_PRECISION
#error "Bullet is to be used in double precision"
#endif

namespace bench {
namespace {

struct Prepared {
  const btConvexHullShape* a;
  const btConvexHullShape* b;
  btTransform pose_a, pose_b;
  btVector3 guess;  // between the centres, in the frame of A, where btGjkEpaSolver2 works
};

class BulletPeer : public Peer {
 public:
  explicit BulletPeer(const Scenario& scenario) {
    for (const Body& body : scenario.pool) {
      auto shape = std::make_unique<btConvexHullShape>(body.points.front().data(), static_cast<int>(body.points.size()),
                                                       sizeof(Vec));
      shape->setMargin(0);
      shapes_.push_back(std::move(shape));
    }
    for (const Query& query : scenario.queries) {
      Prepared q{shapes_[query.a].get(), shapes_[query.b].get(), transform(query.pose_a), transform(query.pose_b), {}};
      q.guess = q.pose_a.getBasis().transpose() * (q.pose_a.getOrigin() - q.pose_b.getOrigin());
      queries_.push_back(q);
    }
  }

  std::string_view library() const override { return "bullet"; }

 protected:
  std::vector<Prepared> queries_;

 private:
  static btTransform transform(const Placement& p) {
    const auto& m = p.linear;
    return btTransform(btMatrix3x3(m[0], m[1], m[2], m[3], m[4], m[5], m[6], m[7], m[8]),
                       btVector3(p.translation[0], p.translation[1], p.translation[2]));
  }

  std::vector<std::unique_ptr<btConvexHullShape>> shapes_;
};

class BulletDistance : public BulletPeer {
 public:
  using BulletPeer::BulletPeer;
  std::string_view method() const override { return "Distance"; }

  void run(std::span<std::uint8_t> meets) override {
    btGjkEpaSolver2::sResults results;
    for (std::size_t i = 0; i < queries_.size(); ++i) {
      const Prepared& q = queries_[i];
      meets[i] = !btGjkEpaSolver2::Distance(q.a, q.pose_a, q.b, q.pose_b, q.guess, results);
    }
  }
};

class BulletPenetration : public BulletPeer {
 public:
  using BulletPeer::BulletPeer;
  std::string_view method() const override { return "Penetration"; }

  void run(std::span<std::uint8_t> meets) override {
    btGjkEpaSolver2::sResults results;
    for (std::size_t i = 0; i < queries_.size(); ++i) {
      const Prepared& q = queries_[i];
      btGjkEpaSolver2::Penetration(q.a, q.pose_a, q.b, q.pose_b, -q.guess, results, false);
      meets[i] = results.status != btGjkEpaSolver2::sResults::Separated;
    }
  }
};

class BulletDetector : public BulletPeer {
 public:
  using BulletPeer::BulletPeer;
  std::string_view method() const override { return "detector"; }

  void run(std::span<std::uint8_t> meets) override {
    struct Result : btDiscreteCollisionDetectorInterface::Result {
      bool called = false;
      void setShapeIdentifiersA(int, int) override {}
      void setShapeIdentifiersB(int, int) override {}
      void addContactPoint(const btVector3&, const btVector3&, btScalar) override { called = true; }
    } result;
    btVoronoiSimplexSolver simplex;
    btDiscreteCollisionDetectorInterface::ClosestPointInput input;
    for (std::size_t i = 0; i < queries_.size(); ++i) {
      const Prepared& q = queries_[i];
      input.m_transformA = q.pose_a;
      input.m_transformB = q.pose_b;
      btGjkPairDetector detector(q.a, q.b, CONVEX_HULL_SHAPE_PROXYTYPE, CONVEX_HULL_SHAPE_PROXYTYPE, 0, 0, &simplex,
                                 nullptr);
      result.called = false;
      detector.getClosestPoints(input, result, nullptr);
      meets[i] = !result.called;  // without a solver for depths, points are reported where apart only
    }
  }
};

}  // namespace

std::unique_ptr<Peer> make_bullet_distance(const Scenario& s) { return std::make_unique<BulletDistance>(s); }
std::unique_ptr<Peer> make_bullet_penetration(const Scenario& s) { return std::make_unique<BulletPenetration>(s); }
std::unique_ptr<Peer> make_bullet_detector(const Scenario& s) { return std::make_unique<BulletDetector>(s); }

}  // namespace bench
