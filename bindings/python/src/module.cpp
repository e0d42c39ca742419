// What is compiled of the module `tamis`: thin, private, and typed in tamis/_core.pyi.
#include <nanobind/stl/string.h>

#include <string>

#include "python/src/bindings.hpp"

namespace tamis::python {
namespace {

/// Throws ImportError if the process has loaded another version: both would give nanobind's backend classes of one
/// name.
void refuse_second_version() {
  const nanobind::object sys = nanobind::module_::import_("sys");
  constexpr const char* kMark = "_tamis_version";
  if (nanobind::hasattr(sys, kMark)) {
    const auto loaded = nanobind::cast<std::string>(sys.attr(kMark));
    if (loaded == TAMIS_VERSION) return;
    const std::string sentence = "tamis " TAMIS_VERSION " cannot be imported, because this process has loaded tamis " +
                                 loaded + " already: start a new process, and keep one version on sys.path";
    throw nanobind::import_error(sentence.c_str());
  }
  sys.attr(kMark) = TAMIS_VERSION;
}

}  // namespace
}  // namespace tamis::python

NB_MODULE(_core, module) {
  using namespace tamis::python;
  refuse_second_version();
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
