// FCL 0.7: the dynamic AABB tree manager, and a loop over the pairs that are asked about with their boxes first; bodies
// as fcl::Convex by libccd's solver, and as meshes (BVHModel of OBBRSS), both with one contact a pair, as booleans too.
#include <bench/peers/placement_peer.h>

#include <fcl/broadphase/broadphase_dynamic_AABB_tree.h>
#include <fcl/geometry/bvh/BVH_model.h>
#include <fcl/geometry/shape/convex.h>
#include <fcl/narrowphase/collision.h>
#include <fcl/narrowphase/collision_object.h>

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cstdio>
#include <iterator>
#include <memory>
#include <utility>

namespace bench {
namespace {

using Object = fcl::CollisionObject<double>;
using Transform = fcl::Transform3<double>;
using Vector = fcl::Vector3<double>;
using Geometry = std::shared_ptr<fcl::CollisionGeometry<double>>;

enum class As : std::uint8_t { convex, mesh };
enum class Broad : std::uint8_t { tree, loop };

Geometry convex_of(const sunder::solid::ConvexPolyhedron& shape) {
  auto vertices = std::make_shared<std::vector<Vector>>();
  for (const sunder::Point3& p : shape.vertices()) vertices->emplace_back(p.x, p.y, p.z);
  auto faces = std::make_shared<std::vector<int>>();
  for (std::uint32_t f = 0; f < shape.facet_count(); ++f) {
    const auto ring = shape.facet(f);
    faces->push_back(static_cast<int>(ring.size()));
    for (const std::uint32_t v : ring) faces->push_back(static_cast<int>(v));
  }
  return std::make_shared<fcl::Convex<double>>(vertices, static_cast<int>(shape.facet_count()), faces, true);
}

Geometry mesh_of(const sunder::solid::ConvexPolyhedron& shape) {
  std::vector<Vector> vertices;
  for (const sunder::Point3& p : shape.vertices()) vertices.emplace_back(p.x, p.y, p.z);
  std::vector<fcl::Triangle> triangles;
  for (std::uint32_t f = 0; f < shape.facet_count(); ++f) {
    const auto ring = shape.facet(f);
    for (std::size_t k = 2; k < ring.size(); ++k) triangles.emplace_back(ring[0], ring[k - 1], ring[k]);
  }
  auto model = std::make_shared<fcl::BVHModel<fcl::OBBRSS<double>>>();
  model->beginModel();
  model->addSubModel(vertices, triangles);
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

class Robot {
 public:
  Robot(const PlacementScenario& scenario, As as, Broad broad, bool has_contacts)
      : of_(scenario), broad_(broad), links_(scenario.links, Transform::Identity()) {
    request_.gjk_solver_type = fcl::GST_LIBCCD;
    request_.enable_contact = has_contacts;
    for (const auto& origin : of_.origins) origins_.push_back(transform(origin));
    for (const auto& shape : of_.shapes) {
      poses_.push_back(transform(shape.pose));
      objects_.push_back(std::make_unique<Object>(as == As::mesh ? mesh_of(shape.hull) : convex_of(shape.hull)));
      objects_.back()->setUserData(reinterpret_cast<void*>(objects_.size() - 1));
    }
    for (std::uint32_t j = 0; j < objects_.size(); ++j) {
      for (std::uint32_t i = 0; i < j; ++i) {
        if (is_asked_about(i, j)) asked_.push_back({i, j});
      }
    }
  }

  std::uint64_t run() {
    read();
    std::FILE* const out = std::fopen(of_.output.c_str(), "wb");
    if (out == nullptr) return kUnknown;
    meeting_ = 0;
    for (std::size_t row = 0; row < values_.size() / of_.columns; ++row) {
      move_to(&values_[row * of_.columns]);
      line_.clear();
      const std::uint64_t before = meeting_;
      broad_ == Broad::tree ? by_manager() : by_loop();
      fmt::format_to(std::back_inserter(text_), R"({{"placement": {}, "answer": "{}")", row,
                     meeting_ > before ? "some" : "none");
      if (meeting_ > before) text_ += R"(, "pairs": [)" + line_ + "]";
      text_ += "}\n";
      if (text_.size() > 1 << 16) flush(out);
    }
    flush(out);
    std::fclose(out);
    return meeting_;
  }

 private:
  bool is_asked_about(std::uint32_t i, std::uint32_t j) const {
    const std::uint32_t a = of_.shapes[i].body, b = of_.shapes[j].body;
    return a != b &&
           !std::binary_search(of_.allowed.begin(), of_.allowed.end(), std::array{std::min(a, b), std::max(a, b)});
  }

  void read() {
    std::FILE* const in = std::fopen(of_.table.c_str(), "rb");
    if (in == nullptr) return;
    std::fseek(in, 0, SEEK_END);
    std::string bytes(static_cast<std::size_t>(std::ftell(in)), '\0');
    std::rewind(in);
    bytes.resize(std::fread(bytes.data(), 1, bytes.size(), in));
    std::fclose(in);
    values_.clear();
    const char* at = bytes.data() + bytes.find('\n') + 1;
    const char* const end = bytes.data() + bytes.size();
    for (double value = 0; at < end;) {
      at = std::from_chars(at, end, value).ptr + 1;
      values_.push_back(value);
    }
  }

  void flush(std::FILE* out) {
    std::fwrite(text_.data(), 1, text_.size(), out);
    text_.clear();
  }

  void move_to(const double* values) {
    for (std::size_t i = 0; i < of_.joints.size(); ++i) {
      const auto& joint = of_.joints[i];
      double value = of_.column[i] == PlacementScenario::none ? 0 : values[of_.column[i]];
      if (joint.mimic) value = joint.mimic->multiplier * values[of_.column[joint.mimic->joint]] + joint.mimic->offset;
      Transform t = links_[joint.parent] * origins_[i];
      const Vector axis(joint.axis[0], joint.axis[1], joint.axis[2]);
      if (joint.type == sunder::io::JointType::prismatic) {
        t.translate(value * axis);
      } else if (joint.type != sunder::io::JointType::fixed) {
        t.rotate(Eigen::AngleAxisd(value, axis));
      }
      links_[joint.child] = t;
    }
    for (std::size_t i = 0; i < objects_.size(); ++i) {
      objects_[i]->setTransform(links_[of_.shapes[i].link] * poses_[i]);
      objects_[i]->computeAABB();
    }
  }

  void ask(std::uint32_t i, std::uint32_t j) {
    result_.clear();
    if (fcl::collide(objects_[i].get(), objects_[j].get(), request_, result_) == 0) return;
    ++meeting_;
    fmt::format_to(std::back_inserter(line_), R"({}{{"a": "{}", "b": "{}", "answer": "meet")",
                   line_.empty() ? "" : ", ", of_.shapes[i].name, of_.shapes[j].name);
    if (request_.enable_contact) {
      const Vector& p = result_.getContact(0).pos;
      fmt::format_to(std::back_inserter(line_), R"(, "point": [{}, {}, {}])", p[0], p[1], p[2]);
    }
    line_ += '}';
  }

  void by_manager() {
    if (!manager_) {
      manager_ = std::make_unique<fcl::DynamicAABBTreeCollisionManager<double>>();
      std::vector<Object*> all;
      for (const auto& object : objects_) all.push_back(object.get());
      manager_->registerObjects(all);
      manager_->setup();
    } else {
      manager_->update();
    }
    manager_->collide(this, [](Object* a, Object* b, void* robot) {
      const auto number = [](Object* of) {
        return static_cast<std::uint32_t>(reinterpret_cast<std::size_t>(of->getUserData()));
      };
      const auto [low, high] = std::minmax({number(a), number(b)});
      Robot& self = *static_cast<Robot*>(robot);
      if (self.is_asked_about(low, high)) self.ask(low, high);
      return false;
    });
  }

  void by_loop() {
    for (const auto& [i, j] : asked_) {
      if (objects_[i]->getAABB().overlap(objects_[j]->getAABB())) ask(i, j);
    }
  }

  const PlacementScenario of_;
  const Broad broad_;
  std::vector<Transform> links_, origins_, poses_;
  std::vector<std::unique_ptr<Object>> objects_;
  std::vector<std::array<std::uint32_t, 2>> asked_;
  std::unique_ptr<fcl::DynamicAABBTreeCollisionManager<double>> manager_;
  fcl::CollisionRequest<double> request_;
  fcl::CollisionResult<double> result_;
  std::vector<double> values_;
  std::string text_, line_;
  std::uint64_t meeting_ = 0;
};

template <As as, Broad broad, bool has_contacts>
Run run_by(const PlacementScenario& scenario) {
  return each(
      [robot = std::make_shared<Robot>(scenario, as, broad, has_contacts)](std::size_t) { return robot->run(); });
}

}  // namespace

std::vector<PlacementWay> fcl_placement_ways() {
  return {{"fcl", "tree, contacts", run_by<As::convex, Broad::tree, true>},
          {"fcl-loop", "loop, contacts", run_by<As::convex, Broad::loop, true>},
          {"fcl-bare", "tree, booleans", run_by<As::convex, Broad::tree, false>},
          {"fcl-bare", "loop, booleans", run_by<As::convex, Broad::loop, false>},
          {"fcl-mesh", "tree, contacts", run_by<As::mesh, Broad::tree, true>},
          {"fcl-mesh", "loop, contacts", run_by<As::mesh, Broad::loop, true>}};
}

}  // namespace bench
