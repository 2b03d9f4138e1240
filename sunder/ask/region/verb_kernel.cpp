// sunder kernel FILE: from which points of a polygon are all of its points seen?
#include <sunder/ask/region/region_question.h>
#include <sunder/ask/verb.h>

#include <sunder/base/error.h>
#include <sunder/io/text/file.h>
#include <sunder/io/text/text.h>
#include <sunder/picture/plane.h>
#include <sunder/planar/region/kernel.h>
#include <sunder/planar/region/regions_claims.h>
#include <sunder/predicate/line/constraints.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <memory>
#include <numeric>

namespace sunder::ask {

namespace {

using picture::Ink;
using picture::PlanePicture;

using planar::PolygonSides;
using planar::Region;
using planar::RegionKind;

using KernelMethod = Region(const PolygonSides&, const planar::RegionOptions&);
constexpr std::array<Named<KernelMethod>, 4> methods{
    {SUNDER_METHOD("automatic", planar::kernel),
     SUNDER_METHOD("half-planes", planar::kernel_by_half_plane_intersection),
     SUNDER_METHOD("lee-preparata", planar::kernel_by_lee_preparata), SUNDER_METHOD("scan", planar::kernel_by_scan)}};

struct KernelResult {
  std::uint32_t polygon = 0;
  Region kernel;
  std::vector<Point2> corners;
};

std::string edge_text(const planar::Polygon& polygon, std::uint32_t k) {
  const planar::Segment e = polygon.edge(k);
  return fmt::format("edge {}: {} to {}", k, place_text(e.a), place_text(e.b));
}

class KernelQuestion : public FeasibilityQuestion {
 public:
  static constexpr const char *verb = "kernel", *drawn_noun = "edge";

  KernelQuestion(const RegionCall& asked, Talk& told)
      : FeasibilityQuestion(asked, told),
        method_(method_by(asked.method, methods)),
        input_(read_with_progress(told, request_of(asked))) {
    for (std::uint32_t i = 0; i < input_.polygons.size(); ++i) {
      if (!call.feature.empty() && input_.name(i) != call.feature) continue;
      if (input_.polygons[i].ring_count() > 1) {
        io::fail_file(call.file,
                      fmt::format("feature {}: has holes, so no kernel; give its outer ring alone", input_.name(i)));
      }
      results_.push_back({i, {}, {}});
    }
    if (results_.empty()) {
      throw Error(ErrorCode::bad_call, fmt::format("{} has no polygon named {}", call.file, io::quote(call.feature)),
                  "--feature");
    }
    if (call.proves() && results_.size() > 1) {
      throw Error(ErrorCode::bad_call, "a proof is about one polygon; name it by --feature", "--certificate");
    }
  }

  std::uint64_t drawn() const {
    return std::accumulate(results_.begin(), results_.end(), std::uint64_t{0},
                           [this](std::uint64_t sum, const KernelResult& r) { return sum + polygon(r).size(); });
  }
  void ask() {
    function_ = method_.function;
    talk.note_all(input_.systems.remarks());
    for (KernelResult& result : results_) {
      const PolygonSides sides(polygon(result));
      result.kernel = method_(sides, {call.proves()});
      cost_.probes += result.kernel.cost.probes;
      cost_.exact += result.kernel.cost.exact;
      if (result.kernel.empty()) {
        is_empty_ = true;
        continue;
      }
      for (const auto& [j, k] : corners(result.kernel)) {
        result.corners.push_back(nearest(exact_corner(sides[j], sides[k])));
      }
    }
  }
  std::string certificate() const {
    Origin origin = by_this_call(talk, input_.origin());
    if (input_.mended.empty()) origin.left_out.clear();  // a proof about one polygon speaks of no others
    origin.said = said_of_rows("rings", 1, said_of_ring());
    return planar::certificate_text(PolygonSides(polygon(results_[0])), results_[0].kernel, origin);
  }

  Report report() const {
    Report report = FeasibilityQuestion::report();
    for (const KernelResult& result : results_) {
      const PolygonSource& source = input_.source[result.polygon];
      Json object = {{"file", io::one_line(call.file)},
                     {"feature", source.feature + 1},
                     {"name", input_.name(result.polygon)},
                     {"part", source.part},
                     {"kind", name_of(result.kernel.kind)},
                     {"sides", result.kernel.sides},
                     {"corners", Json::array()}};
      for (const Point2& p : result.corners) object["corners"].push_back({{"point", {p.x, p.y}}});
      report.objects.push_back(std::move(object));
      report.tell(fmt::format("feature {}: {}", input_.name(result.polygon), text_of(result)));
    }
    report.tell(fmt::format("{}: {}\n", io::one_line(call.file), verdict()));
    report.add(facts_of(input_));
    report.add(facts_of(input_.systems));
    return report;
  }

  std::string picture() const {
    std::vector<Point2> seen;
    for (const KernelResult& result : results_) {
      const auto& vertices = polygon(result).vertices();
      seen.insert(seen.end(), vertices.begin(), vertices.end());
    }
    PlanePicture drawing(seen);
    for (const KernelResult& result : results_) {
      drawing.polygon(polygon(result).vertices(), Ink::calm);
      if (result.kernel.empty()) {
        for (const std::uint32_t k : result.kernel.sides) {
          drawing.segment(polygon(result).edge(k).a, polygon(result).edge(k).b, Ink::accent);
        }
        continue;
      }
      drawing.polygon(result.corners, Ink::bold);
      for (const Point2& p : result.corners) drawing.dot(p, Ink::bold);
    }
    drawing.legend(Ink::bold, "sees all of the polygon");
    drawing.legend(Ink::accent, "edges that no point sees together");
    return drawing.text(call.title_or("From where is all of it seen?"), verdict());
  }

 private:
  // "1 of 2 polygons have a kernel, among these only: skipped: 1 invalid feature"
  std::string verdict() const {
    const auto seen =
        std::count_if(results_.begin(), results_.end(), [](const KernelResult& r) { return !r.kernel.empty(); });
    const std::string without = input_.left_out_words();
    return fmt::format("{} of {} {} a kernel{}", seen, count_of(results_.size(), "polygon"),
                       results_.size() == 1 ? "has" : "have", without.empty() ? "" : ", among these only: " + without);
  }

  Said said_of_ring() const {
    const PolygonSource& source = input_.source[results_[0].polygon];
    Said said = said_of_file(Said::Source::polygons, input_.inputs, call.file, input_.name(results_[0].polygon));
    if (said.empty()) return said;
    const io::LineFile& file = input_.files[source.file];
    said = said_in(std::span(&file.systems[file.system[source.feature]], 1), std::move(said));
    if (call.polygons.drop_z) said = said.dropped("z");
    for (const io::MendedFeature& feature : input_.mended) {
      if (feature.feature == source.feature) said = said.mended({ask::text_of(feature.changes)});
    }
    return said;
  }

  static PolygonsRequest request_of(const RegionCall& call) {
    PolygonsRequest request = call.request();
    request.rule = planar::PolygonRule::simple;
    return request;
  }

  const planar::Polygon& polygon(const KernelResult& result) const { return input_.polygons[result.polygon]; }

  std::string text_of(const KernelResult& result) const {
    if (result.kernel.empty()) {
      std::string text = "no kernel: no point sees the inner sides of these edges\n";
      for (const std::uint32_t k : result.kernel.sides) text += "  " + edge_text(polygon(result), k) + "\n";
      return text;
    }
    const char* const shape = result.kernel.kind == RegionKind::point     ? "one point"
                              : result.kernel.kind == RegionKind::segment ? "a segment"
                                                                          : "a convex polygon";
    return fmt::format("the kernel is {} of {}\n", shape, count_of(result.corners.size(), "corner")) +
           first_of(result.corners.size(), 12, [&](std::size_t k) {
             return fmt::format("  corner at about {}\n", place_text(result.corners[k]));
           });
  }

  Named<KernelMethod> method_;
  PolygonsInput input_;
  std::vector<KernelResult> results_;
};

Report run_kernel(const RegionCall& call, Talk& talk) { return answer(KernelQuestion(call, talk), talk); }

}  // namespace

Verb kernel_verb() {
  const auto call = std::make_shared<RegionCall>();
  return {"kernel",
          "From which points of a simple polygon is the whole polygon visible?",
          "0 each polygon has a kernel; 1 some have none",
          {{"FILE", &call->file, "simple polygons without holes: WKT, GeoJSON", "", true},
           {"--feature", &call->feature, "examine only the polygon of this name", "NAME"},
           {"--name", &call->polygons.name, name_help, "FIELD"},
           {"--skip-invalid", &call->polygons.skip_invalid, skip_invalid_help},
           {"--mend", &call->polygons.mend, mend_help},
           {"--leave-out", &call->polygons.leave_out, leave_out_help},
           {"--method", &call->method, method_names(methods), "NAME"},
           certificate_option(call->certificate),
           {"--svg", &call->svg, "draw the polygons and their kernels to FILE", "FILE"},
           title_option(call->title),
           svg_limit_option(call->svg_limit),
           {"--drop-z", &call->polygons.drop_z, "ignore the third coordinate of each point"},
           {"--mixed-crs", &call->polygons.mixed_crs, mixed_crs_help},
           json_option(call->json)},
          [call](Talk& talk) { return run_kernel(*call, talk); }};
}

}  // namespace sunder::ask
