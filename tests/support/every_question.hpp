// All questions that a detector answers, for tests of properties that all of them must have; and a scene that gives
// work to each.
#pragma once
#include <functional>
#include <string>
#include <vector>

#include "scenes/scene.hpp"
#include "tamis/detector.hpp"
#include "tamis/spline_path.hpp"

namespace tamis::test {

struct AnyQuestion {
  std::string name;
  /// Every number of the answer.
  std::function<std::vector<double>(Detector&)> ask;
  /// Asks without copying the answer: for measuring the question itself.
  std::function<void(Detector&)> ask_only;
  /// If false, the answer belongs to the detector, and lasts until any thread's next question.
  bool is_by_value;
};

/// `distance`: for near pairs; a tenth of it is the separation of some questions. Scene and path must outlive them.
std::vector<AnyQuestion> questions_of(const scenes::Scene& scene, double distance);
std::vector<AnyQuestion> questions_of(const Path& path, double separation);

/// Two wavy sheets of side 1, of 2 cells^2 triangles each. One slides through the other. With several threads, there is
/// work for the others while the first pairs are decided.
scenes::Scene two_sheets(Index cells);
inline double edge_of_sheets(Index cells) { return 1.0 / cells; }

/// A curved path from the scene's start to its end.
BezierPath bent_path(const scenes::Scene& scene);

}  // namespace tamis::test
