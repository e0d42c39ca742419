// How far apart single pairs are, and how long one keeps a part of that.
#include "tamis/pair_distance.hpp"

#include "python/src/answers.hpp"
#include "python/src/bindings.hpp"
#include "python/src/pairs/pair_results.hpp"
#include "python/src/pairs/pair_rows.hpp"
#include "tamis/error.hpp"

namespace tamis::python {
namespace {

/// Of a table's column, whose entries lie apart.
using Numbers = nb::ndarray<const double, nb::ndim<1>, nb::device::cpu>;

/// REQUIRES: as many kinds as rows of vertices, which the Python side sees to.
nb::object distances_of(const Kinds& kinds, const IndexRowsIn<4>& vertices, const Rows& at) {
  return decide_each(kinds.shape(0), [&](std::size_t i, const auto&) {
    try {
      return distance_of(pair_at(kinds, vertices, i), positions(at));
    } catch (const InvalidStep& fault) {
      throw InvalidStep("pair " + std::to_string(i) + ": " + fault.what());
    }
  });
}

nb::tuple pair_safe_step(const Kinds& kind, const IndexRowsIn<4>& vertices, const Rows& start, const Rows& end,
                         double keep, double min_separation, double latest) {
  return step_tuple(
      safe_step(pair_at(kind, vertices, 0), {positions(start), positions(end)}, keep, {min_separation, latest}));
}

/// Places of both features of each pair, two a row.
nb::object features(const Mesh& mesh, const Kinds& kinds, const IndexRowsIn<4>& vertices) {
  std::vector<std::array<Index, 2>> places(kinds.shape(0));
  for (std::size_t i = 0; i < places.size(); ++i) {
    const FeaturePair pair = pair_at(kinds, vertices, i);
    try {
      places[i] = features_of(mesh, pair.kind, pair.vertices);
    } catch (const InvalidMesh& fault) {
      throw InvalidMesh("pair " + std::to_string(i) + ": " + fault.what());
    }
  }
  return own<Index>(std::move(places));
}

/// Signed weights of each, four a row. REQUIRES: kinds that there are, and as many weights.
nb::object weights(const Kinds& kinds, const Numbers& u, const Numbers& v) {
  std::vector<std::array<double, 4>> all(kinds.shape(0));
  for (std::size_t i = 0; i < all.size(); ++i) all[i] = weights_of(static_cast<PairKind>(kinds.data()[i]), u(i), v(i));
  return own<double>(std::move(all));
}

}  // namespace

void bind_pair_distance(nb::module_& module) {
  module.def("distances_of", &distances_of);
  module.def("safe_step", &pair_safe_step);
  module.def("features_of", &features);
  module.def("weights_of", &weights);
}

}  // namespace tamis::python
