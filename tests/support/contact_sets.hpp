// Contacts as sets, and the naive way to all of them: every pair of features, each judged by the oracle.
#pragma once
#include <array>
#include <set>
#include <string>
#include <vector>

#include "lab/detector.hpp"
#include "oracle/oracle.hpp"
#include "scenes/scene.hpp"
#include "tamis/contact.hpp"

namespace tamis::test {

using lab::Method;

/// Which pair of features: comparing these compares sets of contacts, whatever order or number of times they come in.
struct PairName {
  PairKind kind;
  std::array<Index, 4> vertices;
  auto operator<=>(const PairName&) const = default;
};
using PairSet = std::set<PairName>;

PairSet names_of(const std::vector<Contact>& contacts);
PairSet certified_names_of(const std::vector<Contact>& contacts);

/// The methods there are: they must all give the same set.
inline constexpr std::array kMethods{Method::brute, Method::tamis, Method::paper};

/// All contacts of the scene by a new detector.
std::vector<Contact> find_contacts(const scenes::Scene& scene, const lab::Options& options);
PairSet find_names(const scenes::Scene& scene, const lab::Options& options);

/// The truth: from the scene's own lists of faces and edges, by the oracle.
PairSet oracle_contacts(const scenes::Scene& scene);

/// Lets about `count` of the scene's pairs pass, the same for every method: the oracle takes its time.
PairFilter some_pairs(const scenes::Scene& scene, std::uint64_t count);

/// How the four vertices of a pair move.
oracle::Motion motion_of(const scenes::Scene& scene, const std::array<Index, 4>& vertices);

/// What is in `a` but not in `b`, at most a few, for a failure message; empty if there is nothing.
std::string missing(const PairSet& a, const PairSet& b);

}  // namespace tamis::test
