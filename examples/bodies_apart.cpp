// Two placed bodies: how far apart are they, between which features, and at which points? The comparison is exact; what
// is printed is rounded.
#include <sunder/solid/pair/contact_evidence.h>
#include <sunder/solid/pair/polyhedron_polyhedron_distance.h>

#include <iostream>
#include <vector>

int main() {
  using sunder::solid::ConvexPolyhedron;
  const ConvexPolyhedron block(std::vector<sunder::Point3>{
      {0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {4, 4, 0}, {0, 0, 2}, {4, 0, 2}, {0, 4, 2}, {4, 4, 2}});
  const ConvexPolyhedron drill(std::vector<sunder::Point3>{{0, 0, 0}, {1, 1, 3}, {-1, 1, 3}, {0, -1, 3}});
  const sunder::solid::Pose here, there = sunder::solid::Pose::from_quaternion(1, 0, 0, 0, {1, 2, 2.5});

  const auto answer = polyhedron_polyhedron_distance(block, here, drill, there);
  std::cout << "between " << distance_of(answer).low << " and " << distance_of(answer).high << '\n';
  if (const auto* closest = closest_of(answer)) {
    const auto& features = closest->features();
    std::cout << int{features.count_a} << " vertices of the block, " << int{features.count_b} << " of the drill\n";
    const auto [of_block, of_drill] = closest_points(*closest);
    for (const auto& point : {of_block, of_drill}) {
      const sunder::Point3 p = nearest(point.at);
      std::cout << p.x << ' ' << p.y << ' ' << p.z << '\n';
    }
  }
  const bool is_half = compare_distance(answer, 0.5) == sunder::Sign::zero;
  std::cout << (is_half ? "exactly a half\n" : "not a half\n");
  return is_half ? 0 : 1;
}
