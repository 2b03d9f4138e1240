#include <sunder/picture/polar.h>
#include <sunder/picture/rings.h>
#include <sunder/picture/view.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <numeric>
#include <vector>

namespace sunder::picture {

namespace {

constexpr double sheet = 480, sheet_margin = 44;  // of one of the two, in pixels
constexpr std::size_t most_numbered = 9;
constexpr std::array<RingKind, 1> numbered{{{Ink::bold, "facet and vertex"}}};

struct Drawn {
  std::vector<Seen> points;  // the last one is the origin
  // Counter-clockwise, seen from outside.
  std::vector<std::vector<std::uint32_t>> facets;
  std::vector<double> seen_area;  // of each facet as it is seen; 0: turned away
  std::vector<bool> is_seen;      // of each point: is it on a facet that is seen?
};

Drawn drawn(std::span<const Point3> vertices, const Point3& origin, std::vector<std::vector<std::uint32_t>> facets,
            double left) {
  Drawn out{{}, std::move(facets), {}, std::vector<bool>(vertices.size())};
  View view;
  Box2 box{{0, 0}, {0, 0}};
  const auto from_origin = [&](const Point3& p) { return Point3{p.x - origin.x, p.y - origin.y, p.z - origin.z}; };
  for (const Point3& p : vertices) {
    const Seen s = view(from_origin(p));
    box = hull(box, {{s.x, s.y}, {s.x, s.y}});
  }
  const double room = sheet - 2 * sheet_margin;
  const double scale = std::min(room / (box.high.x - box.low.x), room / (box.high.y - box.low.y));
  view.scale = std::isfinite(scale) ? scale : 1;
  view.x = left + sheet / 2 - view.scale * (box.low.x + box.high.x) / 2;
  view.y = sheet / 2 - view.scale * (box.low.y + box.high.y) / 2;
  for (const Point3& p : vertices) out.points.push_back(view(from_origin(p)));
  out.points.push_back(view({}));
  for (const std::vector<std::uint32_t>& facet : out.facets) {
    double twice = 0;
    for (std::size_t k = 0; k < facet.size(); ++k) {
      const Seen &p = out.points[facet[k]], &q = out.points[facet[(k + 1) % facet.size()]];
      twice += p.x * q.y - p.y * q.x;
    }
    // Counter-clockwise seen from outside, and y runs down.
    out.seen_area.push_back(std::max(0.0, -twice / 2));
    for (const std::uint32_t v : facet) {
      if (twice < 0) out.is_seen[v] = true;
    }
  }
  return out;
}

void draw(Canvas& canvas, const Drawn& body) {
  canvas.add("<g transform='scale(.1)' stroke-linejoin='round' stroke-width='8'>\n");
  for (std::size_t f = 0; f < body.facets.size(); ++f) {
    if (body.seen_area[f] == 0) continue;
    std::vector<Seen> corners;
    for (const std::uint32_t v : body.facets[f]) corners.push_back(body.points[v]);
    const Seen n = normal_of(corners);
    const double light = light_on({-n.x, -n.y, -n.z});
    canvas.add(fmt::format("<path d='{}' fill='{}' stroke='{}'/>\n", outline_of(corners), shaded(plain_body, light),
                           shaded(plain_body, light - 0.35)));
  }
  canvas.add("</g>\n");
  const Seen& o = body.points.back();
  canvas.add(fmt::format("<circle class='{}f' cx='{:.1f}' cy='{:.1f}' r='4'/>\n", class_of(Ink::dark), o.x, o.y));
}

}  // namespace

std::string polar_svg(const PolarPicture& picture) {
  const solid::ConvexPolyhedron& body = picture.body;
  const solid::PolarAbout& polar = picture.polar;
  std::vector<std::vector<std::uint32_t>> of_body, of_polar;
  for (std::uint32_t f = 0; f < body.facet_count(); ++f)
    of_body.emplace_back(body.facet(f).begin(), body.facet(f).end());
  for (std::size_t v = 0; v + 1 < polar.facet_begin.size(); ++v) {
    const auto begin = polar.facet_vertices.begin();
    of_polar.emplace_back(begin + polar.facet_begin[v], begin + polar.facet_begin[v + 1]);
  }
  const Drawn left = drawn(body.vertices(), polar.origin, std::move(of_body), 0);
  const Drawn right = drawn(picture.polar_vertices, {}, std::move(of_polar), sheet);

  std::vector<std::uint32_t> largest(left.facets.size());
  std::iota(largest.begin(), largest.end(), 0u);
  std::erase_if(largest, [&](std::uint32_t f) { return left.seen_area[f] == 0 || !right.is_seen[f]; });
  std::sort(largest.begin(), largest.end(), [&](std::uint32_t f, std::uint32_t g) {
    return std::pair(-left.seen_area[f], f) < std::pair(-left.seen_area[g], g);
  });
  largest.resize(std::min(largest.size(), most_numbered));

  Canvas canvas(2 * sheet);
  canvas.legend(Ink::bold, "a facet of the body, and the vertex of the polar that it becomes");
  canvas.legend(Ink::dark, fmt::format("the point ({}, {}, {})", polar.origin.x, polar.origin.y, polar.origin.z));
  draw(canvas, left);
  draw(canvas, right);
  std::vector<RingContact> at_facets, at_vertices;
  for (std::uint32_t k = 0; k < largest.size(); ++k) {
    Point2 middle{0, 0};
    const std::vector<std::uint32_t>& facet = left.facets[largest[k]];
    for (const std::uint32_t v : facet) {
      middle.x += left.points[v].x / static_cast<double>(facet.size());
      middle.y += left.points[v].y / static_cast<double>(facet.size());
    }
    at_facets.push_back({middle, k, 0});
    at_vertices.push_back({{right.points[largest[k]].x, right.points[largest[k]].y}, k, 0});
  }
  draw_rings(canvas, at_facets, numbered, sheet,
             [&](std::uint32_t k) { return fmt::format("facet {} of the body", largest[k]); });
  draw_rings(canvas, at_vertices, numbered, 2 * sheet,
             [&](std::uint32_t k) { return fmt::format("vertex {} of the polar", largest[k]); });
  const auto row = [&](double x, const std::string& text) {
    canvas.add(words(x + sheet_margin, sheet + 12, 14, text_colour, text));
  };
  row(0, fmt::format("{}: {} vertices, {} facets", shortened(picture.name, 34), body.vertices().size(),
                     body.facet_count()));
  row(sheet, fmt::format("its polar: {} vertices, {} facets", right.points.size() - 1, right.facets.size()));
  canvas.note("each as large as its half of the sheet");
  return canvas.finish(picture.title.empty() ? "What is the polar of this body?" : picture.title, picture.said,
                       sheet + 24);
}

}  // namespace sunder::picture
