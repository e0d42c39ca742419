// The vertices of a mesh on a path, piece by piece: where they are at both ends of a piece, and how far they deviate
// from their chords in between.
#pragma once
#include <span>
#include <vector>

#include "paths/frame.hpp"
#include "tamis/path.hpp"

namespace tamis {

/// How far vertices may deviate on the first piece, as a part of the mean edge (MeshPieces::learn changes it). Longer
/// pieces would leave more pairs to be looked at on parts of them, shorter ones search the whole mesh more often.
inline constexpr double kChordDeviationInEdges = 0x1p-6;
/// Of a vertex' bound on a piece, where that goes by the square of its length: how far it is at most from the chord
/// moved half way to where it is in the middle (MeshPieces::lines).
inline constexpr double kPartBesideLine = 0.75;
/// Where pieces leave few pairs the next ones are longer, up to this part.
inline constexpr double kMostChordDeviationInEdges = 1;

/// Straight ways that stand for the curves on a piece, and how far each vertex is from its own at most.
struct Lines {
  std::vector<Point> start, end;
  std::vector<double> deviations;
};

/// Of one question. Throws InvalidPath where the path breaks its promises.
class MeshPieces {
 public:
  /// Keeps references. `ends`: of the pieces, ascending, the last one 1; empty: as deviations ask for.
  MeshPieces(const Mesh& mesh, const Path& path, std::span<const double> ends);

  Frame frame_at(double time) const;
  /// The end of the piece that begins so. lines() are then of this piece, whose bounds were checked in its middle.
  Frame next(const Frame& from);
  const Lines& lines() const { return lines_; }
  /// Sets the length of the next piece by the number of pairs that the last one left undecided.
  void learn(std::size_t pairs);
  /// How far any vertex is from its start at most, at any time.
  double farthest_way();

 private:
  /// Deviations between two times, checked. Returns the largest.
  double read(double from, double to, std::vector<double>& deviations) const;
  double end_of(const Frame& start);
  /// What the path is off its chord in the middle of a piece, known to `error`.
  struct Beside {
    Point off;
    double error;
  };
  Beside beside_chord(std::size_t v, const Frame& from, const Frame& middle, const Frame& to) const;
  /// Throws if a vertex is farther from its chord in the middle than its bound promises.
  void set_lines(const Frame& from, const Frame& to);
  void read_halves(double from, double middle, double to);

  const Mesh& mesh_;
  const Path& path_;
  const std::span<const double> ends_;
  const std::vector<Index> all_;    ///< 0, 1, 2, ...
  std::vector<double> deviations_;  ///< from chords, at most
  std::vector<double> of_halves_;   ///< the same on either half of a piece
  Lines lines_;
  double deviation_in_edges_ = kChordDeviationInEdges;  ///< of the next piece
};

}  // namespace tamis
