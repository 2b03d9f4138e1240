#include <sunder/base/contract.h>
#include <sunder/io/mesh/mesh_memory.h>
#include <sunder/io/text/text.h>

#include <fmt/format.h>

namespace sunder::io {

namespace {

thread_local MeshMemory* memory_now = nullptr;

}  // namespace

MeshMemory::MeshMemory(std::uint64_t mebibytes, std::uint64_t bytes_a_triangle)
    : limit_(mebibytes), bytes_a_triangle_(bytes_a_triangle) {
  SUNDER_REQUIRE(memory_now == nullptr);
  memory_now = this;
}

MeshMemory::~MeshMemory() { memory_now = nullptr; }

void MeshMemory::take(const std::string& file, std::uint64_t triangles) {
  if (memory_now != nullptr) take(file, triangles, memory_now->bytes_a_triangle_);
}

void MeshMemory::take(const std::string& file, std::uint64_t triangles, std::uint64_t bytes) {
  if (memory_now == nullptr) return;
  memory_now->taken_ += triangles * bytes;  // triangles are fewer than 2^32
  const std::uint64_t needed = (memory_now->taken_ + bytes_per_mebibyte - 1) / bytes_per_mebibyte;
  if (needed <= memory_now->limit_) return;
  throw Error(ErrorCode::bad_value,
              fmt::format("with its {} the call may take about {} MiB of memory, at up to {} bytes each, and the limit "
                          "is {} MiB; give smaller meshes, or let it go on: --memory {}",
                          count_of(triangles, "triangle"), needed, bytes, memory_now->limit_, needed),
              one_line(file));
}

}  // namespace sunder::io
