// Wavefront OBJ.
#pragma once

#include <sunder/io/mesh.h>

namespace sunder::io {

// Read: "v x y z" (a weight, or a colour with or without its opacity, may follow and is left out), "f" with corners v,
// v/vt, v//vn and v/vt/vn, numbered from 1, or from -1 backwards; "o NAME" begins a part. A corner may name a vertex
// that comes later in the file. Comments, and lines continued by a backslash.
// No part of a mesh, and not told: texture coordinates, normals, groups, materials. Told in left_out, where there are
// faces: points, lines.
// Refused: free-form curves and surfaces, any other statement, a face with fewer than 3 corners.
// Errors: see read_mesh. Cost: linear.
Mesh parse_obj(std::string_view bytes, std::string_view place);

}  // namespace sunder::io
