#include <sunder/ask/scene/scene_input.h>

#include <sunder/base/error.h>
#include <sunder/io/file.h>
#include <sunder/io/joint_values.h>
#include <sunder/io/scene_file.h>
#include <sunder/io/text.h>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>
#include <set>
#include <string_view>
#include <utility>

namespace sunder::ask {

namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail_call(const std::string& text, const std::string& place) {
  throw Error(ErrorCode::bad_call, text, place);
}

bool is_urdf(const std::string& file) { return fs::path(file).extension() == ".urdf" || file.ends_with(".URDF"); }

bool is_there(const std::string& file) {
  if (io::GivenFiles::now() != nullptr) return io::is_file(file);
  std::error_code problem;  // a name that is too long, and the like
  return file == "-" || fs::exists(file, problem);
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

}  // namespace

SceneInput::SceneInput(const std::vector<std::string>& files, const std::vector<std::string>& poses,
                       bool require_convex, bool leave_out, InputFiles* inputs, const io::Packages& packages,
                       io::PartsOf parts)
    : left_out_(leave_out) {
  for (const std::string& word : files) {
    std::string file = word;
    solid::Pose pose;
    const std::size_t at = word.rfind('@');
    if (at != std::string::npos && !is_there(word)) {
      file = word.substr(0, at);
      pose = parse_pose(std::string_view(word).substr(at + 1), io::one_line(word));
    }
    const std::string stem = io::one_line(fs::path(file).stem().string());
    inputs_.push_back({unused_name(stem), pose});
    if (is_urdf(file)) {
      add_robot(file, require_convex, inputs, packages);
    } else if (io::is_scene_file(file)) {
      add_scene(file, require_convex, inputs, parts);
    } else {
      add_mesh(file, require_convex, inputs, parts);
    }
  }
  for (const std::string& text : poses) {
    const std::size_t equals = text.rfind('=');
    if (equals == std::string::npos) fail_call(io::quote(text) + " is not of the form NAME=POSE", "--pose");
    const std::string name = text.substr(0, equals);
    const auto input = named(name, inputs_);
    if (input == inputs_.end()) {
      fail_call("nothing is named " + io::quote(name) + "; names are " + names_of(inputs_), "--pose");
    }
    input->pose = parse_pose(std::string_view(text).substr(equals + 1), "--pose " + io::one_line(name));
  }
  // Told without consent. So far nothing is left out where there is none.
  tell(robot_bodies_.told);
  require_some_body();
}

// Of the robot.
void SceneInput::tell(std::span<const io::LeftOut> left_out) {
  if (left_out.empty()) return;
  if (left_out_.consent()) {
    left_out_.add(robot_file_, left_out, "");
  } else {
    left_out_ = LeftOutList(robot_file_, left_out);
  }
}

// A question about nothing has no answer that could be relied on; but that a robot has no collision shape is known, and
// who says that he knows gets one. (Not so where it has some that are not read: a wrong folder of meshes would be
// none.)
void SceneInput::require_some_body() const {
  if (!bodies_.empty()) return;
  if (robot_ && left_out_.consent() && !io::has_collision_shapes(*robot_)) {
    note("no link of " + io::one_line(robot_file_) + " has a collision shape, so nothing can meet");
    return;
  }
  fail_call(left_out_.empty() ? "no link has a shape, so there is nothing to ask about; give the links <collision> "
                                "shapes, or say that you know: --leave-out"
                              : "there is nothing to ask about; left out: " + left_out_.text(),
            inputs_.back().name);
}

// `wish`, or wish#2, wish#3, ...: no input or body has it.
std::string SceneInput::unused_name(const std::string& wish) const {
  std::string name = wish;
  const auto taken = [&] { return named(name, inputs_) != inputs_.end() || named(name, bodies_) != bodies_.end(); };
  for (int number = 2; taken(); ++number) name = fmt::format("{}#{}", wish, number);
  return name;
}

void SceneInput::add_mesh(const std::string& file, bool require_convex, InputFiles* inputs, io::PartsOf parts) {
  Body body;
  body.name = inputs_.back().name;
  body.input = inputs_.size() - 1;
  for (MeshBody& object : io::read_bodies(file, require_convex, left_out_, inputs, parts)) {
    std::string name = object.name;
    body.parts.push_back({std::move(name), std::move(object), solid::Pose()});
  }
  bodies_.push_back(std::move(body));
}

void SceneInput::add_robot(const std::string& file, bool require_convex, InputFiles* inputs,
                           const io::Packages& packages) {
  if (robot_) fail_call("a second robot; give one URDF file in a call", io::one_line(file));
  robot_ = io::read_urdf(file, inputs);
  robot_file_ = file;
  robot_bodies_ = io::read_robot_bodies(*robot_, file, require_convex, left_out_, inputs, packages);
  meshes_.insert(meshes_.end(), robot_bodies_.meshes.begin(), robot_bodies_.meshes.end());
  take_unit("m", file);
  for (io::LinkBody& body : robot_bodies_.bodies) {
    bodies_.push_back(
        {unused_name(robot_->links[body.link].name), inputs_.size() - 1, body.link, std::move(body.parts)});
  }
}

void SceneInput::add_scene(const std::string& file, bool require_convex, InputFiles* inputs, io::PartsOf parts) {
  const io::SceneFile scene = io::read_scene_file(file, inputs);
  if (!scene.unit.empty()) take_unit(scene.unit, file);
  auto all = io::read_scene_parts(scene, file, require_convex, left_out_, inputs, &meshes_, parts);
  const auto first = static_cast<std::uint32_t>(bodies_.size());
  for (std::size_t b = 0; b < all.size(); ++b) {
    const std::string& name = scene.bodies[b].name;  // as in the file, unless another body has it
    const bool is_taken = named(name, bodies_) != bodies_.end();
    bodies_.push_back({is_taken ? unused_name(name) : name, inputs_.size() - 1, {}, std::move(all[b])});
  }
  for (const auto& [a, b] : scene.allowed) allowed_by_files_.push_back({{first + a, first + b}, io::one_line(file)});
  if (!scene.allowed.empty()) scene_files_.push_back(file);
}

// Lengths of different units are not compared.
void SceneInput::take_unit(const std::string& unit, const std::string& file) {
  if (!unit_.empty() && unit != unit_) {
    fail_call(fmt::format("is in {}, but {} is in {}; scale one of them", unit, io::quote(unit_file_), unit_),
              io::one_line(file));
  }
  unit_ = unit;
  unit_file_ = file;
}

std::vector<scene::Body> SceneInput::bodies(const std::map<std::string, double>& joints) const {
  std::vector<solid::Pose> links;
  if (robot_) {
    links = io::link_poses(*robot_, joints);
  } else if (!joints.empty()) {
    fail_call("there is no robot to move; name a URDF file", "--joints");
  }
  std::vector<scene::Body> placed;
  for (const Body& body : bodies_) {
    const solid::Pose& base = inputs_[body.input].pose;
    try {
      placed.push_back(io::placed_body(body.name, body.parts, body.link ? compose(base, links[*body.link]) : base));
    } catch (const Error& error) {
      throw Error(error.code(), error.what(), body.name);
    }
  }
  return placed;
}

const io::Robot& SceneInput::robot(const std::string& option) const {
  if (!robot_) fail_call("there is no robot to move; name a URDF file", option);
  return *robot_;
}

bool SceneInput::is_hull(std::uint32_t body, std::uint32_t part) const {
  return bodies_[body].parts[part].body.shape == io::BodyShape::hull;
}

std::vector<const io::BodyPart*> SceneInput::parts() const {
  std::vector<const io::BodyPart*> all;
  for (const Body& body : bodies_) {
    for (const io::BodyPart& part : body.parts) all.push_back(&part);
  }
  return all;
}

std::vector<std::vector<Said>> SceneInput::said(const InputFiles& inputs) const {
  std::vector<std::vector<Said>> all;
  for (const Body& body : bodies_) {
    all.emplace_back();
    for (const io::BodyPart& part : body.parts) {
      const bool is_mesh = !part.round && !is_urdf(part.body.file) && !io::is_scene_file(part.body.file);
      const std::string name = body.parts.size() == 1 ? body.name : body.name + "/" + part.name;
      Said said = is_mesh ? said_of_mesh(part.body, inputs, left_out_)
                          : said_of_file(Said::Source::shape, inputs, part.body.file, name);
      all.back().push_back(said.empty() || part.unit.empty() ? said : said.unit(part.unit));
    }
  }
  return all;
}

std::vector<const MeshBody*> SceneInput::meshes() const {
  std::vector<const MeshBody*> all;
  for (const io::BodyPart* part : parts()) {
    if (!part->round) all.push_back(&part->body);
  }
  return all;
}

std::uint32_t SceneInput::body_named(const std::string& name, const std::string& place) const {
  const auto found = named(name, bodies_);
  if (found != bodies_.end()) return static_cast<std::uint32_t>(found - bodies_.begin());
  fail_call("no body is named " + io::quote(name) + "; bodies are " + names_of(bodies_), place);
}

std::vector<AllowedPair> SceneInput::adjacent() const {
  if (!robot_) fail_call("there is no robot whose links could be adjacent; name a URDF file", "--allow adjacent");
  // Of all links, so that those on both sides of one that is left out are not taken for neighbours.
  std::vector<AllowedPair> pairs;
  for (const auto& [a, b] : io::adjacent_bodies(*robot_, robot_bodies_)) {
    const auto body_a = body_of_link(robot_->links[robot_bodies_.bodies[a].link].name),
               body_b = body_of_link(robot_->links[robot_bodies_.bodies[b].link].name);
    if (body_a && body_b) pairs.push_back({{*body_a, *body_b}, "adjacent"});
  }
  return pairs;
}

std::vector<AllowedPair> SceneInput::allowed(const std::string& text, InputFiles* inputs) const {
  if (text == "adjacent") return adjacent();
  const std::size_t comma = text.find(',');
  if (comma != std::string::npos && !is_there(text)) {
    const std::string place = "--allow";
    return {{{body_named(std::string(io::trimmed(std::string_view(text).substr(0, comma))), place),
              body_named(std::string(io::trimmed(std::string_view(text).substr(comma + 1))), place)},
             place}};
  }
  if (!is_there(text)) {
    fail_call("is no file; give adjacent, touch, NAME,NAME, or a file with two names a line",
              "--allow " + io::one_line(text));
  }
  std::vector<AllowedPair> pairs;
  std::vector<std::string> shapeless;
  for (const auto& [place, names] : io::read_name_pairs(text, inputs)) {
    bool both = true;
    for (const std::string& name : names) {
      if (named(name, bodies_) != bodies_.end() || !is_link(name)) continue;
      if (!is_outside(name)) add_once(name, shapeless);
      both = false;
    }
    if (both) pairs.push_back({{body_named(names[0], place), body_named(names[1], place)}, io::one_line(text)});
  }
  if (!shapeless.empty()) {
    note(fmt::format("{}: lines about links without a shape are passed over: {}", io::one_line(text),
                     listed(shapeless)));
  }
  return pairs;
}

bool SceneInput::is_link(const std::string& name) const {
  return robot_ && named(name, robot_->links) != robot_->links.end();
}

bool SceneInput::is_outside(const std::string& name) const {
  return std::find(outside_.begin(), outside_.end(), name) != outside_.end();
}

std::optional<std::uint32_t> SceneInput::body_of_link(const std::string& name) const {
  for (std::uint32_t b = 0; b < bodies_.size(); ++b) {
    if (bodies_[b].link && robot_->links[*bodies_[b].link].name == name) return b;
  }
  return std::nullopt;
}

std::vector<AllowedPair> SceneInput::allowed(const io::Srdf& srdf, const std::string& file) const {
  if (!robot_) fail_call("there is no robot that this could be about; name a URDF file", "--srdf");
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
  note(fmt::format("{} allows {}", shown, io::reasons_text(taken)));
  if (!shapeless.empty()) {
    note(fmt::format("{}: pairs of links without a shape are passed over: {}", shown, listed(shapeless)));
  }
  if (!unknown.empty()) {
    note(fmt::format("{}: pairs of links that the robot does not have are passed over: {}", shown, listed(unknown)));
  }
  std::sort(pairs.begin(), pairs.end(), [](const AllowedPair& p, const AllowedPair& q) { return p.bodies < q.bodies; });
  return pairs;
}

void SceneInput::keep_groups(const io::Srdf& srdf, const std::vector<std::string>& names) {
  const char* const place = "--group";
  if (!robot_) fail_call("there is no robot that this could be about; name a URDF file", place);
  std::vector<std::string> remarks;
  const std::vector<std::uint32_t> links = io::group_links(srdf, *robot_, names, place, remarks);
  for (const std::string& remark : remarks) note(remark);
  std::vector<io::LeftOut> left_out;
  std::vector<std::uint32_t> numbers(bodies_.size());  // of the bodies that stay
  std::uint32_t kept = 0, kept_links = 0;
  for (std::uint32_t b = 0; b < bodies_.size(); ++b) {
    Body& body = bodies_[b];
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
  note(fmt::format("of the robot {} of {} links with shapes are asked about, those of --group {}", kept_links, all,
                   fmt::join(names, ", ")));
  tell(left_out);
}

io::JointValues SceneInput::state(const io::Srdf& srdf, const std::string& text) const {
  if (!robot_) fail_call("there is no robot to move; name a URDF file", "--state");
  std::vector<std::string> remarks;
  io::JointValues joints = io::state_values(srdf, *robot_, text, "--state", remarks);
  for (const std::string& remark : remarks) note(remark);
  return joints;
}

void SceneInput::note_limits(const std::vector<io::JointValues>& placements) const {
  if (!robot_) return;
  std::string first;
  std::size_t count = 0;
  for (const io::JointValues& joints : placements) {
    for (const std::string& text : io::beyond_limits(*robot_, joints.values)) {
      if (count++ == 0) first = text;
    }
  }
  if (count == 0) return;
  note(first + (count > 1 ? fmt::format("; and {} more values are beyond limits", count - 1) : "") +
       ": it is asked about all the same");
}

}  // namespace sunder::ask
