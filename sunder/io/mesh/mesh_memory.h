// A limit for the memory that a question about meshes takes, in proportion to their triangles: told before it is taken.
#pragma once

#include <sunder/base/error.h>

#include <cstdint>
#include <string>

namespace sunder::io {

// While one of these is alive, what is made of meshes on this thread is counted, and refused beyond the limit. Where
// none is, there is no limit. One at a time on a thread. Throws nothing itself.
class MeshMemory {
 public:
  static constexpr std::uint64_t bytes_per_mebibyte = std::uint64_t{1} << 20;

  // bytes_a_triangle: what the body, the mesh and the question take for a triangle that is read.
  MeshMemory(std::uint64_t mebibytes, std::uint64_t bytes_a_triangle);
  ~MeshMemory();
  MeshMemory(const MeshMemory&) = delete;
  MeshMemory& operator=(const MeshMemory&) = delete;

  // So many triangles more are read, or are asked something that takes `bytes` for each. Throws Error bad_value where
  // all together is more than the limit: one line with the estimate and the option --memory.
  static void take(const std::string& file, std::uint64_t triangles);
  static void take(const std::string& file, std::uint64_t triangles, std::uint64_t bytes);

 private:
  std::uint64_t limit_, bytes_a_triangle_, taken_ = 0;
};

}  // namespace sunder::io
