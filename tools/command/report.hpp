// Answers and costs, as JSON and for people. The keys are listed in docs/files-and-command.md.
#pragma once
#include <cstdint>
#include <string>
#include <string_view>

#include "command/timing.hpp"
#include "files/tally.hpp"
#include "tamis/contact.hpp"
#include "tamis/detector.hpp"

namespace tamis::cli {

using io::add_bracket;
using io::add_stages;
using io::Json;
using io::json_of;
using io::Tally;
using io::tally_of;

Json json_of(const Seconds& seconds);
Json json_of(const Contact& contact);
Json json_of(const NearPair& pair);
/// Adds what every question has: seconds, stages, decided_by, threads and so on.
void add_costs(Json& json, const Detector& detector, const Timing& timing);
/// The one object on stdout.
void print_json(const Json& json);

void print_mesh(const Mesh& mesh);
/// The mesh, and which pairs are left out of every answer by --rings.
void print_asked(const Detector& detector);
/// `only_kind`: the name of the pairs' kind, if there is only one kind.
void print_costs(const Statistics& statistics, const Timing& timing, int repeat, std::string_view only_kind = {});

/// 1234567 as "1,234,567".
std::string grouped(std::uint64_t number);
/// "1 triangle", "2,000 triangles". `nouns`: the plural, unless it is `noun` and an s.
std::string counted(std::uint64_t number, std::string_view noun, std::string_view nouns = {});
/// ", 1 vertex-edge, 0 vertex-vertex"; empty if there is neither: only meshes with loose points have such pairs.
std::string of_loose_points(std::uint64_t ve, std::uint64_t vv);
/// A time of the step with ten decimals, rounded down: if nothing touches before `time`, nothing touches before the
/// printed time.
std::string no_later(double time);
/// Seconds in a unit that suits them.
std::string readable(double seconds);

}  // namespace tamis::cli
