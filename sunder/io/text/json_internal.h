// JSON text as a tree, for readers of small files.
#pragma once

#include <sunder/base/error.h>

#include <nlohmann/json.hpp>

#include <cstdint>
#include <string_view>

namespace sunder::io {

// Throws Error bad_file, with the line, for what is not JSON, for a number beyond the doubles, and for an object with a
// key twice. Numbers are the doubles nearest to those in the text. line: of the file, where the text is one of its
// lines; else 0.
nlohmann::json parse_json(std::string_view text, std::string_view place, std::uint32_t line = 0);

}  // namespace sunder::io
