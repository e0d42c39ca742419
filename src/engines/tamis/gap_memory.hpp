// What a detector remembers of the last questions: which leaf blocks lie near each other, how far apart at least, and
// where everything was then. It decides what need not be looked at again, never what the answer is.
#pragma once
#include <atomic>
#include <vector>

#include "engines/tamis/feature_trees.hpp"
#include "engines/tamis/near_list.hpp"

namespace tamis {

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
  /// The blocks that may touch `block` until t, of those listed. REQUIRES: serves(). Safe from several threads.
  void append_unproven(PairKind kind, int block, float t, std::vector<std::int32_t>& others);
  /// The question has been answered, by what happens until t: what lies near is remembered for the next ones, where
  /// that promises to help.
  void end(const Step& step, float t);
  std::uint64_t memory_bytes() const;

 private:
  static constexpr std::size_t kMostNear = 64;

  bool follows(const Step& step);
  void remember(const Step& step, float t);
  void give_up();
  void forget();

  const Mesh& mesh_;
  const Kernels& kernels_;
  FeatureTrees& trees_;
  std::vector<Point> last_;   ///< where the last question started
  std::vector<Point> where_;  ///< where everything was when the lists were made; empty without lists
  NearList vf_, ee_;
  int builds_ = 0;         ///< of the trees, at that time
  double unit_ = 0;        ///< scale of the boxes at that time
  double separation_ = 0;  ///< and the separation
  float reach_ = 0;        ///< of the lists
  float scale_ = 1;        ///< of gaps in this question's unit
  bool serves_ = false, follows_ = false;
  bool starts_again_ = false;              ///< where the last question started: the next one will probably, too
  std::atomic<std::size_t> unproven_ = 0;  ///< in this question
  std::size_t most_unproven_ = 0;          ///< before lists are worn; 0: not known yet
  int served_ = 0;                         ///< questions that these lists have answered
  int pause_ = 0;                          ///< questions for which no lists are made, as they did not help
};

}  // namespace tamis
