// OFF, the text format of Geomview.
#pragma once

#include <sunder/io/mesh.h>

namespace sunder::io {

// OFF with any of the prefixes ST, C, N, 4, n, in this order.
bool is_off_header(std::string_view word);

// Read: the header, the counts of vertices, faces and (left out) edges on its line or the next, then one vertex and one
// face per line. After x y z, normals, colours and texture coordinates may follow where the header announces them
// (NOFF, COFF, STOFF); after a face, a colour. They are left out. Comments from '#'.
// Refused: binary OFF, points of four or n dimensions, a face with fewer than 3 corners, lines beyond the counts.
// Errors: see read_mesh. Cost: linear.
Mesh parse_off(std::string_view bytes, std::string_view place);

}  // namespace sunder::io
