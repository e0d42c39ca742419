#include "api/pair_faults.hpp"

#include "numbers/finite.hpp"
#include "pair/motion/pair_kinds.hpp"

namespace tamis {
namespace {

std::string feature_text(const std::array<Index, 4>& vertices, std::size_t first, std::size_t last) {
  constexpr std::array kNames{"vertex", "edge", "face"};
  std::string text = kNames[last - first - 1];
  for (std::size_t i = first; i < last; ++i) text.append(" ").append(std::to_string(vertices[i]));
  return text;
}

}  // namespace

std::string features_text(PairKind kind, const std::array<Index, 4>& vertices) {
  const std::size_t second = second_feature(kind);
  return feature_text(vertices, 0, second) + " and " + feature_text(vertices, second, vertex_count(kind));
}

std::string no_such_kind(PairKind kind) {
  return "unknown kind number " + std::to_string(static_cast<int>(kind)) + ": use one of the enumeration's names";
}

std::string not_finite(std::size_t point, const char* when) {
  return "point " + std::to_string(point) + " at the " + when + " of the step is not finite: give finite coordinates";
}

std::string fault_of(const FeaturePair& pair, const Step& step) {
  if (!is_kind(pair.kind)) return no_such_kind(pair.kind);
  for (std::size_t i = 0; i < vertex_count(pair.kind); ++i) {
    const Index v = pair.vertices[i];
    if (v < 0 || v >= step.start.count())
      return "vertex " + std::to_string(v) + " is not a row of the step's " + std::to_string(step.start.count()) +
             " positions: give indices in [0, " + std::to_string(step.start.count()) + ")";
    for (const auto& [positions, when] : {std::pair(step.start, "start"), std::pair(step.end, "end")})
      if (!is_finite(positions[v]))
        return "vertex " + std::to_string(v) + " at the " + when +
               " of the step has a coordinate that is not finite: give finite positions";
  }
  return {};
}

}  // namespace tamis
