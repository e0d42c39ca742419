// The bodies of a file, as a world that goes from one frame to the next.
#pragma once
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "command/collapse_check.hpp"
#include "command/verbs/moving_frames.hpp"
#include "files/bodies/bodies_file.hpp"
#include "tamis/world.hpp"

namespace tamis::cli {

class MovingBodies {
 public:
  /// Begins at step 1. Prints the notes of its meshes on stderr. Throws io::FileError.
  explicit MovingBodies(const std::filesystem::path& path);

  std::size_t step_count() const { return file_.frame_count - 1; }
  std::size_t count() const { return names_.size(); }
  std::size_t count_of(bool moves, bool deforms) const;
  std::size_t triangle_count() const;
  /// By the bodies' numbers in the world, as all functions below.
  const std::vector<std::string>& names() const { return names_; }
  const io::MeshFile& mesh_of(std::size_t body) const;
  const BodyMotion& motion_of(std::size_t body) const { return motions_[body]; }
  /// Every file that was, or will be read.
  std::vector<std::filesystem::path> inputs() const;

  /// A world whose bodies make the present step.
  World world(const Options& options) const;
  /// Moves the bodies of `world` on to the next step. Reads frames: throws io::FileError.
  void go_on(World& world);
  /// Leaves deforming bodies in which an object has collapsed out of the world's answers to the present step, and takes
  /// the others in. Notes on stderr which.
  void leave_out_collapsed(World& world);
  /// Was a body left out of the present step? Then nothing is proven of it.
  bool leaves_out() const { return leaves_out_; }

 private:
  /// The body's motion in the present step. `start`: where a deforming body is at t=0.
  BodyMotion motion_from(std::size_t body, std::vector<Point> start) const;

  std::filesystem::path path_;
  io::BodiesFile file_;
  std::vector<std::string> names_;
  std::map<std::size_t, MovingFrames> frames_;  ///< of deforming bodies, as the next two
  std::map<std::size_t, Mesh> meshes_;
  std::map<std::size_t, CollapseCheck> collapse_;
  bool leaves_out_ = false;
  std::size_t step_ = 1;
  std::vector<BodyMotion> motions_;
};

}  // namespace tamis::cli
