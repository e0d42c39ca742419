// The content of outputs to look at: a mesh, its frames, and the answers for the steps between them; or one pose and
// its intersections.
#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "audit/audited_mesh.hpp"
#include "tamis/detector.hpp"

namespace tamis::io {

/// The answer to one step.
struct RecordedStep {
  std::vector<Contact> contacts;
  std::vector<StageCount> stages;
  /// Proven: no contact before this time. For steps whose contacts are not all listed; none: the listed contacts tell.
  std::optional<double> free_before = {};
  /// Of the frame at which the step ends; only an audit has them.
  std::vector<Intersection> intersections = {};
  /// The places of its start and its end among the frames; none: step i goes from frame i to frame i + 1.
  std::optional<std::array<std::size_t, 2>> ends = {};
  /// Pairs that touch at the start and were ignored, as Statistics::ignored.
  std::uint64_t ignored = 0;
  /// Of an audit, for the intersections, then the contacts: whether the pair is new since the frame before.
  std::vector<bool> is_new = {};
  /// Which objects have collapsed and were left out, so that nothing is proven of the step; empty if none.
  std::string collapsed = {};
};

/// The intersections of a pose.
struct RecordedPose {
  std::vector<Intersection> intersections;
  std::vector<StageCount> stages;
  std::string collapsed = {};  ///< as of a step
};

/// The numbers of all frames of an audited motion; the recording has only some of these frames.
struct RecordedStrip {
  static constexpr int kNotShown = -1;

  bool asks_intersections = true;  ///< of the frames that could be used
  std::vector<std::string> names;
  std::vector<std::string> problems;         ///< why the frame was not asked about; empty if it was
  std::vector<bool> has_step;                ///< a step that ends there was asked about
  std::vector<std::uint64_t> contacts;       ///< of the step that ends there
  std::vector<std::uint64_t> intersections;  ///< of the frame
  std::vector<std::uint64_t> fresh;          ///< of both: new since the frame before
  std::vector<bool> collapsed;               ///< an object has collapsed in the frame
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
  AtStart at_start = AtStart::report;  ///< as the steps were asked
  /// None: each connected part of the mesh is an object, without a name.
  std::optional<audit::Objects> objects = {};
};

/// The vertices at both ends of the first step, scaled as it was decided; for a pose both are the pose.
struct FirstStep {
  explicit FirstStep(const Recording& recording);

  const std::vector<Point>& start;
  std::vector<Point> end;
};

}  // namespace tamis::io
