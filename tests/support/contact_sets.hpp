// Contacts as sets, and the naive way to find all of them: the oracle decides every pair of features.
#pragma once
#include <array>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "oracle/oracle.hpp"
#include "scenes/scene.hpp"
#include "support/yardstick/methods.hpp"
#include "tamis/contact.hpp"

namespace tamis::test {

using yardstick::Method;

/// Identifies a pair of features. Sets of these compare contacts regardless of their order and of duplicates.
struct PairName {
  PairKind kind;
  std::array<Index, 4> vertices;
  auto operator<=>(const PairName&) const = default;
};
using PairSet = std::set<PairName>;

PairSet names_of(std::span<const Contact> contacts);
PairSet certified_names_of(std::span<const Contact> contacts);

/// All methods. They must all give the same set.
inline constexpr std::array kMethods{Method::brute, Method::tamis};

inline yardstick::Options with(yardstick::Method method, double min_separation = 0) {
  yardstick::Options options;
  options.method = method;
  options.min_separation = min_separation;
  return options;
}

/// All contacts of the scene by a new detector.
std::vector<Contact> find_contacts(const scenes::Scene& scene, const yardstick::Options& options);
PairSet find_names(const scenes::Scene& scene, const yardstick::Options& options);

/// The true contacts, by the oracle, from the scene's own lists of faces and edges.
PairSet oracle_contacts(const scenes::Scene& scene);

/// A filter that lets about `count` of the scene's pairs pass, the same for every method. For tests with the oracle,
/// which is slow.
PairFilter some_pairs(const scenes::Scene& scene, std::uint64_t count);

/// How the four vertices of a pair move.
oracle::Motion motion_of(const scenes::Scene& scene, const std::array<Index, 4>& vertices);

/// The largest |coordinate| at the start.
double size_at_start(const scenes::Scene& scene);

/// Names a few of the pairs that are in `a` but not in `b`, for a failure message; empty if there are none.
std::string missing(const PairSet& a, const PairSet& b);

}  // namespace tamis::test
