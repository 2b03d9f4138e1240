// What sunder region was asked, for its kinds of objects.
#pragma once

#include <string>

namespace sunder::cli {

struct RegionCall {
  std::string file;
  std::string of = "half-planes";
  std::string maximize;
  std::string method = "automatic";
  std::string certificate, svg, title;
  bool mend = false, drop_z = false, leave_out = false, skip_invalid = false;  // of polygons
  std::string name{};                                                          // of polygons: the field that names them
  bool json = false;
};

}  // namespace sunder::cli
