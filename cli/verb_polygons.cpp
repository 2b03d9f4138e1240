// sunder polygons FILE: do any two polygons meet? Which? How many?
#include <cli/common.h>
#include <cli/plane_picture.h>
#include <cli/polygons_input.h>
#include <cli/progress.h>

#include <sunder/base/error.h>
#include <sunder/io/file.h>
#include <sunder/io/text.h>
#include <sunder/planar/set/polygons_all.h>
#include <sunder/planar/set/polygons_any_json.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <memory>

namespace sunder::cli {

namespace {

using planar::Polygon;
using planar::PolygonsContact;
using planar::PolygonsOptions;

struct Call {
  std::string file;
  bool any = false, all = false, count = false;  // at most one; none: any
  std::string allow = "nothing";
  std::string method = "automatic";
  std::string group, certificate, svg, title;
  bool drop_z = false;
  bool json = false;

  bool lists() const { return all || !svg.empty(); }
};

struct Result {
  std::vector<PolygonsContact> contacts;  // with --any at most one
  std::uint64_t touching = 0, overlapping = 0;
  Cost cost;

  std::uint64_t pairs() const { return touching + overlapping; }
};

using AnyMethod = planar::PolygonsAnswer(std::span<const Polygon>, const PolygonsOptions&);
using AllMethod = planar::PolygonsAllAnswer(std::span<const Polygon>, const PolygonsOptions&);
struct Methods {
  std::string_view name;
  AnyMethod* any;
  AllMethod* all;
};
constexpr std::array<Methods, 5> methods{{{"automatic", planar::polygons_any, planar::polygons_all},
                                          {"boxes", planar::polygons_any_by_boxes, planar::polygons_all_by_boxes},
                                          {"grid", planar::polygons_any_by_grid, planar::polygons_all_by_grid},
                                          {"sweep", planar::polygons_any_by_sweep, planar::polygons_all_by_sweep},
                                          {"scan", planar::polygons_any_by_scan, planar::polygons_all_by_scan}}};

const Methods& methods_by(const std::string& name) {
  for (const Methods& m : methods) {
    if (m.name == name) return m;
  }
  refuse_method(name, "automatic, boxes, grid, sweep, scan");
}

void require_provable(const Call& call) {
  if (call.certificate.empty()) return;
  if (call.lists() || call.count) {
    throw Error(ErrorCode::bad_call, "lists, counts and pictures have no proof; ask whether any two meet",
                "--certificate");
  }
  if (!call.group.empty()) {
    throw Error(ErrorCode::bad_call, "that members of different groups do not meet has no proof yet; leave out one",
                "--group and --certificate");
  }
  if (call.method == "scan") {
    throw Error(ErrorCode::bad_call, "scan writes no certificates; give automatic or sweep", "--method");
  }
}

Result ask(const Call& call, const Methods& by, const PolygonsInput& input) {
  Progress progress("comparing");
  PolygonsOptions options;
  options.allowed = allowed_by(call.allow);
  options.groups = input.groups;
  options.transcript = !call.certificate.empty();
  options.progress = progress.reporter();
  Result result;
  const auto add = [&](const PolygonsContact& contact) {
    ++(contact.contact == Contact::touching ? result.touching : result.overlapping);
    if (call.lists() || !call.count) result.contacts.push_back(contact);
  };
  if (call.lists() || call.count) {
    const planar::PolygonsAllAnswer answer = by.all(input.polygons, options);
    for (const PolygonsContact& contact : answer.contacts) add(contact);
    result.cost = answer.cost;
  } else {
    const planar::PolygonsAnswer answer = by.any(input.polygons, options);
    if (answer.meet()) add(answer.found);
    result.cost = answer.cost;
    if (!call.certificate.empty()) {
      io::write_file_atomically(call.certificate, certificate_text(input.polygons, options.allowed, answer));
    }
  }
  return result;
}

// A point that shows the contact, and in words what it is.
Point2 place_of(const PolygonsInput& input, const PolygonsContact& c) {
  if (c.kind == planar::ContactKind::none)
    return input.polygons[c.i_inside ? c.i : c.j].vertices()[c.i_inside ? c.of_i : c.of_j];
  return planar::common_point_rounded(planar::sorted(input.polygons[c.i].edge(c.of_i)),
                                      planar::sorted(input.polygons[c.j].edge(c.of_j)));
}

std::string shown_by(const PolygonsContact& c) {
  if (c.kind == planar::ContactKind::none) return "a vertex inside";
  switch (c.kind) {
    case planar::ContactKind::shared_endpoint: return "a vertex of both";
    case planar::ContactKind::touch: return "a vertex on an edge";
    case planar::ContactKind::crossing: return "edges that cross";
    default: return "a common border";
  }
}

std::string about(const Point2& p) { return fmt::format("({:.10g}, {:.10g})", p.x, p.y); }

std::string counts_text(const Result& result) {
  std::string text;
  if (result.overlapping > 0) text += fmt::format("{} overlapping", result.overlapping);
  if (result.touching > 0) text += fmt::format("{}{} touching", text.empty() ? "" : ", ", result.touching);
  return text;
}

std::uint64_t edges_of(const PolygonsInput& input) {
  std::uint64_t edges = 0;
  for (const Polygon& polygon : input.polygons) edges += polygon.size();
  return edges;
}

// Requires that a group was asked for.
const std::string& group_of(const PolygonsInput& input, std::uint32_t polygon) {
  return input.file.groups[input.groups[polygon]];
}

constexpr std::size_t most_listed = 20;

std::string human_text(const Call& call, const PolygonsInput& input, const Result& result) {
  std::string text = fmt::format("{}: {}, {}, {}\n", call.file, count_of(input.polygons.size(), "polygon"),
                                 count_of(edges_of(input), "edge"), input.file.format);
  if (!call.group.empty()) {
    text += fmt::format("{}; those of one {} may meet\n", count_of(input.file.groups.size(), "group"), call.group);
  }
  const bool some = result.pairs() > 0;
  text +=
      fmt::format("{} meet{}", some ? "some" : "none", call.allow == "nothing" ? "" : " (" + call.allow + " allowed)");
  if (some && (call.lists() || call.count)) {
    text += fmt::format(": {}: {}", count_of(result.pairs(), "pair"), counts_text(result));
  }
  text += '\n';
  for (std::size_t k = 0; k < std::min(result.contacts.size(), most_listed); ++k) {
    const PolygonsContact& c = result.contacts[k];
    const auto polygon = [&](std::uint32_t i) {
      const std::uint32_t line = input.line(i);
      const std::string group = call.group.empty() ? "" : fmt::format(" of {}", group_of(input, i));
      return fmt::format("{}{}{}", input.name(i), group, line > 0 ? fmt::format(" (line {})", line) : "");
    };
    text += fmt::format("{} {}: {} and {}: {} at about {}\n", call.lists() ? fmt::format("  {}.", k + 1) : " ",
                        name_of(c.contact), polygon(c.i), polygon(c.j), shown_by(c), about(place_of(input, c)));
  }
  if (result.contacts.size() > most_listed) {
    text += fmt::format("  and {} more; --json or --svg have all\n", result.contacts.size() - most_listed);
  }
  for (const std::string& remark : input.file.remarks) text += fmt::format("  remark      {}\n", remark);
  text += fmt::format("  cost        {}\n", count_of(result.cost.probes, "comparison"));
  if (!call.certificate.empty()) text += fmt::format("  proof       {}\n", call.certificate);
  if (!call.svg.empty()) text += fmt::format("  picture     {}\n", call.svg);
  return text;
}

Json report(const Call& call, const PolygonsInput& input, const Result& result) {
  Json json = envelope("polygons", result.pairs() > 0 ? "some" : "none", call.method);
  json["cost"] = to_json(result.cost);
  json["objects"] = Json::array({{{"file", call.file},
                                  {"format", input.file.format},
                                  {"polygons", input.polygons.size()},
                                  {"edges", edges_of(input)}}});
  json["allowed"] = call.allow;
  if (!call.group.empty()) json["group"] = call.group;
  if (call.lists() || call.count) {
    json["count"] = result.pairs();
    json["counts"] = {{"overlapping", result.overlapping}, {"touching", result.touching}};
  }
  json["contacts"] = Json::array();
  for (const PolygonsContact& c : result.contacts) {
    const Point2 p = place_of(input, c);
    Json contact = {{"i", c.i},
                    {"j", c.j},
                    {"contact", name_of(c.contact)},
                    {"shown_by", shown_by(c)},
                    {"point", {p.x, p.y}},
                    {"names", {input.name(c.i), input.name(c.j)}}};
    if (!call.group.empty()) contact["groups"] = {group_of(input, c.i), group_of(input, c.j)};
    json["contacts"].push_back(contact);
  }
  return json;
}

std::string picture(const Call& call, const PolygonsInput& input, const Result& result) {
  std::vector<Point2> seen;
  for (const Polygon& polygon : input.polygons) {
    seen.insert(seen.end(), polygon.vertices().begin(), polygon.vertices().end());
  }
  PlanePicture drawing(seen);
  std::vector<Contact> strongest(input.polygons.size(), Contact::none);
  for (const PolygonsContact& c : result.contacts) {
    for (const std::uint32_t i : {c.i, c.j}) {
      if (strongest[i] != Contact::overlapping) strongest[i] = c.contact;
    }
  }
  for (std::uint32_t i = 0; i < input.polygons.size(); ++i) {
    const Polygon& polygon = input.polygons[i];
    std::vector<std::vector<Point2>> rings;
    for (std::uint32_t r = 0; r < polygon.ring_count(); ++r) {
      rings.emplace_back(polygon.vertices().begin() + polygon.ring_begin(r),
                         polygon.vertices().begin() + polygon.ring_begin(r + 1));
    }
    drawing.polygon(rings, strongest[i] == Contact::none          ? Ink::calm
                           : strongest[i] == Contact::overlapping ? Ink::accent
                                                                  : Ink::second);
  }
  for (const PolygonsContact& c : result.contacts) {
    if (c.contact == Contact::overlapping) drawing.dot(place_of(input, c), Ink::accent);
  }
  drawing.legend(Ink::accent, fmt::format("overlapping {}", result.overlapping));
  drawing.legend(Ink::second, fmt::format("touching {}", result.touching));
  drawing.legend(Ink::calm, "meets no other");
  return drawing.text(call.title.empty() ? "Which of these polygons meet?" : call.title,
                      fmt::format("{}; {}", count_of(input.polygons.size(), "polygon"),
                                  result.pairs() == 0 ? "none meet" : count_of(result.pairs(), "pair") + " meet"));
}

int run(const Call& call) {
  const Methods& by = methods_by(call.method);
  allowed_by(call.allow);
  require_provable(call);
  const PolygonsInput input = read_polygons(call.file, call.drop_z, true, call.group);
  const Result result = ask(call, by, input);
  if (!call.svg.empty()) io::write_file_atomically(call.svg, picture(call, input, result));
  print(call.json ? to_text(report(call, input, result)) : human_text(call, input, result));
  return result.pairs() == 0 ? exit_code::no : exit_code::yes;
}

}  // namespace

void add_polygons(CLI::App& program, int& code) {
  auto call = std::make_shared<Call>();
  CLI::App* verb = program.add_subcommand(
      "polygons", "Do any two polygons of a file, with their insides, meet? Which? Touching and overlapping apart.");
  verb->add_option("FILE", call->file, "simple polygons, with holes: WKT, GeoJSON")->required();
  auto* any = verb->add_flag("--any", call->any, "does any pair meet? (unless told otherwise)");
  auto* all = verb->add_flag("--all", call->all, "list all pairs that meet");
  auto* count = verb->add_flag("--count", call->count, "count the pairs that meet");
  any->excludes(all)->excludes(count);
  all->excludes(count);
  verb->add_option("--allow", call->allow, "what does not count: nothing, shared-endpoint, or touch")
      ->type_name("KIND");
  verb->add_option("--group", call->group,
                   "polygons that are the same in this may meet: feature, a property of the GeoJSON")
      ->type_name("FIELD");
  verb->add_option("--method", call->method, "automatic, boxes, grid, sweep, or scan")->type_name("NAME");
  verb->add_option("--certificate", call->certificate, "write the proof here")->type_name("FILE");
  auto* svg = verb->add_option("--svg", call->svg, "draw the polygons and the pairs that meet here")->type_name("FILE");
  verb->add_option("--title", call->title, "of the picture")->needs(svg);
  verb->add_flag("--drop-z", call->drop_z, "ignore third coordinates");
  verb->add_flag("--json", call->json, "print a report in JSON");
  verb->callback([call, &code] { code = run(*call); });
}

}  // namespace sunder::cli
