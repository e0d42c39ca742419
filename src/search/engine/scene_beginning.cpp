#include "search/engine/scene_beginning.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "numbers/assert.hpp"
#include "search/bounds/box.hpp"

namespace tamis {
namespace {

/// If the scene's width at t=0 is less than this part of the range of displacements, the floats of the boxes have lost
/// so many bits of the scene that they cull little.
constexpr double kSmallPart = 0x1p-8;
/// The part of the scene's width that vertices may move in a beginning. They meet few others on so short a way.
constexpr double kPartOfWidth = 1.0 / 16;

/// A quarter of the range of coordinates along the axis where it is widest, from half coordinates, which do not
/// overflow.
template <class Half>
double widest_range(std::span<const Index> points, const Half& half_of) {
  Box box;
  for (const Index v : points) box.include(Point{half_of(v, 0), half_of(v, 1), half_of(v, 2)});
  return box.half_width();
}

}  // namespace

double beginning_of_long_step(const Step& step, std::span<const Index> points, double widening) {
  // Displacements differ by no more than the scene's widths at both ends together. So the part is no less than 1 / (1 +
  // widening).
  if (widening < 0.5 / kSmallPart) return 1;
  const auto start = [&](Index v, std::size_t axis) { return 0.5 * step.start[v][axis]; };
  const auto displacement = [&](Index v, std::size_t axis) {
    return 0.5 * step.end[v][axis] - 0.5 * step.start[v][axis];
  };
  const double part = widest_range(points, start) / widest_range(points, displacement);
  return 0 < part && part < kSmallPart ? std::ldexp(kPartOfWidth, std::ilogb(part)) : 1;
}

/// (1 - length) start + length end is off by four roundings and by underflow: 2^-50 and 2^-1000 an axis exceed these.
Listing listing_of_beginning(const Query& query, std::span<const Index> points, double length) {
  TAMIS_ASSERT(0 < length && length <= 1);
  const Step& step = query.step;
  std::vector<Point> end(static_cast<std::size_t>(step.start.count()));
  double deviation = 0;
  for (const Index v : points) {
    double off = 0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double from = (1 - length) * step.start[v][axis], to = length * step.end[v][axis];
      end[static_cast<std::size_t>(v)][axis] = from + to;
      off += 0x1p-50 * (std::fabs(step.start[v][axis]) + std::fabs(to)) + 0x1p-1000;
    }
    deviation = std::max(deviation, off);
  }
  Listing listing{{step.start, end}, query.separations, deviation};
  listing.end = std::move(end);
  return listing;
}

}  // namespace tamis
