// Everything a caller may choose, each with its default.
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

/// What becomes of pairs that touch at t=0: whose distance there is at most the minimum separation plus both radii.
/// Which they are is decided exactly.
enum class AtStart : std::uint8_t {
  report,  ///< they are contacts at t=0, and no step may go at all
  /// They count once they have come apart: such a pair is a contact when it touches again after a time at which it does
  /// not. One that never comes apart, or never comes back, is none (Statistics::ignored).
  ignore,
  fail,  ///< InvalidStep, which names the first of them
};

/// Names as on the command line, and back. Throw InvalidOptions, naming the choices, if there is no such name.
Isa isa_from_name(std::string_view name);
AtStart at_start_from_name(std::string_view name);
std::string_view name_of(Isa);
std::string_view name_of(AtStart);
/// What name_of says of a number that is none of the enumeration's.
inline constexpr std::string_view kUnnamed = "unknown";

/// Which pairs of objects may touch. Vertices carry a group; a feature belongs to the group of its first vertex. Sizes
/// that do not fit the mesh, or each other, make the detector throw InvalidOptions.
struct PairFilter {
  /// Group of each vertex, in [0, group_count), or -1 where it takes no part in contacts (Mesh::points); empty: all in
  /// group 0, the only one, and groups_may_touch is empty too. components_of numbers connected objects so.
  std::vector<Index> group_of_vertex;
  Index group_count = 1;
  /// group_count x group_count, symmetric, row-major; 0 leaves the pair of groups out. Empty: all are tested.
  std::vector<std::uint8_t> groups_may_touch = std::vector<std::uint8_t>();
  /// Asked last, for every pair still there; must be safe to call from several threads. Vertices as in Contact.
  std::function<bool(PairKind, const std::array<Index, 4>&)> accepts = nullptr;
  /// >= 1: pairs are left out whose features are fewer edges apart than this, along the mesh: on the shortest way from
  /// a vertex of the one to a vertex of the other. 1, which costs nothing: those with a common vertex, as always. 2:
  /// also those that an edge connects, and so on. Asked, after `accepts`, of pairs alone that would be in the answer.
  int rings = 1;
  /// Pairs within one group are left out (no self-contact). One group a vertex, as above; memory goes by the square of
  /// their number. Throws InvalidOptions on a group of 2^31 - 1.
  static PairFilter no_self_contact(std::vector<Index> group_of_vertex);
  /// Pairs of two static groups, or within one, are left out. `is_static`: one flag a group.
  static PairFilter no_static_pairs(std::vector<Index> group_of_vertex, const std::vector<bool>& is_static);
};

/// Every member has a default, so that {.threads = 1} names all there is to say, without a warning.
struct Options {
  /// Threads to use, >= 0, but no more than oneTBB allows the process (its global_control, by default one a core); 0:
  /// as many as the caller's oneTBB arena gives. The answer does not depend on it; Statistics say how many there were.
  int threads = 0;
  /// d >= 0, in the unit of the positions: contact means Euclidean distance <= d at some time.
  double min_separation = 0;
  /// A radius >= 0 for each group of filter.group_of_vertex, half of its thickness. Two features are in
  /// contact when their distance is at most `min_separation` plus both radii, for every question but intersections. A
  /// feature that joins groups has the largest radius of its vertices. Empty: all zero. A question throws
  /// InvalidOptions where its separation and twice a radius are more than any double.
  std::vector<double> radii = {};
  Isa isa = Isa::best;
  PairFilter filter = PairFilter();
  /// Asked again and again during a question, a thousand times a second or more; must be safe to call from several
  /// threads. Once it says true the question throws Cancelled; the detector answers the next one as if nothing was.
  std::function<bool()> is_cancelled = nullptr;
};

/// What a question may bring of its own: detector.contacts(step, {.min_separation = 1e-3}).
struct QueryOptions {
  /// In place of Options::min_separation, for this question alone (an activation distance, say); the hierarchy serves
  /// all.
  std::optional<double> min_separation = {};
  /// On curves a pair that cannot be told from one that touches at t=0 is taken for one.
  AtStart at_start = AtStart::report;
  /// Of paths: the widest bracket of a contact, a fraction of the step in (0, 1]. None: 1e-9.
  std::optional<double> tolerance = {};
};

}  // namespace tamis
