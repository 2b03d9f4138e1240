// What a shell and a reader of manuals want to know of the program, made from its verbs and their options.
#pragma once

#include <string>
#include <string_view>

namespace CLI {  // NOLINT(readability-identifier-naming): of CLI11
class App;
}

namespace sunder::cli {

// The text of `sunder help`, or of `sunder help VERB` for the App of a verb: lines of at most 100 characters.
std::string help_text(const CLI::App& app);

// A script that completes verbs, options and names of files: of bash, zsh or fish.
// Throws Error bad_call for another shell.
std::string completion(const CLI::App& program, std::string_view shell);

// The manual page sunder(1), as man and groff read it.
std::string man_page(const CLI::App& program, std::string_view version);

}  // namespace sunder::cli
