#include <sunder/ask/progress.h>
#include <sunder/ask/report.h>
#include <sunder/ask/scene/between.h>

#include <sunder/base/error.h>
#include <sunder/io/robot_motion.h>
#include <sunder/scene/sweep.h>

#include <fmt/format.h>

#include <string>
#include <utility>
#include <vector>

namespace sunder::ask {

namespace {

std::vector<scene::Body> placed(const SceneInput& input, const io::RobotMotion& motion, const io::JointTable& table,
                                std::size_t row, std::vector<scene::Body> bodies) {
  std::vector<scene::Part*> parts;
  for (scene::Body& body : bodies) {
    for (scene::Part& part : body.parts) parts.push_back(&part);
  }
  std::vector<solid::Pose> links(input.robot("--between").links.size());
  try {
    motion.place(table.row(row), links);
    input.place_links(links, [&](std::uint32_t part, const solid::Pose& pose) { parts[part]->pose = pose; });
  } catch (const Error& error) {
    throw Error(error.code(), error.what(), table.place(row));
  }
  return bodies;
}

std::string line_of(std::size_t number, const scene::SweptAnswer& answer, std::span<const scene::Body> bodies,
                    const SceneInput& input) {
  std::string text = fmt::format("{} to {}: ", number, number + 1);
  const char* between = "";
  for (const scene::SweptPair& pair : answer.pairs) {
    const bool is_hull = input.is_hull(pair.body_a, pair.part_a) || input.is_hull(pair.body_b, pair.part_b);
    text += fmt::format("{}{} and {} meet{} ", between, part_name(bodies[pair.body_a], pair.part_a),
                        part_name(bodies[pair.body_b], pair.part_b), is_hull ? " as hulls" : "");
    text += !pair.all_the_way ? fmt::format("at the {}", pair.time.low == 0 ? "begin" : "end")
                              : fmt::format("from {}{:.6g} of the way on",
                                            pair.time.low == pair.time.high ? "" : "about ", pair.time.high);
    between = "; ";
  }
  if (answer.pairs.empty()) text += answer.none_meet() ? "none meet" : "none is known to meet";
  return text + "\n";
}

}  // namespace

int answer_between(const SceneInput& input, const scene::Question& question, const io::JointTable& table) {
  if (question.contacts) {
    throw Error(ErrorCode::bad_call, "does not tell touching from overlapping; leave out --classify and --allow touch",
                "--between");
  }
  if (table.rows() < 2) {
    throw Error(ErrorCode::bad_call, "is for two placements or more; there is one, so leave it out", "--between");
  }
  const io::RobotMotion motion(input.robot("--between"), table.joints);
  std::vector<scene::Body> last = placed(input, motion, table, 0, input.bodies({}));
  const std::size_t steps = table.rows() - 1;
  std::uint64_t some = 0, all_the_way = 0, at_ends_only = 0, unknown = 0;
  Progress progress("placements");
  const auto report = progress.reporter();
  for (std::size_t k = 0; k < steps; ++k) {
    std::vector<scene::Body> next = placed(input, motion, table, k + 1, last);
    const scene::SweptAnswer answer = meeting_on_the_way(last, next, question);
    print_for_people(line_of(k, answer, next, input));
    some += answer.some_meet();
    unknown += !answer.some_meet() && !answer.none_meet();
    all_the_way += answer.counts.by_boxes + answer.counts.by_method;
    at_ends_only += answer.counts.at_ends_only;
    last = std::move(next);
    if (report) report(static_cast<double>(k + 1) / static_cast<double>(steps));
  }
  std::string text = fmt::format("{}, of which {} {}", count_of(steps, "step"), some,
                                 input.left_out().empty() ? "have bodies that meet on the way"
                                                          : "have bodies, of those read, that meet on the way");
  if (unknown > 0) text += fmt::format("; where that is not known: {}", unknown);
  text += fmt::format("; pairs asked about all the way: {}", all_the_way);
  if (at_ends_only > 0) {
    text += fmt::format("; at their ends only, as a part turns or has a radius: {}", at_ends_only);
  }
  print_for_people(text + input.left_out().clause() + "\n");
  return some + unknown > 0 ? exit_code::yes : exit_code::no;
}

}  // namespace sunder::ask
