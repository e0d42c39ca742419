// The parts of the module, each in a file of its own.
#pragma once
#include <nanobind/nanobind.h>

namespace tamis::python {

void bind_errors();
void bind_mesh(nanobind::module_& module);
void bind_options(nanobind::module_& module);
void bind_layouts(nanobind::module_& module);
void bind_detector(nanobind::module_& module);
void bind_pairs(nanobind::module_& module);
void bind_pair_distance(nanobind::module_& module);
void bind_paths(nanobind::module_& module);
void bind_poses(nanobind::module_& module);
void bind_linkage(nanobind::module_& module);
void bind_shape(nanobind::module_& module);
void bind_world(nanobind::module_& module);
void bind_files(nanobind::module_& module);
void bind_scenes(nanobind::module_& module);
void bind_audit(nanobind::module_& module);

}  // namespace tamis::python
