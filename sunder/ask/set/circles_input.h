// Discs out of a file, for verbs.
#pragma once

#include <sunder/io/triples.h>
#include <sunder/planar/object/discs.h>

#include <string>

namespace sunder::ask {

struct DiscsInput {
  io::TripleFile file;
  planar::Discs circles;
};

// group, name_field: the columns to group by and to name by, if not empty.
// inputs: as of io::read_file. Throws Error bad_file with the line, also for a negative radius; bad_call where there is
// no such column.
DiscsInput read_circles(const std::string& name, const std::string& group = {}, const std::string& name_field = {},
                        InputFiles* inputs = nullptr);

}  // namespace sunder::ask
