// What sunder region was asked, for its kinds of objects.
#pragma once

#include <sunder/ask/list_stream.h>

#include <cstdint>
#include <string>

namespace sunder::ask {

struct RegionCall {
  std::string file;
  std::string of = "half-planes";
  std::string maximize;
  std::string method = "automatic";
  std::string certificate, svg, title;
  std::uint64_t svg_limit = most_drawn;  // half-planes, circles, edges of polygons
  bool mend = false, drop_z = false, leave_out = false, skip_invalid = false;  // of polygons
  std::string name{};                                                          // of polygons: the field that names them
  bool json = false;
};

}  // namespace sunder::ask
