#include <sunder/ask/call_words.h>
#include <sunder/ask/report.h>

#include <sunder/base/error.h>
#include <sunder/io/text/file.h>
#include <sunder/io/text/text.h>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <type_traits>
#include <utility>

namespace sunder::ask {

namespace {

constexpr std::array<PairMethod, 6> pair_methods{{SUNDER_METHOD("automatic", solid::polyhedron_polyhedron),
                                                  SUNDER_METHOD("gjk", solid::polyhedron_polyhedron_by_gjk),
                                                  SUNDER_METHOD("hierarchy", solid::polyhedron_polyhedron_by_hierarchy),
                                                  SUNDER_METHOD("bounded", solid::polyhedron_polyhedron_by_bounded),
                                                  SUNDER_METHOD("polar", solid::polyhedron_polyhedron_by_polar),
                                                  SUNDER_METHOD("scan", solid::polyhedron_polyhedron_by_scan)}};

constexpr std::size_t text_width = 120;

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

std::string text_of(const Report& report) {
  std::string text;
  for (const Fact& fact : report.facts) text += fact.text;
  if (!report.cost_text.empty()) text += titled("cost", report.cost_text);
  text += file_line("proof", report.proof);
  if (report.is_proved) text += not_proved_line(report.not_proved);
  return text + file_line("picture", report.picture);
}

Json json_of(const Report& report) {
  Json json{{"sunder", 1},
            {"verb", report.verb},
            {"answer", report.answer},
            {"method", report.method},
            {"function", report.function},
            {"decided_by", report.decided_by},
            {"cost", report.cost ? to_json(*report.cost) : Json(nullptr)},
            {"objects", report.objects},
            {"notes", report.notes}};
  for (const Fact& fact : report.facts) {
    if (!fact.key.empty()) json[fact.key] = fact.json;
  }
  if (report.is_proved) json["not_proved"] = report.not_proved;
  return json;
}

Report told(int code) {
  Report report;
  report.code = code;
  report.is_told = true;
  return report;
}

Json envelope(const Talk& talk, const Json& verb, const Json& answer, const Json& method) {
  Report report{.verb = verb, .answer = answer, .method = method};
  report.notes = talk.notes();
  return json_of(report);
}

Json error_report(const Talk& talk, const Json& verb, std::string_view kind, std::string_view place,
                  std::string_view text) {
  Json json = envelope(talk, verb, nullptr);
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

std::vector<Fact> facts_of(const io::CoordinateSystems& systems) {
  if (systems.declared().empty()) return {};
  return {{"coordinate_systems", to_json(systems), titled("crs", systems.text())}};
}

std::vector<Fact> facts_of(const LeftOutList& left_out) {
  if (left_out.empty()) return {};
  return {{"left_out", to_json(left_out), ""}};
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

void write_proof(const Talk& talk, const std::string& file, const Origin& origin,
                 const std::function<void(ClaimsWriter&)>& write) {
  io::OutputFile out(file, talk.instead(file));
  ClaimsWriter claims([&](std::string_view text) { out.write(text); });
  claims.add_origin(by_this_call(talk, origin));
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
