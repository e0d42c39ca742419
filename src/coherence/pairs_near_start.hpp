// Pairs near at the start: a solver that truncates each of its iterations asks about one start again and again. Pairs
// so close at the start that their vertices' displacements may use up the distance are listed once, and each further
// question decides only those.
#pragma once
#include <array>
#include <vector>

#include "coherence/kept_lists.hpp"
#include "numerics/held_bytes.hpp"

namespace tamis {

/// For questions about step lengths: until when does every pair keep a fraction of its distance at the start?
class PairsNearStart final : public KeptLists {
 public:
  /// Keeps a reference.
  explicit PairsNearStart(const Mesh& mesh) : KeptLists({.first = 1}), mesh_(mesh) {}

  /// Begins a question; `lists_all`: for every pair that ends the step, which a truncation asks after one for a step
  /// for all. Returns true if the lists hold all pairs that may.
  bool begin(const Query& query, double fraction, bool lists_all);
  /// In a truncation lists are worth making if this start will be truncated again: of pairs that are near there.
  std::optional<Listing> plan(const Query& query) override;
  void end_listing(bool is_complete) override;
  std::uint64_t memory_bytes() const {
    return held_bytes(lists_, start_, displacements_, previous_displacements_, search_radii_, listing_radii_);
  }

 private:
  bool has_same_start(const Step& step) const;
  void start_anew(const Step& step);
  bool covers(const Query& query) const;
  double mean_displacement() const;

  const Mesh& mesh_;
  std::vector<Point> start_;  ///< of the last question
  /// The largest displacement of each vertex from this start (in all questions but the first) and from the start
  /// before.
  std::vector<double> displacements_, previous_displacements_;
  /// Of each vertex: pairs farther apart than both radii are not listed. It may move by (1 - fraction) of it.
  std::vector<double> search_radii_;
  std::vector<double> listing_radii_;  ///< search_radii_ plus the largest contact radius among the vertex' features
  const double* radii_ = nullptr;      ///< the query's when the lists were made
  double separation_ = 0;
  double fraction_ = 0;      ///< of the distance that is to be kept, as the last question asks
  bool lists_all_ = false;   ///< it asks for every pair
  bool same_start_ = false;  ///< the last question has the start of the one before it
  // Lists pay from the second truncation of a start on: is there one from this start, and was there from the last two?
  bool is_truncated_ = false, is_truncated_again_ = false;
  std::array<bool, 2> were_truncated_again_{};
};

}  // namespace tamis
