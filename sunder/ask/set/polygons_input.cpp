#include <sunder/ask/progress.h>
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

PolygonsInput read_with_progress(PolygonsRequest request) {
  Progress progress("reading");
  request.progress = progress.reporter();
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

std::string tell(const PolygonsInput& input) {
  constexpr std::size_t most_listed = 20;
  std::string text;
  const auto add = [&](const char* title, const auto& features, const auto& what) {
    for (std::size_t k = 0; k < features.size() && k < most_listed; ++k) {
      const auto& f = features[k];
      const std::string file = input.files.size() > 1 ? io::one_line(input.names[f.file]) + ": " : "";
      text += titled(title, fmt::format("{}feature {}: {}", file, input.feature_text(f.file, f.feature), what(f)));
    }
    if (features.size() <= most_listed) return;
    text += titled("", fmt::format("and {} more; --json has all", features.size() - most_listed));
  };
  add("skipped", input.skipped, [](const io::SkippedFeature& f) { return f.why; });
  add("mended", input.mended,
      [](const io::MendedFeature& f) { return text_of(f.changes) + (f.is_empty ? "; nothing is left of it" : ""); });
  if (!input.left_out.empty()) text += titled("left out", input.left_out.text());
  for (const io::LineFile& file : input.files) {
    for (const std::string& remark : file.remarks) text += titled("remark", remark);
  }
  return text;
}

void tell(const PolygonsInput& input, Json& report) {
  const auto feature = [&](const auto& f) {
    return Json{{"file", io::one_line(input.names[f.file])},
                {"feature", f.feature + 1},
                {"name", input.files[f.file].features[f.feature]}};
  };
  for (const io::SkippedFeature& f : input.skipped) {
    report["skipped"].push_back(feature(f));
    report["skipped"].back()["why"] = f.why;
  }
  for (const io::MendedFeature& f : input.mended) {
    report["mended"].push_back(feature(f));
    for (const Change& change : changes) report["mended"].back()[change.key] = f.changes.*change.count;
    report["mended"].back()["empty"] = f.is_empty;
  }
  if (!input.left_out.empty()) report["left_out"] = to_json(input.left_out);
  for (const io::LineFile& file : input.files) {
    for (const std::string& remark : file.remarks) report["remarks"].push_back(remark);
  }
}

}  // namespace sunder::ask
