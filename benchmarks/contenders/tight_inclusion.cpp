// Tight-Inclusion: one candidate at a time, tolerance 1e-6. Compiled if find_package finds it. MIT licence.
#include <Eigen/Core>
#include <tight_inclusion/ccd.hpp>

#include "benchmarks/contenders/contender.hpp"

namespace tamis::bench {
namespace {

ticcd::Vector3 vector_of(const Point& p) {
  using ticcd::Scalar;
  return {static_cast<Scalar>(p[0]), static_cast<Scalar>(p[1]), static_cast<Scalar>(p[2])};
}

bool touches(const Task& task, const Pair& pair) {
  constexpr ticcd::Scalar kTolerance = 1e-6;  // its authors' advice
  constexpr long kMostIterations = 1'000'000;
  ticcd::Vector3 x[8];
  for (std::size_t i = 0; i < 4; ++i) {
    x[i] = vector_of(task.start[static_cast<std::size_t>(pair.vertices[i])]);
    x[i + 4] = vector_of(task.end[static_cast<std::size_t>(pair.vertices[i])]);
  }
  const ticcd::Array3 no_scene = ticcd::Array3::Constant(-1);
  ticcd::Scalar toi = 0, reached = 0;
  if (pair.kind == PairKind::vertex_face)
    return ticcd::vertexFaceCCD(x[0], x[1], x[2], x[3], x[4], x[5], x[6], x[7], no_scene, 0, toi, kTolerance, 1,
                                kMostIterations, reached);
  return ticcd::edgeEdgeCCD(x[0], x[1], x[2], x[3], x[4], x[5], x[6], x[7], no_scene, 0, toi, kTolerance, 1,
                            kMostIterations, reached);
}

class TightInclusion final : public Contender {
 public:
  std::string name() const override { return "Tight-Inclusion"; }
  Field field() const override { return Field::one_pair; }
  Cost run(const Task& task) override {
    const Stopwatch watch;
    touching_.clear();
    for (const Pair& pair : task.candidates)
      if (touches(task, pair)) touching_.push_back(pair);
    return watch.cost();
  }
  Answer answer(const Task& task) override { return compare(task, touching_, true, true); }

 private:
  std::vector<Pair> touching_;
};

}  // namespace

void add_tight_inclusion(Contenders& list) { list.push_back(std::make_unique<TightInclusion>()); }

}  // namespace tamis::bench
