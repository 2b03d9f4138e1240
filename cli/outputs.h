// What a call writes is none of what it reads, and is written once.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace CLI {  // NOLINT(readability-identifier-naming): of CLI11
class App;
}

namespace sunder::cli {

// A file as the call names it: the option and the path.
struct NamedFile {
  std::string option;
  std::filesystem::path path;
};

// Throws Error bad_call where an output has no name, or is the same file as an input or an output before it: by another
// spelling, a symbolic or a hard link. Devices and pipes are no files. Nothing is read or written.
void require_apart(const std::vector<NamedFile>& inputs, const std::vector<NamedFile>& outputs);

// The same for the options of a verb, after they are parsed: outputs are --certificate, --csv, --geojson, --svg and --out,
// and standard output where it is a file; inputs are what stands without an option, and the values of other options,
// but for those that are words (--title).
void require_apart(const CLI::App& verb);

// Does an option ask for an output on standard output, as "-"? Throws Error bad_call where two do, where a report in
// JSON goes there, too, and where such a report is asked for and --quiet.
bool takes_standard_output(const CLI::App& verb);

}  // namespace sunder::cli
