#include "search/bounds/scene_vertices.hpp"

#include "numbers/in_parts.hpp"

namespace tamis {
namespace {

Point point_at(const double* p) { return {p[0], p[1], p[2]}; }

/// Of the vertices for which is_one(start, end) holds.
template <class F>
EndBoxes boxes_of(const Step& step, std::span<const Index> used, const F& is_one) {
  const auto join = [](const EndBoxes& a, const EndBoxes& b) {
    return EndBoxes{joined(a.start, b.start), joined(a.end, b.end), a.count + b.count};
  };
  return joined_parts(used, kVerticesPerPart, EndBoxes(), join, [&](std::span<const Index> some) {
    EndBoxes boxes;
    for (const Index v : some) {
      if (!is_one(step.start[v], step.end[v])) continue;
      ++boxes.count;
      boxes.start.include(point_at(step.start[v]));
      boxes.end.include(point_at(step.end[v]));
    }
    return boxes;
  });
}

}  // namespace

EndBoxes StepVertices::boxes() const {
  return boxes_of(step_, used_, [](const double*, const double*) { return true; });
}

EndBoxes StepVertices::boxes_near(const FinePlace& place, double distance) const {
  return boxes_of(step_, used_,
                  [&](const double* start, const double* end) { return place.distance_to(start, end) <= distance; });
}

void StepVertices::sample(std::span<SampledVertex> vertices) const {
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    const Index v = used_[sample_place(used_.size(), i)];
    vertices[i] = {point_at(step_.start[v]), point_at(step_.end[v])};
  }
}

}  // namespace tamis
