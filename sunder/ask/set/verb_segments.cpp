// sunder segments FILE: do any two segments meet? Which? How many?
#include <sunder/ask/outputs.h>
#include <sunder/ask/said_of.h>
#include <sunder/ask/set/set_verb.h>

#include <sunder/base/error.h>
#include <sunder/certificate/origin.h>
#include <sunder/io/plane/lines.h>
#include <sunder/io/text/text.h>
#include <sunder/picture/segments.h>
#include <sunder/planar/pair/segment_segment.h>
#include <sunder/planar/segments/drawing_plane.h>
#include <sunder/planar/segments/intervals_any.h>
#include <sunder/planar/segments/segments_all.h>
#include <sunder/planar/segments/segments_claims.h>
#include <sunder/planar/sweep/sweep_events.h>

#include <fmt/ranges.h>

#include <filesystem>

namespace sunder::ask {

namespace {

using planar::ContactKind;
using planar::Segment;
using planar::Segments;
using planar::SegmentsAnswer;
using planar::SegmentsContact;

struct SegmentsCall : SetCall {
  std::string layer;
  bool across_layers = false, centre_lines = false;
};

// What is asked about together: all of a file, or one layer of it.
struct Sheet {
  std::vector<std::uint32_t> members;  // segments of the file
  Segments segments;
  std::vector<std::uint32_t> groups;
  std::string layer;  // where it is one of several sheets, its name as it stands in those of files
};

// Segments of one horizontal line, as intervals.
SegmentsAnswer of_intervals(const Segments& segments, const SetOptions& options) {
  if (!options.groups.empty()) {
    throw Error(ErrorCode::bad_call, "intervals knows no groups; give another method, or leave out --group",
                "--method");
  }
  std::vector<planar::LineInterval> intervals;
  for (const Segment& s : segments.all()) {
    if (s.a.y != segments[0].a.y || s.b.y != segments[0].a.y) {
      throw Error(
          ErrorCode::bad_call,
          "intervals is for segments of one horizontal line, as CSV has them under low,high; give another method",
          "--method");
    }
    intervals.push_back({s.a.x, s.b.x});
  }
  return planar::intervals_any(intervals, options.allowed);
}

// Segments as the edges of a drawing, with vertices where they end.
SegmentsAnswer of_drawing(const Segments& segments, const SetOptions& options) {
  if (options.allowed != Allowed::shared_endpoint || !options.groups.empty()) {
    throw Error(ErrorCode::bad_call,
                "drawing asks whether a drawing is plane, whose edges may share ends; give --allow shared-endpoint and "
                "no --group, or another method",
                "--method");
  }
  std::vector<Point2> vertices;
  for (const Segment& s : segments.all()) vertices.insert(vertices.end(), {s.a, s.b});
  std::sort(vertices.begin(), vertices.end(), planar::lexicographically_less);
  vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
  const auto number_of = [&](const Point2& p) {
    const auto at = std::lower_bound(vertices.begin(), vertices.end(), p, planar::lexicographically_less);
    return static_cast<std::uint32_t>(at - vertices.begin());
  };
  std::vector<planar::DrawingEdge> edges;
  for (std::uint32_t i = 0; i < segments.size(); ++i) {
    if (segments[i].a == segments[i].b) {
      throw Error(ErrorCode::bad_call,
                  fmt::format("segment {} has length zero, and is no edge of a drawing; give another method", i),
                  "--method");
    }
    edges.push_back({number_of(segments[i].a), number_of(segments[i].b)});
  }
  const planar::DrawingAnswer answer = planar::drawing_plane(vertices, edges);
  if (!answer.found) return {std::nullopt, answer.cost};
  return {SegmentsContact{answer.found->i, answer.found->j, answer.found->kind}, answer.cost};
}

using SegmentsAnyMethod = SegmentsAnswer(const Segments&, const SetOptions&);
constexpr std::array<Named<SegmentsAnyMethod>, 7> segments_any_methods{
    {SUNDER_METHOD("automatic", planar::segments_any),
     SUNDER_METHOD("grid", planar::segments_any_by_grid),
     SUNDER_METHOD("sweep", planar::segments_any_by_sweep),
     SUNDER_METHOD("bentley-ottmann", planar::segments_any_by_bentley_ottmann),
     SUNDER_METHOD("scan", planar::segments_any_by_scan),
     {"intervals", of_intervals, "planar::intervals_any"},
     {"drawing", of_drawing, "planar::drawing_plane"}}};
constexpr std::array<Named<planar::SegmentsMethod>, 5> segments_all_methods{
    {SUNDER_METHOD("automatic", planar::segments_visit), SUNDER_METHOD("grid", planar::segments_all_by_grid),
     SUNDER_METHOD("bentley-ottmann", planar::segments_all_by_bentley_ottmann),
     SUNDER_METHOD("balaban", planar::segments_all_by_balaban), SUNDER_METHOD("scan", planar::segments_all_by_scan)}};
Named<planar::SegmentsMethod> contact_method(const std::string& name) {
  return method_by(name, segments_all_methods, " (for lists and counts)");
}

// The name as a part of a file's name, other than those of the sheets: "F.Cu", "top_copper", "top_copper-2".
std::string layer_in_files(const std::string& layer, const std::vector<Sheet>& sheets) {
  std::string plain = layer;
  for (char& c : plain) {
    const bool is_kept = ('a' <= c && c <= 'z') || ('A' <= c && c <= 'Z') || ('0' <= c && c <= '9') || c == '.' ||
                         c == '-' || static_cast<unsigned char>(c) > 127;
    if (!is_kept) c = '_';
  }
  std::string name = plain;
  const auto is_taken = [&](const Sheet& sheet) { return sheet.layer == name; };
  for (int number = 2; std::any_of(sheets.begin(), sheets.end(), is_taken); ++number) {
    name = fmt::format("{}-{}", plain, number);
  }
  return name;
}

// The layers that are asked about, each a sheet; or one sheet of all.
std::vector<Sheet> sheets_of(const SegmentsCall& call, const io::LineFile& file) {
  const bool has_layers = !file.layers.empty();
  if (!has_layers && (!call.layer.empty() || call.across_layers)) {
    throw Error(ErrorCode::bad_call, fmt::format("{} has no layers; leave it out", call.files[0]),
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
    const bool is_one_of_several = members.size() > 1 && call.layer.empty();
    const std::string layer = is_one_of_several ? layer_in_files(file.layers[file.layer[m[0]]], sheets) : "";
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
void check_centre_lines(const SegmentsCall& call, const io::LineFile& file) {
  if (is_board(file) == call.centre_lines) return;
  if (call.centre_lines) throw Error(ErrorCode::bad_call, "is for boards; leave it out", "--centre-lines");
  io::fail_file(call.files[0], fmt::format("copper is not read ({}); to ask about the tracks' centre lines alone, say "
                                           "--centre-lines",
                                           fmt::join(file.remarks, "; ")));
}

// Those of the file, and what the verdict would hide.
std::vector<std::string> remarks_of(const io::LineFile& file) {
  std::vector<std::string> remarks = file.remarks;
  if (!file.rings.empty()) {
    remarks.emplace_back(
        "polygons count as their boundaries: what lies inside of one does not meet it (sunder polygons "
        "asks about insides)");
  }
  return remarks;
}

LeftOutList left_out_of(const io::LineFile& file) { return {"", file.left_out}; }

// "proof.json", or of a layer among others "proof.F.Cu.json".
std::filesystem::path certificate_of(const SegmentsCall& call, const Sheet& sheet) {
  std::filesystem::path path = call.certificate;
  if (sheet.layer.empty()) return path;
  const std::string ending = path.extension().string();
  return path.replace_extension("." + sheet.layer + ending);
}

// The names of certificates are known by now.
void require_apart(const SegmentsCall& call, Talk& talk, const std::vector<Sheet>& sheets) {
  std::vector<NamedFile> outputs;
  if (call.certificate == "-" && !sheets[0].layer.empty()) {
    throw Error(ErrorCode::bad_call,
                "each layer has a proof of its own, and standard output takes one; add --layer NAME or --across-layers",
                "--certificate");
  }
  if (!call.csv.empty()) outputs.push_back({"--csv", call.csv});
  if (!call.geojson.empty()) outputs.push_back({"--geojson", call.geojson});
  if (!call.svg.empty()) outputs.push_back({"--svg", call.svg});
  for (const Sheet& sheet : sheets) {
    if (!call.certificate.empty()) outputs.push_back({"--certificate", certificate_of(call, sheet)});
  }
  ask::require_apart(talk, {{"", call.files[0]}}, outputs);
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

// A proof of a list has the list, and an event for each place where some meet.
void require_provable(const Sheet& sheet, const SetOptions& options) {
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

// What proves how many pairs meet, or that none do: the events alone, few where many meet in one place.
planar::SweepEvents events_of(const Sheet& sheet) {
  const std::uint64_t most = std::max(4 * most_proved, 8 * std::uint64_t{sheet.segments.size()});
  std::optional<planar::SweepEvents> events = planar::sweep_events(sheet.segments, most);
  if (events) return std::move(*events);
  const std::size_t digits = std::to_string(sheet.segments.size()).size();
  throw Error(
      ErrorCode::bad_call,
      fmt::format("segments meet in so many places that the proof would have {:.1f} GB or more; leave it out, or "
                  "ask about less",
                  static_cast<double>(most * (digits + 1)) / 1e9),
      "--certificate");
}

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

io::LineFile read(const SegmentsCall& call, const Talk& talk, InputFiles* inputs) {
  return io::read_lines(call.files[0], {.drop_z = call.drop_z,
                                        .group = call.group,
                                        .progress = talk.progress("reading"),
                                        .leave_out = call.leave_out,
                                        .name = call.name,
                                        .properties = call.properties,
                                        .inputs = inputs});
}

class SegmentsSet {
 public:
  using Call = ask::SegmentsCall;
  using Contact = SegmentsContact;
  using Result = SetResult<SegmentsSet>;
  static constexpr std::string_view verb = "segments", noun = "segment", drawn_noun = noun;
  static constexpr std::array kinds{ContactKind::overlap, ContactKind::crossing, ContactKind::touch,
                                    ContactKind::shared_endpoint};

  static void check(const SegmentsCall& call) {
    allowed_by(call.allow);
    if (call.counts()) {
      contact_method(call.method);
    } else {
      method_by(call.method, segments_any_methods);
    }
    if (call.proves() && call.counts() && call.method != "automatic" && call.method != "bentley-ottmann") {
      throw Error(ErrorCode::bad_call, call.method + " proves no lists; give automatic or bentley-ottmann", "--method");
    }
    require_other_than_scan(call);
  }

  SegmentsSet(const SegmentsCall& call, Talk& talk)
      : call_(call), talk_(talk), file_(read(call, talk, call.proves() ? &origin_.inputs : nullptr)) {
    check_centre_lines(call, file_);
    systems_ = io::CoordinateSystems(call.mixed_crs);
    systems_.add(call.files[0], file_.systems);
    sheets_ = sheets_of(call, file_);
    require_apart(call, talk, sheets_);
    options_.allowed = allowed_by(call.allow);
    if (is_board(file_)) {
      origin_.left_out = {
          fmt::format("copper, but for the centre lines of tracks: {}", fmt::join(file_.remarks, "; "))};
    } else {
      origin_.left_out = left_out_of(file_).texts();
    }
  }

  const io::CoordinateSystems& systems() const { return systems_; }
  std::uint64_t drawn() const { return file_.segments.size(); }

  void ask(Result& result) {
    if (!call_.counts()) {
      find_any(result);
    } else if (call_.proves() && call_.lists()) {
      list_and_prove(result);
    } else if (call_.proves()) {
      count_and_prove(result);
    } else {
      result.function = contact_method(call_.method).function;
      const auto ask_block = [this](const Block& block, const auto& take) { return visit(block, take); };
      result.count_and_list(static_cast<std::uint32_t>(file_.segments.size()), call_.lists(), ask_block);
    }
  }

  std::vector<std::string> prove(const Result&) const {
    std::vector<std::string> files;
    for (const Proof& proof : proofs_) {
      Origin origin = origin_;
      const std::string layer = layer_of(proof.sheet);
      if (!layer.empty() && file_.layers.size() > 1) origin.left_out.push_back("all layers but " + layer);
      origin.said = said_of_rows("segments", proof.sheet.segments.size(), said_of_layer(layer));
      write_proof(talk_, proof.file, origin, proof.write);
      files.push_back(proof.file);
    }
    return files;
  }

  SetFacts facts(const Result& result) const {
    SetFacts facts;
    if (result.some() && !call_.lists() && call_.count) facts.not_proved = {"how many of each kind"};
    facts.head = fmt::format("{}: {} of {}", io::one_line(call_.files[0]), count_of(file_.segments.size(), "segment"),
                             count_of(file_.features.size(), "feature"));
    if (is_board(file_)) facts.said_of = " of the tracks' centre lines";
    Json object = {{"file", call_.files[0]},
                   {"format", file_.format},
                   {"segments", file_.segments.size()},
                   {"features", file_.features.size()}};
    if (!file_.layers.empty()) facts.head += ", " + count_of(file_.layers.size(), "layer");
    if (!file_.groups.empty()) {
      const std::string group = call_.group.empty() ? "net" : call_.group;
      facts.head += ", " + count_of(file_.groups.size(), "group");
      facts.rules.push_back(fmt::format("those of one {} may meet", group));
      object["groups"] = file_.groups.size();
      facts.last["group"] = group;
    }
    if (!file_.layers.empty()) {
      object["layers"] = file_.layers;
      facts.last["across_layers"] = call_.across_layers;
    }
    if (!call_.layer.empty()) {
      facts.rules.push_back("layer " + call_.layer);
      facts.last["layer"] = call_.layer;
    } else if (!file_.layers.empty()) {
      facts.rules.emplace_back(call_.across_layers ? "across layers" : "each layer by itself");
    }
    facts.head += fmt::format(", {}\n", file_.format);
    facts.first["objects"] = Json::array({object});
    facts.first["said_of"] = is_board(file_) ? "centre lines" : "segments";
    if (result.some() && result.count.back() == result.pairs() && (call_.lists() || !call_.count)) {
      facts.tail =
          "  edges that follow each other share an end: to pass over such contacts, give --allow shared-endpoint\n";
    }
    const std::vector<std::string> remarks = remarks_of(file_);
    for (const std::string& remark : remarks) facts.tail += titled("remark", remark);
    if (!remarks.empty()) facts.last["remarks"] = remarks;
    const LeftOutList left_out = left_out_of(file_);
    facts.clause = left_out.clause();
    if (!left_out.empty()) facts.last["left_out"] = to_json(left_out);
    return facts;
  }

  std::string text(const SegmentsContact& contact) const {
    std::string text = fmt::format("{} at about {}\n", name_of(contact.kind), place_text(place_of(file_, contact)));
    for (const std::uint32_t i : {contact.i, contact.j}) {
      text += fmt::format("    segment {}, {}{}: {} to {}\n", i, source_of(file_, i),
                          words_of(call_.properties, file_.properties, file_.source[i].feature),
                          place_text(file_.segments[i].a), place_text(file_.segments[i].b));
    }
    return text;
  }
  static ContactKind kind_of(const SegmentsContact& contact) { return contact.kind; }

  ContactRow row(const SegmentsContact& c) const {
    ContactRow row{c.i, c.j, name_of(c.kind), place_of(file_, c)};
    if (c.kind == ContactKind::overlap) {
      const Segment part = common_part(planar::sorted(file_.segments[c.i]), planar::sorted(file_.segments[c.j]));
      row.part = {part.a, part.b};
    }
    const auto add = [&](std::string_view key, bool is_text, const auto& of) {
      row.properties.push_back({key, {of(c.i), of(c.j)}, is_text});
    };
    add("names", true, [&](std::uint32_t i) { return file_.features[file_.source[i].feature]; });
    add("lines", false, [&](std::uint32_t i) {
      return file_.source[i].line > 0 ? std::to_string(file_.source[i].line) : std::string("null");
    });
    if (!file_.groups.empty()) add("groups", true, [&](std::uint32_t i) { return file_.groups[file_.group[i]]; });
    if (!file_.layers.empty()) add("layers", true, [&](std::uint32_t i) { return file_.layers[file_.layer[i]]; });
    row.fields = fields_of(call_.properties, file_.properties, file_.source[c.i].feature, file_.properties,
                           file_.source[c.j].feature);
    return row;
  }

  std::string picture(const Result&, const std::vector<SegmentsContact>& contacts, const std::string& said) const {
    return picture::segments_svg({file_, Segments(file_.segments), contacts, said, call_.title, is_board(file_)});
  }

 private:
  // ask(options): of a sheet, telling of the progress.
  template <class Ask>
  auto of_sheet(const Sheet& sheet, const Ask& ask) const {
    SetOptions options = options_;
    options.progress = talk_.progress("comparing");
    options.groups = sheet.groups;
    return ask(options);
  }

  struct Proof {
    std::string file;
    const Sheet& sheet;
    std::function<void(ClaimsWriter&)> write;
  };

  // Empty: the file has none, or the sheet is of all.
  std::string layer_of(const Sheet& sheet) const {
    if (file_.layers.empty() || call_.across_layers) return "";
    return file_.layers[file_.layer[sheet.members[0]]];
  }

  Said said_of_layer(const std::string& layer) const {
    const Said said =
        said_in(file_.systems, said_of_file(is_board(file_) ? Said::Source::centre_lines : Said::Source::lines,
                                            origin_.inputs, call_.files[0], layer,
                                            is_board(file_) ? std::vector<std::string>() : left_out_of(file_).texts()));
    return call_.drop_z && !said.empty() ? said.dropped("z") : said;
  }

  // Calls take for each contact whose i, in the file, the block holds.
  template <class Take>
  Cost visit(const Block& block, const Take& take) const {
    Cost sum;
    for (const Sheet& sheet : sheets_) {
      const Cost cost = of_sheet(sheet, [&](const SetOptions& options) {
        return segments_visit_block(sheet.segments, options, in_sheet(sheet, block), contact_method(call_.method),
                                    [&](const SegmentsContact& c) {
                                      take(in_file(sheet, c));
                                      return true;
                                    });
      });
      sum.probes += cost.probes;
    }
    return sum;
  }

  // Keeps the answer, and the events that prove it, until they are written.
  template <class Answer>
  void hold_proof(const Sheet& sheet, Answer answer, planar::SweepEvents events) {
    const auto kept =
        std::make_shared<const std::pair<Answer, planar::SweepEvents>>(std::move(answer), std::move(events));
    proofs_.push_back({certificate_of(call_, sheet).string(), sheet, [this, &sheet, kept](ClaimsWriter& claims) {
                         planar::write_statement(claims, sheet.segments, options_.allowed, kept->first, kept->second,
                                                 sheet.groups);
                       }});
  }

  // Does any pair meet? Sheet by sheet, until one does.
  void find_any(Result& result) {
    const Named<SegmentsAnyMethod> method = method_by(call_.method, segments_any_methods);
    result.function = call_.proves() ? "planar::segments_any_with_transcript" : method.function;
    for (const Sheet& sheet : sheets_) {
      planar::SweepEvents events;
      const SegmentsAnswer answer = of_sheet(sheet, [&](const SetOptions& options) {
        return call_.proves() ? planar::segments_any_with_transcript(sheet.segments, options, events)
                              : method(sheet.segments, options);
      });
      result.cost.probes += answer.cost.probes;
      const bool some = answer.meet();
      if (some) result.found(in_file(sheet, *answer.found));
      if (call_.proves()) hold_proof(sheet, answer, std::move(events));
      if (some) return;
    }
  }

  // With --count and a proof: contacts are counted, and not kept.
  void count_and_prove(Result& result) {
    const Named<planar::SegmentsMethod> method = contact_method(call_.method);
    result.function = method.function;
    std::uint64_t before = 0;
    for (const Sheet& sheet : sheets_) {
      planar::SweepEvents events = events_of(sheet);
      const Cost cost = of_sheet(sheet, [&](const SetOptions& options) {
        return method(sheet.segments, options, [&](const SegmentsContact& c) {
          result.add(c);
          return true;
        });
      });
      result.cost.probes += cost.probes;
      hold_proof(sheet, CountAnswer<>{result.pairs() - before, cost}, std::move(events));
      before = result.pairs();
    }
  }

  // With --all and a proof.
  void list_and_prove(Result& result) {
    result.function = "planar::segments_visit_with_transcript";
    std::vector<SegmentsContact> all;
    for (const Sheet& sheet : sheets_) {
      planar::SweepEvents events;
      planar::SegmentsAllAnswer answer = of_sheet(sheet, [&](const SetOptions& options) {
        require_provable(sheet, options);
        return all_of<SegmentsContact>([&](const planar::SegmentsVisitor& visit) {
          return planar::segments_visit_with_transcript(sheet.segments, options, visit, events);
        });
      });
      std::sort(answer.found.begin(), answer.found.end());
      result.cost.probes += answer.cost.probes;
      for (const SegmentsContact& c : answer.found) {
        result.add(c);
        all.push_back(in_file(sheet, c));
      }
      hold_proof(sheet, std::move(answer), std::move(events));
    }
    std::sort(all.begin(), all.end());
    result.hold(std::move(all));
  }

  const SegmentsCall& call_;
  Talk& talk_;
  Origin origin_;
  io::LineFile file_;
  io::CoordinateSystems systems_;
  std::vector<Sheet> sheets_;
  SetOptions options_;
  std::vector<Proof> proofs_;
};

}  // namespace

Verb segments_verb() {
  const auto call = std::make_shared<SegmentsCall>();
  Verb verb = set_verb<SegmentsSet>(
      call,
      {"segments", "Do any two segments in a file meet?",
       "segments: CSV (x1,y1,x2,y2 in each row); the edges of lines or polygons: WKT, GeoJSON; the tracks of a KiCad "
       "board",
       "segments", "nothing, shared-endpoint, or touch",
       "segments with the same value of FIELD may meet: feature, ring, a column of the CSV, or a property of the "
       "GeoJSON; for a board: net (the default) or layer",
       "the column or property that holds the names of features (default: name, NAME or id)",
       fmt::format("for --any: {}; for --all and --count: {}", method_names(segments_any_methods),
                   method_names(segments_all_methods))});
  add_file_options(verb, *call);
  verb.options.push_back({"--layer", &call->layer, "board: use this layer only", "NAME"});
  verb.options.push_back({.name = "--across-layers",
                          .value = &call->across_layers,
                          .help = "board: also compare tracks of different layers",
                          .excludes = {"--layer"}});
  verb.options.push_back(
      {"--centre-lines", &call->centre_lines,
       "board: required, because only the centre lines of tracks are compared; widths, pads and zones are not read"});
  return verb;
}

}  // namespace sunder::ask
