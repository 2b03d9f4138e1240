// Circles out of a file, for verbs.
#pragma once

#include <sunder/io/triples.h>
#include <sunder/planar/object/circle.h>

#include <string>

namespace sunder::cli {

struct CirclesInput {
  io::TripleFile file;
  planar::Circles circles;
};

// Throws Error bad_file with the line, also for a negative radius.
CirclesInput read_circles(const std::string& name);

}  // namespace sunder::cli
