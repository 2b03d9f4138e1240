// Parts of meshes, which rules about them cut and part: docs/claims.md, "Meshes".
#pragma once

#include <verifier/cpp/tables.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace sunder_verifier {

// Triangles that follow each other.
struct Part {
  std::size_t first, end;

  friend bool operator==(const Part&, const Part&) = default;
};

// How far the corners of a part reach along a direction, from the least to the greatest, as integers * 2^e.
struct Extent {
  Integer least, greatest;
  std::int64_t e;
};

// Takes the steps.
Extent extent(const MeshBody& mesh, Integers direction, const Part& part);

bool have_area(const MeshTriangle& triangle, const std::vector<Integers>& rows);

}  // namespace sunder_verifier
