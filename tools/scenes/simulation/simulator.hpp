// How to put Tamis in a simulator: contacts near the predicted path become constraints; no step is kept before
// Tamis has proven that its path is free.
#pragma once
#include <vector>

#include "scenes/simulation/model.hpp"
#include "scenes/simulation/touch.hpp"
#include "tamis/detector.hpp"

namespace tamis::simulation {

/// What the last frame took.
struct Effort {
  int substeps = 0;
  std::uint64_t touches = 0;        ///< contact constraints, over all substeps
  std::uint64_t repairs = 0;        ///< rounds in which contacts of a failed proof became constraints
  std::uint64_t zone_vertices = 0;  ///< vertices that had to move with an impact zone

  Effort& operator+=(const Effort& other);
};

/// XPBD (Macklin, Mueller, Chentanez 2016) in small steps. Deterministic.
class Simulator {
 public:
  /// Throws Error if the model's surfaces touch or pass through each other at the start.
  explicit Simulator(Model model);

  /// Simulates the next frame. Throws Error if bodies are caught between obstacles that leave them no room.
  void advance();

  const Model& model() const { return model_; }
  const Particles& particles() const { return model_.particles; }
  int frame() const { return frame_; }
  const Effort& effort() const { return effort_; }
  /// Goes on from a frame reached earlier; positions and velocities of all particles.
  void resume(int frame, Points position, Points velocity);

 private:
  bool try_substep(double time, double dt);
  void predict(double time, double dt);
  /// Pairs that come closer than the thickness on the predicted path, except pairs that were closer at the very start.
  std::vector<Touch> touches_near_path();
  void solve(const std::vector<Touch>& touches, double dt);
  /// True: the path from `start_` is proven free.
  bool make_free(std::vector<Touch>& touches, double time, double dt);
  bool move_in_zones(double time, double dt);
  Step step() const;
  void project_touches(const std::vector<Touch>& touches);

  Model model_;
  Detector near_;   ///< contact at the thickness
  Detector proof_;  ///< contact at distance zero
  std::vector<Contact> near_at_start_;
  std::vector<Index> body_of_vertex_;  ///< the obstacle that moves it; one past the last for pinned vertices; or -1
  Points start_;
  int frame_ = 0;
  Effort effort_;
};

}  // namespace tamis::simulation
