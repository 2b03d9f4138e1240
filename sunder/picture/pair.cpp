#include <sunder/picture/pair.h>
#include <sunder/picture/plane.h>

#include <sunder/certificate/direction.h>
#include <sunder/certificate/rounded_evidence.h>
#include <sunder/io/text/text.h>
#include <sunder/planar/pair/contact_evidence.h>
#include <sunder/planar/pair/placed.h>
#include <sunder/planar/pair/polygon_polygon_by.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <set>
#include <tuple>
#include <utility>

namespace sunder::picture {

namespace {

using Kind = io::PlanarObject::Kind;
using planar::PosedPolygon;

constexpr std::array inks{Ink::bold, Ink::accent};  // of A and of B

// A sequence that remembers which of its vertices were looked at.
class Watched : public PosedPolygon {
 public:
  Watched(const PicturedPolygon& p, std::set<std::uint32_t>& seen) : PosedPolygon(p.polygon, p.pose), seen_(seen) {}
  Posed2 operator[](std::uint32_t k) const {
    seen_.insert(k);
    return PosedPolygon::operator[](k);
  }
  Point2 rounded(std::uint32_t k) const {
    seen_.insert(k);
    return PosedPolygon::rounded(k);
  }

 private:
  std::set<std::uint32_t>& seen_;
};

// By the method of that name; none that can be watched: nothing.
std::optional<PairAnswer> answer_by_name(const std::string& method, const Watched& a, const Watched& b) {
  if (method == "automatic") return planar::answer_by_cone(a, b);
  if (method == "difference") return planar::answer_exactly(a, b);
  if (method == "halving") return planar::answer_by_halving(a, b);
  if (method == "gjk") return planar::answer_by_nearest(a, b);
  return std::nullopt;
}

// As searches go by what they see, two of one method that took as many steps and found the same are one search.
bool are_same(const PairAnswer& p, const PairAnswer& q) {
  if (p.meet() != q.meet() || p.cost.probes != q.cost.probes || p.cost.iterations != q.cost.iterations) return false;
  if (const auto* common = std::get_if<CommonVertices>(&p.evidence)) {
    return common->vertices == std::get<CommonVertices>(q.evidence).vertices;
  }
  const auto named = [](const PairAnswer& answer) {
    const auto& [direction, extreme_a, extreme_b] = std::get<Separation>(answer.evidence);
    return std::tuple(direction.kind, direction.index, extreme_a, extreme_b);
  };
  return named(p) == named(q);
}

// In the world, as PosedPolygon has them.
std::vector<Point2> points_of(const PicturedPolygon& body) {
  const PosedPolygon placed(body.polygon, body.pose);
  std::vector<Point2> points;
  for (std::uint32_t v = 0; v < placed.size(); ++v) {
    points.push_back(placed.rounded(v));
    if (!std::isfinite(points.back().x) || !std::isfinite(points.back().y)) {
      throw Error(ErrorCode::bad_call, "a point to be drawn is beyond the doubles; leave it out", "--svg");
    }
  }
  return points;
}

std::string title_of(const std::string& title, const std::string& a, const std::string& b) {
  return title.empty() ? fmt::format("Do {} and {} meet?", shortened(a, 30), shortened(b, 30)) : title;
}

// What the search found: the common point, or the lines that part the polygons. Returns it in words.
std::string draw_evidence(PlanePicture& drawing, const PairCertificate& certificate,
                          const std::array<const PicturedPolygon*, 2>& bodies,
                          const std::array<std::vector<Point2>, 2>& points) {
  std::array<std::vector<Point3>, 2> tables;
  for (std::size_t k = 0; k < 2; ++k) {
    for (const Point2& v : bodies.at(k)->polygon.vertices()) tables.at(k).push_back({v.x, v.y, 0});
  }
  const Affine3 pose_a = planar::in_space(bodies[0]->pose.affine()),
                pose_b = planar::in_space(bodies[1]->pose.affine());
  const PlacedVertices in_a{tables[0], pose_a, false}, in_b{tables[1], pose_b, false};
  if (const auto* common = std::get_if<CommonVertices>(&certificate)) {
    const Point3 p = rounded_common_point(*common, in_a, in_b);
    drawing.dot({p.x, p.y}, Ink::dark, "a common point");
    return fmt::format("they meet: a common point at about ({:.4g}, {:.4g})", p.x, p.y);
  }
  const Separation& apart = std::get<Separation>(certificate);
  const RoundedGap gap = rounded_gap(apart, in_a, in_b);
  const std::array extremes{apart.extreme_a, apart.extreme_b};
  for (std::size_t k = 0; k < 2; ++k) {
    const std::uint32_t at = PosedPolygon(bodies.at(k)->polygon, bodies.at(k)->pose).number(extremes.at(k));
    drawing.line(points.at(k)[at], {-gap.direction.y, gap.direction.x}, Ink::dark, PlanePicture::Extent::line, true);
  }
  return fmt::format("apart: two parallel lines, about {:.4g} from each other", gap.width);
}

void draw_distance(PlanePicture& drawing, const PicturedPolygon& a, const PicturedPolygon& b,
                   const planar::ClosestFeatures& closest) {
  const auto rounded = [](const PointOf& p) { return Point2{nearest(p.at).x, nearest(p.at).y}; };
  const auto points = planar::closest_points(a.polygon, a.pose, b.polygon, b.pose, closest);
  drawing.segment(rounded(points.of_a), rounded(points.of_b), Ink::dark);
  drawing.legend("<path class='l x' d='M0 0h20'/>", fmt::format("the distance, about {:.12g}", closest.distance.high));
}

}  // namespace

std::string pair_svg(const PairPicture& picture) {
  const auto& [a, b, answer, method, closest, clause, title] = picture;
  const std::array bodies{&a, &b};
  std::array<std::set<std::uint32_t>, 2> seen;
  const std::optional<PairAnswer> again = answer_by_name(method, Watched(a, seen[0]), Watched(b, seen[1]));
  const bool is_watched = again && are_same(*again, answer);

  const std::array points{points_of(a), points_of(b)};
  std::vector<Point2> all = points[0];
  all.insert(all.end(), points[1].begin(), points[1].end());
  PlanePicture drawing(all);
  for (std::size_t k = 0; k < 2; ++k) {
    drawing.polygon(points.at(k), inks.at(k));
    std::string text = fmt::format("{}: {}", k == 0 ? "A" : "B", bodies.at(k)->text);
    if (is_watched) {
      for (const std::uint32_t v : seen.at(k)) drawing.dot(points.at(k)[v], inks.at(k), "", true);
      text += fmt::format(", {} looked at (circles)", seen.at(k).size());
    }
    drawing.legend(inks.at(k), text);
  }
  if (!is_watched) drawing.note(fmt::format("The vertices that the method {} looked at are not shown.", method));
  const std::string said = draw_evidence(drawing, answer.evidence, bodies, points);
  if (closest) draw_distance(drawing, a, b, *closest);
  return drawing.text(title_of(title, a.name, b.name), said + clause);
}

std::string cut_svg(const CutPicture& cut) {
  using Extent = PlanePicture::Extent;
  const std::vector<Point2> points = points_of(cut.body);
  const Point2 way{cut.b.x / 16 - cut.a.x / 16, cut.b.y / 16 - cut.a.y / 16};
  Point2 near = foot(cut.a, way, points[0]);
  const bool is_ray = cut.kind == Kind::ray;
  if (is_ray && (near.x / 16 - cut.a.x / 16) * way.x + (near.y / 16 - cut.a.y / 16) * way.y < 0) near = cut.a;
  std::vector<Point2> shown = points;
  shown.push_back(near);
  PlanePicture drawing(shown);
  const Ink of_body = inks.at(cut.body_is_a ? 0 : 1), of_other = inks.at(cut.body_is_a ? 1 : 0);
  const Point2 p = drawing.at(cut.a), q = drawing.at(near);
  const bool begins = is_ray && std::hypot(p.x - q.x, p.y - q.y) < 2000;  // pixels: the sheet's diagonal is shorter
  if (begins) drawing.dot(cut.a, of_other);
  if (cut.kind == Kind::half_plane) drawing.line(near, way, of_other, Extent::half_plane);
  drawing.line(begins ? cut.a : near, way, of_other, begins ? Extent::ray : Extent::line);
  drawing.polygon(points, of_body);
  if (cut.marks.size() == 2) drawing.segment(cut.marks[0], cut.marks[1], Ink::dark);
  for (const Point2& mark : cut.marks) drawing.dot(mark, Ink::dark);
  const std::string& body = cut.body.text;
  const std::string other = fmt::format("{}, {}", cut.name, io::name_of(cut.kind));
  drawing.legend(inks[0], "A: " + (cut.body_is_a ? body : other));
  drawing.legend(inks[1], "B: " + (cut.body_is_a ? other : body));
  std::string said = cut.said;
  std::replace(said.begin(), said.end(), '\n', ' ');
  return drawing.text(
      title_of(cut.title, cut.body_is_a ? cut.body.name : cut.name, cut.body_is_a ? cut.name : cut.body.name),
      "In common: " + said + cut.clause);
}

}  // namespace sunder::picture
