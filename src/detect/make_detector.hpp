// A detector that asks another engine than the library's own: validation, order and curved motion are the same.
#pragma once
#include <functional>

#include "engines/engine.hpp"
#include "tamis/detector.hpp"

namespace tamis {

/// Keeps references to mesh and options, which outlive the engine, as all engines do.
using MakeEngine = std::function<std::unique_ptr<Engine>(const Mesh&, const Options&)>;

class DetectorMaker {
 public:
  /// `make_engine` is called once, with what has been validated. Throws InvalidOptions.
  static Detector make(Mesh mesh, Options options, const MakeEngine& make_engine);
};

}  // namespace tamis
