// Every question that a detector answers, and a scene that gives each something to do: what must hold of all of them is
// tested on this list.
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
  /// Leaves the answer where it is: what the question itself takes.
  std::function<void(Detector&)> ask_only;
  /// False: the answer is the detector's, until the next question of whatever thread.
  bool is_by_value;
};

/// `distance`: of near pairs, and a tenth of it the separation of one question. What they are about must outlive them.
std::vector<AnyQuestion> questions_of(const scenes::Scene& scene, double distance);
std::vector<AnyQuestion> questions_of(const Path& path, double separation);

/// Two wavy sheets of 2 cells^2 triangles of side 1, of which one slides through the other. Unless one thread does all,
/// there is work for the others while the first pairs are decided.
scenes::Scene two_sheets(Index cells);
inline double edge_of_sheets(Index cells) { return 1.0 / cells; }

/// From where the scene starts to where it ends, not straight.
BezierPath bent_path(const scenes::Scene& scene);

}  // namespace tamis::test
