// Figures for the tables and claims of tamis-lab paper: the paper's numbers, and ratios and rates of our results.
#pragma once
#include <span>
#include <string>
#include <string_view>

#include "paper/command/evaluation/run.hpp"

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

/// How many times faster `fast` is than `slow`, both names of methods.
double ratio(const SceneResult& result, std::string_view slow, std::string_view fast);

/// Which kinds of pairs are counted.
enum class Counted : std::uint8_t { both, vf, ee };

/// The part of the pairs entering stage `from` that does not enter stage `to`. 0 if none enters `from`.
double culled_between(const MethodResult& method, std::string_view from, std::string_view to,
                      Counted counted = Counted::both);

/// The part that NCF culls of the pairs that DNF leaves.
double ncf_rate(const SceneResult& result);
/// The same, counting only pairs that are no contact: a sound filter can cull no others.
double ncf_rate_of_false_pairs(const SceneResult& result);

/// The paper's claims and ours, one by one: whether each holds, and if not, on which rows it fails.
std::string paper_claims(Results results);

/// The pairs that NCF leaves, and how many of them each further filter proves free.
std::string paper_sieve(Results results);

}  // namespace tamis::lab
