// A robot out of its URDF file: which links meet, in how many of so many random placements? What is said of the first
// one is proved. Arguments: ROBOT.urdf NUMBER PROOF.json
#include <sunder/base/random.h>
#include <sunder/io/text/file.h>
#include <sunder/robot/rows.h>
#include <sunder/scene/scene_claims.h>

#include <iostream>
#include <map>

int main(int, char** arguments) {
  using namespace sunder;
  using namespace sunder::scene;
  const robot::Cell cell(std::vector<robot::CellFile>{{arguments[1]}});
  const std::vector<std::string> joints = io::movable_joints(cell.robot("joints"));
  std::vector<double> values(std::stoul(arguments[2]) * joints.size());
  for (Random random(1); double& value : values) value = random.uniform(-2, 2);
  const robot::Rows rows(cell, joints, values, values.size() / joints.size());
  const std::vector<Body> bodies = cell.place();
  const Question question{.allowed = bodies_of(cell.adjacent("robot")), .every_pair = true};

  using Times = std::map<std::array<std::uint32_t, 2>, std::size_t>;
  Times all;
  const auto look = [](std::size_t, const Moment& moment, Times& found) {
    for (const PartPair& pair : moment.meeting.pairs) ++found[{pair.body_a, pair.body_b}];
  };
  const auto take = [&](const Times& found, std::size_t) {
    for (const auto& [pair, times] : found) all[pair] += times;
  };
  run_timeline<Times>(practised({bodies, question}, rows), rows, thread_count(0), look, take);
  for (const auto& [pair, n] : all)
    std::cout << bodies[pair[0]].name << ' ' << bodies[pair[1]].name << ' ' << n << '\n';

  robot::RowBodies placed(rows, bodies);
  const auto answer = meeting_pairs(placed.at(0), question);
  io::OutputFile proof(arguments[3]);
  write_certificate(std::array{Placement{"first", placed.at(0), answer}}, question, {},
                    [&](std::string_view text) { proof.write(text); });
  proof.commit();
}
