// PLY (Stanford polygon format), ASCII and binary of both byte orders.
#pragma once

#include <sunder/io/mesh.h>

namespace sunder::io {

// Read: the properties x, y, z of the element "vertex", of any plain type; the list "vertex_indices" or "vertex_index"
// of the element "face", of any integer type. Type names of both generations (float, float32, ...). No part of a mesh,
// and not told: all other properties, plain or lists, comments, the elements "camera", "material", "texture". Other
// elements are told in left_out. In ASCII files each row stands on its own line. Without faces the mesh is a set of
// points. Refused: faces without that list, a face with fewer than 3 corners, anything after the last row. Errors: see
// read_mesh. Cost: linear.
Mesh parse_ply(std::string_view bytes, std::string_view place);

}  // namespace sunder::io
