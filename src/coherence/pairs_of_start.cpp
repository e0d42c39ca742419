#include "coherence/pairs_of_start.hpp"

#include <algorithm>
#include <cmath>

#include "numerics/error_bounds.hpp"
#include "topology/at.hpp"
#include "topology/largest_beside.hpp"

namespace tamis {
namespace {

/// Lists hold ways to come from the same start: a vertex may go so much farther than it went from this one or the one
/// before, and so many times as far as they go on the average.
constexpr double kFarther = 1.5, kBesides = 0.5;
/// Where squares are too small for it, the least length.
constexpr double kLeastLength = 0x1p-500;

/// No less than it is.
double length_at_most(const Step& step, Index v) {
  double sum = 0;
  for (int axis = 0; axis < 3; ++axis) {
    const double length = step.end[v][axis] - step.start[v][axis];
    sum += length * length;
  }
  return std::sqrt(sum) * kRoundedUp + kLeastLength;
}

}  // namespace

bool PairsOfStart::begin(const Query& query, double fraction, bool lists_all) {
  starts_again_ = starts_again(query.step);
  if (starts_again_) {
    is_truncated_again_ |= is_truncated_ && !lists_all;
    is_truncated_ |= lists_all;
    for (const Index v : mesh_.points()) ways_[at(v)] = std::max(ways_[at(v)], length_at_most(query.step, v));
    if (are_listed_ && covers(query, fraction)) return true;
  } else {
    start_anew(query.step);
  }
  return false;
}

void PairsOfStart::start_anew(const Step& step) {
  forget();
  pause_.tick();
  were_truncated_again_ = {is_truncated_again_, were_truncated_again_[0]};
  is_truncated_ = is_truncated_again_ = false;
  ways_before_.swap(ways_);
  const auto count = at(mesh_.vertex_count());
  ways_before_.resize(count);
  ways_.assign(count, 0);
  start_.resize(count);
  for (const Index v : mesh_.points()) std::copy_n(step.start[v], 3, start_[at(v)].begin());
}

bool PairsOfStart::starts_again(const Step& step) const {
  return !start_.empty() && std::all_of(mesh_.points().begin(), mesh_.points().end(), [&](Index v) {
    return std::equal(step.start[v], step.start[v] + 3, start_[at(v)].begin());
  });
}

/// A pair beyond separations() has more than (way + way) / (1 - fraction) besides what it is to keep apart, so that
/// its vertices leave it more than `fraction` of that: a feature's reach is no less than its room and its radius, which
/// may be those of two vertices (largest_beside).
bool PairsOfStart::covers(const Query& query, double fraction) const {
  if (query.separations.fixed > separation_ || query.separations.radii.data() != radii_) return false;
  return std::all_of(mesh_.points().begin(), mesh_.points().end(),
                     [&](Index v) { return length_at_most(query.step, v) <= (1 - fraction) * room_[at(v)]; });
}

bool PairsOfStart::plan(const Query& query, double fraction) {
  if (!starts_again_ || pause_.left > 0) return false;
  if (!is_truncated_again_ && !were_truncated_again_[0] && !were_truncated_again_[1]) return false;
  const double besides = kBesides * mean_of_ways();
  forget();
  room_.resize(start_.size());
  reach_.resize(start_.size());
  const std::vector<double> radii = largest_beside(mesh_, query.separations.radii);
  for (const Index index : mesh_.points()) {
    const auto v = at(index);
    room_[v] = (kFarther * std::max(ways_[v], ways_before_[v]) + besides) / (1 - fraction) * kRoundedUp;
    reach_[v] = (room_[v] + (radii.empty() ? 0 : radii[v])) * kRoundedUp;
    if (!std::isfinite(reach_[v])) return false;
  }
  radii_ = query.separations.radii.data();
  separation_ = query.separations.fixed;
  return true;
}

double PairsOfStart::mean_of_ways() const {
  double sum = 0;
  for (const Index v : mesh_.points()) sum += ways_[at(v)];
  return sum / static_cast<double>(std::max<std::size_t>(1, mesh_.points().size()));
}

bool PairsOfStart::complete(bool hold_all) {
  are_listed_ = hold_all;
  if (hold_all) {
    pause_.lists_were_worth_it();
    return true;
  }
  pause_.begin();
  forget();
  return false;
}

void PairsOfStart::forget() {
  are_listed_ = false;
  lists_.clear();
}

}  // namespace tamis
