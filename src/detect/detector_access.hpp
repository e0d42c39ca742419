// The library's own access to a detector: to make one with another engine (validation, order and curved motion are the
// same), to cut a path at given times, and to ask its state.
#pragma once
#include <functional>
#include <span>

#include "query/engine.hpp"
#include "tamis/detector.hpp"

namespace tamis {

/// Keeps references to mesh and options, which outlive the engine, as all engines do.
using MakeEngine = std::function<std::unique_ptr<Engine>(const Mesh&, const Options&)>;

/// A path, and the ends of its pieces: ascending, the last one 1; empty: as deviations ask for.
struct CutPath {
  const Path& path;
  std::span<const double> ends = {};
};

class DetectorAccess {
 public:
  /// `make_engine` is called once, with what has been validated. Throws InvalidOptions.
  static Detector make(Mesh mesh, Options options, const MakeEngine& make_engine);
  /// For one question that is asked of the state itself (detect/detector_state.hpp). Throws Busy.
  static Detector::LockedState lock(const Detector& detector);
};

}  // namespace tamis
