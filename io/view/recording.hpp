// What the outputs for looking show: a mesh, its frames, and what was found in each step between two of them; or one
// pose, and what passes through what in it.
#pragma once
#include <array>
#include <cstdint>
#include <optional>
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
  /// Of the frame at which it ends; of an audit alone.
  std::vector<Intersection> intersections = {};
  /// The places of its start and its end among the frames; none: step i goes from frame i to frame i + 1.
  std::optional<std::array<std::size_t, 2>> ends = {};
};

/// What passes through what.
struct RecordedPose {
  std::vector<Intersection> intersections;
  std::vector<StageCount> stages;
};

/// All frames of an audited motion, of which the recording has some: a number each.
struct RecordedStrip {
  static constexpr int kNotShown = -1;

  std::vector<std::string> names;
  std::vector<std::uint64_t> contacts;       ///< of the step that ends there
  std::vector<std::uint64_t> intersections;  ///< of the frame
  std::vector<int> steps;                    ///< the recording's step that ends there, or kNotShown
};

/// REQUIRES: one frame more than steps, or steps that have their ends; frames have a row for each vertex of the mesh. A
/// single frame comes with `pose`.
struct Recording {
  const Mesh& mesh;
  const Options& options;
  double scale = 1;                ///< step i goes from frame i to frame i + scale (frame i+1 - frame i)
  std::vector<std::string> names;  ///< of the frames, in UTF-8
  std::vector<std::vector<Point>> frames;
  std::vector<RecordedStep> steps;
  std::optional<RecordedPose> pose = {};
  std::optional<RecordedStrip> strip = {};
};

/// Where the vertices of the first step are, as it was decided; of a pose both are the pose.
struct FirstStep {
  explicit FirstStep(const Recording& recording);

  const std::vector<Point>& start;
  std::vector<Point> end;
};

}  // namespace tamis::io
