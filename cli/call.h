// A call of a verb: what is wrong with its words, before they are parsed, in our own words; and the files that it
// names.
#pragma once

#include <span>
#include <string>
#include <vector>

namespace CLI {  // NOLINT(readability-identifier-naming): of CLI11
class App;
class Option;
}  // namespace CLI

namespace sunder::ask {
class Talk;
}

namespace sunder::cli {

std::vector<const CLI::App*> verbs_of(const CLI::App& program);
bool takes_value(const CLI::Option& option);

// All long names of options, with their dashes.
std::vector<std::string> names_of_options(const CLI::App& app);

// The first option that the verb does not have (with the one that was meant), that lacks its value, has one that is
// empty (but for a title, and for outputs), has one and takes none, or is given twice and may be once. Empty: none; or
// help is asked for.
std::string option_problem(const CLI::App& verb, std::span<const std::string> words);

// Is a report in JSON asked for? What is the value of another option asks for nothing.
bool asks_for_json(const CLI::App& verb, std::span<const std::string> words);

// ask::require_apart for the options of a verb, after they are parsed: outputs are --certificate, --csv, --geojson,
// --svg, --gltf, --out, --json-lines and --meeting-certificate; inputs are what stands without an option, the values of
// other options that take a FILE, and those of --allow. Throws also where standard input is named twice.
void require_apart(const CLI::App& verb, ask::Talk& talk);

// Does an option ask for an output on standard output, as "-"? Throws Error bad_call where two do, where a report in
// JSON goes there, too, and where such a report is asked for and --quiet. Where the talk has another place for "-", no
// option does.
bool takes_standard_output(const CLI::App& verb, const ask::Talk& talk);

// Is standard output a file that one of the words names, and that is no output? For a call that is not understood.
bool prints_over_input(std::span<const std::string> words);

}  // namespace sunder::cli
