// The vertices of a step, as their frame reads them: in one process, or on many ranks that each have some.
#pragma once
#include <span>

#include "search/bounds/box.hpp"
#include "search/bounds/fine_place.hpp"
#include "tamis/step.hpp"

namespace tamis {

/// The boxes of some vertices at both ends of the step, and how many vertices they hold.
struct EndBoxes {
  Box start, end;
  std::size_t count = 0;
};

class SceneVertices {
 public:
  virtual ~SceneVertices() = default;
  virtual std::size_t count() const = 0;
  virtual EndBoxes boxes() const = 0;
  /// Of the vertices within a distance of a place.
  virtual EndBoxes boxes_near(const FinePlace& place, double distance) const = 0;
  /// Writes the sample. REQUIRES: sample_size(count()) vertices.
  virtual void sample(std::span<SampledVertex> vertices) const = 0;
};

/// The vertices of a step that are `used`, by number. Refers to the positions and to `used`.
class StepVertices final : public SceneVertices {
 public:
  StepVertices(const Step& step, std::span<const Index> used) : step_(step), used_(used) {}

  std::size_t count() const override { return used_.size(); }
  EndBoxes boxes() const override;
  EndBoxes boxes_near(const FinePlace& place, double distance) const override;
  void sample(std::span<SampledVertex> vertices) const override;

 private:
  Step step_;
  std::span<const Index> used_;
};

}  // namespace tamis
