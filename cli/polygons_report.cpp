#include <cli/plane_picture.h>
#include <cli/polygons_report.h>

#include <sunder/io/text.h>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace sunder::cli {

namespace {

using planar::Polygon;
using planar::PolygonsContact;

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

// The part of polygon i that the contact shows, counted from 0; null where it shows none: of the one that a vertex of
// the other is inside of.
Json part_of(const PolygonsInput& input, const PolygonsContact& c, bool of_i) {
  if (c.kind == planar::ContactKind::none && c.i_inside != of_i) return nullptr;
  const std::uint32_t polygon = of_i ? c.i : c.j;
  const std::vector<std::uint32_t>& part = input.source[polygon].part_of_ring;
  return part.empty() ? 0 : part[input.polygons[polygon].ring_of(of_i ? c.of_i : c.of_j)];
}

// Requires that a group was asked for.
const std::string& group_of(const PolygonsInput& input, std::uint32_t polygon) {
  return input.files.front().groups[input.groups[polygon]];
}

std::string about(const Point2& p) { return fmt::format("({:.10g}, {:.10g})", p.x, p.y); }

std::string counts_text(const PolygonsResult& result) {
  std::string text;
  if (result.overlapping > 0) text += fmt::format("{} overlapping", result.overlapping);
  if (result.touching > 0) text += fmt::format("{}{} touching", text.empty() ? "" : ", ", result.touching);
  return text;
}

// "Chad of farms, part 2 (a.wkt, line 7)"
std::string polygon_text(const PolygonsCall& call, const PolygonsInput& input, const PolygonsContact& c, bool of_i) {
  const std::uint32_t i = of_i ? c.i : c.j, line = input.line(i);
  std::string text = input.name(i);
  if (call.groups()) text += fmt::format(" of {}", group_of(input, i));
  const Json part = part_of(input, c, of_i);
  if (!input.source[i].part_of_ring.empty() && !part.is_null()) text += fmt::format(", part {}", part.dump());
  std::vector<std::string> place;
  if (input.files.size() > 1) place.push_back(io::one_line(input.names[input.source[i].file]));
  if (line > 0) place.push_back(fmt::format("line {}", line));
  return place.empty() ? text : fmt::format("{} ({})", text, fmt::join(place, ", "));
}

// "some meet (touch allowed): 2 pairs: 2 touching; 1 invalid feature skipped"
std::string verdict_text(const PolygonsCall& call, const PolygonsInput& input, const PolygonsResult& result) {
  const bool some = result.pairs() > 0;
  std::vector<std::string> rules;
  if (call.allow != "nothing") rules.push_back(call.allow + " allowed");
  if (input.files.size() > 1) rules.emplace_back("those of one file may meet");
  std::string text = fmt::format("{} meet", some ? "some" : "none");
  if (!rules.empty()) text += fmt::format(" ({})", fmt::join(rules, "; "));
  if (some && (call.lists() || call.count)) {
    text += fmt::format(": {}: {}", count_of(result.pairs(), "pair"), counts_text(result));
  }
  const std::string without = input.left_out_words();
  if (!without.empty()) {
    text += fmt::format(", said of the {} only: {}", count_of(input.polygons.size(), "feature"), without);
  }
  return text + "\n";
}

Json properties_of(const PolygonsCall& call, const PolygonsInput& input, const PolygonsContact& c) {
  const PolygonSource &i = input.source[c.i], &j = input.source[c.j];
  Json json = {{"i", i.feature}, {"j", j.feature}};
  if (input.files.size() > 1) json["files"] = {i.file, j.file};
  json["contact"] = name_of(c.contact);
  json["shown_by"] = shown_by(c);
  json["names"] = {input.name(c.i), input.name(c.j)};
  json["parts"] = {part_of(input, c, true), part_of(input, c, false)};
  if (i.line > 0) json["lines"] = {i.line, j.line};
  if (call.groups()) json["groups"] = {group_of(input, c.i), group_of(input, c.j)};
  return json;
}

}  // namespace

std::string human_text(const PolygonsCall& call, const PolygonsInput& input, const PolygonsResult& result,
                       std::span<const PolygonsContact> listed) {
  std::string text;
  for (std::size_t f = 0; f < input.files.size(); ++f) {
    const auto of_file = [&](const PolygonSource& source) { return source.file == f; };
    const auto features = static_cast<std::uint64_t>(std::count_if(input.source.begin(), input.source.end(), of_file));
    std::uint64_t edges = 0;
    for (std::size_t k = 0; k < input.polygons.size(); ++k)
      edges += of_file(input.source[k]) ? input.polygons[k].size() : 0;
    text += fmt::format("{}: {}, {}, {}\n", io::one_line(input.names[f]), count_of(features, "polygon"),
                        count_of(edges, "edge"), input.files[f].format);
  }
  if (call.groups()) {
    text +=
        fmt::format("{}; those of one {} may meet\n", count_of(input.files.front().groups.size(), "group"), call.group);
  }
  text += verdict_text(call, input, result);
  for (std::size_t k = 0; k < listed.size(); ++k) {
    const PolygonsContact& c = listed[k];
    text += fmt::format("{} {}: {} and {}: {} at about {}\n", call.lists() ? fmt::format("  {}.", k + 1) : " ",
                        name_of(c.contact), polygon_text(call, input, c, true), polygon_text(call, input, c, false),
                        shown_by(c), about(place_of(input, c)));
  }
  if (call.lists() && result.pairs() > listed.size()) {
    text += fmt::format("  and {} more; --json, --geojson or --svg have all\n", result.pairs() - listed.size());
  }
  text += input.tell();
  text += fmt::format("  cost        {}\n", count_of(result.cost.probes, "comparison"));
  if (!call.certificate.empty()) text += fmt::format("  proof       {}\n", call.certificate);
  if (!call.geojson.empty()) text += fmt::format("  contacts    {}\n", call.geojson);
  if (!call.svg.empty()) text += fmt::format("  picture     {}\n", call.svg);
  return text;
}

Json report(const PolygonsCall& call, const PolygonsInput& input, const PolygonsResult& result) {
  Json json = envelope("polygons", result.pairs() > 0 ? "some" : "none", call.method);
  json["cost"] = cli::to_json(result.cost);
  json["objects"] = Json::array();
  std::vector<std::uint64_t> polygons(input.files.size()), edges(input.files.size());
  for (std::size_t k = 0; k < input.polygons.size(); ++k) {
    ++polygons[input.source[k].file];
    edges[input.source[k].file] += input.polygons[k].size();
  }
  for (std::size_t f = 0; f < input.files.size(); ++f) {
    json["objects"].push_back({{"file", io::one_line(input.names[f])},
                               {"format", input.files[f].format},
                               {"features", input.files[f].features.size()},
                               {"polygons", polygons[f]},
                               {"edges", edges[f]}});
  }
  json["allowed"] = call.allow;
  if (!call.group.empty()) json["group"] = call.group;
  input.tell(json);
  if (call.lists() || call.count) {
    json["count"] = result.pairs();
    json["counts"] = {{"overlapping", result.overlapping}, {"touching", result.touching}};
  }
  return json;
}

Json to_json(const PolygonsCall& call, const PolygonsInput& input, const PolygonsContact& contact) {
  Json json = properties_of(call, input, contact);
  const Point2 p = place_of(input, contact);
  json["point"] = {p.x, p.y};
  return json;
}

std::string contact_feature(const PolygonsCall& call, const PolygonsInput& input, const PolygonsContact& contact,
                            std::uint64_t number) {
  const Point2 p = place_of(input, contact);
  Json properties = {{"number", number}};
  properties.update(properties_of(call, input, contact));
  const Json feature = {{"type", "Feature"},
                        {"geometry", {{"type", "Point"}, {"coordinates", {p.x, p.y}}}},
                        {"properties", std::move(properties)}};
  return feature.dump(-1, ' ', false, Json::error_handler_t::replace);
}

std::string picture(const PolygonsCall& call, const PolygonsInput& input, const PolygonsResult& result,
                    std::span<const PolygonsContact> contacts) {
  std::vector<Point2> seen;
  for (const Polygon& polygon : input.polygons) {
    seen.insert(seen.end(), polygon.vertices().begin(), polygon.vertices().end());
  }
  PlanePicture drawing(seen);
  std::vector<Contact> strongest(input.polygons.size(), Contact::none);
  for (const PolygonsContact& c : contacts) {
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
  for (const PolygonsContact& c : contacts) {
    if (c.contact == Contact::overlapping) drawing.dot(place_of(input, c), Ink::accent);
  }
  drawing.legend(Ink::accent, fmt::format("overlapping {}", result.overlapping));
  drawing.legend(Ink::second, fmt::format("touching {}", result.touching));
  drawing.legend(Ink::calm, "meets no other");
  const std::string without = input.left_out_words();
  return drawing.text(call.title.empty() ? "Which of these polygons meet?" : call.title,
                      fmt::format("{}; {}{}", count_of(input.polygons.size(), "polygon"),
                                  result.pairs() == 0 ? "none meet" : count_of(result.pairs(), "pair") + " meet",
                                  without.empty() ? "" : "; " + without));
}

}  // namespace sunder::cli
