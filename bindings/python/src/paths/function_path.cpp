#include "python/src/paths/function_path.hpp"

#include <algorithm>

namespace tamis::python {
namespace {

using Bounds = nb::ndarray<const double, nb::ndim<1>, nb::c_contig, nb::device::cpu>;

nb::object array_of(std::span<const Index> vertices) {
  return own<Index>(std::vector<Index>(vertices.begin(), vertices.end()));
}

}  // namespace

void FunctionPath::points_at(double time, std::span<const Index> vertices, std::span<Point> points,
                             std::span<double> errors) const {
  const nb::gil_scoped_acquire lock;
  const auto answer = nb::cast<nb::tuple>(points_at_(time, array_of(vertices)));
  const auto places = nb::cast<PointRows>(answer[0]);
  const auto bounds = nb::cast<Bounds>(answer[1]);
  std::copy_n(places.data(), 3 * points.size(), points.data()->data());
  std::copy_n(bounds.data(), errors.size(), errors.data());
}

void FunctionPath::deviations(double from, double to, std::span<const Index> vertices,
                              std::span<double> deviations) const {
  const nb::gil_scoped_acquire lock;
  const auto bounds = nb::cast<Bounds>(deviations_(from, to, array_of(vertices)));
  std::copy_n(bounds.data(), deviations.size(), deviations.data());
}

}  // namespace tamis::python
