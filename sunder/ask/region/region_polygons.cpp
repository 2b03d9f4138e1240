// sunder region --of polygons: convex ones.
#include <sunder/ask/region/region_question.h>

#include <sunder/base/error.h>
#include <sunder/io/text/text.h>
#include <sunder/picture/plane.h>
#include <sunder/planar/object/convex_either_way.h>
#include <sunder/planar/region/convex_polygon_intersection.h>
#include <sunder/planar/region/regions_claims.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

namespace sunder::ask {

namespace {

using picture::Ink;
using picture::PlanePicture;

using planar::ConvexPolygon;
using planar::PolygonFeature;
using planar::PolygonsCorner;
using planar::PolygonsPart;
using planar::PolygonsPartKind;

using PartMethod = PolygonsPart(std::span<const ConvexPolygon>);
constexpr std::array<Named<PartMethod>, 4> part_methods{
    {SUNDER_METHOD("automatic", planar::convex_polygon_intersection),
     SUNDER_METHOD("division", planar::convex_polygon_intersection_by_division),
     SUNDER_METHOD("edges", planar::convex_polygon_intersection_by_edges),
     SUNDER_METHOD("scan", planar::convex_polygon_intersection_by_scan)}};

planar::EitherWay convex(const planar::Polygon& polygon, bool mend) {
  if (polygon.ring_count() > 1) throw Error(ErrorCode::bad_shape, "has holes; give convex polygons");
  try {
    if (mend) return {ConvexPolygon::mended(polygon.vertices())};
    return planar::convex_either_way(polygon.vertices());
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

// Those of the input; it loses the ones that are skipped. changed: how many are not as they were given.
std::vector<ConvexPolygon> convex_polygons(const RegionCall& call, PolygonsInput& input, std::uint64_t& changed) {
  std::vector<ConvexPolygon> polygons;
  polygons.reserve(input.polygons.size());
  std::vector<planar::Polygon> given;  // those that are not skipped, like kept
  std::vector<PolygonSource> kept;
  std::uint64_t clockwise = 0;
  std::string first_clockwise;
  for (std::uint32_t i = 0; i < input.polygons.size(); ++i) {
    const PolygonSource& source = input.source[i];
    const std::string feature = input.feature_text(source.file, source.feature);
    try {
      auto [polygon, reversed] = convex(input.polygons[i], call.polygons.mend);
      polygons.push_back(std::move(polygon));
      if (reversed && clockwise++ == 0) first_clockwise = feature;
      const std::string change =
          call.polygons.mend ? change_text(polygons.back(), input.polygons[i].vertices()) : std::string();
      if (!change.empty()) ++changed;
      if (!change.empty())
        input.files.front().remarks.push_back(fmt::format("feature {}: mended: {}", feature, change));
      given.push_back(std::move(input.polygons[i]));
      kept.push_back(source);
    } catch (const Error& error) {
      if (!call.polygons.skip_invalid) io::fail_file(call.file, fmt::format("feature {}: {}", feature, error.what()));
      input.skipped.push_back({source.file, source.feature, source.line, error.what()});
    }
  }
  if (clockwise > 0) {
    input.files.front().remarks.push_back(fmt::format(
        "{} clockwise, the first of feature {}: their vertices are taken in reverse, so that vertex k of n is "
        "vertex n - 1 - k of the file, and edge k is edge n - 2 - k",
        clockwise == 1 ? "1 polygon is" : fmt::format("{} polygons are", clockwise), first_clockwise));
  }
  if (polygons.empty()) io::fail_file(call.file, "no polygon is convex, so nothing is left to ask about");
  input.polygons = std::move(given);
  input.source = std::move(kept);
  return polygons;
}

class PolygonsQuestion final : public RegionQuestion {
 public:
  static constexpr const char* drawn_noun = "edge";

  PolygonsQuestion(const RegionCall& asked, Talk& told)
      : RegionQuestion(asked, told),
        method_(method_by(asked.method, part_methods)),
        input_(read_with_progress(told, asked.request())),
        polygons_(convex_polygons(asked, input_, changed_)) {}

  std::uint64_t drawn() const { return input_.edges(); }
  void ask() {
    function_ = method_.function;
    talk.note_all(input_.systems.remarks());
    part_ = method_(polygons_);
    for (const PolygonsCorner& c : part_.corners) corners_.push_back(nearest(exact_point(corner_point(polygons_, c))));
    corner_count_ = corners_.size();
    is_empty_ = part_.kind == PolygonsPartKind::empty;
    cost_ = part_.cost;
    const std::string& format = input_.files.front().format;
    things_ = fmt::format("{}, {}", count_of(polygons_.size(), "convex polygon"), format);
    object_json_ = {{"format", format}, {"polygons", polygons_.size()}};
    region_json_ = {{"kind", name_of(part_.kind)}};
    verdict_ = is_empty_ ? fmt::format("empty{}: these have nothing in common", without()) : shape() + without();
    // The polygons of a contradiction, each once.
    for (const planar::PolygonSupport& s : part_.supports()) named_.push_back(s.vertex.polygon);
    std::sort(named_.begin(), named_.end());
    named_.erase(std::unique(named_.begin(), named_.end()), named_.end());
  }
  std::string certificate() const { return planar::certificate_text(polygons_, by_this_call(talk, origin())); }

  Report report() const {
    Report report = RegionQuestion::report();
    if (is_empty_) report.add("contradiction", named_);
    report.add(facts_of(input_));
    report.add(facts_of(input_.systems));
    return report;
  }

  std::string picture() const {
    std::vector<Point2> seen;
    for (const ConvexPolygon& p : polygons_) seen.insert(seen.end(), p.vertices().begin(), p.vertices().end());
    PlanePicture drawing(seen);
    draw_things(polygons_.size(), [&](std::uint32_t i, Ink ink) { drawing.polygon(polygons_[i].vertices(), ink); });
    switch (part_.kind) {
      case PolygonsPartKind::polygon:
        drawing.polygon(corners_, Ink::bold);
        drawing.legend(Ink::bold, "common to all");
        break;
      case PolygonsPartKind::segment: drawing.segment(corners_[0], corners_[1], Ink::accent); break;
      case PolygonsPartKind::point: drawing.dot(corners_[0], Ink::accent, "the only point"); break;
      default: drawing.legend(Ink::accent, "have nothing in common");
    }
    return drawing.text(call.title_or("What is common to these convex polygons?"),
                        fmt::format("{}: {}", count_of(polygons_.size(), "convex polygon"),
                                    is_empty_ ? "nothing is common to all" : shape()) +
                            without());
  }

 private:
  Origin origin() const {
    Origin origin = origin_of(input_, "convex_polygons", call.polygons.drop_z);
    if (changed_ == 0) return origin;
    for (auto& [entries, said] : origin.said.at(0).parts) {
      said = said.mended({fmt::format("{} made convex or turned round", count_of(changed_, "polygon"))});
    }
    return origin;
  }

  // Of what the verdict does not speak.
  std::string without() const {
    const std::string words = input_.left_out_words();
    return words.empty() ? "" : fmt::format(", of the {} read ({})", count_of(polygons_.size(), "polygon"), words);
  }

  std::string thing_text(std::uint32_t i) const override {
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

  Point2 corner(std::size_t k) const override { return corners_[k]; }
  std::string corner_text(std::size_t k) const override {
    const auto& [is_vertex, a, b] = part_.corners[k];
    const std::string of_a = fmt::format("{} of {}", a.number, thing_text(a.polygon));
    return fmt::format(
        "  corner at about {}: {}\n", place_text(corners_[k]),
        is_vertex ? "vertex " + of_a : fmt::format("edge {} and edge {} of {}", of_a, b.number, thing_text(b.polygon)));
  }
  Json corner_json(std::size_t k) const override {
    const auto& [is_vertex, a, b] = part_.corners[k];
    if (is_vertex) return {{"vertex", {a.polygon, a.number}}};
    return {{"edges", {{a.polygon, a.number}, {b.polygon, b.number}}}};
  }

  Named<PartMethod> method_;
  PolygonsInput input_;
  std::uint64_t changed_ = 0;  // polygons that --mend changed
  std::vector<ConvexPolygon> polygons_;
  PolygonsPart part_;
  std::vector<Point2> corners_;  // rounded
};

}  // namespace

Report run_region_polygons(const RegionCall& call, Talk& talk) { return answer(PolygonsQuestion(call, talk), talk); }

std::string polygon_method_names() { return method_names(part_methods); }

}  // namespace sunder::ask
