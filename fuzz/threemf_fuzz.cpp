// Any bytes, read as 3MF: those of an archive as they are, others as the model in one. Seeds: cases/mesh, cases/broken.
#include <fuzz/mesh_fuzz.h>

#include <sunder/io/text/foreign.h>
#include <sunder/io/text/zip_make_test.h>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  const std::string package = sunder::io::is_zip(bytes) ? std::string(bytes) : sunder::io::package_made(bytes);
  sunder::fuzz::check_mesh_reader(reinterpret_cast<const std::uint8_t*>(package.data()), package.size(),
                                  sunder::io::MeshFormat::three_mf);
  return 0;
}
