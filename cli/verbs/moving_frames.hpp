// The frames of a sequence, one after the other.
#pragma once
#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "io/mesh/mesh_file.hpp"

namespace tamis::cli {

/// What is said where io::has_own_order().
inline constexpr const char* kNaturalOrder =
    "frames are taken in natural order, not as they are given: name two at a time for an order of your own";

class MovingFrames {
 public:
  /// Files, folders and patterns, in natural order; two files stay in the order in which they are given. Reads the
  /// first. Throws io::FileError if there are fewer than `least`.
  explicit MovingFrames(const std::vector<std::string>& names, std::size_t least = 2);

  const std::vector<std::filesystem::path>& paths() const { return paths_; }
  const io::MeshFile& first() const { return first_; }
  /// Reads frame i. Prints its notes on stderr, except those that the first frame has, too. Throws
  /// io::FileError unless it has the topology of the first.
  std::vector<Point> read(std::size_t i) const;

 private:
  std::vector<std::filesystem::path> paths_;
  io::MeshFile first_;
};

}  // namespace tamis::cli
