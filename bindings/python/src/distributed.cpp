// What is compiled of the module `tamis.distributed`: the only part that knows of MPI, built where TAMIS_PYTHON_MPI is
// on; thin, private, and typed in tamis/_distributed.pyi.
#include "tamis/distributed.hpp"

#include <nanobind/stl/string.h>

#include <array>

#include "python/src/answers.hpp"
#include "python/src/asker.hpp"
#include "python/src/collected.hpp"
#include "python/src/contact_array.hpp"

namespace tamis::python {
namespace {

/// Of this rank.
struct Part {
  Part(const Indices& vertices, const IndexRowsIn<3>& faces, const IndexRowsIn<2>& edges, const Indices& points)
      : mesh{copy_of<Index>(vertices), copy_of<Face>(faces), copy_of<Edge>(edges), copy_of<Index>(points)} {}

  distributed::LocalMesh mesh;
};

/// Of an exception; what UTF-8 has no place for is escaped.
std::string text_of(const nb::python_error& error) {
  try {
    const auto text = nb::cast<nb::bytes>(nb::str(error.value()).attr("encode")("utf-8", "backslashreplace"));
    return {text.c_str(), text.size()};
  } catch (const nb::python_error&) {
    return "its text raises an exception, too";
  }
}

/// What the filter raises becomes an error of all ranks, in one sentence: Python's exceptions do not travel.
Options with_sentences(Options options) {
  if (!options.filter.accepts) return options;
  options.filter.accepts = [accepts = std::move(options.filter.accepts)](PairKind kind, const auto& vertices) {
    try {
      return accepts(kind, vertices);
    } catch (const nb::python_error& error) {
      const nb::gil_scoped_acquire lock;
      throw Error("the filter raised " + nb::cast<std::string>(error.type().attr("__name__")) + ": " + text_of(error));
    }
  };
  return options;
}

/// Everything is collective. `communicator` is what Fortran calls it, as mpi4py's py2f() says.
class RankQuestions {
 public:
  RankQuestions(int communicator, const Part& part, const Asking& asking)
      : asker_(asking),
        detector_(MPI_Comm_f2c(communicator), part.mesh, with_sentences(asker_.with_callbacks(asking.options))) {}

  nb::object contacts(const QueryOptions& q, const Rows& start, const Rows& end) {
    return own_bytes(asker_.answer([&] { return copied(detector_.contacts(step_of(start, end), q)); }));
  }
  nb::object gather_contacts(int root) {
    return own_bytes(asker_.answer([&] { return detector_.gather_contacts(root); }));
  }
  nb::tuple earliest(const QueryOptions& q, const Rows& start, const Rows& end) {
    return earliest_tuple(asker_.answer([&] { return detector_.earliest(step_of(start, end), q); }));
  }
  bool is_free(const QueryOptions& q, const Rows& start, const Rows& end) {
    return asker_.answer([&] { return detector_.is_free(step_of(start, end), q); });
  }
  nb::tuple safe_step(const QueryOptions& q, double keep, const Rows& start, const Rows& end) {
    return step_tuple(asker_.answer([&] { return detector_.safe_step(step_of(start, end), keep, q); }));
  }

  Index vertex_count() const { return detector_.vertex_count(); }

  nb::dict statistics() {
    const distributed::Statistics& s = detector_.statistics();
    nb::dict seconds, all;
    seconds["positions"] = s.seconds.positions;
    seconds["decompose"] = s.seconds.decompose;
    seconds["borrow"] = s.seconds.borrow;
    seconds["interior"] = s.seconds.interior;
    seconds["border"] = s.seconds.border;
    seconds["deliver"] = s.seconds.deliver;
    seconds["total"] = s.seconds.total;
    all["owned"] = s.owned;
    all["borrowed"] = s.borrowed;
    all["pairs_tested"] = s.pairs_tested;
    all["boxes"] = s.boxes;
    all["messages_sent"] = s.messages_sent;
    all["bytes_sent"] = s.bytes_sent;
    all["decomposed_anew"] = s.decomposed_anew;
    all["seconds"] = seconds;
    return all;
  }

  nb::tuple balance() { return nb::make_tuple(detector_.balance().pairs, detector_.balance().owned); }

  int traverse(visitproc visit, void* arg) const { return asker_.traverse(visit, arg); }
  void clear() { asker_.clear(); }

 private:
  Asker asker_;
  distributed::Detector detector_;
};

/// As mpi4py says it of its own.
std::string library_version() {
  std::array<char, MPI_MAX_LIBRARY_VERSION_STRING> text{};
  int length = 0;
  MPI_Get_library_version(text.data(), &length);
  return text.data();
}

}  // namespace
}  // namespace tamis::python

NB_MODULE(_distributed, module) {
  using namespace tamis::python;
  nanobind::set_leak_warnings(false);  // as in _core
  nb::class_<Part>(module, "Part")
      .def(nb::init<const Indices&, const IndexRowsIn<3>&, const IndexRowsIn<2>&, const Indices&>());
  nb::class_<RankQuestions>(module, "Detector", nb::type_slots(collected<RankQuestions>), nb::is_weak_referenceable())
      .def(nb::init<int, const Part&, const Asking&>())
      .def("contacts", &RankQuestions::contacts)
      .def("gather_contacts", &RankQuestions::gather_contacts)
      .def("earliest", &RankQuestions::earliest)
      .def("is_free", &RankQuestions::is_free)
      .def("safe_step", &RankQuestions::safe_step)
      .def("vertex_count", &RankQuestions::vertex_count)
      .def("statistics", &RankQuestions::statistics)
      .def("balance", &RankQuestions::balance);
  module.def("library_version", &library_version);
}
