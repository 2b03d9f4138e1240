#include <bench/peers/sunder_sets.h>

#include <sunder/near/cover_order.h>
#include <sunder/planar/discs/disc_boxes.h>
#include <sunder/planar/discs/discs_all.h>
#include <sunder/planar/discs/discs_any.h>
#include <sunder/planar/object/convex_polygon.h>
#include <sunder/planar/object/discs.h>
#include <sunder/planar/object/polygon.h>
#include <sunder/planar/polygons/convex_polygons_any.h>
#include <sunder/planar/polygons/polygons_all.h>
#include <sunder/planar/polygons/polygons_any.h>

#include <memory>
#include <utility>
#include <vector>

namespace bench {
namespace {

using sunder::Point2;
using sunder::planar::ConvexPolygon;
using sunder::planar::Discs;
using sunder::planar::Polygon;

std::vector<Point2> points_of(const Ring& ring) {
  std::vector<Point2> points;
  points.reserve(ring.size());
  for (const Xy& p : ring) points.push_back({p.x, p.y});
  return points;
}

std::shared_ptr<const Discs> circles_of(const SetInput& input) {
  std::vector<sunder::Disc> given;
  for (const Disc& d : input.discs) given.push_back({{d.center.x, d.center.y}, d.radius});
  return std::make_shared<const Discs>(given);
}

std::shared_ptr<const std::vector<ConvexPolygon>> convex_polygons_of(const SetInput& input) {
  std::vector<ConvexPolygon> given;
  for (const Ring& ring : input.rings) given.push_back(ConvexPolygon::from_vertices(points_of(ring)));
  return std::make_shared<const std::vector<ConvexPolygon>>(std::move(given));
}

std::shared_ptr<const std::vector<Polygon>> polygons_of(const SetInput& input) {
  std::vector<Polygon> given;
  for (const Ring& ring : input.rings) given.emplace_back(std::vector<std::vector<Point2>>{points_of(ring)});
  return std::make_shared<const std::vector<Polygon>>(std::move(given));
}

Asked ask_discs(const SetInput& input, SetQuestion question) {
  const auto circles = circles_of(input);
  switch (question) {
    case SetQuestion::any: return [circles]() -> std::uint64_t { return discs_any(*circles).meet() ? 1 : 0; };
    case SetQuestion::all: return [circles]() -> std::uint64_t { return discs_all(*circles).found.size(); };
    case SetQuestion::count: return [circles]() -> std::uint64_t { return discs_count(*circles).count; };
    default: return {};
  }
}

Asked ask_convex_polygons(const SetInput& input, SetQuestion question) {
  if (question != SetQuestion::any) return {};
  const auto polygons = convex_polygons_of(input);
  return [polygons]() -> std::uint64_t { return convex_polygons_any(*polygons).meet() ? 1 : 0; };
}

Asked ask_polygons(const SetInput& input, SetQuestion question) {
  const auto polygons = polygons_of(input);
  switch (question) {
    case SetQuestion::any: return [polygons]() -> std::uint64_t { return polygons_any(*polygons).meet() ? 1 : 0; };
    case SetQuestion::all: return [polygons]() -> std::uint64_t { return polygons_all(*polygons).found.size(); };
    default: return {};
  }
}

}  // namespace

Asked ask_sunder(const SetInput& input, SetKind kind, SetQuestion question) {
  switch (kind) {
    case SetKind::discs: return ask_discs(input, question);
    case SetKind::convex_polygons: return ask_convex_polygons(input, question);
    case SetKind::polygons: return ask_polygons(input, question);
  }
  return {};
}

Asked ask_sunder_for_transcript(const SetInput& input, SetKind kind) {
  if (kind == SetKind::discs) {
    return [circles = circles_of(input)]() -> std::uint64_t {
      const bool meet = discs_any(*circles).meet();
      return meet || cover_order(rounded_boxes(*circles)).size() < circles->size() ? 1 : 0;
    };
  }
  return {};
}

}  // namespace bench
