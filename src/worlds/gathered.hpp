// The items of near bodies that may touch, gathered as one mesh with a detector.
#pragma once
#include <set>
#include <span>
#include <vector>

#include "api/detector_state.hpp"
#include "search/query/pair_vertices.hpp"
#include "tamis/detector.hpp"
#include "worlds/carried_bodies.hpp"
#include "worlds/near_items.hpp"

namespace tamis {

class Gathered {
 public:
  /// Bodies with a lesser kind of motion than `least` are passive. They do not meet each other. These are the bodies
  /// that stay, or in a question about curves those that do not turn. In a question about curves bodies that turn
  /// together do not meet each other here. `options`: the detector's, without groups. REQUIRES: `items` is not empty.
  Gathered(const BodyList& bodies, NearItems items, MotionKind least, const std::set<BodyPair>& excluded_pairs,
           const Options& options);
  Gathered(const Gathered&) = delete;

  /// True if each body has the same kind of motion as when this was made, and the same bodies turn together.
  bool keeps_motion_kinds(const BodyList& bodies) const;
  /// The links that carry the frame of the bodies given from now on; empty: the frame of the world.
  void set_carrier(RigidChain carrier) { carrier_ = std::move(carrier); }
  const NearItems& items() const { return items_; }
  /// The same as items().pairs, for the vertices of the gathered mesh.
  const BodyPairs& body_pairs() const { return body_pairs_; }
  std::vector<BodyId> body_ids() const;

  /// All vertices at t=0 and at t=1, in doubles. Valid until the next call.
  Step step(const BodyList& bodies);
  Positions start(const BodyList& bodies);
  /// The motion of all vertices on curves.
  RigidPath path(const BodyList& bodies) const;

  /// Replaces the vertices of the gathered mesh in a row by bodies and the bodies' own vertices. Turns directions into
  /// the world.
  template <class Row>
  void name(Row& row) const {
    row.bodies = {body_of(row.vertices[0]), body_of(row.vertices[second_feature(row.kind)])};
    to_own(std::span(row.vertices).first(vertex_count(row.kind)));
    turn_into_world(row);
  }
  void name(BodyIntersection& row) const;

  Detector& detector() { return detector_; }
  std::uint64_t memory_bytes() const;

 private:
  struct Vertex {
    BodyId body;
    Index own;
  };

  BodyId body_of(Index vertex) const { return vertices_[static_cast<std::size_t>(vertex)].body; }
  void to_own(std::span<Index> vertices) const {
    for (Index& v : vertices) v = vertices_[static_cast<std::size_t>(v)].own;
  }
  void turn_into_world(BodyContact& row) const {
    if (!carrier_.empty()) row.normal = turned_by(carrier_, row.toi_lower, row.normal);
  }
  void turn_into_world(BodyNearPair& row) const {
    if (!carrier_.empty()) row.direction = turned_by(carrier_, 0, row.direction);
  }
  /// For each of its bodies by ascending number: first_of_carrier() in a question about curves, else itself.
  std::vector<BodyId> carriers(const BodyList& bodies) const;
  BodyPairs make_body_pairs() const;
  Mesh make_mesh(const BodyList& bodies);
  PairFilter make_filter(const BodyList& bodies, const std::set<BodyPair>& excluded_pairs) const;
  Detector make_detector(const BodyList& bodies, const std::set<BodyPair>& excluded_pairs, Options options);

  const NearItems items_;
  const MotionKind least_;
  const std::vector<BodyId> carriers_;
  RigidChain carrier_;
  std::vector<MotionKind> motion_kinds_;  ///< of its bodies, by ascending number
  std::vector<Vertex> vertices_;          ///< by body, then own vertex, as contacts are ordered
  std::vector<Point> start_, end_;
  Detector detector_;
  const BodyPairs body_pairs_;
};

}  // namespace tamis
