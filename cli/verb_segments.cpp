// sunder segments FILE: do any two segments meet?
#include <cli/common.h>

#include <sunder/base/error.h>
#include <sunder/io/file.h>
#include <sunder/io/lines.h>
#include <sunder/io/text.h>
#include <sunder/planar/set/segments_any_json.h>

#include <fmt/format.h>

#include <memory>
#include <optional>

namespace sunder::cli {

namespace {

using planar::Allowed;
using planar::Segment;
using planar::Segments;
using planar::SegmentsAnswer;

struct Call {
  std::string file;
  std::string allow = "nothing";
  std::string method = "automatic";
  std::string certificate;
  bool drop_z = false;
  bool json = false;
};

Allowed allowed_by(const std::string& name) {
  for (const Allowed allowed : {Allowed::nothing, Allowed::shared_endpoint, Allowed::touch}) {
    if (name == name_of(allowed)) return allowed;
  }
  throw Error(ErrorCode::bad_call,
              fmt::format("there is nothing named {} to allow; there are nothing, shared-endpoint, "
                          "touch",
                          io::quote(name)),
              "--allow");
}

SegmentsAnswer answer_by(const std::string& method, const Segments& segments, const planar::SegmentsOptions& options) {
  if (method == "automatic") return segments_any(segments, options);
  if (method == "sweep") return segments_any_by_sweep(segments, options);
  if (method == "scan" && !options.transcript) return segments_any_by_scan(segments, options);
  if (method == "scan") {
    throw Error(ErrorCode::bad_call, "scan writes no certificates; give automatic or sweep", "--method");
  }
  throw Error(ErrorCode::bad_call,
              fmt::format("there is no method {}; methods are automatic, sweep, scan", io::quote(method)), "--method");
}

std::string about(const Point2& p) { return fmt::format("({:.10g}, {:.10g})", p.x, p.y); }

std::string place_of(const io::LineFile& file, std::uint32_t i) {
  const io::LineSource& source = file.source[i];
  std::string place = fmt::format("feature {}", file.features[source.feature]);
  if (source.line > 0) place += fmt::format(", line {}", source.line);
  return place;
}

std::string human_text(const Call& call, const io::LineFile& file, const Segments& segments,
                       const SegmentsAnswer& answer) {
  const std::string allowing = call.allow == "nothing" ? "" : fmt::format(" ({} allowed)", call.allow);
  std::string text = fmt::format("{}: {} of {}, {}\n", call.file, count_of(segments.size(), "segment"),
                                 count_of(file.features.size(), "feature"), file.format);
  if (!answer.meet()) {
    text += fmt::format("none meet{}\n", allowing);
  } else {
    text += fmt::format("some meet{}: {} at about {}\n", allowing, name_of(answer.kind),
                        about(planar::common_point_rounded(segments[answer.i], segments[answer.j])));
    for (const std::uint32_t i : {answer.i, answer.j}) {
      text += fmt::format("  segment {}, {}: {} to {}\n", i, place_of(file, i), about(file.segments[i].a),
                          about(file.segments[i].b));
    }
    if (answer.kind == planar::ContactKind::shared_endpoint) {
      text += "  edges that follow each other share an end: to pass over such contacts, give --allow shared-endpoint\n";
    }
  }
  text += fmt::format("  cost        {}\n", count_of(answer.cost.probes, "comparison"));
  if (!call.certificate.empty()) text += fmt::format("  proof       {}\n", call.certificate);
  return text;
}

Json report(const Call& call, const io::LineFile& file, const Segments& segments, const SegmentsAnswer& answer) {
  Json json = envelope("segments", answer.meet() ? "some" : "none", call.method);
  json["cost"] = to_json(answer.cost);
  json["objects"] = {{{"file", call.file},
                      {"format", file.format},
                      {"segments", segments.size()},
                      {"features", file.features.size()}}};
  json["allowed"] = call.allow;
  json["contacts"] = Json::array();
  if (answer.meet()) {
    Json contact = {{"i", answer.i}, {"j", answer.j}, {"kind", name_of(answer.kind)}};
    const Point2 p = planar::common_point_rounded(segments[answer.i], segments[answer.j]);
    contact["point"] = {p.x, p.y};
    for (const std::uint32_t i : {answer.i, answer.j}) {
      const io::LineSource& source = file.source[i];
      contact["features"].push_back(file.features[source.feature]);
      contact["lines"].push_back(source.line > 0 ? Json(source.line) : Json(nullptr));
    }
    json["contacts"].push_back(contact);
  }
  return json;
}

int run(const Call& call) {
  const Allowed allowed = allowed_by(call.allow);
  const io::LineFile file = io::read_lines(call.file, {call.drop_z, {}});
  const Segments segments(file.segments);
  const SegmentsAnswer answer = answer_by(call.method, segments, {allowed, !call.certificate.empty()});
  if (!call.certificate.empty()) {
    io::write_file_atomically(call.certificate, planar::certificate_text(segments, allowed, answer));
  }
  print(call.json ? to_text(report(call, file, segments, answer)) : human_text(call, file, segments, answer));
  return answer.meet() ? exit_code::yes : exit_code::no;
}

}  // namespace

void add_segments(CLI::App& program, int& code) {
  auto call = std::make_shared<Call>();
  CLI::App* verb =
      program.add_subcommand("segments", "Do any two segments of a file meet? Which, or a proof that none do.");
  verb->add_option("FILE", call->file, "segments, lines or polygons: CSV (x1,y1,x2,y2), WKT, GeoJSON")->required();
  verb->add_option("--allow", call->allow, "what does not count: nothing, shared-endpoint, or touch")
      ->type_name("KIND");
  verb->add_option("--method", call->method, "automatic, sweep, or scan")->type_name("NAME");
  verb->add_option("--certificate", call->certificate, "write the proof here")->type_name("FILE");
  verb->add_flag("--drop-z", call->drop_z, "ignore third coordinates");
  verb->add_flag("--json", call->json, "print a report in JSON");
  verb->callback([call, &code] { code = run(*call); });
}

}  // namespace sunder::cli
