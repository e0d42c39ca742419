#include "paper/pipeline/subspace_certificates.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "numbers/assert.hpp"
#include "numbers/interval.hpp"
#include "numbers/vec.hpp"
#include "paper/topology/representatives.hpp"
#include "search/topology/at.hpp"

namespace tamis::lab {
namespace {

/// The allowance, relative to the largest side of the rest pose's box: far above the rounding of positions, even of
/// floats, and far below gaps that matter.
constexpr double kAllowance = 0x1p-20;
constexpr double kInfinity = std::numeric_limits<double>::infinity();

using Direction = Vec3<double>;

double size_of(const Direction& n) { return std::fabs(n.x) + std::fabs(n.y) + std::fabs(n.z); }

/// Unlike std::min and std::max, both return NaN if one argument is. Overflow leaves NaN, and then nothing is proven.
double lesser(double a, double b) { return a <= b ? a : b < a ? b : a + b; }
double greater(double a, double b) { return a >= b ? a : b > a ? b : a + b; }

Interval hull(const Interval& a, const Interval& b) { return {lesser(a.lower, b.lower), greater(a.upper, b.upper)}; }

/// The largest |a - b| of two intervals.
double largest_difference(const Interval& a, const Interval& b) {
  const Interval difference = a - b;
  return greater(std::fabs(difference.lower), std::fabs(difference.upper));
}

/// n.(x, y, z). Three products and two sums are off by less than 3.1 u times the sum of absolute values, or 8 u with
/// the bound's own rounding.
Interval along(const Direction& n, double x, double y, double z) {
  const double a = n.x * x, b = n.y * y, c = n.z * z, sum = a + b + c;
  const double error = 0x1p-50 * (std::fabs(a) + std::fabs(b) + std::fabs(c)) + 0x1p-1060;
  return {sum - error, sum + error};
}

/// A set of vertices projected on a direction: the interval of their rest positions, then one interval for each mode.
using Slab = std::vector<Interval>;

class Builder {
 public:
  Builder(const BinaryTree& tree, std::span<const Face> triangles, const ReducedModel& model, double allowance)
      : tree_(tree), triangles_(triangles), model_(model), allowance_(allowance) {}

  std::vector<double> least_norms() {
    least_norms_.assign(at(tree_.size()), kInfinity);
    if (tree_.size() == 0) return {};
    slabs_.resize(at(tree_.size()));
    for (Index node = tree_.size() - 1; node >= 0; --node) bound(node);
    for (Index node = tree_.size() - 1; node >= 0; --node) {
      if (tree_.is_leaf(node)) continue;
      const Index a = tree_.left(node), b = tree_.right(node);
      least_norms_[at(node)] = least_between(a, b, std::min(least_norms_[at(a)], least_norms_[at(b)]));
    }
    return std::move(least_norms_);
  }

 private:
  static constexpr std::array<Direction, 3> kNodeDirections{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};

  void bound(Index node) {
    for (std::size_t d = 0; d < kNodeDirections.size(); ++d) {
      Slab& slab = slabs_[at(node)][d];
      if (tree_.is_leaf(node)) {
        const Face& f = triangles_[at(tree_.triangle(node))];
        slab = seen(f[0], kNodeDirections[d]);
        for (std::size_t i = 1; i < f.size(); ++i) slab = joined(std::move(slab), seen(f[i], kNodeDirections[d]));
      } else {
        slab = joined(slabs_[at(tree_.left(node))][d], slabs_[at(tree_.right(node))][d]);
      }
    }
  }

  static Slab joined(Slab a, const Slab& b) {
    for (std::size_t i = 0; i < a.size(); ++i) a[i] = hull(a[i], b[i]);
    return a;
  }

  Slab seen(Index vertex, const Direction& n) const {
    const Point& p = model_.rest[at(vertex)];
    const double *ux = model_.row(vertex, 0), *uy = model_.row(vertex, 1), *uz = model_.row(vertex, 2);
    Slab slab{along(n, p[0], p[1], p[2])};
    for (Index k = 0; k < model_.modes; ++k) slab.push_back(along(n, ux[k], uy[k], uz[k]));
    return slab;
  }

  /// The least of `best` and of the certified norms of all pairs of triangles between two nodes.
  double least_between(Index a, Index b, double best) const {
    if (!(best > 0)) return 0;
    double apart = 0;
    for (std::size_t d = 0; d < kNodeDirections.size(); ++d)
      apart = std::max(apart, norm_to_close(slabs_[at(a)][d], slabs_[at(b)][d], kNodeDirections[d]));
    if (apart >= best) return best;
    if (tree_.is_leaf(a) && tree_.is_leaf(b))
      return std::min(best, norm_to_touch(tree_.triangle(a), tree_.triangle(b), best));
    if (tree_.is_leaf(a)) return least_between(a, tree_.right(b), least_between(a, tree_.left(b), best));
    if (tree_.is_leaf(b)) return least_between(tree_.right(a), b, least_between(tree_.left(a), b, best));
    for (const Index i : {tree_.left(a), tree_.right(a)})
      for (const Index j : {tree_.left(b), tree_.right(b)}) best = least_between(i, j, best);
    return best;
  }

  /// For |q| below this, n separates the two sets. 0 if n does not separate them at rest.
  double norm_to_close(const Slab& a, const Slab& b, const Direction& n) const {
    const double gap = left_of(greater((b[0] - a[0]).lower, (a[0] - b[0]).lower), n);
    if (!(gap > 0)) return 0;
    Interval squares;
    for (std::size_t k = 1; k < a.size(); ++k) squares = squares + square(largest_difference(a[k], b[k]));
    return quotient(gap, squares.upper);
  }

  static Interval square(double a) { return Interval(a) * Interval(a); }

  /// A gap along n, less what the residual may take of it.
  double left_of(double gap, const Direction& n) const {
    return (Interval(gap) - Interval(allowance_) * Interval(rounding::above(rounding::above(size_of(n))))).lower;
  }

  /// gap / sqrt(squares), rounded down. REQUIRES: gap > 0.
  static double quotient(double gap, double squares) {
    TAMIS_ASSERT(gap > 0);
    if (!(squares > 0)) return squares == 0 ? kInfinity : 0;
    const double result = rounding::below(gap / rounding::above(std::sqrt(squares)));
    return result > 0 ? result : 0;
  }

  /// norm_to_close for two triangles: the best over many directions. Stops at a direction that reaches `enough`.
  double norm_to_touch(Index s, Index t, double enough) const {
    const Face &a = triangles_[at(s)], &b = triangles_[at(t)];
    if (share_a_vertex(a, b)) return kInfinity;
    double best = 0;
    for (const Direction& n : directions(a, b)) {
      if (size_of(n) > 0 && size_of(n) < kInfinity && may_separate(a, b, n)) best = std::max(best, norm_along(a, b, n));
      if (best >= enough) break;
    }
    return best;
  }

  /// The norm from the least gap and the greatest approach, each over all pairs of vertices.
  double norm_along(const Face& a, const Face& b, const Direction& n) const {
    std::array<Slab, 3> of_a, of_b;
    for (std::size_t i = 0; i < 3; ++i) {
      of_a[i] = seen(a[i], n);
      of_b[i] = seen(b[i], n);
    }
    const bool up = of_b[0][0].lower > of_a[0][0].upper;
    double gap = kInfinity, squares = 0;
    for (const Slab& x : of_a)
      for (const Slab& y : of_b) {
        gap = lesser(gap, (up ? y[0] - x[0] : x[0] - y[0]).lower);
        Interval sum;
        for (std::size_t k = 1; k < x.size(); ++k) sum = sum + square(largest_difference(x[k], y[k]));
        squares = greater(squares, sum.upper);
      }
    gap = left_of(gap, n);
    return gap > 0 ? quotient(gap, squares) : 0;
  }

  /// A quick test, with rounding: is there a gap along n in the rest pose? Only saves work.
  bool may_separate(const Face& a, const Face& b, const Direction& n) const {
    double a_low = kInfinity, a_high = -kInfinity, b_low = kInfinity, b_high = -kInfinity;
    for (std::size_t i = 0; i < 3; ++i) {
      const double x = dot(n, rest(a[i])), y = dot(n, rest(b[i]));
      a_low = std::min(a_low, x);
      a_high = std::max(a_high, x);
      b_low = std::min(b_low, y);
      b_high = std::max(b_high, y);
    }
    return b_low > a_high || a_low > b_high;
  }

  /// Directions to try: normals, cross products of edges and in-plane normals of edges, one of which separates two
  /// triangles if any direction does; the direction between their centres; and the coordinate axes, along which modes
  /// often do nothing.
  std::vector<Direction> directions(const Face& a, const Face& b) const {
    std::array<Direction, 3> e, f;
    for (std::size_t i = 0; i < 3; ++i) {
      e[i] = rest(a[(i + 1) % 3]) - rest(a[i]);
      f[i] = rest(b[(i + 1) % 3]) - rest(b[i]);
    }
    const Direction m = cross(e[0], e[1]), n = cross(f[0], f[1]);
    std::vector<Direction> all(kNodeDirections.begin(), kNodeDirections.end());
    all.push_back(rest(b[0]) + rest(b[1]) + rest(b[2]) - rest(a[0]) - rest(a[1]) - rest(a[2]));
    all.push_back(m);
    all.push_back(n);
    for (std::size_t i = 0; i < 3; ++i) {
      all.push_back(cross(m, e[i]));
      all.push_back(cross(n, f[i]));
      for (std::size_t j = 0; j < 3; ++j) all.push_back(cross(e[i], f[j]));
    }
    return all;
  }

  Direction rest(Index vertex) const {
    const Point& p = model_.rest[at(vertex)];
    return {p[0], p[1], p[2]};
  }

  const BinaryTree& tree_;
  std::span<const Face> triangles_;
  const ReducedModel& model_;
  double allowance_;
  std::vector<std::array<Slab, 3>> slabs_;
  std::vector<double> least_norms_;
};

double largest_side(std::span<const Face> triangles, const ReducedModel& model) {
  double side = 0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    double low = kInfinity, high = -kInfinity;
    for (const Face& f : triangles)
      for (const Index v : f) {
        low = std::min(low, model.rest[at(v)][axis]);
        high = std::max(high, model.rest[at(v)][axis]);
      }
    side = std::max(side, high - low);
  }
  return side;
}

}  // namespace

SubspaceCertificates::SubspaceCertificates(const BinaryTree& tree, std::span<const Face> triangles,
                                           const ReducedModel& model)
    : allowance_(kAllowance * largest_side(triangles, model)) {
  least_norms_ = Builder(tree, triangles, model, allowance_).least_norms();
}

}  // namespace tamis::lab
