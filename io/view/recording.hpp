// What the outputs for looking show: a mesh, its frames, and what was found in each step between two of them.
#pragma once
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "tamis/detector.hpp"

namespace tamis::io {

/// The answer to one step.
struct RecordedStep {
  std::vector<Contact> contacts;
  std::vector<StageCount> stages;
  /// What is proven free where not all contacts are listed; none: the listed ones say it.
  std::optional<double> free_before = {};
};

/// REQUIRES: one frame more than steps; frames have a row for each vertex of the mesh.
struct Recording {
  const Mesh& mesh;
  const Options& options;
  double scale = 1;                ///< step i goes from frame i to frame i + scale (frame i+1 - frame i)
  std::vector<std::string> names;  ///< of the frames, in UTF-8
  std::vector<std::vector<Point>> frames;
  std::vector<RecordedStep> steps;
};

/// Where the vertices of the first step are, as it was decided.
struct FirstStep {
  explicit FirstStep(const Recording& recording);

  const std::vector<Point>& start;
  std::vector<Point> end;
};

}  // namespace tamis::io
