// What a proof says that its tables are made of (certificate/said.h), of files that were read. Where no proof is
// written files are not told (InputFiles is empty), and nothing is said.
#pragma once

#include <sunder/certificate/origin.h>
#include <sunder/certificate/said.h>
#include <sunder/io/mesh/mesh_body.h>
#include <sunder/io/plane/coordinate_system.h>
#include <sunder/io/text/left_out.h>

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace sunder::ask {

// All of a file, which is named as it was given, or as it is shown to people; or of the part of this name.
Said said_of_file(Said::Source what, const InputFiles& inputs, const std::string& file, const std::string& part = "",
                  const std::vector<std::string>& without = {});

// What of its file a body is without: what was left out, and unused vertices.
std::vector<std::string> missing_of(const io::MeshBody& body, const io::LeftOutList& left_out);

// The vertices of a mesh, or of an object of it, as a hull where it is not convex; a set of points. `left_out` has what
// of its file was left out.
Said said_of_mesh(const io::MeshBody& body, const InputFiles& inputs, const io::LeftOutList& left_out);
// Its triangles, as they are; of a set of points the same as above.
Said said_of_triangles(const io::MeshBody& body, const InputFiles& inputs, const io::LeftOutList& left_out);

// The same in the coordinate systems that its file declares; unchanged where nothing is said, or none is declared.
Said said_in(std::span<const io::SystemOfFile> systems, Said said);

// What a proof says of a table whose rows come from one file. Empty where the table has no rows, or `said` is empty.
std::vector<SaidOfRows> said_of_rows(const char* table, std::uint64_t rows, const Said& said);

}  // namespace sunder::ask
