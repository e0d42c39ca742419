// The bodies of a file, as a world that goes from one frame to the next.
#pragma once
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "cli/verbs/moving_frames.hpp"
#include "io/bodies/bodies_file.hpp"
#include "tamis/world.hpp"

namespace tamis::cli {

class MovingBodies {
 public:
  /// Says on stderr what readers of its meshes should know. Throws io::FileError.
  explicit MovingBodies(const std::filesystem::path& path);

  std::size_t step_count() const { return file_.frame_count - 1; }
  /// By their numbers in the world.
  const std::vector<std::string>& names() const { return names_; }
  /// Every file that was, or will be read.
  std::vector<std::filesystem::path> inputs() const;
  std::size_t count_of(bool moves, bool deforms) const;
  std::size_t triangle_count() const;

  /// A world that makes step 1.
  World world(const Options& options);
  /// REQUIRES: steps are asked for in order. Reads frames: throws io::FileError.
  void go_on(World& world, std::size_t step);

 private:
  BodyMotion motion_of(std::size_t body, std::size_t step);
  std::size_t triangles_of(std::size_t body) const;

  std::filesystem::path path_;
  io::BodiesFile file_;
  std::vector<std::string> names_;
  struct Deforming {
    MovingFrames frames;
    std::vector<Point> last;  ///< where the step before ended
  };
  std::map<std::size_t, Deforming> deforming_;  ///< by body
};

}  // namespace tamis::cli
