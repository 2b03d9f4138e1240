#include "set_cliffs.h"

#include <sunder/planar/set/polygons_all.h>
#include <sunder/planar/set/polygons_any.h>

#include <cmath>
#include <memory>
#include <vector>

namespace bench {
namespace {

using sunder::Point2;
using sunder::planar::Allowed;
using sunder::planar::Polygon;
using sunder::planar::PolygonsOptions;
using Rings = std::vector<std::vector<Point2>>;

constexpr double kTurn = 6.283185307179586;

Point2 on_circle(double radius, double turns) {
  return {radius * std::cos(kTurn * turns), radius * std::sin(kTurn * turns)};
}

Asked ask_any(const std::shared_ptr<const std::vector<Polygon>>& polygons, Allowed allowed) {
  PolygonsOptions options;
  options.allowed = allowed;
  return [=]() -> std::uint64_t { return polygons_any(*polygons, options).meet() ? 1 : 0; };
}

}  // namespace

Contest frames_contest(std::size_t n) {
  auto polygons = std::make_shared<std::vector<Polygon>>();
  Contest made;
  made.keys.emplace_back();
  const auto square = [](double d) { return std::vector<Point2>{{-d, -d}, {d, -d}, {d, d}, {-d, d}}; };
  for (std::size_t k = 1; k <= n; ++k) {
    const double d = static_cast<double>(k);
    polygons->emplace_back(Rings{square(d), square(d - 0.5)});
    made.keys[0].insert(made.keys[0].end(), {-d, d});
  }
  made.truths = {0};
  made.subject = {"sunder", "touching allowed", [=](std::size_t) { return ask_any(polygons, Allowed::touch); }};
  made.peers = {{"itself", "nothing allowed", [=](std::size_t) { return ask_any(polygons, Allowed::nothing); }}};
  return made;
}

Contest star_contest(std::size_t n) {
  auto polygons = std::make_shared<std::vector<Polygon>>();
  Contest made;
  made.keys.emplace_back();
  std::vector<Point2> star;
  const double vertices = static_cast<double>(4 * n), count = static_cast<double>(n);
  for (std::size_t k = 0; k < 4 * n; ++k) {
    star.push_back(on_circle(k % 2 == 0 ? 100 : 40, static_cast<double>(k) / vertices));
    made.keys[0].push_back(star.back().x);
  }
  polygons->emplace_back(Rings{star});
  constexpr double golden = 0.6180339887498949;  // of a turn: points of a sunflower
  const double size = 5 / std::sqrt(count);      // less than a sixth of their distance from each other
  for (std::size_t k = 0; k < n; ++k) {
    const double at = static_cast<double>(k);
    const Point2 p = on_circle(30 * std::sqrt((at + 0.5) / count), at * golden);
    polygons->emplace_back(Rings{{p, {p.x + size, p.y}, {p.x, p.y + size}}});
  }
  made.truths = {n};
  made.subject = {"sunder", "front door",
                  [=](std::size_t) -> Asked { return [=] { return polygons_all(*polygons).contacts.size(); }; }};
  return made;
}

}  // namespace bench
