#include <sunder/ask/progress.h>
#include <sunder/ask/set/polygon_defect_text.h>
#include <sunder/ask/set/polygon_parts.h>
#include <sunder/ask/set/polygons_input.h>

#include <sunder/base/error.h>
#include <sunder/io/text.h>

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <span>

namespace sunder::ask {

namespace {

using planar::Polygon;

// What is wrong with the parts of a feature, in words, where something is.
std::optional<std::string> defect_of(std::span<const Rings> parts, planar::PolygonRule rule) {
  const planar::PolygonDefects answer = planar::polygon_defects(parts, {rule, 1});
  if (answer.valid()) return std::nullopt;
  return text_of(answer.defects.front(), parts.size() > 1);
}

class Reader {
 public:
  explicit Reader(const PolygonsRequest& request) : request_(request) {
    if (request.group == "ring") {
      throw Error(ErrorCode::bad_call, "rings belong to polygons; group by a property", "--group");
    }
    if (request.group == "feature") {
      throw Error(ErrorCode::bad_call,
                  "each feature is one polygon, and its parts are not compared; leave it out, or group by a property",
                  "--group");
    }
    if (request.files.size() > 1 && !request.group.empty()) {
      throw Error(ErrorCode::bad_call, "two files are two groups; leave it out, or give one file", "--group");
    }
  }

  PolygonsInput read() {
    if (is_strict()) input_.skipped_kind = "not strictly simple feature";
    for (const std::string& name : request_.files) read_file(name);
    if (!input_.skipped.empty() && !request_.skip_invalid) refuse();
    for (std::uint32_t file = 0; file < input_.files.size(); ++file) {
      const bool some = std::any_of(input_.source.begin(), input_.source.end(),
                                    [&](const PolygonSource& source) { return source.file == file; });
      if (some) continue;
      io::fail_file(request_.files[file], input_.skipped.empty() ? "no polygon with an area is left; give others"
                                          : is_strict()
                                              ? "no polygon is strictly simple, so nothing is left to ask about"
                                              : "no polygon is valid, so nothing is left to ask about");
    }
    return std::move(input_);
  }

 private:
  // What is valid need not be strictly simple.
  bool is_strict() const { return request_.rule == planar::PolygonRule::simple; }

  void read_file(const std::string& name) {
    const auto file = static_cast<std::uint32_t>(input_.files.size());
    input_.names.push_back(name);
    {
      Progress progress("reading");
      io::LineOptions options;
      options.drop_z = request_.drop_z;
      options.lines = false;
      options.leave_out = request_.leave_out;
      options.keep_broken = true;
      options.group = request_.group;
      options.name = request_.name;
      options.progress = progress.reporter();
      options.inputs = request_.tell_inputs ? &input_.inputs : nullptr;
      input_.files.push_back(io::read_lines(name, options));
    }
    input_.left_out.add(name, input_.files.back().left_out, "");
    PartsReader reader(input_.files.back());
    for (Parts parts; reader.next(parts);) add(file, parts);
  }

  void add(std::uint32_t file, Parts& parts) {
    if (request_.mend) mend_parts(file, parts);
    for (Rings& rings : parts.rings) {
      for (std::vector<Point2>& ring : rings) {
        if (!request_.by_part) leave_out_repeated(ring);
      }
    }
    try {
      if (!parts.broken.empty()) return skip(file, parts, parts.broken);
      if (request_.rule) {
        if (const auto defect = defect_of(parts.rings, *request_.rule)) return skip(file, parts, *defect);
      }
      add_polygons(file, parts);
    } catch (const Error& error) {  // a ring of too few different vertices
      skip(file, parts, error.what());
    }
  }

  void mend_parts(std::uint32_t file, Parts& parts) {
    const MendedRings changes = mend(parts);
    if (changes.all() > 0) input_.mended.push_back({file, parts.feature, changes});
  }

  void skip(std::uint32_t file, const Parts& parts, const std::string& why) {
    input_.skipped.push_back({file, parts.feature, parts.line, io::one_line(why)});
  }

  void add_polygons(std::uint32_t file, const Parts& parts) {
    PolygonSource source{file, parts.feature, parts.line};
    if (request_.by_part) {
      for (const Rings& rings : parts.rings) {
        add_polygon(rings, source, parts.group);
        ++source.part;
      }
      return;
    }
    if (parts.rings.empty()) return;
    Rings all;
    for (std::uint32_t p = 0; p < parts.rings.size(); ++p) {
      all.insert(all.end(), parts.rings[p].begin(), parts.rings[p].end());
      if (parts.rings.size() > 1) source.part_of_ring.resize(all.size(), p);
    }
    add_polygon(all, source, parts.group);
  }

  void add_polygon(const Rings& rings, const PolygonSource& source, std::uint32_t group) {
    input_.polygons.emplace_back(rings);
    input_.source.push_back(source);
    if (request_.files.size() > 1) {
      input_.groups.push_back(source.file);
    } else if (!input_.files.front().groups.empty()) {
      input_.groups.push_back(group);
    }
  }

  [[noreturn]] void refuse() const {
    const SkippedFeature& first = input_.skipped.front();
    const std::size_t others = input_.skipped.size() - 1;
    const std::string what = fmt::format(
        "feature {}: is not {}: {}{}; mend it (sunder simple{} tells more{}), or give --skip-invalid to ask about the "
        "others",
        input_.feature_text(first.file, first.feature), is_strict() ? "strictly simple" : "valid", first.why,
        others > 0 ? fmt::format("; nor {} {}", others == 1 ? "is" : "are", count_of(others, "other feature")) : "",
        is_strict() ? " --strict" : "", request_.mend ? "" : "; --mend does what is safe");
    const std::string& name = input_.names[first.file];
    if (first.line > 0) io::fail_line(name, first.line, what);
    io::fail_file(name, what);
  }

  const PolygonsRequest& request_;
  PolygonsInput input_;
};

constexpr std::size_t most_listed = 20;

std::string and_more(std::size_t all) {
  return all > most_listed ? fmt::format("              and {} more; --json has all\n", all - most_listed) : "";
}

}  // namespace

const std::string& PolygonsInput::name(std::uint32_t polygon) const {
  return files[source[polygon].file].features[source[polygon].feature];
}

std::uint64_t PolygonsInput::features() const {
  std::uint64_t all = 0;
  for (const io::LineFile& file : files) all += file.features.size();
  return all;
}

std::uint64_t PolygonsInput::edges() const {
  std::uint64_t all = 0;
  for (const Polygon& polygon : polygons) all += polygon.size();
  return all;
}

std::string PolygonsInput::feature_text(std::uint32_t file, std::uint32_t feature) const {
  const std::string number = std::to_string(feature + 1), &name = files[file].features[feature];
  return name == number ? number : fmt::format("{} ({})", number, name);
}

std::string PolygonsInput::left_out_words() const {
  std::string words;
  if (!skipped.empty()) words = fmt::format("skipped: {}", count_of(skipped.size(), skipped_kind));
  if (!left_out.empty()) words += fmt::format("{}left out: {}", words.empty() ? "" : "; ", left_out.text());
  return words;
}

Origin PolygonsInput::origin() const {
  Origin origin{inputs, {}};
  if (!skipped.empty()) origin.left_out.push_back(fmt::format("skipped: {}", count_of(skipped.size(), skipped_kind)));
  for (const std::string& text : left_out.texts()) origin.left_out.push_back(text);
  if (!mended.empty()) origin.left_out.push_back(fmt::format("mended: {}", count_of(mended.size(), "feature")));
  return origin;
}

std::string PolygonsInput::tell() const {
  std::string text;
  const auto of_file = [&](std::uint32_t file) { return files.size() > 1 ? io::one_line(names[file]) + ": " : ""; };
  for (std::size_t k = 0; k < std::min(skipped.size(), most_listed); ++k) {
    const SkippedFeature& s = skipped[k];
    text += fmt::format("  skipped     {}feature {}: {}\n", of_file(s.file), feature_text(s.file, s.feature), s.why);
  }
  text += and_more(skipped.size());
  for (std::size_t k = 0; k < std::min(mended.size(), most_listed); ++k) {
    const MendedFeature& m = mended[k];
    text += fmt::format("  mended      {}feature {}: {}\n", of_file(m.file), feature_text(m.file, m.feature),
                        text_of(m.changes));
  }
  text += and_more(mended.size());
  if (!left_out.empty()) text += fmt::format("  left out    {}\n", left_out.text());
  for (const io::LineFile& file : files) {
    for (const std::string& remark : file.remarks) text += fmt::format("  remark      {}\n", remark);
  }
  return text;
}

void PolygonsInput::tell(Json& report) const {
  const auto feature = [&](const auto& f) {
    return Json{
        {"file", io::one_line(names[f.file])}, {"feature", f.feature}, {"name", files[f.file].features[f.feature]}};
  };
  for (const SkippedFeature& s : skipped) {
    Json entry = feature(s);
    entry["why"] = s.why;
    report["skipped"].push_back(entry);
  }
  for (const MendedFeature& m : mended) {
    Json entry = feature(m);
    entry.update(to_json(m.changes));
    report["mended"].push_back(entry);
  }
  if (!left_out.empty()) report["left_out"] = to_json(left_out);
  for (const io::LineFile& file : files) {
    for (const std::string& remark : file.remarks) report["remarks"].push_back(remark);
  }
}

PolygonsInput read_polygons(const PolygonsRequest& request) { return Reader(request).read(); }

}  // namespace sunder::ask
