// Pairs near at the start, for a solver that truncates each of its iterations from one start. Pairs so close at the
// start that their vertices' displacements may use up the distance are listed once. Each further question decides only
// those.
#pragma once
#include <array>
#include <vector>

#include "numbers/held_bytes.hpp"
#include "search/coherence/kept_lists.hpp"

namespace tamis {

/// For questions about step lengths. Such a question finds the time until which every pair keeps a fraction of its
/// distance at the start.
class PairsNearStart final : public KeptLists {
 public:
  /// Keeps a reference.
  explicit PairsNearStart(const Mesh& mesh) : KeptLists({.first = 1}), mesh_(mesh) {}

  /// Begins a question. `lists_all`: the question wants every pair that ends the step, as a truncation does after it
  /// has one step length for all. Returns true if the lists hold all pairs that may end the step.
  bool begin(const Query& query, double fraction, bool lists_all);
  /// In a truncation, if this start will be truncated again, the pairs near at the start are worth listing.
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
  /// One a vertex, which may move by 1 - fraction of it. Pairs farther apart than both features' radii are not listed.
  std::vector<double> search_radii_;
  std::vector<double> listing_radii_;  ///< search_radii_ plus the largest contact radius among the vertex' features
  const double* radii_ = nullptr;      ///< the query's when the lists were made
  double separation_ = 0;
  double fraction_ = 0;      ///< the part of the distance that the last question wants kept
  bool lists_all_ = false;   ///< the last question wants every pair
  bool same_start_ = false;  ///< the last question has the start of the one before it
  // Lists pay from a start's second truncation on. Whether this start has had one, whether two, and whether each of the
  // last two starts had two.
  bool is_truncated_ = false, is_truncated_again_ = false;
  std::array<bool, 2> were_truncated_again_{};
};

}  // namespace tamis
