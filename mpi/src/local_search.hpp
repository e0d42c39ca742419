// The ordinary detector on some elements of the whole mesh: vertices are numbered anew in the order of their numbers,
// which keeps every order that an answer depends on, and answers are translated back.
#pragma once
#include <optional>
#include <vector>

#include "mpi/src/partition/element_set.hpp"
#include "tamis/detector.hpp"

namespace tamis::distributed {

/// And the rank to which it goes.
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

  /// What to search, with its motions. Keeps the detector where elements have the ids of last time.
  void assign(std::span<const ElementSet* const> sets);
  /// The same, of pairs with a feature of `mine` and one of `others`; pairs within either may be left out.
  void assign_sides(const ElementSet& mine, std::span<const ElementSet* const> others);
  /// Ids mean other elements from now on.
  void forget();
  /// From the next question on: in how many pairs whose boxes meet each vertex takes part.
  void count_pairs(bool counts);

  bool empty() const { return set_.empty(); }
  std::vector<HomedContact> contacts(const QueryOptions& asked);
  EarliestContact earliest(const QueryOptions& asked);
  bool is_free(const QueryOptions& asked);
  SafeStep safe_step(double keep, const QueryOptions& asked);

  /// Pairs of features whose boxes meet, in the last question.
  std::uint64_t pairs_tested() const;
  /// Of the elements at these vertices: pairs in which their corners take part, each at least 1. REQUIRES: count_pairs.
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
  std::vector<std::uint8_t> side_;  ///< of each vertex, a bit each; empty: sides do not matter
  bool counts_pairs_ = false;
  std::vector<std::uint64_t> pairs_of_vertex_;
};

}  // namespace tamis::distributed
