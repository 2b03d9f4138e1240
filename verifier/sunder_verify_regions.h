// Checks statements about the common part of half-planes (docs/certificates-sets.md): the twin of
// sunder_verify_regions.py.
#pragma once

#include "half_plane.h"
#include "statement.h"

#include <memory>
#include <string>
#include <vector>

namespace sunder_verifier {

using HalfPlanes = std::shared_ptr<const std::vector<HalfPlane>>;

// A statement that the common part of half-planes is of some kind. `about` and `rule` are its names.
Statement read_region(const json& item, const HalfPlanes& given, const std::string& about, const std::string& rule,
                      const std::string& where);

// S1, S2: two or three half-planes have no common point.
void check_contradict(const std::vector<HalfPlane>& given, const std::vector<std::size_t>& sides);

// Adds the questions about the tables of half-planes and of rings, if the file has them. Throws Refused where its form
// is wrong.
void add_region_questions(const json& top, Questions& questions);

}  // namespace sunder_verifier
