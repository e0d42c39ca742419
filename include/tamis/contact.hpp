// One contact of a step, and the answer to "how far may the step go?".
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

#include "tamis/mesh.hpp"
#include "tamis/positions.hpp"

namespace tamis {

/// Vertex-face (VF) and edge-edge (EE) pairs cover every first contact of two triangle meshes. Points and edges of no
/// face have other contacts. Vertex-edge (VE) and vertex-vertex (VV) pairs cover them.
enum class PairKind : std::uint8_t { vertex_face, edge_edge, vertex_edge, vertex_vertex };
/// The number of kinds; PairKind indexes a table that has one row a kind.
inline constexpr std::size_t kPairKinds = 4;

/// Returns "vf", "ee", "ve" or "vv", as in files and on the command line.
[[nodiscard]] std::string_view name_of(PairKind);

/// How sure a reported contact is. All contacts of straight motion are certified; curved motion (Path) has both kinds.
enum class Certainty : std::uint8_t {
  certified,   ///< proven: the closed features touch (come within the minimum separation) at some time of the bracket
  unresolved,  ///< arithmetic could not decide; kept, because a contact must never be missed
};

/// One pair of features that touches during the step.
struct Contact {
  PairKind kind;        ///< which features
  Certainty certainty;  ///< whether the contact is proven
  /// vf: the vertex, then the face's vertices in the mesh's order. ee: the vertices of each edge ascending, the smaller
  /// edge first. ve: the vertex, then the edge's vertices, ascending. vv: ascending. Entries that a kind does not use
  /// are -1.
  std::array<Index, 4> vertices;
  double toi_lower;  ///< a fraction of the step, in [0,1]: the pair is apart on [0, toi_lower)
  double toi_upper;  ///< a fraction of the step: a certified contact touches at some time of [toi_lower, toi_upper]
  /// Weight. vf: point = (1-u-v) f0 + u f1 + v f2. ee: place on the first edge, in [0,1]. ve: place on the
  /// edge. vv: 0.
  double u;
  double v;  ///< second weight. ee: place on the second edge, in [0,1]. ve and vv: 0
  /// Unit vector. To part the features, move the first one (the vertex; the first edge) along it, or the second one
  /// against it.
  /// - With a minimum separation or radii, and for ve and vv: from the second feature's closest point to the first's at
  ///   toi_lower.
  /// - Otherwise: the normal of the face, or the cross product of both edges, on the side where the first feature is
  ///   just before they touch. If all points stay in one plane, the face has no area or the edges are parallel: the
  ///   direction between the closest points.
  /// - Features that share a point at t=0 count as having come against their motion. If they are at rest it is the
  ///   normal, on either side. If the normal is zero, it is any unit vector.
  Point normal;
};

/// Returns both features of a pair, the first one first. Of a face it returns its place in Mesh::faces(), of an edge
/// its place in Mesh::edges(), of a vertex its index. For callers who keep data by feature: Contact and NearPair name
/// vertices. Another library may list edges in another order than Mesh::edges(). Mesh::find_edge leads from one to the
/// other.
/// Throws InvalidMesh if the mesh has no such vertex, edge or face, or if there is no such kind. A face with its
/// vertices in another order is not found.
[[nodiscard]] std::array<Index, 2> features_of(const Mesh& mesh, PairKind kind, const std::array<Index, 4>& vertices);

/// Returns a signed weight for each of a pair's vertices. The four add up to 0. The first feature's vertices, weighted
/// and summed, give its point. The second feature's give its point, negative. So the sum over all is the vector from
/// the second point to the first. For vf: 1, u+v-1, -u, -v; ee: 1-u, u, v-1, -v; ve: 1, u-1, -u, 0; vv: 1, -1, 0, 0.
/// `u` and `v`: as in a Contact, a NearPair or a PairResult.
/// Throws Error if there is no such kind.
[[nodiscard]] std::array<double, 4> weights_of(PairKind kind, double u, double v);

/// Answer to "how far may the step go?".
struct EarliestContact {
  /// Proven: the motion is free on [0, toi_lower). Where very many pairs touch at one time, it may lie up to 2^-37 of
  /// itself before the contact's own toi_lower. It is 1, with no contact, if the whole step is free. It is 0 only if a
  /// pair touches at t=0 (and is not ignored), or sooner than at any positive double (toi_upper > 0). This is a time,
  /// not a position. The position start + toi_lower (end - start), rounded to doubles, may touch. Detector::truncate
  /// returns positions to go to.
  double toi_lower = 1;
  /// A certified contact happens at or before this time. 1 if no contact is certified. On a path all contacts may be
  /// unresolved.
  double toi_upper = 1;
  /// The contact that ends the step; none if the step is free.
  std::optional<Contact> contact;
};

}  // namespace tamis
