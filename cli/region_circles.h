// sunder region --of circles: what is the common part of circles, with their insides?
#pragma once

#include <string>

namespace sunder::cli {

struct RegionCirclesCall {
  std::string file;
  std::string method = "automatic";
  std::string certificate, svg, title;
  bool json = false;
};

// Prints the answer; returns the exit code. Throws Error for bad input.
int run_region_circles(const RegionCirclesCall& call);

}  // namespace sunder::cli
