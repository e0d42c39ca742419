// What is found in one frame and in the step that ends there.
#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "audit/frame_source.hpp"
#include "tamis/contact.hpp"
#include "tamis/proximity.hpp"

namespace tamis::audit {

/// Contacts by kind, in the order of tamis::PairKind, and intersections: an edge through a face.
enum class Kind : std::uint8_t { vertex_face, edge_edge, vertex_edge, vertex_vertex, edge_face };
inline constexpr std::size_t kKinds = kPairKinds + 1;
static_assert(static_cast<std::size_t>(Kind::edge_face) == kPairKinds, "name each kind of pair above, in its order");

/// "vf", "ee", "ve", "vv", "ef".
std::string_view name_of(Kind kind);

/// No path of edges joins two features.
inline constexpr Index kNotConnected = -1;

/// A pair that touches in a step, or whose features pass through each other in a frame. Plain data.
struct Finding {
  /// The frame, counted from 0; of a contact the one at which the step ends.
  std::int64_t frame;
  Kind kind;
  /// Vertices of the first feature, then of the second, as in Contact and Intersection; -1 where a kind has fewer.
  std::array<Index, 5> vertices;
  /// Of a contact, fractions of the step, as in Contact; of an intersection both 1, the end of the step.
  double toi_lower;
  double toi_upper;
  /// The object of each feature's first vertex.
  std::array<Index, 2> objects;
  /// As RingSearch counts: 1 for topological neighbours, limit + 1 beyond the limit, -1 if not connected.
  Index rings;
  /// The frame before, with the step to it, has no such pair: the same kind and vertices (NewPairs).
  bool is_new;
};

/// One frame and the step that ends there, in numbers.
struct FrameAnswer {
  std::string name;
  std::string problem;                         ///< why the frame was not asked about; empty if it was
  std::string note;                            ///< the Frame's note; says also if the topology changes here
  bool has_collapsed = false;                  ///< objects have collapsed: the note says which (collapsed.hpp)
  bool has_step = false;                       ///< a step that ends here was asked about
  std::array<std::uint64_t, kKinds> counts{};  ///< by Kind
  std::uint64_t neighbours = 0;                ///< of these, pairs one edge apart
  std::uint64_t fresh = 0;                     ///< of these, pairs that are new since the frame before
  double toi_lower = 1;                        ///< proven: the step is free before
  double toi_upper = 1;

  std::uint64_t contacts() const { return counts[0] + counts[1] + counts[2] + counts[3]; }
  std::uint64_t intersections() const { return counts[4]; }
  /// Something was found: a contact, an intersection, or that an object has collapsed.
  bool is_bad() const { return has_collapsed || contacts() + intersections() > 0; }
  bool is_free() const { return problem.empty() && !is_bad(); }
};

/// The answer with the pairs, and the data to show them.
struct FrameFindings {
  std::int64_t number;  ///< of the frame, counted from 0
  FramePointer before;  ///< null unless there is a step
  FramePointer frame;
  FrameAnswer answer;
  std::vector<Finding> pairs;  ///< intersections, then contacts, each in the detector's order
  std::vector<bool> is_new;    ///< of each of `pairs`
  std::vector<Contact> contacts;
  std::vector<Intersection> intersections;
};

}  // namespace tamis::audit
