// The answers to one step, for people and as JSON, whoever found them.
#pragma once
#include <array>
#include <string>

#include "command/report.hpp"

namespace tamis::cli {

/// How many contacts of which kind, and the first. Unless the answer is about all of the mesh, nothing is proven free.
void print_tally(const Tally& tally, bool is_of_all = true);
void add_tally(Json& json, const Tally& tally, bool is_of_all = true);

/// `bodies`: the names of the features' bodies; empty if the question is about one mesh.
void print_contact(const Contact& contact, const std::array<std::string, 2>& bodies = {});

void print_earliest(const EarliestContact& first, bool is_of_all = true);
void add_earliest(Json& json, const EarliestContact& first, bool is_of_all = true);

/// `keep`: the part of the distance beyond `min_separation` that every pair was to keep.
void print_safe_step(const SafeStep& safe, double keep, double min_separation);
void add_safe_step(Json& json, const SafeStep& safe, double keep);

/// How many pairs were not counted because they touch at the start; nothing if there are none.
void print_ignored(const Statistics& statistics);

/// `during`: "the step".
void print_free(bool is_free, const std::string& during);

}  // namespace tamis::cli
