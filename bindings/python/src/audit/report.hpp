// The report of an audit as arrays and lists.
#pragma once
#include <nanobind/nanobind.h>

#include "audit/report.hpp"

namespace tamis::python {

/// One row a frame; Python has the texts beside them.
struct FrameRow {
  std::int64_t frame;
  bool is_usable;
  bool has_step;
  std::array<std::uint64_t, audit::kKinds> counts;
  std::uint64_t neighbours;
  std::uint64_t fresh;
  double toi_lower;
  double toi_upper;
  bool has_collapsed;
};

nanobind::dict as_dict(const audit::Report& report);
FrameRow row_of(const audit::FrameAnswer& answer, std::size_t frame);
void bind_report_layouts(nanobind::module_& module);

}  // namespace tamis::python
