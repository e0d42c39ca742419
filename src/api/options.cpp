#include "tamis/options.hpp"

#include <algorithm>
#include <limits>

#include "api/enum_names.hpp"
#include "tamis/error.hpp"
#include "tamis/stored_type.hpp"

namespace tamis {
namespace {

constexpr EnumNames<PairKind, 4> kKinds{{{PairKind::vertex_face, "vf"},
                                         {PairKind::edge_edge, "ee"},
                                         {PairKind::vertex_edge, "ve"},
                                         {PairKind::vertex_vertex, "vv"}}};
static_assert(kKinds.size() == kPairKinds, "name each kind of pair");
constexpr EnumNames<Isa, 4> kIsas{
    {{Isa::best, "best"}, {Isa::baseline, "baseline"}, {Isa::avx2, "avx2"}, {Isa::avx512, "avx512"}}};

constexpr EnumNames<AtStart, 3> kAtStart{
    {{AtStart::report, "report"}, {AtStart::ignore, "ignore"}, {AtStart::fail, "fail"}}};

constexpr EnumNames<StoredType, 2> kStored{{{StoredType::float64, "float64"}, {StoredType::float32, "float32"}}};

PairFilter matrix_filter(std::vector<Index> group_of_vertex, Index group_count, auto may_touch) {
  PairFilter filter;
  filter.group_of_vertex = std::move(group_of_vertex);
  filter.group_count = group_count;
  for (Index a = 0; a < group_count; ++a)
    for (Index b = 0; b < group_count; ++b) filter.groups_may_touch.push_back(may_touch(a, b) ? 1 : 0);
  return filter;
}

}  // namespace

Isa isa_from_name(std::string_view name) { return find_by_name(kIsas, "instruction set", name); }
AtStart at_start_from_name(std::string_view name) { return find_by_name(kAtStart, "at_start mode", name); }
std::string_view name_of(PairKind value) { return find_name(kKinds, value); }
std::string_view name_of(AtStart value) { return find_name(kAtStart, value); }
std::string_view name_of(StoredType value) { return find_name(kStored, value); }
std::string_view name_of(Isa value) { return find_name(kIsas, value); }

PairFilter PairFilter::no_self_contact(std::vector<Index> group_of_vertex) {
  constexpr Index kLast = std::numeric_limits<Index>::max();
  Index count = 1;
  for (const Index g : group_of_vertex) {
    if (g == kLast)
      throw InvalidOptions("a vertex is in group " + std::to_string(kLast) + ": number groups from 0 on, without gaps");
    count = std::max(count, g + 1);
  }
  return matrix_filter(std::move(group_of_vertex), count, [](Index a, Index b) { return a != b; });
}

PairFilter PairFilter::no_static_pairs(std::vector<Index> group_of_vertex, const std::vector<bool>& is_static) {
  const auto still = [&](Index g) { return bool(is_static[static_cast<std::size_t>(g)]); };
  return matrix_filter(std::move(group_of_vertex), static_cast<Index>(is_static.size()),
                       [&](Index a, Index b) { return !(still(a) && still(b)); });
}

}  // namespace tamis
