// The extension module sunder._sunder. Its folders of names are those of the library: planar, solid, scene.
#include <sunder/version.h>

#include "common.h"

NB_MODULE(_sunder, module) {
  using namespace sunder::python;  // NOLINT(google-build-using-namespace): of this folder
  module.attr("__version__") = std::string(sunder::version);
  translate_errors();
  bind_answers(module);
  nb::module_ planar = module.def_submodule("planar"), solid = module.def_submodule("solid");
  nb::module_ scene = module.def_submodule("scene");
  bind_planar(module, planar);
  bind_sets(planar);
  bind_regions(planar);
  bind_solid(module, solid);
  bind_many(module);
  bind_scene(scene);
}
