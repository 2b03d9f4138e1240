// Reading a mesh of a text: what is read, and what is said of what is refused.
#pragma once

#include <sunder/base/error.h>
#include <sunder/io/mesh/mesh.h>
#include <sunder/io/mesh/mesh_check_test.h>

#include <gtest/gtest.h>

#include <string>
#include <string_view>

namespace sunder::io {

inline Mesh checked_mesh(std::string_view text, MeshFormat format) {
  Mesh mesh = parse_mesh(text, "test", format);
  EXPECT_EQ(mesh_fault(mesh), "");
  return mesh;
}

inline std::string mesh_error(std::string_view text, MeshFormat format) {
  try {
    parse_mesh(text, "test", format);
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::bad_file);
    return error.what();
  }
  return "no error";
}

}  // namespace sunder::io
