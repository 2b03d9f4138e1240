#include <sunder/ask/call_words.h>
#include <sunder/ask/report.h>

#include <sunder/base/error.h>
#include <sunder/io/text/file.h>
#include <sunder/io/text/text.h>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cmath>
#include <cstdio>
#include <system_error>
#include <type_traits>
#include <utility>

namespace sunder::ask {

struct Spoken {
  std::vector<std::string> notes;
  bool is_quiet = false, leaves_output = false, has_printed = false, is_silent = false;
};

namespace {

constexpr std::array<Named<std::remove_pointer_t<PairMethod>>, 5> pair_methods{
    {{"automatic", solid::polyhedron_polyhedron},
     {"gjk", solid::polyhedron_polyhedron_by_gjk},
     {"hierarchy", solid::polyhedron_polyhedron_by_hierarchy},
     {"polar", solid::polyhedron_polyhedron_by_polar},
     {"scan", solid::polyhedron_polyhedron_by_scan}}};

constexpr std::size_t text_width = 120;

Spoken reported;

bool is_flat(const Json& json) {
  return std::none_of(json.items().begin(), json.items().end(), [](const Json& item) { return item.is_structured(); });
}

void append(const Json& json, std::size_t indent, std::string& text) {
  const std::span<const Json> items = json.items();
  const bool small = is_flat(json) || std::all_of(items.begin(), items.end(), is_flat);
  if (json.empty() || (small && indent > 0)) {
    std::string line = json.on_one_line();
    if (json.empty() || line.size() + indent <= text_width) {
      text += line;
      return;
    }
  }
  const std::string margin(indent + 2, ' ');
  text += json.is_object() ? "{\n" : "[\n";
  for (std::size_t k = 0; k < items.size(); ++k) {
    text += (k == 0 ? "" : ",\n") + margin;
    if (json.is_object()) text += json_string(json.keys()[k]) + ": ";
    append(items[k], indent + 2, text);
  }
  text += "\n" + std::string(indent, ' ') + (json.is_object() ? "}" : "]");
}

}  // namespace

Silence::Silence() : before_(std::make_unique<Spoken>(reported)) { reported.is_quiet = reported.is_silent = true; }

Silence::~Silence() { reported = std::move(*before_); }

void print(std::string_view text) {
  if (reported.is_silent) return;
  reported.has_printed = true;
  errno = 0;
  const bool written = std::fwrite(text.data(), 1, text.size(), stdout) == text.size() && std::fflush(stdout) == 0;
  if (written) return;
  throw Error(ErrorCode::bad_call,
              fmt::format("cannot be written ({}); check where it goes", std::generic_category().message(errno)),
              "standard output");
}

void be_quiet() { reported.is_quiet = true; }
bool is_quiet() { return reported.is_quiet; }
void leave_standard_output() { reported.leaves_output = true; }
bool is_output_in_use() { return reported.leaves_output || reported.has_printed; }

void print_for_people(std::string_view text) {
  if (reported.is_quiet || reported.leaves_output) return;
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
  reported.notes.push_back(io::one_line(text));
  if (!reported.is_quiet) print_error("note: " + reported.notes.back());
}

void refuse_method(std::string_view method, std::string_view known) {
  throw Error(ErrorCode::bad_call, fmt::format("there is no method {}; choose one of {}", io::quote(method), known),
              "--method");
}

Allowed allowed_by(std::string_view name, std::span<const Allowed> those) {
  std::string known;
  for (const Allowed allowed : those) {
    if (name == name_of(allowed)) return allowed;
    known += fmt::format("{}{}", known.empty() ? "" : ", ", name_of(allowed));
  }
  throw Error(ErrorCode::bad_call,
              fmt::format("there is nothing named {} to allow; there are {}", io::quote(name), known), "--allow");
}

PairMethod pair_method(const std::string& name, std::string_view more) { return method_by(name, pair_methods, more); }
std::string pair_method_names() { return method_names(pair_methods); }

Json envelope(const Json& verb, const Json& answer, const Json& method) {
  return {{"sunder", 1},           {"verb", verb},    {"answer", answer},         {"method", method},
          {"decided_by", nullptr}, {"cost", nullptr}, {"objects", Json::array()}, {"notes", reported.notes}};
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

Json to_json(const io::CoordinateSystems& systems) {
  Json json = Json::array();
  for (const auto& [system, files, first] : systems.declared()) {
    json.push_back({{"name", system.name}, {"assumed", system.is_assumed}, {"files", files}});
  }
  return json;
}

std::string systems_line(const io::CoordinateSystems& systems) {
  return systems.declared().empty() ? "" : titled("crs", systems.text());
}

void add_systems(const io::CoordinateSystems& systems, Json& report) {
  if (!systems.declared().empty()) report["coordinate_systems"] = to_json(systems);
}

void note_systems(const io::CoordinateSystems& systems) {
  for (const std::string& remark : systems.remarks()) note(remark);
}

Json to_json(const LeftOutList& list) {
  Json json = Json::array();
  for (const LeftOutList::Kind& kind : list.kinds()) {
    json.push_back({{"kind", kind.name}, {"count", kind.count}, {"of", kind.of}});
  }
  return json;
}

std::string to_text(const Json& json) {
  std::string text;
  append(json, 0, text);
  return text + "\n";
}

void write_proof(const std::string& file, const Origin& origin, const std::function<void(ClaimsWriter&)>& write) {
  io::OutputFile out(file);
  ClaimsWriter claims([&](std::string_view text) { out.write(text); });
  claims.add_origin(by_this_call(origin));
  write(claims);
  claims.end();
  out.commit();
}

std::string titled(std::string_view title, std::string value) {
  for (std::size_t end = value.find('\n'); end != std::string::npos; end = value.find('\n', end + 1)) {
    value.insert(end + 1, 14, ' ');
  }
  return fmt::format("  {:<10}  {}\n", title, value);
}

std::string file_line(std::string_view title, const std::string& file, std::string_view clause) {
  return file.empty() ? "" : titled(title, io::one_line(file).append(clause));
}

std::string not_proved_line(std::span<const std::string> words) {
  return words.empty() ? "" : titled("not proved", fmt::format("{}", fmt::join(words, "; ")));
}

std::string about(double x) { return fmt::format("{:.4g}", x == 0 ? 0.0 : x); }

std::string about_length(const Interval& length) {
  const auto [low, high] = length;
  return std::isfinite(high) ? fmt::format("about {:.12g}", high) : fmt::format("at least {:.12g}", low);
}

std::string about(const Point3& p) { return fmt::format("({}, {}, {})", about(p.x), about(p.y), about(p.z)); }

}  // namespace sunder::ask
