#include <sunder/base/error.h>
#include <sunder/io/robot/joint_values.h>
#include <sunder/io/robot/scene_file.h>
#include <sunder/io/text/text.h>
#include <sunder/robot/cell.h>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <set>
#include <utility>

namespace sunder::robot {

namespace {

[[noreturn]] void fail_call(const std::string& text, const std::string& place) {
  throw Error(ErrorCode::bad_call, text, place);
}

template <class Named>  // std::vector of what has a name
std::string names_of(const Named& all) {
  std::string names;
  for (const auto& each : all) names += (names.empty() ? "" : ", ") + each.name;
  return names;
}

template <class Named>
auto named(const std::string& name, Named& all) {
  return std::find_if(all.begin(), all.end(), [&](const auto& each) { return each.name == name; });
}

void add_once(const std::string& name, std::vector<std::string>& names) {
  if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
}

// The first few, and how many more.
std::string listed(const std::vector<std::string>& names) {
  constexpr std::size_t most = 5;
  std::string list;
  for (std::size_t i = 0; i < std::min(names.size(), most); ++i) list += (i == 0 ? "" : ", ") + names[i];
  return names.size() > most ? fmt::format("{} and {} more", list, names.size() - most) : list;
}

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
  for (const CellFile& given : files) {
    const std::string name = given.name.empty() ? "" : unused_name(given.name);
    files_.push_back({given.file, name, given.pose});
    if (is_urdf(given.file)) {
      add_robot(options, inputs);
    } else if (io::is_scene_file(given.file)) {
      add_scene(options, inputs);
    } else {
      add_mesh(options, inputs);
    }
  }
  // Told without consent. So far nothing is left out where there is none.
  tell(robot_bodies_.told);
  require_some_body(remarks);
}

CellFile& Cell::file_named(const std::string& name, const std::string& place) {
  const auto file = named(name, files_);
  if (file != files_.end()) return *file;
  fail_call("nothing is named " + io::quote(name) + "; names are " + names_of(files_), place);
}

// Of the robot.
void Cell::tell(std::span<const io::LeftOut> left_out) {
  if (left_out.empty()) return;
  if (left_out_.consent()) {
    left_out_.add(robot_file_, left_out, "");
  } else {
    left_out_ = io::LeftOutList(robot_file_, left_out);
  }
}

// A question about nothing has no answer that could be relied on; but that a robot has no collision shape is known, and
// who says that he knows gets one. (Not so where it has some that are not read: a wrong folder of meshes would be
// none.)
void Cell::require_some_body(std::vector<std::string>* remarks) const {
  if (!bodies_.empty()) return;
  if (robot_ && left_out_.consent() && !io::has_collision_shapes(*robot_)) {
    if (remarks != nullptr) {
      remarks->push_back("no link of " + io::one_line(robot_file_) + " has a collision shape, so nothing can meet");
    }
    return;
  }
  fail_call(left_out_.empty() ? "no link has a shape, so there is nothing to ask about; give the links <collision> "
                                "shapes, or say that you know: --leave-out"
                              : "there is nothing to ask about; left out: " + left_out_.text(),
            files_.back().name.empty() ? io::one_line(files_.back().file) : files_.back().name);
}

// `wish`, or wish#2, wish#3, ...: no input or body has it.
std::string Cell::unused_name(const std::string& wish) const {
  std::string name = wish;
  const auto taken = [&] { return named(name, files_) != files_.end() || named(name, bodies_) != bodies_.end(); };
  for (int number = 2; taken(); ++number) name = fmt::format("{}#{}", wish, number);
  return name;
}

void Cell::add_mesh(const CellOptions& options, InputFiles* inputs) {
  CellBody body;
  body.name = files_.back().name;
  body.file = files_.size() - 1;
  for (io::MeshBody& object :
       io::read_bodies(files_.back().file, options.require_convex, left_out_, inputs, options.parts)) {
    std::string name = object.name;
    body.parts.push_back({std::move(name), std::move(object), solid::Pose()});
  }
  bodies_.push_back(std::move(body));
}

void Cell::add_robot(const CellOptions& options, InputFiles* inputs) {
  const std::string& file = files_.back().file;
  if (robot_) fail_call("a second robot; give one URDF file in a call", io::one_line(file));
  robot_ = io::read_urdf(file, inputs);
  robot_file_ = file;
  robot_bodies_ = io::read_robot_bodies(*robot_, file, options.require_convex, left_out_, inputs, options.packages);
  meshes_.insert(meshes_.end(), robot_bodies_.meshes.begin(), robot_bodies_.meshes.end());
  take_unit("m");
  for (io::LinkBody& body : robot_bodies_.bodies) {
    bodies_.push_back(
        {unused_name(robot_->links[body.link].name), files_.size() - 1, body.link, std::move(body.parts)});
  }
}

void Cell::add_scene(const CellOptions& options, InputFiles* inputs) {
  const std::string& file = files_.back().file;
  const io::SceneFile scene = io::read_scene_file(file, inputs);
  if (!scene.unit.empty()) take_unit(scene.unit);
  auto all = io::read_scene_parts(scene, file, options.require_convex, left_out_, inputs, &meshes_, options.parts);
  const auto first = static_cast<std::uint32_t>(bodies_.size());
  for (std::size_t b = 0; b < all.size(); ++b) {
    const std::string& name = scene.bodies[b].name;  // as in the file, unless another body has it
    const bool is_taken = named(name, bodies_) != bodies_.end();
    bodies_.push_back({is_taken ? unused_name(name) : name, files_.size() - 1, {}, std::move(all[b])});
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
  std::vector<solid::Pose> links;
  if (robot_) {
    links = io::link_poses(*robot_, joints);
  } else if (!joints.empty()) {
    (void)robot("joints");
  }
  std::vector<scene::Body> placed;
  for (const CellBody& body : bodies_) {
    const solid::Pose& base = files_[body.file].pose;
    try {
      placed.push_back(io::placed_body(body.name, body.parts, body.link ? compose(base, links[*body.link]) : base));
    } catch (const Error& error) {
      throw Error(error.code(), error.what(), body.name);
    }
  }
  return placed;
}

const io::Robot& Cell::robot(const std::string& place) const {
  if (!robot_) fail_call("there is no robot to move; name a URDF file", place);
  return *robot_;
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
  fail_call("no body is named " + io::quote(name) + "; bodies are " + names_of(bodies_), place);
}

std::vector<AllowedPair> Cell::adjacent(const std::string& place) const {
  if (!robot_) fail_call("there is no robot whose links could be adjacent; name a URDF file", place);
  // Of all links, so that those on both sides of one that is left out are not taken for neighbours.
  std::vector<AllowedPair> pairs;
  for (const auto& [a, b] : io::adjacent_bodies(*robot_, robot_bodies_)) {
    const auto body_a = body_of_link(robot_->links[robot_bodies_.bodies[a].link].name),
               body_b = body_of_link(robot_->links[robot_bodies_.bodies[b].link].name);
    if (body_a && body_b) pairs.push_back({{*body_a, *body_b}, "adjacent"});
  }
  return pairs;
}

std::vector<AllowedPair> Cell::pairs_in(const std::string& file, InputFiles* inputs,
                                        std::vector<std::string>& remarks) const {
  std::vector<AllowedPair> pairs;
  std::vector<std::string> shapeless;
  for (const auto& [place, names] : io::read_name_pairs(file, inputs)) {
    bool both = true;
    for (const std::string& name : names) {
      if (named(name, bodies_) != bodies_.end() || !is_link(name)) continue;
      if (!is_outside(name)) add_once(name, shapeless);
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

bool Cell::is_link(const std::string& name) const {
  return robot_ && named(name, robot_->links) != robot_->links.end();
}

bool Cell::is_outside(const std::string& name) const {
  return std::find(outside_.begin(), outside_.end(), name) != outside_.end();
}

std::optional<std::uint32_t> Cell::body_of_link(const std::string& name) const {
  for (std::uint32_t b = 0; b < bodies_.size(); ++b) {
    if (bodies_[b].link && robot_->links[*bodies_[b].link].name == name) return b;
  }
  return std::nullopt;
}

std::vector<AllowedPair> Cell::disabled(const io::Srdf& srdf, const std::string& file, const std::string& place,
                                        std::vector<std::string>& remarks) const {
  if (!robot_) fail_call("there is no robot that this could be about; name a URDF file", place);
  std::set<std::array<std::uint32_t, 2>> known;
  std::vector<AllowedPair> pairs;
  std::vector<io::Srdf::Pair> taken;
  std::vector<std::string> shapeless, unknown;
  for (const io::Srdf::Pair& pair : srdf.disabled) {
    std::array<std::optional<std::uint32_t>, 2> both;
    for (std::size_t i = 0; i < 2; ++i) {
      both[i] = body_of_link(pair.links[i]);
      if (both[i] || is_outside(pair.links[i])) continue;
      add_once(pair.links[i], is_link(pair.links[i]) ? shapeless : unknown);
    }
    if (!both[0] || !both[1]) continue;
    if (!known.insert({std::min(*both[0], *both[1]), std::max(*both[0], *both[1])}).second) continue;
    taken.push_back(pair);
    pairs.push_back({{std::min(*both[0], *both[1]), std::max(*both[0], *both[1])},
                     pair.reason.empty() ? "without a reason" : pair.reason});
  }
  const std::string shown = io::one_line(file);
  remarks.push_back(fmt::format("{} allows {}", shown, io::reasons_text(taken)));
  if (!shapeless.empty()) {
    remarks.push_back(fmt::format("{}: pairs of links without a shape are passed over: {}", shown, listed(shapeless)));
  }
  if (!unknown.empty()) {
    remarks.push_back(
        fmt::format("{}: pairs of links that the robot does not have are passed over: {}", shown, listed(unknown)));
  }
  std::sort(pairs.begin(), pairs.end(), [](const AllowedPair& p, const AllowedPair& q) { return p.bodies < q.bodies; });
  return pairs;
}

void Cell::keep_groups(const io::Srdf& srdf, std::span<const std::string> names, const std::string& place,
                       std::vector<std::string>& remarks) {
  if (!robot_) fail_call("there is no robot that this could be about; name a URDF file", place);
  const std::vector<std::uint32_t> links = io::group_links(srdf, *robot_, names, place, remarks);
  std::vector<io::LeftOut> left_out;
  std::vector<std::uint32_t> numbers(bodies_.size());  // of the bodies that stay
  std::uint32_t kept = 0, kept_links = 0;
  for (std::uint32_t b = 0; b < bodies_.size(); ++b) {
    CellBody& body = bodies_[b];
    if (body.link && !std::binary_search(links.begin(), links.end(), *body.link)) {
      left_out.push_back({"shape", body.name, body.parts.size()});
      outside_.push_back(robot_->links[*body.link].name);
      continue;
    }
    if (body.link) ++kept_links;
    numbers[b] = kept;
    if (kept != b) bodies_[kept] = std::move(body);
    ++kept;
  }
  if (kept_links == 0) fail_call("no link of the group has a shape, so there is nothing to ask about", place);
  bodies_.resize(kept);
  for (AllowedPair& pair : allowed_by_files_) {  // of bodies of scene files, which stay
    for (std::uint32_t& body : pair.bodies) body = numbers[body];
  }
  const auto all = static_cast<std::uint32_t>(kept_links + left_out.size());
  remarks.push_back(fmt::format("of the robot {} of {} links with shapes are asked about, those of {} {}", kept_links,
                                all, place, fmt::join(names, ", ")));
  tell(left_out);
}

}  // namespace sunder::robot
