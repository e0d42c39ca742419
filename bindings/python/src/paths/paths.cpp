// Curved motion: ready-made paths, those that Python describes, and their single pairs.
#include <nanobind/stl/optional.h>
#include <nanobind/stl/vector.h>

#include <algorithm>
#include <optional>

#include "files/view/path_positions.hpp"
#include "python/src/bindings.hpp"
#include "python/src/pairs/pair_results.hpp"
#include "python/src/pairs/pair_rows.hpp"
#include "python/src/paths/function_path.hpp"
#include "python/src/paths/pose_rows.hpp"
#include "tamis/rigid_path.hpp"
#include "tamis/spline_path.hpp"

namespace tamis::python {
namespace {

using Frames = nb::ndarray<const double, nb::shape<-1, -1, 3>, nb::c_contig, nb::device::cpu>;

void make_rigid_path(RigidPath* path, const PointRows& rest, const Indices& bodies, const std::vector<Links>& links,
                     const PointRows& rest_end) {
  std::vector<RigidChain> chains;
  for (const Links& chain : links) chains.push_back(copy_of<RigidLink>(chain));
  new (path) RigidPath(copy_of<Point>(rest), copy_of<Index>(bodies), std::move(chains), copy_of<Point>(rest_end));
}

template <class SplinePath>
void make_spline_path(SplinePath* path, const Frames& given) {
  const auto* first = reinterpret_cast<const Point*>(given.data());
  const std::size_t vertices = given.shape(1);
  std::vector<std::vector<Point>> frames;
  for (std::size_t i = 0; i < given.shape(0); ++i, first += vertices) frames.emplace_back(first, first + vertices);
  new (path) SplinePath(std::move(frames));
}

/// The first of the vertices, as many as the kind has.
template <std::size_t corners>
std::array<Index, corners> first_of(const FeaturePair& pair) {
  std::array<Index, corners> vertices;
  std::copy_n(pair.vertices.begin(), corners, vertices.begin());
  return vertices;
}

PairResult decide_on(const Path& path, const FeaturePair& pair, const PairOptions& options) {
  switch (pair.kind) {
    case PairKind::vertex_face:
      return vertex_face(path, pair.vertices, options);
    case PairKind::edge_edge:
      return edge_edge(path, pair.vertices, options);
    case PairKind::vertex_edge:
      return vertex_edge(path, first_of<3>(pair), options);
    case PairKind::vertex_vertex:
      return vertex_vertex(path, first_of<2>(pair), options);
  }
  throw InvalidPath("a pair of no kind that there is: give a PairKind");
}

nb::object decide_list_on(const Kinds& kinds, const IndexRowsIn<4>& vertices, const Path& path, double min_separation,
                          std::optional<double> tolerance) {
  PairOptions options{.min_separation = min_separation};
  options.tolerance = tolerance.value_or(options.tolerance);
  return decide_each(kinds.shape(0), [&](std::size_t i, const std::function<bool()>& is_cancelled) {
    options.is_cancelled = is_cancelled;
    return decide_on(path, pair_at(kinds, vertices, i), options);
  });
}

using Times = nb::ndarray<const double, nb::ndim<1>, nb::c_contig, nb::device::cpu>;
using VertexRows = nb::ndarray<const Index, nb::ndim<2>, nb::c_contig, nb::device::cpu>;

/// Where the vertices of each row are at a time of its own, rounded. REQUIRES: vertices of the path, and as many times.
nb::object corners_at(const Path& path, const Times& times, const VertexRows& rows) {
  const std::size_t columns = rows.shape(1);
  std::vector<Point> corners(rows.size());
  std::vector<double> errors(columns);
  for (std::size_t i = 0; i < rows.shape(0); ++i)
    path.points_at(times.data()[i], {rows.data() + columns * i, columns}, {corners.data() + columns * i, columns},
                   errors);
  return own<double>(std::move(corners));
}

nb::object points_at(const Path& path, double time) { return own<double>(io::positions_at(path, time)); }

}  // namespace

void bind_paths(nb::module_& module) {
  nb::class_<Path>(module, "Path")
      .def_prop_ro("vertex_count", &Path::vertex_count)
      .def("points_at", &points_at)
      .def("corners_at", &corners_at);
  nb::class_<RigidPath, Path>(module, "RigidPath").def("__init__", &make_rigid_path);
  nb::class_<BezierPath, Path>(module, "BezierPath").def("__init__", &make_spline_path<BezierPath>);
  nb::class_<CatmullRomPath, Path>(module, "CatmullRomPath").def("__init__", &make_spline_path<CatmullRomPath>);
  nb::class_<FunctionPath, Path>(module, "FunctionPath").def(nb::init<Index, nb::object, nb::object>());
  const nb::arg any;
  module.def("narrow_phase_on", &decide_list_on, any, any, any, any, nb::arg().none());
}

}  // namespace tamis::python
