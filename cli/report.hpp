// Answers and costs, as JSON and for people. The keys are listed in docs/files-and-command.md.
#pragma once
#include <cstdint>
#include <nlohmann/json.hpp>
#include <span>
#include <string>

#include "cli/timing.hpp"
#include "tamis/contact.hpp"
#include "tamis/detector.hpp"

namespace tamis::cli {

using Json = nlohmann::ordered_json;

/// Contacts of a step by kind, and the bracket of the first.
struct Tally {
  std::uint64_t vf = 0;
  std::uint64_t ee = 0;
  std::uint64_t ve = 0;
  std::uint64_t vv = 0;
  std::uint64_t unresolved = 0;
  double toi_lower = 1;
  double toi_upper = 1;

  std::uint64_t contacts() const { return vf + ee + ve + vv; }
  bool is_free() const { return contacts() == 0; }
  /// Adds the counts; brackets of different steps cannot be added.
  void add_counts(const Tally& step);
};

Tally tally_of(std::span<const Contact> contacts);

Json json_of(const Tally& tally);
Json json_of(const Seconds& seconds);
Json json_of(const Contact& contact);
Json json_of(const LimitingPair& pair);
/// Adds toi_lower and toi_upper: null if the step is free.
void add_bracket(Json& json, bool is_free, double toi_lower, double toi_upper);
/// Adds stages: the pairs that enter each.
void add_stages(Json& json, std::span<const StageCount> stages);
/// Adds what every question has: seconds, stages, decided_by, threads, method and so on.
void add_costs(Json& json, const Detector& detector, const Timing& timing);
/// The one object on stdout.
void print_json(const Json& json);

void print_mesh(const Mesh& mesh);
void print_costs(const Detector& detector, const Timing& timing, int repeat);

/// Largest memory this process held so far.
std::uint64_t peak_memory_bytes();
/// 1234567 as "1,234,567".
std::string grouped(std::uint64_t number);
/// Seconds in a unit that suits them.
std::string readable(double seconds);

}  // namespace tamis::cli
