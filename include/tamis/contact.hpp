// The answers: one contact, and what is said of a whole step.
#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "tamis/mesh.hpp"
#include "tamis/step.hpp"

namespace tamis {

/// Vertex-face (VF) and edge-edge (EE): between them every first contact of two triangle meshes.
enum class PairKind : std::uint8_t { vertex_face, edge_edge };

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
  std::array<Index, 4> vertices;
  /// The pair is apart on [0, toi_lower); if certified it touches at some time of [toi_lower, toi_upper].
  double toi_lower;
  double toi_upper;
  /// Contact weights. vf: point = (1-u-v) f0 + u f1 + v f2. ee: u on the first edge, v on the second, each in [0,1].
  double u;
  double v;
  /// Unit normal at the contact: of the face, or the cross product of the edges; any unit vector orthogonal
  /// to what is left where those vanish.
  Point normal;
};

/// Answer to "how far may the step go?".
struct EarliestContact {
  /// The motion is free on [0, toi_lower): proven. 1 and no contact if the whole step is free.
  double toi_lower = 1;
  /// A certified contact happens at or before this time; 1 if none is certified.
  double toi_upper = 1;
  /// The contact that bounds the step first; none if the step is free.
  std::optional<Contact> contact;
};

}  // namespace tamis
