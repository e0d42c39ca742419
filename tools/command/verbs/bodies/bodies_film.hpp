// The steps of bodies as a page to look at.
#pragma once
#include <filesystem>
#include <vector>

#include "command/verbs/bodies/moving_bodies.hpp"
#include "files/view/recording.hpp"

namespace tamis::cli {

/// Shows all bodies as one mesh.
class BodiesFilm {
 public:
  /// `bodies` must live as long.
  BodiesFilm(const MovingBodies& bodies, const Options& options, AtStart at_start);
  BodiesFilm(const BodiesFilm&) = delete;
  BodiesFilm& operator=(const BodiesFilm&) = delete;

  /// Adds the present step of the bodies. `ignored`: as Statistics::ignored.
  void add(std::size_t step, const std::vector<BodyContact>& contacts, std::uint64_t ignored);
  /// Throws io::FileError.
  void write(const std::filesystem::path& to) const;

 private:
  Contact in_one_mesh(const BodyContact& contact) const;

  const MovingBodies& bodies_;
  std::vector<Index> first_vertices_;  ///< of each body
  Options options_;
  Mesh mesh_;
  io::Recording recording_;
};

}  // namespace tamis::cli
