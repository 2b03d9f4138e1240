#include <sunder/ask/scene/scene_input.h>

#include <sunder/base/error.h>
#include <sunder/io/robot/scene_file.h>
#include <sunder/io/text/file.h>
#include <sunder/io/text/text.h>

#include <fmt/format.h>

#include <filesystem>
#include <string_view>

namespace sunder::ask {

namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail_call(const std::string& text, const std::string& place) {
  throw Error(ErrorCode::bad_call, text, place);
}

bool is_there(const std::string& file) {
  if (io::GivenFiles::now() != nullptr) return io::is_file(file);
  std::error_code problem;  // a name that is too long, and the like
  return file == "-" || fs::exists(file, problem);
}

}  // namespace

FileWord file_word(const std::string& word) {
  FileWord of{"", word, ""};
  if (const std::size_t at = word.rfind('@'); at != std::string::npos && !is_there(word)) {
    of.file = word.substr(0, at);
    of.pose = word.substr(at + 1);
  }
  const std::size_t equals = of.file.find('=');
  if (equals == std::string::npos || equals == 0 || is_there(of.file)) return of;
  const std::string name = of.file.substr(0, equals);
  if (name.find('/') != std::string::npos) return of;
  return {io::one_line(name), of.file.substr(equals + 1), of.pose};
}

robot::Cell read_cell(Talk& talk, const std::vector<std::string>& files, const std::vector<std::string>& poses,
                      const robot::CellOptions& options, InputFiles* inputs) {
  std::vector<robot::CellFile> named;
  for (const std::string& word : files) {
    const FileWord of = file_word(word);
    named.push_back({of.file, of.name.empty() ? io::one_line(fs::path(of.file).stem().string()) : of.name,
                     of.pose.empty() ? solid::Pose() : parse_pose(of.pose, io::one_line(word))});
  }
  robot::Cell cell =
      noting(talk, [&](std::vector<std::string>& remarks) { return robot::Cell(named, options, inputs, &remarks); });
  for (const std::string& text : poses) {
    const std::size_t equals = text.rfind('=');
    if (equals == std::string::npos) fail_call(io::quote(text) + " is not of the form NAME=POSE", "--pose");
    const std::string name = text.substr(0, equals);
    robot::CellFile& file = cell.file_named(name, "--pose");
    file.pose = parse_pose(std::string_view(text).substr(equals + 1), "--pose " + io::one_line(name));
  }
  return cell;
}

void attach(const std::vector<std::string>& words, robot::Cell& cell) {
  const std::string place = "--attach";
  for (const std::string& word : words) {
    const std::size_t equals = word.find('='), at = word.find('@', equals);
    if (equals == std::string::npos) fail_call(io::quote(word) + " is not of the form NAME=LINK", place);
    const std::string link = word.substr(equals + 1, at == std::string::npos ? at : at - equals - 1);
    std::optional<solid::Pose> pose;
    if (at != std::string::npos) pose = parse_pose(std::string_view(word).substr(at + 1), place);
    cell.attach(word.substr(0, equals), link, place, pose);
  }
}

std::vector<std::array<std::string, 2>> attached_names(const robot::Cell& cell) {
  std::vector<std::array<std::string, 2>> all;
  const auto add = [&](const std::string& name, const std::optional<robot::Attachment>& attached) {
    if (attached) all.push_back({name, cell.robot("").links[attached->link].name});
  };
  for (const robot::CellRobot& robot : cell.robots()) add(robot.name, robot.attached);
  for (const robot::CellBody& body : cell.bodies()) add(body.name, body.attached);
  return all;
}

Json attached_json(const robot::Cell& cell) {
  Json json = Json::array();
  for (const auto& [name, link] : attached_names(cell)) json.push_back({{"name", name}, {"link", link}});
  return json;
}

std::vector<AllowedPair> allowed_by_word(Talk& talk, const robot::Cell& cell, const std::string& word,
                                         InputFiles* inputs) {
  if (word == "adjacent") return cell.adjacent("--allow adjacent");
  const std::size_t comma = word.find(',');
  if (comma != std::string::npos && !is_there(word)) {
    const std::string place = "--allow";
    return {{{cell.body_named(std::string(io::trimmed(std::string_view(word).substr(0, comma))), place),
              cell.body_named(std::string(io::trimmed(std::string_view(word).substr(comma + 1))), place)},
             place}};
  }
  if (!is_there(word)) {
    fail_call("is no file; give adjacent, touch, NAME,NAME, or a file with two names a line",
              "--allow " + io::one_line(word));
  }
  return noting(talk, [&](std::vector<std::string>& remarks) { return cell.pairs_in(word, inputs, remarks); });
}

std::vector<std::vector<Said>> said_of(const robot::Cell& cell, const InputFiles& inputs, bool as_meshes) {
  std::vector<std::vector<Said>> all;
  for (const robot::CellBody& body : cell.bodies()) {
    all.emplace_back();
    for (const io::BodyPart& part : body.parts) {
      const bool is_mesh = !part.round && !robot::is_urdf(part.body.file) && !io::is_scene_file(part.body.file);
      const std::string name = body.parts.size() == 1 ? body.name : body.name + "/" + part.name;
      Said said = is_mesh ? (as_meshes && part.mesh != nullptr ? said_of_triangles : said_of_mesh)(part.body, inputs,
                                                                                                   cell.left_out())
                          : said_of_file(Said::Source::shape, inputs, part.body.file, name);
      all.back().push_back(said.empty() || part.unit.empty() ? said : said.unit(part.unit));
    }
  }
  return all;
}

std::vector<const MeshBody*> meshes_of(const robot::Cell& cell) {
  std::vector<const MeshBody*> all;
  for (const io::BodyPart* part : cell.parts()) {
    if (!part->round) all.push_back(&part->body);
  }
  return all;
}

void note_limits(Talk& talk, const robot::Cell& cell, const std::vector<io::JointValues>& placements) {
  if (!cell.has_robot()) return;
  std::string first;
  std::size_t count = 0;
  for (const io::JointValues& joints : placements) {
    for (const std::string& text : io::beyond_limits(cell.robot("joints"), joints.values)) {
      if (count++ == 0) first = text;
    }
  }
  if (count == 0) return;
  talk.note(first + (count > 1 ? fmt::format("; and {} more values are beyond limits", count - 1) : "") +
            ": it is asked about all the same");
}

}  // namespace sunder::ask
