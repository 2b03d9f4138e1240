// What is wrong with a polygon, in words.
#pragma once

#include <sunder/planar/set/polygon_valid.h>

#include <string>

namespace sunder::ask {

// "ring 0 crosses itself at about (2, 2): edges 0 and 2". has_parts: rings are named with their parts.
std::string text_of(const planar::PolygonDefect& defect, bool has_parts);

}  // namespace sunder::ask
