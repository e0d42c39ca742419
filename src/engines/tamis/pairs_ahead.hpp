// Pairs listed ahead: where a mesh goes on as it did, or is asked about the same way again, as in a line search, what
// may come near there is found once, and each of these steps asks about that alone. It decides what is looked at, never
// what the answer is.
#pragma once
#include <vector>

#include "engines/tamis/feature_trees.hpp"
#include "engines/tamis/forecast.hpp"
#include "engines/tamis/stage_pipeline.hpp"

namespace tamis {

/// Bounded memory: kMostListed pairs a leaf block of sixteen features, 24 bytes each, with room to grow to twice that;
/// and positions.
class PairsAhead {
 public:
  /// Keeps a reference.
  explicit PairsAhead(const Mesh& mesh);

  /// A new question. True: the pairs that may touch are listed, unless leaves_open() says otherwise then, and when()
  /// the question is.
  bool begin(const FoundContacts& asked);
  /// The listed pairs have been decided, and a contact may be among others: the trees must be searched.
  bool leaves_open(const FoundContacts& answered) const;
  /// Else: has the last question foreseen this one, so that lists promise to help the next ones? Then way() is to be
  /// searched for pairs that may touch before until() while every vertex is within room() of it, and they are listed by
  /// list_found(), until complete() or give_up().
  bool plan(const FoundContacts& asked);
  Step way() const { return way_.way(); }
  double room() const { return room_; }
  /// A part of the way.
  float until() const { return until_; }
  /// Where a mesh has so many leaf blocks.
  static std::int64_t most_pairs(int leaf_blocks) { return kMostListed * leaf_blocks; }
  /// What one thread has found there since the last time.
  void list_found(StagePipeline& pipeline);
  void complete() { are_listed_ = true; }
  /// There are too many.
  void give_up();
  /// This question, as part of the way.
  const TimeInterval<float>& when() const { return when_; }
  const PairList& list(PairKind kind) const { return lists_[static_cast<std::size_t>(kind)]; }
  void end(const FoundContacts& answered);
  std::uint64_t memory_bytes() const;

 private:
  static constexpr std::int64_t kMostListed = 256;

  bool plan_again(Question question, double length);
  bool plan_steps(Question question, const Forecast::Fit& fit);
  bool covers(float time) const { return until_ == 1 || time <= until_; }
  Step sample_of(const Step& step);
  /// Says when, too.
  bool is_on_way(const Step& step);
  void forget();
  void learn();
  void pause();
  double steps_to_foresee(double stray) const;

  const Mesh& mesh_;
  std::vector<Index> sample_, sample_numbers_;    ///< some vertices in use; 0, 1, ...
  std::vector<Point> sample_start_, sample_end_;  ///< where they are in a step
  Forecast next_;                                 ///< by the last question, of the sample
  Forecast way_;                                  ///< that the lists are for, of all vertices in use
  double room_ = 0;                               ///< how far vertices may stray from it
  double edge_ = 0;                               ///< mean length, when last planned
  double separation_ = 0;                         ///< in question when the lists were made
  TimeInterval<float> when_{};
  PairList lists_[kPairKinds];
  bool are_listed_ = false;
  bool starts_again_ = false;  ///< as the question before the one that planned them did
  float until_ = 1;            ///< when the lists end
  double first_ = 1;           ///< of the last question's step: no contact before; 1: none at all; below 0: not known
  double steps_;               ///< to look ahead
  double steps_listed_ = 0;
  int served_ = 0;  ///< questions, by these lists
  int pause_ = 0;   ///< questions until it is worth another try
  int next_pause_;
};

}  // namespace tamis
