// What only the library says to a detector: which engine it asks, if not the library's own (validation, order and
// curved motion are the same), how a path is cut, and what else its state can be asked.
#pragma once
#include <functional>
#include <span>

#include "query/engine.hpp"
#include "tamis/detector.hpp"

namespace tamis {

/// Keeps references to mesh and options, which outlive the engine, as all engines do.
using MakeEngine = std::function<std::unique_ptr<Engine>(const Mesh&, const Options&)>;

/// Its pieces end at `ends`: ascending, the last one 1; none: as deviations ask for.
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
