// Pairs listed ahead: where a mesh goes on as it did, what may come near within the next steps is found once, and each
// of these steps asks about that alone. It decides what is looked at, never what the answer is.
#pragma once
#include <vector>

#include "engines/tamis/feature_trees.hpp"
#include "engines/tamis/forecast.hpp"
#include "engines/tamis/stage_pipeline.hpp"

namespace tamis {

/// Bounded memory: at most twice kMostListed pairs a leaf block of sixteen features, 24 bytes each, and positions. For
/// exact answers alone: which pairs doubles leave unresolved may not depend on what was listed.
class PairsAhead {
 public:
  /// Keeps references.
  PairsAhead(const Mesh& mesh, const Options& options);

  /// A new question. True: all pairs that may touch are listed.
  bool covers(const FoundContacts& asked);
  /// Else: did the last question foresee this one, so that looking ahead promises to help the next ones? Then way() is
  /// to be searched for what may touch though no vertex is farther than room() from there.
  bool promises(const FoundContacts& asked);
  Step way() const { return window_.way(); }
  double room() const { return room_; }
  /// What one thread has found there since the last time.
  void take(StagePipeline& pipeline);
  /// False, and all is forgotten: that is too much for trees of so many leaf blocks.
  bool has_room(int leaf_blocks);
  /// Everything has been taken.
  void end_list() { are_listed_ = true; }
  /// When this question is, as part of the way.
  const TimeInterval<float>& when() const { return when_; }
  const PairList& list(PairKind kind) const { return lists_[static_cast<std::size_t>(kind)]; }
  /// The question has been answered.
  void end(const FoundContacts& answered);
  std::uint64_t memory_bytes() const;

 private:
  static constexpr std::size_t kMostListed = 256;

  Step sample_of(const Step& step);
  bool is_on_way(const Step& step);
  void forget();
  void learn();
  void pause();
  double steps_to_foresee(double stray) const;

  const Mesh& mesh_;
  const Options& options_;
  std::vector<Index> some_, places_;          ///< vertices in use; 0, 1, ...
  std::vector<Point> some_start_, some_end_;  ///< of these vertices
  Forecast next_;                             ///< by the last question, of some vertices
  Forecast window_;                           ///< of the lists
  double room_ = 0;                           ///< how far vertices may stray from it
  double edge_ = 0;                           ///< mean length, once
  double separation_ = 0;                     ///< in question when the lists were made
  TimeInterval<float> when_{};
  PairList lists_[kPairKinds];
  bool are_listed_ = false;
  bool is_soon_touching_ = false;  ///< is_free found a contact when it was last asked, without looking at everything
  double steps_;                   ///< to look ahead
  double steps_listed_ = 0;
  int served_ = 0;  ///< questions, by these lists
  int pause_ = 0;   ///< questions until it is worth another try
  int next_pause_;
};

}  // namespace tamis
