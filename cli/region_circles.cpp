#include <cli/circles_input.h>
#include <cli/common.h>
#include <cli/progress.h>
#include <cli/region_circles.h>

#include <sunder/base/error.h>
#include <sunder/io/file.h>
#include <sunder/io/text.h>
#include <sunder/picture/plane.h>
#include <sunder/planar/region/disc_intersection.h>
#include <sunder/planar/region/disc_intersection_json.h>
#include <sunder/predicate/constraints.h>
#include <sunder/predicate/disc_powers.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace sunder::cli {

namespace {

using picture::Ink;
using picture::PlanePicture;
using planar::DiscIntersection;
using planar::DiscIntersectionKind;
using planar::Discs;

using PartMethod = DiscIntersection(const Discs&);
PartMethod* part_method(const std::string& name) {
  if (name == "automatic") return planar::disc_intersection;
  if (name == "division") return planar::disc_intersection_by_division;
  if (name == "scan") return planar::disc_intersection_by_scan;
  refuse_method(name, "automatic, division, scan");
}

std::string about(const Point2& p) { return fmt::format("({:.10g}, {:.10g})", p.x, p.y); }

// The middle of what holds it.
Point2 rounded(const DiscCrossing& crossing) {
  const Enclosure2 in = enclosure(crossing);
  return {in.x.low / 2 + in.x.high / 2, in.y.low / 2 + in.y.high / 2};
}

Point2 deepest_of(const Discs& circles, const DiscIntersection& part) {
  const planar::DiscBasis basis = planar::discs_of(circles.all(), part.deepest.basis());
  return nearest(deepest_point(basis));
}

class Report {
 public:
  Report(const RegionCall& call, const io::TripleFile& file, const Discs& circles, const DiscIntersection& part)
      : call_(call), file_(file), circles_(circles), part_(part), deepest_(deepest_of(circles, part)) {}

  std::string human() const {
    std::string text = fmt::format("{}: {}\n", io::one_line(call_.file), count_of(circles_.size(), "circle"));
    const auto basis = part_.deepest.basis();
    switch (part_.kind) {
      case DiscIntersectionKind::empty:
        text += "empty: these have nothing in common\n";
        for (const std::uint32_t k : basis) text += fmt::format("    circle {}\n", circle(k));
        break;
      case DiscIntersectionKind::point:
        text += fmt::format("one point, about {}, common to\n", about(deepest_));
        for (const std::uint32_t k : basis) text += fmt::format("    circle {}\n", circle(k));
        break;
      default:
        text += fmt::format("a region bounded by {}; a point inside is about {}\n", count_of(part_.arcs.size(), "arc"),
                            about(deepest_));
        text += arcs_text();
    }
    text += fmt::format("  cost        {}\n", count_of(part_.cost.probes, "comparison"));
    if (!call_.certificate.empty()) {
      text += fmt::format("  proof       {} (of what kind it is, not of the arcs)\n", io::one_line(call_.certificate));
    }
    if (!call_.svg.empty()) text += fmt::format("  picture     {}\n", io::one_line(call_.svg));
    return text;
  }

  Json json() const {
    const bool empty = part_.kind == DiscIntersectionKind::empty;
    Json json = envelope("region", empty ? "infeasible" : "feasible", call_.method);
    json["cost"] = to_json(part_.cost);
    json["objects"] =
        Json::array({{{"file", io::one_line(call_.file)}, {"format", "CSV"}, {"circles", circles_.size()}}});
    json["region"] = {{"kind", name_of(part_.kind)}, {"arcs", part_.arcs}};
    json["region"]["corners"] = Json::array();
    for (const Point2& p : corners()) json["region"]["corners"].push_back({{"point", {p.x, p.y}}});
    json["deepest"] = {{"point", {deepest_.x, deepest_.y}}, {"circles", Json::array()}};
    for (const std::uint32_t k : part_.deepest.basis()) json["deepest"]["circles"].push_back(k);
    return json;
  }

  std::string picture() const {
    PlanePicture drawing(seen());
    std::vector<bool> named(circles_.size(), false);
    for (const std::uint32_t k : part_.deepest.basis()) named[k] = part_.kind != DiscIntersectionKind::region;
    for (std::uint32_t k = 0; k < circles_.size(); ++k) {
      if (!named[k]) drawing.circle(circles_[k], Ink::calm);
    }
    for (std::uint32_t k = 0; k < circles_.size(); ++k) {
      if (named[k]) drawing.circle(circles_[k], Ink::accent);
    }
    if (part_.kind == DiscIntersectionKind::region) {
      drawing.polygon(outline(), Ink::bold);
      for (const Point2& p : corners()) drawing.dot(p, Ink::bold);
      drawing.legend(Ink::bold, "common to all");
    } else if (part_.kind == DiscIntersectionKind::point) {
      drawing.dot(deepest_, Ink::accent, "the only point");
    } else {
      drawing.legend(Ink::accent, "have nothing in common");
    }
    return drawing.text(call_.title.empty() ? "What is common to these circles?" : call_.title,
                        fmt::format("{}: {}", count_of(circles_.size(), "circle"),
                                    part_.kind == DiscIntersectionKind::empty   ? "nothing is common to all"
                                    : part_.kind == DiscIntersectionKind::point ? "one point"
                                                                                : count_of(part_.arcs.size(), "arc")));
  }

 private:
  static constexpr std::size_t most_listed = 20;

  std::string circle(std::uint32_t k) const {
    const Disc& c = circles_[k];
    return fmt::format("{}, line {}: centre {}, radius {:.10g}", file_.name[k], file_.line[k], about(c.center),
                       c.radius);
  }

  std::vector<Point2> corners() const {
    std::vector<Point2> all;
    for (std::size_t m = 0; part_.arcs.size() > 1 && m < part_.arcs.size(); ++m) {
      all.push_back(rounded(corner(circles_, part_, m)));
    }
    return all;
  }

  std::string arcs_text() const {
    if (part_.arcs.size() == 1) return fmt::format("  all of circle {}\n", circle(part_.arcs[0]));
    std::string text;
    const std::vector<Point2> ends = corners();
    for (std::size_t m = 0; m < std::min(ends.size(), most_listed); ++m) {
      text += fmt::format("  arc of {} up to about {}\n", file_.name[part_.arcs[m]], about(ends[m]));
    }
    if (ends.size() > most_listed) text += fmt::format("  and {} more; --json has all\n", ends.size() - most_listed);
    return text;
  }

  // Points along the boundary, close to each other; for a picture.
  std::vector<Point2> outline() const {
    constexpr double step = std::numbers::pi / 180;
    const std::vector<Point2> ends = corners();
    std::vector<Point2> points;
    for (std::size_t m = 0; m < part_.arcs.size(); ++m) {
      const Disc& c = circles_[part_.arcs[m]];
      const auto angle = [&](const Point2& p) { return std::atan2(p.y - c.center.y, p.x - c.center.x); };
      const double from = ends.empty() ? 0 : angle(ends[m > 0 ? m - 1 : ends.size() - 1]);
      double to = ends.empty() ? 2 * std::numbers::pi : angle(ends[m]);
      if (to < from) to += 2 * std::numbers::pi;
      const int steps = static_cast<int>(std::ceil((to - from) / step));
      for (int k = 0; k < steps; ++k) {
        const double t = from + k * step;
        points.push_back({c.center.x + c.radius * std::cos(t), c.center.y + c.radius * std::sin(t)});
      }
    }
    return points;
  }

  // The common part with as much again around it; without a region the circles that are named.
  std::vector<Point2> seen() const {
    std::vector<Point2> points;
    if (part_.kind == DiscIntersectionKind::region) {
      points = outline();
      double room = 0;
      for (const Point2& p : points) room = std::max({room, std::fabs(p.x - deepest_.x), std::fabs(p.y - deepest_.y)});
      points.push_back({deepest_.x - 2 * room, deepest_.y - 2 * room});
      points.push_back({deepest_.x + 2 * room, deepest_.y + 2 * room});
      return points;
    }
    for (const std::uint32_t k : part_.deepest.basis()) {
      const Disc& c = circles_[k];
      points.push_back({c.center.x - c.radius, c.center.y - c.radius});
      points.push_back({c.center.x + c.radius, c.center.y + c.radius});
    }
    return points;
  }

  const RegionCall& call_;
  const io::TripleFile& file_;
  const Discs& circles_;
  const DiscIntersection& part_;
  Point2 deepest_;
};

}  // namespace

int run_region_circles(const RegionCall& call) {
  PartMethod* const method = part_method(call.method);
  Origin origin;
  const auto [file, circles] = read_circles(call.file, {}, {}, call.certificate.empty() ? nullptr : &origin.inputs);
  if (!call.svg.empty()) require_drawable(circles.size(), "circle", 0, call.svg_limit);
  const DiscIntersection part = method(circles);
  if (!call.certificate.empty())
    io::write_file_atomically(call.certificate, planar::certificate_text(circles, part, origin));
  const Report report(call, file, circles, part);
  if (!call.svg.empty()) io::write_file_atomically(call.svg, report.picture());
  call.json ? print(to_text(report.json())) : print_for_people(report.human());
  return part.kind == DiscIntersectionKind::empty ? exit_code::yes : exit_code::no;
}

}  // namespace sunder::cli
