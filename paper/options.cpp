// The paper's competitors by name: how each differs from the published pipeline.
#include "paper/options.hpp"

#include "api/enum_names.hpp"
#include "paper/filters/filters.hpp"

namespace tamis::lab {
namespace {

struct Competitor {
  std::string_view name;
  std::array<std::string_view, 2> filters;
  bool orphan_sets = true, representative_triangles = true;
  HighLevelCulling high_level = HighLevelCulling::none;
};

constexpr std::array kCompetitors{
    Competitor{"paper-dnf-ncf", {"dnf", "ncf-published"}},
    Competitor{"paper-dnf", {"dnf"}},
    Competitor{"paper-ncf", {"ncf-published"}},
    Competitor{"paper-sat", {"sat"}},
    Competitor{"paper-pfs", {"pfs-linear", "pfs-planar"}},
    Competitor{"paper-r-triangles", {}},
    Competitor{"paper-no-orphans", {"dnf", "ncf-published"}, false, true},
    Competitor{"paper-no-representatives", {"dnf", "ncf-published"}, true, false},
    Competitor{"paper-normal-cones", {"dnf", "ncf-published"}, true, true, HighLevelCulling::normal_cones},
    Competitor{"paper-star-contours", {"dnf", "ncf-published"}, true, true, HighLevelCulling::star_contours}};

constexpr EnumNames<Method, 3> kMethods{{{Method::tamis, "tamis"}, {Method::paper, "paper"}, {Method::brute, "brute"}}};
constexpr EnumNames<BoundingVolume, 6> kVolumes{{{BoundingVolume::sphere, "sphere"},
                                                 {BoundingVolume::aabb, "aabb"},
                                                 {BoundingVolume::obb, "obb"},
                                                 {BoundingVolume::dop16, "16-dop"},
                                                 {BoundingVolume::dop18, "18-dop"},
                                                 {BoundingVolume::dop26, "26-dop"}}};

}  // namespace

Method method_from_name(std::string_view name) { return find_by_name(kMethods, "method", name); }
BoundingVolume bounding_volume_from_name(std::string_view name) {
  return find_by_name(kVolumes, "bounding volume", name);
}
std::string_view name_of(Method value) { return find_name(kMethods, value); }
std::string_view name_of(BoundingVolume value) { return find_name(kVolumes, value); }

std::vector<std::string_view> method_choices() {
  std::vector<std::string_view> names;
  for (const auto& [method, name] : kMethods) names.push_back(name);
  for (const Competitor& c : kCompetitors) names.push_back(c.name);
  return names;
}

void choose_method(Options& options, std::string_view name) {
  for (const auto& [method, its_name] : kMethods)
    if (its_name == name) {
      options.method = method;
      return;
    }
  for (const Competitor& c : kCompetitors) {
    if (c.name != name) continue;
    options.method = Method::paper;
    options.paper.filters.clear();
    for (const std::string_view filter : c.filters)
      if (!filter.empty()) options.paper.filters.emplace_back(filter);
    options.paper.orphan_sets = c.orphan_sets;
    options.paper.representative_triangles = c.representative_triangles;
    options.paper.high_level = c.high_level;
    return;
  }
  std::string choices;
  for (const std::string_view choice : method_choices()) choices += (choices.empty() ? "" : ", ") + std::string(choice);
  throw InvalidOptions("unknown method '" + std::string(name) + "': use one of " + choices);
}

std::vector<std::string_view> filter_names() {
  std::vector<std::string_view> names;
  for (const FilterStage& stage : filter_stages()) names.push_back(stage.name);
  return names;
}

}  // namespace tamis::lab
