// sunder region FILE: what is the common part of half-planes, of circles, of convex polygons? Its best point?
#include <sunder/ask/progress.h>
#include <sunder/ask/region/region_circles.h>
#include <sunder/ask/region/region_polygons.h>
#include <sunder/ask/report.h>
#include <sunder/ask/verb.h>

#include <sunder/base/error.h>
#include <sunder/io/file.h>
#include <sunder/io/text.h>
#include <sunder/io/triples.h>
#include <sunder/picture/region.h>
#include <sunder/planar/region/half_plane_intersection.h>
#include <sunder/planar/region/linear_program.h>
#include <sunder/planar/region/linear_program_json.h>
#include <sunder/planar/region/regions_json.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <optional>

namespace sunder::ask {

namespace {

using planar::Constraints;
using planar::LinearProgramAnswer;
using planar::Objective;
using planar::Optimum;
using planar::Region;
using planar::RegionKind;

using Call = RegionCall;

using RegionMethod = Region(const Constraints&, const planar::RegionOptions&);
constexpr std::array<Named<RegionMethod>, 4> methods{
    {{"automatic", planar::half_plane_intersection<Constraints>},
     {"sort", planar::half_plane_intersection_by_sort<Constraints>},
     {"division", planar::half_plane_intersection_by_division<Constraints>},
     {"scan", planar::half_plane_intersection_by_scan<Constraints>}}};

Constraints constraints_of(const io::TripleFile& file, const std::string& name) {
  std::vector<Constraint> rows;
  rows.reserve(file.rows.size());
  for (std::size_t k = 0; k < file.rows.size(); ++k) {
    const auto& [a, b, c] = file.rows[k];
    if (a == 0 && b == 0) {
      io::fail_line(name, file.line[k], "a and b are zero, which makes no half-plane; leave the line out");
    }
    rows.push_back({a, b, c});
  }
  return Constraints(std::move(rows));
}

std::optional<Objective> objective_of(const std::string& text) {
  if (text.empty()) return std::nullopt;
  const std::vector<double> numbers = parse_numbers(text, "--maximize");
  if (numbers.size() != 2) {
    throw Error(ErrorCode::bad_call, fmt::format("{}; give two, p,q", count_of(numbers.size(), "number")),
                "--maximize");
  }
  return Objective{numbers[0], numbers[1]};
}

std::string about(const Constraint& k) {
  return fmt::format("{:.10g} x {} {:.10g} y <= {:.10g}", k.a, k.b < 0 ? "-" : "+", std::fabs(k.b), k.c);
}

class HalfPlanesQuestion {
 public:
  static constexpr const char *verb = "region", *drawn_noun = "half-plane";
  const Call& call;

  explicit HalfPlanesQuestion(const Call& asked)
      : call(asked),
        method_(method_by(asked.method, methods)),
        objective_(objective_of(asked.maximize)),
        file_(read(asked, origin_)),
        constraints_(constraints_of(file_, asked.file)) {}

  std::uint64_t drawn() const { return constraints_.size(); }
  void ask() {
    region_ = method_(constraints_, {call.proves()});
    if (objective_) best_ = linear_program_by_region(constraints_, region_, *objective_);
  }
  std::string certificate() const {
    return objective_ ? planar::certificate_text(constraints_, *objective_, best_, origin_)
                      : planar::certificate_text(constraints_, region_, origin_);
  }

  bool yes() const { return region_.empty(); }
  const char* answer() const { return yes() ? "infeasible" : "feasible"; }
  Cost cost() const {
    Cost sum = region_.cost;
    sum.probes += best_.cost.probes;
    sum.exact += best_.cost.exact;
    return sum;
  }
  std::string cost_text() const { return count_of(cost().probes, "sign"); }
  const char* proof_clause() const { return ""; }

  std::string text() const {
    std::string text = fmt::format("{}: {}\n", io::one_line(call.file), count_of(constraints_.size(), "half-plane"));
    if (yes()) {
      text += "empty: these contradict each other\n" + contradiction();
    } else {
      text +=
          fmt::format("{}, bounded by {}\n", shape(), count_of(region_.sides.size(), "half-plane")) + corners_text();
    }
    return objective_ ? text + best_text() : text;
  }

  void add_to(Json& json) const {
    json["objects"] =
        Json::array({{{"file", io::one_line(call.file)}, {"format", "CSV"}, {"half_planes", constraints_.size()}}});
    json["region"] = {
        {"kind", name_of(region_.kind)}, {"sides", region_.sides}, {"names", Json::array()}, {"lines", Json::array()}};
    for (const std::uint32_t k : region_.sides) {
      json["region"]["names"].push_back(file_.name[k]);
      json["region"]["lines"].push_back(file_.line[k]);
    }
    json["region"]["corners"] = Json::array();
    if (!region_.empty()) {
      for (const auto& [i, j] : corners(region_)) {
        const Point2 p = corner(i, j);
        json["region"]["corners"].push_back({{"sides", {i, j}}, {"point", {p.x, p.y}}});
      }
    }
    if (objective_) {
      json["best"] = {{"objective", {objective_->p, objective_->q}}, {"outcome", name_of(best_.outcome)}};
      for (const auto& [key, k] : tight()) {
        if (k != planar::no_half_plane && best_.outcome != Optimum::all) json["best"][key] = k;
      }
      if (best_.feasible()) {
        const Point2 p = best_point();
        json["best"]["point"] = {p.x, p.y};
      }
    }
  }

  std::string picture() const {
    picture::RegionPicture picture{constraints_, region_, file_.name};
    if (objective_ && best_.feasible() && best_.outcome != Optimum::unbounded) {
      picture.best = best_point();
      picture.objective = {objective_->p, objective_->q};
    }
    picture.title = call.title_or("What is common to these half-planes?");
    picture.summary = fmt::format("{}: {}", count_of(constraints_.size(), "half-plane"),
                                  region_.empty() ? "nothing is common to all" : shape());
    return picture::region_svg(picture);
  }

 private:
  static io::TripleFile read(const Call& call, Origin& origin) {
    Progress progress("reading");
    return io::read_triples(call.file, io::half_plane_rows, {}, progress.reporter(), {},
                            call.proves() ? &origin.inputs : nullptr);
  }

  std::string shape() const {
    switch (region_.kind) {
      case RegionKind::empty: return "empty";
      case RegionKind::point: return "one point";
      case RegionKind::segment: return "a segment";
      case RegionKind::ray: return "a ray";
      case RegionKind::line: return "a line";
      case RegionKind::strip: return "a strip";
      case RegionKind::half_plane: return "a half-plane";
      case RegionKind::unbounded: return "a region without bounds";
      case RegionKind::bounded: return "a bounded region";
      case RegionKind::plane: return "the whole plane";
    }
    return "";
  }

  Point2 corner(std::uint32_t i, std::uint32_t j) const {
    return nearest(exact_corner(constraints_[i], constraints_[j]));
  }
  // From the exact point: of rounded coordinates nothing may be left where products cancel. Infinite beyond doubles.
  double best_value() const {
    const ExactPoint2 p = point_of(constraints_, best_);
    return nearest_ratio(Dyadic(objective_->p) * p.x + Dyadic(objective_->q) * p.y, p.denominator);
  }
  Point2 best_point() const { return nearest(point_of(constraints_, best_)); }

  std::string half_plane(std::uint32_t k) const {
    return fmt::format("{}, line {}: {}", file_.name[k], file_.line[k], about(constraints_[k]));
  }

  std::string contradiction() const {
    std::string text;
    for (const std::uint32_t k : region_.sides) text += fmt::format("    half-plane {}\n", half_plane(k));
    text += "  certain positive multiples of them add up to 0 <= a negative number\n";
    return text;
  }

  std::string corners_text() const {
    const auto all = corners(region_);
    return first_of(all.size(), 20, [&](std::size_t k) {
      const auto [i, j] = all[k];
      return fmt::format("  corner at about {}, of {} and {}\n", place_text(corner(i, j)), file_.name[i],
                         file_.name[j]);
    });
  }

  std::array<std::pair<const char*, std::uint32_t>, 3> tight() const {
    return {{{"before", best_.before}, {"side", best_.side}, {"after", best_.after}}};
  }

  std::string best_text() const {
    const std::string aim =
        fmt::format("{:.10g} x {} {:.10g} y", objective_->p, objective_->q < 0 ? "-" : "+", std::fabs(objective_->q));
    if (!best_.feasible()) return "";
    if (best_.outcome == Optimum::unbounded) return fmt::format("{} is as great as one likes\n", aim);
    if (best_.outcome == Optimum::all) {
      return fmt::format("{} is zero everywhere: every common point is an optimum; they are {}\n", aim, shape());
    }
    const double value = best_value();
    std::string text = fmt::format(
        "{} is greatest, {}, {} about {}\n", aim,
        std::isfinite(value) ? fmt::format("about {:.10g}", value) : "beyond the range of doubles",
        best_.outcome == Optimum::one ? "at" : "at more points than one, such as", place_text(best_point()));
    for (const auto& [key, k] : tight()) {
      if (k != planar::no_half_plane) text += fmt::format("    held by half-plane {}\n", half_plane(k));
    }
    return text;
  }

  RegionMethod* method_;
  std::optional<Objective> objective_;
  Origin origin_;
  io::TripleFile file_;
  Constraints constraints_;
  Region region_;
  LinearProgramAnswer best_;
};

int run(const Call& call) {
  const bool of_half_planes = call.of == "half-planes", of_circles = call.of == "circles";
  const bool of_polygons = call.of == "polygons";
  if (!of_half_planes && !of_circles && !of_polygons) {
    throw Error(
        ErrorCode::bad_call,
        fmt::format("there is no common part of {}; there are half-planes, circles, polygons", io::quote(call.of)),
        "--of");
  }
  if (!of_half_planes && !call.maximize.empty()) {
    throw Error(ErrorCode::bad_call, "only half-planes have a best point here; leave it out", "--maximize");
  }
  for (const auto& [given, option] :
       {std::pair(call.polygons.mend, "--mend"), std::pair(call.polygons.drop_z, "--drop-z"),
        std::pair(call.polygons.leave_out, "--leave-out"), std::pair(call.polygons.skip_invalid, "--skip-invalid"),
        std::pair(!call.polygons.name.empty(), "--name")}) {
    if (given && !of_polygons) throw Error(ErrorCode::bad_call, "is for polygons; leave it out", option);
  }
  if (of_circles) return run_region_circles(call);
  if (of_polygons) return run_region_polygons(call);
  HalfPlanesQuestion question(call);
  return answer(question);
}

}  // namespace

Verb region_verb() {
  const auto call = std::make_shared<Call>();
  return {
      "region",
      "What is the common part of half-planes, circles, or convex polygons? Its best point? Which contradict each "
      "other?",
      "0 something is common to all; 1 nothing is",
      {{"FILE", &call->file, "half-planes a x + b y <= c: CSV (a,b,c, and a name if you like)", "", true},
       {"--of", &call->of, "half-planes; circles: CSV x,y,r; or convex polygons: WKT, GeoJSON", "KIND"},
       {"--maximize", &call->maximize, "two numbers p,q: where is p x + q y greatest?", "P,Q"},
       {"--method", &call->method, "automatic, sort (of half-planes), edges (of polygons), division, or scan", "NAME"},
       certificate_option(call->certificate,
                          "write the proof here: of the region, or with --maximize of the best point"),
       {"--svg", &call->svg, "draw the common part here", "FILE"},
       title_option(call->title),
       svg_limit_option(call->svg_limit),
       {"--mend", &call->polygons.mend,
        "polygons: leave out repeated and collinear vertices, turn clockwise ones round"},
       {"--skip-invalid", &call->polygons.skip_invalid, "polygons: answer for the convex ones, and list the others"},
       {"--leave-out", &call->polygons.leave_out, "polygons: leave out points and lines, and say so"},
       {"--name", &call->polygons.name, "polygons: the property that names them; unless given, name, NAME, id",
        "FIELD"},
       {"--drop-z", &call->polygons.drop_z, "polygons: ignore third coordinates"},
       json_option(call->json)},
      [call] { return run(*call); }};
}

}  // namespace sunder::ask
