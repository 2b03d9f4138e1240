// STL, ASCII and binary.
#pragma once

#include <sunder/io/mesh.h>

namespace sunder::io {

// True when the size is exactly that of the binary STL which the bytes 80 to 83 promise: 84 + 50 times the number of
// triangles, which is not zero. It may begin with "solid" all the same.
bool is_binary_stl(std::string_view bytes);

// ASCII: any number of solids, each a part; keywords in any case, words parted by any blanks and line breaks; numbers
// in full double precision. Binary: single precision, exactly as stored; the size must match the count.
// Equal points become one vertex. Left out: normals (which may be NaN), and the attribute bytes of a binary triangle.
// Errors: see read_mesh; a file without a triangle is refused. Cost: n log n.
Mesh parse_stl(std::string_view bytes, std::string_view place);

}  // namespace sunder::io
