#include <sunder/ask/progress.h>
#include <sunder/ask/region/region_circles.h>
#include <sunder/ask/report.h>

#include <sunder/base/error.h>
#include <sunder/io/file.h>
#include <sunder/io/text.h>
#include <sunder/io/triples.h>
#include <sunder/picture/plane.h>
#include <sunder/planar/region/disc_intersection.h>
#include <sunder/planar/region/disc_intersection_json.h>
#include <sunder/predicate/constraints.h>
#include <sunder/predicate/disc_powers.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace sunder::ask {

namespace {

using picture::Ink;
using picture::PlanePicture;

using planar::DiscIntersection;
using planar::DiscIntersectionKind;
using planar::Discs;

using PartMethod = DiscIntersection(const Discs&);
constexpr std::array<Named<PartMethod>, 3> methods{{{"automatic", planar::disc_intersection},
                                                    {"division", planar::disc_intersection_by_division},
                                                    {"scan", planar::disc_intersection_by_scan}}};

// The middle of what holds it.
Point2 rounded(const DiscCrossing& crossing) {
  const Enclosure2 in = enclosure(crossing);
  return {in.x.low / 2 + in.x.high / 2, in.y.low / 2 + in.y.high / 2};
}

class CirclesQuestion {
 public:
  static constexpr const char *verb = "region", *drawn_noun = "circle";
  const RegionCall& call;

  explicit CirclesQuestion(const RegionCall& asked)
      : call(asked), method_(method_by(asked.method, methods)), read_(read(asked, origin_)) {}

  std::uint64_t drawn() const { return circles_.size(); }
  void ask() {
    part_ = method_(circles_);
    deepest_ = nearest(deepest_point(planar::discs_of(circles_.all(), part_.deepest.basis())));
  }
  std::string certificate() const { return planar::certificate_text(circles_, part_, origin_); }

  bool yes() const { return part_.kind == DiscIntersectionKind::empty; }
  const char* answer() const { return yes() ? "infeasible" : "feasible"; }
  const Cost& cost() const { return part_.cost; }
  std::string cost_text() const { return count_of(part_.cost.probes, "comparison"); }
  const char* proof_clause() const { return " (of what kind it is, not of the arcs)"; }

  std::string text() const {
    std::string text = fmt::format("{}: {}\n", io::one_line(call.file), count_of(circles_.size(), "circle"));
    if (part_.kind == DiscIntersectionKind::region) {
      return text +
             fmt::format("a region bounded by {}; a point inside is about {}\n", count_of(part_.arcs.size(), "arc"),
                         place_text(deepest_)) +
             arcs_text();
    }
    text += yes() ? "empty: these have nothing in common\n"
                  : fmt::format("one point, about {}, common to\n", place_text(deepest_));
    for (const std::uint32_t k : part_.deepest.basis()) text += fmt::format("    circle {}\n", circle(k));
    return text;
  }

  void add_to(Json& json) const {
    json["objects"] =
        Json::array({{{"file", io::one_line(call.file)}, {"format", "CSV"}, {"circles", circles_.size()}}});
    json["region"] = {{"kind", name_of(part_.kind)}, {"arcs", part_.arcs}};
    json["region"]["corners"] = Json::array();
    for (const Point2& p : corners()) json["region"]["corners"].push_back({{"point", {p.x, p.y}}});
    json["deepest"] = {{"point", {deepest_.x, deepest_.y}}, {"circles", Json::array()}};
    for (const std::uint32_t k : part_.deepest.basis()) json["deepest"]["circles"].push_back(k);
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
    return drawing.text(call.title_or("What is common to these circles?"),
                        fmt::format("{}: {}", count_of(circles_.size(), "circle"),
                                    part_.kind == DiscIntersectionKind::empty   ? "nothing is common to all"
                                    : part_.kind == DiscIntersectionKind::point ? "one point"
                                                                                : count_of(part_.arcs.size(), "arc")));
  }

 private:
  static io::CirclesFile read(const RegionCall& call, Origin& origin) {
    Progress progress("reading");
    return io::read_circles(call.file, {}, progress.reporter(), {}, call.proves() ? &origin.inputs : nullptr);
  }
  const io::TripleFile& file() const { return read_.file; }

  std::string circle(std::uint32_t k) const {
    const Disc& c = circles_[k];
    return fmt::format("{}, line {}: centre {}, radius {:.10g}", file().name[k], file().line[k], place_text(c.center),
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
    const std::vector<Point2> ends = corners();
    return first_of(ends.size(), 20, [&](std::size_t m) {
      return fmt::format("  arc of {} up to about {}\n", file().name[part_.arcs[m]], place_text(ends[m]));
    });
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

  PartMethod* method_;
  Origin origin_;
  io::CirclesFile read_;
  const Discs& circles_ = read_.circles;
  DiscIntersection part_;
  Point2 deepest_;
};

}  // namespace

int run_region_circles(const RegionCall& call) {
  CirclesQuestion question(call);
  return answer(question);
}

}  // namespace sunder::ask
