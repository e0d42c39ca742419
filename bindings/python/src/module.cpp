// What is compiled of the module `tamis`: thin, private, and typed in tamis/_core.pyi.
#include "python/src/bindings.hpp"

NB_MODULE(_core, module) {
  using namespace tamis::python;
  nanobind::set_leak_warnings(false);  // what lives until the interpreter ends is no concern of its user
  module.attr("__version__") = TAMIS_VERSION;
  bind_errors();
  bind_mesh(module);
  bind_options(module);
  bind_layouts(module);
  bind_detector(module);
  bind_pairs(module);
  bind_pair_distance(module);
  bind_paths(module);
  bind_poses(module);
  bind_shape(module);
  bind_linkage(module);
  bind_world(module);
  bind_files(module);
  bind_scenes(module);
  bind_audit(module);
}
