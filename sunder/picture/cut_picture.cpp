#include <sunder/picture/cut_picture.h>
#include <sunder/picture/planar_canvas.h>

#include <sunder/planar/pair/placed.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace sunder::picture {

using ask::Unbounded;

namespace {

using Kind = io::PlanarObject::Kind;

// Of length one.
Point2 direction(const Unbounded& u) {
  Point2 d{u.b.x - u.a.x, u.b.y - u.a.y};
  if (!std::isfinite(std::hypot(d.x, d.y))) d = {u.b.x / 16 - u.a.x / 16, u.b.y / 16 - u.a.y / 16};
  const double greatest = std::max(std::fabs(d.x), std::fabs(d.y));
  d = {d.x / greatest, d.y / greatest};
  const double length = std::hypot(d.x, d.y);
  return {d.x / length, d.y / length};
}

// The point of the line, or of the ray, next to p.
Point2 foot(const Unbounded& u, const Point2& d, const Point2& p) {
  const double t = (p.x / 16 - u.a.x / 16) * d.x + (p.y / 16 - u.a.y / 16) * d.y;
  const double along = u.kind == Kind::ray ? std::max(t, 0.0) : t;
  return {(u.a.x / 16 + along * d.x) * 16, (u.a.y / 16 + along * d.y) * 16};
}

void draw(const Unbounded& u, const Point2& d, const Point2& near, const char* colour, PlanarCanvas& canvas) {
  constexpr double far = 2000;  // pixels: beyond the sheet, whose diagonal is shorter
  const Point2 at = canvas.pixel(near);
  const auto beside = [&](double along, double left) {
    return Point2{at.x + along * d.x - left * d.y, at.y - along * d.y - left * d.x};
  };
  Point2 from = beside(-far, 0);
  const Point2 to = beside(far, 0);
  if (u.kind == Kind::half_plane) {
    const Point2 p = beside(far, far), q = beside(-far, far);
    canvas.add(
        fmt::format("<polygon points=\"{:.2f},{:.2f} {:.2f},{:.2f} {:.2f},{:.2f} {:.2f},{:.2f}\" fill=\"{}\" "
                    "fill-opacity=\"0.18\"/>\n",
                    from.x, from.y, to.x, to.y, p.x, p.y, q.x, q.y, colour));
  }
  if (u.kind == Kind::ray) {
    const Point2 beginning = canvas.pixel(u.a);
    if (std::hypot(beginning.x - at.x, beginning.y - at.y) < far) {
      from = beginning;
      canvas.add(fmt::format("<circle cx=\"{:.2f}\" cy=\"{:.2f}\" r=\"3\" fill=\"{}\"/>\n", from.x, from.y, colour));
    }
  }
  canvas.add(
      fmt::format("<line x1=\"{:.2f}\" y1=\"{:.2f}\" x2=\"{:.2f}\" y2=\"{:.2f}\" stroke=\"{}\" "
                  "stroke-width=\"1.5\"/>\n",
                  from.x, from.y, to.x, to.y, colour));
}

}  // namespace

std::string cut_svg(const CutPicture& picture) {
  const planar::PosedPolygon placed(picture.body.polygon, picture.body.pose);
  std::vector<Point2> points;
  for (std::uint32_t v = 0; v < placed.size(); ++v) points.push_back(placed.rounded(v));
  Point2 low = points[0], high = points[0];
  for (const Point2& p : points) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y)};
  }
  const Point2 d = direction(picture.unbounded);
  const Point2 near = foot(picture.unbounded, d, {low.x / 2 + high.x / 2, low.y / 2 + high.y / 2});
  std::vector<Point2> shown = points;
  shown.push_back(near);
  const std::size_t break_at = picture.said.find('\n');
  const bool two_rows = break_at != std::string::npos;
  PlanarCanvas canvas(shown, two_rows ? 4 : 3);

  const char *const colour_a = pair_colours[0], *const colour_b = pair_colours[1];
  draw(picture.unbounded, d, near, picture.body_is_a ? colour_b : colour_a, canvas);
  canvas.polygon(points, picture.body_is_a ? colour_a : colour_b);
  if (picture.marks.size() == 2) {
    const Point2 p = canvas.pixel(picture.marks[0]), q = canvas.pixel(picture.marks[1]);
    if (picture.marks[0] == picture.marks[1]) {
      canvas.cross(picture.marks[0]);
    } else {
      canvas.add(
          fmt::format("<line x1=\"{:.2f}\" y1=\"{:.2f}\" x2=\"{:.2f}\" y2=\"{:.2f}\" stroke=\"black\" "
                      "stroke-width=\"3\" stroke-linecap=\"round\"/>\n",
                      p.x, p.y, q.x, q.y));
    }
  }
  const std::string of_body = fmt::format("{}, {}", picture.body.name,
                                          points.size() == 1 ? "1 vertex" : fmt::format("{} vertices", points.size()));
  const std::string of_other = fmt::format("{}, {}", picture.unbounded.name, io::name_of(picture.unbounded.kind));
  std::vector<PlanarCanvas::Row> legend{{"A: " + (picture.body_is_a ? of_body : of_other), colour_a},
                                        {"B: " + (picture.body_is_a ? of_other : of_body), colour_b},
                                        {"in common: " + picture.said.substr(0, break_at)}};
  if (two_rows) legend.push_back({picture.said.substr(break_at + 1)});
  const std::string names = picture.body_is_a ? picture.body.name + " and " + picture.unbounded.name
                                              : picture.unbounded.name + " and " + picture.body.name;
  return canvas.finish(picture.title.empty() ? names : picture.title, legend);
}

}  // namespace sunder::picture
