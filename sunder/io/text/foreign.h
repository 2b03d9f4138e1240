// Files of formats that are not read, by their first bytes, with the way out. For readers.
#pragma once

#include <sunder/base/error.h>

#include <string>
#include <string_view>

namespace sunder::io {

// Throws Error bad_file that names the format and the remedy, where the bytes begin as a format does that people take
// for one of the plane (GIS, CAD, boards, chips), or for text; also where they are a mesh, UTF-16 or UTF-32.
// place: the file's name.
void refuse_foreign(std::string_view bytes, std::string_view place);

// Is this a geometry as PostGIS shows it: WKB or EWKB in hexadecimal digits?
bool is_hexadecimal_wkb(std::string_view word);

// What the bytes are, for people: "a PNG image"; empty where nothing is known. For meshes and files of the plane alike.
std::string_view foreign_format(std::string_view bytes);

// Do they begin as a ZIP archive does? Packages of several formats are such: 3MF, USDZ, KMZ, those of offices.
inline bool is_zip(std::string_view bytes) { return bytes.starts_with("PK\x03\x04"); }

// Text of robots, worlds and scenes that people give where a body is expected, and the way out; {} is the file.
// `what` is empty where nothing is known.
struct ForeignBody {
  std::string_view what, way;
};
ForeignBody foreign_body(std::string_view bytes);

// "this is SDF (..), which is not read; convert it ..". Requires that something is known.
std::string foreign_text(const ForeignBody& body, std::string_view place);

}  // namespace sunder::io
