// The option --memory: how much memory a question about meshes may take.
#pragma once

#include <sunder/ask/verb.h>

#include <sunder/io/mesh/mesh_memory.h>

#include <cstdint>

namespace sunder::ask {

// Bytes for each triangle of the meshes that are read: the most that was measured (docs/guide/program.md), of meshes
// all of whose vertices are on their hull, and somewhat more. By far most of it is the hull's, while it is made.
inline constexpr std::uint64_t bytes_of_question = 600, bytes_of_proof = 750, bytes_of_crossings = 650;
// For each triangle of two meshes of which it is asked how they lie to each other, if a tree of planes has to tell.
inline constexpr std::uint64_t bytes_of_relation = 22'000;

Option memory_option(std::uint64_t& mebibytes);

// The limit of this call, for as long as it is alive.
inline io::MeshMemory limit_of(const QuestionCall& call, std::uint64_t bytes_a_triangle = bytes_of_question) {
  return {call.memory, call.proves() ? bytes_of_proof : bytes_a_triangle};
}

}  // namespace sunder::ask
