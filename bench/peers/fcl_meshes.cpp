// FCL 0.7: trees of oriented boxes and rectangle swept spheres (OBBRSS), and of oriented boxes alone. Booleans only,
// trees and transforms prepared.
#include <bench/peers/mesh_peer.h>

#include <fcl/geometry/bvh/BVH_model.h>
#include <fcl/narrowphase/collision.h>

#include <memory>
#include <utility>
#include <vector>

namespace bench {
namespace {

using Transform = fcl::Transform3<double>;

template <class Box>
std::shared_ptr<fcl::BVHModel<Box>> model_of(const sunder::solid::Mesh& mesh) {
  std::vector<fcl::Vector3<double>> points;
  std::vector<fcl::Triangle> triangles;
  for (const sunder::Point3& p : mesh.points()) points.emplace_back(p.x, p.y, p.z);
  for (const auto& t : mesh.triangles()) triangles.emplace_back(t[0], t[1], t[2]);
  auto model = std::make_shared<fcl::BVHModel<Box>>();
  model->beginModel();
  model->addSubModel(points, triangles);
  model->endModel();
  return model;
}

Transform transform(const sunder::solid::Pose& pose) {
  Transform t = Transform::Identity();
  const auto& [linear, translation] = pose.affine();
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) t.linear()(i, j) = linear[static_cast<std::size_t>(3 * i + j)];
    t.translation()(i) = translation[static_cast<std::size_t>(i)];
  }
  return t;
}

template <class Box>
Run by_trees(const MeshScenario& scenario) {
  struct Pair {
    const fcl::BVHModel<Box>*a, *b;
    Transform pose_a, pose_b;
  };
  std::vector<std::shared_ptr<fcl::BVHModel<Box>>> models;
  for (const auto& mesh : scenario.pool) models.push_back(model_of<Box>(mesh));
  std::vector<Pair> pairs;
  for (const auto& q : scenario.queries) {
    pairs.push_back({models[q.a].get(), models[q.b].get(), transform(q.pose_a), transform(q.pose_b)});
  }
  fcl::CollisionRequest<double> request;  // one contact at most, none computed
  request.enable_contact = false;
  return each([models, pairs, request, result = fcl::CollisionResult<double>()](std::size_t k) mutable {
    const Pair& q = pairs[k];
    result.clear();
    return fcl::collide(q.a, q.pose_a, q.b, q.pose_b, request, result) != 0;
  });
}

}  // namespace

std::vector<MeshWay> fcl_mesh_ways() {
  return {{"fcl", "OBBRSS", by_trees<fcl::OBBRSS<double>>}, {"fcl", "OBB", by_trees<fcl::OBB<double>>}};
}

}  // namespace bench
