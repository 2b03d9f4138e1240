// FCL 0.7: trees of oriented boxes and rectangle swept spheres (OBBRSS), and of oriented boxes alone. Booleans, and distances;
// trees and transforms prepared.
#include <bench/peers/mesh_peer.h>

#include <fcl/geometry/bvh/BVH_model.h>
#include <fcl/narrowphase/collision.h>
#include <fcl/narrowphase/distance.h>

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
struct Prepared {
  struct Pair {
    const fcl::BVHModel<Box>*a, *b;
    Transform pose_a, pose_b;
  };
  std::vector<std::shared_ptr<fcl::BVHModel<Box>>> models;
  std::vector<Pair> pairs;

  explicit Prepared(const MeshScenario& scenario) {
    for (const auto& mesh : scenario.pool) models.push_back(model_of<Box>(mesh));
    for (const auto& q : scenario.queries) {
      pairs.push_back({models[q.a].get(), models[q.b].get(), transform(q.pose_a), transform(q.pose_b)});
    }
  }
};

template <class Box>
Run by_trees(const MeshScenario& scenario) {
  fcl::CollisionRequest<double> request;  // one contact at most, none computed
  request.enable_contact = false;
  return each(
      [made = Prepared<Box>(scenario), request, result = fcl::CollisionResult<double>()](std::size_t k) mutable {
        const auto& q = made.pairs[k];
        result.clear();
        return fcl::collide(q.a, q.pose_a, q.b, q.pose_b, request, result) != 0;
      });
}

Run distances(const MeshScenario& scenario) {
  return each([made = Prepared<fcl::OBBRSS<double>>(scenario), request = fcl::DistanceRequest<double>(),
               result = fcl::DistanceResult<double>()](std::size_t k) mutable {
    const auto& q = made.pairs[k];
    result.clear();
    return fcl::distance(q.a, q.pose_a, q.b, q.pose_b, request, result) <= 0;
  });
}

}  // namespace

Run fcl_make_meshes(const std::vector<MeshSoup>& soups) {
  struct Input {
    std::vector<fcl::Vector3<double>> points;
    std::vector<fcl::Triangle> triangles;
  };
  std::vector<Input> inputs;
  for (const MeshSoup& soup : soups) {
    Input& input = inputs.emplace_back();
    for (const sunder::Point3& p : soup.points) input.points.emplace_back(p.x, p.y, p.z);
    for (std::size_t k = 0; k < soup.corners.size(); k += 3) {
      input.triangles.emplace_back(soup.corners[k], soup.corners[k + 1], soup.corners[k + 2]);
    }
  }
  return each([inputs = std::move(inputs)](std::size_t k) {
    fcl::BVHModel<fcl::OBBRSS<double>> model;
    model.beginModel();
    model.addSubModel(inputs[k].points, inputs[k].triangles);
    model.endModel();
    return model.num_tris;
  });
}

std::vector<MeshWay> fcl_mesh_ways() {
  return {{"fcl", "OBBRSS", by_trees<fcl::OBBRSS<double>>}, {"fcl", "OBB", by_trees<fcl::OBB<double>>}};
}

std::vector<MeshWay> fcl_mesh_distances() { return {{"fcl", "OBBRSS", distances}}; }

}  // namespace bench
