// Bodies out of mesh files, in the words and reports of the verbs.
#pragma once

#include <sunder/ask/report.h>

#include <sunder/io/mesh/mesh_body.h>

#include <string>
#include <vector>

namespace sunder::ask {

using io::MeshBody;

// By how much the mesh departs from its hull: "deepest edge about 0.5 below the hull, ...". Empty where not known.
std::string departure_text(const MeshBody& object);

// Notes what the readers of the files remark, each once.
void note_remarks(Talk& talk, const std::vector<const MeshBody*>& objects);

// Notes that, and of which meshes the hulls are used: one line, however many there are.
void note_hulls(Talk& talk, const std::vector<const MeshBody*>& objects);

// Is the mesh closed, and if so, how? A word or two, then lines about what is out of the ordinary.
struct SurfaceTold {
  Json json;
  std::vector<std::string> lines;
};
SurfaceTold surface_told(const solid::Mesh& mesh);

// "body", "polygon", "segment", "point".
const char* dimension_name(int dimension);

Json to_json(const MeshBody& object);

}  // namespace sunder::ask
