// What every fuzzer of a mesh reader does.
#pragma once

#include <fuzz/require.h>

#include <sunder/base/error.h>
#include <sunder/io/mesh/mesh.h>
#include <sunder/io/mesh/mesh_check_test.h>
#include <sunder/io/mesh/mesh_write.h>

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <string_view>

namespace sunder::fuzz {

// A message is one line of printable text, and names the file first.
inline void check_message(const Error& error, std::string_view file) {
  const std::string_view text = error.what();
  require(error.code() == ErrorCode::bad_file, "the code of: " + std::string(text));
  require(text.starts_with(file) && text.size() < 400, "the message: " + std::string(text));
  for (const char c : text)
    require(static_cast<unsigned char>(c) >= 0x20 && c != 0x7f, "a control byte in the message");
}

// Bytes are a valid mesh or give an error of one line; a mesh that is written and read again is the same.
inline void check_mesh_reader(const std::uint8_t* data, std::size_t size, io::MeshFormat format) {
  constexpr std::string_view file = "fuzz";
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  try {
    io::mesh_format(bytes, file);
  } catch (const Error& error) {
    check_message(error, file);
  }

  io::Mesh mesh;
  try {
    mesh = io::parse_mesh(bytes, file, format);
  } catch (const Error& error) {
    check_message(error, file);
    return;
  }
  require(io::mesh_fault(mesh).empty(), io::mesh_fault(mesh));
  for (const io::Mesh& part : io::split_parts(mesh)) require(io::mesh_fault(part).empty(), io::mesh_fault(part));

  for (const io::MeshFormat other : {io::MeshFormat::obj, io::MeshFormat::off, io::MeshFormat::ply}) {
    const std::string text = io::to_text(other, mesh.vertices, mesh.polygon_begin, mesh.polygon_vertices);
    require(io::mesh_format(text, file) == other, "the format of what was written");
    const io::Mesh again = io::parse_mesh(text, file, other);
    require(again.vertices == mesh.vertices, "the vertices of what was written");
    require(again.polygon_begin == mesh.polygon_begin, "the polygons of what was written");
    require(again.polygon_vertices == mesh.polygon_vertices, "the corners of what was written");
  }
}

}  // namespace sunder::fuzz
