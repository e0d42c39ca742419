// The task that every contender is given, and the answer that it returns. Answers are compared before times count.
#pragma once
#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <unordered_set>
#include <vector>

#include "benchmarks/contenders/stopwatch.hpp"
#include "tamis/contact.hpp"
#include "tamis/mesh.hpp"
#include "tamis/step.hpp"

namespace tamis::bench {

/// Vertices as in Contact.
struct Pair {
  PairKind kind;
  std::array<Index, 4> vertices;

  bool operator==(const Pair&) const = default;
};

std::uint64_t hash_of(const Pair& pair);
struct PairHash {
  std::size_t operator()(const Pair& pair) const { return hash_of(pair); }
};
using PairSet = std::unordered_set<Pair, PairHash>;

struct VertexFace {
  Index vertex, face;
};

/// The step that all contenders work on, and its exact answer.
struct Task {
  Mesh mesh;
  std::vector<Point> start, end;
  PairSet contacts;                                ///< every pair that touches, by exact algebra
  std::vector<Pair> candidates;                    ///< every pair without a common vertex whose swept boxes meet
  std::vector<VertexFace> vertex_face_candidates;  ///< the candidates of vertex and face, in the same order
  int threads = 1;
};

struct Answer {
  std::uint64_t vf = 0, ee = 0;  ///< pairs returned: candidates by a broad phase, contacts by all others
  std::uint64_t missed = 0;      ///< true contacts (of the kinds that the contender knows) that were not returned
  std::uint64_t extra = 0;       ///< pairs that are neither contacts nor, for a broad phase, swept boxes that meet
  std::string note;
};

enum class Field : std::uint8_t { broad_phase, one_pair, all_contacts, largest_step };

/// The answer of a contender that decides pairs of these kinds.
Answer compare(const Task& task, const std::vector<Pair>& touching, bool knows_vf, bool knows_ee);

/// One program in the comparison.
class Contender {
 public:
  virtual ~Contender() = default;
  virtual std::string name() const = 0;
  virtual Field field() const = 0;
  /// If false, it is measured with one thread only.
  virtual bool uses_threads() const { return field() != Field::one_pair; }
  /// Does the work, keeps its result for `answer`, and returns the cost of the part that is compared.
  virtual Cost run(const Task& task) = 0;
  /// The answer of the last run; not timed.
  virtual Answer answer(const Task& task) = 0;
};

using Contenders = std::vector<std::unique_ptr<Contender>>;
/// Each adds its contenders; those whose package was not found at build time are not compiled.
void add_tamis(Contenders& list);
void add_embree(Contenders& list);
void add_cgal(Contenders& list);
void add_bullet(Contenders& list);
void add_ipc_toolkit(Contenders& list);
void add_tight_inclusion(Contenders& list);

}  // namespace tamis::bench
