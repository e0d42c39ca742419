// Lists of pairs as they come from NumPy: a kind and four vertices each.
#pragma once
#include <algorithm>
#include <cstdint>

#include "python/src/arrays.hpp"
#include "tamis/pair.hpp"

namespace tamis::python {

/// Numbers of kinds; what is none is not a kind either when it comes here.
using Kinds = nb::ndarray<const std::uint8_t, nb::shape<-1>, nb::c_contig, nb::device::cpu>;

/// REQUIRES: as many kinds as rows of vertices, which the Python side sees to.
inline FeaturePair pair_at(const Kinds& kinds, const IndexRowsIn<4>& vertices, std::size_t i) {
  FeaturePair pair{static_cast<PairKind>(kinds.data()[i]), {}};
  std::copy_n(vertices.data() + 4 * i, 4, pair.vertices.begin());
  return pair;
}

}  // namespace tamis::python
