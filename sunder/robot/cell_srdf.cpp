// What SRDFs say of a cell's robots.
#include <sunder/base/error.h>
#include <sunder/io/text/text.h>
#include <sunder/robot/cell.h>
#include <sunder/robot/named_internal.h>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>
#include <set>
#include <utility>

namespace sunder::robot {

// Of "ROBOT/REST" both, else all of it. Of one robot no name is told.
std::pair<std::optional<std::size_t>, std::string> Cell::robot_and_rest(const std::string& name) const {
  for (std::size_t r = 0; r < robots_.size() && robots_.size() > 1; ++r) {
    if (name.starts_with(robots_[r].name + "/")) return {r, name.substr(robots_[r].name.size() + 1)};
  }
  return {std::nullopt, name};
}

void Cell::add_srdf(io::Srdf srdf, const std::string& file, const std::string& robot, const std::string& place) {
  if (!has_robot()) fail_call("there is no robot that this could be about; name a URDF file", place);
  CellSrdf& added = srdfs_.emplace_back(CellSrdf{std::move(srdf), file, {}});
  const auto is_meant = [&](const CellRobot& of) {
    return robot.empty() ? robots_.size() == 1 || of.model.name == added.srdf.name : of.name == robot;
  };
  for (std::size_t r = 0; r < robots_.size(); ++r) {
    if (is_meant(robots_[r])) added.robots.push_back(r);
  }
  if (!added.robots.empty()) return;
  if (!robot.empty()) fail_unknown("robot", robot, robots_, place);
  fail_call(fmt::format("{} is about the robot {}, and no URDF file has this name; give NAME={}, where names are {}",
                        io::one_line(file), io::quote(added.srdf.name), io::one_line(file), names_of(robots_)),
            place);
}

std::vector<AllowedPair> Cell::disabled(std::vector<std::string>& remarks) const {
  std::vector<AllowedPair> all;
  for (const CellSrdf& given : srdfs_) {
    std::set<std::array<std::uint32_t, 2>> known;
    std::vector<AllowedPair> pairs;
    std::vector<io::Srdf::Pair> taken;
    std::vector<std::string> shapeless, unknown;
    for (const std::size_t r : given.robots) {
      const CellRobot& robot = robots_[r];
      for (const io::Srdf::Pair& pair : given.srdf.disabled) {
        std::array<std::optional<std::uint32_t>, 2> both;
        for (std::size_t i = 0; i < 2; ++i) {
          const auto link = named(pair.links[i], robot.model.links);
          if (link == robot.model.links.end()) {
            add_once(pair.links[i], unknown);
            continue;
          }
          const std::uint32_t number = robot.first_link + static_cast<std::uint32_t>(link - robot.model.links.begin());
          both[i] = body_of_link(number);
          if (!both[i] && !is_outside(number)) add_once(pair.links[i], shapeless);
        }
        if (!both[0] || !both[1]) continue;
        const std::array bodies{std::min(*both[0], *both[1]), std::max(*both[0], *both[1])};
        if (!known.insert(bodies).second) continue;
        taken.push_back(pair);
        pairs.push_back({bodies, pair.reason.empty() ? "without a reason" : pair.reason});
      }
    }
    const std::string shown = io::one_line(given.file);
    remarks.push_back(fmt::format("{} allows {}", shown, io::reasons_text(taken)));
    const auto tell_passed_over = [&](const char* what, const std::vector<std::string>& names) {
      if (names.empty()) return;
      remarks.push_back(fmt::format("{}: pairs of links {} are passed over: {}", shown, what, listed(names)));
    };
    tell_passed_over("without a shape", shapeless);
    tell_passed_over("that the robot does not have", unknown);
    std::sort(pairs.begin(), pairs.end(),
              [](const AllowedPair& p, const AllowedPair& q) { return p.bodies < q.bodies; });
    add_allowed(pairs, all);
  }
  return all;
}

std::vector<AllowedPair> Cell::allowed(std::vector<std::string>& remarks) const {
  std::vector<AllowedPair> all = disabled(remarks);
  add_allowed(attached(), all);
  add_allowed(allowed_by_files_, all);
  return all;
}

std::vector<std::string> Cell::state_names() const {
  std::vector<std::string> names;
  for (const CellSrdf& given : srdfs_) {
    for (const std::size_t r : given.robots) {
      const std::string robot = robots_.size() > 1 ? robots_[r].name + "/" : "";
      for (const io::Srdf::State& state : given.srdf.states) {
        names.push_back(robot + (state.group.empty() ? "" : state.group + "/") + state.name);
      }
    }
  }
  return names;
}

// The texts ("NAME", "ROBOT/NAME") by the SRDF and the robot that they are about: of a text without a robot, all that
// have such a thing. One that none has is about the first SRDF, which tells so.
std::map<std::array<std::size_t, 2>, std::vector<std::string>> Cell::by_robot(
    std::span<const std::string> texts, const std::string& place,
    const std::function<bool(const io::Srdf& srdf, const std::string& text)>& has) const {
  std::map<std::array<std::size_t, 2>, std::vector<std::string>> all;
  for (const std::string& text : texts) {
    const std::pair<std::optional<std::size_t>, std::string> about = robot_and_rest(text);
    const std::optional<std::size_t>& robot = about.first;
    const std::string& rest = about.second;
    const auto add = [&](bool asks) {
      bool is_some = false;
      for (std::size_t g = 0; g < srdfs_.size(); ++g) {
        for (const std::size_t r : srdfs_[g].robots) {
          if ((robot && *robot != r) || (asks && !has(srdfs_[g].srdf, rest))) continue;
          all[{g, r}].push_back(rest);
          if (!asks) return true;
          is_some = true;
        }
      }
      return is_some;
    };
    if (!add(true) && !add(false)) fail_call("no SRDF is given that could have " + io::quote(text), place);
  }
  return all;
}

io::JointValues Cell::state(const std::string& text, const std::string& place,
                            std::vector<std::string>& remarks) const {
  std::vector<std::string> texts;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find(',', begin), text.size());
    texts.emplace_back(io::trimmed(std::string_view(text).substr(begin, end - begin)));
    begin = end + 1;
  }
  const auto has = [](const io::Srdf& srdf, const std::string& name) {
    return std::any_of(srdf.states.begin(), srdf.states.end(), [&](const io::Srdf::State& state) {
      return name == state.name || name == state.group + "/" + state.name;
    });
  };
  io::JointValues all{io::one_line(text), {}};
  for (const auto& [of, names] : by_robot(texts, place, has)) {
    const CellRobot& robot = robots_[of[1]];
    const std::string joined = fmt::format("{}", fmt::join(names, ","));
    for (const auto& [name, value] : io::state_values(srdfs_[of[0]].srdf, robot.model, joined, place, remarks).values) {
      const auto joint = robot.first_joint + (named(name, robot.model.joints) - robot.model.joints.begin());
      all.values[robot_.joints[static_cast<std::size_t>(joint)].name] = value;
    }
  }
  return all;
}

void Cell::keep_groups(std::span<const std::string> names, const std::string& place,
                       std::vector<std::string>& remarks) {
  (void)robot(place);
  const auto has = [](const io::Srdf& srdf, const std::string& name) {
    return named(name, srdf.groups) != srdf.groups.end();
  };
  std::set<std::size_t> robots;
  std::set<std::uint32_t> links;  // that stay, of these robots
  for (const auto& [of, groups] : by_robot(names, place, has)) {
    const CellRobot& robot = robots_[of[1]];
    robots.insert(of[1]);
    for (const std::uint32_t link : io::group_links(srdfs_[of[0]].srdf, robot.model, groups, place, remarks)) {
      links.insert(robot.first_link + link);
    }
  }
  std::map<std::string, std::vector<io::LeftOut>> left_out;  // by file
  std::vector<std::uint32_t> numbers(bodies_.size());        // of the bodies that stay
  std::uint32_t kept = 0, kept_links = 0, all = 0;
  for (std::uint32_t b = 0; b < bodies_.size(); ++b) {
    CellBody& body = bodies_[b];
    if (body.link && robots.contains(robot_of_link_[*body.link])) {
      ++all;
      if (!links.contains(*body.link)) {
        left_out[files_[body.file].file].push_back({"shape", body.name, body.parts.size()});
        outside_.push_back(*body.link);
        continue;
      }
      ++kept_links;
    }
    numbers[b] = kept;
    if (kept != b) bodies_[kept] = std::move(body);
    ++kept;
  }
  if (kept_links == 0) fail_call("no link of the group has a shape, so there is nothing to ask about", place);
  bodies_.resize(kept);
  for (AllowedPair& pair : allowed_by_files_) {  // of bodies of scene files, which stay
    for (std::uint32_t& body : pair.bodies) body = numbers[body];
  }
  std::string of = robots_.size() == 1 ? "the robot" : "";
  for (const std::size_t r : robots) {
    if (robots_.size() > 1) of += (of.empty() ? "" : " and ") + robots_[r].name;
  }
  remarks.push_back(fmt::format("of {} {} of {} links with shapes are asked about, those of {} {}", of, kept_links, all,
                                place, fmt::join(names, ", ")));
  for (const auto& [file, what] : left_out) tell(file, what);
}

}  // namespace sunder::robot
