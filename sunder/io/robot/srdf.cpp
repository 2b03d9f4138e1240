#include <sunder/io/robot/srdf.h>
#include <sunder/io/text/file.h>
#include <sunder/io/text/text.h>
#include <sunder/io/text/xml_internal.h>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <optional>
#include <set>
#include <utility>

namespace sunder::io {

namespace {

constexpr XmlKind srdf_file{"robot", "SRDF", "an SRDF", "robot's SRDF"};

class SrdfParser {
 public:
  SrdfParser(std::string_view bytes, std::string_view place) : xml_(bytes, place, srdf_file) {}

  Srdf parse() {
    const XMLElement& robot = xml_.root();
    if (const char* name = robot.Attribute("name")) srdf_.name = one_line(name);
    if (const XMLElement* link = robot.FirstChildElement("link")) {
      if (link->FirstChildElement() != nullptr) {
        xml_.fail(*link, "this is a URDF, and an SRDF is expected; name it as a FILE");
      }
    }
    XmlFile::each_child(robot, [&](const XMLElement& child) {
      if (XmlFile::is(child, "disable_collisions")) read_pair(child);
      if (XmlFile::is(child, "group")) read_group(child);
      if (XmlFile::is(child, "group_state")) read_state(child);
    });
    return std::move(srdf_);
  }

 private:
  std::string there(const XMLElement& element, const char* attribute) const {
    std::string text = one_line(xml_.attribute(element, attribute));
    if (text.empty()) {
      xml_.fail(element, fmt::format("{}=\"\" of {} is empty; name one", attribute, XmlFile::tag(element)));
    }
    return text;
  }

  void read_pair(const XMLElement& element) {
    Srdf::Pair pair{{there(element, "link1"), there(element, "link2")}, ""};
    if (const char* reason = element.Attribute("reason")) pair.reason = one_line(reason);
    if (pair.links[0] == pair.links[1]) {
      xml_.fail(element, fmt::format("both links are {}; name two", quote(pair.links[0])));
    }
    srdf_.disabled.push_back(std::move(pair));
  }

  void read_group(const XMLElement& element) {
    Srdf::Group group{xml_.name_of(element), {}, {}, {}, {}};
    if (!groups_.insert(group.name).second) {
      xml_.fail(element, fmt::format("the group {} comes twice; rename one", quote(group.name)));
    }
    XmlFile::each_child(element, [&](const XMLElement& child) {
      if (XmlFile::is(child, "link")) group.links.push_back(xml_.name_of(child));
      if (XmlFile::is(child, "joint")) group.joints.push_back(xml_.name_of(child));
      if (XmlFile::is(child, "group")) group.groups.push_back(xml_.name_of(child));
      if (XmlFile::is(child, "chain")) group.chains.push_back({there(child, "base_link"), there(child, "tip_link")});
    });
    srdf_.groups.push_back(std::move(group));
  }

  void read_state(const XMLElement& element) {
    Srdf::State state{xml_.name_of(element), "", {}, {}};
    if (element.Attribute("group") != nullptr) state.group = there(element, "group");
    if (!known_.emplace(state.group, state.name).second) {
      xml_.fail(element,
                fmt::format("the state {} of group {} comes twice; rename one", quote(state.name), quote(state.group)));
    }
    XmlFile::each_child(element, [&](const XMLElement& joint) {
      if (!XmlFile::is(joint, "joint")) return;
      std::string name = xml_.name_of(joint);
      const std::vector<std::string_view> words = xml_words(xml_.attribute(joint, "value"));
      if (words.size() != 1) {
        state.other.push_back(std::move(name));
      } else if (!state.values.emplace(name, xml_.number(joint, "value", words[0])).second) {
        xml_.fail(joint, fmt::format("the joint {} comes twice in this state; remove one", quote(name)));
      }
    });
    srdf_.states.push_back(std::move(state));
  }

  XmlFile xml_;
  Srdf srdf_;
  std::set<std::pair<std::string, std::string>> known_;
  std::set<std::string> groups_;
};

std::string full_name(const Srdf::State& state) {
  return state.group.empty() ? state.name : state.group + "/" + state.name;
}

// "NAME" or "GROUP/NAME".
const Srdf::State& state_named(const Srdf& srdf, std::string_view text, const std::string& place) {
  const Srdf::State* found = nullptr;
  std::string names;
  for (const Srdf::State& state : srdf.states) {
    const std::string full = full_name(state);
    names += (names.empty() ? "" : ", ") + full;
    if (text == full) return state;
    if (text != state.name) continue;
    if (found != nullptr) {
      fail_call(fmt::format("several groups have a state {}; write {} or {}", quote(text), full_name(*found), full),
                place);
    }
    found = &state;
  }
  if (found == nullptr) {
    fail_call(fmt::format("there is no state {}; states are {}", quote(text), names.empty() ? "none" : names), place);
  }
  return *found;
}

template <class All>
auto named(const std::string& name, const All& all) {
  return std::find_if(all.begin(), all.end(), [&](const auto& one) { return one.name == name; });
}

// Which links groups have.
class Groups {
 public:
  Groups(const Srdf& srdf, const Robot& robot, const std::string& place) : srdf_(srdf), robot_(robot), place_(place) {}

  // Adds the links of the group.
  void add(const std::string& name, const std::string& within) {
    const auto group = named(name, srdf_.groups);
    if (group == srdf_.groups.end()) {
      fail_call(fmt::format("there is no group {}{}; groups are {}", quote(name),
                            within.empty() ? "" : fmt::format(", which {} has", quote(within)), all_names()),
                place_);
    }
    const auto number = static_cast<std::size_t>(group - srdf_.groups.begin());
    if (open_.contains(number)) fail_call(fmt::format("the group {} is within itself", quote(name)), place_);
    if (!done_.insert(number).second) return;
    open_.insert(number);
    for (const std::string& link : group->links) {
      if (const auto found = link_named(link)) links_.insert(*found);
    }
    for (const std::string& joint : group->joints) {
      // A planar or floating joint is a chain of joints (urdf.h): the last one counts.
      auto found = named(joint, robot_.joints);
      for (const char* last : {"/roll", "/yaw"}) {
        if (found == robot_.joints.end()) found = named(joint + last, robot_.joints);
      }
      if (found == robot_.joints.end()) {
        skipped_.push_back(joint);
      } else {
        links_.insert(found->child);
      }
    }
    for (const auto& [base, tip] : group->chains) add_chain(name, base, tip);
    for (const std::string& inner : group->groups) add(inner, name);
    open_.erase(number);
  }

  const std::set<std::uint32_t>& links() const { return links_; }
  const std::vector<std::string>& skipped() const { return skipped_; }

 private:
  std::optional<std::uint32_t> link_named(const std::string& name) {
    const auto found = named(name, robot_.links);
    if (found != robot_.links.end()) return static_cast<std::uint32_t>(found - robot_.links.begin());
    skipped_.push_back(name);
    return std::nullopt;
  }

  void add_chain(const std::string& group, const std::string& base, const std::string& tip) {
    const auto from = link_named(base), to = link_named(tip);
    if (!from || !to) return;
    std::uint32_t link = *to;
    links_.insert(link);
    while (link != *from) {
      const auto joint =
          std::find_if(robot_.joints.begin(), robot_.joints.end(), [&](const Joint& j) { return j.child == link; });
      if (joint == robot_.joints.end()) {
        fail_call(fmt::format("in group {} the link {} does not hang on {}", quote(group), quote(tip), quote(base)),
                  place_);
      }
      link = joint->parent;
      links_.insert(link);
    }
  }

  std::string all_names() const {
    std::string names;
    for (const Srdf::Group& group : srdf_.groups) names += (names.empty() ? "" : ", ") + group.name;
    return names.empty() ? "none" : names;
  }

  const Srdf& srdf_;
  const Robot& robot_;
  const std::string& place_;
  std::set<std::uint32_t> links_;
  std::set<std::size_t> open_, done_;  // groups
  std::vector<std::string> skipped_;
};

}  // namespace

std::vector<std::uint32_t> group_links(const Srdf& srdf, const Robot& robot, std::span<const std::string> names,
                                       const std::string& place, std::vector<std::string>& remarks) {
  std::set<std::uint32_t> all;
  for (const std::string& name : names) {
    Groups groups(srdf, robot, place);
    groups.add(name, "");
    if (groups.links().empty()) {
      fail_call(fmt::format("the group {} has no link of the robot; is the SRDF of another one?", quote(name)), place);
    }
    all.insert(groups.links().begin(), groups.links().end());
    if (!groups.skipped().empty()) {
      remarks.push_back(
          fmt::format("of group {} these are not in the robot: {}", name, fmt::join(groups.skipped(), ", ")));
    }
  }
  return {all.begin(), all.end()};
}

Srdf parse_srdf(std::string_view bytes, std::string_view place) { return SrdfParser(bytes, place).parse(); }

Srdf read_srdf(const std::filesystem::path& path, InputFiles* inputs) {
  return parse_srdf(read_file(path, inputs), path.string());
}

JointValues state_values(const Srdf& srdf, const Robot& robot, std::string_view text, const std::string& place,
                         std::vector<std::string>& remarks) {
  JointValues joints{one_line(text), {}};
  for (;;) {
    const std::size_t comma = std::min(text.find(','), text.size());
    const Srdf::State& state = state_named(srdf, trimmed(text.substr(0, comma)), place);
    std::vector<std::string> skipped = state.other;
    for (const auto& [name, value] : state.values) {
      const auto joint =
          std::find_if(robot.joints.begin(), robot.joints.end(), [&](const Joint& j) { return j.name == name; });
      if (joint == robot.joints.end() || joint->type == JointType::fixed || joint->mimic) {
        skipped.push_back(name);
        continue;
      }
      const auto [known, is_new] = joints.values.emplace(name, value);
      if (!is_new && known->second != value) {
        fail_call(fmt::format("two of these states give joint {} different values", quote(name)), place);
      }
    }
    if (skipped.size() == state.values.size() + state.other.size()) {
      fail_call(fmt::format("the state {} moves no joint of the robot; is the SRDF of another one?", quote(state.name)),
                place);
    }
    if (!skipped.empty()) {
      std::string list;
      for (const std::string& name : skipped) list += (list.empty() ? "" : ", ") + name;
      remarks.push_back(
          fmt::format("of state {} these joints are not moved by it (they are not in the robot, are fixed, follow "
                      "others, or have several numbers): {}",
                      full_name(state), list));
    }
    if (comma == text.size()) return joints;
    text.remove_prefix(comma + 1);
  }
}

std::string reasons_text(std::span<const Srdf::Pair> pairs) {
  std::map<std::string, std::uint64_t> counts;
  for (const Srdf::Pair& pair : pairs) ++counts[pair.reason.empty() ? "without a reason" : pair.reason];
  std::vector<std::pair<std::uint64_t, std::string>> sorted;
  for (const auto& [reason, count] : counts) sorted.emplace_back(count, reason);
  std::sort(sorted.begin(), sorted.end(),
            [](const auto& a, const auto& b) { return a.first != b.first ? a.first > b.first : a.second < b.second; });
  std::string text = count_of(pairs.size(), "pair");
  for (std::size_t i = 0; i < sorted.size(); ++i) {
    text += fmt::format("{}{} {}", i == 0 ? ": " : ", ", sorted[i].first, sorted[i].second);
  }
  return text;
}

}  // namespace sunder::io
