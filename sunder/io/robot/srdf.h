// What goes with a robot (SRDF): pairs of links whose collisions are not asked about, and named values of joints.
#pragma once

#include <sunder/base/error.h>
#include <sunder/certificate/origin.h>
#include <sunder/io/robot/joint_values.h>
#include <sunder/io/robot/urdf.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace sunder::io {

// What read_srdf returns has these properties:
// S1. Every name is one line of UTF-8 and, but for those of the robot, of reasons and of a state's group, not empty.
// S2. The links of a pair differ. A pair may come twice, in either order, and links need not be in any robot.
// S3. No two states of one group have the same name. Values are finite.
// S4. No two groups have the same name. What they name need not be in any robot, nor subgroups in the file.
struct Srdf {
  struct Pair {
    std::array<std::string, 2> links;
    std::string reason;  // "Adjacent", "Never", ...; empty where the file says none
  };
  struct State {
    std::string name, group;
    std::map<std::string, double> values;  // of joints with one number
    std::vector<std::string> other;        // joints with none or several numbers, which are not taken
  };

  struct Group {
    std::string name;
    std::vector<std::string> links, joints, groups;  // of the robot; other groups of the file
    std::vector<std::array<std::string, 2>> chains;  // from a base link to a tip link
  };

  std::string name;
  std::vector<Pair> disabled;
  std::vector<Group> groups;  // in the order of the file
  std::vector<State> states;
};

// Reads <disable_collisions>, <group>, <group_state>. No part of any question here: <end_effector>,
// <virtual_joint>, <passive_joint>, and what other programs put there.
// Throws Error bad_file, "FILE:LINE: what is wrong; remedy". inputs: as of read_file (file.h).
Srdf read_srdf(const std::filesystem::path& path, InputFiles* inputs = nullptr);

// As read_srdf, from memory. place: the file's name for messages.
Srdf parse_srdf(std::string_view bytes, std::string_view place);

// The values of one state, or of several: "NAME" or "GROUP/NAME", with commas between them. Of joints that are not in
// the robot, are fixed, follow others, or have several numbers, the values are not taken: `remarks` gets a line about
// each state that has some. place: for messages, such as "--state".
// Throws Error bad_call: there is no such state, several groups have one, it moves no joint of the robot, or two states
// give a joint different values.
JointValues state_values(const Srdf& srdf, const Robot& robot, std::string_view text, const std::string& place,
                         std::vector<std::string>& remarks);

// The numbers of the links that these groups have, each once, ascending: those that are named, the child of each joint,
// the links of each chain, from base to tip and both of them, and what subgroups have. What the robot does not have is
// not taken: `remarks` gets a line about each group that names some. place: for messages, such as "--group".
// Throws Error bad_call: there is no such group, or subgroup; a group is within itself; none of its links is in the
// robot; the tip of a chain does not hang on its base.
std::vector<std::uint32_t> group_links(const Srdf& srdf, const Robot& robot, std::span<const std::string> names,
                                       const std::string& place, std::vector<std::string>& remarks);

// The pairs by reason, for people: "45 pairs: 32 Never, 13 Adjacent", most frequent first.
std::string reasons_text(std::span<const Srdf::Pair> pairs);

}  // namespace sunder::io
