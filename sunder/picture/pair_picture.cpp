#include <sunder/ask/report.h>
#include <sunder/picture/pair_picture.h>
#include <sunder/picture/planar_canvas.h>

#include <sunder/certificate/direction.h>
#include <sunder/planar/pair/minkowski_difference_search.h>
#include <sunder/scene/rounded_evidence.h>

#include <fmt/format.h>

#include <array>
#include <cstdint>
#include <set>
#include <vector>

namespace sunder::picture {

using ask::about;

namespace {

using planar::PosedPolygon;

// A sequence that remembers which of its vertices were looked at.
class Watched : public PosedPolygon {
 public:
  Watched(const PicturedPolygon& p, std::set<std::uint32_t>& seen) : PosedPolygon(p.polygon, p.pose), seen_(seen) {}
  Posed2 operator[](std::uint32_t k) const {
    seen_.insert(k);
    return PosedPolygon::operator[](k);
  }

 private:
  std::set<std::uint32_t>& seen_;
};

}  // namespace

std::string pair_svg(const PicturedPolygon& a, const PicturedPolygon& b, const std::string& title) {
  const std::array polygons{&a, &b};
  std::array<std::set<std::uint32_t>, 2> seen;
  PairCertificate certificate;
  Cost cost;
  StageTally tally;
  planar::search_difference(Watched(a, seen[0]), 0, Watched(b, seen[1]), 0, certificate, cost, tally);

  std::array<std::vector<Point2>, 2> points;
  std::vector<Point2> shown;
  for (std::size_t k = 0; k < 2; ++k) {
    const PosedPolygon placed(polygons[k]->polygon, polygons[k]->pose);
    for (std::uint32_t v = 0; v < placed.size(); ++v) points[k].push_back(placed.rounded(v));
    shown.insert(shown.end(), points[k].begin(), points[k].end());
  }
  PlanarCanvas canvas(shown, 3);
  for (std::size_t k = 0; k < 2; ++k) {
    canvas.polygon(points[k], pair_colours[k]);
    for (const std::uint32_t v : seen[k]) {
      const Point2 at = canvas.pixel(points[k][v]);
      canvas.add(fmt::format("<circle cx=\"{:.2f}\" cy=\"{:.2f}\" r=\"2.6\" fill=\"white\" stroke=\"{}\"/>\n", at.x,
                             at.y, pair_colours[k]));
    }
  }

  const auto in_space = [](const PicturedPolygon& p) {
    std::vector<Point3> out;
    for (const Point2& v : p.polygon.vertices()) out.push_back({v.x, v.y, 0});
    return out;
  };
  const std::vector<Point3> table_a = in_space(a), table_b = in_space(b);
  const Affine3 pose_a = planar::in_space(a.pose.affine()), pose_b = planar::in_space(b.pose.affine());
  const PlacedVertices in_a{table_a, pose_a, false}, in_b{table_b, pose_b, false};
  std::string said;
  if (certificate.verdict == Verdict::meet) {
    const Point3 p = scene::rounded_common_point(certificate, in_a, in_b);
    canvas.cross({p.x, p.y});
    said = fmt::format("they meet: a common point at about ({}, {})", about(p.x), about(p.y));
  } else {
    const scene::RoundedGap gap = scene::rounded_gap(certificate, in_a, in_b);
    const auto image = [](const PlacedVertices& body, std::uint32_t v) {
      const auto& [m, t] = body.pose;
      const Point3& p = body.vertices[v];
      return Point2{m[0] * p.x + m[1] * p.y + t[0], m[3] * p.x + m[4] * p.y + t[1]};
    };
    constexpr double reach = 2000;  // pixels: beyond the sheet
    const Point2 along{reach * gap.direction.y, reach * gap.direction.x};
    for (const Point2& p : {image(in_a, certificate.extreme_a), image(in_b, certificate.extreme_b)}) {
      const Point2 at = canvas.pixel(p);
      canvas.add(
          fmt::format("<line x1=\"{:.2f}\" y1=\"{:.2f}\" x2=\"{:.2f}\" y2=\"{:.2f}\" stroke=\"black\" "
                      "stroke-dasharray=\"6 4\"/>\n",
                      at.x - along.x, at.y - along.y, at.x + along.x, at.y + along.y));
    }
    said = fmt::format("apart: two parallel lines, about {} from each other", about(gap.width));
  }
  std::vector<PlanarCanvas::Row> legend;
  for (std::size_t k = 0; k < 2; ++k) {
    legend.push_back(
        {fmt::format("{}: {}, {} of {} looked at (circles)", k == 0 ? "A" : "B", polygons[k]->name, seen[k].size(),
                     points[k].size() == 1 ? "1 vertex" : fmt::format("{} vertices", points[k].size())),
         pair_colours[k]});
  }
  legend.push_back({said});
  return canvas.finish(title.empty() ? a.name + " and " + b.name : title, legend);
}

}  // namespace sunder::picture
