// Poses and links of chains as they lie in NumPy.
#pragma once
#include "python/src/arrays.hpp"
#include "tamis/rigid_path.hpp"

namespace tamis::python {

/// Position and rotation vector each.
using PoseRows = nb::ndarray<const double, nb::shape<-1, 2, 3>, nb::c_contig, nb::device::cpu>;
/// Position and rotation vector at the start, then at the end.
using Links = nb::ndarray<const double, nb::shape<-1, 4, 3>, nb::c_contig, nb::device::cpu>;
/// Chains of as many links each.
using Chains = nb::ndarray<const double, nb::shape<-1, -1, 4, 3>, nb::c_contig, nb::device::cpu>;
static_assert(sizeof(Pose) == 6 * sizeof(double) && sizeof(RigidLink) == 12 * sizeof(double));

template <class Element, class Array>
const Element& row(const Array& array, std::size_t i) {
  return reinterpret_cast<const Element*>(array.data())[i];
}

inline RigidChain chain_at(const Chains& chains, std::size_t i) {
  const RigidLink* first = &row<RigidLink>(chains, i * chains.shape(1));
  return {first, first + chains.shape(1)};
}

}  // namespace tamis::python
