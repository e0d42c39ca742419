// What happens to a pair of features once the paper's hierarchy has found it: swept boxes of the features, filters,
// interval Newton, and what that leaves open, decide(). Pairs are taken in blocks, stage by stage. One per thread.
#pragma once
#include "lab/bounds/feature_boxes.hpp"
#include "lab/filters/filters.hpp"
#include "lab/options.hpp"
#include "lab/topology/representatives.hpp"
#include "query/engine.hpp"
#include "query/pair_vertices.hpp"
#include "tamis/pair.hpp"

namespace tamis::lab {

/// What all threads read.
struct PaperScene {
  const tamis::Options& options;
  const PaperOptions& paper;
  const Mesh& mesh;  ///< every feature belongs to a triangle
  Index face_count;  ///< triangles from here on are no features
  std::vector<TriangleFeatures> triangles;
  std::vector<FilterStage> stages;
  MovingPoints points;
  FeatureBoxes boxes;
  const ContactCollector* answer = nullptr;  ///< the question, and what is known of its answer
};

/// Pairs that enter each part, and the seconds it took. The boxes are in `boxes`, then one count a filter.
struct PaperCounts {
  StageCount boxes{"boxes"}, newton{"newton"}, decide{"decide"};
  std::vector<StageCount> filters;
  PrecisionCount decided_by;
  double filter_seconds = 0, solve_seconds = 0;
  std::uint64_t bounds_tested = 0, triangle_pairs = 0;

  explicit PaperCounts(std::span<const FilterStage> stages);
  void add(const PaperCounts& other);
};

class PaperTester {
 public:
  explicit PaperTester(const PaperScene& scene);

  /// The features of two triangles against each other. Cheap to call: see `flush`.
  void add_triangles(Index a, Index b);
  void add_vertex_face(Index vertex, Index face);
  /// Two of the degenerate triangles that stand for loose edges and points.
  void add_loose(Index a, Index b);
  void add_edges(Index edge0, Index edge1);
  /// Tests what still waits in the blocks.
  void flush();
  /// A new question; keeps the memory.
  void begin();

  ContactCollector found;
  /// Of all contacts, the features of each, so that duplicates can be told: vertex and face, or two edges.
  std::vector<std::array<Index, 2>> features;
  PaperCounts counts;
  std::uint64_t memory_bytes() const;

 private:
  static constexpr std::size_t kBlock = 256;

  template <PairKind kind>
  struct Block {
    std::size_t size = 0;
    std::array<std::array<Index, 2>, kBlock> features;
    std::array<PairVertices, kBlock> vertices;
    std::array<PairMotion<double>, kBlock> motions;
  };

  template <PairKind kind>
  void add(Block<kind>& block, const std::array<Index, 2>& features, const PairVertices& vertices);
  template <PairKind kind>
  void test(Block<kind>& block);
  template <PairKind kind>
  std::size_t run_filters(const Block<kind>& block, std::span<std::uint16_t> alive);
  template <PairKind kind>
  void solve(const Block<kind>& block, std::size_t pair);
  template <PairKind kind>
  PairResult result_of(const Block<kind>& block, std::size_t pair);

  const PaperScene& scene_;
  Block<PairKind::vertex_face> vf_;
  Block<PairKind::edge_edge> ee_;
};

}  // namespace tamis::lab
