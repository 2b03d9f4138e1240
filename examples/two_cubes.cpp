// Two cubes, one of them turned and moved: do they meet? Prints the answer, and a proof that `sunder verify` accepts.
#include <sunder/solid/pair/contact_evidence.h>
#include <sunder/solid/pair/polyhedron_polyhedron.h>

#include <iostream>
#include <string_view>
#include <vector>

int main() {
  const std::vector<sunder::Point3> corners{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0},
                                            {0, 0, 1}, {1, 0, 1}, {0, 1, 1}, {1, 1, 1}};
  const sunder::solid::ConvexPolyhedron cube(corners);
  const auto here = sunder::solid::Pose(), there = sunder::solid::Pose::from_quaternion(2, 0, 0, 1, {1.7, 0.1, 0.5});

  const auto answer = sunder::intersect(cube, here, cube, there);
  std::cout << (answer.meet() ? "they meet\n" : "they are apart\n");

  sunder::prove([](std::string_view text) { std::cout << text; }, sunder::AskedPair{cube, here, cube, there}, answer);
}
