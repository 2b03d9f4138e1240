#include <sunder/picture/plane_picture.h>
#include <sunder/picture/region_picture.h>

#include <algorithm>
#include <cmath>

namespace sunder::picture {

namespace {

using planar::Constraints;
using planar::Region;
using planar::RegionKind;

constexpr std::size_t most_lines = 400;  // of half-planes that bound nothing

// How far p is outside of the half-plane, in units of its normal; scaled, so that nothing overflows.
double outside(const Constraint& k, const Point2& p) {
  const double scale = std::max({std::fabs(k.a), std::fabs(k.b), std::fabs(k.c), 1e-300});
  return k.a / scale * p.x + k.b / scale * p.y - k.c / scale;
}

// Two points of its line: the one nearest to `around`, and another one that is about `reach` away.
std::array<Point2, 2> line_of(const Constraint& k, const Point2& around, double reach) {
  const double size = std::max(std::fabs(k.a), std::fabs(k.b)), a = k.a / size, b = k.b / size;
  const double square = a * a + b * b, away = (a * around.x + b * around.y - k.c / size) / square;
  const Point2 foot{around.x - a * away, around.y - b * away};
  return {foot, {foot.x - b * reach, foot.y + a * reach}};
}

Point2 inwards(const Constraint& k) {
  const double size = std::max(std::fabs(k.a), std::fabs(k.b));
  return {-k.a / size, -k.b / size};
}

struct View {
  Point2 low{}, high{};
  void include(const Point2& p) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y)};
  }
  Point2 middle() const { return {low.x / 2 + high.x / 2, low.y / 2 + high.y / 2}; }
  double extent() const { return std::max(high.x - low.x, high.y - low.y); }
};

// All corners, or a point, with room around them; of an empty region the corners of those that contradict.
View view_of(const RegionPicture& picture) {
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
  View view{points[0], points[0]};
  for (const Point2& p : points) view.include(p);
  const double size = std::max(std::fabs(view.low.x), std::fabs(view.low.y));
  const double room = view.extent() > 0 ? view.extent() / 2 : size > 0 ? size / 2 : 1;
  view.include({view.low.x - room, view.low.y - room});
  view.include({view.high.x + room, view.high.y + room});
  return view;
}

}  // namespace

std::vector<Point2> clipped(const Constraints& constraints, const std::vector<std::uint32_t>& sides, const Point2& low,
                            const Point2& high) {
  std::vector<Point2> shape{low, {high.x, low.y}, high, {low.x, high.y}}, cut;
  for (const std::uint32_t k : sides) {
    cut.clear();
    for (std::size_t i = 0; i < shape.size(); ++i) {
      const Point2 &p = shape[i], &q = shape[(i + 1) % shape.size()];
      const double of_p = outside(constraints[k], p), of_q = outside(constraints[k], q);
      if (of_p <= 0) cut.push_back(p);
      if ((of_p < 0 && of_q > 0) || (of_p > 0 && of_q < 0)) {
        const double t = of_p / (of_p - of_q);
        cut.push_back({p.x + t * (q.x - p.x), p.y + t * (q.y - p.y)});
      }
    }
    shape = cut;
  }
  return shape;
}

std::string region_svg(const RegionPicture& picture) {
  const View view = view_of(picture);
  const Region& region = picture.region;
  PlanePicture drawing(std::array{view.low, view.high});
  const auto draw_line = [&](std::uint32_t k, Ink ink) {
    const auto [p, q] = line_of(picture.constraints[k], view.middle(), view.extent());
    drawing.line(p, q, ink);
    drawing.arrow(p, inwards(picture.constraints[k]), 18, ink);  // on which side it is
  };
  std::vector<bool> is_side(picture.constraints.size(), false);
  for (const std::uint32_t k : region.sides) is_side[k] = true;
  std::size_t drawn = 0;
  for (std::uint32_t k = 0; k < picture.constraints.size() && drawn < most_lines; ++k) {
    if (is_side[k]) continue;
    draw_line(k, Ink::calm);
    ++drawn;
  }
  if (!region.empty()) drawing.polygon(clipped(picture.constraints, region.sides, view.low, view.high), Ink::bold);
  for (const std::uint32_t k : region.sides) draw_line(k, region.empty() ? Ink::accent : Ink::bold);
  for (const auto& [i, j] : corners(region)) {
    if (!region.empty()) drawing.dot(nearest(exact_corner(picture.constraints[i], picture.constraints[j])), Ink::bold);
  }
  if (picture.best) {
    drawing.arrow(*picture.best, picture.objective, 70, Ink::accent);
    drawing.dot(*picture.best, Ink::accent, "best");
  }
  if (region.empty()) {
    drawing.legend(Ink::accent, "these contradict each other");
  } else {
    drawing.legend(Ink::bold, "common to all");
  }
  if (drawn > 0) drawing.legend(Ink::calm, "other half-planes");
  return drawing.text(picture.title, picture.summary);
}

}  // namespace sunder::picture
