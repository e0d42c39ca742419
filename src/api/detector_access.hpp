// The library's own access to a detector. It makes one with another engine (validation, order and curved motion are the
// same), cuts a path at given times, and reaches a detector's state.
#pragma once
#include <functional>
#include <span>

#include "search/bounds/box_frame.hpp"
#include "search/query/engine.hpp"
#include "tamis/detector.hpp"

namespace tamis {

/// Makes an engine, which keeps references to mesh and options. Both outlive the engine.
using MakeEngine = std::function<std::unique_ptr<Engine>(const Mesh&, const Options&)>;

/// A path, and the ends of its pieces: ascending, the last one 1. If empty, deviations determine them.
struct CutPath {
  const Path& path;
  std::span<const double> ends = {};
};

class DetectorAccess {
 public:
  /// Calls `make_engine` once, with the mesh and validated options. Throws InvalidOptions.
  static Detector make(Mesh mesh, Options options, const MakeEngine& make_engine);
  /// Locks the state for one question to the state itself (api/detector_state.hpp). Throws Busy.
  static Detector::LockedState lock(const Detector& detector);
  /// For a mesh that is a part of a larger scene: gives the next questions about a step that scene's frame. Throws
  /// Busy. REQUIRES (not checked: O(n)): it was made of that step, and of vertices that include the mesh's.
  static void use_frame(Detector& detector, const BoxFrame& of_scene);
};

}  // namespace tamis
