// What only the library says to a detector: which engine it asks, if not the library's own (validation, order and
// curved motion are the same), and how a path is cut.
#pragma once
#include <functional>

#include "query/engine.hpp"
#include "tamis/detector.hpp"

namespace tamis {

/// Keeps references to mesh and options, which outlive the engine, as all engines do.
using MakeEngine = std::function<std::unique_ptr<Engine>(const Mesh&, const Options&)>;

class DetectorMaker {
 public:
  /// `make_engine` is called once, with what has been validated. Throws InvalidOptions.
  static Detector make(Mesh mesh, Options options, const MakeEngine& make_engine);
  /// All contacts, each with the bits of narrow_phase.
  static const std::vector<Contact>& contacts_by_pair(Detector& detector, const Step& step,
                                                      const QueryOptions& options);
  /// The contacts that Detector finds on a path, of which the pieces end at `ends`: ascending, the last one 1.
  static const std::vector<Contact>& ask(Detector& detector, const Path& path, const QueryOptions& options,
                                         Question question, std::span<const double> ends);
  /// The same of Detector::safe_step.
  static SafeStep safe_step(Detector& detector, const Path& path, double keep, const QueryOptions& options,
                            std::span<const double> ends);
};

}  // namespace tamis
