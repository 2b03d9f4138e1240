// The options that the benchmarks of segments and of polygons share.
#pragma once

#include <algorithm>
#include <cstdint>
#include <string>

#include "report.h"

namespace bench {

// "100,1000": numbers of at least `least`.
template <class Sizes>
bool parse_sizes(const std::string& text, std::uint64_t least, Sizes& sizes) {
  for (std::size_t from = 0; from <= text.size();) {
    const std::size_t comma = std::min(text.find(',', from), text.size());
    std::uint64_t number = 0;
    if (!parse_number(text.substr(from, comma - from), least, number)) return false;
    sizes.push_back(number);
    from = comma + 1;
  }
  return true;
}

// Reads the command line. more(name, value): takes an option of one's own, or 1 where there is none, 2 where the value
// is wrong. Returns what is wrong with the call; empty: nothing.
template <class Options, class More>
std::string read_options(int argc, char** argv, std::uint64_t least_size, Options& options, bool& quick,
                         const More& more) {
  for (int i = 1; i < argc; ++i) {
    const std::string name = argv[i];
    if (name == "--check" || name == "--quick" || name == "--ways") {
      (name == "--check" ? options.check : name == "--quick" ? quick : options.ways) = true;
      continue;
    }
    if (i + 1 == argc) return "unknown option, or value missing: " + name;
    const std::string value = argv[++i];
    std::uint64_t number = 0;
    int wrong = 0;
    if (name == "--json") {
      options.json = value;
    } else if (name == "--commit") {
      options.commit = value;
    } else if (name == "--rounds") {
      wrong = parse_number(value, 1, number) ? 0 : 2;
      if (wrong == 0) options.rounds = number;
    } else if (name == "--seed") {
      wrong = parse_number(value, 0, options.seed) ? 0 : 2;
    } else if (name == "--sizes") {
      wrong = parse_sizes(value, least_size, options.sizes) ? 0 : 2;
    } else {
      wrong = more(name, value);
    }
    if (wrong == 1) return "unknown option: " + name;
    if (wrong == 2) return name + ": bad value: " + value;
  }
  if (quick) options.rounds = std::min<std::size_t>(options.rounds, 5);
  return "";
}

}  // namespace bench
