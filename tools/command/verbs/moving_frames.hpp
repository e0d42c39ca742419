// The frames of a sequence, one after the other.
#pragma once
#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "files/mesh/mesh_file.hpp"
#include "files/mesh/weld.hpp"

namespace tamis::cli {

/// What is said where io::has_own_order().
inline constexpr const char* kNaturalOrder =
    "frames are taken in natural order, not as they are given: name two at a time for an order of your own";

class MovingFrames {
 public:
  /// Files, folders and patterns, in natural order; two files stay in the order in which they are given. Reads the
  /// first; with a distance to weld, all. Throws io::FileError if there are fewer than `least`.
  explicit MovingFrames(const std::vector<std::string>& names, std::size_t least = 2,
                        std::optional<double> weld_distance = {});

  const std::vector<std::filesystem::path>& paths() const { return paths_; }
  const io::MeshFile& first() const { return first_; }
  /// Does a step lead from the frame before to frame i? Not if frames are missing between their numbers.
  bool follows(std::size_t i) const { return gaps_[i].empty(); }
  /// How many steps lead from a frame to the next.
  std::size_t step_count() const;
  /// Notes on stderr which steps are left out.
  void note_gaps() const;
  /// For callers who cannot leave out a step. Throws io::FileError if frames are missing.
  void require_no_gap() const;
  /// Reads frame i. Prints its notes on stderr, except those that the first frame has, too. Throws
  /// io::FileError unless it has the topology of the first.
  std::vector<Point> read(std::size_t i) const;

 private:
  void note_order(const std::vector<std::string>& names) const;
  void weld_all(double distance);

  std::vector<std::filesystem::path> paths_;
  std::vector<std::string> gaps_;  ///< for each path a sentence on frames that are missing before it, or empty
  io::MeshFile first_;
  std::optional<io::Weld> weld_;
};

}  // namespace tamis::cli
