// Robots out of files: which links meet, for thousands of placements in one call.
#include <sunder/io/robot_bodies.h>
#include <sunder/io/robot_motion.h>
#include <sunder/io/scene_file.h>
#include <sunder/io/srdf.h>
#include <sunder/scene/rounded_evidence.h>
#include <sunder/scene/scene_json.h>
#include <sunder/scene/timeline.h>
#include <sunder/solid/object/affine_product.h>

#include "common.h"

#include <algorithm>
#include <cstdlib>
#include <limits>
#include <set>

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

class Robot {
 public:
  Robot(const std::string& file, const Names& packages, const std::string& srdf, const std::string& scene,
        const Names& groups, bool require_convex, bool leave_out)
      : left_out_(leave_out) {
    const char* search = std::getenv("ROS_PACKAGE_PATH");
    robot_ = io::read_urdf(file, &inputs_);
    links_ = io::read_robot_bodies(robot_, file, require_convex, left_out_, &inputs_,
                                   io::parse_packages(packages, search == nullptr ? "" : search));
    if (!links_.told.empty() && !left_out_.consent()) left_out_ = io::LeftOutList(file, links_.told);
    if (links_.bodies.empty()) {
      throw Error(ErrorCode::bad_file, "no link has a shape, so there is nothing to ask about", file);
    }
    const io::Srdf given = srdf.empty() ? io::Srdf{} : io::read_srdf(srdf, &inputs_);
    adjacent_ = adjacent_links();
    if (!groups.empty()) keep_groups(given, groups, file);
    for (const io::LinkBody& body : links_.bodies) names_.push_back(robot_.links[body.link].name);
    allow_disabled(given);
    if (!scene.empty()) add_scene(scene, require_convex);
  }

  void allow(const std::string& a, const std::string& b) {
    const std::uint32_t i = number_of(a), j = number_of(b);
    if (i == j)
      throw Error(ErrorCode::bad_call, "'" + a + "' is named twice; parts of a body are never compared", "allow");
    allowed_.insert({std::min(i, j), std::max(i, j)});
  }
  void allow_adjacent() {
    for (const auto& [a, b] : adjacent_) {
      if (is_body(a) && is_body(b)) allow(a, b);
    }
  }
  void allow_touch() { touch_ = true; }

  const std::string& name() const { return robot_.name; }
  Names links() const {
    Names all;
    for (const io::Link& link : robot_.links) all.push_back(link.name);
    return all;
  }
  const Names& bodies() const { return names_; }
  Names part_names(std::uint32_t body) const {
    Names all;
    for (const io::BodyPart& part : parts_of(body)) all.push_back(part.name);
    return all;
  }
  Names hulls() const {
    Names all;
    for (std::uint32_t b = 0; b < names_.size(); ++b) {
      const auto& parts = parts_of(b);
      if (std::any_of(parts.begin(), parts.end(),
                      [](const io::BodyPart& part) { return part.body.shape == io::BodyShape::hull; })) {
        all.push_back(names_[b]);
      }
    }
    return all;
  }
  std::vector<std::pair<std::string, std::string>> allowed() const {
    std::vector<std::pair<std::string, std::string>> all;
    for (const auto& [a, b] : allowed_) all.emplace_back(names_[a], names_[b]);
    return all;
  }
  Names left_out() const { return left_out_.texts(); }
  nb::dict joints() const {
    nb::dict all;
    const io::RobotMotion motion(robot_, io::movable_joints(robot_));
    for (const std::string& joint : io::movable_joints(robot_)) {
      const auto found =
          std::find_if(robot_.joints.begin(), robot_.joints.end(), [&](const io::Joint& j) { return j.name == joint; });
      all[joint.c_str()] = nb::make_tuple(found->lower, found->upper);
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
  bool is_body(const std::string& name) const { return std::find(names_.begin(), names_.end(), name) != names_.end(); }

  void allow_disabled(const io::Srdf& srdf) {
    for (const auto& [links, reason] : srdf.disabled) {
      if (is_body(links[0]) && is_body(links[1])) allow(links[0], links[1]);
    }
  }

  // Of all links, so that those on both sides of one that is in no group are not taken for neighbours.
  std::vector<std::pair<std::string, std::string>> adjacent_links() const {
    std::vector<std::pair<std::string, std::string>> pairs;
    const auto name = [&](std::uint32_t body) { return robot_.links[links_.bodies[body].link].name; };
    for (const auto& [a, b] : io::adjacent_bodies(robot_, links_)) pairs.emplace_back(name(a), name(b));
    return pairs;
  }

  void keep_groups(const io::Srdf& srdf, const Names& groups, const std::string& file) {
    Names remarks;
    const std::vector<std::uint32_t> kept = io::group_links(srdf, robot_, groups, "groups", remarks);
    std::vector<io::LeftOut> left_out;
    std::erase_if(links_.bodies, [&](const io::LinkBody& body) {
      if (std::binary_search(kept.begin(), kept.end(), body.link)) return false;
      left_out.push_back({"shape", robot_.links[body.link].name, body.parts.size()});
      return true;
    });
    if (links_.bodies.empty()) {
      throw Error(ErrorCode::bad_call, "no link of them has a shape, so there is nothing to ask about", "groups");
    }
    if (left_out.empty()) return;
    if (left_out_.consent()) {
      left_out_.add(file, left_out, "");
    } else {
      left_out_ = io::LeftOutList(file, left_out);
    }
  }

  // Bodies that do not move.
  void add_scene(const std::string& file, bool require_convex) {
    const io::SceneFile scene = io::read_scene_file(file, &inputs_);
    if (!scene.unit.empty() && scene.unit != "m") {
      throw Error(ErrorCode::bad_call, "is in " + scene.unit + ", and the robot is in m; scale one of them", file);
    }
    const auto first = static_cast<std::uint32_t>(names_.size());
    fixed_ = io::read_scene_parts(scene, file, require_convex, left_out_, &inputs_);
    for (const io::SceneFile::Body& body : scene.bodies) {
      if (std::find(names_.begin(), names_.end(), body.name) != names_.end()) {
        throw Error(ErrorCode::bad_call, "a link of the robot is named '" + body.name + "', too; rename one", file);
      }
      names_.push_back(body.name);
    }
    for (const auto& [a, b] : scene.allowed) allowed_.insert({first + a, first + b});
  }

  std::uint32_t number_of(const std::string& name) const {
    const auto found = std::find(names_.begin(), names_.end(), name);
    if (found == names_.end()) throw Error(ErrorCode::bad_call, "no body is named '" + name + "'", "allow");
    return static_cast<std::uint32_t>(found - names_.begin());
  }

  const std::vector<io::BodyPart>& parts_of(std::uint32_t body) const {
    return body < links_.bodies.size() ? links_.bodies[body].parts : fixed_.at(body - links_.bodies.size());
  }

  scene::Question question() const {
    scene::Question question;
    for (const auto& [a, b] : allowed_) question.allowed.push_back({a, b});
    question.touching_allowed = question.contacts = touch_;
    return question;
  }

  std::vector<scene::Body> bodies_at(std::span<const solid::Pose> poses) const {
    std::vector<scene::Body> placed;
    for (std::uint32_t b = 0; b < names_.size(); ++b) {
      const bool moves = b < links_.bodies.size();
      placed.push_back(io::placed_body(names_[b], parts_of(b), moves ? poses[links_.bodies[b].link] : solid::Pose()));
    }
    return placed;
  }

  std::string proof(const Names& joints, const Doubles& values) const {
    const io::RobotMotion motion(robot_, joints);
    scene::Question asked = question();
    asked.every_pair = true;
    std::vector<std::vector<scene::Body>> bodies;
    std::vector<scene::Answer> answers;
    Names titles;
    std::vector<Affine3> links(robot_.links.size());
    for (std::size_t k = 0; k < values.shape(0); ++k) {
      motion.place({values.data() + k * joints.size(), joints.size()}, links);
      std::vector<solid::Pose> poses;
      for (const Affine3& link : links) poses.push_back(solid::Pose::from_matrix(link.linear, link.translation));
      bodies.push_back(bodies_at(poses));
      answers.push_back(scene::meeting_pairs(bodies.back(), asked));
      titles.push_back(std::to_string(k));
    }
    std::vector<scene::Placement> placements;
    std::size_t pairs = 0;
    for (std::size_t k = 0; k < answers.size(); ++k) {
      placements.push_back({titles[k], bodies[k], answers[k]});
      pairs += answers[k].pairs.size() - answers[k].counts.undecided;
    }
    if (pairs == 0) {
      throw Error(ErrorCode::bad_call, "no pair is asked about and decided, so there is nothing to prove",
                  "certificate");
    }
    std::string text;
    scene::write_certificate(placements, asked, {inputs_, left_out_.texts()},
                             [&](std::string_view piece) { text += piece; });
    return text;
  }

  // The rows of one call, for run_timeline.
  struct Rows {
    const Robot& of;
    const io::RobotMotion motion;
    std::span<const double> values;
    std::size_t columns, count;

    std::size_t size() const { return count; }
    std::string name(std::size_t row) const { return "joints[" + std::to_string(row) + "]"; }
    auto placer() const {
      return [this, links = std::vector<Affine3>(of.robot_.links.size())](std::size_t row, const auto& put) mutable {
        motion.place(values.subspan(row * columns, columns), links);
        std::uint32_t number = 0;
        for (const io::LinkBody& body : of.links_.bodies) {
          for (const io::BodyPart& part : body.parts) {
            const Affine3 &link = links[body.link], &inner = part.pose.affine();
            const Affine3 at = io::is_identity(inner) ? link : solid::affine_product(link, inner);
            put(number++, solid::Pose::from_matrix(at.linear, at.translation));
          }
        }
      };
    }
  };

  Collisions found(const Names& joints, const Doubles& values, bool evidence, std::uint64_t threads) const {
    const Rows rows{
        *this, io::RobotMotion(robot_, joints), {values.data(), values.size()}, joints.size(), values.shape(0)};
    const scene::MomentFollower start(bodies_at(std::vector<solid::Pose>(robot_.links.size())), question());
    Collisions all;
    all.placements = scene::run_timeline<Collisions>(
        practised(start, rows), rows, scene::thread_count(threads),
        [&](std::size_t k, const scene::Moment& moment, Collisions& out) {
          take(k, moment, evidence, out);
          return true;
        },
        [&](const Collisions& chain, std::size_t) {
          all.append(chain);
          return true;
        });
    return all;
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
      out.points.push_back(pair.undecided()
                               ? Point3{none, none, none}
                               : scene::rounded_common_point(pair, moment.bodies[pair.body_a].parts[pair.part_a],
                                                             moment.bodies[pair.body_b].parts[pair.part_b]));
    }
  }

  io::Robot robot_;
  io::RobotBodies links_;
  std::vector<std::vector<io::BodyPart>> fixed_;  // the parts of bodies that do not move, after the links
  Names names_;                                   // of all bodies
  io::LeftOutList left_out_;
  InputFiles inputs_;
  std::set<std::pair<std::uint32_t, std::uint32_t>> allowed_;
  std::vector<std::pair<std::string, std::string>> adjacent_;  // links
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
