// Contacts of a step in numbers, for people and as JSON. The keys are listed in docs/files-and-command.md.
#pragma once
#include <cstdint>
#include <span>

#include "files/output/json.hpp"
#include "tamis/contact.hpp"
#include "tamis/statistics.hpp"

namespace tamis::io {

/// Contacts of a step by kind, and the bracket of the first.
struct Tally {
  std::uint64_t vf = 0;
  std::uint64_t ee = 0;
  std::uint64_t ve = 0;
  std::uint64_t vv = 0;
  std::uint64_t unresolved = 0;  ///< among the above; only on curves
  double toi_lower = 1;
  double toi_upper = 1;

  std::uint64_t contacts() const { return vf + ee + ve + vv; }
  bool is_free() const { return contacts() == 0; }
  /// Adds the counts; brackets of different steps cannot be added.
  void add_counts(const Tally& step);
};

Tally tally_of(std::span<const Contact> contacts);

Json json_of(const Tally& tally);
/// Adds toi_lower and toi_upper: null if the step is free.
void add_bracket(Json& json, bool is_free, double toi_lower, double toi_upper);
/// Adds stages: the pairs that enter each.
void add_stages(Json& json, std::span<const StageCount> stages);

}  // namespace tamis::io
