// What people write about a robot: the values of its joints, and pairs of names.
#pragma once

#include <sunder/base/error.h>
#include <sunder/certificate/origin.h>

#include <array>
#include <cstddef>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace sunder::io {

struct JointValues {
  std::string name;  // for people; empty where there is none
  std::map<std::string, double> values;
};

// "name=value,..." or "LABEL:name=value,...". Throws Error bad_call, with `place`.
JointValues parse_joint_values(std::string_view text, const std::string& place);

// A file with one joint a line, "name value" or "name=value"; '#' starts a comment. Its name is that of the values.
// inputs: as of read_file. Throws Error.
JointValues read_joint_values(const std::string& file, InputFiles* inputs = nullptr);

// A file with two names a line, with blanks or a comma between them; '#' starts a comment. Each with its place,
// "FILE:7". inputs: as of read_file. Throws Error.
std::vector<std::pair<std::string, std::array<std::string, 2>>> read_name_pairs(const std::string& file,
                                                                                InputFiles* inputs = nullptr);

// The names that end in "/name", where there are several, as of several robots: "left/base and right/base"; else nothing.
std::string longer_names(const std::string& name, std::span<const std::string> names);

}  // namespace sunder::io
