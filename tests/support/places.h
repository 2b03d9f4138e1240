// Where tests find their files. The only code that knows the names of folders: all else compiles alike in every clone.
#pragma once

#include <filesystem>
#include <string>

namespace sunder::tests {

std::string cases_folder();   // cases/, without a slash at the end
std::string source_folder();  // the folder of the whole project
std::string python();         // the interpreter

inline const std::filesystem::path cases = cases_folder();

}  // namespace sunder::tests
