#include "distributed/src/frame.hpp"

#include <array>

#include "search/bounds/scene_vertices.hpp"

namespace tamis::distributed {
namespace {

/// Where the vertices are that this rank gives or uses.
Step step_of(const std::vector<Motion>& motions) {
  if (motions.empty()) return {};
  constexpr std::ptrdiff_t kStride = sizeof(Motion) / sizeof(double);
  const auto count = static_cast<Index>(motions.size());
  return {{motions[0].start.data(), count, kStride}, {motions[0].end.data(), count, kStride}};
}

/// The vertices of all ranks. All questions are collective.
class RankVertices final : public SceneVertices {
 public:
  RankVertices(Communicator& communicator, const InputPart& input)
      : communicator_(communicator),
        input_(input),
        step_(step_of(input.elements.motions)),
        mine_(step_, input.spoken_for) {}

  std::size_t count() const override { return input_.used_count; }
  EndBoxes boxes() const override { return of_all(mine_.boxes()); }
  EndBoxes boxes_near(const FinePlace& place, double distance) const override {
    return of_all(mine_.boxes_near(place, distance));
  }

  void sample(std::span<SampledVertex> vertices) const override {
    Packer packer;
    for (const auto& [in_sample, place] : input_.sample) {
      const auto& [start, end] = input_.elements.motions[static_cast<std::size_t>(place)];
      packer.put(in_sample);
      packer.put(SampledVertex{start, end});
    }
    for (const Bytes& bytes : communicator_.gather_for_all(packer.take()))
      for (Unpacker unpacker(bytes); !unpacker.empty();) {
        const auto in_sample = unpacker.get<std::size_t>();
        vertices[in_sample] = unpacker.get<SampledVertex>();
      }
  }

 private:
  EndBoxes of_all(const EndBoxes& mine) const {
    constexpr std::size_t kEnds = 12;
    std::array<double, kEnds> ends{};
    const auto each = [&](EndBoxes& boxes, const auto& f) {
      double* end = ends.data();
      for (Box* box : {&boxes.start, &boxes.end})
        for (std::size_t axis = 0; axis < 3; ++axis, end += 2) f(box->low[axis], box->high[axis], end);
    };
    EndBoxes all = mine;
    each(all, [](double low, double high, double* end) { end[0] = low, end[1] = -high; });
    communicator_.reduce_to_least(ends);
    each(all, [](double& low, double& high, const double* end) { low = end[0], high = -end[1]; });
    all.count = communicator_.sum(mine.count);
    return all;
  }

  Communicator& communicator_;
  const InputPart& input_;
  const Step step_;
  const StepVertices mine_;
};

}  // namespace

BoxFrame frame_of_scene(Communicator& communicator, const InputPart& input, double min_separation) {
  return frame_of(RankVertices(communicator, input), min_separation);
}

}  // namespace tamis::distributed
