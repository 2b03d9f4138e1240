// sunder polygons FILE: do any two polygons meet? Which? How many?
#include <cli/common.h>
#include <cli/left_out.h>
#include <cli/polygons_input.h>
#include <cli/polygons_report.h>
#include <cli/progress.h>

#include <sunder/base/error.h>
#include <sunder/certificate/json.h>
#include <sunder/io/file.h>
#include <sunder/io/text.h>
#include <sunder/planar/set/polygons_all.h>
#include <sunder/planar/set/polygons_any_json.h>

#include <fmt/format.h>

#include <array>
#include <memory>

namespace sunder::cli {

namespace {

using planar::Polygon;
using planar::PolygonsContact;
using planar::PolygonsOptions;

using Call = PolygonsCall;
using Result = PolygonsResult;

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
  if (call.groups()) {
    throw Error(ErrorCode::bad_call, "that members of different groups do not meet has no proof yet; leave out one",
                "--group and --certificate");
  }
  if (call.files.size() > 1) {
    throw Error(ErrorCode::bad_call,
                "that those of two files do not meet has no proof yet; give one file, or leave it out",
                "--certificate");
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
  if (call.count && !call.lists() && call.method == "automatic") {
    const planar::PolygonsCountAnswer answer = planar::polygons_count(input.polygons, options);
    result.touching = answer.touching;
    result.overlapping = answer.overlapping;
    result.cost = answer.cost;
  } else if (call.lists() || call.count) {
    const planar::PolygonsAllAnswer answer = by.all(input.polygons, options);
    for (const PolygonsContact& contact : answer.contacts) add(contact);
    result.cost = answer.cost;
  } else {
    const planar::PolygonsAnswer answer = by.any(input.polygons, options);
    if (answer.meet()) add(answer.found);
    result.cost = answer.cost;
    if (!call.certificate.empty()) {
      const std::string text = certificate_text(input.polygons, options.allowed, answer);
      io::write_file_atomically(call.certificate, with_note(text, input.note()));
    }
  }
  return result;
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
  const PolygonsInput input = read_polygons(request);
  const Result result = ask(call, by, input);
  if (!call.geojson.empty()) io::write_file_atomically(call.geojson, contacts_geojson(call, input, result));
  if (!call.svg.empty()) io::write_file_atomically(call.svg, picture(call, input, result));
  call.json ? print(to_text(report(call, input, result))) : print_for_people(human_text(call, input, result));
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
  verb->add_flag("--drop-z", call->drop_z, "ignore third coordinates");
  verb->add_flag("--json", call->json, "print a report in JSON");
  verb->callback([call, &code] { code = run(*call); });
}

}  // namespace sunder::cli
