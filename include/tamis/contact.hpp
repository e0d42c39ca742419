// The answers: one contact, and what is said of a whole step.
#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "tamis/mesh.hpp"
#include "tamis/step.hpp"

namespace tamis {

/// Vertex-face (VF) and edge-edge (EE): between them every first contact of two triangle meshes. Points and edges that
/// belong to no face have closed features of their own that these leave out: vertex-edge (VE) and vertex-vertex (VV).
enum class PairKind : std::uint8_t { vertex_face, edge_edge, vertex_edge, vertex_vertex };

/// "vf", "ee", "ve", "vv": as in files and on the command line.
std::string_view name_of(PairKind);

/// How sure a reported contact is.
enum class Certainty : std::uint8_t {
  certified,   ///< proven: the closed features touch (within the minimum separation) at some time of the bracket
  unresolved,  ///< floating point could not decide; kept, because a contact must never be missed
};

/// One pair of features that touches during the step.
struct Contact {
  PairKind kind;
  Certainty certainty;
  /// vf: the vertex, then the face's vertices in the mesh's order. ee: each edge ascending, the smaller edge first.
  /// ve: the vertex, then the edge's, ascending. vv: ascending. Those that a kind does not use are -1.
  std::array<Index, 4> vertices;
  /// Fractions of the step, in [0,1]: the pair is apart on [0, toi_lower); if certified it touches at some time of
  /// [toi_lower, toi_upper].
  double toi_lower;
  double toi_upper;
  /// Contact weights. vf: point = (1-u-v) f0 + u f1 + v f2. ee: u on the first edge, v on the second, each in [0,1].
  /// ve: u on the edge, v = 0. vv: both 0.
  double u;
  double v;
  /// Unit normal at the contact. vf: of the face; ee: the cross product of the edges; ve, vv: towards the first vertex
  /// from the closest point of the other feature. Any unit vector orthogonal to what is left where those vanish.
  Point normal;
};

/// The two features of a pair by their places: of a face in Mesh::faces(), of an edge in Mesh::edges(), of a vertex its
/// index; -1 where the mesh has none. For those who keep data by feature: a Contact names vertices, as does a NearPair.
struct FeaturePair {
  Index first, second;
};
FeaturePair features_of(const Mesh& mesh, PairKind kind, const std::array<Index, 4>& vertices);

/// Answer to "how far may the step go?".
struct EarliestContact {
  /// The motion is free on [0, toi_lower): proven. 1 and no contact if the whole step is free; 0 only if a pair touches
  /// at t=0, or (toi_upper > 0) sooner than at any positive double. A time, not a position: start + toi_lower
  /// (end - start), rounded to doubles, may touch again. Detector::truncate gives positions to go to.
  double toi_lower = 1;
  /// A certified contact happens at or before this time; 1 if none is certified.
  double toi_upper = 1;
  /// The contact that bounds the step first; none if the step is free.
  std::optional<Contact> contact;
};

/// The pair of features that ends a step: kind and vertices as in Contact.
struct LimitingPair {
  PairKind kind;
  std::array<Index, 4> vertices;
  /// At t=0, in the unit of the positions; rounded, not certified.
  double distance;
};

/// Answer to "how far may the step go so that every pair keeps a fraction of its distance?". The distance that counts
/// is what exceeds the minimum separation.
struct SafeStep {
  /// On [0, lower] every pair keeps at least the fraction, and on [0, lower) none touches: proven. 1 if the whole step
  /// may go; 0 only if a pair touches (comes within the minimum separation) at t=0.
  double lower = 1;
  /// At this time some pair has no more than the fraction left: proven; 1 if that is not known of any time.
  double upper = 1;
  /// The pair that ends the step at `lower`; none if the whole step may go.
  std::optional<LimitingPair> pair;
};

/// Answer to "how far may each vertex go?".
struct VertexSteps {
  /// Until here all vertices may go together, at one time of the step: what keep_distance says.
  double together = 1;
  /// Of each vertex, in [together, 1]. From where all are at `together`, every vertex may go, at a pace of its own, to
  /// its time or any before it, whatever the others do: no pair comes into contact. Proven, with room for positions
  /// that are rounded to doubles. 1 for vertices that take no part in contacts.
  std::vector<double> until;
};

/// Where a step may end.
struct TruncatedStep {
  /// One a vertex: where to go. The straight way there from the start of the step, to these very doubles, is free.
  std::vector<Point> positions;
  /// False: not even that is proven, because something touches (within the minimum separation) at the start, where
  /// `positions` then are.
  bool is_free = true;
};

}  // namespace tamis
