// What sunder info tells of a file of the plane.
#pragma once

#include <sunder/ask/report.h>

#include <string>
#include <string_view>

namespace sunder::ask {

struct Info {
  std::string text;
  Json json;
};

// Has the file an ending of a format of the plane, read or not?
bool is_of_the_plane(const std::string& file);

// How much of what there is in the text of the file, in which box, and which verbs ask about it. Throws Error bad_file
// where that cannot be read, with the way out.
Info describe_planar(const std::string& file, std::string_view text);

}  // namespace sunder::ask
