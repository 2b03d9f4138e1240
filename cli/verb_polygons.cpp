// sunder polygons FILE: do any two polygons meet? Which? How many?
#include <cli/common.h>
#include <cli/left_out.h>
#include <cli/list_stream.h>
#include <cli/polygons_input.h>
#include <cli/polygons_report.h>
#include <cli/progress.h>

#include <sunder/base/error.h>
#include <sunder/io/file.h>
#include <sunder/io/text.h>
#include <sunder/planar/set/polygons_all.h>
#include <sunder/planar/set/polygons_json.h>

#include <fmt/format.h>
#include <CLI/App.hpp>

#include <algorithm>
#include <array>
#include <memory>
#include <optional>
#include <vector>

namespace sunder::cli {

namespace {

using planar::Polygon;
using planar::PolygonsContact;

using Call = PolygonsCall;
using Result = PolygonsResult;

using AnyMethod = planar::PolygonsAnswer(std::span<const Polygon>, const SetOptions&);
struct Methods {
  std::string_view name;
  AnyMethod* any;
  planar::PolygonsFinder* find;
};
constexpr std::array<Methods, 5> methods{{{"automatic", planar::polygons_any, planar::find_contacts_by_boxes},
                                          {"boxes", planar::polygons_any_by_boxes, planar::find_contacts_by_boxes},
                                          {"grid", planar::polygons_any_by_grid, planar::find_contacts_by_grid},
                                          {"sweep", planar::polygons_any_by_sweep, planar::find_contacts_by_sweep},
                                          {"scan", planar::polygons_any_by_scan, planar::find_contacts_by_scan}}};

const Methods& methods_by(const std::string& name) {
  for (const Methods& m : methods) {
    if (m.name == name) return m;
  }
  refuse_method(name, "automatic, boxes, grid, sweep, scan");
}

void require_provable(const Call& call) {
  if (!call.certificate.empty() && call.method == "scan") {
    throw Error(ErrorCode::bad_call, "scan writes no certificates; give automatic or sweep", "--method");
  }
}

constexpr std::uint64_t most_proved = 10'000'000;  // pairs, and numbers of a sweep

[[noreturn]] void refuse_proof(const PolygonsInput& input, const std::string& what, std::uint64_t numbers) {
  const std::size_t digits = std::to_string(input.edges()).size();
  throw Error(ErrorCode::bad_call,
              fmt::format("{}, and the proof would have {:.1f} GB or more; leave it out, or ask about less", what,
                          static_cast<double>(numbers * (digits + 1)) / 1e9),
              "--certificate");
}

// The sweep that proves all answers but `some`.
planar::SweepEvents sweep_of(const PolygonsInput& input, const Result& result) {
  if (result.pairs() > most_proved) {
    refuse_proof(input, fmt::format("{} pairs meet, more than {}", result.pairs(), most_proved), 2 * result.pairs());
  }
  Progress progress("proving");
  const std::uint64_t most = std::max(most_proved, 8 * input.edges());  // six for an edge, where none cross
  std::optional<planar::SweepEvents> events = planar::polygon_events(input.polygons, most);
  if (!events) refuse_proof(input, "edges cross, so that their sweep is long", most);
  return std::move(*events);
}

void prove(const Call& call, const PolygonsInput& input, const Result& result) {
  const planar::PolygonsAsked asked{input.polygons, allowed_by(call.allow), input.groups};
  const bool is_some = !call.lists() && !call.count && result.pairs() > 0;
  const planar::SweepEvents events = is_some ? planar::SweepEvents() : sweep_of(input, result);
  io::OutputFile out(call.certificate);
  ClaimsWriter file([&](std::string_view text) { out.write(text); });
  file.add_origin(input.origin());
  if (is_some) {
    write_some(file, asked, *result.found);
  } else if (call.lists()) {
    write_these(file, asked, events, [&](const auto& take) {
      result.visit([&](const PolygonsContact& c) {
        take(c.i, c.j);
        return true;
      });
    });
  } else if (call.count) {
    write_count(file, asked, events, result.pairs());
  } else {
    write_none(file, asked, events);
  }
  file.end();
  out.commit();
}

Result ask(const Call& call, const Methods& by, const PolygonsInput& input) {
  Progress progress("comparing");
  SetOptions options;
  options.allowed = allowed_by(call.allow);
  options.groups = input.groups;
  options.progress = progress.reporter();
  Result result;
  if (call.count && !call.lists() && call.method == "automatic") {
    const planar::PolygonsCountAnswer answer = planar::polygons_count(input.polygons, options);
    result.touching = answer.touching;
    result.overlapping = answer.overlapping;
    result.cost = answer.cost;
  } else if (call.lists() || call.count) {
    result.contacts = std::make_unique<planar::PolygonContactsInOrder>(input.polygons, options, by.find);
    result.touching = result.contacts->touching();
    result.overlapping = result.contacts->overlapping();
    result.cost = result.contacts->cost();
  } else {
    const planar::PolygonsAnswer answer = by.any(input.polygons, options);
    result.found = answer.found;
    result.touching = answer.meet() && answer.found->contact == Contact::touching ? 1 : 0;
    result.overlapping = answer.meet() ? 1 - result.touching : 0;
    result.cost = answer.cost;
  }
  return result;
}

constexpr std::size_t most_listed = 20;

// Goes through the contacts once, and writes all that was asked for.
void write(const Call& call, const PolygonsInput& input, const Result& result) {
  std::optional<GeojsonFile> geojson;
  if (!call.geojson.empty()) geojson.emplace(call.geojson);
  std::optional<ListReport> json;
  if (call.json) json.emplace(report(call, input, result), "contacts");
  std::vector<PolygonsContact> listed, drawn;
  const auto take = [&](const PolygonsContact& contact) {
    if (json) json->add(to_line(to_json(call, input, contact)));
    if (geojson) geojson->add(contact_feature(call, input, contact, geojson->count() + 1));
    if (!call.svg.empty()) drawn.push_back(contact);
    if (listed.size() < most_listed) listed.push_back(contact);
    return json || geojson || !call.svg.empty() || listed.size() < most_listed;
  };
  if (!call.count || call.lists()) result.visit(take);
  if (geojson) geojson->close();
  if (!call.svg.empty()) io::write_file_atomically(call.svg, picture(call, input, result, drawn));
  if (json) {
    json->close();
  } else {
    print_for_people(human_text(call, input, result, listed));
  }
}

int run(const Call& call) {
  const Methods& by = methods_by(call.method);
  allowed_by(call.allow);
  if (call.files.size() > 2) {
    throw Error(ErrorCode::bad_call, "three files or more; give one, or two to ask for pairs across them", "FILE");
  }
  require_provable(call);
  PolygonsRequest request;
  request.files = call.files;
  request.drop_z = call.drop_z;
  request.leave_out = call.leave_out;
  request.skip_invalid = call.skip_invalid;
  request.mend = call.mend;
  request.rule = call.self_touch ? planar::PolygonRule::self_touch : planar::PolygonRule::valid;
  request.group = call.group;
  request.name = call.name;
  request.tell_inputs = !call.certificate.empty();
  const PolygonsInput input = read_polygons(request);
  const auto require_drawable = [&](std::uint64_t contacts) {
    if (!call.svg.empty()) cli::require_drawable(input.edges(), "edge", contacts, call.svg_limit);
  };
  require_drawable(0);
  const Result result = ask(call, by, input);
  require_drawable(result.pairs());
  if (!call.certificate.empty()) prove(call, input, result);
  write(call, input, result);
  return result.pairs() == 0 ? exit_code::no : exit_code::yes;
}

}  // namespace

void add_polygons(CLI::App& program, int& code) {
  auto call = std::make_shared<Call>();
  CLI::App* verb = program.add_subcommand(
      "polygons", "Do any two polygons of a file, with their insides, meet? Which? Touching and overlapping apart.");
  verb->add_option("FILE", call->files, "polygons, with holes and parts: WKT, GeoJSON; of two files, pairs across them")
      ->required();
  auto* any = verb->add_flag("--any", call->any, "does any pair meet? (unless told otherwise)");
  auto* all = verb->add_flag("--all", call->all, "list all pairs that meet");
  auto* count = verb->add_flag("--count", call->count, "count the pairs that meet");
  any->excludes(all)->excludes(count);
  all->excludes(count);
  verb->add_option("--allow", call->allow, "what does not count: nothing, shared-endpoint, or touch")
      ->type_name("KIND");
  verb->add_option("--group", call->group, "features that are the same in this may meet: a property of the GeoJSON")
      ->type_name("FIELD");
  verb->add_option("--name", call->name, name_help)->type_name("FIELD");
  verb->add_flag("--skip-invalid", call->skip_invalid, skip_invalid_help);
  verb->add_flag("--self-touch", call->self_touch, "take rings that touch themselves in points");
  verb->add_flag("--mend", call->mend, mend_help);
  verb->add_flag("--leave-out", call->leave_out, leave_out_help);
  verb->add_option("--method", call->method, "automatic, boxes, grid, sweep, or scan")->type_name("NAME");
  verb->add_option("--certificate", call->certificate, "write the proof here")->type_name("FILE");
  verb->add_option("--geojson", call->geojson, "write all contacts here, to lay over a map")->type_name("FILE");
  auto* svg = verb->add_option("--svg", call->svg, "draw the polygons and the pairs that meet here")->type_name("FILE");
  verb->add_option("--title", call->title, "of the picture")->needs(svg);
  add_svg_limit(*verb, call->svg_limit);
  verb->add_flag("--drop-z", call->drop_z, "ignore third coordinates");
  verb->add_flag("--json", call->json, "print a report in JSON");
  verb->callback([call, &code] { code = run(*call); });
}

}  // namespace sunder::cli
