#include <sunder/base/names.h>
#include <sunder/near/set_question.h>

#include <algorithm>
#include <string>

namespace sunder {

std::string_view name_of(Allowed allowed) {
  return name_in<Allowed::touch>({"nothing", "shared-endpoint", "touch"}, allowed);
}

void check_groups(Groups groups, std::size_t members) {
  if (groups.empty() || groups.size() == members) return;
  throw Error(ErrorCode::bad_call,
              std::to_string(groups.size()) + " groups of " + std::to_string(members) +
                  " members; give a group for each, or none",
              "groups");
}

bool are_one_group(Groups groups) {
  return !groups.empty() && std::all_of(groups.begin(), groups.end(), [&](std::uint32_t g) { return g == groups[0]; });
}

}  // namespace sunder
