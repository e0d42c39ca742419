#include "paper/filters/filters.hpp"

#include <array>
#include <string>

#include "tamis/error.hpp"

namespace tamis::lab {
namespace {

template <class Filter, PairKind kind>
std::size_t cull(const PairMotion<double>* motions, std::span<std::uint16_t> alive) {
  std::size_t kept = 0;
  for (const std::uint16_t pair : alive) {
    alive[kept] = pair;
    kept += Filter::template proves_free<kind>(motions[pair]) ? 0 : 1;
  }
  return kept;
}

template <class... F>
constexpr auto stages_of(FilterList<F...>) {
  return std::array{FilterStage{F::name, cull<F, PairKind::vertex_face>, cull<F, PairKind::edge_edge>}...};
}

constexpr auto kStages = stages_of(Filters{});

}  // namespace

std::span<const FilterStage> filter_stages() { return kStages; }

const FilterStage& filter_stage_by_name(std::string_view name) {
  std::string choices;
  for (const FilterStage& stage : kStages) {
    if (stage.name == name) return stage;
    choices += (choices.empty() ? "" : ", ") + std::string(stage.name);
  }
  throw InvalidOptions("unknown filter '" + std::string(name) + "': use some of " + choices);
}

}  // namespace tamis::lab
