// What somebody says that entries are, in words: nothing of it is proved (docs/claims.md, "Said").
// Words are those of the twin (verifier/python/sunder_verify/said.py). What is not as it must be is refused by rule F.
#pragma once

#include <verifier/cpp/json.h>

#include <cstddef>
#include <string>
#include <vector>

namespace sunder_verifier {

using InputNames = std::vector<std::string>;

// What entries are made of, then what has become of that, from the first step to the last.
std::string read_description(const Json& value, const InputNames& inputs, const std::string& where);

// `said` of a statement that leaves out so many pairs: "; .." of each.
std::string read_notes(const Json& list, const InputNames& inputs, std::size_t pairs_left_out,
                       const std::string& where);

// `said` of a table of so many rows: how many of them are made of what. "; these are said to be made of ..".
std::string read_said_of_rows(const Json& list, const InputNames& inputs, std::size_t size, const std::string& where);

}  // namespace sunder_verifier
