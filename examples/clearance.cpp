// Two placed convex polygons: how far apart are they, which of their features are closest, and is a clearance kept? The
// comparison is exact; what is printed is rounded.
#include <sunder/planar/pair/polygon_polygon_distance.h>

#include <iostream>
#include <vector>

int main() {
  using sunder::planar::ConvexPolygon;
  const auto plate = ConvexPolygon::from_vertices({{0, 0}, {4, 0}, {4, 2}, {0, 2}});
  const auto tool = ConvexPolygon::hull_of(std::vector<sunder::Point2>{{0, 0}, {1, 2}, {-1, 2}, {0, 1}});
  const sunder::planar::Pose here, there = sunder::planar::Pose::from_matrix({1, 0, 0, 1}, {2, 2.5});

  const auto answer = polygon_polygon_distance(plate, here, tool, there);
  std::cout << "between " << distance_of(answer).low << " and " << distance_of(answer).high << '\n';
  if (const auto* closest = closest_of(answer)) {
    std::cout << (closest->edge_of_a ? "edge " : "vertex ") << closest->a << " of the plate, "
              << (closest->edge_of_b ? "edge " : "vertex ") << closest->b << " of the tool\n";
  }
  const bool is_half = compare_distance(answer, 0.5) == sunder::Sign::zero;
  std::cout << (is_half ? "exactly a half\n" : "not a half\n");
  return is_half ? 0 : 1;
}
