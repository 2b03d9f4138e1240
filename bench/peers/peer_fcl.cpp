// FCL 0.7 with libccd's GJK. Booleans only, shapes and transforms prepared.
#include <fcl/geometry/shape/convex.h>
#include <fcl/narrowphase/collision.h>
#include <fcl/narrowphase/detail/gjk_solver_libccd.h>

#include <utility>
#include <vector>

#include "peer.h"

namespace bench {
namespace {

using Shape = fcl::Convex<double>;
using Transform = fcl::Transform3<double>;

struct Prepared {
  const Shape* a;
  const Shape* b;
  Transform pose_a, pose_b;
};

class FclPeer : public Peer {
 public:
  explicit FclPeer(const Scenario& scenario) {
    for (const Body& body : scenario.pool) {
      auto vertices = std::make_shared<std::vector<fcl::Vector3<double>>>();
      for (const Vec& p : body.points) vertices->emplace_back(p[0], p[1], p[2]);
      auto faces = std::make_shared<std::vector<int>>();
      int count = 0;
      for (const auto& t : triangles_by_qhull(body.points)) {
        faces->insert(faces->end(), {3, static_cast<int>(t[0]), static_cast<int>(t[1]), static_cast<int>(t[2])});
        ++count;
      }
      // A mesh that is not watertight would silently fall back to a linear search: make it an error instead.
      auto shape = std::make_unique<Shape>(vertices, count, faces, true);
      shape->computeLocalAABB();
      shapes_.push_back(std::move(shape));
    }
    for (const Query& query : scenario.queries) {
      queries_.push_back(
          {shapes_[query.a].get(), shapes_[query.b].get(), transform(query.pose_a), transform(query.pose_b)});
    }
  }

  std::string_view library() const override { return "fcl"; }

 protected:
  std::vector<Prepared> queries_;

 private:
  static Transform transform(const Placement& placement) {
    Transform t = Transform::Identity();
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < 3; ++j) t.linear()(i, j) = placement.linear[3 * i + j];
      t.translation()(i) = placement.translation[i];
    }
    return t;
  }

  std::vector<std::unique_ptr<Shape>> shapes_;
};

class FclCollide : public FclPeer {
 public:
  using FclPeer::FclPeer;
  std::string_view method() const override { return "collide"; }

  void run(std::span<std::uint8_t> meets) override {
    fcl::CollisionRequest<double> request;  // one contact at most, none computed, libccd, tolerance 1e-6
    request.gjk_solver_type = fcl::GST_LIBCCD;
    request.enable_contact = false;
    fcl::CollisionResult<double> result;
    for (std::size_t i = 0; i < queries_.size(); ++i) {
      const Prepared& q = queries_[i];
      result.clear();
      meets[i] = fcl::collide(q.a, q.pose_a, q.b, q.pose_b, request, result) != 0;
    }
  }
};

class FclSolver : public FclPeer {
 public:
  using FclPeer::FclPeer;
  std::string_view method() const override { return "solver"; }

  void run(std::span<std::uint8_t> meets) override {
    const fcl::detail::GJKSolver_libccd<double> solver;
    for (std::size_t i = 0; i < queries_.size(); ++i) {
      const Prepared& q = queries_[i];
      meets[i] = solver.shapeIntersect(*q.a, q.pose_a, *q.b, q.pose_b, nullptr);
    }
  }
};

}  // namespace

std::unique_ptr<Peer> make_fcl_collide(const Scenario& scenario) { return std::make_unique<FclCollide>(scenario); }
std::unique_ptr<Peer> make_fcl_solver(const Scenario& scenario) { return std::make_unique<FclSolver>(scenario); }

}  // namespace bench
