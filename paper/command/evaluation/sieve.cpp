// The pairs that DNF and NCF leave, and what further filters prove of them: explains the culling rate of NCF.
#include <fmt/format.h>

#include <algorithm>

#include "command/report.hpp"
#include "paper/command/evaluation/figures.hpp"

namespace tamis::lab {
namespace {

/// Numbers of the pairs that NCF leaves, by the first of the further filters that proves them free, or by none.
struct Left {
  std::uint64_t by_ncf, turn_over, slab_clip, axes, tested, contacts;

  Left(const MethodResult& sieve, std::uint64_t contacts_found)
      : by_ncf(sieve.entering("ncf")),
        turn_over(by_ncf - sieve.entering("slab")),
        slab_clip(sieve.entering("slab") - sieve.entering("sat")),
        axes(sieve.entering("sat") - sieve.entering("newton")),
        tested(sieve.entering("newton")),
        contacts(std::min(tested, contacts_found)) {}
};

std::string share(std::uint64_t part, std::uint64_t whole) {
  return fmt::format("{:.1f}%", whole == 0 ? 0.0 : kPercent * static_cast<double>(part) / static_cast<double>(whole));
}

}  // namespace

std::string paper_sieve(Results results) {
  std::string text =
      "\n## What NCF leaves, and why\n\nThe pairs that DNF and NCF leave, through further filters in turn. Each is "
      "counted where it is first proven free.\n\n"
      "| scene, step | left by NCF | free without the turn-over test | never near at one time (slab clip) | on one "
      "side "
      "of a constant axis (SAT, PFS) | no filter: no contact | contacts |\n|---|--:|--:|--:|--:|--:|--:|\n";
  for (const SceneResult& r : results) {
    const Left left(r.sieve, r.method("paper").contacts);
    const auto cell = [&](std::uint64_t part) { return share(part, left.by_ncf); };
    text += fmt::format("| {} | {} | {} | {} | {} | {} | {} |\n", row_name(r), cli::grouped(left.by_ncf),
                        cell(left.turn_over), cell(left.slab_clip), cell(left.axes), cell(left.tested - left.contacts),
                        cell(left.contacts));
  }
  return text + R"(
NCF needs one sign that holds during the whole step. It leaves two kinds of pairs. The first kind is near all along, as neighbours
in a sheet and layers that rest on each other. The second kind is not near at any one time, although each feature passes where the
other has been or will be. Then the sign changes while the pair is far apart. The slab clip culls the second kind, because it
compares boxes at the same time. Constant axes cull much of the first. Contacts, which no filter may cull, are counted apart.
)";
}

}  // namespace tamis::lab
