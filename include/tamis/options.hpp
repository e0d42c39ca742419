// Everything a caller may choose, each with its default.
#pragma once
#include <cstdint>
#include <functional>
#include <string_view>
#include <vector>

#include "tamis/contact.hpp"

namespace tamis {

/// Instruction set of the hot loops; every one gives the same bits. `best`: the widest that this machine has.
enum class Isa : std::uint8_t { best, baseline, avx2, avx512 };

/// Names as on the command line, and back. Throws InvalidOptions, naming the choices, if there is no such name.
Isa isa_from_name(std::string_view name);
std::string_view name_of(Isa);
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

  bool empty() const { return groups_may_touch.empty() && !accepts; }
  /// Pairs within one group are left out (no self-contact). One group a vertex, as above.
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
  /// A radius >= 0 for each group of filter.group_of_vertex: thickness is half on each side. Two features are in
  /// contact when their distance is at most `min_separation` plus both radii, for every question. A feature that joins
  /// groups has the largest radius of its vertices. Empty: all zero.
  std::vector<double> thickness = {};
  Isa isa = Isa::best;
  PairFilter filter = PairFilter();
  /// Asked again and again during a question, a thousand times a second or more; must be safe to call from several
  /// threads. Once it says true the question throws Cancelled; the detector answers the next one as if nothing was.
  std::function<bool()> is_cancelled = nullptr;
};

}  // namespace tamis
