// The files that a call names, by the options of its verb.
#pragma once

#include <span>
#include <string>

namespace CLI {  // NOLINT(readability-identifier-naming): of CLI11
class App;
}

namespace sunder::cli {

// ask::require_apart for the options of a verb, after they are parsed: outputs are --certificate, --csv, --geojson,
// --svg and --out; inputs are what stands without an option, the values of other options that take a FILE, and those of
// --allow. Throws also where standard input is named twice.
void require_apart(const CLI::App& verb);

// Does an option ask for an output on standard output, as "-"? Throws Error bad_call where two do, where a report in
// JSON goes there, too, and where such a report is asked for and --quiet.
bool takes_standard_output(const CLI::App& verb);

// Is standard output a file that one of the words names, and that is no output? For a call that is not understood.
bool prints_over_input(std::span<const std::string> words);

}  // namespace sunder::cli
