// Robots out of files: what meets, what is too near and what meets on the way, for thousands of placements in one call.
#include <sunder/certificate/said.h>
#include <sunder/robot/cell.h>
#include <sunder/robot/rows.h>
#include <sunder/scene/scene_claims.h>
#include <sunder/scene/timeline.h>

#include "common.h"

#include <nanobind/stl/map.h>

#include <algorithm>
#include <cstdlib>
#include <limits>
#include <map>
#include <tuple>

namespace sunder::python {

namespace {

using Names = std::vector<std::string>;
using NamePairs = std::vector<std::pair<std::string, std::string>>;

// What was found in each row: pairs of parts, with numbers that tell more of each.
struct Found {
  std::vector<std::array<std::uint8_t, 2>> verdicts;  // of each row: is something found, is something undecided?
  std::vector<std::uint64_t> row;                     // of each pair; likewise below
  std::vector<std::array<std::uint32_t, 2>> bodies, parts;
  std::vector<std::uint8_t> decided;
  std::vector<std::array<double, 3>> numbers;

  void append(const Found& other) {
    const auto add = [](auto& to, const auto& from) { to.insert(to.end(), from.begin(), from.end()); };
    add(verdicts, other.verdicts);
    add(row, other.row);
    add(bodies, other.bodies);
    add(parts, other.parts);
    add(decided, other.decided);
    add(numbers, other.numbers);
  }

  void add(std::size_t k, const auto& pair, bool is_decided, const std::array<double, 3>& more) {
    row.push_back(k);
    bodies.push_back({pair.body_a, pair.body_b});
    parts.push_back({pair.part_a, pair.part_b});
    decided.push_back(is_decided ? 1 : 0);
    numbers.push_back(more);
  }
};

robot::CellOptions options_of(const Names& packages, bool require_convex, bool leave_out) {
  const char* search = std::getenv("ROS_PACKAGE_PATH");
  return {require_convex, false, leave_out, io::parse_packages(packages, search == nullptr ? "" : search)};
}

class Robot {
 public:
  // srdfs: the robot, or nothing, and the file; allow: "adjacent", "touch", or a name with another one.
  Robot(const NamePairs& files, const Doubles& poses, const Names& packages, const NamePairs& srdfs,
        const Names& groups, const NamePairs& attached, const NamePairs& allow, bool require_convex, bool leave_out)
      : cell_(files_of(files, poses), options_of(packages, require_convex, leave_out), &inputs_) {
    Names remarks;
    for (const auto& [robot, file] : srdfs) cell_.add_srdf(io::read_srdf(file, &inputs_), file, robot, "srdf");
    for (const auto& [name, link] : attached) cell_.attach(name, link, "attach");
    if (!groups.empty()) cell_.keep_groups(groups, "groups", remarks);
    for (const auto& [a, b] : allow) {
      if (b.empty() && a == "touch") {
        question_.touching_allowed = question_.contacts = true;
      } else if (b.empty()) {
        add_allowed(cell_.adjacent("allow"), allowed_);
      } else {
        if (a == b)
          throw Error(ErrorCode::bad_call, "'" + a + "' is named twice; parts of a body are never compared", "allow");
        add_allowed(
            std::array{robot::AllowedPair{{cell_.body_named(a, "allow"), cell_.body_named(b, "allow")}, "allow"}},
            allowed_);
      }
    }
    add_allowed(cell_.allowed(remarks), allowed_);
    question_.allowed = bodies_of(allowed_);
  }

  std::string name() const { return cell_.robots().empty() ? "" : cell_.robots()[0].model.name; }
  Names links() const { return names_of(cell_.robot("links").links); }
  Names bodies() const { return names_of(cell_.bodies()); }
  Names part_names(std::uint32_t body) const { return names_of(cell_.bodies().at(body).parts); }
  Names left_out() const { return cell_.left_out().texts(); }
  Names states() const { return cell_.state_names(); }
  std::map<std::string, double> state(const std::string& name) const {
    Names remarks;
    return cell_.state(name, "state", remarks).values;
  }
  Names hulls() const {
    Names all;
    for (std::uint32_t b = 0; b < cell_.bodies().size(); ++b) {
      const std::uint32_t parts = static_cast<std::uint32_t>(cell_.bodies()[b].parts.size());
      for (std::uint32_t p = 0; p < parts; ++p) {
        if (cell_.is_hull(b, p) && (all.empty() || all.back() != cell_.bodies()[b].name)) {
          all.push_back(cell_.bodies()[b].name);
        }
      }
    }
    return all;
  }
  NamePairs allowed() const {
    NamePairs all;
    for (const auto& [a, b] : question_.allowed) all.emplace_back(cell_.bodies()[a].name, cell_.bodies()[b].name);
    return all;
  }
  nb::dict joints() const {
    nb::dict all;
    for (const io::Joint& joint : cell_.robot("joints").joints) {
      if (joint.type != io::JointType::fixed && !joint.mimic)
        all[joint.name.c_str()] = nb::make_tuple(joint.lower, joint.upper);
    }
    return all;
  }

  Found collisions(const Names& joints, const Doubles& values, bool evidence, std::uint64_t threads) const {
    return found<scene::MomentFollower>(
        joints, values, threads, {cell_.place(), question_},
        [evidence](auto k, const scene::Moment& moment, Found& out) {
          constexpr double none = std::numeric_limits<double>::quiet_NaN();
          out.verdicts.push_back({moment.meeting.some_meet(), moment.meeting.counts.leave_some_open()});
          for (const scene::PartPair& pair : moment.meeting.pairs) {
            if (!pair.counts && !pair.undecided()) continue;
            const auto& [a, b] =
                std::tie(moment.bodies[pair.body_a].parts[pair.part_a], moment.bodies[pair.body_b].parts[pair.part_b]);
            const Point3 p =
                pair.undecided() || !evidence ? Point3{none, none, none} : rounded_common_point(pair, a, b);
            out.add(k, pair, !pair.undecided(), {p.x, p.y, p.z});
          }
        });
  }

  Found clearance(const Names& joints, const Doubles& values, double least, std::uint64_t threads) const {
    const scene::NearnessQuestion near{scene::ClearanceQuestion{least, {}, question_.allowed}, false, {}};
    return found<scene::MomentFollower>(
        joints, values, threads, {cell_.place(), question_, near}, [](auto k, const scene::Moment& moment, Found& out) {
          const scene::ClearanceAnswer& answer = *moment.near.clearance;
          out.verdicts.push_back({!answer.closer.empty(), answer.leaves_some_open()});
          for (const auto* list : {&answer.closer, &answer.undecided}) {
            for (const scene::CloserParts& pair : *list) {
              out.add(k, pair, list == &answer.closer, {pair.distance.low, pair.distance.high});
            }
          }
        });
  }

  Found motion(const Names& joints, const Doubles& values, std::uint64_t threads) const {
    if (question_.contacts)
      throw Error(ErrorCode::bad_call, "does not tell touching from overlapping; do not allow \"touch\"", "motion");
    if (values.shape(0) < 2) throw Error(ErrorCode::bad_call, "is for two placements or more", "motion");
    return found<scene::StepFollower>(
        joints, values, threads, {cell_.place(), question_}, [](auto k, const scene::SweptAnswer& answer, Found& out) {
          out.verdicts.push_back({answer.some_meet(), !answer.some_meet() && !answer.none_meet()});
          for (const scene::SweptPair& pair : answer.pairs) {
            const Interval time = pair.meet() ? pair.time() : Interval{0, 0};
            out.add(k, pair, !pair.undecided(), {time.low, time.high, pair.all_the_way() ? 1.0 : 0.0});
          }
        });
  }

  auto poses(const Names& joints, const Doubles& values) const {
    const robot::Rows rows = rows_of(joints, values);
    std::vector<Affine3> links(cell_.robot("joints").links.size());
    std::vector<std::array<double, 16>> all;
    for (std::size_t k = 0; k < rows.size(); ++k) {
      rows.motion().place(rows[k], links);
      for (std::uint32_t link = 0; link < links.size(); ++link) {
        const auto& [m, t] = cell_.link_frame(link, links);
        all.push_back({m[0], m[1], m[2], t[0], m[3], m[4], m[5], t[1], m[6], m[7], m[8], t[2], 0, 0, 0, 1});
      }
    }
    return array_of<double, 16>(std::move(all));
  }

  nb::bytes certificate(const Names& joints, const Doubles& values) const {
    return bytes_of([&] { return proof(joints, values); });
  }

 private:
  static std::vector<robot::CellFile> files_of(const NamePairs& files, const Doubles& poses) {
    std::vector<robot::CellFile> all;
    for (std::size_t k = 0; k < files.size(); ++k) {
      const double* const m = poses.data() + 12 * k;
      const solid::Pose pose =
          solid::Pose::from_matrix({m[0], m[1], m[2], m[4], m[5], m[6], m[8], m[9], m[10]}, {m[3], m[7], m[11]});
      all.push_back({files[k].second, files[k].first, pose});
    }
    return all;
  }

  static Names names_of(const auto& all) {
    Names names;
    for (const auto& each : all) names.push_back(each.name);
    return names;
  }

  robot::Rows rows_of(const Names& joints, const Doubles& values) const {
    return {cell_, joints, {values.data(), values.size()}, values.shape(0), [](std::size_t row) {
              return "joints[" + std::to_string(row) + "]";
            }};
  }

  template <class Follower>
  Found found(const Names& joints, const Doubles& values, std::uint64_t threads, Follower start,
              const auto& take) const {
    return unlocked([&] {
      const robot::Rows rows = rows_of(joints, values);
      if constexpr (Follower::rows_before == 0) start = practised(std::move(start), rows);
      Found all;
      scene::run_timeline<Found>(start, rows, scene::thread_count(threads), take,
                                 [&](const Found& chain, std::size_t) { all.append(chain); });
      return all;
    });
  }

  std::string proof(const Names& joints, const Doubles& values) const {
    const robot::Rows rows = rows_of(joints, values);
    const std::vector<scene::Body> bodies = cell_.place();
    scene::Question asked = question_;
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
    const auto joints_of = [&](std::size_t k) -> std::optional<SaidNote> {
      std::vector<std::pair<std::string, double>> all;
      for (std::size_t j = 0; j < joints.size(); ++j) all.emplace_back(joints[j], rows[k][j]);
      return all.empty() ? std::nullopt : std::optional(SaidNote::joint_values(all));
    };
    std::string text;
    scene::write_whole_certificate(
        bodies, rows.size(),
        [&](std::size_t k) { return scene::MeetingPlacement{std::to_string(k), placed.at(k), met[k]}; }, asked,
        {inputs_, cell_.left_out().texts()}, [&](std::string_view piece) { text += piece; }, nullptr,
        {{}, reason_of_each(allowed_), joints_of});
    return text;
  }

  InputFiles inputs_;
  robot::Cell cell_;
  std::vector<robot::AllowedPair> allowed_;
  scene::Question question_;
};

}  // namespace

void bind_robots(nb::module_& module) {
  nb::class_<Found>(module, "_Found")
      .def_prop_ro(
          "verdicts", [](const Found& f) { return array_of<std::uint8_t, 2>(f.verdicts); }, owned)
      .def_prop_ro(
          "row", [](const Found& f) { return array_of<std::uint64_t>(f.row); }, owned)
      .def_prop_ro(
          "bodies", [](const Found& f) { return array_of<std::uint32_t, 2>(f.bodies); }, owned)
      .def_prop_ro(
          "parts", [](const Found& f) { return array_of<std::uint32_t, 2>(f.parts); }, owned)
      .def_prop_ro(
          "decided", [](const Found& f) { return array_of<std::uint8_t>(f.decided); }, owned)
      .def_prop_ro("numbers", [](const Found& f) { return array_of<double, 3>(f.numbers); }, owned);
  nb::class_<Robot>(module, "_Robot")
      .def(nb::init<const NamePairs&, const Doubles&, const Names&, const NamePairs&, const Names&, const NamePairs&,
                    const NamePairs&, bool, bool>())
      .def_prop_ro("name", &Robot::name)
      .def_prop_ro("links", &Robot::links)
      .def_prop_ro("bodies", &Robot::bodies)
      .def("part_names", &Robot::part_names)
      .def_prop_ro("hulls", &Robot::hulls)
      .def_prop_ro("allowed", &Robot::allowed)
      .def_prop_ro("left_out", &Robot::left_out)
      .def_prop_ro("joints", &Robot::joints)
      .def_prop_ro("states", &Robot::states)
      .def("state", &Robot::state)
      .def("collisions", &Robot::collisions)
      .def("clearance", &Robot::clearance)
      .def("motion", &Robot::motion)
      .def("poses", &Robot::poses, owned)
      .def("certificate", &Robot::certificate);
}

}  // namespace sunder::python
