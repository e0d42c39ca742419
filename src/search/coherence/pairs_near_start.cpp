#include "search/coherence/pairs_near_start.hpp"

#include <algorithm>
#include <cmath>

#include "numbers/error_bounds.hpp"
#include "numbers/in_parts.hpp"
#include "numbers/mean_of_most.hpp"
#include "search/topology/at.hpp"
#include "search/topology/neighbourhood_maximum.hpp"

namespace tamis {
namespace {

/// Lists must also serve larger displacements: kFarther times those seen so far from this start or the one before, plus
/// kExtra times the mean displacement.
constexpr double kFarther = 1.5, kExtra = 0.5;
/// Longer than every length whose square underflows.
constexpr double kLeastLength = 0x1p-500;

/// An upper bound of how far the vertex moves.
double displacement_bound(const Step& step, Index v) {
  double sum = 0;
  for (int axis = 0; axis < 3; ++axis) {
    const double length = step.end[v][axis] - step.start[v][axis];
    sum += length * length;
  }
  return std::sqrt(sum) * kRoundedUp + kLeastLength;
}

}  // namespace

bool PairsNearStart::begin(const Query& query, double fraction, bool lists_all) {
  fraction_ = fraction;
  lists_all_ = lists_all;
  same_start_ = has_same_start(query.step);
  if (!same_start_) {
    start_anew(query.step);
    return false;
  }
  is_truncated_again_ |= is_truncated_ && !lists_all;
  is_truncated_ |= lists_all;
  for_each_in_parts(mesh_.points(), kVerticesPerPart, [&](Index v) {
    displacements_[at(v)] = std::max(displacements_[at(v)], displacement_bound(query.step, v));
  });
  return are_listed_ && covers(query);
}

void PairsNearStart::start_anew(const Step& step) {
  forget();
  pause_.tick();
  were_truncated_again_ = {is_truncated_again_, were_truncated_again_[0]};
  is_truncated_ = is_truncated_again_ = false;
  previous_displacements_.swap(displacements_);
  const auto count = at(mesh_.vertex_count());
  previous_displacements_.resize(count);
  displacements_.assign(count, 0);
  start_.resize(count);
  for_each_in_parts(mesh_.points(), kVerticesPerPart,
                    [&](Index v) { std::copy_n(step.start[v], 3, start_[at(v)].begin()); });
}

bool PairsNearStart::has_same_start(const Step& step) const {
  return !start_.empty() && all_in_parts(mesh_.points(), kVerticesPerPart, [&](Index v) {
    return std::equal(step.start[v], step.start[v] + 3, start_[at(v)].begin());
  });
}

/// A pair that is not listed is farther apart than separations(), so its clearance exceeds the sum of both
/// displacements over (1 - fraction). More than `fraction` of it is left. A feature's listing radius is at least its
/// search radius plus its contact radius, even if different vertices give these (neighbourhood_maximum).
bool PairsNearStart::covers(const Query& query) const {
  if (query.separations.fixed > separation_ || query.separations.radii.data() != radii_) return false;
  return all_in_parts(mesh_.points(), kVerticesPerPart, [&](Index v) {
    return displacement_bound(query.step, v) <= (1 - fraction_) * search_radii_[at(v)];
  });
}

std::optional<Listing> PairsNearStart::plan(const Query& query) {
  if (!lists_all_ || !same_start_ || pause_.left > 0) return {};
  if (!is_truncated_again_ && !were_truncated_again_[0] && !were_truncated_again_[1]) return {};
  const double extra = kExtra * mean_displacement();
  forget();
  search_radii_.resize(start_.size());
  listing_radii_.resize(start_.size());
  const std::vector<double> radii = neighbourhood_maximum(mesh_, query.separations.radii);
  for (const Index index : mesh_.points()) {
    const auto v = at(index);
    search_radii_[v] =
        (kFarther * std::max(displacements_[v], previous_displacements_[v]) + extra) / (1 - fraction_) * kRoundedUp;
    listing_radii_[v] = (search_radii_[v] + (radii.empty() ? 0 : radii[v])) * kRoundedUp;
    if (!std::isfinite(listing_radii_[v])) return {};
  }
  radii_ = query.separations.radii.data();
  separation_ = query.separations.fixed;
  return Listing{{query.step.start, query.step.start}, {separation_, listing_radii_}};
}

double PairsNearStart::mean_displacement() const {
  const auto points = mesh_.points();
  return mean_of_most(points.size(), 1, [&](std::size_t i) { return displacements_[at(points[i])]; });
}

void PairsNearStart::end_listing(bool is_complete) {
  KeptLists::end_listing(is_complete);
  if (is_complete) pause_.lists_were_worth_it();
}

}  // namespace tamis
