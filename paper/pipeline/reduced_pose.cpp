#include "paper/pipeline/reduced_pose.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "numbers/interval.hpp"
#include "search/topology/at.hpp"

namespace tamis::lab {
namespace {

/// Added to the diagonal of U^T U, relative to its trace, so that dependent columns of U leave it regular: they share
/// the motion that each of them could make.
constexpr double kRidge = 1e-12;

}  // namespace

PoseFinder::PoseFinder(const ReducedModel& model) : model_(model), factor_(at(model.modes) * at(model.modes), 0.0) {
  const std::size_t r = at(model.modes);
  for (std::size_t row = 0; row < 3 * model.rest.size(); ++row) {
    const double* u = model.basis.data() + row * r;
    for (std::size_t i = 0; i < r; ++i)
      for (std::size_t j = 0; j <= i; ++j) factor_[i * r + j] += u[i] * u[j];
  }
  double trace = 0;
  for (std::size_t i = 0; i < r; ++i) trace += factor_[i * r + i];
  for (std::size_t i = 0; i < r; ++i) {
    factor_[i * r + i] += kRidge * trace;
    for (std::size_t j = 0; j <= i; ++j) {
      double sum = factor_[i * r + j];
      for (std::size_t k = 0; k < j; ++k) sum -= factor_[i * r + k] * factor_[j * r + k];
      factor_[i * r + j] = i == j ? std::sqrt(sum) : sum / factor_[j * r + j];
    }
  }
}

/// U^T (x - X - U q).
std::vector<double> PoseFinder::project(Positions x, const std::vector<double>& q) const {
  const std::size_t r = at(model_.modes);
  std::vector<double> result(r, 0.0);
  for (Index v = 0; v < x.count(); ++v)
    for (Index axis = 0; axis < 3; ++axis) {
      const double* u = model_.row(v, axis);
      double rest = x[v][axis] - model_.rest[at(v)][at(axis)];
      for (std::size_t k = 0; k < r; ++k) rest -= u[k] * q[k];
      for (std::size_t k = 0; k < r; ++k) result[k] += rest * u[k];
    }
  return result;
}

void PoseFinder::solve(std::vector<double>& b) const {
  const std::size_t r = b.size();
  for (std::size_t i = 0; i < r; ++i) {
    for (std::size_t k = 0; k < i; ++k) b[i] -= factor_[i * r + k] * b[k];
    b[i] /= factor_[i * r + i];
  }
  for (std::size_t i = r; i-- > 0;) {
    for (std::size_t k = i + 1; k < r; ++k) b[i] -= factor_[k * r + i] * b[k];
    b[i] /= factor_[i * r + i];
  }
}

ReducedPose PoseFinder::pose_of(Positions x) const {
  std::vector<double> q(at(model_.modes), 0.0);
  constexpr int kRefinements = 2;  // the first solves, the second corrects the errors of ridge and rounding
  for (int i = 0; i < kRefinements; ++i) {
    std::vector<double> change = project(x, q);
    solve(change);
    for (std::size_t k = 0; k < q.size(); ++k) q[k] += change[k];
  }
  Interval squares;
  for (const double c : q) squares = squares + Interval(c) * Interval(c);
  return {rounding::above(std::sqrt(squares.upper)), residual(x, q)};
}

/// A sum of r products and two more terms is off by less than (r + 2) u (1 + tiny) times the sum of the absolute
/// values; twice that also covers the rounding of the bound itself. A product that underflows adds at most 2^-1075.
double PoseFinder::residual(Positions x, const std::vector<double>& q) const {
  const std::size_t r = q.size();
  const double factor = static_cast<double>(r + 4) * 0x1p-52;
  double largest = 0;
  for (Index v = 0; v < x.count(); ++v)
    for (Index axis = 0; axis < 3; ++axis) {
      const double* u = model_.row(v, axis);
      const double rest = model_.rest[at(v)][at(axis)];
      double sum = rest - x[v][axis], sizes = std::fabs(rest) + std::fabs(x[v][axis]);
      for (std::size_t k = 0; k < r; ++k) {
        const double term = u[k] * q[k];
        sum += term;
        sizes += std::fabs(term);
      }
      const double error = std::fabs(sum) + factor * sizes;
      if (!(error <= largest)) largest = error;  // keeps NaN, for which no comparison holds
      if (largest != largest) return largest;
    }
  return largest + static_cast<double>(r + 4) * std::numeric_limits<double>::denorm_min();
}

}  // namespace tamis::lab
