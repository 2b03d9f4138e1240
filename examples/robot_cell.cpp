// A cell of three bodies, one made of two parts: which meet? Boxes part most pairs; the others are searched, and each
// answer has its evidence.
#include <sunder/scene/scene.h>

#include <iostream>
#include <vector>

int main() {
  using sunder::solid::ConvexPolyhedron;
  using sunder::solid::Pose;
  const ConvexPolyhedron cube(std::vector<sunder::Point3>{
      {0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}, {0, 0, 1}, {1, 0, 1}, {0, 1, 1}, {1, 1, 1}});
  const auto at = [](double x, double y, double z) {
    return Pose::from_matrix({1, 0, 0, 0, 1, 0, 0, 0, 1}, {x, y, z});
  };
  const std::vector<sunder::scene::Body> cell{
      {"table", {{"top", cube, at(0, 0, 0)}}},
      {"gripper", {{"palm", cube, at(0.25, 0.25, 2)}, {"finger", cube, at(0.5, 0.5, 1)}}},  // stands on the table
      {"fence", {{"post", cube, at(5, 0, 0)}}},
  };
  sunder::scene::Question question;
  question.contacts = true;
  const auto answer = meeting_pairs(cell, question);
  for (const auto& pair : answer.pairs) {
    const auto &a = cell[pair.body_a], &b = cell[pair.body_b];
    std::cout << a.parts[pair.part_a].name << " of " << a.name << " and " << b.parts[pair.part_b].name << " of "
              << b.name << ": " << (pair.meet() ? name_of(pair.contact) : "apart") << '\n';
  }
  std::cout << answer.counts.by_boxes << " of " << answer.counts.pairs << " pairs parted by their boxes\n";
  return answer.counts.meeting == 1 ? 0 : 1;
}
