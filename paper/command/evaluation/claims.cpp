// The claims of tamis-lab paper's report, checked row by row.
#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <string>

#include "paper/command/evaluation/figures.hpp"

namespace tamis::lab {
namespace {

/// The culling rate that the paper claims for NCF after DNF.
constexpr double kClaimedRate = 0.9;

/// Counts the rows on which a claim holds, and names the others.
struct CullingTally {
  std::size_t rows = 0, holds = 0;
  std::string fails;

  void count(const SceneResult& r, bool is_true) {
    ++rows;
    holds += is_true ? 1 : 0;
    if (!is_true) fails += (fails.empty() ? "" : ", ") + row_name(r);
  }
  std::string text() const {
    return holds == rows ? fmt::format("all {}.", rows) : fmt::format("{} of {}. It fails on {}.", holds, rows, fails);
  }
};

template <class Holds>
std::string claim(Results results, const std::string& words, const Holds& holds) {
  CullingTally ours, others;
  for (const SceneResult& r : results) (published_row(r) ? ours : others).count(r, holds(r));
  std::string text = fmt::format("- {}.", words);
  if (ours.rows > 0)
    text += fmt::format(" This **{}** on the rows that the paper has: {}",
                        ours.holds == ours.rows ? "holds" : "does not hold", ours.text());
  if (others.rows > 0) text += fmt::format(" On other rows: {}", others.text());
  return text + "\n";
}

/// Formats the smallest and the largest value of a figure over all rows.
template <class Figure>
std::string range(Results results, const char* format, const Figure& figure) {
  double least = std::numeric_limits<double>::infinity(), most = -least;
  for (const SceneResult& r : results) {
    least = std::min(least, figure(r));
    most = std::max(most, figure(r));
  }
  return fmt::format(fmt::runtime(format), least, most);
}

std::string claim_of_speed(Results results, const std::string& words, const char* slow, const char* fast) {
  const auto times = [&](const SceneResult& r) { return ratio(r, slow, fast); };
  return claim(results, words + range(results, " ({:.2f} to {:.2f} times)", times),
               [&](const SceneResult& r) { return times(r) > 1; });
}

/// Among the filters that look at the whole step, as the paper's competitors do.
bool pfs_culls_best(const SceneResult& r) {
  const std::uint64_t pfs = r.method("paper-pfs").elementary_tests();
  return std::all_of(r.methods.begin(), r.methods.end(),
                     [&](const MethodResult& m) { return m.method == "tamis" || pfs <= m.elementary_tests(); });
}

}  // namespace

std::string paper_claims(Results results) {
  std::string text = "\n## The paper's claims, one by one\n\n";
  text += claim(results,
                "NCF culls over 90% of what DNF leaves" +
                    range(results, " ({:.1f} to {:.1f}%)", [](const auto& r) { return kPercent * ncf_rate(r); }),
                [](const auto& r) { return ncf_rate(r) > kClaimedRate; });
  text += claim(results, "NCF culls over 90% of the pairs without a contact that DNF leaves",
                [](const auto& r) { return ncf_rate_of_false_pairs(r) > kClaimedRate; });
  text += claim_of_speed(results, "DNF+NCF is faster than SAT", "paper-sat", "paper");
  text += claim_of_speed(results, "DNF+NCF is faster than R-triangles alone", "paper-r-triangles", "paper");
  text += claim(results, "PFS culls best of all filters", pfs_culls_best);
  text += "\nTwo claims of this project:\n\n";
  text += claim_of_speed(results, "The default method is faster than the published one", "paper", "tamis");
  text += claim(results, "Every method finds the same contacts in every step",
                [](const auto& r) { return r.sets_agree(); });
  return text;
}

}  // namespace tamis::lab
