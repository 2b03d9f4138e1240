// Robots out of files: which links meet, for thousands of placements in one call.
#include <sunder/certificate/rounded_evidence.h>
#include <sunder/robot/cell.h>
#include <sunder/robot/rows.h>
#include <sunder/scene/scene_claims.h>
#include <sunder/scene/timeline.h>

#include "common.h"

#include <algorithm>
#include <cstdlib>
#include <limits>

namespace sunder::python {

namespace {

using Pairs = std::vector<std::array<std::uint32_t, 2>>;
using Names = std::vector<std::string>;

// Pairs of parts that meet in a way that counts, or are undecided; in the order of placements, then of scene.h.
struct Collisions {
  std::size_t placements = 0;
  std::vector<std::uint64_t> placement;  // of each pair
  Pairs bodies, parts;
  std::vector<std::uint8_t> decided;  // do they meet, for all that is known?
  std::vector<Point3> points;         // about where, where it was asked for; NaN of what is undecided

  void append(const Collisions& other) {
    const auto add = [](auto& to, const auto& from) { to.insert(to.end(), from.begin(), from.end()); };
    add(placement, other.placement);
    add(bodies, other.bodies);
    add(parts, other.parts);
    add(decided, other.decided);
    add(points, other.points);
  }
};

std::vector<robot::CellFile> files_of(const std::string& robot, const std::string& scene) {
  std::vector<robot::CellFile> files{{robot}};
  if (!scene.empty()) files.push_back({scene});
  return files;
}

robot::CellOptions options_of(const Names& packages, bool require_convex, bool leave_out) {
  const char* search = std::getenv("ROS_PACKAGE_PATH");
  return {require_convex, leave_out, io::parse_packages(packages, search == nullptr ? "" : search)};
}

class Robot {
 public:
  Robot(const std::string& file, const Names& packages, const std::string& srdf, const std::string& scene,
        const Names& groups, bool require_convex, bool leave_out)
      : cell_(files_of(file, scene), options_of(packages, require_convex, leave_out), &inputs_) {
    Names remarks;
    if (!srdf.empty()) cell_.add_srdf(io::read_srdf(srdf, &inputs_), srdf, "", "srdf");
    if (!groups.empty()) cell_.keep_groups(groups, "groups", remarks);
    add_allowed(cell_.allowed(remarks), allowed_);
  }

  void allow(const std::string& a, const std::string& b) {
    if (a == b)
      throw Error(ErrorCode::bad_call, "'" + a + "' is named twice; parts of a body are never compared", "allow");
    add_allowed(std::array{robot::AllowedPair{{cell_.body_named(a, "allow"), cell_.body_named(b, "allow")}, "allow"}},
                allowed_);
  }
  void allow_adjacent() { add_allowed(cell_.adjacent("allow"), allowed_); }
  void allow_touch() { touch_ = true; }

  const std::string& name() const { return model().name; }
  Names links() const { return names_of(model().links); }
  Names bodies() const { return names_of(cell_.bodies()); }
  Names part_names(std::uint32_t body) const { return names_of(cell_.bodies().at(body).parts); }
  Names left_out() const { return cell_.left_out().texts(); }
  Names hulls() const {
    Names all;
    for (const robot::CellBody& body : cell_.bodies()) {
      if (std::any_of(body.parts.begin(), body.parts.end(),
                      [](const io::BodyPart& part) { return part.body.shape == io::BodyShape::hull; })) {
        all.push_back(body.name);
      }
    }
    return all;
  }
  std::vector<std::pair<std::string, std::string>> allowed() const {
    std::vector<std::pair<std::string, std::string>> all;
    for (const auto& [a, b] : allowed_pairs()) all.emplace_back(cell_.bodies()[a].name, cell_.bodies()[b].name);
    return all;
  }
  nb::dict joints() const {
    nb::dict all;
    const Names names = io::movable_joints(model());
    const io::RobotMotion motion(model(), names);
    for (std::size_t k = 0; k < names.size(); ++k) {
      all[names[k].c_str()] = nb::make_tuple(motion.joint_of(k).lower, motion.joint_of(k).upper);
    }
    return all;
  }

  Collisions collisions(const Names& joints, const Doubles& values, bool evidence, std::uint64_t threads) const {
    return unlocked([&] { return found(joints, values, evidence, threads); });
  }

  nb::bytes certificate(const Names& joints, const Doubles& values) const {
    const std::string text = unlocked([&] { return proof(joints, values); });
    return nb::bytes(text.data(), text.size());
  }

 private:
  template <class Named>
  static Names names_of(const std::vector<Named>& all) {
    Names names;
    for (const Named& each : all) names.push_back(each.name);
    return names;
  }

  const io::Robot& model() const { return cell_.robot("file"); }

  // Sorted, the lower body first.
  Pairs allowed_pairs() const {
    Pairs pairs = bodies_of(allowed_);
    for (auto& pair : pairs) std::sort(pair.begin(), pair.end());
    std::sort(pairs.begin(), pairs.end());
    return pairs;
  }

  scene::Question question() const {
    scene::Question question;
    question.allowed = allowed_pairs();
    question.touching_allowed = question.contacts = touch_;
    return question;
  }

  robot::Rows rows_of(const Names& joints, const Doubles& values) const {
    return {cell_, joints, {values.data(), values.size()}, values.shape(0), [](std::size_t row) {
              return "joints[" + std::to_string(row) + "]";
            }};
  }

  Collisions found(const Names& joints, const Doubles& values, bool evidence, std::uint64_t threads) const {
    const robot::Rows rows = rows_of(joints, values);
    Collisions all;
    all.placements = scene::run_timeline<Collisions>(
        practised(scene::MomentFollower(cell_.place(), question()), rows), rows, scene::thread_count(threads),
        [&](std::size_t k, const scene::Moment& moment, Collisions& out) { take(k, moment, evidence, out); },
        [&](const Collisions& chain, std::size_t) { all.append(chain); });
    return all;
  }

  std::string proof(const Names& joints, const Doubles& values) const {
    const robot::Rows rows = rows_of(joints, values);
    const std::vector<scene::Body> bodies = cell_.place();
    scene::Question asked = question();
    asked.every_pair = true;
    robot::RowBodies placed(rows, bodies);
    std::vector<std::vector<scene::PartPair>> met;
    std::uint64_t decided = 0;
    for (std::size_t k = 0; k < rows.size(); ++k) {
      scene::Answer answer = scene::meeting_pairs(placed.at(k), asked);
      decided += answer.pairs.size() - answer.counts.undecided;
      std::erase_if(answer.pairs, [](const scene::PartPair& pair) { return !pair.meet() && !pair.undecided(); });
      met.push_back(std::move(answer.pairs));
    }
    if (decided == 0) {
      throw Error(ErrorCode::bad_call, "no pair is asked about and decided, so there is nothing to prove",
                  "certificate");
    }
    std::string text;
    scene::write_whole_certificate(
        bodies, rows.size(),
        [&](std::size_t k) { return scene::MeetingPlacement{std::to_string(k), placed.at(k), met[k]}; }, asked,
        {inputs_, cell_.left_out().texts()}, [&](std::string_view piece) { text += piece; });
    return text;
  }

  static void take(std::size_t k, const scene::Moment& moment, bool evidence, Collisions& out) {
    constexpr double none = std::numeric_limits<double>::quiet_NaN();
    for (const scene::PartPair& pair : moment.meeting.pairs) {
      if (!pair.counts && !pair.undecided()) continue;
      out.placement.push_back(k);
      out.bodies.push_back({pair.body_a, pair.body_b});
      out.parts.push_back({pair.part_a, pair.part_b});
      out.decided.push_back(pair.undecided() ? 0 : 1);
      if (!evidence) continue;
      out.points.push_back(pair.undecided() ? Point3{none, none, none}
                                            : rounded_common_point(pair, moment.bodies[pair.body_a].parts[pair.part_a],
                                                                   moment.bodies[pair.body_b].parts[pair.part_b]));
    }
  }

  InputFiles inputs_;
  robot::Cell cell_;
  std::vector<robot::AllowedPair> allowed_;
  bool touch_ = false;
};

}  // namespace

void bind_robots(nb::module_& module) {
  nb::class_<Collisions>(module, "_Collisions")
      .def_ro("placements", &Collisions::placements)
      .def_prop_ro(
          "placement", [](const Collisions& c) { return array_of<std::uint64_t>(c.placement); }, owned)
      .def_prop_ro(
          "bodies", [](const Collisions& c) { return array_of<std::uint32_t, 2>(c.bodies); }, owned)
      .def_prop_ro(
          "parts", [](const Collisions& c) { return array_of<std::uint32_t, 2>(c.parts); }, owned)
      .def_prop_ro(
          "decided", [](const Collisions& c) { return array_of<std::uint8_t>(c.decided); }, owned)
      .def_prop_ro("points", [](const Collisions& c) { return array_of<double, 3>(c.points); }, owned);
  nb::class_<Robot>(module, "_Robot")
      .def(nb::init<const std::string&, const Names&, const std::string&, const std::string&, const Names&, bool,
                    bool>())
      .def("allow", &Robot::allow)
      .def("allow_adjacent", &Robot::allow_adjacent)
      .def("allow_touch", &Robot::allow_touch)
      .def_prop_ro("name", &Robot::name)
      .def_prop_ro("links", &Robot::links)
      .def_prop_ro("bodies", &Robot::bodies)
      .def("part_names", &Robot::part_names)
      .def_prop_ro("hulls", &Robot::hulls)
      .def_prop_ro("allowed", &Robot::allowed)
      .def_prop_ro("left_out", &Robot::left_out)
      .def_prop_ro("joints", &Robot::joints)
      .def("collisions", &Robot::collisions)
      .def("certificate", &Robot::certificate);
}

}  // namespace sunder::python
