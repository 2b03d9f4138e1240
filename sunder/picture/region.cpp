#include <sunder/picture/plane.h>
#include <sunder/picture/region.h>

#include <sunder/planar/region/half_plane_intersection.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace sunder::picture {

namespace {

constexpr std::size_t most_lines = 400, most_labels = 12;  // of half-planes that bound nothing; of those that do

// All corners, or a point, with room around them; of an empty region the corners of those that contradict.
Box2 view_of(const RegionPicture& picture) {
  std::vector<Point2> points;
  const std::vector<std::uint32_t>& sides = picture.region.sides;
  const std::size_t n = sides.size();
  for (std::size_t k = 0; k < n; ++k) {
    const Constraint &i = picture.constraints[sides[k]], &j = picture.constraints[sides[(k + 1) % n]];
    if (n > 1 && turn(i, j) != Sign::zero && (turn(i, j) == Sign::positive || picture.region.empty())) {
      points.push_back(nearest(exact_corner(i, j)));
    }
  }
  if (points.empty()) {
    for (const std::uint32_t k : sides) points.push_back(nearest(exact_point_on(picture.constraints[k])));
  }
  if (picture.best) points.push_back(*picture.best);
  if (points.empty()) points.push_back({0, 0});
  Box2 view{points[0], points[0]};
  for (const Point2& p : points) view = hull(view, {p, p});
  const double size = std::max(std::fabs(view.low.x), std::fabs(view.low.y));
  const double extent = std::max(view.high.x - view.low.x, view.high.y - view.low.y);
  const double room = extent > 0 ? extent / 2 : size > 0 ? size / 2 : 1;
  const auto within = [](double x) {
    return std::clamp(x, std::numeric_limits<double>::lowest(), std::numeric_limits<double>::max());
  };
  return {{within(view.low.x - room), within(view.low.y - room)},
          {within(view.high.x + room), within(view.high.y + room)}};
}

// The corners of the common part within a box, counter-clockwise, rounded.
std::vector<Point2> clipped(const RegionPicture& picture, const Box2& box) {
  std::vector<Constraint> rows{{1, 0, box.high.x}, {-1, 0, -box.low.x}, {0, 1, box.high.y}, {0, -1, -box.low.y}};
  for (const std::uint32_t k : picture.region.sides) rows.push_back(picture.constraints[k]);
  const planar::Constraints constraints(std::move(rows));
  std::vector<Point2> shape;
  for (const auto& [i, j] : corners(half_plane_intersection(constraints))) {
    shape.push_back(nearest(exact_corner(constraints[i], constraints[j])));
  }
  return shape;
}

}  // namespace

std::string region_svg(const RegionPicture& picture) {
  const auto& [constraints, region, names, best, objective, title, summary] = picture;
  const Box2 view = view_of(picture);
  const Point2 middle{view.low.x / 2 + view.high.x / 2, view.low.y / 2 + view.high.y / 2};
  PlanePicture drawing(std::array{view.low, view.high});
  const auto draw_line = [&](std::uint32_t k, Ink ink, bool labelled) {
    const Constraint& c = constraints[k];
    const Point2 way{-c.b, c.a}, p = foot(nearest(exact_point_on(c)), way, middle);
    const std::string name = names.empty() ? "" : shortened(names[k], 40);
    drawing.named(name, [&] {
      drawing.line(p, way, ink);
      drawing.arrow(p, {-c.a, -c.b}, 18, ink);  // on which side it is
      if (labelled && !name.empty()) drawing.label(p, name);
    });
  };
  std::vector<bool> is_side(constraints.size(), false);
  for (const std::uint32_t k : region.sides) is_side[k] = true;
  std::size_t drawn = 0;
  for (std::uint32_t k = 0; k < constraints.size() && drawn < most_lines; ++k) {
    if (is_side[k]) continue;
    draw_line(k, Ink::calm, false);
    ++drawn;
  }
  if (!region.empty()) drawing.polygon(clipped(picture, view), Ink::bold);
  for (const std::uint32_t k : region.sides) {
    draw_line(k, region.empty() ? Ink::accent : Ink::bold, region.sides.size() <= most_labels);
  }
  for (const auto& [i, j] : corners(region)) {
    if (!region.empty()) drawing.dot(nearest(exact_corner(constraints[i], constraints[j])), Ink::bold);
  }
  if (best) {
    drawing.arrow(*best, objective, 70, Ink::accent);
    drawing.dot(*best, Ink::accent);
  }
  if (region.empty()) {
    drawing.legend(Ink::accent, "these contradict each other");
  } else {
    drawing.legend(Ink::bold, "common to all");
  }
  if (best) drawing.legend(Ink::accent, "best, and the way that is better");
  if (drawn > 0) drawing.legend(Ink::calm, "other half-planes");
  if (is_side.size() > drawn + region.sides.size()) {
    drawing.note(fmt::format("Of those that bound nothing, the first {} are drawn.", drawn));
  }
  return drawing.text(title, summary);
}

}  // namespace sunder::picture
