// The list of filters. To add one: write its file, and name it in `Filters`.
#pragma once
#include <span>

#include "pair/filters/dnf.hpp"
#include "pair/filters/ncf.hpp"
#include "pair/filters/slab_clip.hpp"
#include "paper/filters/ncf_published.hpp"
#include "paper/filters/pfs_linear.hpp"
#include "paper/filters/pfs_planar.hpp"
#include "paper/filters/sat.hpp"

namespace tamis::lab {

template <class... F>
struct FilterList {};

using Filters = FilterList<Dnf, Ncf, NcfPublished, Sat, PfsLinear, PfsPlanar, SlabClip>;

/// One filter as a stage over a block of pairs. It keeps in `alive` (indices into `motions`) the pairs that it cannot
/// prove free, in order, and returns their number.
struct FilterStage {
  using Cull = std::size_t (*)(const PairMotion<double>* motions, std::span<std::uint16_t> alive);
  std::string_view name;
  Cull vf, ee;
};

std::span<const FilterStage> filter_stages();

/// Throws InvalidOptions, naming the choices, if there is no such filter.
const FilterStage& filter_stage_by_name(std::string_view name);

}  // namespace tamis::lab
