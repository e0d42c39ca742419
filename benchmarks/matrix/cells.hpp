// The cells of the matrix: a question, the step it is about, and the state of the detector.
#pragma once
#include <string>
#include <vector>

#include "matrix/scenes.hpp"

namespace tamis::matrix {

enum class Question {
  contacts,
  earliest,
  free,
  keep,
  three,  ///< contacts, earliest, free, one after the other
  truncate,
  within,         ///< of the positions at the end, within the separation
  intersections,  ///< of the positions at the end
};

/// The questions that the detector was asked before, and how often it is asked now.
enum class State {
  fresh,     ///< "new": nothing before
  kept,      ///< about other positions before
  line,      ///< about other positions before; then eight trials of a line search, to 1, 1/2, 1/4 ... of the step
  substeps,  ///< about other positions before; then the step in twenty parts
};

struct Cell {
  SceneName scene;
  double scale;  ///< factor of the motion
  Question question;
  State state;
  double separation;  ///< in mean edges
};

/// "scene/x3/contacts/kept/d0".
std::string name_of(const Cell& cell);

/// Triangles times (questions + steps' lengths times crowding). Decides whether a cell is asked at all.
double work_of(const Cell& cell);

/// Which cells are asked.
enum class Part {
  night,  ///< all cells whose work is below a limit
  daily,  ///< one about the step and one about positions for each scene and scale: all ways to ask come in turn
  quick,  ///< the daily cells that take little work
};

/// The cells of a part, scene by scene. Recorded scenes are among them if their data is here; the others always are.
std::vector<Cell> cells_of(Part part);
/// The cells that even the night leaves out.
std::vector<Cell> cells_left_out();

/// Throws InvalidOptions if the night has no cell of this name.
Cell cell_from_name(const std::string& name);
/// "night", "daily" or "quick"; throws InvalidOptions.
Part part_from_name(const std::string& name);

}  // namespace tamis::matrix
