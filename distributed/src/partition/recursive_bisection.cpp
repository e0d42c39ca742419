#include "distributed/src/partition/recursive_bisection.hpp"

#include <algorithm>
#include <cmath>

namespace tamis::distributed {
namespace {

/// Each pass looks at 64 places in every cell at once: after four a cut is known to 2^-24 of its cell.
constexpr std::size_t kBins = 64;
constexpr int kPasses = 4;

/// Parts that are still in one cell, and the cut that will divide it.
struct Cell {
  int first_part, parts;
  std::size_t axis = 0;
  double low = 0, high = 0;  ///< the cut lies between these
  std::uint64_t before = 0;  ///< weight below `low`
  std::uint64_t wanted = 0;  ///< weight below the cut

  int lower_parts() const { return parts / 2; }
  std::size_t bin_of(double x) const {
    const double bin = (x - low) / (high - low) * static_cast<double>(kBins);
    return bin >= static_cast<double>(kBins - 1) ? kBins - 1 : bin > 0 ? static_cast<std::size_t>(bin) : 0;
  }
  double end_of_bin(std::size_t bin) const {
    return bin + 1 == kBins ? high : low + (high - low) * (static_cast<double>(bin + 1) / static_cast<double>(kBins));
  }
};

class Bisection {
 public:
  Bisection(Communicator& communicator, std::span<const Point> points, std::span<const std::uint64_t> weights)
      : communicator_(communicator), points_(points), weights_(weights), cell_of_(points.size(), 0) {
    cells_ = {{0, communicator.size()}};
  }

  std::vector<int> run() {
    while (std::ranges::any_of(cells_, [](const Cell& cell) { return cell.parts > 1; })) {
      choose_axes();
      weigh();
      for (int pass = 0; pass < kPasses; ++pass) narrow();
      cut();
    }
    std::vector<int> parts;
    for (const std::size_t cell : cell_of_) parts.push_back(cells_[cell].first_part);
    return parts;
  }

 private:
  /// Chooses the longest axis of each cell.
  void choose_axes() {
    std::vector<double> ends(6 * cells_.size(), HUGE_VAL);
    for (std::size_t i = 0; i < points_.size(); ++i)
      for (std::size_t axis = 0; axis < 3; ++axis) {
        double* end = &ends[6 * cell_of_[i] + 2 * axis];
        end[0] = std::min(end[0], points_[i][axis]);
        end[1] = std::min(end[1], -points_[i][axis]);
      }
    communicator_.reduce_to_least(ends);
    for (std::size_t c = 0; c < cells_.size(); ++c) {
      const auto length = [&](std::size_t axis) { return -ends[6 * c + 2 * axis + 1] - ends[6 * c + 2 * axis]; };
      Cell& cell = cells_[c];
      cell.axis = 0;
      for (std::size_t axis = 1; axis < 3; ++axis)
        if (length(axis) > length(cell.axis)) cell.axis = axis;
      cell.low = ends[6 * c + 2 * cell.axis];
      cell.high = std::nextafter(-ends[6 * c + 2 * cell.axis + 1], HUGE_VAL);
    }
  }

  void weigh() {
    std::vector<std::uint64_t> totals(cells_.size(), 0);
    for (std::size_t i = 0; i < points_.size(); ++i) totals[cell_of_[i]] += weights_[i];
    communicator_.reduce_to_sum(totals);
    for (std::size_t c = 0; c < cells_.size(); ++c) {
      Cell& cell = cells_[c];
      cell.before = 0;
      cell.wanted = totals[c] / static_cast<std::uint64_t>(cell.parts) * static_cast<std::uint64_t>(cell.lower_parts());
    }
  }

  /// Narrows each cell's bounds of the cut to the bin in which the wanted weight is reached.
  void narrow() {
    std::vector<std::uint64_t> bins(kBins * cells_.size(), 0);
    for (std::size_t i = 0; i < points_.size(); ++i) {
      const Cell& cell = cells_[cell_of_[i]];
      const double x = points_[i][cell.axis];
      if (x >= cell.low && x < cell.high) bins[kBins * cell_of_[i] + cell.bin_of(x)] += weights_[i];
    }
    communicator_.reduce_to_sum(bins);
    for (std::size_t c = 0; c < cells_.size(); ++c) {
      Cell& cell = cells_[c];
      std::size_t bin = 0;
      while (bin + 1 < kBins && cell.before + bins[kBins * c + bin] < cell.wanted)
        cell.before += bins[kBins * c + bin++];
      const double high = cell.end_of_bin(bin);
      if (bin > 0) cell.low = cell.end_of_bin(bin - 1);
      cell.high = high;
    }
  }

  /// Cuts all cells with more than one part.
  void cut() {
    std::vector<Cell> next;
    std::vector<std::size_t> lower_of;
    for (const Cell& cell : cells_) {
      lower_of.push_back(next.size());
      if (cell.parts == 1) {
        next.push_back(cell);
        continue;
      }
      next.push_back({cell.first_part, cell.lower_parts()});
      next.push_back({cell.first_part + cell.lower_parts(), cell.parts - cell.lower_parts()});
    }
    for (std::size_t i = 0; i < points_.size(); ++i) {
      const Cell& cell = cells_[cell_of_[i]];
      const bool is_upper = cell.parts > 1 && points_[i][cell.axis] >= cell.high;
      cell_of_[i] = lower_of[cell_of_[i]] + (is_upper ? 1 : 0);
    }
    cells_ = std::move(next);
  }

  Communicator& communicator_;
  std::span<const Point> points_;
  std::span<const std::uint64_t> weights_;
  std::vector<std::size_t> cell_of_;
  std::vector<Cell> cells_;
};

}  // namespace

std::vector<int> bisect(Communicator& communicator, std::span<const Point> points,
                        std::span<const std::uint64_t> weights) {
  return Bisection(communicator, points, weights).run();
}

}  // namespace tamis::distributed
