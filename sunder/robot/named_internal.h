// What has a name, found by it, and told by it: for this folder alone.
#pragma once

#include <sunder/base/error.h>
#include <sunder/io/robot/joint_values.h>
#include <sunder/io/text/text.h>

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace sunder::robot {

[[noreturn]] inline void fail_call(const std::string& text, const std::string& place) {
  throw Error(ErrorCode::bad_call, text, place);
}

template <class Named>  // std::vector of what has a name
std::string names_of(const Named& all) {
  std::string names;
  for (const auto& each : all) names += (names.empty() ? "" : ", ") + each.name;
  return names;
}

template <class Named>
auto named(const std::string& name, Named& all) {
  return std::find_if(all.begin(), all.end(), [&](const auto& each) { return each.name == name; });
}

// There is none of this name; several robots may have one.
template <class Named>
[[noreturn]] void fail_unknown(const char* what, const std::string& name, const Named& all, const std::string& place) {
  std::vector<std::string> names;
  for (const auto& each : all) names.push_back(each.name);
  const std::string longer = io::longer_names(name, names);
  if (!longer.empty())
    fail_call(fmt::format("no {} is named {}, but {}; give one of these", what, io::quote(name), longer), place);
  fail_call(fmt::format("no {} is named {}; {} are {}", what, io::quote(name),
                        what == std::string_view("body") ? "bodies" : what + std::string("s"), names_of(all)),
            place);
}

inline void add_once(const std::string& name, std::vector<std::string>& names) {
  if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
}

// The first few, and how many more.
inline std::string listed(const std::vector<std::string>& names) {
  constexpr std::size_t most = 5;
  std::string list;
  for (std::size_t i = 0; i < std::min(names.size(), most); ++i) list += (i == 0 ? "" : ", ") + names[i];
  return names.size() > most ? fmt::format("{} and {} more", list, names.size() - most) : list;
}

}  // namespace sunder::robot
