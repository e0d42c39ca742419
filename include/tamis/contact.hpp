// Contacts of a step: one, and the first of all.
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

#include "tamis/mesh.hpp"
#include "tamis/positions.hpp"

namespace tamis {

/// Vertex-face (VF) and edge-edge (EE): between them every first contact of two triangle meshes. Points and edges that
/// belong to no face have closed features of their own that these leave out: vertex-edge (VE) and vertex-vertex (VV).
enum class PairKind : std::uint8_t { vertex_face, edge_edge, vertex_edge, vertex_vertex };
/// How many there are: a table that has a row a kind is indexed by it.
inline constexpr std::size_t kPairKinds = 4;

/// "vf", "ee", "ve", "vv": as in files and on the command line.
std::string_view name_of(PairKind);

/// How sure a reported contact is. Of straight motion all are certified; curved motion (Path) has both.
enum class Certainty : std::uint8_t {
  certified,   ///< proven: the closed features touch (within the minimum separation) at some time of the bracket
  unresolved,  ///< arithmetic could not decide; kept, because a contact must never be missed
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
  /// Unit vector: the direction in which the first feature (the vertex; the first edge) must go, or the second be
  /// pushed back, so that they part. With a minimum separation or radii, and of ve and vv, from the second feature's
  /// closest point to the first's at toi_lower. Else of the face, or of both edges (their cross product), on the side
  /// where the first feature is just before they touch; where all stay in one plane, or the face has no area, or the
  /// edges are parallel, that of the closest points. Features that share a point at t=0 are taken to have come against
  /// their motion; if they are at rest it is the normal, on either side, or any unit vector where there is none.
  Point normal;
};

/// Both features of a pair, the first one first, by their places: of a face in Mesh::faces(), of an edge in
/// Mesh::edges(), of a vertex its index. For those who keep data by feature: a Contact names vertices, as does a
/// NearPair. Mesh::edges() has an order of its own, which another library's list of edges need not have:
/// Mesh::find_edge leads from one to the other. Throws InvalidMesh where the mesh has no such vertex, edge or face (a
/// face counts in the mesh's order of its vertices only), or there is no such kind.
std::array<Index, 2> features_of(const Mesh& mesh, PairKind kind, const std::array<Index, 4>& vertices);

/// Of each of a pair's vertices, as signed weights that add up to 0: sums over the first feature's give its point, and
/// those over the second's the other point, negative. So the sum over all is the vector from the second point to the
/// first. vf: 1, u+v-1, -u, -v; ee: 1-u, u, v-1, -v; ve: 1, u-1, -u, 0; vv: 1, -1, 0, 0. u and v as of a Contact, a
/// NearPair or a PairResult. Throws Error if there is no such kind.
std::array<double, 4> weights_of(PairKind kind, double u, double v);

/// Answer to "how far may the step go?".
struct EarliestContact {
  /// The motion is free on [0, toi_lower): proven. 1 and no contact if the whole step is free; 0 only if a pair touches
  /// at t=0 (and is not ignored for it), or (toi_upper > 0) sooner than at any positive double. A time, not a position:
  /// start + toi_lower (end - start), rounded to doubles, may touch again. Detector::truncate gives positions to go to.
  double toi_lower = 1;
  /// A certified contact happens at or before this time; 1 if none is certified, as may be on a path.
  double toi_upper = 1;
  /// The contact that bounds the step first; none if the step is free.
  std::optional<Contact> contact;
};

}  // namespace tamis
