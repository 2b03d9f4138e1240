// sunder hull of points or half-spaces of two to six dimensions, out of CSV or NPY.
#pragma once

#include <sunder/ask/report.h>
#include <sunder/certificate/origin.h>
#include <sunder/polytope/object/polytope.h>

#include <string>

namespace sunder::ask {

// What `sunder hull` was asked.
struct HullCall {
  std::string file, out, certificate;
  bool leave_out = false, half_spaces = false;
  bool json = false;
};

// Answers. Throws Error for bad input, and for options that are not for polytopes.
Report run_polytope_hull(const HullCall& call, Talk& talk);

// The same of half-spaces that have been read: the vertices of what they have in common.
Report run_half_space_hull(const HullCall& call, Talk& talk, const polytope::Polytope& half_spaces,
                           const InputFiles& inputs);

// "polygon", "polytope"; and what the report says of the file.
const char* name_of_hull(std::size_t dimension);
Json object_of(const HullCall& call, const polytope::Polytope& polytope);

// Tells of the files that are written, last of all. out: empty where none is.
void add_files(const HullCall& call, const std::string& out, Report& report);

}  // namespace sunder::ask
