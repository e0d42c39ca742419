// The vertices of a mesh on a path, piece by piece: where they are at both ends of a piece, and how far they deviate
// from their chords in between.
#pragma once
#include <span>
#include <vector>

#include "paths/frame.hpp"
#include "paths/remembered_path.hpp"

namespace tamis {

/// On a piece no vertex deviates from its chord by more than this part of the mean edge. Longer pieces would leave more
/// pairs to be looked at on parts of them, shorter ones search the whole mesh more often.
inline constexpr double kChordDeviationInEdges = 0x1p-6;
/// Where pieces leave few pairs the next ones are longer, up to this part.
inline constexpr double kMostChordDeviationInEdges = 1;

/// Of one question. Throws InvalidPath where the path breaks its promises.
class MeshPieces {
 public:
  /// Keeps references. `ends`: of the pieces, ascending, the last one 1; empty: as deviations ask for.
  MeshPieces(const Mesh& mesh, const Path& path, std::span<const double> ends);

  Frame frame_at(double time) const;
  /// The end of the piece that begins so. deviations() are then of this piece, and were checked in its middle.
  Frame next(const Frame& from);
  /// Of every vertex from its chord, at most.
  const std::vector<double>& deviations() const { return deviations_; }
  /// Sets the length of the next piece by the number of pairs that the last one left undecided.
  void learn(std::size_t pairs);
  /// How far any vertex is from its start at most, at any time. deviations() are then of the whole path.
  double farthest_way();

 private:
  /// Between two times. Returns the largest.
  double read_deviations(double from, double to);
  double end_of(const Frame& start);
  void check_chords(const Frame& from, const Frame& to) const;

  const Mesh& mesh_;
  const IsolatedPath path_;
  const std::span<const double> ends_;
  const std::vector<Index> all_;  ///< 0, 1, 2, ...
  std::vector<double> deviations_;
  double deviation_in_edges_ = kChordDeviationInEdges;  ///< of the next piece
};

}  // namespace tamis
