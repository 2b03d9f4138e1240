#include <sunder/ask/scene/scene_input.h>

#include <sunder/base/error.h>
#include <sunder/io/file.h>
#include <sunder/io/text.h>
#include <sunder/io/urdf_kinematics.h>

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
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
  std::error_code problem;  // a name that is too long, and the like
  return file == "-" || fs::exists(file, problem);
}

// "name=value" or "name value".
void add_joint(std::string_view text, const std::string& place, Placement& placement) {
  const std::size_t between = text.find_first_of("= \t");
  if (between == std::string_view::npos || between == 0) {
    fail_call(io::quote(text) + " is no joint with a value; write name=value", place);
  }
  const std::string name(text.substr(0, between));
  std::string_view word = io::trimmed(text.substr(between));
  if (word.starts_with('=')) word = io::trimmed(word.substr(1));
  double value = 0;
  if (const char* problem = io::parse_number(word, value)) {
    fail_call("joint " + io::quote(name) + ": " + io::quote(word) + " " + problem, place);
  }
  if (!placement.joints.emplace(name, value).second) fail_call("joint " + io::quote(name) + " comes twice", place);
}

// The lines of a text without comments and blanks around them, with their numbers; empty ones left out.
std::vector<std::pair<std::size_t, std::string>> lines_of(std::string_view text) {
  std::vector<std::pair<std::size_t, std::string>> lines;
  for (std::size_t number = 1; !text.empty(); ++number) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    std::string_view line = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    line = io::trimmed(line.substr(0, line.find('#')));
    if (!line.empty()) lines.emplace_back(number, line);
  }
  return lines;
}

}  // namespace

Placement parse_joints(const std::string& text) {
  Placement placement;
  std::string_view rest = text;
  const std::size_t colon = rest.find(':');
  if (colon < rest.find('=')) {
    placement.name = io::one_line(io::trimmed(rest.substr(0, colon)));
    rest.remove_prefix(colon + 1);
  }
  while (!io::trimmed(rest).empty()) {
    const std::size_t comma = std::min(rest.find(','), rest.size());
    add_joint(io::trimmed(rest.substr(0, comma)), "--joints", placement);
    rest.remove_prefix(std::min(comma + 1, rest.size()));
  }
  return placement;
}

Placement read_joints(const std::string& file, InputFiles* inputs) {
  Placement placement;
  placement.name = io::one_line(fs::path(file).stem().string());
  for (const auto& [number, line] : lines_of(io::read_file(file, inputs))) {
    add_joint(line, fmt::format("{}:{}", io::one_line(file), number), placement);
  }
  return placement;
}

SceneInput::SceneInput(const std::vector<std::string>& files, const std::vector<std::string>& poses,
                       bool require_convex, bool leave_out, InputFiles* inputs)
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
      add_robot(file, require_convex, inputs);
    } else {
      add_mesh(file, require_convex, inputs);
    }
  }
  for (const std::string& text : poses) {
    const std::size_t equals = text.rfind('=');
    if (equals == std::string::npos) fail_call(io::quote(text) + " is not of the form NAME=POSE", "--pose");
    const std::string name = text.substr(0, equals);
    const auto input = std::find_if(inputs_.begin(), inputs_.end(), [&](const Input& i) { return i.name == name; });
    if (input == inputs_.end()) {
      std::string known;
      for (const Input& i : inputs_) known += (known.empty() ? "" : ", ") + i.name;
      fail_call("nothing is named " + io::quote(name) + "; names are " + known, "--pose");
    }
    input->pose = parse_pose(std::string_view(text).substr(equals + 1), "--pose " + io::one_line(name));
  }
  require_some_body();
}

// A question about nothing has no answer that could be relied on.
void SceneInput::require_some_body() const {
  if (!bodies_.empty()) return;
  fail_call(left_out_.empty()
                ? "no link has a shape, so there is nothing to ask about; give the links <collision> shapes"
                : "there is nothing to ask about; left out: " + left_out_.text(),
            inputs_.back().name);
}

// `wish`, or wish#2, wish#3, ...: no input or body has it.
std::string SceneInput::unused_name(const std::string& wish) const {
  std::string name = wish;
  const auto taken = [&] {
    return std::any_of(inputs_.begin(), inputs_.end(), [&](const Input& i) { return i.name == name; }) ||
           std::any_of(bodies_.begin(), bodies_.end(), [&](const Body& b) { return b.name == name; });
  };
  for (int number = 2; taken(); ++number) name = fmt::format("{}#{}", wish, number);
  return name;
}

void SceneInput::add_mesh(const std::string& file, bool require_convex, InputFiles* inputs) {
  Body body;
  body.name = inputs_.back().name;
  body.input = inputs_.size() - 1;
  for (MeshBody& object : io::read_bodies(file, require_convex, left_out_, inputs)) {
    std::string name = object.name;
    body.parts.push_back({std::move(name), std::move(object), solid::Pose()});
  }
  bodies_.push_back(std::move(body));
}

void SceneInput::add_robot(const std::string& file, bool require_convex, InputFiles* inputs) {
  if (robot_) fail_call("a second robot; give one URDF file in a call", io::one_line(file));
  robot_ = io::read_urdf(file, inputs);
  robot_bodies_ = io::read_robot_bodies(*robot_, file, require_convex, left_out_, inputs);
  first_of_robot_ = static_cast<std::uint32_t>(bodies_.size());
  for (io::LinkBody& body : robot_bodies_.bodies) {
    bodies_.push_back(
        {unused_name(robot_->links[body.link].name), inputs_.size() - 1, body.link, std::move(body.parts)});
  }
}

std::vector<scene::Body> SceneInput::bodies(const Placement& placement) const {
  std::vector<solid::Pose> links;
  if (robot_) {
    links = io::link_poses(*robot_, placement.joints);
  } else if (!placement.joints.empty()) {
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

std::vector<std::vector<bool>> SceneInput::are_hulls() const {
  std::vector<std::vector<bool>> all;
  for (const Body& body : bodies_) {
    all.emplace_back();
    for (const io::BodyPart& part : body.parts) all.back().push_back(part.body.shape == io::BodyShape::hull);
  }
  return all;
}

std::vector<const MeshBody*> SceneInput::objects() const {
  std::vector<const MeshBody*> all;
  for (const Body& body : bodies_) {
    for (const io::BodyPart& part : body.parts) all.push_back(&part.body);
  }
  return all;
}

std::uint32_t SceneInput::body_named(const std::string& name, const std::string& place) const {
  const auto found = std::find_if(bodies_.begin(), bodies_.end(), [&](const Body& b) { return b.name == name; });
  if (found != bodies_.end()) return static_cast<std::uint32_t>(found - bodies_.begin());
  std::string known;
  for (const Body& body : bodies_) known += (known.empty() ? "" : ", ") + body.name;
  fail_call("no body is named " + io::quote(name) + "; bodies are " + known, place);
}

std::vector<std::array<std::uint32_t, 2>> SceneInput::adjacent() const {
  if (!robot_) fail_call("there is no robot whose links could be adjacent; name a URDF file", "--allow adjacent");
  auto pairs = io::adjacent_bodies(*robot_, robot_bodies_);
  for (auto& [a, b] : pairs) {
    a += first_of_robot_;
    b += first_of_robot_;
  }
  return pairs;
}

std::vector<std::array<std::uint32_t, 2>> SceneInput::allowed(const std::string& text) const {
  if (text == "adjacent") return adjacent();
  const std::size_t comma = text.find(',');
  if (comma != std::string::npos && !is_there(text)) {
    const std::string place = "--allow";
    return {{body_named(std::string(io::trimmed(std::string_view(text).substr(0, comma))), place),
             body_named(std::string(io::trimmed(std::string_view(text).substr(comma + 1))), place)}};
  }
  if (!is_there(text)) {
    fail_call("is no file; give adjacent, touch, NAME,NAME, or a file with two names a line",
              "--allow " + io::one_line(text));
  }
  std::vector<std::array<std::uint32_t, 2>> pairs;
  for (const auto& [number, line] : lines_of(io::read_file(text))) {
    const std::string place = fmt::format("{}:{}", io::one_line(text), number);
    const std::size_t between = line.find_first_of(" \t,");
    const std::string first = line.substr(0, between);
    const std::string second =
        between == std::string::npos ? "" : line.substr(std::min(line.find_first_not_of(" \t,", between), line.size()));
    if (second.empty()) fail_call("expected two names of bodies, found one", place);
    pairs.push_back({body_named(first, place), body_named(second, place)});
  }
  return pairs;
}

}  // namespace sunder::ask
