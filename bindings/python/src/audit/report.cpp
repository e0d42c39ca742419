#include "python/src/audit/report.hpp"

#include <nanobind/stl/string.h>
#include <nanobind/stl/vector.h>

#include "python/src/arrays.hpp"
#include "python/src/layout.hpp"

namespace tamis::python {
namespace {

nb::object frame_rows(const audit::Report& report) {
  std::vector<FrameRow> rows;
  rows.reserve(report.frames.size());
  for (std::size_t i = 0; i < report.frames.size(); ++i) rows.push_back(row_of(report.frames[i], i));
  return own_bytes(std::move(rows));
}

/// Names of files may hold any byte: as Python has them.
nb::object text_of(const std::string& text) {
  return nb::steal(PyUnicode_DecodeUTF8(text.data(), static_cast<Py_ssize_t>(text.size()), "surrogateescape"));
}

nb::list texts(const audit::Report& report, std::string audit::FrameAnswer::*member) {
  nb::list all;
  for (const audit::FrameAnswer& frame : report.frames) all.append(text_of(frame.*member));
  return all;
}

nb::list segments(const audit::Report& report) {
  nb::list all;
  for (const audit::Segment& segment : report.segments)
    all.append(nb::make_tuple(segment.first_frame, segment.objects.names));
  return all;
}

}  // namespace

FrameRow row_of(const audit::FrameAnswer& answer, std::size_t frame) {
  return {static_cast<std::int64_t>(frame),
          answer.problem.empty(),
          answer.has_step,
          answer.counts,
          answer.neighbours,
          answer.fresh,
          answer.toi_lower,
          answer.toi_upper,
          answer.has_collapsed};
}

nb::dict as_dict(const audit::Report& report) {
  nb::dict all;
  all["is_free"] = report.is_free();
  all["ring_limit"] = report.ring_limit;
  all["frames"] = frame_rows(report);
  all["names"] = texts(report, &audit::FrameAnswer::name);
  all["problems"] = texts(report, &audit::FrameAnswer::problem);
  all["notes"] = texts(report, &audit::FrameAnswer::note);
  all["segments"] = segments(report);
  all["pairs"] = own_bytes(std::vector<audit::Finding>(report.pairs));
  all["pairs_left_out"] = report.pairs_left_out;
  all["by_rings"] = report.by_rings;
  return all;
}

void bind_report_layouts(nb::module_& module) {
  module.def("finding_layout", [] {
    return Layout<audit::Finding>()
        .field("frame", &audit::Finding::frame)
        .field("kind", &audit::Finding::kind)
        .field("vertices", &audit::Finding::vertices)
        .field("toi_lower", &audit::Finding::toi_lower)
        .field("toi_upper", &audit::Finding::toi_upper)
        .field("objects", &audit::Finding::objects)
        .field("rings", &audit::Finding::rings)
        .field("is_new", &audit::Finding::is_new)
        .dict();
  });
  module.def("frame_row_layout", [] {
    return Layout<FrameRow>()
        .field("frame", &FrameRow::frame)
        .field("is_usable", &FrameRow::is_usable)
        .field("has_step", &FrameRow::has_step)
        .field("counts", &FrameRow::counts)
        .field("neighbours", &FrameRow::neighbours)
        .field("new", &FrameRow::fresh)
        .field("toi_lower", &FrameRow::toi_lower)
        .field("toi_upper", &FrameRow::toi_upper)
        .field("has_collapsed", &FrameRow::has_collapsed)
        .dict();
  });
}

}  // namespace tamis::python
