// sunder region FILE: what is the common part of half-planes, of circles, of convex polygons? Its best point?
#include <cli/common.h>
#include <cli/progress.h>
#include <cli/region_circles.h>
#include <cli/region_picture.h>
#include <cli/region_polygons.h>

#include <sunder/base/error.h>
#include <sunder/io/file.h>
#include <sunder/io/text.h>
#include <sunder/io/triples.h>
#include <sunder/planar/region/half_plane_intersection.h>
#include <sunder/planar/region/linear_program.h>
#include <sunder/planar/region/linear_program_json.h>
#include <sunder/planar/region/regions_json.h>

#include <fmt/format.h>
#include <CLI/App.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <optional>

namespace sunder::cli {

namespace {

using planar::Constraints;
using planar::LinearProgramAnswer;
using planar::Objective;
using planar::Optimum;
using planar::Region;
using planar::RegionKind;

using Call = RegionCall;

using RegionMethod = Region(const Constraints&, const planar::RegionOptions&);
RegionMethod* region_method(const std::string& name) {
  if (name == "automatic") return planar::half_plane_intersection<Constraints>;
  if (name == "sort") return planar::half_plane_intersection_by_sort<Constraints>;
  if (name == "division") return planar::half_plane_intersection_by_division<Constraints>;
  if (name == "scan") return planar::half_plane_intersection_by_scan<Constraints>;
  refuse_method(name, "automatic, sort, division, scan");
}

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

std::string about(const Point2& p) { return fmt::format("({:.10g}, {:.10g})", p.x, p.y); }

std::string about(const Constraint& k) {
  return fmt::format("{:.10g} x {} {:.10g} y <= {:.10g}", k.a, k.b < 0 ? "-" : "+", std::fabs(k.b), k.c);
}

// A program's question and its answer.
class Report {
 public:
  Report(const Call& call, const io::TripleFile& file, const Constraints& constraints, const Region& region,
         const std::optional<Objective>& objective)
      : call_(call), file_(file), constraints_(constraints), region_(region), objective_(objective) {
    if (objective_) best_ = linear_program_by_region(constraints_, region_, *objective_);
  }

  std::string human() const {
    std::string text = fmt::format("{}: {}\n", io::one_line(call_.file), count_of(constraints_.size(), "half-plane"));
    if (region_.empty()) {
      text += "empty: these contradict each other\n" + contradiction();
    } else {
      text +=
          fmt::format("{}, bounded by {}\n", shape(), count_of(region_.sides.size(), "half-plane")) + corners_text();
    }
    if (objective_) text += best_text();
    text += fmt::format("  cost        {}\n", count_of(cost().probes, "sign"));
    if (!call_.certificate.empty()) text += fmt::format("  proof       {}\n", io::one_line(call_.certificate));
    if (!call_.svg.empty()) text += fmt::format("  picture     {}\n", io::one_line(call_.svg));
    return text;
  }

  Json json() const {
    Json json = envelope("region", region_.empty() ? "infeasible" : "feasible", call_.method);
    json["cost"] = to_json(cost());
    json["objects"] =
        Json::array({{{"file", io::one_line(call_.file)}, {"format", "CSV"}, {"half_planes", constraints_.size()}}});
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
    return json;
  }

  std::string picture() const {
    RegionPicture picture{constraints_, region_};
    if (objective_ && best_.feasible() && best_.outcome != Optimum::unbounded) {
      picture.best = best_point();
      picture.objective = {objective_->p, objective_->q};
    }
    picture.title = call_.title.empty() ? "What is common to these half-planes?" : call_.title;
    picture.summary = fmt::format("{}: {}", count_of(constraints_.size(), "half-plane"),
                                  region_.empty() ? "nothing is common to all" : shape());
    return region_svg(picture);
  }

 private:
  static constexpr std::size_t most_listed = 20;

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

  Cost cost() const {
    Cost sum = region_.cost;
    sum.probes += best_.cost.probes;
    sum.exact += best_.cost.exact;
    return sum;
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
    std::string text;
    const auto all = corners(region_);
    for (std::size_t k = 0; k < std::min(all.size(), most_listed); ++k) {
      const auto [i, j] = all[k];
      text += fmt::format("  corner at about {}, of {} and {}\n", about(corner(i, j)), file_.name[i], file_.name[j]);
    }
    if (all.size() > most_listed) text += fmt::format("  and {} more; --json has all\n", all.size() - most_listed);
    return text;
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
    std::string text =
        fmt::format("{} is greatest, {}, {} about {}\n", aim,
                    std::isfinite(value) ? fmt::format("about {:.10g}", value) : "beyond the range of doubles",
                    best_.outcome == Optimum::one ? "at" : "at more points than one, such as", about(best_point()));
    for (const auto& [key, k] : tight()) {
      if (k != planar::no_half_plane) text += fmt::format("    held by half-plane {}\n", half_plane(k));
    }
    return text;
  }

  const Call& call_;
  const io::TripleFile& file_;
  const Constraints& constraints_;
  const Region& region_;
  std::optional<Objective> objective_;
  LinearProgramAnswer best_;
};

int run_half_planes(const Call& call) {
  const auto method = region_method(call.method);
  const std::optional<Objective> objective = objective_of(call.maximize);
  Origin origin;
  const io::TripleFile file = [&] {
    Progress progress("reading");
    return io::read_triples(call.file, io::half_plane_rows, {}, progress.reporter(), {},
                            call.certificate.empty() ? nullptr : &origin.inputs);
  }();
  const Constraints constraints = constraints_of(file, call.file);
  if (!call.svg.empty()) require_drawable(constraints.size(), "half-plane", 0, call.svg_limit);
  const Region region = method(constraints, {!call.certificate.empty()});
  if (!call.certificate.empty()) {
    io::write_file_atomically(
        call.certificate,
        objective ? planar::certificate_text(constraints, *objective,
                                             linear_program_by_region(constraints, region, *objective), origin)
                  : planar::certificate_text(constraints, region, origin));
  }
  const Report report(call, file, constraints, region, objective);
  if (!call.svg.empty()) io::write_file_atomically(call.svg, report.picture());
  call.json ? print(to_text(report.json())) : print_for_people(report.human());
  return region.empty() ? exit_code::yes : exit_code::no;
}

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
       {std::pair(call.mend, "--mend"), std::pair(call.drop_z, "--drop-z"), std::pair(call.leave_out, "--leave-out"),
        std::pair(call.skip_invalid, "--skip-invalid"), std::pair(!call.name.empty(), "--name")}) {
    if (given && !of_polygons) throw Error(ErrorCode::bad_call, "is for polygons; leave it out", option);
  }
  if (of_half_planes) return run_half_planes(call);
  return of_circles ? run_region_circles(call) : run_region_polygons(call);
}

}  // namespace

void add_region(CLI::App& program, int& code) {
  auto call = std::make_shared<Call>();
  CLI::App* verb = program.add_subcommand("region",
                                          "What is the common part of half-planes, circles, or convex polygons? Its "
                                          "best point? Which contradict each other?");
  verb->add_option("FILE", call->file, "half-planes a x + b y <= c: CSV (a,b,c, and a name if you like)")->required();
  verb->add_option("--of", call->of, "half-planes; circles: CSV x,y,r; or convex polygons: WKT, GeoJSON")
      ->type_name("KIND");
  verb->add_option("--maximize", call->maximize, "two numbers p,q: where is p x + q y greatest?")->type_name("P,Q");
  verb->add_option("--method", call->method, "automatic, sort (of half-planes), edges (of polygons), division, or scan")
      ->type_name("NAME");
  verb->add_option("--certificate", call->certificate,
                   "write the proof here: of the region, or with --maximize of the best point")
      ->type_name("FILE");
  auto* svg = verb->add_option("--svg", call->svg, "draw the common part here")->type_name("FILE");
  verb->add_option("--title", call->title, "of the picture")->needs(svg);
  add_svg_limit(*verb, call->svg_limit);
  verb->add_flag("--mend", call->mend,
                 "polygons: leave out repeated and collinear vertices, turn clockwise ones round");
  verb->add_flag("--skip-invalid", call->skip_invalid, "polygons: answer for the convex ones, and list the others");
  verb->add_flag("--leave-out", call->leave_out, "polygons: leave out points and lines, and say so");
  verb->add_option("--name", call->name, "polygons: the property that names them; unless given, name, NAME, id")
      ->type_name("FIELD");
  verb->add_flag("--drop-z", call->drop_z, "polygons: ignore third coordinates");
  verb->add_flag("--json", call->json, "print a report in JSON");
  verb->callback([call, &code] { code = run(*call); });
}

}  // namespace sunder::cli
