// Tests the pairs of features that the paper's hierarchy finds: swept boxes of the features, filters, interval Newton,
// and decide() for pairs that are still undecided. Takes pairs in blocks, stage by stage. Each thread has one tester.
#pragma once
#include "paper/bounds/feature_boxes.hpp"
#include "paper/filters/filters.hpp"
#include "paper/options.hpp"
#include "paper/topology/representatives.hpp"
#include "search/query/engine.hpp"
#include "search/query/pair_vertices.hpp"
#include "tamis/pair.hpp"

namespace tamis::lab {

/// The data that all threads read.
struct PaperScene {
  const tamis::Options& options;
  const PaperOptions& paper;
  const Mesh& mesh;  ///< every feature belongs to a triangle
  Index face_count;  ///< triangles from here on are no features
  std::vector<TriangleFeatures> triangles;
  std::vector<FilterStage> stages;
  MovingPoints points;
  FeatureBoxes boxes;
  const ContactCollector* answer = nullptr;  ///< holds the query and its bound
};

/// Numbers of the pairs that enter each stage, and seconds. `boxes`: pairs whose boxes meet; `filters`: one count each.
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

  /// Adds the pairs of features of two triangles to the blocks. A block that is full is tested.
  void add_triangles(Index a, Index b);
  void add_vertex_face(Index vertex, Index face);
  /// Decides the pair of loose features that two degenerate triangles stand for, unless both are edges.
  void add_loose(Index a, Index b);
  void add_edges(Index edge0, Index edge1);
  /// Tests the pairs that are still in the blocks.
  void flush();
  /// Begins a new question; keeps the memory.
  void begin();

  ContactCollector found;
  /// The features of each contact in `found`, to recognize duplicates: vertex and face, or two edges. Only if all
  /// contacts are asked for.
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
