#include <cli/common.h>
#include <cli/plane_picture.h>
#include <cli/polygons_input.h>
#include <cli/region_polygons.h>

#include <sunder/base/error.h>
#include <sunder/io/file.h>
#include <sunder/io/text.h>
#include <sunder/planar/region/convex_polygon_intersection.h>
#include <sunder/planar/region/regions_json.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace sunder::cli {

namespace {

using planar::ConvexPolygon;
using planar::PolygonFeature;
using planar::PolygonsCorner;
using planar::PolygonsPart;
using planar::PolygonsPartKind;

using PartMethod = PolygonsPart(std::span<const ConvexPolygon>);
PartMethod* part_method(const std::string& name) {
  if (name == "automatic") return planar::convex_polygon_intersection;
  if (name == "division") return planar::convex_polygon_intersection_by_division;
  if (name == "edges") return planar::convex_polygon_intersection_by_edges;
  if (name == "scan") return planar::convex_polygon_intersection_by_scan;
  refuse_method(name, "automatic, division, edges, scan");
}

ConvexPolygon convex(const planar::Polygon& polygon, bool mend) {
  if (polygon.ring_count() > 1) throw Error(ErrorCode::bad_shape, "has holes; give convex polygons");
  try {
    return mend ? ConvexPolygon::mended(polygon.vertices()) : ConvexPolygon::from_vertices(polygon.vertices());
  } catch (const Error& error) {
    throw Error(error.code(), fmt::format("{}{}", error.what(), mend ? "" : "; or give --mend"));
  }
}

// Does the convex polygon go round the other way than the ring that it was made of?
bool turned(const ConvexPolygon& convex, const std::vector<Point2>& ring) {
  const auto at = [&](std::uint32_t k) {
    return std::find(ring.begin(), ring.end(), convex.vertices()[k]) - ring.begin();
  };
  return convex.size() > 2 && ((at(0) < at(1)) + (at(1) < at(2)) + (at(2) < at(0))) < 2;
}

// What --mend changed besides, as a remark; empty where nothing.
std::string change_text(const ConvexPolygon& convex, const std::vector<Point2>& ring) {
  std::string text;
  if (convex.size() < ring.size()) text = fmt::format("{} of {} vertices kept", convex.size(), ring.size());
  if (turned(convex, ring)) text += text.empty() ? "turned round" : ", turned round";
  return text;
}

// Those of the input; it loses the ones that are skipped.
std::vector<ConvexPolygon> convex_polygons(const RegionCall& call, PolygonsInput& input) {
  std::vector<ConvexPolygon> polygons;
  polygons.reserve(input.polygons.size());
  std::vector<planar::Polygon> given;  // those that are not skipped, like kept
  std::vector<PolygonSource> kept;
  for (std::uint32_t i = 0; i < input.polygons.size(); ++i) {
    const PolygonSource& source = input.source[i];
    const std::string feature = input.feature_text(source.file, source.feature);
    try {
      polygons.push_back(convex(input.polygons[i], call.mend));
      const std::string change = change_text(polygons.back(), input.polygons[i].vertices());
      if (!change.empty())
        input.files.front().remarks.push_back(fmt::format("feature {}: mended: {}", feature, change));
      given.push_back(std::move(input.polygons[i]));
      kept.push_back(source);
    } catch (const Error& error) {
      if (!call.skip_invalid) io::fail_file(call.file, fmt::format("feature {}: {}", feature, error.what()));
      input.skipped.push_back({source.file, source.feature, source.line, error.what()});
    }
  }
  if (polygons.empty()) io::fail_file(call.file, "no polygon is convex, so nothing is left to ask about");
  input.polygons = std::move(given);
  input.source = std::move(kept);
  return polygons;
}

std::string about(const Point2& p) { return fmt::format("({:.10g}, {:.10g})", p.x, p.y); }

class Report {
 public:
  Report(const RegionCall& call, const PolygonsInput& input, std::span<const ConvexPolygon> polygons,
         const PolygonsPart& part)
      : call_(call), input_(input), polygons_(polygons), part_(part) {
    for (const PolygonsCorner& c : part.corners) corners_.push_back(nearest(exact_point(corner_point(polygons, c))));
  }

  std::string human() const {
    std::string text = fmt::format("{}: {}, {}\n", call_.file, count_of(polygons_.size(), "convex polygon"),
                                   input_.files.front().format);
    if (part_.kind == PolygonsPartKind::empty) {
      text += fmt::format("empty{}: these have nothing in common\n", without());
      for (const std::uint32_t i : named()) text += fmt::format("    {}\n", polygon(i));
    } else {
      text += fmt::format("{}{}\n", shape(), without()) + corners_text();
    }
    text += input_.tell();
    text += fmt::format("  cost        {}\n", count_of(part_.cost.probes, "sign"));
    if (!call_.certificate.empty()) text += fmt::format("  proof       {}\n", io::one_line(call_.certificate));
    if (!call_.svg.empty()) text += fmt::format("  picture     {}\n", io::one_line(call_.svg));
    return text;
  }

  Json json() const {
    const bool empty = part_.kind == PolygonsPartKind::empty;
    Json json = envelope("region", empty ? "infeasible" : "feasible", call_.method);
    json["cost"] = to_json(part_.cost);
    json["objects"] = Json::array({{{"file", io::one_line(call_.file)},
                                    {"format", input_.files.front().format},
                                    {"polygons", polygons_.size()}}});
    json["region"] = {{"kind", name_of(part_.kind)}, {"corners", Json::array()}};
    for (std::size_t k = 0; k < corners_.size(); ++k) {
      const PolygonsCorner& c = part_.corners[k];
      Json corner = {{"point", {corners_[k].x, corners_[k].y}}};
      if (c.is_vertex) {
        corner["vertex"] = {c.a.polygon, c.a.number};
      } else {
        corner["edges"] = {{c.a.polygon, c.a.number}, {c.b.polygon, c.b.number}};
      }
      json["region"]["corners"].push_back(corner);
    }
    if (empty) json["contradiction"] = named();
    input_.tell(json);
    return json;
  }

  std::string picture() const {
    std::vector<Point2> seen;
    for (const ConvexPolygon& p : polygons_) seen.insert(seen.end(), p.vertices().begin(), p.vertices().end());
    PlanePicture drawing(seen);
    const std::vector<std::uint32_t> guilty = named();
    const auto is_guilty = [&](std::uint32_t i) { return std::find(guilty.begin(), guilty.end(), i) != guilty.end(); };
    for (std::uint32_t i = 0; i < polygons_.size(); ++i) {
      if (!is_guilty(i)) drawing.polygon(polygons_[i].vertices(), Ink::calm);
    }
    for (const std::uint32_t i : guilty) drawing.polygon(polygons_[i].vertices(), Ink::accent);
    switch (part_.kind) {
      case PolygonsPartKind::polygon:
        drawing.polygon(corners_, Ink::bold);
        drawing.legend(Ink::bold, "common to all");
        break;
      case PolygonsPartKind::segment: drawing.segment(corners_[0], corners_[1], Ink::accent); break;
      case PolygonsPartKind::point: drawing.dot(corners_[0], Ink::accent, "the only point"); break;
      default: drawing.legend(Ink::accent, "have nothing in common");
    }
    return drawing.text(call_.title.empty() ? "What is common to these convex polygons?" : call_.title,
                        fmt::format("{}: {}", count_of(polygons_.size(), "convex polygon"),
                                    part_.kind == PolygonsPartKind::empty ? "nothing is common to all" : shape()));
  }

 private:
  static constexpr std::size_t most_listed = 20;

  // Of what the verdict does not speak.
  std::string without() const {
    const std::string words = input_.left_out_words();
    return words.empty() ? "" : fmt::format(", of the {} read ({})", count_of(polygons_.size(), "polygon"), words);
  }

  // The polygons of a contradiction, each once.
  std::vector<std::uint32_t> named() const {
    std::vector<std::uint32_t> all;
    for (const planar::PolygonSupport& s : part_.supports()) all.push_back(s.vertex.polygon);
    std::sort(all.begin(), all.end());
    all.erase(std::unique(all.begin(), all.end()), all.end());
    return all;
  }

  std::string polygon(std::uint32_t i) const {
    const std::uint32_t line = input_.line(i);
    return fmt::format("{}{}", input_.name(i), line > 0 ? fmt::format(" (line {})", line) : "");
  }

  std::string shape() const {
    switch (part_.kind) {
      case PolygonsPartKind::point: return "one point";
      case PolygonsPartKind::segment: return "a segment";
      default: return fmt::format("a region with {}", count_of(corners_.size(), "corner"));
    }
  }

  std::string corners_text() const {
    std::string text;
    for (std::size_t k = 0; k < std::min(corners_.size(), most_listed); ++k) {
      const PolygonsCorner& c = part_.corners[k];
      const std::string of = c.is_vertex ? fmt::format("vertex {} of {}", c.a.number, polygon(c.a.polygon))
                                         : fmt::format("edge {} of {} and edge {} of {}", c.a.number,
                                                       polygon(c.a.polygon), c.b.number, polygon(c.b.polygon));
      text += fmt::format("  corner at about {}: {}\n", about(corners_[k]), of);
    }
    if (corners_.size() > most_listed) {
      text += fmt::format("  and {} more; --json has all\n", corners_.size() - most_listed);
    }
    return text;
  }

  const RegionCall& call_;
  const PolygonsInput& input_;
  const std::span<const ConvexPolygon> polygons_;
  const PolygonsPart& part_;
  std::vector<Point2> corners_;  // rounded
};

}  // namespace

int run_region_polygons(const RegionCall& call) {
  PartMethod* const method = part_method(call.method);
  PolygonsRequest request;
  request.files = {call.file};
  request.drop_z = call.drop_z;
  request.leave_out = call.leave_out;
  request.skip_invalid = call.skip_invalid;
  request.mend = call.mend;
  request.by_part = true;
  request.name = call.name;
  request.tell_inputs = !call.certificate.empty();
  PolygonsInput input = read_polygons(request);
  const std::vector<ConvexPolygon> polygons = convex_polygons(call, input);
  if (!call.svg.empty()) require_drawable(input.edges(), "edge", 0, call.svg_limit);
  const PolygonsPart part = method(polygons);
  if (!call.certificate.empty()) {
    io::write_file_atomically(call.certificate, planar::certificate_text(polygons, input.origin()));
  }
  const Report report(call, input, polygons, part);
  if (!call.svg.empty()) io::write_file_atomically(call.svg, report.picture());
  call.json ? print(to_text(report.json())) : print_for_people(report.human());
  return part.kind == PolygonsPartKind::empty ? exit_code::yes : exit_code::no;
}

}  // namespace sunder::cli
