// The scene reduced-sheet with its reduced model.
#pragma once
#include <memory>

#include "paper/reduced_model.hpp"
#include "scenes/reduced_scene.hpp"

namespace tamis::lab {

struct ReducedScene : scenes::ReducedScene {
  std::shared_ptr<const ReducedModel> model;
};

/// As scenes::reduced_sheet.
inline ReducedScene reduced_sheet(Index triangles, std::uint64_t seed, double length) {
  ReducedScene result{scenes::reduced_sheet(triangles, seed, length), nullptr};
  result.model = std::make_shared<const ReducedModel>(ReducedModel{result.rest, result.modes, result.basis});
  return result;
}

}  // namespace tamis::lab
