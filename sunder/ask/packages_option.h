// The option --package: where the meshes of robots are.
#pragma once

#include <sunder/ask/talk.h>
#include <sunder/ask/verb.h>

#include <sunder/base/error.h>
#include <sunder/io/robot/packages.h>

#include <string>
#include <vector>

namespace sunder::ask {

Option package_option(std::vector<std::string>& named);

// The packages that the option's values name, and those in the folders that the caller searches. Throws Error as io::parse_packages does.
io::Packages packages_of(const Talk& talk, const std::vector<std::string>& named);

}  // namespace sunder::ask
