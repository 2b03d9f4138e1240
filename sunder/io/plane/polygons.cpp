#include <sunder/io/plane/polygons.h>

#include <sunder/io/plane/polygon_parts.h>
#include <sunder/io/text/text.h>

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <span>

namespace sunder::io {

namespace {

using planar::Polygon;
using planar::PolygonDefect;
using planar::PolygonRings;
using planar::RingPlace;
using DefectKind = planar::PolygonDefectKind;

bool of_one_ring(const PolygonDefect& d) { return d.a.part == d.b.part && d.a.ring == d.b.ring; }

std::string ring_text(const RingPlace& place, bool has_parts) {
  return has_parts ? fmt::format("part {}, ring {}", place.part, place.ring) : fmt::format("ring {}", place.ring);
}

std::string edges_text(const PolygonDefect& d) {
  if (d.a == d.b) return fmt::format("edge {}", d.a.edge);
  if (of_one_ring(d)) return fmt::format("edges {} and {}", d.a.edge, d.b.edge);
  return fmt::format("edge {} of the one, edge {} of the other", d.a.edge, d.b.edge);
}

// What is wrong with the parts of a feature, in words, where something is.
std::optional<std::string> defect_of(std::span<const PolygonRings> parts, planar::PolygonRule rule) {
  const planar::PolygonDefects answer = planar::polygon_defects(parts, {rule, 1});
  if (answer.found.empty()) return std::nullopt;
  return text_of(answer.found.front(), parts.size() > 1);
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
    input_.systems = CoordinateSystems(request_.mixed_crs);
    if (is_strict()) input_.skipped_kind = "not strictly simple feature";
    for (const std::string& name : request_.files) read_file(name);
    if (!input_.skipped.empty() && !request_.skip_invalid) refuse();
    for (std::uint32_t file = 0; file < input_.files.size(); ++file) {
      const bool some = std::any_of(input_.source.begin(), input_.source.end(),
                                    [&](const PolygonSource& source) { return source.file == file; });
      if (some) continue;
      fail_file(request_.files[file], input_.skipped.empty() ? "no polygon with an area is left; give others"
                                      : is_strict() ? "no polygon is strictly simple, so nothing is left to ask about"
                                                    : "no polygon is valid, so nothing is left to ask about");
    }
    return std::move(input_);
  }

 private:
  // What is valid need not be strictly simple.
  bool is_strict() const { return request_.rule == planar::PolygonRule::simple; }

  void read_file(const std::string& name) {
    const auto file = static_cast<std::uint32_t>(input_.files.size());
    input_.read_file(name,
                     {.drop_z = request_.drop_z,
                      .group = request_.group,
                      .progress = request_.progress,
                      .leave_out = request_.leave_out,
                      .keep_broken = true,
                      .name = request_.name,
                      .properties = request_.properties},
                     request_.tell_inputs);
    PolygonPartsReader reader(input_.files.back());
    for (PolygonParts parts; reader.next(parts);) add(file, parts);
  }

  void add(std::uint32_t file, PolygonParts& parts) {
    if (request_.mend) {
      const planar::MendedRings changes = mend(parts);
      if (changes.all() > 0) input_.mended.push_back({file, parts.feature, parts.line, changes, parts.rings.empty()});
    }
    for (PolygonRings& rings : parts.rings) {
      for (std::vector<Point2>& ring : rings) {
        if (!request_.by_part) planar::leave_out_repeated(ring);
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

  void skip(std::uint32_t file, const PolygonParts& parts, const std::string& why) {
    input_.skipped.push_back({file, parts.feature, parts.line, one_line(why)});
  }

  void add_polygons(std::uint32_t file, const PolygonParts& parts) {
    PolygonSource source{file, parts.feature, parts.line};
    if (request_.by_part) {
      for (const PolygonRings& rings : parts.rings) {
        add_polygon(rings, source, parts.group);
        ++source.part;
      }
      return;
    }
    if (parts.rings.empty()) return;
    PolygonRings all;
    for (std::uint32_t p = 0; p < parts.rings.size(); ++p) {
      all.insert(all.end(), parts.rings[p].begin(), parts.rings[p].end());
      if (parts.rings.size() > 1) source.part_of_ring.resize(all.size(), p);
    }
    add_polygon(all, source, parts.group);
  }

  void add_polygon(const PolygonRings& rings, const PolygonSource& source, std::uint32_t group) {
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
    if (first.line > 0) fail_line(name, first.line, what);
    fail_file(name, what);
  }

  const PolygonsRequest& request_;
  PolygonsInput input_;
};

}  // namespace

std::string text_of(const PolygonDefect& d, bool has_parts) {
  const std::string a = ring_text(d.a, has_parts), b = ring_text(d.b, has_parts), at = place_text(d.place.a);
  const std::string both = of_one_ring(d) ? a : a + " and " + b;
  const auto meet = [&](const char* itself, const char* other) {
    return fmt::format("{} {} at about {}: {}", both, of_one_ring(d) ? itself : other, at, edges_text(d));
  };
  switch (d.kind) {
    case DefectKind::too_few_points: return fmt::format("{} has fewer than three different vertices, at {}", a, at);
    case DefectKind::crossing: return meet("crosses itself", "cross");
    case DefectKind::overlap:
      return fmt::format("{} {} from about {} to {}: {}", both,
                         of_one_ring(d) ? "runs along itself" : "have a piece in common", at, place_text(d.place.b),
                         edges_text(d));
    case DefectKind::repeated_vertex:
      return fmt::format("{}: vertices {} and {} are the same, {}", a, d.a.edge, d.b.edge, at);
    case DefectKind::self_touch: return meet("touches itself", "touch");
    case DefectKind::rings_touch: return meet("touches itself", "touch");
    case DefectKind::hole_outside:
      return fmt::format("{} is a hole outside of its shell, at {}: edge {}", a, at, d.a.edge);
    case DefectKind::nested_holes: return fmt::format("{} is a hole inside of a hole, ring {}, at {}", a, d.b.ring, at);
    case DefectKind::disconnected:
      return fmt::format("{} part{} the interior in two at {}", both, of_one_ring(d) ? "s" : "", at);
    case DefectKind::nested_parts: return fmt::format("part {} is inside of part {}, at {}", d.a.part, d.b.part, at);
  }
  return "";
}

const std::string& PolygonsInput::name(std::uint32_t polygon) const {
  return files[source[polygon].file].features[source[polygon].feature];
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

std::string PolygonsInput::skipped_text() const {
  return skipped.empty() ? "" : fmt::format("skipped: {}", count_of(skipped.size(), skipped_kind));
}

std::string PolygonsInput::emptied_text() const {
  const auto count = std::count_if(mended.begin(), mended.end(), [](const MendedFeature& f) { return f.is_empty; });
  return count == 0 ? ""
                    : fmt::format("without area, so empty when mended: {}",
                                  count_of(static_cast<std::uint64_t>(count), "feature"));
}

std::string PolygonsInput::left_out_words() const {
  std::string words;
  for (const std::string& more :
       {skipped_text(), emptied_text(), left_out.empty() ? std::string() : "left out: " + left_out.text()}) {
    if (!more.empty()) words += (words.empty() ? "" : "; ") + more;
  }
  return words;
}

Origin PolygonsInput::origin() const {
  Origin origin{inputs, left_out.texts()};
  if (!skipped.empty()) origin.left_out.insert(origin.left_out.begin(), skipped_text());
  if (!mended.empty()) origin.left_out.push_back(fmt::format("mended: {}", count_of(mended.size(), "feature")));
  if (const std::string emptied = emptied_text(); !emptied.empty()) origin.left_out.push_back(emptied);
  return origin;
}

void PolygonsInput::read_file(const std::string& name, LineOptions options, bool tell_inputs) {
  options.lines = false;
  options.inputs = tell_inputs ? &inputs : nullptr;
  names.push_back(name);
  files.push_back(read_lines(name, options));
  left_out.add(name, files.back().left_out, "");
  systems.add(name, files.back().systems);
}

PolygonsInput read_polygons(const PolygonsRequest& request) { return Reader(request).read(); }

}  // namespace sunder::io
