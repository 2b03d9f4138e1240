// Every method for sets refuses groups that are not as many as the members, before it reads one.
#include <sunder/base/error.h>
#include <sunder/planar/boxes/boxes.h>
#include <sunder/planar/discs/discs_all.h>
#include <sunder/planar/discs/discs_any.h>
#include <sunder/planar/polygons/convex_polygons_any.h>
#include <sunder/planar/polygons/polygon_contacts_in_order.h>
#include <sunder/planar/polygons/polygons_all.h>
#include <sunder/planar/polygons/polygons_any.h>
#include <sunder/planar/segments/segments_all.h>
#include <sunder/planar/segments/segments_any.h>

#include <gtest/gtest.h>

#include <vector>

namespace sunder::planar {
namespace {

const std::vector<std::uint32_t> three_groups(3);
const SetOptions wrong{Allowed::nothing, three_groups};
constexpr int object_count = 40;

template <class Ask>
void expect_refused(const Ask& ask) {
  EXPECT_THROW(static_cast<void>(ask()), Error);
}

Point2 corner(int k) { return {3.0 * k, 0}; }

TEST(Groups, OfSegments) {
  std::vector<Segment> all;
  for (int k = 0; k < object_count; ++k) all.push_back({corner(k), {3.0 * k + 1, 1}});
  const Segments segments(all);
  for (const auto method : {segments_any, segments_any_by_grid, segments_any_by_sweep, segments_any_by_bentley_ottmann,
                            segments_any_by_scan}) {
    expect_refused([&] { return method(segments, wrong); });
  }
  for (SegmentsMethod* method : {segments_visit, segments_all_by_grid, segments_all_by_bentley_ottmann,
                                 segments_all_by_balaban, segments_all_by_sweep, segments_all_by_scan}) {
    expect_refused([&] { return method(segments, wrong, [](const SegmentsContact&) { return true; }); });
  }
  expect_refused([&] { return segments_all(segments, wrong); });
  expect_refused([&] { return segments_count(segments, wrong); });
}

TEST(Groups, OfDiscs) {
  std::vector<Disc> all;
  for (int k = 0; k < object_count; ++k) all.push_back({corner(k), 1});
  const Discs discs(all);
  for (const auto method : {discs_any, discs_any_by_grid, discs_any_by_sweep, discs_any_by_scan}) {
    expect_refused([&] { return method(discs, wrong); });
  }
  for (DiscsMethod* method : {discs_visit, discs_all_by_grid, discs_all_by_sweep, discs_all_by_scan}) {
    expect_refused([&] { return method(discs, wrong, [](const DiscsContact&) { return true; }); });
  }
}

TEST(Groups, OfBoxes) {
  std::vector<Box2> all;
  for (int k = 0; k < object_count; ++k) all.push_back({corner(k), {3.0 * k + 1, 1}});
  const Boxes boxes(all);
  expect_refused([&] { return contacts_any(boxes, wrong); });
  expect_refused([&] { return contacts_all(boxes, wrong); });
  expect_refused([&] { return contacts_count(boxes, wrong); });
  expect_refused([&] { return contacts_visit_by_scan<Boxes>(boxes, wrong, [](const auto&) { return true; }); });
  expect_refused([&] { return cover_order(boxes_of(boxes), three_groups); });
}

TEST(Groups, OfConvexPolygons) {
  std::vector<ConvexPolygon> polygons;
  for (int k = 0; k < object_count; ++k)
    polygons.push_back(ConvexPolygon::hull_of(std::vector<Point2>{corner(k), {3.0 * k + 1, 0}, {3.0 * k, 1}}));
  for (const auto method :
       {convex_polygons_any, convex_polygons_any_by_grid, convex_polygons_any_by_sweep, convex_polygons_any_by_scan}) {
    expect_refused([&] { return method(polygons, wrong); });
  }
}

TEST(Groups, OfPolygons) {
  std::vector<Polygon> polygons;
  for (int k = 0; k < object_count; ++k) {
    const std::vector<std::vector<Point2>> rings{{corner(k), {3.0 * k + 1, 0}, {3.0 * k, 1}}};
    polygons.emplace_back(rings);
  }
  for (const auto method :
       {polygons_any, polygons_any_by_boxes, polygons_any_by_grid, polygons_any_by_sweep, polygons_any_by_scan}) {
    expect_refused([&] { return method(polygons, wrong); });
  }
  for (const auto method :
       {polygons_all, polygons_all_by_boxes, polygons_all_by_grid, polygons_all_by_sweep, polygons_all_by_scan}) {
    expect_refused([&] { return method(polygons, wrong); });
  }
  expect_refused([&] { return polygons_count(polygons, wrong); });
  expect_refused([&] {
    PolygonContactsInOrder(polygons, wrong, find_contacts_by_boxes);
    return 0;
  });
}

}  // namespace
}  // namespace sunder::planar
