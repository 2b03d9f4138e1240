#include <cli/common.h>
#include <cli/pair_picture.h>

#include <sunder/certificate/direction.h>
#include <sunder/planar/pair/difference_search.h>
#include <sunder/scene/rounded_evidence.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <set>
#include <vector>

namespace sunder::cli {

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

struct View {
  double left, top, scale;
  double x(double world) const { return (world - left) * scale; }
  double y(double world) const { return (top - world) * scale; }
};

std::string escaped(const std::string& text) {
  std::string out;
  for (const char c : text) {
    out += c == '&' ? "&amp;" : c == '<' ? "&lt;" : c == '>' ? "&gt;" : c == '"' ? "&quot;" : std::string(1, c);
  }
  return out;
}

}  // namespace

std::string pair_svg(const PicturedPolygon& a, const PicturedPolygon& b, const std::string& title) {
  constexpr double width = 900, border = 40, legend = 70, most_height = 900;
  const std::array polygons{&a, &b};
  std::array<std::set<std::uint32_t>, 2> seen;
  PairCertificate certificate;
  Cost cost;
  StageTally tally;
  planar::search_difference(Watched(a, seen[0]), 0, Watched(b, seen[1]), 0, certificate, cost, tally);

  // What is to be seen.
  std::array<std::vector<Point2>, 2> points;
  Point2 low{std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()}, high{-low.x, -low.y};
  for (std::size_t k = 0; k < 2; ++k) {
    const PosedPolygon placed(polygons[k]->polygon, polygons[k]->pose);
    for (std::uint32_t v = 0; v < placed.size(); ++v) {
      const Point2 p = placed.rounded(v);
      points[k].push_back(p);
      low = {std::min(low.x, p.x), std::min(low.y, p.y)};
      high = {std::max(high.x, p.x), std::max(high.y, p.y)};
    }
  }
  const double w = high.x - low.x, h = high.y - low.y,
               size = std::max(std::max(w, h), std::numeric_limits<double>::min());
  const double scale = std::min((width - 2 * border) / std::max(w, size * 1e-3),
                                (most_height - 2 * border - legend) / std::max(h, size * 1e-3));
  const double height = std::min(most_height, h * scale + 2 * border + legend);
  const View view{low.x - ((width / scale) - w) / 2, high.y + border / scale, scale};

  std::string svg = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0:.0f}\" height=\"{1:.0f}\" viewBox=\"0 0 {0:.0f} {1:.0f}\" "
      "font-family=\"sans-serif\" font-size=\"14\">\n<title>{2}</title>\n"
      "<rect width=\"100%\" height=\"100%\" fill=\"white\"/>\n",
      width, height, escaped(title.empty() ? a.name + " and " + b.name : title));
  constexpr std::array colours{"#0072b2", "#d55e00"};  // of Okabe and Ito
  for (std::size_t k = 0; k < 2; ++k) {
    std::string path;
    Point2 last{};
    for (const Point2& p : points[k]) {  // bends nearer than a tenth of a pixel are left out
      const Point2 at{view.x(p.x), view.y(p.y)};
      if (!path.empty() && points[k].size() > 50 && std::hypot(at.x - last.x, at.y - last.y) < 0.1) continue;
      path += fmt::format("{}{:.2f},{:.2f}", path.empty() ? "" : " ", at.x, at.y);
      last = at;
    }
    svg += fmt::format(
        "<polygon points=\"{}\" fill=\"{}\" fill-opacity=\"0.18\" stroke=\"{}\" stroke-width=\"1.5\" "
        "stroke-linejoin=\"round\"/>\n",
        path, colours[k], colours[k]);
    if (points[k].size() == 1) {
      svg += fmt::format("<circle cx=\"{:.2f}\" cy=\"{:.2f}\" r=\"3\" fill=\"{}\"/>\n", view.x(points[k][0].x),
                         view.y(points[k][0].y), colours[k]);
    }
    for (const std::uint32_t v : seen[k]) {
      svg += fmt::format("<circle cx=\"{:.2f}\" cy=\"{:.2f}\" r=\"2.6\" fill=\"white\" stroke=\"{}\"/>\n",
                         view.x(points[k][v].x), view.y(points[k][v].y), colours[k]);
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
    svg += fmt::format("<path d=\"M{0:.2f},{1:.2f}m-7,-7l14,14m0,-14l-14,14\" stroke=\"black\" stroke-width=\"2\"/>\n",
                       view.x(p.x), view.y(p.y));
    said = fmt::format("they meet: a common point at about ({}, {})", about(p.x), about(p.y));
  } else {
    const scene::RoundedGap gap = scene::rounded_gap(certificate, in_a, in_b);
    const auto image = [](const PlacedVertices& body, std::uint32_t v) {
      const auto& [m, t] = body.pose;
      const Point3& p = body.vertices[v];
      return Point2{m[0] * p.x + m[1] * p.y + t[0], m[3] * p.x + m[4] * p.y + t[1]};
    };
    const double reach = 2 * size;
    for (const Point2& p : {image(in_a, certificate.extreme_a), image(in_b, certificate.extreme_b)}) {
      svg += fmt::format(
          "<line x1=\"{:.2f}\" y1=\"{:.2f}\" x2=\"{:.2f}\" y2=\"{:.2f}\" stroke=\"black\" "
          "stroke-dasharray=\"6 4\"/>\n",
          view.x(p.x - reach * gap.direction.y), view.y(p.y + reach * gap.direction.x),
          view.x(p.x + reach * gap.direction.y), view.y(p.y - reach * gap.direction.x));
    }
    said = fmt::format("apart: two parallel lines, about {} from each other", about(gap.width));
  }
  svg += fmt::format("<rect y=\"{0:.0f}\" width=\"100%\" height=\"{1:.0f}\" fill=\"white\" fill-opacity=\"0.9\"/>\n",
                     height - legend, legend);
  for (std::size_t k = 0; k < 2; ++k) {
    svg += fmt::format("<text x=\"{:.0f}\" y=\"{:.0f}\" fill=\"{}\">{}: {}, {} of {} looked at (circles)</text>\n",
                       border, height - legend + 22 + 18 * static_cast<double>(k), colours[k], k == 0 ? "A" : "B",
                       escaped(polygons[k]->name), seen[k].size(),
                       points[k].size() == 1 ? "1 vertex" : fmt::format("{} vertices", points[k].size()));
  }
  svg += fmt::format("<text x=\"{:.0f}\" y=\"{:.0f}\">{}</text>\n", border, height - legend + 58, escaped(said));
  return svg + "</svg>\n";
}

}  // namespace sunder::cli
