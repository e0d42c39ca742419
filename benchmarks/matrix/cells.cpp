#include "matrix/cells.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <span>

#include "matrix/versions.hpp"
#include "tamis/detector.hpp"
#include "tamis/error.hpp"

namespace tamis::matrix {
namespace {

constexpr std::array kScales{0.01, 0.1, 1., 3., 10., 30.};
constexpr std::array kQuestions{"contacts", "earliest", "free", "keep", "three", "truncate", "within", "intersections"};
constexpr std::array kStates{"new", "kept", "line", "substeps"};
constexpr std::array kSeparations{0., 0.001, 0.1};
constexpr std::array kParts{"night", "daily", "quick"};

// A part leaves out the cells whose work exceeds its limit. A unit of work takes about a microsecond.
constexpr std::array kMostWork{7e6, 2.5e6, 2.5e5};

/// The questions of a state, the one about other positions included: their number, and their total length in steps.
struct Asked {
  double questions, steps;
};
constexpr std::array kAsked{Asked{1, 1}, Asked{2, 2}, Asked{9, 3}, Asked{21, 2}};
constexpr Asked kAskedThrice{6, 6};

constexpr std::array kAllStates{State::fresh, State::kept, State::line, State::substeps};

void add_ways(const Cell& cell, std::initializer_list<Question> questions, std::vector<Cell>& ways) {
  for (const auto question : questions)
    for (const auto state : kAllStates) ways.push_back({cell.scene, cell.scale, question, state, cell.separation});
}

std::span<const double> separations_of(const SceneName& scene) {
  return std::span(kSeparations).first(scene.is_of_two_sizes ? 1 : kSeparations.size());
}

/// All ways to ask about the contacts of a step, in a fixed order.
std::vector<Cell> ways_to_ask_step(const SceneName& scene, double scale) {
  std::vector<Cell> ways;
  for (const double separation : separations_of(scene)) {
    const Cell three{scene, scale, Question::three, State::kept, separation};
    add_ways(three, {Question::contacts, Question::earliest, Question::free, Question::keep}, ways);
    ways.push_back(three);
  }
  return ways;
}

/// All ways to ask about positions, or for truncated ones. Intersections have no separation, and trials of a line
/// search do not ask for them.
std::vector<Cell> ways_to_ask_positions(const SceneName& scene, double scale) {
  std::vector<Cell> ways;
  for (const double separation : separations_of(scene))
    add_ways({scene, scale, {}, {}, separation}, {Question::truncate, Question::within}, ways);
  for (const auto state : {State::fresh, State::kept, State::substeps})
    ways.push_back({scene, scale, Question::intersections, state, 0});
  return ways;
}

bool is_asked(const Cell& cell, Part part) { return work_of(cell) <= kMostWork[static_cast<std::size_t>(part)]; }

/// Calls visit(ways, number of the step) for each step of the matrix: first with the ways to ask about the step, then
/// with those to ask about positions.
template <class Visit>
void for_each_step(const Visit& visit) {
  std::size_t number = 0;
  for (const SceneName& scene : scene_names()) {
    for (const double scale : kScales) {
      visit(ways_to_ask_step(scene, scale), number);
      if constexpr (AsksPositions<Detector>) visit(ways_to_ask_positions(scene, scale), number);
      ++number;
    }
    ++number;  // seven numbers a scene, but six scales: so the ways come in turn at each scale, too
  }
}

/// Adds the way to ask that the step's number selects, or the next one that is not left out. The stride has no common
/// divisor with the number of ways, so that all ways come in turn.
void add_daily(const std::vector<Cell>& ways, std::size_t number, std::vector<Cell>& cells) {
  constexpr std::size_t kStride = 20;
  for (std::size_t i = 0; i < ways.size(); ++i) {
    const Cell& cell = ways[(number + i) * kStride % ways.size()];
    if (is_asked(cell, Part::daily)) return cells.push_back(cell);
  }
}

}  // namespace

std::string name_of(const Cell& cell) {
  return fmt::format("{}/x{}/{}/{}/d{}", cell.scene.name, cell.scale,
                     kQuestions[static_cast<std::size_t>(cell.question)], kStates[static_cast<std::size_t>(cell.state)],
                     cell.separation);
}

double work_of(const Cell& cell) {
  const Asked& asked = cell.question == Question::three ? kAskedThrice : kAsked[static_cast<std::size_t>(cell.state)];
  return cell.scene.triangles * (asked.questions + asked.steps * cell.scale * cell.scene.crowding);
}

std::vector<Cell> cells_of(Part part) {
  std::vector<Cell> cells;
  for_each_step([&](const std::vector<Cell>& ways, std::size_t number) {
    if (!ways.front().scene.is_here) return;
    if (part != Part::night) return add_daily(ways, number, cells);
    std::copy_if(ways.begin(), ways.end(), std::back_inserter(cells),
                 [](const Cell& cell) { return is_asked(cell, Part::night); });
  });
  std::erase_if(cells, [&](const Cell& cell) { return !is_asked(cell, part); });
  return cells;
}

std::vector<Cell> cells_left_out() {
  std::vector<Cell> cells;
  for_each_step([&](const std::vector<Cell>& ways, std::size_t) {
    std::copy_if(ways.begin(), ways.end(), std::back_inserter(cells),
                 [](const Cell& cell) { return cell.scene.is_here && !is_asked(cell, Part::night); });
  });
  return cells;
}

Cell cell_from_name(const std::string& name) {
  static const std::map<std::string, Cell> cells = [] {
    std::map<std::string, Cell> by_name;
    for (const Cell& cell : cells_of(Part::night)) by_name.emplace(name_of(cell), cell);
    return by_name;
  }();
  const auto found = cells.find(name);
  if (found == cells.end())
    throw InvalidOptions(fmt::format("there is no cell '{}': tamis_matrix --list names all of them", name));
  return found->second;
}

Part part_from_name(const std::string& name) {
  const auto found = std::find(kParts.begin(), kParts.end(), name);
  if (found == kParts.end()) throw InvalidOptions(fmt::format("there is no part '{}': night, daily or quick", name));
  return static_cast<Part>(found - kParts.begin());
}

}  // namespace tamis::matrix
