// Any bytes, read as COLLADA. Seeds: cases/mesh, cases/broken.
#include <fuzz/mesh_fuzz.h>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  sunder::fuzz::check_mesh_reader(data, size, sunder::io::MeshFormat::collada);
  return 0;
}
