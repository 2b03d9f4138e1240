// FCL 0.7: the dynamic AABB tree manager, and a loop over all pairs with their boxes first; libccd's GJK for pairs.
#include <bench/peers/scene_peer.h>

#include <fcl/broadphase/broadphase_dynamic_AABB_tree.h>
#include <fcl/geometry/shape/convex.h>
#include <fcl/narrowphase/collision.h>
#include <fcl/narrowphase/collision_object.h>

#include <algorithm>
#include <cstddef>
#include <map>
#include <memory>
#include <utility>
#include <vector>

namespace bench {
namespace {

using Object = fcl::CollisionObject<double>;
using Transform = fcl::Transform3<double>;

std::shared_ptr<fcl::Convex<double>> convex_of(const sunder::solid::ConvexPolyhedron& shape) {
  auto vertices = std::make_shared<std::vector<fcl::Vector3<double>>>();
  for (const sunder::Point3& p : shape.vertices()) vertices->emplace_back(p.x, p.y, p.z);
  auto faces = std::make_shared<std::vector<int>>();
  for (std::uint32_t f = 0; f < shape.facet_count(); ++f) {
    const auto ring = shape.facet(f);
    faces->push_back(static_cast<int>(ring.size()));
    for (const std::uint32_t v : ring) faces->push_back(static_cast<int>(v));
  }
  // A mesh that is not watertight would silently fall back to a linear search: make it an error instead.
  return std::make_shared<fcl::Convex<double>>(vertices, static_cast<int>(shape.facet_count()), faces, true);
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

// Objects that are moved from step to step. Transforms are prepared.
class Scene {
 public:
  explicit Scene(const SceneScenario& scenario) : allowed_(scenario.allowed) {
    request_.gjk_solver_type = fcl::GST_LIBCCD;  // one contact at most, none computed, tolerance 1e-6
    request_.enable_contact = false;
    for (const auto& poses : scenario.steps) {
      steps_.emplace_back();
      for (const auto& pose : poses) steps_.back().push_back(transform(pose));
    }
    std::map<const sunder::Point3*, std::shared_ptr<fcl::Convex<double>>> made;  // bodies share shapes
    for (const auto& shape : scenario.shapes) {
      auto& convex = made[shape.vertices().data()];
      if (!convex) convex = convex_of(shape);
      objects_.push_back(std::make_unique<Object>(convex));
      objects_.back()->setUserData(reinterpret_cast<void*>(objects_.size() - 1));
    }
  }

  void move_to(std::size_t step) {
    for (std::size_t i = 0; i < objects_.size(); ++i) {
      objects_[i]->setTransform(steps_[step][i]);
      objects_[i]->computeAABB();
    }
  }

  void ask(Object* a, Object* b) {
    const auto number = [](Object* of) {
      return static_cast<std::uint32_t>(reinterpret_cast<std::size_t>(of->getUserData()));
    };
    const auto [low, high] = std::minmax({number(a), number(b)});
    if (std::binary_search(allowed_.begin(), allowed_.end(), std::array{low, high})) return;
    result_.clear();
    meeting_ += fcl::collide(a, b, request_, result_) != 0;
  }

  std::uint64_t by_manager(std::size_t step) {
    move_to(step);
    if (!manager_) {
      manager_ = std::make_unique<fcl::DynamicAABBTreeCollisionManager<double>>();
      std::vector<Object*> all;
      for (const auto& object : objects_) all.push_back(object.get());
      manager_->registerObjects(all);
      manager_->setup();
    } else {
      manager_->update();
    }
    meeting_ = 0;
    manager_->collide(this, [](Object* a, Object* b, void* scene) {
      static_cast<Scene*>(scene)->ask(a, b);
      return false;
    });
    return meeting_;
  }

  std::uint64_t by_loop(std::size_t step) {
    move_to(step);
    meeting_ = 0;
    for (std::size_t j = 0; j < objects_.size(); ++j) {
      for (std::size_t i = 0; i < j; ++i) {
        if (objects_[i]->getAABB().overlap(objects_[j]->getAABB())) ask(objects_[i].get(), objects_[j].get());
      }
    }
    return meeting_;
  }

 private:
  std::vector<std::array<std::uint32_t, 2>> allowed_;
  std::vector<std::vector<Transform>> steps_;
  std::vector<std::unique_ptr<Object>> objects_;
  std::unique_ptr<fcl::DynamicAABBTreeCollisionManager<double>> manager_;
  fcl::CollisionRequest<double> request_;
  fcl::CollisionResult<double> result_;
  std::uint64_t meeting_ = 0;
};

Run by_manager(const SceneScenario& scenario) {
  return each([scene = std::make_shared<Scene>(scenario)](std::size_t k) { return scene->by_manager(k); });
}
Run by_loop(const SceneScenario& scenario) {
  return each([scene = std::make_shared<Scene>(scenario)](std::size_t k) { return scene->by_loop(k); });
}

}  // namespace

std::vector<SceneWay> fcl_scene_ways() { return {{"fcl", "tree", by_manager}, {"fcl-loop", "loop", by_loop}}; }

}  // namespace bench
