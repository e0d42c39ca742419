// How far apart single pairs are, and how long one keeps a part of that.
#include "tamis/pair_distance.hpp"

#include <nanobind/stl/string.h>

#include <algorithm>

#include "python/src/answers.hpp"
#include "python/src/bindings.hpp"
#include "python/src/pair_results.hpp"
#include "tamis/error.hpp"

namespace tamis::python {
namespace {

/// Numbers of kinds; what is none is no kind either when it comes here.
using Kinds = nb::ndarray<const std::uint8_t, nb::shape<-1>, nb::c_contig, nb::device::cpu>;

Pair pair_at(const Kinds& kinds, const IndexRowsIn<4>& vertices, std::size_t i) {
  Pair pair{static_cast<PairKind>(kinds.data()[i]), {}};
  std::copy_n(vertices.data() + 4 * i, 4, pair.vertices.begin());
  return pair;
}

/// REQUIRES: as many kinds as rows of vertices, which the Python side sees to.
nb::object distances_of(const Kinds& kinds, const IndexRowsIn<4>& vertices, const Rows& at) {
  return decide_each(kinds.shape(0), [&](std::size_t i) {
    try {
      return distance_of(pair_at(kinds, vertices, i), positions(at));
    } catch (const InvalidStep& fault) {
      throw InvalidStep("pair " + std::to_string(i) + ": " + fault.what());
    }
  });
}

nb::tuple pair_keep_distance(const Kinds& kind, const IndexRowsIn<4>& vertices, const Rows& start, const Rows& end,
                             double fraction, const std::string& guarantee, double min_separation, double latest) {
  return as_tuple(keep_distance(pair_at(kind, vertices, 0), {positions(start), positions(end)}, fraction,
                                {guarantee_from_name(guarantee), min_separation, latest}));
}

/// Places of both features of each pair, two a row.
nb::object features(const Mesh& mesh, const Kinds& kinds, const IndexRowsIn<4>& vertices) {
  std::vector<FeaturePair> places(kinds.shape(0));
  for (std::size_t i = 0; i < places.size(); ++i) {
    const Pair pair = pair_at(kinds, vertices, i);
    places[i] = features_of(mesh, pair.kind, pair.vertices);
  }
  return own<Index>(std::move(places), 2);
}

}  // namespace

void bind_pair_distance(nb::module_& module) {
  module.def("distances_of", &distances_of);
  module.def("keep_distance", &pair_keep_distance);
  module.def("features_of", &features);
}

}  // namespace tamis::python
