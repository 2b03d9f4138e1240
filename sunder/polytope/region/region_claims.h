// Writes what is proved of half-spaces into a certificate file (docs/claims.md): a table `polytopes` of one entry, and
// a statement `half_spaces`, `half_spaces_vertices` or `half_spaces_program` about it. Also called: proof logging.
// Throws only std::bad_alloc, what the writer's sink throws, and of no half-spaces as require_entries(). Cost: linear.
#pragma once

#include <sunder/certificate/claims.h>
#include <sunder/polytope/region/half_space_region.h>
#include <sunder/polytope/region/linear_program.h>
#include <sunder/polytope/region/region_vertices.h>

#include <span>
#include <string>

namespace sunder::polytope {

// All of a file but its origin and its end. Requires the answer to be about these. name: of the half-spaces; empty:
// "unnamed".
void add_claims(ClaimsWriter& file, const std::string& name, const Polytope& half_spaces,
                const HalfSpaceRegion& region);
void add_claims(ClaimsWriter& file, const std::string& name, const Polytope& half_spaces,
                std::span<const double> objective, const LinearProgramAnswer& answer);
// Of bounded ones their vertices; else what the region is.
void add_claims(ClaimsWriter& file, const std::string& name, const Polytope& half_spaces, const RegionVertices& answer);

}  // namespace sunder::polytope
