// Options of a detector and of one question, each with its default.
#pragma once
#include <cstdint>
#include <functional>
#include <optional>
#include <string_view>
#include <vector>

#include "tamis/contact.hpp"

namespace tamis {

/// Instruction set of the hot loops; every one gives the same bits. `best`: the widest that this machine has.
enum class Isa : std::uint8_t { best, baseline, avx2, avx512 };

/// How a question counts pairs that touch at t=0. These are pairs whose distance there is at most the minimum
/// separation plus both radii. Decided exactly for steps.
enum class AtStart : std::uint8_t {
  report,  ///< they are contacts at t=0, and no step may go at all
  /// A pair that touches at t=0 is a contact only when it touches again, after a time at which it does not touch. A
  /// pair that never comes apart, or never touches again, is not a contact (see Statistics::ignored).
  ignore,
  fail,  ///< throws InvalidStep, which names the first such pair
};

/// Finds the instruction set with this name, as on the command line.
/// Returns it.
/// Throws InvalidOptions, which lists the choices, if there is no such name.
[[nodiscard]] Isa isa_from_name(std::string_view name);
/// Finds the mode with this name, as on the command line; otherwise the same.
[[nodiscard]] AtStart at_start_from_name(std::string_view name);
/// Returns the name of an instruction set.
[[nodiscard]] std::string_view name_of(Isa);
/// Returns the name of a mode.
[[nodiscard]] std::string_view name_of(AtStart);
/// Returns true if questions have threads of their own: oneTBB's. Returns false if the library was built without
/// oneTBB. Then a question without a parallel_for runs on the calling thread, whatever Options::threads says.
[[nodiscard]] bool has_threads();
/// name_of returns this for a value outside the enumeration.
inline constexpr std::string_view kUnnamed = "unknown";

/// Which pairs may touch. Each vertex has a group; a feature has the group of its first vertex. The detector throws
/// InvalidOptions if sizes do not fit the mesh or each other.
struct PairFilter {
  /// The group of each vertex, in [0, group_count), or -1 for a vertex that takes no part in contacts (it is not in
  /// Mesh::points). Empty: all vertices are in group 0, group_count is 1 and groups_may_touch is empty, too.
  /// components_of numbers connected objects in this way.
  std::vector<Index> group_of_vertex;
  Index group_count = 1;  ///< number of groups
  /// group_count x group_count, symmetric, row-major; 0 skips the pairs of these two groups. Empty: none are skipped.
  std::vector<std::uint8_t> groups_may_touch = std::vector<std::uint8_t>();
  /// Called, after the groups, for each pair that may still be in the answer. False leaves the pair out. Must be safe
  /// to call from several threads. Vertices as in Contact.
  std::function<bool(PairKind, const std::array<Index, 4>&)> accepts = nullptr;
  /// Skips pairs whose features are fewer than `rings` edges apart. The distance is the shortest way along the mesh
  /// from a vertex of one to a vertex of the other. At least 1. 1 costs nothing: it skips pairs with a common vertex,
  /// which never count. 2 also skips features that an edge connects, and so on. Tested after `accepts`, only for pairs
  /// that would be in the answer.
  int rings = 1;
  /// Skips pairs within one group (no self-contact). `group_of_vertex`: as above. Memory grows with the square of the
  /// number of groups.
  /// Returns such a filter.
  /// Throws InvalidOptions if a group is 2^31 - 1.
  [[nodiscard]] static PairFilter no_self_contact(std::vector<Index> group_of_vertex);
  /// Skips pairs of two static groups, and pairs within a static group. `is_static`: one flag a group.
  /// Returns such a filter.
  [[nodiscard]] static PairFilter no_static_pairs(std::vector<Index> group_of_vertex,
                                                  const std::vector<bool>& is_static);
};

/// A parallel loop of the caller's. It calls body(i) once for each i in [0, count), on any threads, in any order, and
/// returns when all calls have returned. Each call ends on the thread that it began on.
using ParallelFor = std::function<void(int count, const std::function<void(int)>& body)>;

/// The options of a detector. Every member has an initializer, so {.threads = 1} compiles without a warning.
struct Options {
  /// Threads to use, >= 0; 0: as many as the caller's oneTBB arena gives. No more than oneTBB allows the process (its
  /// global_control; by default one a core). Without oneTBB (has_threads()) the caller's alone. The answer does not
  /// depend on it; Statistics::threads is the number used.
  int threads = 0;
  /// d >= 0, in the unit of the positions: contact means Euclidean distance <= d at some time.
  double min_separation = 0;
  /// A radius >= 0 for each group of filter.group_of_vertex: half of its thickness. Two features are in contact when
  /// their distance is at most `min_separation` plus both radii. This holds for every question but intersections. A
  /// feature whose vertices have different groups has the largest radius of its vertices. Empty: all zero. A question
  /// throws InvalidOptions if its separation plus twice a radius is more than any double.
  std::vector<double> radii = {};
  Isa isa = Isa::best;               ///< changes speed only
  PairFilter filter = PairFilter();  ///< which pairs may touch
  /// Called again and again during a question, a thousand times a second or more. Must be safe to call from several
  /// threads. Once it returns true, the question throws Cancelled. The detector answers the next question as usual.
  std::function<bool()> is_cancelled = nullptr;
  /// An engine's threads: questions run their loops by this function, on `threads` threads (0: one a core). Called by
  /// the calling thread, never from within a body, and not if `threads` is 1. Empty: oneTBB's threads.
  ParallelFor parallel_for = nullptr;
};

/// Options of one question about a step: detector.contacts(step, {.min_separation = 1e-3}).
struct QueryOptions {
  /// Replaces Options::min_separation for this question alone (an activation distance, for example). One hierarchy
  /// serves all separations.
  std::optional<double> min_separation = {};
  AtStart at_start = AtStart::report;  ///< how pairs count that touch at t=0
};

/// Options of one question about a path, or about a world, whose bodies may turn.
struct PathOptions {
  std::optional<double> min_separation = {};  ///< as in QueryOptions
  /// On a path, a pair counts as touching at t=0 if it cannot be proven apart there.
  AtStart at_start = AtStart::report;
  double tolerance = 1e-9;  ///< the widest bracket of a contact, a fraction of the step in (0, 1]
};

/// Options of one question about the bodies of a world where they are at t=0.
struct PoseOptions {
  bool include_static = false;  ///< also query two bodies that are both Static
};

}  // namespace tamis
