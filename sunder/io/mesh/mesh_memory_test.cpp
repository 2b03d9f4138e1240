#include <sunder/base/error.h>
#include <sunder/io/mesh/mesh_body.h>
#include <sunder/io/mesh/mesh_memory.h>

#include <tests/support/places.h>

#include <gtest/gtest.h>

#include <string>

namespace sunder::io {
namespace {

std::string refusal_of(std::uint64_t triangles, std::uint64_t bytes) {
  try {
    MeshMemory::take("m.obj", triangles, bytes);
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::bad_value);
    return error.what();
  }
  return "";
}

TEST(MeshMemory, AddsUpToItsLimit) {
  EXPECT_EQ(refusal_of(1'000'000'000, 1'000'000), "") << "without a limit";
  {
    const MeshMemory limit(3, 1024);
    MeshMemory::take("m.obj", 1024);
    EXPECT_EQ(refusal_of(2048, 1024), "");
    EXPECT_EQ(refusal_of(1, 1),
              "m.obj: with its 1 triangle the call may take about 4 MiB of memory, at up to 1 bytes each, and the "
              "limit is 3 MiB; give smaller meshes, or let it go on: --memory 4");
  }
  EXPECT_EQ(refusal_of(1'000'000'000, 1'000'000), "");
}

// Twelve triangles of six faces, before anything is made of them.
TEST(MeshMemory, CountsTheTrianglesOfBodies) {
  LeftOutList left_out(false);
  const auto read = [&](std::uint64_t bytes) {
    const MeshMemory limit(1, bytes);
    return read_body(tests::cases / "mesh" / "cube.obj", true, left_out).mesh_polygons;
  };
  const std::uint64_t most = MeshMemory::bytes_per_mebibyte / 12;
  EXPECT_EQ(read(most), 6u);
  EXPECT_THROW((void)read(most + 1), Error);
}

}  // namespace
}  // namespace sunder::io
