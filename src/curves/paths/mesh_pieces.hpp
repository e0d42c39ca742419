// The pieces of a mesh's path. Each has the vertices at both ends, and their deviations from straight motion between.
#pragma once
#include <span>
#include <vector>

#include "curves/paths/mesh_moment.hpp"
#include "tamis/path.hpp"

namespace tamis {

/// How far all but a few vertices may deviate on the first piece, in mean fine edges, or in separations if these are
/// longer. MeshPieces::adapt_length changes it for later pieces. Longer pieces leave more pairs to be decided on parts
/// of them. Shorter ones search the whole mesh more often.
inline constexpr double kChordDeviationInEdges = 0x1p-6;
/// If bounds go by the square of a piece's length, a vertex is no farther from its shifted chord (ShiftedChords) than
/// this part of its bound on the piece.
inline constexpr double kShiftedChordPart = 0.75;
/// While pieces leave few pairs, the next ones grow up to this deviation, in the same unit.
inline constexpr double kMostChordDeviationInEdges = 0.25;

/// Straight motions that stand for the curves on a piece: chords, shifted half way to the path's position in the middle
/// of the piece. `deviations`: no vertex is farther from its shifted chord.
struct ShiftedChords {
  std::vector<Point> start, end;
  std::vector<double> deviations;
};

/// The pieces of one question. Throws InvalidPath if the path breaks its promises.
class MeshPieces {
 public:
  /// Keeps references. `ends`: of the pieces, ascending, the last one 1. If empty, deviations determine them, beside
  /// edges and `separation`.
  MeshPieces(const Mesh& mesh, const Path& path, std::span<const double> ends, double separation);

  MeshMoment moment_at(double time) const;
  /// Returns the end of the piece that begins at `from`, and sets chords() for this piece. Checks the path's bounds in
  /// the middle of the piece.
  MeshMoment next(const MeshMoment& from);
  const ShiftedChords& chords() const { return chords_; }
  /// Adapts the length of the next piece to the number of pairs that the last one left undecided.
  void adapt_length(std::size_t pairs);
  /// For each vertex an upper bound of its distance from its start, from `start`, at 0, until the time of `to`; 0 for
  /// vertices that take no part.
  std::vector<double> displacements(const MeshMoment& start, const MeshMoment& to) const;

 private:
  /// The path's deviations between two times, checked.
  std::vector<double> deviations(double from, double to) const;
  /// For each vertex the larger of its deviations on both halves. Infinite if no double lies between `from` and `to`.
  std::vector<double> half_deviations(double from, double middle, double to) const;
  double end_of(const MeshMoment& start) const;
  /// The vector from the chord's middle to the path's position there. Off by at most `error`.
  struct ChordOffset {
    Point offset;
    double error;
  };
  ChordOffset chord_offset(std::size_t v, const MeshMoment& from, const MeshMoment& middle, const MeshMoment& to) const;
  /// Sets chords_. Throws if a vertex is farther from its chord in the middle than its bound promises.
  void shift_chords(const MeshMoment& from, const MeshMoment& to);

  const Mesh& mesh_;
  const Path& path_;
  const std::span<const double> ends_;
  const double separation_;
  const std::vector<Index> all_;  ///< 0, 1, 2, ...
  ShiftedChords chords_;
  double deviation_in_units_ = kChordDeviationInEdges;  ///< allowed on the next piece
};

}  // namespace tamis
