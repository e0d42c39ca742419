// A simulation as frames in a folder; interrupted at any time, it goes on where it was.
#pragma once
#include <filesystem>
#include <functional>

#include "scenes/simulation/scenes.hpp"
#include "scenes/simulation/simulator.hpp"

namespace tamis::simulation {

struct Recording {
  std::filesystem::path folder;
  int frames;       ///< after frame 0, the start
  Index triangles;  ///< about
  std::uint64_t seed;
};

/// Called after every frame that was made, with the simulator as it stands.
using FrameMade = std::function<void(const Simulator&)>;

/// Writes frame_0000.ply (binary, doubles) to frame_<frames>.ply, and beside them the state from which the same
/// command goes on, bit for bit as if it had never stopped. Throws Error if the folder holds another run.
void record(const SimulatedScene& scene, const Recording& recording, const FrameMade& made);

std::filesystem::path frame_path(const std::filesystem::path& folder, int frame);

}  // namespace tamis::simulation
