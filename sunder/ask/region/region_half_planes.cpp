// sunder region: of half-planes.
#include <sunder/ask/region/region_question.h>

#include <sunder/base/error.h>
#include <sunder/io/text/text.h>
#include <sunder/io/text/triples.h>
#include <sunder/picture/region.h>
#include <sunder/planar/region/half_plane_intersection.h>
#include <sunder/planar/region/linear_program.h>
#include <sunder/planar/region/linear_program_claims.h>
#include <sunder/planar/region/regions_claims.h>

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

namespace sunder::ask {

namespace {

using planar::Constraints;
using planar::Objective;
using planar::Region;
using planar::RegionKind;

using HalfPlanesMethod = Region(const Constraints&, const planar::RegionOptions&);
constexpr std::array<Named<HalfPlanesMethod>, 4> half_planes_methods{
    {{"automatic", planar::half_plane_intersection<Constraints>, "planar::half_plane_intersection"},
     {"sort", planar::half_plane_intersection_by_sort<Constraints>, "planar::half_plane_intersection_by_sort"},
     {"division", planar::half_plane_intersection_by_division<Constraints>,
      "planar::half_plane_intersection_by_division"},
     {"scan", planar::half_plane_intersection_by_scan<Constraints>, "planar::half_plane_intersection_by_scan"}}};

io::TripleFile read_half_planes(const RegionCall& call, const Talk& talk, Origin& origin) {
  return io::read_triples(call.file, io::half_plane_rows,
                          {.progress = talk.progress("reading"), .inputs = call.proves() ? &origin.inputs : nullptr});
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

// "2 x - 3 y"
std::string form_text(double a, double b) {
  return fmt::format("{:.10g} x {} {:.10g} y", a, b < 0 ? "-" : "+", std::fabs(b));
}

const char* shape_of(RegionKind kind) {
  switch (kind) {
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

class HalfPlanesQuestion final : public RegionQuestion {
 public:
  static constexpr const char* drawn_noun = "half-plane";

  HalfPlanesQuestion(const RegionCall& asked, Talk& told)
      : RegionQuestion(asked, told),
        method_(method_by(asked.method, half_planes_methods)),
        objective_(objective_of(asked.maximize)),
        file_(read_half_planes(asked, told, origin_)),
        constraints_(constraints_of(file_, asked.file)) {}

  std::uint64_t drawn() const { return constraints_.size(); }
  void ask() {
    function_ = objective_ ? "planar::linear_program_by_region" : method_.function;
    region_ = method_(constraints_, {call.proves()});
    if (objective_) best_ = linear_program_by_region(constraints_, region_, *objective_);
    const std::vector<std::uint32_t>& sides = region_.sides;
    is_empty_ = region_.empty();
    cost_ = region_.cost;
    cost_.probes += best_.cost.probes;
    cost_.exact += best_.cost.exact;
    things_ = count_of(constraints_.size(), "half-plane");
    object_json_ = {{"format", "CSV"}, {"half_planes", constraints_.size()}};
    region_json_ = {
        {"kind", name_of(region_.kind)}, {"sides", sides}, {"names", Json::array()}, {"lines", Json::array()}};
    for (const std::uint32_t k : sides) {
      region_json_["names"].push_back(file_.name[k]);
      region_json_["lines"].push_back(file_.line[k]);
    }
    if (is_empty_) {
      verdict_ = "empty: these contradict each other";
      named_ = sides;
      return;
    }
    verdict_ = fmt::format("{}, bounded by {}", shape_of(region_.kind), count_of(sides.size(), "half-plane"));
    corners_ = corners(region_);
    corner_count_ = corners_.size();
  }
  std::string certificate() const {
    if (!objective_) return planar::certificate_text(constraints_, region_, origin());
    return planar::certificate_text(constraints_, *objective_, best_, origin(), is_empty_ ? nullptr : &region_);
  }

  Report report() const {
    Report report = RegionQuestion::report();
    if (is_empty_) report.tell("  certain positive multiples of them add up to 0 <= a negative number\n");
    if (!objective_) return report;
    Json best{{"objective", {objective_->p, objective_->q}}, {"outcome", name_of(best_.verdict())}};
    for (const auto& [key, k] : tight()) {
      if (k != planar::no_half_plane) best[key] = k;
    }
    if (is_feasible(best_)) {
      const Point2 p = best_point();
      best["point"] = {p.x, p.y};
    }
    report.add("best", std::move(best), best_text());
    return report;
  }

  std::string picture() const {
    picture::RegionPicture picture{constraints_, region_, file_.name};
    if (objective_ && is_feasible(best_) && best_.verdict() != Optimum::unbounded) {
      picture.best = best_point();
      picture.objective = {objective_->p, objective_->q};
    }
    picture.title = call.title_or("What is common to these half-planes?");
    picture.summary = fmt::format("{}: {}", things_, is_empty_ ? "nothing is common to all" : shape_of(region_.kind));
    return picture::region_svg(picture);
  }

 private:
  Origin origin() const {
    Origin origin = by_this_call(talk, origin_);
    origin.said = said_of_rows("half_planes", constraints_.size(),
                               said_of_file(Said::Source::half_planes, origin.inputs, call.file));
    return origin;
  }

  std::string thing_text(std::uint32_t k) const override {
    const auto& [a, b, c] = constraints_[k];
    return fmt::format("half-plane {}, line {}: {} <= {:.10g}", file_.name[k], file_.line[k], form_text(a, b), c);
  }
  Point2 corner(std::size_t k) const override {
    const auto& [i, j] = corners_[k];
    return nearest(exact_corner(constraints_[i], constraints_[j]));
  }
  std::string corner_text(std::size_t k) const override {
    const auto& [i, j] = corners_[k];
    return fmt::format("  corner at about {}, of {} and {}\n", place_text(corner(k)), file_.name[i], file_.name[j]);
  }
  Json corner_json(std::size_t k) const override { return {{"sides", corners_[k]}}; }

  // From the exact point: of rounded coordinates nothing may be left where products cancel. Infinite beyond doubles.
  double best_value() const {
    const ExactPoint2 p = point_of(constraints_, best_);
    return nearest_ratio(Dyadic(objective_->p) * p.x + Dyadic(objective_->q) * p.y, p.denominator);
  }
  Point2 best_point() const { return nearest(point_of(constraints_, best_)); }

  // The half-planes that the evidence names, or no_half_plane.
  using Named3 = std::array<std::pair<const char*, std::uint32_t>, 3>;
  Named3 tight() const {
    return std::visit(
        [](const auto& held) -> Named3 {
          if constexpr (requires { held.from; }) {
            return {{{"before", held.from.before}, {"side", held.side}, {"after", held.from.after}}};
          } else if constexpr (requires { held.side; }) {
            return {{{"before", held.before}, {"side", held.side}, {"after", held.after}}};
          } else {  // of the objective zero, which holds none
            return {{{"", planar::no_half_plane}, {"", planar::no_half_plane}, {"", planar::no_half_plane}}};
          }
        },
        best_.evidence);
  }

  std::string best_text() const {
    const std::string aim = form_text(objective_->p, objective_->q);
    if (!is_feasible(best_)) return "";
    if (best_.verdict() == Optimum::unbounded) return fmt::format("{} is as great as one likes\n", aim);
    if (best_.verdict() == Optimum::all) {
      return fmt::format("{} is zero everywhere: every common point is an optimum; they are {}\n", aim,
                         shape_of(region_.kind));
    }
    const double value = best_value();
    std::string text = fmt::format(
        "{} is greatest, {}, {} about {}\n", aim,
        std::isfinite(value) ? fmt::format("about {:.10g}", value) : "beyond the range of doubles",
        best_.verdict() == Optimum::one ? "at" : "at more points than one, such as", place_text(best_point()));
    for (const auto& [key, k] : tight()) {
      if (k != planar::no_half_plane) text += fmt::format("    held by {}\n", thing_text(k));
    }
    return text;
  }

  Named<HalfPlanesMethod> method_;
  std::optional<Objective> objective_;
  Origin origin_;
  io::TripleFile file_;
  Constraints constraints_;
  Region region_;
  planar::LinearProgramAnswer best_;
  std::vector<std::array<std::uint32_t, 2>> corners_;  // by their sides
};

}  // namespace

Report run_region_half_planes(const RegionCall& call, Talk& talk) {
  return answer(HalfPlanesQuestion(call, talk), talk);
}

std::string half_plane_method_names() { return method_names(half_planes_methods); }

}  // namespace sunder::ask
