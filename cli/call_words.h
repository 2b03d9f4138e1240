// The words of a call of a verb, before they are parsed: what is wrong with its options, in our own words.
#pragma once

#include <span>
#include <string>
#include <vector>

namespace CLI {  // NOLINT(readability-identifier-naming): of CLI11
class App;
}

namespace sunder::cli {

// All long names of options, with their dashes.
std::vector<std::string> names_of_options(const CLI::App& app);

// The first option that the verb does not have (with the one that was meant), that lacks its value, has one and takes
// none, or is given twice and may be once. Empty: none; or help is asked for.
std::string option_problem(const CLI::App& verb, std::span<const std::string> words);

// Is a report in JSON asked for? What is the value of another option asks for nothing.
bool asks_for_json(const CLI::App& verb, std::span<const std::string> words);

}  // namespace sunder::cli
