// The ordinary detector on some elements of the whole mesh. It numbers vertices anew in the order of their numbers,
// which keeps every order that an answer depends on; answers are translated back.
#pragma once
#include <optional>
#include <vector>

#include "distributed/src/partition/element_set.hpp"
#include "search/bounds/box_frame.hpp"
#include "tamis/detector.hpp"

namespace tamis::distributed {

/// A contact, and the rank to which it is sent.
struct HomedContact {
  Contact contact;
  int home;
};

class LocalSearch {
 public:
  /// Keeps a reference.
  explicit LocalSearch(const Options& options) : options_(options) {}
  LocalSearch(const LocalSearch&) = delete;
  LocalSearch& operator=(const LocalSearch&) = delete;

  /// Sets the elements to search, their motions, and the frame of the whole scene. Keeps the detector if the elements
  /// have the ids of last time.
  void assign(std::span<const ElementSet* const> sets, const BoxFrame& frame);
  /// The same for a search of pairs with a feature of `mine` and one of `others`; pairs within either may be left out.
  void assign_sides(const ElementSet& mine, const ElementSet& others, const BoxFrame& frame);
  /// To be called when ids begin to name other elements.
  void forget();
  /// From the next question on: does it count for each vertex the pairs of features whose boxes meet in which it takes
  /// part?
  void count_pairs(bool counts);

  bool empty() const { return set_.empty(); }
  std::vector<HomedContact> contacts(const QueryOptions& asked);
  EarliestContact earliest(const QueryOptions& asked);
  bool is_free(const QueryOptions& asked);
  SafeStep safe_step(double keep, const QueryOptions& asked);

  /// The number of pairs of features whose boxes met in the last question.
  std::uint64_t pairs_tested() const;
  /// For each element of `part` 1 plus the counted pairs of its corners. REQUIRES: count_pairs.
  std::vector<std::uint64_t> weights_of(const ElementSet& part) const;

 private:
  void make_detector();
  Options local_options();
  bool is_wanted(PairKind kind, const std::array<Index, 4>& vertices);
  bool is_within_a_side(const std::array<Index, 4>& vertices) const;
  void count(const std::array<Index, 4>& vertices);
  bool accepts(PairKind kind, std::array<Index, 4> vertices) const;
  void translate(std::array<Index, 4>& vertices) const;
  Step step() const { return {start_, end_}; }

  const Options& options_;
  std::vector<ElementId> ids_;
  ElementSet set_;
  std::vector<Point> start_, end_;
  std::optional<tamis::Detector> detector_;
  std::vector<std::uint8_t> side_;  ///< for each vertex, one bit a side; empty if sides do not matter
  bool counts_pairs_ = false;
  std::vector<std::uint64_t> pairs_of_vertex_;
};

}  // namespace tamis::distributed
