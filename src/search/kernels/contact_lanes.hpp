// Contacts in lanes, to be read pair by pair.
#pragma once
#include <cmath>

#include "numbers/lanes.hpp"
#include "numbers/vec.hpp"
#include "search/kernels/kernels.hpp"

namespace tamis::TAMIS_ISA {

/// One contact a lane.
class ContactLanes {
 public:
  /// The normal is NaN where the place is not known.
  ContactLanes(const DoubleLanes& lower, const DoubleLanes& upper, const DoubleLanes& u, const DoubleLanes& v,
               const Vec3<DoubleLanes>& normal) {
    const DoubleLanes fields[] = {lower, upper, u, v, normal.x, normal.y, normal.z};
    for (int k = 0; k < 7; ++k) fields[k].store_unaligned(at_[k]);
  }

  bool has_place(int i) const { return !std::isnan(at_[4][i]); }
  PairResult result(int i) const {
    return {true, Certainty::certified, at_[0][i], at_[1][i], at_[2][i], at_[3][i], {at_[4][i], at_[5][i], at_[6][i]}};
  }

 private:
  double at_[7][kDoubleLanes];
};

}  // namespace tamis::TAMIS_ISA
