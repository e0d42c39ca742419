// What the tables and claims of tamis-lab paper are made of: the paper's numbers, and ratios and rates of ours.
#pragma once
#include <span>
#include <string>
#include <string_view>

#include "lab/command/evaluation/run.hpp"

namespace tamis::lab {

inline constexpr double kPercent = 100;

using Results = std::span<const SceneResult>;

/// A row of the paper's Table 1: 2.33 GHz Pentium, one thread.
struct PublishedRow {
  std::string_view scene;
  int factor;
  double milliseconds, over_sat, over_r_triangles;
};

/// Null if the paper has no such scene and step.
const PublishedRow* published_row(const SceneResult& result);

/// "airbag 3x".
std::string row_name(const SceneResult& result);

/// How many times faster.
double ratio(const SceneResult& result, std::string_view slow, std::string_view fast);

/// Which kinds of pairs are counted.
enum class Counted : std::uint8_t { both, vf, ee };

/// Of the pairs that enter `from`, the part that does not enter `to`; stages of one method. 0 if none enters.
double culled_between(const MethodResult& method, std::string_view from, std::string_view to,
                      Counted counted = Counted::both);

/// What NCF culls of the pairs that DNF leaves.
double ncf_rate(const SceneResult& result);
/// The same among the pairs that are no contact, the only ones that a sound filter can cull.
double ncf_rate_of_false_pairs(const SceneResult& result);

/// The paper's claims and ours, one by one: each holds, or on which rows it does not.
std::string paper_claims(Results results);

/// What NCF leaves, and which other filter proves how much of it free.
std::string paper_sieve(Results results);

}  // namespace tamis::lab
