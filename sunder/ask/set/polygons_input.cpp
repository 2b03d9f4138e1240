#include <sunder/ask/said_of.h>
#include <sunder/ask/set/polygons_input.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace sunder::ask {

namespace {

using planar::MendedRings;

// What is mended of rings: in reports, and in words.
struct Change {
  std::uint64_t MendedRings::* count;
  const char *key, *one, *many, *done;
};
constexpr std::array<Change, 4> changes{
    {{&MendedRings::repeated, "repeated_vertices", "repeated vertex", "repeated vertices", "left out"},
     {&MendedRings::spikes, "spikes", "spike", "spikes", "cut off"},
     {&MendedRings::closed, "closed_rings", "ring", "rings", "closed"},
     {&MendedRings::left_out, "rings_left_out", "ring", "rings", "without area left out"}}};

}  // namespace

PolygonsInput read_with_progress(const Talk& talk, PolygonsRequest request) {
  request.progress = talk.progress("reading");
  return io::read_polygons(request);
}

std::string text_of(const MendedRings& mended) {
  std::string text;
  for (const Change& change : changes) {
    const std::uint64_t count = mended.*change.count;
    if (count == 0) continue;
    text +=
        fmt::format("{}{} {} {}", text.empty() ? "" : ", ", count, count == 1 ? change.one : change.many, change.done);
  }
  return text;
}

Origin origin_of(const PolygonsInput& input, const char* table, bool drop_z, std::vector<std::uint64_t> entries) {
  Origin origin = input.origin();
  entries.resize(input.files.size());
  for (const PolygonSource& source : input.source) ++entries[source.file];
  SaidOfRows rows{table, {}};
  for (std::uint32_t f = 0; f < input.files.size(); ++f) {
    std::vector<std::string> without = input.left_out.texts_of(input.names[f]);
    const auto of_file = [&](const auto& feature) { return feature.file == f; };
    const auto skips = std::count_if(input.skipped.begin(), input.skipped.end(), of_file);
    if (skips > 0) without.push_back(count_of(static_cast<std::uint64_t>(skips), input.skipped_kind));
    MendedRings of_this;
    for (const io::MendedFeature& feature : input.mended) {
      if (feature.file == f) of_this += feature.changes;
    }
    Said said = said_in(input.files[f].systems,
                        said_of_file(Said::Source::polygons, origin.inputs, input.names[f], "", without));
    if (entries[f] == 0 || said.empty()) continue;
    if (drop_z) said = said.dropped("z");
    if (of_this.all() > 0) said = said.mended({text_of(of_this)});
    rows.parts.emplace_back(entries[f], said);
  }
  if (!rows.parts.empty()) origin.said.push_back(std::move(rows));
  return origin;
}

std::vector<Fact> facts_of(const PolygonsInput& input) {
  constexpr std::size_t most_listed = 20;
  std::vector<Fact> facts;
  // what(f, json): in words; adds to what the report has of the feature.
  const auto add = [&](const char* title, const auto& features, const auto& what) {
    if (features.empty()) return;
    Fact& fact = facts.emplace_back(Fact{title, Json::array(), ""});
    for (std::size_t k = 0; k < features.size(); ++k) {
      const auto& f = features[k];
      const std::string name = io::one_line(input.names[f.file]), file = input.files.size() > 1 ? name + ": " : "";
      Json json{{"file", name}, {"feature", f.feature + 1}, {"name", input.files[f.file].features[f.feature]}};
      const std::string words = what(f, json);
      fact.json.push_back(std::move(json));
      if (k >= most_listed) continue;
      fact.text += titled(title, fmt::format("{}feature {}: {}", file, input.feature_text(f.file, f.feature), words));
    }
    if (features.size() <= most_listed) return;
    fact.text += titled("", fmt::format("and {} more; --json has all", features.size() - most_listed));
  };
  add("skipped", input.skipped, [](const io::SkippedFeature& f, Json& json) {
    json["why"] = f.why;
    return f.why;
  });
  add("mended", input.mended, [](const io::MendedFeature& f, Json& json) {
    for (const Change& change : changes) json[change.key] = f.changes.*change.count;
    json["empty"] = f.is_empty;
    return text_of(f.changes) + (f.is_empty ? "; nothing is left of it" : "");
  });
  if (!input.left_out.empty()) {
    facts.push_back({"left_out", to_json(input.left_out), titled("left out", input.left_out.text())});
  }
  Fact remarks{"remarks", Json::array(), ""};
  for (const io::LineFile& file : input.files) {
    for (const std::string& remark : file.remarks) {
      remarks.json.push_back(remark);
      remarks.text += titled("remark", remark);
    }
  }
  if (!remarks.text.empty()) facts.push_back(std::move(remarks));
  return facts;
}

}  // namespace sunder::ask
