// Tables and statements about half-planes in certificate files (docs/certificates-sets.md). Each appends to a text.
#pragma once

#include <sunder/planar/region/region.h>

#include <string>

namespace sunder::planar {

// The table, with its key.
void append_half_planes(std::string& text, const Constraints& given);
void append_half_planes(std::string& text, const HalfPlanes& given);

// The verdict, the sides, and what proves them, where the region is not empty; each with its key.
void append_region(std::string& text, const Region& region);

}  // namespace sunder::planar
