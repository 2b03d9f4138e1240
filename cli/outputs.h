// What a call writes is none of what it reads, and is written once.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace CLI {  // NOLINT(readability-identifier-naming): of CLI11
class App;
}

namespace sunder::cli {

// A file as the call names it: the option and the path. "-" is standard input, or standard output.
struct NamedFile {
  std::string option;
  std::filesystem::path path;
};

// Throws Error bad_call where an output has no name, or is the same file as an input or an output before it: by another
// spelling, a symbolic or a hard link, the name of an open stream. Standard output is an output too, unless the call is
// quiet. Pipes and devices are files here, but for /dev/null, and a terminal that is read and written. Nothing is read
// or written; where standard output is an input, nothing is printed there any more.
void require_apart(const std::vector<NamedFile>& inputs, std::vector<NamedFile> outputs);

// The same for the options of a verb, after they are parsed: outputs are --certificate, --csv, --geojson, --svg and
// --out; inputs are what stands without an option, the values of other options that take a FILE, and those of --allow.
// Throws also where standard input is named twice.
void require_apart(const CLI::App& verb);

// Does an option ask for an output on standard output, as "-"? Throws Error bad_call where two do, where a report in
// JSON goes there, too, and where such a report is asked for and --quiet.
bool takes_standard_output(const CLI::App& verb);

// Is standard output a file that one of the words names, and that is no output? For a call that is not understood.
bool prints_over_input(std::span<const std::string> words);

}  // namespace sunder::cli
