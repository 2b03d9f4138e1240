// Which Sunder this is. The build reads it from here.
#pragma once

#include <string_view>

#define SUNDER_VERSION_MAJOR 0
#define SUNDER_VERSION_MINOR 1
#define SUNDER_VERSION_PATCH 0

namespace sunder {

inline constexpr std::string_view version = "0.1.0";

}  // namespace sunder
