#include <sunder/io/mesh/space_objects.h>
#include <sunder/io/robot/robot_bodies.h>
#include <sunder/io/robot/robot_motion.h>
#include <sunder/io/text/text.h>

#include <algorithm>
#include <map>
#include <set>
#include <utility>

namespace sunder::io {

namespace {

namespace fs = std::filesystem;

// The body of a shape that is one with a radius.
std::optional<solid::RoundBody> round_body(const CollisionShape& shape) {
  const Point3 low{0, 0, -shape.length / 2}, high{0, 0, shape.length / 2};
  switch (shape.kind) {
    case ShapeKind::mesh:
    case ShapeKind::box: break;
    case ShapeKind::sphere: return solid::RoundBody::ball({0, 0, 0}, shape.radius);
    case ShapeKind::cylinder: return solid::RoundBody::cylinder(low, high, shape.radius);
    case ShapeKind::capsule: return solid::RoundBody::capsule(low, high, shape.radius);
  }
  return std::nullopt;
}

class Reader {
 public:
  Reader(const Robot& robot, const fs::path& file, bool require_convex, LeftOutList& left_out, InputFiles* inputs,
         const Packages& packages)
      : robot_(robot),
        file_(file),
        require_convex_(require_convex),
        left_out_(left_out),
        inputs_(inputs),
        packages_(packages) {}

  RobotBodies read() {
    RobotBodies result;
    for (std::uint32_t l = 0; l < robot_.links.size(); ++l) {
      LinkBody body{l, {}};
      for (const CollisionShape& shape : robot_.links[l].shapes) add_shape(shape, body);
      if (!body.parts.empty()) result.bodies.push_back(std::move(body));
    }
    result.meshes = std::move(meshes_);
    return result;
  }

 private:
  void add_shape(const CollisionShape& shape, LinkBody& body) {
    const solid::Pose pose = shape_pose(shape);
    const std::string name = shape.name.empty() ? std::to_string(body.parts.size()) : shape.name;
    const std::string shown = one_line(file_.string());
    if (const auto round = round_body(shape)) {
      const std::string kind(name_of(shape.kind));
      const auto vertices = static_cast<std::uint32_t>(round->points().size());
      body.parts.push_back(
          {name, {shown, kind, kind, vertices, 0, BodyShape::convex, "", {}, round->core()}, pose, round, "m"});
      return;
    }
    if (shape.kind == ShapeKind::box) {
      const solid::ConvexPolyhedron box(box_corners(shape.size));
      body.parts.push_back({name, {shown, "box", "box", 8, 6, BodyShape::convex, "", {}, box}, pose, {}, "m"});
      return;
    }
    const std::vector<MeshBody>* mesh = mesh_of(shape, robot_.links[body.link].name);
    if (mesh == nullptr) return;
    const bool is_scaled = shape.scale != std::array<double, 3>{1, 1, 1};
    for (const MeshBody& object : *mesh) {
      body.parts.push_back(
          {mesh->size() == 1 ? name : name + "." + object.name, object, pose, {}, is_scaled ? "" : "m"});
    }
  }

  // The objects of the mesh; nothing where it cannot be read, and is left out.
  const std::vector<MeshBody>* mesh_of(const CollisionShape& shape, const std::string& link) {
    try {
      const fs::path path = resolve_mesh(shape.mesh, robot_.folder, packages_);
      auto found = known_.find(path);
      if (found == known_.end()) {
        meshes_.push_back(path);
        InputFiles read;  // not told of where it is left out
        found = known_.emplace(path, read_bodies(path, require_convex_, left_out_, inputs_ ? &read : nullptr)).first;
        if (inputs_ != nullptr) inputs_->insert(inputs_->end(), read.begin(), read.end());
      }
      return &found->second;
    } catch (const Error& error) {
      if (error.code() != ErrorCode::bad_file || !left_out_.consent()) throw;
      left_out_.add(shape.mesh, std::array{LeftOut{"mesh", link, 1}}, "");
      return nullptr;
    }
  }

  const Robot& robot_;
  const fs::path& file_;
  bool require_convex_;
  LeftOutList& left_out_;
  InputFiles* inputs_;
  const Packages& packages_;
  std::map<fs::path, std::vector<MeshBody>> known_;
  std::vector<fs::path> meshes_;
};

}  // namespace

bool has_collision_shapes(const Robot& robot) {
  return std::any_of(robot.links.begin(), robot.links.end(), [](const Link& link) { return !link.shapes.empty(); }) ||
         std::any_of(robot.left_out.begin(), robot.left_out.end(),
                     [](const LeftOut& item) { return item.kind != visual_shape; });
}

RobotBodies read_robot_bodies(const Robot& robot, const fs::path& file, bool require_convex, LeftOutList& left_out,
                              InputFiles* inputs, const Packages& packages) {
  std::vector<LeftOut> shapes, visuals;
  for (const LeftOut& item : robot.left_out) (item.kind == visual_shape ? visuals : shapes).push_back(item);
  const bool has_collisions = has_collision_shapes(robot);
  left_out.add(file.string(), has_collisions ? shapes : visuals, "give meshes in their stead");
  RobotBodies bodies = Reader(robot, file, require_convex, left_out, inputs, packages).read();
  if (has_collisions) bodies.told = std::move(visuals);
  return bodies;
}

scene::Body placed_body(const std::string& name, const std::vector<BodyPart>& parts, const solid::Pose& link) {
  scene::Body placed{name, {}};
  for (const BodyPart& part : parts)
    placed.parts.push_back({part.name, part.shape(), compose(link, part.pose), part.mesh});
  return placed;
}

std::vector<std::array<std::uint32_t, 2>> adjacent_bodies(const Robot& robot, const RobotBodies& robot_bodies) {
  std::map<std::uint32_t, std::uint32_t> body_of_link;
  for (std::uint32_t b = 0; b < robot_bodies.bodies.size(); ++b) body_of_link[robot_bodies.bodies[b].link] = b;
  std::vector<std::array<std::uint32_t, 2>> pairs;
  for (const auto& [link, body] : body_of_link) {
    std::set<std::uint32_t> seen{link};
    std::vector<std::uint32_t> open{link};  // this link, and links without shapes
    while (!open.empty()) {
      const std::uint32_t at = open.back();
      open.pop_back();
      for (const Joint& joint : robot.joints) {
        if (joint.parent != at && joint.child != at) continue;
        const std::uint32_t next = joint.parent == at ? joint.child : joint.parent;
        if (!seen.insert(next).second) continue;
        const auto neighbour = body_of_link.find(next);
        if (neighbour == body_of_link.end()) {
          open.push_back(next);
        } else if (body < neighbour->second) {
          pairs.push_back({body, neighbour->second});
        }
      }
    }
  }
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

}  // namespace sunder::io
