#include "command/answers.hpp"

#include <fmt/format.h>

#include "command/command_line/printable.hpp"

namespace tamis::cli {
namespace {

void print_bracket(double toi_lower, double toi_upper) {
  fmt::print("first contact   at {:.12g} of the step; free before {}, proven; bracket {:.1e} wide\n", toi_upper,
             toi_lower, toi_upper - toi_lower);
}

/// Of a part of the mesh: contacts of what was left out may come first.
void print_of_rest(bool is_free, double toi_upper) {
  if (is_free)
    fmt::print("first contact   none among the other objects\n");
  else
    fmt::print("first contact   of the other objects at {:.12g} of the step\n", toi_upper);
}

/// Prints two features. `bodies`: the names of their bodies; empty if all are of one mesh.
void print_between(PairKind kind, const std::array<Index, 4>& v, const std::array<std::string, 2>& bodies = {}) {
  const auto [first, second] = [&]() -> std::array<std::string, 2> {
    switch (kind) {
      case PairKind::vertex_face:
        return {fmt::format("vertex {}", v[0]), fmt::format("face {} {} {}", v[1], v[2], v[3])};
      case PairKind::edge_edge:
        return {fmt::format("edge {} {}", v[0], v[1]), fmt::format("edge {} {}", v[2], v[3])};
      case PairKind::vertex_edge:
        return {fmt::format("vertex {}", v[0]), fmt::format("edge {} {}", v[1], v[2])};
      case PairKind::vertex_vertex:
        return {fmt::format("vertex {}", v[0]), fmt::format("vertex {}", v[1])};
    }
    return {};
  }();
  const auto of = [](const std::string& body) { return body.empty() ? "" : fmt::format(" of {}", printable(body)); };
  fmt::print("between         {}{} and {}{}", first, of(bodies[0]), second, of(bodies[1]));
}

void print_limit(const SafeStep& safe, double keep, const std::string& distance) {
  if (safe.toi_lower == 0)
    fmt::print("step            0: a pair {}\n",
               safe.toi_upper > 0 ? "is too near at the start for the smallest step" : "touches at the start");
  else if (keep == 0)
    fmt::print("step            {}; no pair touches before it, proven\n", safe.toi_lower);
  else
    fmt::print("step            {}; on it every pair keeps {} of its {}, proven\n", safe.toi_lower, keep, distance);
  if (safe.toi_lower > 0 && safe.toi_upper < 1)
    fmt::print("largest         not above {}, proven: {:.1e} more\n", safe.toi_upper, safe.toi_upper - safe.toi_lower);
}

}  // namespace

void print_tally(const Tally& tally, bool is_of_all) {
  fmt::print("contacts        {} vertex-face, {} edge-edge{}\n", grouped(tally.vf), grouped(tally.ee),
             of_loose_points(tally.ve, tally.vv));
  if (tally.unresolved > 0)
    fmt::print("unresolved      {} of them: they may touch, or only come close\n", grouped(tally.unresolved));
  if (!is_of_all)
    print_of_rest(tally.is_free(), tally.toi_upper);
  else if (tally.is_free())
    fmt::print("first contact   none: the step is free, proven\n");
  else if (tally.unresolved == tally.contacts())
    fmt::print("first contact   unresolved; free before {}, proven\n", tally.toi_lower);
  else
    print_bracket(tally.toi_lower, tally.toi_upper);
}

void add_tally(Json& json, const Tally& tally, bool is_of_all) {
  json["contacts"] = json_of(tally);
  add_bracket(json, tally.is_free() && is_of_all, is_of_all ? tally.toi_lower : 0, tally.toi_upper);
}

void print_contact(const Contact& c, const std::array<std::string, 2>& bodies) {
  print_between(c.kind, c.vertices, bodies);
  fmt::print(", u = {:.6g}, v = {:.6g}, normal ({:.6g}, {:.6g}, {:.6g})\n", c.u, c.v, c.normal[0], c.normal[1],
             c.normal[2]);
}

void print_earliest(const EarliestContact& first, bool is_of_all) {
  if (!is_of_all)
    print_of_rest(!first.contact, first.toi_upper);
  else if (first.contact)
    print_bracket(first.toi_lower, first.toi_upper);
  else
    fmt::print("first contact   none: the whole step is free, proven\n");
  if (first.contact) print_contact(*first.contact);
}

void add_earliest(Json& json, const EarliestContact& first, bool is_of_all) {
  add_bracket(json, !first.contact && is_of_all, is_of_all ? first.toi_lower : 0, first.toi_upper);
  json["contact"] = first.contact ? json_of(*first.contact) : Json();
}

void print_safe_step(const SafeStep& safe, double keep, double min_separation) {
  const std::string distance =
      min_separation > 0 ? fmt::format("distance beyond {}", min_separation) : std::string("distance");
  if (!safe.pair) {
    fmt::print("step            1: the whole step may go, proven\n");
    return;
  }
  print_limit(safe, keep, distance);
  print_between(safe.pair->kind, safe.pair->vertices);
  fmt::print(", {:.6g} apart at the start\n", safe.pair->distance);
}

void add_safe_step(Json& json, const SafeStep& safe, double keep) {
  json["keep"] = keep;
  json["toi_lower"] = safe.toi_lower;
  json["toi_upper"] = safe.toi_upper;
  json["pair"] = safe.pair ? json_of(*safe.pair) : Json();
}

void print_ignored(const Statistics& statistics) {
  if (statistics.ignored == 0) return;
  fmt::print("ignored         {} at START, and not again once apart\n",
             counted(statistics.ignored, "pair that touches", "pairs that touch"));
}

void print_free(bool is_free, const std::string& during) {
  if (is_free)
    fmt::print("free            no contact during {}, proven\n", during);
  else
    fmt::print("not free        there is a contact ('tamis earliest' tells where)\n");
}

}  // namespace tamis::cli
