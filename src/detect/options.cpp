#include "tamis/options.hpp"

#include <array>
#include <string>
#include <utility>

#include "tamis/error.hpp"

namespace tamis {
namespace {

template <class E, std::size_t n>
using Names = std::array<std::pair<E, std::string_view>, n>;

constexpr Names<Method, 3> kMethods{{{Method::tamis, "tamis"}, {Method::paper, "paper"}, {Method::brute, "brute"}}};
constexpr Names<PairKind, 4> kKinds{{{PairKind::vertex_face, "vf"},
                                     {PairKind::edge_edge, "ee"},
                                     {PairKind::vertex_edge, "ve"},
                                     {PairKind::vertex_vertex, "vv"}}};
constexpr Names<BoundingVolume, 6> kVolumes{{{BoundingVolume::sphere, "sphere"},
                                             {BoundingVolume::aabb, "aabb"},
                                             {BoundingVolume::obb, "obb"},
                                             {BoundingVolume::dop16, "16-dop"},
                                             {BoundingVolume::dop18, "18-dop"},
                                             {BoundingVolume::dop26, "26-dop"}}};
constexpr Names<Isa, 4> kIsas{
    {{Isa::best, "best"}, {Isa::baseline, "baseline"}, {Isa::avx2, "avx2"}, {Isa::avx512, "avx512"}}};

constexpr Names<AtStart, 3> kAtStart{
    {{AtStart::report, "report"}, {AtStart::ignore, "ignore"}, {AtStart::fail, "fail"}}};

template <class E, std::size_t n>
E find(const Names<E, n>& names, std::string_view what, std::string_view name) {
  std::string choices;
  for (const auto& [value, text] : names) {
    if (text == name) return value;
    choices += (choices.empty() ? "" : ", ") + std::string(text);
  }
  throw InvalidOptions("no " + std::string(what) + " is called '" + std::string(name) + "': use one of " + choices);
}

template <class E, std::size_t n>
std::string_view name(const Names<E, n>& names, E value) {
  for (const auto& [key, text] : names)
    if (key == value) return text;
  return kUnnamed;
}

}  // namespace

Method method_from_name(std::string_view text) { return find(kMethods, "method", text); }
Isa isa_from_name(std::string_view text) { return find(kIsas, "instruction set", text); }
AtStart at_start_from_name(std::string_view text) {
  return find(kAtStart, "way with pairs that touch at the start", text);
}
BoundingVolume bounding_volume_from_name(std::string_view text) { return find(kVolumes, "bounding volume", text); }
std::string_view name_of(PairKind value) { return name(kKinds, value); }
std::string_view name_of(BoundingVolume value) { return name(kVolumes, value); }
std::string_view name_of(Method value) { return name(kMethods, value); }
std::string_view name_of(AtStart value) { return name(kAtStart, value); }
std::string_view name_of(Isa value) { return name(kIsas, value); }

namespace {

PairFilter matrix_filter(std::vector<Index> group_of_vertex, Index group_count, auto may_touch) {
  PairFilter filter;
  filter.group_of_vertex = std::move(group_of_vertex);
  filter.group_count = group_count;
  for (Index a = 0; a < group_count; ++a)
    for (Index b = 0; b < group_count; ++b) filter.groups_may_touch.push_back(may_touch(a, b) ? 1 : 0);
  return filter;
}

}  // namespace

PairFilter PairFilter::no_self_contact(std::vector<Index> group_of_vertex) {
  Index count = 1;
  for (Index g : group_of_vertex) count = g < count ? count : g + 1;
  return matrix_filter(std::move(group_of_vertex), count, [](Index a, Index b) { return a != b; });
}

PairFilter PairFilter::no_static_pairs(std::vector<Index> group_of_vertex, const std::vector<bool>& is_static) {
  const auto still = [&](Index g) { return bool(is_static[static_cast<std::size_t>(g)]); };
  return matrix_filter(std::move(group_of_vertex), static_cast<Index>(is_static.size()),
                       [&](Index a, Index b) { return !(still(a) && still(b)); });
}

}  // namespace tamis
