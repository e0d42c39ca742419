// What a detector remembers of the last questions: which leaf blocks lie near each other, how far apart at least, and
// where everything was then. It decides what need not be looked at again, never what the answer is.
#pragma once
#include <atomic>
#include <vector>

#include "engines/tamis/feature_trees.hpp"
#include "engines/tamis/near_list.hpp"

namespace tamis {

/// Gaps from `from` on and below `to`, as parts of the reach of the lists.
struct GapBand {
  float from, to;
};

/// From what lies nearest outwards: an early contact there leaves little of the step for the rest.
inline constexpr GapBand kGapBands[] = {{0, 1.0f / 64}, {1.0f / 64, kNowhere}};

/// Bounded memory: at most kMostNear pairs a leaf block of sixteen features, 8 bytes each, and positions.
class GapMemory {
 public:
  /// Keeps references.
  GapMemory(const Mesh& mesh, const Kernels& kernels, FeatureTrees& trees)
      : mesh_(mesh), kernels_(kernels), trees_(trees) {}

  /// A new question; the trees are those of its step.
  void begin(const Step& step);
  /// Are there lists that may serve this question?
  bool serves() const { return serves_; }
  /// Is everything that is not listed proven apart until t? REQUIRES: serves().
  bool covers(float t) const;
  /// Before they are gone through.
  void use_lists();
  /// The blocks that may touch `block` until t, of those listed whose gaps are in the band. REQUIRES: use_lists(). Safe
  /// from several threads.
  void append_unproven(PairKind kind, int block, const GapBand& band, float t, std::vector<std::int32_t>& others);
  /// The question has been answered, by what happens until t: what lies near is remembered for the next ones, where
  /// that promises to help.
  void end(const Step& step, float t);
  std::uint64_t memory_bytes() const;

 private:
  static constexpr std::size_t kMostNear = 64;

  bool follows(const Step& step);
  float reach_now() const;
  void remember(const Step& step, float t);
  void count_drifts(const Step& step);
  float drift_of_all(float t) const;
  float used_up(float t) const;
  void give_up();
  void forget();

  const Mesh& mesh_;
  const Kernels& kernels_;
  FeatureTrees& trees_;
  std::vector<Point> last_;   ///< where the last question to the trees started
  std::vector<Point> where_;  ///< where everything was when the lists were made; empty without lists
  NearList vf_, ee_;
  MovingBox all_drifts_;  ///< since then, of all vertices
  BlockDrifts points_, edges_, faces_;
  int drifting_builds_ = 0;  ///< of the trees, whose blocks these are
  bool drift_of_blocks_is_known_ = false;
  int builds_ = 0;         ///< of the trees, when the lists were made
  double unit_ = 0;        ///< scale of the boxes at that time
  double separation_ = 0;  ///< and the separation
  float reach_ = 0;        ///< of the lists
  float scale_ = 1;        ///< of gaps in this question's unit
  bool serves_ = false, follows_ = false;
  bool starts_again_ = false;              ///< where the last question started: the next one will probably, too
  int asked_again_ = 0;                    ///< questions from one start that lists would have served; below 0: a pause
  std::atomic<std::size_t> unproven_ = 0;  ///< in this question
  std::size_t most_unproven_ = 0;          ///< before lists are worn; 0: not known yet
  int served_ = 0;                         ///< questions that these lists have answered
};

}  // namespace tamis
