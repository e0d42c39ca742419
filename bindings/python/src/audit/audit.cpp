// Audits: of frames that an iterator gives, and of a motion that is still going on.
#include "audit/audit.hpp"

#include <nanobind/stl/filesystem.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/vector.h>

#include "audit/auditor.hpp"
#include "files/motion/motion.hpp"
#include "files/output/audit_csv.hpp"
#include "files/view/audit_page.hpp"
#include "python/src/asker.hpp"
#include "python/src/audit/report.hpp"
#include "python/src/audit/source.hpp"
#include "python/src/bindings.hpp"
#include "tamis/error.hpp"

namespace tamis::python {
namespace {

/// What Python has chosen; `progress` is none or a function of the number of frames.
struct AuditOptions {
  audit::Options options;
  nb::object progress = nb::none();
};

void init_options(AuditOptions* place, double min_separation, int threads, bool intersections, bool contacts,
                  Index ring_limit, std::uint64_t listed_pairs, std::size_t page_bytes, nb::object progress) {
  new (place) AuditOptions{{min_separation, threads, intersections, contacts, ring_limit, listed_pairs, page_bytes},
                           std::move(progress)};
}

struct AuditReport {
  audit::Report report;

  void write_page(const std::filesystem::path& path) const {
    const nb::gil_scoped_release unlocked;
    io::write_audit_page(path, report);
  }
  void write_pairs(const std::filesystem::path& path) const {
    const nb::gil_scoped_release unlocked;
    io::write_audit_pairs_csv(path, report);
  }
  /// Throws what ended the audit, if anything did.
  void raise() const {
    if (report.ended_by) std::rethrow_exception(report.ended_by);
  }
};

/// Interrupted, it holds what Python raised.
AuditReport audit_source(audit::FrameSource& source, const AuditOptions& given) {
  Asker asker{Asking{}};
  audit::Options options = given.options;
  options.is_cancelled = [&] { return asker.should_stop(); };
  if (!given.progress.is_none())
    options.progress = [&](std::size_t frames) {
      const nb::gil_scoped_acquire lock;
      given.progress(frames);
    };
  AuditReport result;
  asker.ask([&] { result.report = audit::audit(source, options); });
  try {
    asker.rethrow();
  } catch (...) {
    result.report.ended_by = std::current_exception();
  }
  return result;
}

AuditReport audit_frames(nb::object iterator, const AuditOptions& given) {
  IteratorSource source(std::move(iterator));
  return audit_source(source, given);
}

nb::tuple motion_files(const std::vector<std::string>& names) {
  const io::MotionFiles files = io::motion_files(names);
  std::vector<std::string> paths;
  for (const std::filesystem::path& path : files.all()) paths.push_back(path.string());
  return nb::make_tuple(paths, !files.cache.empty());
}

/// `mesh`: of a point cache, or none. `with_objects`: has those of what is read, or none.
AuditReport audit_files(const std::vector<std::string>& names, const SharedMesh* mesh, const SharedMesh* with_objects,
                        const AuditOptions& given) {
  io::GivenMesh known;
  if (mesh != nullptr) known.mesh = mesh->mesh;
  if (with_objects != nullptr) known.objects = with_objects->mesh->objects();
  const auto source = io::open_motion(io::motion_files(names), std::move(known));
  return audit_source(*source, given);
}

/// One question at a time, other Python threads run meanwhile.
class StreamAuditor {
 public:
  StreamAuditor(const SharedMesh& mesh, const AuditOptions& given)
      : asker_(Asking{}), auditor_(mesh.mesh, with_cancellation(given.options)) {}

  nb::tuple add(const Rows& rows, std::string name) {
    audit::Added added;
    std::size_t number = 0;
    asker_.ask([&] {
      number = auditor_.report().frames.size();
      added = auditor_.add(points_of(positions(rows)), std::move(name));
    });
    return nb::make_tuple(own_bytes(std::vector{row_of(added.answer, number)}), added.answer.name, added.answer.problem,
                          own_bytes(std::move(added.pairs)));
  }
  AuditReport report() {
    const BusyGuard guard = asker_.guard();
    return {auditor_.report()};
  }

 private:
  audit::Options with_cancellation(audit::Options options) {
    options.is_cancelled = [this] { return asker_.should_stop(); };
    return options;
  }

  Asker asker_;
  audit::Auditor auditor_;
};

SharedMesh shared_mesh(const Mesh& mesh, const Indices& of_vertex, std::vector<std::string> names) {
  audit::Objects objects{copy_of<Index>(of_vertex), std::move(names)};
  return {std::make_shared<const audit::AuditedMesh>(mesh, std::move(objects))};
}

}  // namespace

void bind_audit(nb::module_& module) {
  const nb::arg any;
  nb::class_<SharedMesh>(module, "SharedMesh").def_prop_ro("object_names", [](const SharedMesh& shared) {
    return shared.mesh->objects().names;
  });
  module.def("shared_mesh", &shared_mesh);
  nb::class_<AuditOptions>(module, "AuditOptions")
      .def("__init__", &init_options, any, any, any, any, any, any, any, nb::arg().none());
  nb::class_<AuditReport>(module, "AuditReport")
      .def("as_dict", [](const AuditReport& report) { return as_dict(report.report); })
      .def("write_page", &AuditReport::write_page)
      .def("write_pairs", &AuditReport::write_pairs)
      .def("raise_what_ended_it", &AuditReport::raise);
  module.def("audit_frames", &audit_frames);
  module.def("motion_files", &motion_files);
  module.def("audit_files", &audit_files, any, nb::arg().none(), nb::arg().none(), any);
  nb::class_<StreamAuditor>(module, "Auditor")
      .def(nb::init<const SharedMesh&, const AuditOptions&>())
      .def("add", &StreamAuditor::add)
      .def("report", &StreamAuditor::report);
  bind_report_layouts(module);
}

}  // namespace tamis::python
