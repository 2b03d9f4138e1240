// sunder hull of points of two to six dimensions, out of CSV.
#pragma once

#include <string>

namespace sunder::ask {

// What `sunder hull` was asked.
struct HullCall {
  std::string file, out, certificate;
  bool leave_out = false;
  bool json = false;
};

// Answers; returns the exit code. Throws Error for bad input, and for options that are not for polytopes.
int run_polytope_hull(const HullCall& call);

}  // namespace sunder::ask
