// sunder region --of circles: with their insides.
#include <sunder/ask/region/region_question.h>

#include <sunder/io/text/triples.h>
#include <sunder/picture/plane.h>
#include <sunder/planar/region/disc_intersection.h>
#include <sunder/planar/region/disc_intersection_claims.h>
#include <sunder/predicate/disc/disc_powers.h>
#include <sunder/predicate/line/constraints.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>

namespace sunder::ask {

namespace {

using picture::Ink;
using picture::PlanePicture;

using planar::DiscIntersection;
using planar::DiscIntersectionKind;
using planar::Discs;

using CirclesMethod = DiscIntersection(const Discs&);
constexpr std::array<Named<CirclesMethod>, 3> circles_methods{
    {SUNDER_METHOD("automatic", planar::disc_intersection),
     SUNDER_METHOD("division", planar::disc_intersection_by_division),
     SUNDER_METHOD("scan", planar::disc_intersection_by_scan)}};

// The middle of what holds it.
Point2 rounded(const DiscCrossing& crossing) {
  const Enclosure2 in = enclosure(crossing);
  return {in.x.low / 2 + in.x.high / 2, in.y.low / 2 + in.y.high / 2};
}

class CirclesQuestion final : public RegionQuestion {
 public:
  static constexpr const char* drawn_noun = "circle";

  CirclesQuestion(const RegionCall& asked, Talk& told)
      : RegionQuestion(asked, told),
        method_(method_by(asked.method, circles_methods)),
        read_(read(asked, told, origin_)) {
    system_ = {io::system_beside(asked.file, asked.proves() ? &origin_.inputs : nullptr), {}};
    systems_.add(asked.file, std::span(&system_, 1));
  }

  std::uint64_t drawn() const { return circles_.size(); }
  void ask() {
    function_ = method_.function;
    part_ = method_(circles_);
    deepest_ = nearest(deepest_point(planar::discs_of(circles_.all(), part_.deepest.basis())));
    is_empty_ = part_.kind == DiscIntersectionKind::empty;
    cost_ = part_.cost;
    counted_ = "comparison";
    things_ = count_of(circles_.size(), "circle");
    object_json_ = {{"format", "CSV"}, {"circles", circles_.size()}};
    region_json_ = {{"kind", name_of(part_.kind)}, {"arcs", part_.arcs}};
    if (!is_region()) {
      verdict_ = is_empty_ ? "empty: these have nothing in common"
                           : fmt::format("one point, about {}, common to", place_text(deepest_));
      named_.assign(part_.deepest.basis().begin(), part_.deepest.basis().end());
      return;
    }
    verdict_ = fmt::format("a region bounded by {}; a point inside is about {}", count_of(part_.arcs.size(), "arc"),
                           place_text(deepest_));
    for (std::size_t m = 0; part_.arcs.size() > 1 && m < part_.arcs.size(); ++m) {
      corners_.push_back(rounded(planar::corner(circles_, part_, m)));
    }
    corner_count_ = corners_.size();
    not_proved_.emplace_back("that the point inside is the deepest");
  }
  std::string certificate() const { return planar::certificate_text(circles_, part_, origin()); }

  Report report() const {
    Report report = RegionQuestion::report();
    const bool is_one_circle = is_region() && corners_.empty();
    if (is_one_circle) report.tell(fmt::format("  all of {}\n", thing_text(part_.arcs[0])));
    report.add(facts_of(systems_));
    report.add("deepest", {{"point", {deepest_.x, deepest_.y}}, {"circles", part_.deepest.basis()}});
    return report;
  }

  std::string picture() const {
    PlanePicture drawing(seen());
    draw_things(circles_.size(), [&](std::uint32_t k, Ink ink) { drawing.circle(circles_[k], ink); });
    if (is_region()) {
      drawing.polygon(outline(), Ink::bold);
      for (const Point2& p : corners_) drawing.dot(p, Ink::bold);
      drawing.legend(Ink::bold, "common to all");
    } else if (part_.kind == DiscIntersectionKind::point) {
      drawing.dot(deepest_, Ink::accent, "the only point");
    } else {
      drawing.legend(Ink::accent, "have nothing in common");
    }
    return drawing.text(call.title_or("What is common to these circles?"),
                        fmt::format("{}: {}", things_,
                                    is_empty_      ? "nothing is common to all"
                                    : !is_region() ? "one point"
                                                   : count_of(part_.arcs.size(), "arc")));
  }

 private:
  Origin origin() const {
    Origin origin = by_this_call(talk, origin_);
    const Said said = said_of_file(Said::Source::circles, origin.inputs, call.file);
    origin.said = said_of_rows("circles", circles_.size(), said_in(std::span(&system_, 1), said));
    return origin;
  }

  static io::CirclesFile read(const RegionCall& call, const Talk& talk, Origin& origin) {
    return io::read_circles(call.file,
                            {.progress = talk.progress("reading"), .inputs = call.proves() ? &origin.inputs : nullptr});
  }
  bool is_region() const { return part_.kind == DiscIntersectionKind::region; }
  const std::string& name(std::uint32_t k) const { return read_.file.name[k]; }
  std::string thing_text(std::uint32_t k) const override {
    const Disc& c = circles_[k];
    return fmt::format("circle {}, line {}: centre {}, radius {:.10g}", name(k), read_.file.line[k],
                       place_text(c.center), c.radius);
  }

  Point2 corner(std::size_t k) const override { return corners_[k]; }
  std::string corner_text(std::size_t k) const override {
    return fmt::format("  arc of {} up to about {}\n", name(part_.arcs[k]), place_text(corners_[k]));
  }

  // Points along the boundary, close to each other; for a picture.
  std::vector<Point2> outline() const {
    constexpr double step = std::numbers::pi / 180;
    const std::vector<Point2>& ends = corners_;
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
    if (is_region()) {
      points = outline();
      double room = 0;
      for (const Point2& p : points) room = std::max({room, std::fabs(p.x - deepest_.x), std::fabs(p.y - deepest_.y)});
      points.push_back({deepest_.x - 2 * room, deepest_.y - 2 * room});
      points.push_back({deepest_.x + 2 * room, deepest_.y + 2 * room});
      return points;
    }
    for (const std::uint32_t k : named_) {
      const Disc& c = circles_[k];
      points.push_back({c.center.x - c.radius, c.center.y - c.radius});
      points.push_back({c.center.x + c.radius, c.center.y + c.radius});
    }
    return points;
  }

  Named<CirclesMethod> method_;
  Origin origin_;
  io::SystemOfFile system_;
  io::CoordinateSystems systems_;
  io::CirclesFile read_;
  const Discs& circles_ = read_.circles;
  DiscIntersection part_;
  Point2 deepest_;
  std::vector<Point2> corners_;  // rounded: where each arc ends
};

}  // namespace

Report run_region_circles(const RegionCall& call, Talk& talk) { return answer(CirclesQuestion(call, talk), talk); }

std::string circle_method_names() { return method_names(circles_methods); }

}  // namespace sunder::ask
