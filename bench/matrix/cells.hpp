// The cells of the matrix: what is asked, of which step, in which state of the detector.
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

/// What the detector was asked before, and how often it is asked.
enum class State {
  fresh,     ///< "new": nothing before
  kept,      ///< other positions before
  line,      ///< other positions before; then eight trials of a line search, to 1, 1/2, 1/4 ... of the step
  substeps,  ///< other positions before; then the step in twenty parts
};

struct Cell {
  SceneName scene;
  double scale;  ///< of the motion
  Question question;
  State state;
  double separation;  ///< in mean edges
};

/// "scene/x3/contacts/kept/d0".
std::string name_of(const Cell& cell);

/// Triangles times (questions + steps' lengths times crowding): what decides whether a cell is asked at all.
double work_of(const Cell& cell);

/// Which cells are asked.
enum class Part {
  night,  ///< all whose work is below a limit
  daily,  ///< two of each scene and scale, of steps' and of positions' questions, so that all ways to ask come in turn
  quick,  ///< of the daily ones those that take little
};

/// By scene. Recorded scenes are among them where the data is; the others are the same everywhere.
std::vector<Cell> cells_of(Part part);
/// What even the night leaves out.
std::vector<Cell> cells_left_out();

/// Throws InvalidOptions where the night has no cell of this name.
Cell cell_from_name(const std::string& name);
/// "night", "daily" or "quick"; throws InvalidOptions.
Part part_from_name(const std::string& name);

}  // namespace tamis::matrix
