#include <bench/set_cliffs.h>

#include <sunder/planar/polygons/polygon_valid.h>
#include <sunder/planar/polygons/polygons_all.h>
#include <sunder/planar/polygons/polygons_any.h>
#include <sunder/planar/segments/segments_all.h>

#include <cmath>
#include <memory>
#include <span>
#include <vector>

namespace bench {
namespace {

using sunder::Allowed;
using sunder::Point2;
using sunder::SetOptions;
using sunder::planar::Polygon;
using Rings = std::vector<std::vector<Point2>>;

constexpr double kTurn = 6.283185307179586;

Point2 on_circle(double radius, double turns) {
  return {radius * std::cos(kTurn * turns), radius * std::sin(kTurn * turns)};
}

Asked ask_any(const std::shared_ptr<const std::vector<Polygon>>& polygons, Allowed allowed) {
  SetOptions options;
  options.allowed = allowed;
  return [=]() -> std::uint64_t { return polygons_any(*polygons, options).meet() ? 1 : 0; };
}

// Of one input.
Entry entry(const char* library, const char* method, const Asked& ask) {
  // NOLINTNEXTLINE(clang-analyzer-cplusplus.NewDeleteLeaks): a std::function frees what it holds
  return entry_by_input(library, method, 1, [=](std::size_t) { return ask; });
}

using sunder::planar::Segment;
using sunder::planar::Segments;

std::shared_ptr<const Segments> shared(const std::vector<Segment>& given) { return std::make_shared<Segments>(given); }

// So many lines across so many.
std::shared_ptr<const Segments> hatch(std::size_t across, std::size_t along) {
  std::vector<Segment> lines;
  const double width = static_cast<double>(along), height = static_cast<double>(across);
  for (std::size_t k = 0; k < across; ++k) {
    lines.push_back({{-1, static_cast<double>(k)}, {width, static_cast<double>(k)}});
  }
  for (std::size_t k = 0; k < along; ++k) {
    lines.push_back({{static_cast<double>(k), -1}, {static_cast<double>(k), height}});
  }
  return shared(lines);
}

std::vector<double> abscissas(const Segments& segments) {
  std::vector<double> all;
  for (const Segment& s : segments.all()) all.insert(all.end(), {s.a.x, s.b.x});
  return all;
}

}  // namespace

Contest net_contest(std::size_t n) {
  const auto lines = hatch(n / 2, n / 2);
  const std::vector<std::uint32_t> one_net(lines->size(), 0);
  const std::uint64_t crossings = std::uint64_t{n / 2} * (n / 2);
  Contest made;
  made.yardstick = sort_with_indices({abscissas(*lines)});
  made.truths = {crossings};
  made.subjects = {entry("sunder", "one net", [=]() -> std::uint64_t {
    return crossings + segments_count(*lines, {Allowed::nothing, one_net}).count;
  })};
  made.peers = {entry("itself", "no nets", [=]() -> std::uint64_t { return segments_count(*lines).count; })};
  return made;
}

Contest overlaps_contest(std::size_t n) {
  std::vector<Segment> pieces;
  for (std::size_t k = 0; k < n; ++k) {
    const double at = static_cast<double>(k), end = at + static_cast<double>(n);
    pieces.push_back({{at, 2 * at}, {end, 2 * end}});
  }
  const auto overlapping = shared(pieces), crossing = hatch(n / 2, n - 1);
  Contest made;
  made.yardstick = sort_with_indices({abscissas(*overlapping)});
  made.truths = {std::uint64_t{n} * (n - 1) / 2};
  const auto ask = [](const std::shared_ptr<const Segments>& segments) -> Asked {
    return [=]() -> std::uint64_t { return segments_count(*segments).count; };
  };
  made.subjects = {entry("sunder", "overlaps", ask(overlapping))};
  made.peers = {entry("itself", "crossings", ask(crossing))};
  return made;
}

Contest frames_contest(std::size_t n) {
  auto polygons = std::make_shared<std::vector<Polygon>>();
  Contest made;
  std::vector<double> ends;
  const auto square = [](double d) { return std::vector<Point2>{{-d, -d}, {d, -d}, {d, d}, {-d, d}}; };
  for (std::size_t k = 1; k <= n; ++k) {
    const double d = static_cast<double>(k);
    polygons->emplace_back(Rings{square(d), square(d - 0.5)});
    ends.insert(ends.end(), {-d, d});
  }
  made.yardstick = sort_with_indices({ends});
  made.truths = {0};
  made.subjects = {entry("sunder", "touching allowed", ask_any(polygons, Allowed::touch))};
  made.peers = {entry("itself", "nothing allowed", ask_any(polygons, Allowed::nothing))};
  return made;
}

Contest star_contest(std::size_t n) {
  auto polygons = std::make_shared<std::vector<Polygon>>();
  Contest made;
  std::vector<double> abscissas_of_star;
  std::vector<Point2> star;
  const double vertices = static_cast<double>(4 * n), count = static_cast<double>(n);
  for (std::size_t k = 0; k < 4 * n; ++k) {
    star.push_back(on_circle(k % 2 == 0 ? 100 : 40, static_cast<double>(k) / vertices));
    abscissas_of_star.push_back(star.back().x);
  }
  made.yardstick = sort_with_indices({abscissas_of_star});
  polygons->emplace_back(Rings{star});
  constexpr double golden = 0.6180339887498949;  // of a turn: points of a sunflower
  const double size = 5 / std::sqrt(count);      // less than a sixth of their distance from each other
  for (std::size_t k = 0; k < n; ++k) {
    const double at = static_cast<double>(k);
    const Point2 p = on_circle(30 * std::sqrt((at + 0.5) / count), at * golden);
    polygons->emplace_back(Rings{{p, {p.x + size, p.y}, {p.x, p.y + size}}});
  }
  made.truths = {n};
  made.subjects = {entry("sunder", "front door", [=] { return polygons_all(*polygons).found.size(); })};
  return made;
}

Contest petals_contest(std::size_t n) {
  auto rings = std::make_shared<Rings>(1);
  std::vector<Point2>& ring = rings->front();
  const double petals = static_cast<double>(n);
  for (std::size_t k = 0; k < n; ++k) {
    const double at = static_cast<double>(k);
    ring.insert(ring.end(), {{0, 0}, on_circle(1, at / petals), on_circle(1, (at + 0.5) / petals)});
  }
  std::vector<double> ends;
  for (const Point2& p : ring) ends.insert(ends.end(), {p.x, p.x});
  Contest made;
  made.yardstick = sort_with_indices({ends});
  made.truths = {1};
  made.subjects = {entry("sunder", "front door", [=]() -> std::uint64_t {
    return sunder::planar::polygon_defects(std::span(rings.get(), 1), {.most = 1}).found.size();
  })};
  return made;
}

}  // namespace bench
