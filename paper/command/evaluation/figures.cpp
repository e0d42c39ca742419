#include "paper/command/evaluation/figures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "paper/command/evaluation/tables.hpp"

namespace tamis::lab {
namespace {

constexpr std::array kPublished{
    PublishedRow{"airbag", 1, 150, 1.16, 1.41},     PublishedRow{"airbag", 3, 330, 1.32, 1.37},
    PublishedRow{"cloth-ball", 1, 938, 1.24, 1.53}, PublishedRow{"cloth-ball", 3, 3507, 1.36, 1.28},
    PublishedRow{"funnel", 1, 73, 1.09, 2.16},      PublishedRow{"funnel", 3, 139, 1.14, 1.64},
    PublishedRow{"bunny", 1, 12, 1.54, 2.36},       PublishedRow{"bunny", 3, 38, 1.67, 1.89},
};

std::uint64_t entering(const MethodResult& method, std::string_view stage, Counted counted) {
  for (const StageCount& count : method.stages)
    if (count.name == stage) return (counted == Counted::ee ? 0 : count.vf) + (counted == Counted::vf ? 0 : count.ee);
  return 0;
}

}  // namespace

const PublishedRow* published_row(const SceneResult& r) {
  const auto row = std::find_if(kPublished.begin(), kPublished.end(),
                                [&](const PublishedRow& p) { return p.scene == r.scene && p.factor == r.factor; });
  return row == kPublished.end() ? nullptr : &*row;
}

std::string row_name(const SceneResult& r) {
  return fmt::format("{} {}x{}", r.scene, r.factor, r.extrapolated ? " (stretched)" : "");
}

double ratio(const SceneResult& r, std::string_view slow, std::string_view fast) {
  return r.milliseconds(slow) / r.milliseconds(fast);
}

double culled_between(const MethodResult& method, std::string_view from, std::string_view to, Counted counted) {
  return culled_part(entering(method, from, counted), entering(method, to, counted));
}

double ncf_rate(const SceneResult& r) { return culled_between(r.method("paper"), "ncf-published", "newton"); }

double ncf_rate_of_false_pairs(const SceneResult& r) {
  const MethodResult& m = r.method("paper");
  const std::uint64_t entering = m.entering("ncf-published");
  return culled_part(entering - std::min(entering, m.contacts), m.false_pairs());
}

}  // namespace tamis::lab
