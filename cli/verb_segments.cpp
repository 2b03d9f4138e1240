// sunder segments FILE: do any two segments meet? Which? How many?
#include <cli/common.h>
#include <cli/contacts_geojson.h>
#include <cli/left_out.h>
#include <cli/list_stream.h>
#include <cli/outputs.h>
#include <cli/progress.h>
#include <cli/segments_picture.h>

#include <sunder/base/error.h>
#include <sunder/certificate/claims.h>
#include <sunder/certificate/origin.h>
#include <sunder/io/file.h>
#include <sunder/io/lines.h>
#include <sunder/io/text.h>
#include <sunder/planar/set/segments_all.h>
#include <sunder/planar/set/segments_json.h>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <CLI/App.hpp>

#include <algorithm>
#include <array>
#include <filesystem>
#include <memory>
#include <numeric>
#include <optional>

namespace sunder::cli {

namespace {

using planar::ContactKind;
using planar::Segment;
using planar::Segments;
using planar::SegmentsAnswer;

struct Call {
  std::string file;
  bool any = false, all = false, count = false;  // at most one; none: any
  std::string group, layer, name;
  bool across_layers = false, centre_lines = false;
  std::string allow = "nothing";
  std::string method = "automatic";
  std::string certificate, geojson, svg, title;
  std::uint64_t svg_limit = most_drawn;  // segments and contacts
  bool drop_z = false, leave_out = false;
  bool json = false;

  // A picture and a GeoJSON show all.
  bool lists() const { return all || !geojson.empty() || !svg.empty(); }
};

// What is asked about together: all of a file, or one layer of it.
struct Sheet {
  std::vector<std::uint32_t> members;  // segments of the file
  Segments segments;
  std::vector<std::uint32_t> groups;
  std::string layer;  // its name, where it is one of several sheets
};

constexpr std::uint64_t most_proved = 10'000'000;  // pairs that a proof tells of

using planar::SegmentsContact;
using Contacts = ContactsInOrder<SegmentsContact>;

struct Result {
  std::unique_ptr<Contacts> contacts;     // by numbers of the file, with --any at most one; with --count null
  std::array<std::uint64_t, 5> number{};  // of contacts, by kind
  std::vector<std::string> proofs;        // files written
  Cost cost;

  void add(ContactKind kind) { ++number.at(static_cast<std::size_t>(kind)); }
  std::uint64_t count() const { return std::accumulate(number.begin(), number.end(), std::uint64_t{0}); }
  bool some() const { return count() > 0; }
  bool all_are(ContactKind kind) const { return some() && number.at(static_cast<std::size_t>(kind)) == count(); }
};

using AnyMethod = SegmentsAnswer(const Segments&, const SetOptions&);
AnyMethod* any_method(const std::string& name) {
  if (name == "automatic") return planar::segments_any;
  if (name == "grid") return planar::segments_any_by_grid;
  if (name == "sweep") return planar::segments_any_by_sweep;
  if (name == "bentley-ottmann") return planar::segments_any_by_bentley_ottmann;
  if (name == "scan") return planar::segments_any_by_scan;
  refuse_method(name, "automatic, grid, sweep, bentley-ottmann, scan");
}
planar::SegmentsMethod* contact_method(const std::string& name) {
  if (name == "automatic") return planar::segments_visit;
  if (name == "grid") return planar::segments_all_by_grid;
  if (name == "bentley-ottmann") return planar::segments_all_by_bentley_ottmann;
  if (name == "balaban") return planar::segments_all_by_balaban;
  if (name == "scan") return planar::segments_all_by_scan;
  refuse_method(name, "automatic, grid, bentley-ottmann, balaban, scan (for lists and counts)");
}

// The layers that are asked about, each a sheet; or one sheet of all.
std::vector<Sheet> sheets_of(const Call& call, const io::LineFile& file) {
  const bool has_layers = !file.layers.empty();
  if (!has_layers && (!call.layer.empty() || call.across_layers)) {
    throw Error(ErrorCode::bad_call, fmt::format("{} has no layers; leave it out", call.file),
                call.layer.empty() ? "--across-layers" : "--layer");
  }
  std::vector<std::vector<std::uint32_t>> members(has_layers && !call.across_layers ? file.layers.size() : 1);
  for (std::uint32_t i = 0; i < file.segments.size(); ++i) {
    if (!call.layer.empty() && file.layers[file.layer[i]] != call.layer) continue;
    members[members.size() > 1 ? file.layer[i] : 0].push_back(i);
  }
  std::vector<Sheet> sheets;
  for (std::vector<std::uint32_t>& m : members) {
    if (m.empty()) continue;
    std::vector<Segment> segments;
    std::vector<std::uint32_t> groups;
    segments.reserve(m.size());
    for (const std::uint32_t i : m) {
      segments.push_back(file.segments[i]);
      if (!file.group.empty()) groups.push_back(file.group[i]);
    }
    const std::string layer = members.size() > 1 && call.layer.empty() ? file.layers[file.layer[m[0]]] : "";
    sheets.push_back({std::move(m), Segments(std::move(segments)), std::move(groups), layer});
  }
  if (sheets.empty()) {
    throw Error(
        ErrorCode::bad_call,
        fmt::format("no segment is on a layer {}; layers are {}", io::quote(call.layer), fmt::join(file.layers, ", ")),
        "--layer");
  }
  return sheets;
}

bool is_board(const io::LineFile& file) { return file.format == "KiCad board"; }

// Tracks are copper, and there is more copper than tracks: their lines are asked about by those who say so.
void check_centre_lines(const Call& call, const io::LineFile& file) {
  if (is_board(file) == call.centre_lines) return;
  if (call.centre_lines) throw Error(ErrorCode::bad_call, "is for boards; leave it out", "--centre-lines");
  io::fail_file(call.file, fmt::format("copper is not read ({}); to ask about the tracks' centre lines alone, say "
                                       "--centre-lines",
                                       fmt::join(file.remarks, "; ")));
}

LeftOutList left_out_of(const io::LineFile& file) {
  LeftOutList list(true);  // the reader refuses what the caller does not let go
  list.add("", file.left_out, "");
  return list;
}

// What the certificate does not speak of.
std::vector<std::string> left_out_texts(const io::LineFile& file) {
  if (!is_board(file)) return left_out_of(file).texts();
  return {fmt::format("copper, but for the centre lines of tracks: {}", fmt::join(file.remarks, "; "))};
}

// "proof.json", or of a layer among others "proof.F.Cu.json".
std::filesystem::path certificate_of(const Call& call, const Sheet& sheet) {
  std::filesystem::path path = call.certificate;
  if (sheet.layer.empty()) return path;
  const std::string ending = path.extension().string();
  return path.replace_extension("." + sheet.layer + ending);
}

// The names of certificates are known by now.
void require_apart(const Call& call, const std::vector<Sheet>& sheets) {
  std::vector<NamedFile> outputs;
  if (!call.geojson.empty()) outputs.push_back({"--geojson", call.geojson});
  if (!call.svg.empty()) outputs.push_back({"--svg", call.svg});
  for (const Sheet& sheet : sheets) {
    if (!call.certificate.empty()) outputs.push_back({"--certificate", certificate_of(call, sheet)});
  }
  cli::require_apart({{"", call.file}}, outputs);
}

SegmentsContact in_file(const Sheet& sheet, const SegmentsContact& c) {
  return {sheet.members[c.i], sheet.members[c.j], c.kind};  // members rise, so i < j stays
}

// The numbers in the sheet of those in the file.
Block in_sheet(const Sheet& sheet, const Block& block) {
  const auto number = [&](std::uint32_t i) {
    return static_cast<std::uint32_t>(std::lower_bound(sheet.members.begin(), sheet.members.end(), i) -
                                      sheet.members.begin());
  };
  return {number(block.first), number(block.last)};
}

// Calls take for each contact of the sheet whose i the block holds.
template <class Take>
Cost visit(const Call& call, const Sheet& sheet, SetOptions options, const Block& block, const Take& take) {
  Progress progress("comparing");
  options.progress = progress.reporter();
  options.groups = sheet.groups;
  return segments_visit_block(sheet.segments, options, in_sheet(sheet, block), contact_method(call.method),
                              [&](const SegmentsContact& c) {
                                take(in_file(sheet, c));
                                return true;
                              });
}

// With --count, and where a list is wanted. Keeps the sheets by reference.
void count_and_list(const Call& call, const std::vector<Sheet>& sheets, const SetOptions& options, std::uint32_t size,
                    Result& result) {
  const auto ask = [&, options](const Block& block, const Contacts::Take& take) {
    const bool is_first = result.contacts == nullptr;
    for (const Sheet& sheet : sheets) {
      const Cost cost = visit(call, sheet, options, block, [&](const SegmentsContact& c) {
        if (is_first) result.add(c.kind);
        if (take) take(c);
      });
      if (is_first) result.cost.probes += cost.probes;
    }
  };
  if (call.lists()) {
    result.contacts = std::make_unique<Contacts>(size, most_held(size), ask);
  } else {
    ask({0, size}, nullptr);
  }
}

// Writes the proof of an answer about a sheet.
template <class Answer>
void prove(const Call& call, const Sheet& sheet, Allowed allowed, const Answer& answer, const Origin& origin,
           Result& result) {
  result.proofs.push_back(certificate_of(call, sheet).string());
  io::OutputFile file(result.proofs.back());
  ClaimsWriter claims([&](std::string_view text) { file.write(text); });
  claims.add_origin(origin);
  planar::write_statement(claims, sheet.segments, allowed, answer, sheet.groups);
  claims.end();
  file.commit();
}

// A proof of a list, or of its length, has an event for each place where some meet.
void require_provable(const Sheet& sheet, SetOptions options) {
  options.transcript = false;
  const std::uint64_t count = planar::segments_count(sheet.segments, options).count;
  if (count <= most_proved) return;
  const std::size_t digits = std::to_string(sheet.segments.size()).size();
  const double gigabytes = static_cast<double>(count) * static_cast<double>(5 * digits + 30) / 1e9;
  throw Error(ErrorCode::bad_call,
              fmt::format("{} pairs meet, and the proof would have about {:.1f} GB; of more than {} pairs none is "
                          "written; leave it out, or ask about less",
                          count, gigabytes, most_proved),
              "--certificate");
}

// With --count or --all, and a proof.
void count_and_prove(const Call& call, const std::vector<Sheet>& sheets, SetOptions options, const Origin& origin,
                     Result& result) {
  std::vector<SegmentsContact> all;
  for (const Sheet& sheet : sheets) {
    Progress progress("comparing");
    options.progress = progress.reporter();
    options.groups = sheet.groups;
    require_provable(sheet, options);
    planar::SegmentsAllAnswer answer = planar::segments_all(sheet.segments, options);
    result.cost.probes += answer.cost.probes;
    for (const SegmentsContact& c : answer.contacts) {
      result.add(c.kind);
      if (call.lists()) all.push_back(in_file(sheet, c));
    }
    if (call.lists()) {
      prove(call, sheet, options.allowed, answer, origin, result);
    } else {
      prove(call, sheet, options.allowed,
            planar::SegmentsCountAnswer{{answer.contacts.size(), answer.cost}, std::move(answer.transcript)}, origin,
            result);
    }
  }
  if (!call.lists()) return;
  std::sort(all.begin(), all.end());
  result.contacts = std::make_unique<Contacts>(std::move(all));
}

// Does any pair meet? Sheet by sheet, until one does.
void find_any(const Call& call, const std::vector<Sheet>& sheets, SetOptions options, const Origin& origin,
              Result& result) {
  std::vector<SegmentsContact> found;
  for (const Sheet& sheet : sheets) {
    Progress progress("comparing");
    options.progress = progress.reporter();
    options.groups = sheet.groups;
    const SegmentsAnswer answer = any_method(call.method)(sheet.segments, options);
    result.cost.probes += answer.cost.probes;
    if (!call.certificate.empty()) prove(call, sheet, options.allowed, answer, origin, result);
    if (!answer.meet()) continue;
    found.push_back(in_file(sheet, *answer.found));
    result.add(answer.found->kind);
    break;
  }
  result.contacts = std::make_unique<Contacts>(std::move(found));
}

std::string about(const Point2& p) { return fmt::format("({:.10g}, {:.10g})", p.x, p.y); }

Point2 place_of(const io::LineFile& file, const SegmentsContact& contact) {
  return planar::common_point_rounded(planar::sorted(file.segments[contact.i]),
                                      planar::sorted(file.segments[contact.j]));
}

std::string source_of(const io::LineFile& file, std::uint32_t i) {
  const io::LineSource& source = file.source[i];
  std::string place = fmt::format("feature {}", file.features[source.feature]);
  if (!file.layers.empty()) place += fmt::format(", layer {}", file.layers[file.layer[i]]);
  if (source.line > 0) place += fmt::format(", line {}", source.line);
  return place;
}

// "(touch allowed; members of one net may meet; layer by layer)"
std::string rule_text(const Call& call, const io::LineFile& file) {
  std::vector<std::string> rules;
  if (call.allow != "nothing") rules.push_back(call.allow + " allowed");
  if (!file.groups.empty())
    rules.push_back(fmt::format("those of one {} may meet", call.group.empty() ? "net" : call.group));
  if (!call.layer.empty()) rules.push_back("layer " + call.layer);
  if (!file.layers.empty() && call.layer.empty())
    rules.push_back(call.across_layers ? "across layers" : "each layer by itself");
  return rules.empty() ? "" : fmt::format(" ({})", fmt::join(rules, "; "));
}

constexpr std::size_t most_listed = 20;

// listed: the first of the contacts.
std::string human_text(const Call& call, const io::LineFile& file, const Result& result,
                       const std::vector<SegmentsContact>& listed) {
  std::string text = fmt::format("{}: {} of {}", io::one_line(call.file), count_of(file.segments.size(), "segment"),
                                 count_of(file.features.size(), "feature"));
  if (!file.layers.empty()) text += fmt::format(", {}", count_of(file.layers.size(), "layer"));
  if (!file.groups.empty()) text += fmt::format(", {}", count_of(file.groups.size(), "group"));
  text += fmt::format(", {}\n", file.format);
  text += fmt::format("{}{} meet{}", result.some() ? "some" : "none",
                      is_board(file) ? " of the tracks' centre lines" : "", rule_text(call, file));
  if (result.some() && (call.lists() || call.count)) text += fmt::format(": {}", count_of(result.count(), "pair"));
  text += left_out_of(file).clause() + '\n';
  for (std::size_t k = 0; k < listed.size(); ++k) {
    const SegmentsContact& contact = listed[k];
    text += fmt::format("{} {} at about {}\n", call.lists() ? fmt::format("  {}.", k + 1) : " ", name_of(contact.kind),
                        about(place_of(file, contact)));
    for (const std::uint32_t i : {contact.i, contact.j}) {
      text += fmt::format("    segment {}, {}: {} to {}\n", i, source_of(file, i), about(file.segments[i].a),
                          about(file.segments[i].b));
    }
  }
  if (call.lists() && result.count() > listed.size()) {
    text += fmt::format("  and {} more; --json, --geojson or --svg have all\n", result.count() - listed.size());
  }
  if (!listed.empty() && result.all_are(ContactKind::shared_endpoint)) {
    text += "  edges that follow each other share an end: to pass over such contacts, give --allow shared-endpoint\n";
  }
  for (const std::string& remark : file.remarks) text += fmt::format("  remark      {}\n", remark);
  text += fmt::format("  cost        {}\n", count_of(result.cost.probes, "comparison"));
  for (const std::string& proof : result.proofs) text += fmt::format("  proof       {}\n", io::one_line(proof));
  if (!call.geojson.empty()) text += fmt::format("  contacts    {}\n", io::one_line(call.geojson));
  if (!call.svg.empty()) text += fmt::format("  picture     {}\n", io::one_line(call.svg));
  return text;
}

// All but the contacts.
Json report(const Call& call, const io::LineFile& file, const Result& result) {
  Json json = envelope("segments", result.some() ? "some" : "none", call.method);
  json["cost"] = to_json(result.cost);
  Json object = {{"file", call.file},
                 {"format", file.format},
                 {"segments", file.segments.size()},
                 {"features", file.features.size()}};
  if (!file.groups.empty()) object["groups"] = file.groups.size();
  if (!file.layers.empty()) object["layers"] = file.layers;
  json["objects"] = Json::array({object});
  json["said_of"] = is_board(file) ? "centre lines" : "segments";
  json["allowed"] = call.allow;
  if (!file.groups.empty()) json["group"] = call.group.empty() ? "net" : call.group;
  if (!file.layers.empty()) json["across_layers"] = call.across_layers;
  if (!call.layer.empty()) json["layer"] = call.layer;
  if (!file.remarks.empty()) json["remarks"] = file.remarks;
  if (!file.left_out.empty()) json["left_out"] = left_out_of(file).json();
  if (call.lists() || call.count) json["count"] = result.count();
  return json;
}

std::string contact_json(const io::LineFile& file, const SegmentsContact& c) {
  const Point2 p = place_of(file, c);
  std::string text = fmt::format(R"({{"i": {}, "j": {}, "kind": "{}", "point": {})", c.i, c.j, name_of(c.kind),
                                 pair_json(number_json(p.x), number_json(p.y)));
  const auto add = [&](std::string_view key, const auto& of) {
    text += fmt::format(R"(, "{}": {})", key, pair_json(of(c.i), of(c.j)));
  };
  add("features", [&](std::uint32_t i) { return quoted_json(file.features[file.source[i].feature]); });
  add("lines", [&](std::uint32_t i) {
    return file.source[i].line > 0 ? fmt::format_int(file.source[i].line).str() : std::string("null");
  });
  if (!file.groups.empty()) add("groups", [&](std::uint32_t i) { return quoted_json(file.groups[file.group[i]]); });
  if (!file.layers.empty()) add("layers", [&](std::uint32_t i) { return quoted_json(file.layers[file.layer[i]]); });
  return text + "}";
}

// Goes through the contacts once, and writes all that was asked for.
void write(const Call& call, const io::LineFile& file, const Result& result) {
  std::optional<io::OutputFile> geojson_file;
  if (!call.geojson.empty()) geojson_file.emplace(call.geojson);
  std::optional<ContactsGeojson> geojson;
  if (geojson_file) geojson.emplace(file, [&](std::string_view text) { geojson_file->write(text); });
  std::optional<ListReport> json;
  if (call.json) json.emplace(report(call, file, result), "contacts");
  std::vector<SegmentsContact> listed, drawn;
  const auto take = [&](const SegmentsContact& contact) {
    if (json) json->add(contact_json(file, contact));
    if (geojson) geojson->add(contact);
    if (!call.svg.empty()) drawn.push_back(contact);
    if (listed.size() < most_listed) listed.push_back(contact);
    return json || geojson || !call.svg.empty() || listed.size() < most_listed;
  };
  if (result.contacts) result.contacts->visit(take);
  if (geojson) {
    geojson->close();
    geojson_file->commit();
  }
  if (!call.svg.empty()) {
    io::write_file_atomically(call.svg,
                              segments_svg({file, Segments(file.segments), drawn, call.title, is_board(file)}));
  }
  if (json) {
    json->close();
  } else {
    print_for_people(human_text(call, file, result, listed));
  }
}

// What can be told before the file is read.
void check(const Call& call) {
  if (call.lists() || call.count) {
    contact_method(call.method);
  } else {
    any_method(call.method);
  }
  if (call.certificate.empty()) return;
  if ((call.lists() || call.count) && call.method != "automatic" && call.method != "bentley-ottmann") {
    throw Error(ErrorCode::bad_call, call.method + " proves no lists; give automatic or bentley-ottmann", "--method");
  }
  if (call.method == "scan") {
    throw Error(ErrorCode::bad_call, "scan writes no certificates; give automatic or sweep", "--method");
  }
}

io::LineFile read(const Call& call, InputFiles* inputs) {
  Progress progress("reading");
  io::LineOptions options;
  options.drop_z = call.drop_z;
  options.leave_out = call.leave_out;
  options.group = call.group;
  options.name = call.name;
  options.progress = progress.reporter();
  options.inputs = inputs;
  return io::read_lines(call.file, options);
}

int run(const Call& call) {
  check(call);
  SetOptions options;
  options.allowed = allowed_by(call.allow);
  options.transcript = !call.certificate.empty();
  Origin origin;
  const io::LineFile file = read(call, call.certificate.empty() ? nullptr : &origin.inputs);
  check_centre_lines(call, file);
  const auto require_drawable = [&](std::uint64_t contacts) {
    if (!call.svg.empty()) cli::require_drawable(file.segments.size(), "segment", contacts, call.svg_limit);
  };
  require_drawable(0);
  const std::vector<Sheet> sheets = sheets_of(call, file);
  require_apart(call, sheets);
  const std::uint32_t size = static_cast<std::uint32_t>(file.segments.size());
  Result result;
  origin.left_out = left_out_texts(file);
  if ((call.lists() || call.count) && options.transcript) {
    count_and_prove(call, sheets, options, origin, result);
  } else if (call.lists() || call.count) {
    count_and_list(call, sheets, options, size, result);
  } else {
    find_any(call, sheets, options, origin, result);
  }
  require_drawable(result.count());
  write(call, file, result);
  return result.some() ? exit_code::yes : exit_code::no;
}

}  // namespace

void add_segments(CLI::App& program, int& code) {
  auto call = std::make_shared<Call>();
  CLI::App* verb =
      program.add_subcommand("segments", "Do any two segments of a file meet? Which, or a proof that none do.");
  verb->add_option("FILE", call->file, "segments, lines or polygons: CSV (x1,y1,x2,y2), WKT, GeoJSON, KiCad board")
      ->required();
  auto* any = verb->add_flag("--any", call->any, "does any pair meet? (unless told otherwise)");
  auto* all = verb->add_flag("--all", call->all, "list all pairs that meet");
  auto* count = verb->add_flag("--count", call->count, "count the pairs that meet");
  any->excludes(all)->excludes(count);
  all->excludes(count);
  verb->add_option("--allow", call->allow, "what does not count: nothing, shared-endpoint, or touch")
      ->type_name("KIND");
  verb->add_option("--group", call->group,
                   "segments that are the same in this may meet and cross: feature, ring, a column of the CSV, a "
                   "property of the GeoJSON; of a board net (unless told otherwise) or layer")
      ->type_name("FIELD");
  auto* layer = verb->add_option("--layer", call->layer, "of a board, this layer only")->type_name("NAME");
  verb->add_flag("--across-layers", call->across_layers, "of a board, tracks of different layers may meet too")
      ->excludes(layer);
  verb->add_flag(
      "--centre-lines", call->centre_lines,
      "of a board, ask about the tracks' centre lines: copper is not read, neither widths nor pads nor zones");
  verb->add_option("--method", call->method,
                   "automatic, grid, sweep (not for lists), bentley-ottmann, balaban (for lists), or scan")
      ->type_name("NAME");
  verb->add_option("--certificate", call->certificate, "write the proof here")->type_name("FILE");
  verb->add_option("--geojson", call->geojson, "write all contacts here, to lay over a map")->type_name("FILE");
  auto* svg = verb->add_option("--svg", call->svg, "draw the segments and all contacts here")->type_name("FILE");
  verb->add_option("--title", call->title, "of the picture")->needs(svg);
  add_svg_limit(*verb, call->svg_limit);
  verb->add_option("--name", call->name, "the column or property that names features; unless given, name, NAME, id")
      ->type_name("FIELD");
  verb->add_flag("--leave-out", call->leave_out, leave_out_help);
  verb->add_flag("--drop-z", call->drop_z, "ignore third coordinates");
  verb->add_flag("--json", call->json, "print a report in JSON");
  verb->callback([call, &code] { code = run(*call); });
}

}  // namespace sunder::cli
