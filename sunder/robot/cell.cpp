#include <sunder/base/error.h>
#include <sunder/io/robot/joint_values.h>
#include <sunder/io/robot/scene_file.h>
#include <sunder/io/text/text.h>
#include <sunder/robot/cell.h>
#include <sunder/robot/named_internal.h>

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>
#include <utility>

namespace sunder::robot {

namespace {

std::array<std::uint32_t, 2> in_order(const AllowedPair& pair) {
  const auto [low, high] = std::minmax(pair.bodies[0], pair.bodies[1]);
  return {low, high};
}

}  // namespace

void add_allowed(std::span<const AllowedPair> more, std::vector<AllowedPair>& list) {
  std::set<std::array<std::uint32_t, 2>> known;
  for (const AllowedPair& pair : list) known.insert(in_order(pair));
  for (const AllowedPair& pair : more) {
    if (pair.bodies[0] != pair.bodies[1] && known.insert(in_order(pair)).second) list.push_back(pair);
  }
}

std::vector<std::array<std::uint32_t, 2>> bodies_of(std::span<const AllowedPair> list) {
  std::vector<std::array<std::uint32_t, 2>> pairs;
  for (const AllowedPair& pair : list) pairs.push_back(pair.bodies);
  return pairs;
}

std::vector<std::string> reason_of_each(std::span<const AllowedPair> list) {
  std::vector<std::string> reasons;
  for (const AllowedPair& pair : list) reasons.push_back(pair.reason);
  return reasons;
}

bool is_urdf(const std::string& file) {
  return std::filesystem::path(file).extension() == ".urdf" || file.ends_with(".URDF");
}

Cell::Cell(std::span<const CellFile> files, const CellOptions& options, InputFiles* inputs,
           std::vector<std::string>* remarks)
    : left_out_(options.leave_out) {
  std::vector<std::pair<std::string, std::vector<io::LeftOut>>> told;  // without consent: so, when all is read
  for (const CellFile& given : files) {
    files_.push_back(given);
    if (is_urdf(given.file)) {
      told.emplace_back(given.file, add_robot(options, inputs));
    } else if (io::is_scene_file(given.file)) {
      add_scene(options, inputs);
    } else {
      add_mesh(options, inputs);
    }
  }
  give_names();
  join_robots();
  for (const auto& [file, left_out] : told) tell(file, left_out);
  require_some_body(remarks);
  if (!options.hulls) keep_meshes();
}

// Names are given in the order of the files: to a file, then to its bodies. `wish`, or wish#2, wish#3, ...: no input or
// body has it.
void Cell::give_names() {
  std::map<std::string, int> links, joints;  // how many robots have them
  for (const CellRobot& robot : robots_) {
    for (const io::Link& link : robot.model.links) ++links[link.name];
    for (const io::Joint& joint : robot.model.joints) ++joints[joint.name];
  }
  std::set<std::string> of_files, of_bodies, of_robots;
  const auto unused = [](const std::string& wish, const auto& is_taken) {
    std::string name = wish;
    for (int number = 2; is_taken(name); ++number) name = fmt::format("{}#{}", wish, number);
    return name;
  };
  const auto is_taken = [&](const std::string& name) { return of_files.contains(name) || of_bodies.contains(name); };
  auto body = bodies_.begin();
  auto robot = robots_.begin();
  for (std::size_t f = 0; f < files_.size(); ++f) {
    CellFile& file = files_[f];
    if (!file.name.empty()) of_files.insert(file.name = unused(file.name, is_taken));
    if (robot != robots_.end() && robot->file == f) {
      robot->name =
          unused(file.name.empty() ? io::one_line(std::filesystem::path(file.file).stem().string()) : file.name,
                 [&](const std::string& name) { return of_robots.contains(name); });
      of_robots.insert(robot->name);
      const auto name = [&](const std::string& of, const auto& times) {
        return times.at(of) > 1 ? robot->name + "/" + of : of;
      };
      for (const io::Link& link : robot->model.links) robot_.links.push_back({name(link.name, links), link.shapes});
      for (io::Joint joint : robot->model.joints) {
        joint.name = name(joint.name, joints);
        joint.parent += robot->first_link;
        joint.child += robot->first_link;
        if (joint.mimic) joint.mimic->joint += robot->first_joint;
        robot_.joints.push_back(std::move(joint));
      }
      ++robot;
    }
    for (; body != bodies_.end() && body->file == f; ++body) {
      if (body->link) {
        body->name = unused(robot_.links[*body->link].name, is_taken);
      } else if (io::is_scene_file(file.file)) {  // as in the file, unless another body has it
        if (of_bodies.contains(body->name)) body->name = unused(body->name, is_taken);
      } else {
        body->name = file.name;
      }
      of_bodies.insert(body->name);
    }
  }
}

void Cell::join_robots() {
  for (std::uint32_t r = 0; r < robots_.size(); ++r) {
    robot_of_link_.insert(robot_of_link_.end(), robots_[r].model.links.size(), r);
  }
  if (robots_.empty()) return;
  const io::Robot& first = robots_[0].model;
  robot_.name = first.name;
  robot_.root = first.root;
  robot_.folder = first.folder;
  const auto require_once = [&](const auto& all, const char* what) {
    std::set<std::string> names;
    for (const auto& each : all) {
      if (!names.insert(each.name).second) {
        fail_call(fmt::format("two {} would be named {}; give the robots other names", what, io::quote(each.name)),
                  robots_[0].name);
      }
    }
  };
  require_once(robot_.links, "links");
  require_once(robot_.joints, "joints");
}

CellFile& Cell::file_named(const std::string& name, const std::string& place) {
  return files_[file_number(name, place)];
}

std::size_t Cell::file_number(const std::string& name, const std::string& place) const {
  const auto robot = named(name, robots_);
  if (robot != robots_.end()) return robot->file;
  const auto file = named(name, files_);
  if (file != files_.end()) return static_cast<std::size_t>(file - files_.begin());
  fail_call("nothing is named " + io::quote(name) + "; names are " + names_of(files_), place);
}

void Cell::tell(const std::string& file, std::span<const io::LeftOut> left_out) {
  if (left_out.empty()) return;
  if (left_out_.consent()) {
    left_out_.add(file, left_out, "");
  } else {
    left_out_ = io::LeftOutList(file, left_out);
  }
}

// A question about nothing has no answer that could be relied on; but that a robot has no collision shape is known, and
// who says that he knows gets one. (Not so where it has some that are not read: a wrong folder of meshes would be
// none.)
void Cell::require_some_body(std::vector<std::string>* remarks) const {
  if (!bodies_.empty()) return;
  const auto is_bare = [](const CellRobot& robot) { return !io::has_collision_shapes(robot.model); };
  if (has_robot() && left_out_.consent() && std::all_of(robots_.begin(), robots_.end(), is_bare)) {
    for (const CellRobot& robot : robots_) {
      if (remarks == nullptr) break;
      remarks->push_back("no link of " + io::one_line(files_[robot.file].file) +
                         " has a collision shape, so nothing can meet");
    }
    return;
  }
  fail_call(left_out_.empty() ? "no link has a shape, so there is nothing to ask about; give the links <collision> "
                                "shapes, or say that you know: --leave-out"
                              : "there is nothing to ask about; left out: " + left_out_.text(),
            files_.back().name.empty() ? io::one_line(files_.back().file) : files_.back().name);
}

// Keeps each mesh that is not convex once, for all bodies that show it.
void Cell::keep_meshes() {
  std::map<const io::Mesh*, std::shared_ptr<const solid::Mesh>> known;
  for (CellBody& body : bodies_) {
    for (io::BodyPart& part : body.parts) {
      if (part.body.shape != io::BodyShape::hull) continue;
      std::shared_ptr<const solid::Mesh>& mesh = known[part.body.mesh.get()];
      if (mesh == nullptr) mesh = std::make_shared<const solid::Mesh>(io::mesh_as_it_is(part.body));
      part.mesh = mesh;
    }
  }
}

void Cell::add_mesh(const CellOptions& options, InputFiles* inputs) {
  CellBody body;
  body.file = files_.size() - 1;
  for (io::MeshBody& object :
       io::read_bodies(files_.back().file, options.require_convex, left_out_, inputs, options.parts)) {
    std::string name = object.name;
    body.parts.push_back({std::move(name), std::move(object), solid::Pose()});
  }
  bodies_.push_back(std::move(body));
}

std::vector<io::LeftOut> Cell::add_robot(const CellOptions& options, InputFiles* inputs) {
  const std::string& file = files_.back().file;
  CellRobot robot;
  robot.file = files_.size() - 1;
  robot.model = io::read_urdf(file, inputs);
  if (has_robot()) {
    const CellRobot& last = robots_.back();
    robot.first_link = last.first_link + static_cast<std::uint32_t>(last.model.links.size());
    robot.first_joint = last.first_joint + static_cast<std::uint32_t>(last.model.joints.size());
  }
  io::RobotBodies read =
      io::read_robot_bodies(robot.model, file, options.require_convex, left_out_, inputs, options.packages);
  meshes_.insert(meshes_.end(), read.meshes.begin(), read.meshes.end());
  take_unit("m");
  for (io::LinkBody& body : read.bodies) {
    const std::uint32_t link = robot.first_link + body.link;
    bodies_.push_back({"", robot.file, link, std::move(body.parts)});
    robot_bodies_.bodies.push_back({link, {}});
  }
  robots_.push_back(std::move(robot));
  return std::move(read.told);
}

void Cell::add_scene(const CellOptions& options, InputFiles* inputs) {
  const std::string& file = files_.back().file;
  const io::SceneFile scene = io::read_scene_file(file, inputs);
  if (!scene.unit.empty()) take_unit(scene.unit);
  auto all = io::read_scene_parts(scene, file, options.require_convex, left_out_, inputs, &meshes_, options.parts);
  const auto first = static_cast<std::uint32_t>(bodies_.size());
  for (std::size_t b = 0; b < all.size(); ++b) {
    bodies_.push_back({scene.bodies[b].name, files_.size() - 1, {}, std::move(all[b])});
  }
  for (const auto& [a, b] : scene.allowed) allowed_by_files_.push_back({{first + a, first + b}, io::one_line(file)});
  if (!scene.allowed.empty()) scene_files_.push_back(file);
}

// Lengths of different units are not compared.
void Cell::take_unit(const std::string& unit) {
  const std::string& file = files_.back().file;
  if (!unit_.empty() && unit != unit_) {
    fail_call(fmt::format("is in {}, but '{}' is in {}; scale one of them", unit, io::one_line(unit_file_), unit_),
              io::one_line(file));
  }
  unit_ = unit;
  unit_file_ = file;
}

std::vector<scene::Body> Cell::place(const std::map<std::string, double>& joints) const {
  std::vector<Affine3> links(robot_.links.size());
  if (has_robot()) {
    std::vector<std::string> names;
    std::vector<double> values;
    for (const auto& [name, value] : joints) {
      names.push_back(name);
      values.push_back(value);
    }
    io::RobotMotion(robot_, names).place(values, links);
  } else if (!joints.empty()) {
    (void)robot("joints");
  }
  std::vector<scene::Body> placed;
  for (const CellBody& body : bodies_) {
    try {
      const Affine3 frame = body.link       ? link_frame(*body.link, links)
                            : body.attached ? mounted(*body.attached, links, {})
                                            : files_[body.file].pose.affine();
      placed.push_back(
          io::placed_body(body.name, body.parts, solid::Pose::from_matrix(frame.linear, frame.translation)));
    } catch (const Error& error) {
      throw Error(error.code(), error.what(), body.name);
    }
  }
  return placed;
}

const io::Robot& Cell::robot(const std::string& place) const {
  if (!has_robot()) fail_call("there is no robot to move; name a URDF file", place);
  return robot_;
}

bool Cell::is_hull(std::uint32_t body, std::uint32_t part) const {
  return bodies_[body].parts[part].body.shape == io::BodyShape::hull;
}

std::vector<const io::BodyPart*> Cell::parts() const {
  std::vector<const io::BodyPart*> all;
  for (const CellBody& body : bodies_) {
    for (const io::BodyPart& part : body.parts) all.push_back(&part);
  }
  return all;
}

std::uint32_t Cell::body_named(const std::string& name, const std::string& place) const {
  const auto found = named(name, bodies_);
  if (found != bodies_.end()) return static_cast<std::uint32_t>(found - bodies_.begin());
  fail_unknown("body", name, bodies_, place);
}

std::uint32_t Cell::link_named(const std::string& name, const std::string& place) const {
  const auto found = named(name, robot(place).links);
  if (found != robot_.links.end()) return static_cast<std::uint32_t>(found - robot_.links.begin());
  fail_unknown("link", name, robot_.links, place);
}

// Pairs of bodies.
std::vector<std::array<std::uint32_t, 2>> Cell::neighbours(const io::Robot& robot,
                                                           const io::RobotBodies& bodies) const {
  // Of all links, so that those on both sides of one that is left out are not taken for neighbours.
  std::vector<std::array<std::uint32_t, 2>> pairs;
  const auto body_of = [&](std::uint32_t of) -> std::optional<std::uint32_t> {
    const std::uint32_t link = bodies.bodies[of].link;
    return link < robot_.links.size() ? body_of_link(link) : attached_bodies()[link - robot_.links.size()];
  };
  for (const auto& [a, b] : io::adjacent_bodies(robot, bodies)) {
    const auto body_a = body_of(a), body_b = body_of(b);
    if (body_a && body_b) pairs.push_back({*body_a, *body_b});
  }
  return pairs;
}

// Those that are no links.
std::vector<std::uint32_t> Cell::attached_bodies() const {
  std::vector<std::uint32_t> all;
  for (std::uint32_t b = 0; b < bodies_.size(); ++b) {
    if (bodies_[b].attached) all.push_back(b);
  }
  return all;
}

std::vector<AllowedPair> Cell::adjacent(const std::string& place) const {
  if (!has_robot()) fail_call("there is no robot whose links could be adjacent; name a URDF file", place);
  std::vector<AllowedPair> pairs;
  for (const auto& bodies : neighbours(robot_, robot_bodies_)) pairs.push_back({bodies, "adjacent"});
  return pairs;
}

std::vector<AllowedPair> Cell::attached() const {
  io::Robot joined = robot_;
  io::RobotBodies links = robot_bodies_;
  const auto join = [&](std::uint32_t parent, std::uint32_t child) {
    io::Joint& joint = joined.joints.emplace_back();
    joint.parent = parent;
    joint.child = child;
  };
  for (const CellRobot& robot : robots_) {
    if (robot.attached) join(robot.attached->link, robot.first_link + robot.model.root);
  }
  for (const std::uint32_t body : attached_bodies()) {
    const auto link = static_cast<std::uint32_t>(joined.links.size());
    joined.links.emplace_back();
    links.bodies.push_back({link, {}});
    join(bodies_[body].attached->link, link);
  }
  const auto known = neighbours(robot_, robot_bodies_);
  std::vector<AllowedPair> pairs;
  for (const auto& bodies : neighbours(joined, links)) {
    if (std::find(known.begin(), known.end(), bodies) == known.end()) pairs.push_back({bodies, "attached"});
  }
  return pairs;
}

void Cell::attach(const std::string& name, const std::string& link, const std::string& place,
                  const std::optional<solid::Pose>& pose) {
  const std::uint32_t to = link_named(link, place);
  const auto set = [&](std::optional<Attachment>& attached, std::size_t file) {
    if (attached) fail_call(io::quote(name) + " is attached to a link already; attach it to one", place);
    attached = {to, pose.value_or(files_[file].pose)};
  };
  if (const auto body = named(name, bodies_); body != bodies_.end()) {
    if (body->link) fail_call(io::quote(name) + " is a link; attach a mesh, a body of a scene file, or a robot", place);
    set(body->attached, body->file);
    return;
  }
  const std::size_t file = file_number(name, place);
  for (CellBody& body : bodies_) {
    if (body.file == file && !body.link) set(body.attached, file);
  }
  for (std::size_t r = 0; r < robots_.size(); ++r) {
    if (robots_[r].file != file) continue;
    for (std::size_t on = robot_of_link_[to];; on = robot_of_link_[robots_[on].attached->link]) {
      if (on == r) fail_call(io::quote(name) + " would hang on itself; attach it to a link of another robot", place);
      if (!robots_[on].attached) break;
    }
    set(robots_[r].attached, file);
  }
}

std::vector<AllowedPair> Cell::pairs_in(const std::string& file, InputFiles* inputs,
                                        std::vector<std::string>& remarks) const {
  std::vector<AllowedPair> pairs;
  std::vector<std::string> shapeless;
  for (const auto& [place, names] : io::read_name_pairs(file, inputs)) {
    bool both = true;
    for (const std::string& name : names) {
      const auto link = named(name, robot_.links);
      if (named(name, bodies_) != bodies_.end() || link == robot_.links.end()) continue;
      if (!is_outside(static_cast<std::uint32_t>(link - robot_.links.begin()))) add_once(name, shapeless);
      both = false;
    }
    if (both) pairs.push_back({{body_named(names[0], place), body_named(names[1], place)}, io::one_line(file)});
  }
  if (!shapeless.empty()) {
    remarks.push_back(fmt::format("{}: lines about links without a shape are passed over: {}", io::one_line(file),
                                  listed(shapeless)));
  }
  return pairs;
}

bool Cell::is_outside(std::uint32_t link) const {
  return std::find(outside_.begin(), outside_.end(), link) != outside_.end();
}

std::optional<std::uint32_t> Cell::body_of_link(std::uint32_t link) const {
  for (std::uint32_t b = 0; b < bodies_.size(); ++b) {
    if (bodies_[b].link == link) return b;
  }
  return std::nullopt;
}

}  // namespace sunder::robot
