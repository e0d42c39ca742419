// What only the library says to a detector: which engine it asks, if not the library's own (validation, order and
// curved motion are the same), how a path is cut, and that answers must not depend on what else the mesh holds.
#pragma once
#include <functional>
#include <vector>

#include "query/engine.hpp"
#include "tamis/detector.hpp"

namespace tamis {

/// Keeps references to mesh and options, which outlive the engine, as all engines do.
using MakeEngine = std::function<std::unique_ptr<Engine>(const Mesh&, const Options&)>;

/// The pieces end at `ends`: ascending, the last one 1.
struct CutPath {
  const Path& path;
  std::span<const double> ends;
};

class DetectorAccess {
 public:
  /// `make_engine` is called once, with what has been validated. Throws InvalidOptions.
  static Detector make(Mesh mesh, Options options, const MakeEngine& make_engine);
  /// With a radius for each vertex in place of one for each group, so that radii make no groups. Throws as above.
  /// REQUIRES: the options have no radii; as many as vertices. REQUIRES (not checked: O(n)): finite and >= 0.
  static Detector make(Mesh mesh, Options options, std::vector<double> radius_of_vertex);
  /// All contacts, each with the bits of narrow_phase.
  static const std::vector<Contact>& contacts_by_pair(Detector& detector, const Step& step,
                                                      const QueryOptions& options);
  /// All intersections, or with is_free one if there is any, each with the bits of its pair alone, and of pairs that
  /// `accepts` of the options' filter leaves: it is asked of a vertex of the edge and the face.
  static const std::vector<Intersection>& intersections_by_pair(Detector& detector, const Positions& positions,
                                                                Question question);
  /// As Detector's `contacts`, `earliest` and `is_free` of a path.
  static const std::vector<Contact>& ask(Detector& detector, const CutPath& path, const QueryOptions& options,
                                         Question question);
  /// As Detector::safe_step of a path.
  static SafeStep safe_step(Detector& detector, const CutPath& path, double keep, const QueryOptions& options);
};

}  // namespace tamis
