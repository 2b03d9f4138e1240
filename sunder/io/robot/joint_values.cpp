#include <sunder/io/robot/joint_values.h>
#include <sunder/io/text/file.h>
#include <sunder/io/text/text.h>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>

namespace sunder::io {

namespace {

// "name=value" or "name value".
void add_joint(std::string_view text, const std::string& place, JointValues& joints) {
  const std::size_t between = text.find_first_of("= \t");
  if (between == std::string_view::npos || between == 0) {
    fail_call(quote(text) + " is no joint with a value; write name=value", place);
  }
  const std::string name(text.substr(0, between));
  std::string_view word = trimmed(text.substr(between));
  if (word.starts_with('=')) word = trimmed(word.substr(1));
  double value = 0;
  if (const char* problem = parse_number(word, value)) {
    fail_call("joint " + quote(name) + ": " + quote(word) + " " + problem, place);
  }
  if (!joints.values.emplace(name, value).second) fail_call("joint " + quote(name) + " comes twice", place);
}

// The lines of a file without comments and blanks around them, with their places; empty ones left out.
std::vector<std::pair<std::string, std::string>> lines_of(const std::string& file, InputFiles* inputs) {
  std::vector<std::pair<std::string, std::string>> lines;
  const std::string whole = read_file(file, inputs);
  std::string_view text = whole;
  for (std::size_t number = 1; !text.empty(); ++number) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    std::string_view line = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    line = trimmed(line.substr(0, line.find('#')));
    if (!line.empty()) lines.emplace_back(fmt::format("{}:{}", one_line(file), number), line);
  }
  return lines;
}

}  // namespace

JointValues parse_joint_values(std::string_view text, const std::string& place) {
  JointValues joints;
  const std::size_t colon = text.find(':');
  if (colon < text.find('=')) {
    joints.name = one_line(trimmed(text.substr(0, colon)));
    text.remove_prefix(colon + 1);
  }
  while (!trimmed(text).empty()) {
    const std::size_t comma = std::min(text.find(','), text.size());
    add_joint(trimmed(text.substr(0, comma)), place, joints);
    text.remove_prefix(std::min(comma + 1, text.size()));
  }
  return joints;
}

JointValues read_joint_values(const std::string& file, InputFiles* inputs) {
  JointValues joints{one_line(std::filesystem::path(file).stem().string()), {}};
  for (const auto& [place, line] : lines_of(file, inputs)) add_joint(line, place, joints);
  return joints;
}

std::vector<std::pair<std::string, std::array<std::string, 2>>> read_name_pairs(const std::string& file,
                                                                                InputFiles* inputs) {
  std::vector<std::pair<std::string, std::array<std::string, 2>>> pairs;
  for (const auto& [place, line] : lines_of(file, inputs)) {
    const std::size_t between = line.find_first_of(" \t,");
    const std::size_t second = line.find_first_not_of(" \t,", between);
    if (between == std::string::npos || second == std::string::npos) {
      fail_call("expected two names of bodies, found one", place);
    }
    pairs.push_back({place, {line.substr(0, between), line.substr(second)}});
  }
  return pairs;
}

std::string longer_names(const std::string& name, std::span<const std::string> names) {
  std::vector<std::string> longer;
  for (const std::string& each : names) {
    if (each.ends_with("/" + name)) longer.push_back(each);
  }
  return longer.size() < 2 ? "" : fmt::format("{}", fmt::join(longer, " and "));
}

}  // namespace sunder::io
