#include <sunder/ask/report.h>

#include <sunder/base/error.h>
#include <sunder/io/text.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdio>
#include <system_error>
#include <utility>

namespace sunder::ask {

namespace {

struct NamedMethod {
  std::string_view name;
  PairMethod method;
};

constexpr std::array<NamedMethod, 4> pair_methods{{{"automatic", solid::polyhedron_polyhedron},
                                                   {"gjk", solid::polyhedron_polyhedron_by_gjk},
                                                   {"hierarchy", solid::polyhedron_polyhedron_by_hierarchy},
                                                   {"scan", solid::polyhedron_polyhedron_by_scan}}};

constexpr std::size_t text_width = 120;

// What has been said in this call, and whether anything is to be.
struct Said {
  std::vector<std::string> notes;
  bool is_quiet = false, leaves_output = false, has_printed = false;
} said;

bool is_flat(const Json& json) {
  return std::none_of(json.begin(), json.end(), [](const Json& item) { return item.is_structured(); });
}

std::string compact(const Json& json) { return json.dump(-1, ' ', false, Json::error_handler_t::replace); }

// `json` on one line, with blanks: {"a": 1, "b": [2, 3]}.
std::string on_one_line(const Json& json) {
  if (!json.is_structured()) return compact(json);
  std::string text;
  for (const auto& [key, item] : json.items()) {
    text += text.empty() ? "" : ", ";
    text += json.is_object() ? compact(Json(key)) + ": " + on_one_line(item) : on_one_line(item);
  }
  return json.is_object() ? "{" + text + "}" : "[" + text + "]";
}

void append(const Json& json, std::size_t indent, std::string& text) {
  if (!json.is_structured() || json.empty()) {
    text += compact(json);
    return;
  }
  const bool small =
      is_flat(json) || std::all_of(json.begin(), json.end(), [](const Json& item) { return is_flat(item); });
  if (small && indent > 0) {
    std::string line = on_one_line(json);
    if (line.size() + indent <= text_width) {
      text += line;
      return;
    }
  }
  const bool object = json.is_object();
  const std::string margin(indent + 2, ' ');
  text += object ? "{\n" : "[\n";
  bool first = true;
  for (const auto& [key, item] : json.items()) {
    text += (first ? "" : ",\n") + margin;
    if (object) text += compact(Json(key)) + ": ";
    append(item, indent + 2, text);
    first = false;
  }
  text += "\n" + std::string(indent, ' ') + (object ? "}" : "]");
}

}  // namespace

const char* const pose_forms = "tx,ty,tz; or qw,qx,qy,qz,tx,ty,tz; or 12 or 16 numbers of a matrix row by row";

void print(std::string_view text) {
  said.has_printed = true;
  errno = 0;
  const bool written = std::fwrite(text.data(), 1, text.size(), stdout) == text.size() && std::fflush(stdout) == 0;
  if (written) return;
  throw Error(ErrorCode::bad_call,
              fmt::format("cannot be written ({}); check where it goes", std::generic_category().message(errno)),
              "standard output");
}

void be_quiet() { said.is_quiet = true; }
bool is_quiet() { return said.is_quiet; }
void leave_standard_output() { said.leaves_output = true; }
bool is_output_in_use() { return said.leaves_output || said.has_printed; }

void print_for_people(std::string_view text) {
  if (said.is_quiet || said.leaves_output) return;
  std::string shown;
  while (!text.empty()) {
    const std::size_t length = std::min(text.find('\n'), text.size());
    shown += io::one_line(text.substr(0, length));
    if (length < text.size()) shown += '\n';
    text.remove_prefix(std::min(length + 1, text.size()));
  }
  print(shown);
}

void print_error(std::string_view text) {
  const std::string line = fmt::format("sunder: {}\n", io::one_line(text));
  static_cast<void>(std::fwrite(line.data(), 1, line.size(), stderr));
}

void note(std::string_view text) {
  said.notes.push_back(io::one_line(text));
  if (!said.is_quiet) print_error("note: " + said.notes.back());
}

void refuse_method(std::string_view method, std::string_view known) {
  throw Error(ErrorCode::bad_call, fmt::format("there is no method {}; choose one of {}", io::quote(method), known),
              "--method");
}

Allowed allowed_by(std::string_view name) {
  for (const Allowed allowed : {Allowed::nothing, Allowed::shared_endpoint, Allowed::touch}) {
    if (name == name_of(allowed)) return allowed;
  }
  throw Error(
      ErrorCode::bad_call,
      fmt::format("there is nothing named {} to allow; there are nothing, shared-endpoint, touch", io::quote(name)),
      "--allow");
}

PairMethod pair_method(const std::string& name) {
  std::string known;
  for (const auto& [known_name, method] : pair_methods) {
    if (known_name == name) return method;
    known += fmt::format("{}{}", known.empty() ? "" : ", ", known_name);
  }
  refuse_method(name, known);
}

std::vector<double> parse_numbers(std::string_view text, const std::string& place) {
  constexpr std::string_view blanks = " \t";
  std::vector<double> numbers;
  while (true) {
    const std::size_t comma = std::min(text.find(','), text.size());
    std::string_view field = text.substr(0, comma);
    const std::size_t before = numbers.size();
    while (true) {
      field.remove_prefix(std::min(field.find_first_not_of(blanks), field.size()));
      if (field.empty() && numbers.size() > before) break;
      const std::string_view word = field.substr(0, std::min(field.find_first_of(blanks), field.size()));
      double value = 0;
      if (const char* problem = io::parse_number(word, value)) {
        throw Error(ErrorCode::bad_call, io::quote(word) + " " + problem, place);
      }
      numbers.push_back(value);
      field.remove_prefix(word.size());
    }
    if (comma == text.size()) return numbers;
    text.remove_prefix(comma + 1);
  }
}

solid::Pose parse_pose(std::string_view text, const std::string& place) {
  const std::vector<double> n = parse_numbers(text, place);
  try {
    switch (n.size()) {
      case 3: return solid::Pose::from_matrix({1, 0, 0, 0, 1, 0, 0, 0, 1}, {n[0], n[1], n[2]});
      case 7: return solid::Pose::from_quaternion(n[0], n[1], n[2], n[3], {n[4], n[5], n[6]});
      case 12:
        return solid::Pose::from_matrix({n[0], n[1], n[2], n[4], n[5], n[6], n[8], n[9], n[10]}, {n[3], n[7], n[11]});
      case 16: {
        std::array<double, 16> rows;
        std::copy(n.begin(), n.end(), rows.begin());
        return solid::Pose::from_matrix4(rows);
      }
      default: break;
    }
  } catch (const Error& error) {
    throw Error(error.code(), error.what(), place);
  }
  throw Error(ErrorCode::bad_call, fmt::format("a pose of {}; give {}", count_of(n.size(), "number"), pose_forms),
              place);
}

Json envelope(const Json& verb, const Json& answer, const Json& method) {
  return {{"sunder", 1},           {"verb", verb},    {"answer", answer},         {"method", method},
          {"decided_by", nullptr}, {"cost", nullptr}, {"objects", Json::array()}, {"notes", said.notes}};
}

Json error_report(const Json& verb, std::string_view kind, std::string_view place, std::string_view text) {
  Json json = envelope(verb, nullptr);
  json["error"] = {{"kind", kind}, {"place", place}, {"text", io::one_line(text)}};
  return json;
}

Json to_json(const Cost& cost) {
  return {{"probes", cost.probes}, {"iterations", cost.iterations}, {"exact", cost.exact}};
}

Json to_json(const Point3& p) { return Json::array({p.x, p.y, p.z}); }

std::string to_text(const Json& json) {
  std::string text;
  append(json, 0, text);
  return text + "\n";
}

std::string to_line(const Json& json) { return on_one_line(json); }

std::string about(double x) { return fmt::format("{:.4g}", x == 0 ? 0.0 : x); }

std::string about(const Point3& p) { return fmt::format("({}, {}, {})", about(p.x), about(p.y), about(p.z)); }

std::string place_text(const Point2& p) { return fmt::format("({:.10g}, {:.10g})", p.x, p.y); }

}  // namespace sunder::ask
