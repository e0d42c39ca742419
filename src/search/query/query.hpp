// A query: the step and the question about it. It goes down through the engine unchanged. Answers come back in
// collectors.
#pragma once
#include <cstdint>
#include <span>

#include "pair/motion/separations.hpp"
#include "pair/narrow/kept_distance.hpp"
#include "search/bounds/box_frame.hpp"
#include "search/query/body_pairs.hpp"
#include "search/topology/rings.hpp"
#include "tamis/options.hpp"
#include "tamis/pair.hpp"
#include "tamis/step.hpp"

namespace tamis {

enum class Question : std::uint8_t {
  all_contacts,
  earliest,
  is_free,  ///< in a search for intersections: whether there are none
};

/// Refers to positions, radii, filter, rings, function and frame, which must outlive it.
struct Query {
  Step step;  ///< for a question about one pose: from the pose to itself
  Separations separations;
  const PairFilter& filter;
  const Rings& rings;
  const std::function<bool()>& is_cancelled;
  Question question = Question::all_contacts;
  bool ignores_start = false;  ///< AtStart::ignore; `fail` runs as `report`
  /// `filter.accepts` is called for intersections, too: with the edge's first vertex and the face.
  bool accepts_intersections = false;
  /// The frame of the whole scene, if the mesh is a part of it; null: the frame of the mesh.
  const BoxFrame* frame = nullptr;
  /// The step is a piece of a path. The next one has other radii, so nothing is listed ahead.
  bool is_piece = false;
  /// With `earliest` the answers are the first contacts of these pairs of bodies; null: the first one of the mesh.
  /// Other pairs of bodies are skipped.
  const BodyPairs* each_of = nullptr;
  /// For find_step_ends alone, one a vertex: pairs all of whose vertices have 0 are known already, and may be skipped.
  /// Empty: no pair is known.
  std::span<const std::uint8_t> changed = {};

  /// How many first contacts the query wants.
  std::size_t answers() const { return each_of ? each_of->count() : 1; }
  /// The answer whose first contact a pair may be; answers() if none.
  std::size_t answer_of(PairKind kind, const std::array<Index, 4>& vertices) const {
    return each_of ? each_of->number_of(vertices[0], vertices[second_feature(kind)]) : 0;
  }
  /// The rule that decides a pair in questions that keep a fraction of distances.
  DistanceRule distance_rule_for(PairKind kind, const std::array<Index, 4>& vertices, double fraction) const {
    return {fraction, separations.between(kind, vertices), ignores_start};
  }
  /// True if the pair's features are fewer edges apart than the caller wants. Takes a search along the mesh. So it runs
  /// last, for pairs that would be in the answer.
  bool are_neighbours(PairKind kind, const std::array<Index, 4>& v) const {
    const std::span<const Index> all(v.data(), vertex_count(kind));
    return rings.are_neighbours(all.first(second_feature(kind)), all.subspan(second_feature(kind)));
  }
};

}  // namespace tamis
